// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Problems, the exceptions that carry them, and the version.

#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/version.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace test_problems {

using namespace CGAL::Surface_mesh_foliation::internal;
namespace SMF = CGAL::Surface_mesh_foliation;
using SMF::Problem_kind;

// ===  problem.h

TEST(Quoted, is_short_and_printable)
{
  const auto quoted = [](std::string_view text) { return SMF::internal::quoted(text); };
  EXPECT_EQ(quoted(""), "''");
  EXPECT_EQ(quoted("a b~"), "'a b~'");
  EXPECT_EQ(quoted(std::string_view("\0\t\n\x7f\xc3", 5)), "'" + std::string(5, '?') + "'");
  EXPECT_EQ(quoted(std::string(24, 'a')), "'" + std::string(24, 'a') + "'");
  EXPECT_EQ(quoted(std::string(25, 'a')), "'" + std::string(24, 'a') + "...'");
}

TEST(Problem_kind, has_a_name_of_its_own)
{
  const int last = static_cast<int>(Problem_kind::CERTIFICATE_FAILURE);
  std::set<std::string> names;
  for (int kind = 0; kind <= last; ++kind)
  {
    const std::string name = SMF::name(static_cast<Problem_kind>(kind));
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_"), std::string::npos) << name;
  }
  EXPECT_EQ(names.count("unknown"), 0u);
  EXPECT_STREQ(SMF::name(static_cast<Problem_kind>(last + 1)), "unknown");
  EXPECT_STREQ(SMF::name(Problem_kind::FILE), "file");
  EXPECT_STREQ(SMF::name(Problem_kind::CERTIFICATE_FAILURE), "certificate_failure");
}

TEST(Problem_kind, is_about_the_mesh_or_about_what_is_on_it)
{
  using SMF::internal::is_about_mesh;
  for (Problem_kind kind : {Problem_kind::FILE, Problem_kind::EMPTY_MESH, Problem_kind::NOT_CLOSED,
                            Problem_kind::DEGENERATE_FACE})
    EXPECT_TRUE(is_about_mesh(kind)) << SMF::name(kind);
  for (Problem_kind kind : {Problem_kind::INVALID_POLE, Problem_kind::NO_LOOP,
                            Problem_kind::STOPPED, Problem_kind::CERTIFICATE_FAILURE})
    EXPECT_FALSE(is_about_mesh(kind)) << SMF::name(kind);
}

TEST(Problems, have_their_parts)
{
  const SMF::Problem found = problem(Problem_kind::NOT_CLOSED, "m", 5).vertices({1, 2}).faces({3});
  EXPECT_EQ(found.kind, Problem_kind::NOT_CLOSED);
  EXPECT_EQ(found.message, "m5");
  EXPECT_EQ(found.vertices, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(found.faces, std::vector<std::size_t>{3});
  EXPECT_TRUE(found.loops.empty());
  const SMF::Problem of_loops = problem(Problem_kind::INVALID_POLE, "m").loops({4});
  EXPECT_EQ(of_loops.loops, std::vector<std::size_t>{4});
  EXPECT_THROW(throw_file_problem("m", 5), SMF::Invalid_file_exception);
  try
  {
    throw_file_problem("m", 5);
  }
  catch (const SMF::Invalid_file_exception& exception)
  {
    EXPECT_EQ(exception.problem().kind, Problem_kind::FILE);
    EXPECT_STREQ(exception.what(), "m5");
  }
  EXPECT_EQ(vertex_name(7), "vertex 7");
  EXPECT_EQ(face_name(0), "face 0");
}

// ===  exceptions.h and version.h

namespace {

template <class Exception>
void expect_carries_its_problem()
{
  static_assert(std::is_base_of_v<SMF::Foliation_exception, Exception>);
  static_assert(std::is_base_of_v<std::runtime_error, Exception>);
  try
  {
    throw Exception({Problem_kind::NO_LOOP, "text", {1}, {2}, {3, 4}});
  }
  catch (const SMF::Foliation_exception& exception)
  {
    EXPECT_NE(dynamic_cast<const Exception*>(&exception), nullptr);
    EXPECT_STREQ(exception.what(), "text");
    EXPECT_EQ(exception.problem().kind, Problem_kind::NO_LOOP);
    EXPECT_EQ(exception.problem().message, "text");
    EXPECT_EQ(exception.problem().vertices, std::vector<std::size_t>{1});
    EXPECT_EQ(exception.problem().faces, std::vector<std::size_t>{2});
    EXPECT_EQ(exception.problem().loops, (std::vector<std::size_t>{3, 4}));
  }
}

} // namespace

TEST(Exceptions, carry_their_problem)
{
  expect_carries_its_problem<SMF::Invalid_file_exception>();
  expect_carries_its_problem<SMF::Invalid_mesh_exception>();
  expect_carries_its_problem<SMF::Invalid_loops_exception>();
  expect_carries_its_problem<SMF::Invalid_parameter_exception>();
  expect_carries_its_problem<SMF::Solver_exception>();
  expect_carries_its_problem<SMF::Certificate_exception>();
  static_assert(!std::is_base_of_v<SMF::Invalid_file_exception, SMF::Invalid_mesh_exception>);
}

TEST(Version, text_and_number_agree)
{
  std::istringstream text(CGAL_SURFACE_MESH_FOLIATION_VERSION);
  int major = -1, minor = -1, patch = -1;
  char first_dot = 0, second_dot = 0;
  text >> major >> first_dot >> minor >> second_dot >> patch;
  EXPECT_EQ(first_dot, '.');
  EXPECT_EQ(second_dot, '.');
  EXPECT_EQ(10000 * major + 100 * minor + patch, CGAL_SURFACE_MESH_FOLIATION_VERSION_NR);
}

} // namespace test_problems
