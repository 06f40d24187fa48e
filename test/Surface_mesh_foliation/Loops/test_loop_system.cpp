// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/example_systems.h"

#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/loops.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace test_loop_system {

// What Loop_system and validate() refuse, and how they say it.

namespace {

using smf_test::Item;
using smf_test::Mesh;
using smf_test::vertex;
using smf_test::vertex_range;
namespace SMF = CGAL::Surface_mesh_foliation;
namespace soups = smf_test::soups;

using Input = SMF::Poles_and_loops<Mesh>;
using Loop = SMF::Loop<Mesh>;
using Indices = std::vector<std::size_t>;
using Kind = SMF::Problem_kind;

std::string constructor_message(const Mesh& mesh, const Input& input, const SMF::Problem& problem)
{
  const bool is_problem_of_mesh = SMF::internal::is_about_mesh(problem.kind);
  const auto compare = [&](const SMF::Foliation_exception& exception) {
    EXPECT_EQ(exception.problem().kind, problem.kind);
    EXPECT_EQ(exception.problem().vertices, problem.vertices);
    EXPECT_EQ(exception.problem().faces, problem.faces);
    EXPECT_EQ(exception.problem().loops, problem.loops);
    return exception.problem().message == exception.what() ? std::string(exception.what())
                                                           : "message and what() differ";
  };
  try
  {
    const SMF::Loop_system<Mesh> system(mesh, input);
  }
  catch (const SMF::Invalid_mesh_exception& exception)
  {
    EXPECT_TRUE(is_problem_of_mesh);
    return compare(exception);
  }
  catch (const SMF::Invalid_loops_exception& exception)
  {
    EXPECT_FALSE(is_problem_of_mesh);
    return compare(exception);
  }
  return "the constructor accepts it";
}

// Both ways to check agree; returns the problems.
std::vector<SMF::Problem> problems_of(const Mesh& mesh, const Input& input)
{
  const std::vector<SMF::Problem> problems = SMF::validate(mesh, input);
  if (problems.empty())
  {
    EXPECT_NO_THROW(SMF::Loop_system<Mesh>(mesh, input));
    return problems;
  }
  EXPECT_EQ(constructor_message(mesh, input, problems[0]), problems[0].message);
  for (const SMF::Problem& problem : problems)
  {
    EXPECT_FALSE(problem.message.empty());
    EXPECT_EQ(problem.message.find('\n'), std::string::npos);
  }
  return problems;
}

bool contains_words(const std::string& message, const std::vector<std::string>& words)
{
  return std::all_of(words.begin(), words.end(), [&](const std::string& word) {
    return (' ' + message + ' ').find(word) != std::string::npos;
  });
}

Indices sorted(Indices indices)
{
  std::sort(indices.begin(), indices.end());
  return indices;
}

// Whether one of the problems is of a kind, about these vertices and loops (in any order), and its
// message says so.
::testing::AssertionResult reports(const std::vector<SMF::Problem>& problems,
                                   Kind kind,
                                   const Indices& vertices,
                                   const Indices& loops,
                                   std::vector<std::string> words = {})
{
  std::string found;
  for (const Indices* indices : {&vertices, &loops})
    for (const std::size_t index : *indices)
      words.push_back(std::to_string(index));
  for (const SMF::Problem& problem : problems)
    if (problem.kind == kind && sorted(problem.vertices) == sorted(vertices) &&
        sorted(problem.loops) == sorted(loops) && contains_words(problem.message, words))
      return ::testing::AssertionSuccess();
    else
      found += "\n  kind " + std::to_string(static_cast<int>(problem.kind)) + ", " +
               ::testing::PrintToString(problem.vertices) +
               ::testing::PrintToString(problem.loops) + " " + problem.message;
  return ::testing::AssertionFailure() << "no such problem, but:" << found;
}

// ===  Meshes

Mesh unchecked_mesh(const smf_test::Triangle_soup& soup)
{
  Mesh mesh;
  for (const auto& p : soup.points)
    mesh.add_vertex(Mesh::Point(p[0], p[1], p[2]));
  for (const auto& [a, b, c] : soup.triangles)
    mesh.add_face(vertex(a), vertex(b), vertex(c));
  return mesh;
}

smf_test::Triangle_soup united(smf_test::Triangle_soup soup, const smf_test::Triangle_soup& other)
{
  const std::size_t first = soup.points.size();
  soup.points.insert(soup.points.end(), other.points.begin(), other.points.end());
  for (const auto& [a, b, c] : other.triangles)
    soup.triangles.push_back({first + a, first + b, first + c});
  return soup;
}

Input some_poles()
{
  Input input;
  input.add_pole(vertex(0));
  input.add_pole(vertex(1));
  return input;
}

TEST(Loop_system_mesh, empty_meshes)
{
  Mesh mesh;
  EXPECT_TRUE(reports(problems_of(mesh, Input()), Kind::EMPTY_MESH, {}, {}));
  mesh.add_vertex(Mesh::Point(0, 0, 0));
  mesh.add_vertex(Mesh::Point(1, 0, 0));
  EXPECT_TRUE(reports(problems_of(mesh, some_poles()), Kind::EMPTY_MESH, {}, {}));
}

TEST(Loop_system_mesh, faces_that_are_no_triangles)
{
  Mesh mesh;
  const Mesh::Point p(0, 0, 0);
  CGAL::make_hexahedron(p, Mesh::Point(1, 0, 0), Mesh::Point(1, 1, 0), Mesh::Point(0, 1, 0),
                        Mesh::Point(0, 1, 1), Mesh::Point(0, 0, 1), Mesh::Point(1, 0, 1),
                        Mesh::Point(1, 1, 1), mesh);
  const std::vector<SMF::Problem> problems = problems_of(mesh, some_poles());
  ASSERT_FALSE(problems.empty());
  EXPECT_EQ(problems[0].kind, Kind::NOT_TRIANGLE_MESH);
  EXPECT_EQ(problems[0].faces, Indices{0});
  EXPECT_TRUE(contains_words(problems[0].message, {"face 0 "}));
}

TEST(Loop_system_mesh, one_face_of_four_corners_is_named)
{
  Mesh mesh = smf_test::icosphere(1);
  const auto h = halfedge(CGAL::SM_Face_index(31), mesh);
  CGAL::Euler::join_face(h,
                         mesh); // face 31 stays, another one is removed before garbage collection
  std::size_t position = 0;
  for (const auto f : faces(mesh))
  {
    if (degree(f, mesh) == 4)
      break;
    ++position;
  }
  ASSERT_LT(position, num_faces(mesh));
  const std::vector<SMF::Problem> problems = problems_of(mesh, some_poles());
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].kind, Kind::NOT_TRIANGLE_MESH);
  EXPECT_EQ(problems[0].faces, Indices{position});
}

