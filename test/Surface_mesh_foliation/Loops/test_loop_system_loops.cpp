// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/example_systems.h"

#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/loops.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace test_loop_system_loops {

// Which curves Loop_system and validate() refuse, and how they say it.

namespace {

using smf_test::Mesh;
using smf_test::vertex;
using smf_test::vertex_range;
namespace SMF = CGAL::Surface_mesh_foliation;
namespace soups = smf_test::soups;

using Input = SMF::Poles_and_loops<Mesh>;
using Loop = SMF::Loop<Mesh>;
using Indices = std::vector<std::size_t>;
using Kind = SMF::Problem_kind;

Loop cycle(const Indices& indices, const Mesh& mesh)
{
  return SMF::loop_from_edge_cycle(vertex_range(indices), mesh);
}

std::vector<Loop> loops_around(const Indices& indices, const Mesh& mesh)
{
  std::vector<Loop> result;
  SMF::loops_around_vertices(vertex_range(indices), mesh, std::back_inserter(result));
  return result;
}

std::vector<SMF::Problem> problems_of(const Mesh& mesh, const Input& input)
{
  const std::vector<SMF::Problem> problems = SMF::validate(mesh, input);
  try
  {
    const SMF::Loop_system<Mesh> system(mesh, input);
    EXPECT_TRUE(problems.empty()) << "the constructor accepts it";
  }
  catch (const SMF::Invalid_loops_exception& exception)
  {
    EXPECT_EQ(exception.what(), problems.empty() ? "validate() accepts it" : problems[0].message);
  }
  return problems;
}

// Whether the first problem is of a kind and about these loops, and its message names them.
::testing::AssertionResult is_refused(const std::vector<SMF::Problem>& problems,
                                      Kind kind,
                                      const Indices& loops)
{
  if (problems.empty())
    return ::testing::AssertionFailure() << "no problem";
  Indices named = problems[0].loops;
  std::sort(named.begin(), named.end());
  if (problems[0].kind != kind || named != loops)
    return ::testing::AssertionFailure()
           << "kind " << static_cast<int>(problems[0].kind) << ", loops "
           << ::testing::PrintToString(named) << ": " << problems[0].message;
  for (const std::size_t loop : loops)
    if (problems[0].message.find(std::to_string(loop)) == std::string::npos)
      return ::testing::AssertionFailure() << problems[0].message;
  return ::testing::AssertionSuccess();
}

Input with_loop(Input input, const Loop& loop)
{
  input.add_loop(loop);
  return input;
}

// a torus 8 x 6 with a pole and, as loop 1, a curve around the tube
struct Torus
{
  Torus()
  {
    input.add_pole(vertex(45));
    input.add_loop(cycle(smf_test::meridian(3, 6), mesh));
  }
  Mesh mesh = smf_test::torus(8, 6, 3, 1);
  Input input;
};

// ===  Curves

TEST(Loop_system_curves, without_crossing)
{
  const Torus torus;
  EXPECT_TRUE(
    is_refused(problems_of(torus.mesh, with_loop(torus.input, {})), Kind::INVALID_LOOP, {2}));
}

TEST(Loop_system_curves, positions_lie_strictly_inside_edges)
{
  const Torus torus;
  for (const double bad : {0., 1., -0.5, 1.5, std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity()})
  {
    Loop loop = cycle(smf_test::meridian(0, 6), torus.mesh);
    loop[2].position = bad;
    const std::vector<SMF::Problem> problems =
      problems_of(torus.mesh, with_loop(torus.input, loop));
    EXPECT_TRUE(is_refused(problems, Kind::INVALID_LOOP, {2}));
    ASSERT_FALSE(problems.empty());
    const Indices ends = {source(loop[2].halfedge, torus.mesh),
                          target(loop[2].halfedge, torus.mesh)};
    EXPECT_EQ(problems[0].vertices, ends);
  }
  Loop close = cycle(smf_test::meridian(0, 6), torus.mesh);
  close[2].position = 1e-300;
  close[3].position = 1 - 1e-16;
  Input input;
  input.add_loop(close);
  EXPECT_EQ(problems_of(torus.mesh, input).size(), 0u);
}

TEST(Loop_system_curves, that_are_not_closed)
{
  const Torus torus;
  Loop loop = cycle(smf_test::meridian(0, 6), torus.mesh);
  loop.pop_back();
  EXPECT_TRUE(
    is_refused(problems_of(torus.mesh, with_loop(torus.input, loop)), Kind::INVALID_LOOP, {2}));
}

TEST(Loop_system_curves, that_jump)
{
  const Torus torus;
  Loop loop = cycle(smf_test::meridian(0, 6), torus.mesh);
  std::swap(loop[1], loop[4]);
  EXPECT_TRUE(
    is_refused(problems_of(torus.mesh, with_loop(torus.input, loop)), Kind::INVALID_LOOP, {2}));
}

TEST(Loop_system_curves, that_turn_back)
{
  const Torus torus;
  Loop loop = cycle(smf_test::meridian(0, 6), torus.mesh);
  const auto h = loop[0].halfedge;
  loop.insert(loop.begin() + 1, {{opposite(h, torus.mesh), 0.6}, {h, 0.2}});
  EXPECT_TRUE(
    is_refused(problems_of(torus.mesh, with_loop(torus.input, loop)), Kind::INVALID_LOOP, {2}));
  const Loop to_and_fro = {{h, 0.3}, {opposite(h, torus.mesh), 0.3}};
  EXPECT_TRUE(is_refused(problems_of(torus.mesh, with_loop(torus.input, to_and_fro)),
                         Kind::INVALID_LOOP, {2}));
}

TEST(Loop_system_curves, with_halfedges_in_the_wrong_direction)
{
  const Torus torus;
  Loop loop = cycle(smf_test::meridian(0, 6), torus.mesh);
  for (auto& crossing : loop)
    crossing.halfedge = opposite(crossing.halfedge, torus.mesh);
  EXPECT_TRUE(
    is_refused(problems_of(torus.mesh, with_loop(torus.input, loop)), Kind::INVALID_LOOP, {2}));
}

TEST(Loop_system_curves, that_cross_a_line_pole)
{
  const Mesh mesh = smf_test::torus(8, 6, 3, 1);
  Input input;
  input.add_line_pole(vertex_range({0, 6, 12, 18}));
  input.add_loop(cycle(smf_test::meridian(1, 6), mesh)); // through vertex 6, pushed to row 0 or 2
  EXPECT_TRUE(is_refused(problems_of(mesh, input), Kind::INVALID_LOOP, {1}));
}

TEST(Loop_system_curves, that_meet_themselves)
{
  const Mesh mesh = smf_test::torus(8, 6, 3, 1);
  Input input;
  input.add_pole(vertex(27));
  input.add_loop(cycle(smf_test::meridian(0, 6), mesh));
  Loop twice = cycle(smf_test::meridian(4, 6), mesh);
  twice.insert(twice.end(), twice.begin(), twice.end());
  EXPECT_TRUE(is_refused(problems_of(mesh, with_loop(input, twice)), Kind::INVALID_LOOP, {2}));
  for (std::size_t i = 0; i < twice.size() / 2; ++i)
    twice[i].position = 0.4; // now no two points coincide, but it must cross itself somewhere
  EXPECT_TRUE(is_refused(problems_of(mesh, with_loop(input, twice)), Kind::INVALID_LOOP, {2}));
}

// ===  Pairs of curves

TEST(Loop_system_pairs, that_cross)
{
  const Mesh mesh = smf_test::torus(8, 6, 3, 1);
  Input input;
  input.add_pole(vertex(45));
  input.add_loop(cycle(smf_test::longitude(1, 8, 6), mesh));
  input.add_loop(cycle(smf_test::meridian(2, 6), mesh));
  const std::vector<SMF::Problem> problems = problems_of(mesh, input);
  EXPECT_TRUE(is_refused(problems, Kind::INTERSECTING_LOOPS, {1, 2}));
  // the edge named is one that both cross or that lies in a triangle where both are
  ASSERT_EQ(problems[0].vertices.size(), 2u);
  EXPECT_TRUE(
    halfedge(vertex(problems[0].vertices[0]), vertex(problems[0].vertices[1]), mesh).second);
}

TEST(Loop_system_pairs, that_touch)
{
  const Mesh mesh = smf_test::torus(8, 6, 3, 1);
  Input input;
  input.add_loop(cycle(smf_test::meridian(2, 6), mesh));
  input.add_loop(cycle(smf_test::meridian(2, 6), mesh));
  EXPECT_TRUE(is_refused(problems_of(mesh, input), Kind::INTERSECTING_LOOPS, {0, 1}));
}

TEST(Loop_system_pairs, that_are_parallel_in_one_strip)
{
  const Mesh mesh = smf_test::torus(8, 6, 3, 1);
  Input input;
  input.add_loop(cycle(smf_test::meridian(2, 6), mesh));
  Loop shifted = cycle(smf_test::meridian(2, 6), mesh);
  for (auto& crossing : shifted)
    crossing.position = 0.5;
  input.add_loop(shifted);
  EXPECT_TRUE(is_refused(problems_of(mesh, input), Kind::HOMOTOPIC_LOOPS, {0, 1}));
  std::reverse(shifted.begin(), shifted.end());
  for (auto& crossing : shifted)
    crossing = {opposite(crossing.halfedge, mesh), 1 - crossing.position};
  Input backwards;
  backwards.add_loop(cycle(smf_test::meridian(2, 6), mesh));
  backwards.add_loop(shifted);
  EXPECT_TRUE(is_refused(problems_of(mesh, backwards), Kind::HOMOTOPIC_LOOPS, {0, 1}));
}

TEST(Loop_system_pairs, of_which_each_point_is_beyond_the_other)
{
  const Mesh mesh = smf_test::torus(8, 6, 3, 1);
  Input input;
  input.add_loop(cycle(smf_test::meridian(2, 6), mesh));
  Loop alternating = cycle(smf_test::meridian(2, 6), mesh);
  for (std::size_t i = 0; i < alternating.size(); ++i)
    alternating[i].position = i % 2 == 0 ? 0.1 : 0.5; // the other is at 0.25
  input.add_loop(alternating);
  EXPECT_TRUE(is_refused(problems_of(mesh, input), Kind::INTERSECTING_LOOPS, {0, 1}));
}

// ===  Homotopy

TEST(Loop_system_homotopy, loops_on_both_sides_of_a_cycle)
{
  const Mesh mesh = smf_test::torus(8, 6, 3, 1);
  Indices cycle_vertices = smf_test::meridian(2, 6);
  const Loop left = cycle(cycle_vertices, mesh);
  std::reverse(cycle_vertices.begin(), cycle_vertices.end());
  const Loop right = cycle(cycle_vertices, mesh);
  Input input;
  input.add_loop(left);
  input.add_loop(right);
  EXPECT_TRUE(is_refused(problems_of(mesh, input), Kind::HOMOTOPIC_LOOPS, {0, 1}));
  Input with_pole_on_one_side; // the other annulus has no pole
  with_pole_on_one_side.add_pole(vertex(40));
  with_pole_on_one_side.add_loop(left);
  with_pole_on_one_side.add_loop(right);
  EXPECT_TRUE(is_refused(problems_of(mesh, with_pole_on_one_side), Kind::HOMOTOPIC_LOOPS, {1, 2}));
  with_pole_on_one_side.add_pole(vertex(cycle_vertices[0]));
  EXPECT_EQ(problems_of(mesh, with_pole_on_one_side).size(), 0u);
}

TEST(Loop_system_homotopy, inessential_loops)
{
  const Torus torus;
  const std::vector<Loop> around = loops_around({36, 37, 42, 43}, torus.mesh);
  ASSERT_EQ(around.size(), 1u);
  EXPECT_TRUE(is_refused(problems_of(torus.mesh, with_loop(torus.input, around[0])),
                         Kind::INESSENTIAL_LOOP, {2}));
  Input alone;
  alone.add_loop(around[0]);
  EXPECT_TRUE(is_refused(problems_of(torus.mesh, alone), Kind::INESSENTIAL_LOOP, {0}));
}

TEST(Loop_system_homotopy, a_loop_around_one_pole)
{
  const Mesh mesh = smf_test::icosphere(2);
  Input input;
  for (const std::size_t v : {0, 3, 7, 9})
    input.add_pole(vertex(v));
  EXPECT_EQ(problems_of(mesh, input).size(), 0u);
  EXPECT_TRUE(is_refused(problems_of(mesh, with_loop(input, SMF::pole_loop(vertex(7), mesh, 2))),
                         Kind::HOMOTOPIC_LOOPS, {2, 4}));
}

TEST(Loop_system_homotopy, loops_around_several_poles_are_essential)
{
  const Mesh mesh = smf_test::icosphere(3);
  Input input;
  for (const std::size_t v : {0, 1, 2, 3})
    input.add_pole(vertex(v));
  std::set<std::size_t> ball; // around 0 and 1, which are neighbors in the icosahedron
  for (const auto u : vertices(mesh))
    if (CGAL::squared_distance(mesh.point(u), mesh.point(vertex(0))) +
          CGAL::squared_distance(mesh.point(u), mesh.point(vertex(1))) <
        1.3)
      ball.insert(u);
  ASSERT_TRUE(ball.count(0) == 1 && ball.count(1) == 1);
  ASSERT_TRUE(ball.count(2) == 0 && ball.count(3) == 0);
  const std::vector<Loop> around = loops_around({ball.begin(), ball.end()}, mesh);
  ASSERT_EQ(around.size(), 1u);
  Input both = with_loop(input, around[0]);
  EXPECT_EQ(problems_of(mesh, both).size(), 0u);
  Input three; // with one pole less, the loop is homotopic to that of pole 2
  for (const std::size_t v : {0, 1, 2})
    three.add_pole(vertex(v));
  EXPECT_TRUE(
    is_refused(problems_of(mesh, with_loop(three, around[0])), Kind::HOMOTOPIC_LOOPS, {2, 3}));
}

TEST(Loop_system_homotopy, only_neighboring_pairs_are_reported)
{
  const Mesh mesh = smf_test::torus(12, 6, 3, 1);
  Input input;
  for (const std::size_t row : {0, 4, 8})
    input.add_loop(cycle(smf_test::meridian(row, 6), mesh));
  const std::vector<SMF::Problem> problems = problems_of(mesh, input);
  ASSERT_EQ(problems.size(), 3u); // three annuli between three loops
  for (const SMF::Problem& problem : problems)
    EXPECT_EQ(problem.kind, Kind::HOMOTOPIC_LOOPS);
}

// ===  Loops of the user's around poles

TEST(Loop_system_pole_loops, of_the_user)
{
  const Mesh mesh = smf_test::icosphere(3);
  for (const unsigned int rings : {1u, 2u, 4u})
  {
    Input input;
    input.add_pole(vertex(0), SMF::pole_loop(vertex(0), mesh, rings));
    input.add_pole(vertex(1));
    input.add_pole(vertex(2));
    EXPECT_EQ(problems_of(mesh, input).size(), 0u) << rings;
  }
}

TEST(Loop_system_pole_loops, of_the_user_around_a_line)
{
  const Mesh mesh = smf_test::torus(12, 8, 3, 1);
  const Indices line = {0, 8, 16, 24};
  const auto problems = [&](const Indices& inside) {
    const std::vector<Loop> around = loops_around(inside, mesh);
    Input input;
    input.add_line_pole(vertex_range(line), around.at(0), 2);
    input.add_loop(cycle(smf_test::meridian(8, 8), mesh));
    EXPECT_EQ(input.entries()[0].height, 2);
    return problems_of(mesh, input);
  };
  EXPECT_EQ(problems(line).size(), 0u);
  EXPECT_EQ(problems({0, 8, 16, 24, 1, 9, 17, 25}).size(), 0u);
  EXPECT_FALSE(problems({0, 8}).empty()) << "it crosses the line";
  EXPECT_FALSE(problems({44, 45}).empty()) << "it surrounds nothing";
}

TEST(Loop_system_pole_loops, that_do_not_surround_just_their_pole)
{
  const Mesh mesh = smf_test::icosphere(3);
  const auto problems = [&](const Loop& loop) {
    Input input;
    input.add_pole(vertex(2));
    input.add_pole(vertex(0), loop);
    input.add_pole(vertex(1));
    input.add_pole(vertex(3));
    return problems_of(mesh, input);
  };
  EXPECT_EQ(problems(SMF::pole_loop(vertex(0), mesh, 3)).size(), 0u);
  // around another vertex; around another pole; around two poles
  EXPECT_FALSE(problems(SMF::pole_loop(vertex(8), mesh, 1)).empty());
  EXPECT_FALSE(problems(SMF::pole_loop(vertex(3), mesh, 2)).empty());
  EXPECT_FALSE(problems(SMF::pole_loop(vertex(0), mesh, 9)).empty());
}

TEST(Loop_system_pole_loops, are_checked_on_a_sphere_with_two_poles_too)
{
  const Mesh mesh = smf_test::icosphere(3);
  const auto problems = [&](const Loop& first, const Loop& second) {
    Input input;
    input.add_pole(vertex(0), first);
    input.add_pole(vertex(3), second);
    return problems_of(mesh, input);
  };
  const Loop around_first = SMF::pole_loop(vertex(0), mesh),
             around_second = SMF::pole_loop(vertex(3), mesh);
  EXPECT_EQ(problems(around_first, around_second).size(), 0u);
  EXPECT_FALSE(problems(around_first, SMF::pole_loop(vertex(8), mesh)).empty()) << "inessential";
  EXPECT_FALSE(problems(SMF::pole_loop(vertex(8), mesh), around_second).empty()) << "inessential";
  EXPECT_FALSE(problems(around_first, around_first).empty()) << "they coincide";
}

// ===  Too few

TEST(Loop_system_too_few, nothing_at_all)
{
  for (const Mesh& mesh : {smf_test::icosphere(1), smf_test::torus(8, 6, 3, 1)})
  {
    const auto problems = problems_of(mesh, {});
    EXPECT_TRUE(is_refused(problems, Kind::NO_LOOP, {}));
    EXPECT_NE(problems.at(0).message.find("detect_feature_poles()"), std::string::npos)
      << "what to do";
  }
}

TEST(Loop_system_too_few, sphere_with_one_pole_or_none)
{
  const Mesh mesh = smf_test::icosphere(2);
  Input one;
  one.add_pole(vertex(5));
  EXPECT_FALSE(problems_of(mesh, one).empty());
  Input none;
  none.add_loop(SMF::pole_loop(vertex(5), mesh, 3));
  EXPECT_FALSE(problems_of(mesh, none).empty());
  Input one_and_loop = one;
  one_and_loop.add_loop(SMF::pole_loop(vertex(5), mesh, 3));
  EXPECT_FALSE(problems_of(mesh, one_and_loop).empty());
}

TEST(Loop_system_too_few, one_pole_is_enough_from_genus_one_on)
{
  for (const Mesh& mesh : {smf_test::torus(8, 6, 3, 1), smf_test::genus_surface(2, 1)})
  {
    Input input;
    input.add_pole(vertex(5));
    EXPECT_EQ(problems_of(mesh, input).size(), 0u);
  }
}

} // namespace

} // namespace test_loop_system_loops