TEST(Loop_system_mesh, borders)
{
  smf_test::Triangle_soup soup = soups::icosphere(1);
  const soups::Triangle removed = soup.triangles[13];
  soup.triangles.erase(soup.triangles.begin() + 13);
  const std::vector<SMF::Problem> problems = problems_of(unchecked_mesh(soup), some_poles());
  ASSERT_FALSE(problems.empty());
  EXPECT_EQ(problems[0].kind, Kind::NOT_CLOSED);
  EXPECT_EQ(problems[0].faces.size(), 1u);
  ASSERT_EQ(problems[0].vertices.size(), 2u);
  for (const std::size_t v : problems[0].vertices) // a border edge is named
    EXPECT_EQ(std::count(removed.begin(), removed.end(), v), 1);
}

TEST(Loop_system_mesh, two_edges_between_the_same_vertices)
{
  Mesh mesh = smf_test::tetrahedron();
  CGAL::Euler::flip_edge(halfedge(vertex(0), vertex(1), mesh).first, mesh);
  const std::vector<SMF::Problem> problems = problems_of(mesh, some_poles());
  ASSERT_FALSE(problems.empty());
  EXPECT_EQ(problems[0].kind, Kind::NOT_MANIFOLD);
}

TEST(Loop_system_mesh, two_faces_back_to_back)
{
  const smf_test::Triangle_soup pillow = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                                          {{0, 1, 2}, {2, 1, 0}}};
  const std::vector<SMF::Problem> problems = problems_of(unchecked_mesh(pillow), some_poles());
  ASSERT_FALSE(problems.empty());
  EXPECT_EQ(problems[0].kind, Kind::NOT_MANIFOLD);
  EXPECT_EQ(problems[0].faces, (Indices{0, 1}));
}

TEST(Loop_system_mesh, several_components)
{
  const Mesh mesh = unchecked_mesh(united(soups::icosphere(0), soups::torus(5, 4, 9, 1)));
  const std::vector<SMF::Problem> problems = problems_of(mesh, some_poles());
  ASSERT_FALSE(problems.empty());
  EXPECT_EQ(problems[0].kind, Kind::NOT_CONNECTED);
  ASSERT_EQ(problems[0].vertices.size(), 2u);
  EXPECT_LT(problems[0].vertices[0], 12u);
  EXPECT_GE(problems[0].vertices[1], 12u);
}

TEST(Loop_system_mesh, isolated_vertices)
{
  Mesh mesh = smf_test::icosphere(1);
  const std::size_t added = num_vertices(mesh);
  mesh.add_vertex(Mesh::Point(5, 5, 5));
  EXPECT_TRUE(reports(problems_of(mesh, some_poles()), Kind::ISOLATED_VERTEX, {added}, {}));
}

TEST(Loop_system_mesh, removed_vertices_do_not_count)
{
  Mesh mesh = smf_test::icosphere(1);
  mesh.remove_vertex(mesh.add_vertex(Mesh::Point(5, 5, 5)));
  EXPECT_EQ(problems_of(mesh, some_poles()).size(), 0u);
}

TEST(Loop_system_mesh, coordinates_that_are_not_finite)
{
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()})
    for (const int axis : {0, 1, 2})
    {
      smf_test::Triangle_soup soup = soups::icosphere(1);
      soup.points[17][static_cast<std::size_t>(axis)] = bad;
      EXPECT_TRUE(
        reports(problems_of(unchecked_mesh(soup), some_poles()), Kind::NOT_FINITE, {17}, {}));
    }
}

TEST(Loop_system_mesh, degenerate_faces)
{
  smf_test::Triangle_soup soup = soups::tetrahedron();
  soup.points[3] = soups::scaled(soups::sum(soup.points[0], soup.points[1]), 0.5);
  const std::vector<SMF::Problem> problems = problems_of(unchecked_mesh(soup), some_poles());
  ASSERT_FALSE(problems.empty());
  EXPECT_EQ(problems[0].kind, Kind::DEGENERATE_FACE);
  ASSERT_EQ(problems[0].faces.size(), 1u);
  EXPECT_EQ(sorted(problems[0].vertices), (Indices{0, 1, 3}));
}

TEST(Loop_system_mesh, a_bad_mesh_hides_other_problems)
{
  Mesh mesh = smf_test::icosphere(1);
  mesh.add_vertex(Mesh::Point(5, 5, 5));
  Input input;
  input.add_pole(vertex(0), -1);
  for (const SMF::Problem& problem : problems_of(mesh, input))
    EXPECT_LT(problem.kind, Kind::INVALID_POLE);
}

// ===  Heights

TEST(Loop_system_heights, must_be_finite_and_not_tiny)
{
  const Mesh mesh = smf_test::icosphere(1);
  for (const double bad : {0., -0., -1., 9e-301, std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity()})
  {
    Input input = some_poles();
    input.add_pole(vertex(2), bad);
    EXPECT_TRUE(reports(problems_of(mesh, input), Kind::INVALID_HEIGHT, {}, {2}, {"height"}));
    input.set_height(0, bad);
    input.set_height(2, 1e-300);
    EXPECT_TRUE(reports(problems_of(mesh, input), Kind::INVALID_HEIGHT, {}, {0}, {"height"}));
    input.set_height(0, 1e300);
    EXPECT_EQ(problems_of(mesh, input).size(), 0u);
  }
}

TEST(Loop_system_heights, the_sum_of_merged_heights_must_be_finite)
{
  const Mesh mesh = smf_test::icosphere(1);
  Input input;
  input.add_pole(vertex(0), 1.5e308);
  input.add_pole(vertex(1), 1.5e308);
  const std::vector<SMF::Problem> problems = problems_of(mesh, input);
  ASSERT_FALSE(problems.empty());
  EXPECT_EQ(problems[0].kind, Kind::INVALID_HEIGHT);
}

TEST(Loop_system_heights, are_reported_with_the_poles_but_before_the_curves)
{
  const Mesh mesh = smf_test::icosphere(1);
  Input input;
  input.add_pole(vertex(0), -1);
  input.add_pole(vertex(0));
  input.add_loop(Loop(), 0);
  const std::vector<SMF::Problem> problems = problems_of(mesh, input);
  EXPECT_TRUE(reports(problems, Kind::INVALID_HEIGHT, {}, {0}));
  EXPECT_TRUE(reports(problems, Kind::INVALID_HEIGHT, {}, {2}));
  EXPECT_TRUE(reports(problems, Kind::INVALID_POLE, {0}, {}));
  for (const SMF::Problem& problem : problems)
    EXPECT_NE(problem.kind, Kind::INVALID_LOOP);
}

// ===  Poles

TEST(Loop_system_poles, no_vertex)
{
  const Mesh mesh = smf_test::icosphere(1);
  Input input = some_poles();
  input.add_pole(Mesh::null_vertex());
  EXPECT_TRUE(reports(problems_of(mesh, input), Kind::INVALID_POLE, {}, {}, {"pole 2"}));
}

TEST(Loop_system_poles, empty_line)
{
  const Mesh mesh = smf_test::icosphere(1);
  Input input = some_poles();
  input.add_line_pole(std::vector<Mesh::Vertex_index>());
  const std::vector<SMF::Problem> problems = problems_of(mesh, input);
  ASSERT_FALSE(problems.empty());
  EXPECT_TRUE(contains_words(problems[0].message, {" 2 "}));
}

TEST(Loop_system_poles, one_vertex_in_two_poles)
{
  const Mesh mesh = smf_test::torus(8, 6, 3, 1);
  Input input;
  input.add_pole(vertex(20));
  input.add_line_pole(vertex_range({0, 6, 12}));
  input.add_pole(vertex(20));
  EXPECT_TRUE(reports(problems_of(mesh, input), Kind::INVALID_POLE, {20}, {}, {"poles 0 and 2"}));
  Input crossing_lines;
  crossing_lines.add_line_pole(vertex_range({0, 6, 12}));
  crossing_lines.add_line_pole(vertex_range({5, 6, 7})); // 5 is no neighbor of 6
  EXPECT_TRUE(
    reports(problems_of(mesh, crossing_lines), Kind::INVALID_POLE, {6}, {}, {"poles 0 and 1"}));
}

TEST(Loop_system_poles, a_line_must_be_an_induced_path)
{
  const Mesh mesh = smf_test::torus(8, 6, 3, 1); // vertex 6i+j has neighbors 6(i+1)+j, 6(i+1)+j+1
  const auto problems = [&](const Indices& line) {
    Input input;
    input.add_line_pole(vertex_range(line));
    input.add_loop(SMF::loop_from_edge_cycle(vertex_range(smf_test::meridian(5, 6)), mesh));
    return problems_of(mesh, input);
  };
  EXPECT_EQ(problems({0, 6, 12, 18}).size(), 0u);
  EXPECT_TRUE(reports(problems({0, 12, 18}), Kind::INVALID_POLE, {0, 12}, {}, {"edge"}));
  EXPECT_TRUE(reports(problems({0, 6, 7}), Kind::INVALID_POLE, {0, 7}, {}, {"induced path"}));
  EXPECT_TRUE(reports(problems({0, 6, 0}), Kind::INVALID_POLE, {0}, {}, {"twice"}));
  EXPECT_TRUE(reports(problems({0, 6, 12, 6}), Kind::INVALID_POLE, {6}, {}, {"twice"}));
  // around the axis until it meets its own beginning
  EXPECT_TRUE(reports(problems({0, 6, 12, 18, 24, 30, 36, 42}), Kind::INVALID_POLE, {0, 42}, {},
                      {"induced path"}));
}

} // namespace

} // namespace test_loop_system
