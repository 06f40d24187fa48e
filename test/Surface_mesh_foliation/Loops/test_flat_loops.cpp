// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Loops on plain arrays: their order along edges, what they cut the surface into, and what is wrong
// with bad ones. The meshes are so small that the answers are worked out by hand.

#include <CGAL/Surface_mesh_foliation/internal/Loops/to_loop.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/Flat_loop_system.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/Flat_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/Regions.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/loop_checks.h>

#include "include/flat_systems.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_flat_loops {

using namespace smf_test;
using namespace CGAL::Surface_mesh_foliation::internal;
namespace SMF = CGAL::Surface_mesh_foliation;
using SMF::Problem_kind;

namespace {

// around vertex 4 of the octahedron, which lies to the left
Flat_loop loop_around_top(const Flat_mesh& octahedron, double position)
{
  return flat_loop(octahedron, {{0, 4}, {2, 4}, {1, 4}, {3, 4}}, position);
}

} // namespace

// ===  Edge_crossings

TEST(Edge_crossings, are_sorted_along_edges_whatever_their_direction)
{
  const Flat_mesh mesh = flat_mesh(soups::octahedron());
  std::vector<Flat_loop> loops = {loop_around_top(mesh, 0.25), loop_around_top(mesh, 0.75),
                                  loop_around_top(mesh, 0.5)};
  // the last one backwards: it crosses the opposite halfedges, and positions count from their ends
  std::reverse(loops[2].crossings.begin(), loops[2].crossings.end());
  for (Flat_crossing& crossing : loops[2].crossings)
    crossing = {opposite_of(crossing.halfedge), 0.5};
  const Edge_crossings crossings(mesh, loops);
  for (int e = 0; e < mesh.number_of_edges(); ++e)
  {
    const bool is_at_top = mesh.source(halfedge_of(e)) == 4 || mesh.target(halfedge_of(e)) == 4;
    ASSERT_EQ(crossings.size(e), is_at_top ? 3 : 0);
    if (!is_at_top)
      continue;
    const int h = mesh.target(halfedge_of(e)) == 4 ? halfedge_of(e)
                                                   : opposite_of(halfedge_of(e)); // toward the top
    std::vector<int> order;
    for (int i : {0, 1, 2})
      order.push_back(crossings.from_source(h, i).loop);
    EXPECT_EQ(order, (std::vector<int>{0, 2, 1}));
    for (int i : {0, 1, 2})
    {
      EXPECT_EQ(&crossings.from_source(opposite_of(h), i), &crossings.from_source(h, 2 - i));
      const Edge_crossings::Entry& entry = crossings.entry(e, i);
      EXPECT_EQ(crossings.place(loops[entry.loop], entry.loop, entry.index), i);
      EXPECT_EQ(entry.halfedge, loops[entry.loop].crossings[entry.index].halfedge);
      EXPECT_EQ(entry.halfedge, entry.loop == 2 ? opposite_of(h) : h);
      EXPECT_EQ(entry.rank, 0);
      EXPECT_EQ(crossings.place(loops[entry.loop], 3, entry.index), -1);
    }
  }
}

TEST(Edge_crossings, tight_loops_come_next_to_their_poles)
{
  const Flat_mesh mesh = flat_mesh(soups::octahedron());
  const Flat_loop close = loop_around_top(mesh, 0.999999);
  const std::vector<Flat_loop> loops = {close, tight_loop(mesh, {4}, 0, 1),
                                        tight_loop(mesh, {0}, 1, 1)};
  const Edge_crossings crossings(mesh, loops);
  const int h = mesh.find_halfedge(0, 4);
  ASSERT_EQ(crossings.size(edge_of(h)), 3);
  EXPECT_EQ(crossings.from_source(h, 0).loop, 2); // around 0
  EXPECT_EQ(crossings.from_source(h, 1).loop, 0);
  EXPECT_EQ(crossings.from_source(h, 2).loop, 1); // around 4
}

TEST(Edge_crossings, coincide_only_with_equal_rank_and_position)
{
  const Flat_mesh mesh = flat_mesh(soups::octahedron());
  const std::vector<Flat_loop> loops = {loop_around_top(mesh, 0.75), loop_around_top(mesh, 0.75),
                                        tight_loop(mesh, {4}, 0, 1)};
  const Edge_crossings crossings(mesh, loops);
  const int h = mesh.find_halfedge(0, 4);
  const auto coincide = [&](int i, int j) {
    return Edge_crossings::coincide(crossings.from_source(h, i), crossings.from_source(h, j));
  };
  EXPECT_TRUE(coincide(0, 1));
  EXPECT_FALSE(coincide(1, 2));
}

// ===  Regions

using Sides = std::vector<std::pair<int, int>>; // loop and side

Sides sides(const Regions::Region& region)
{
  Sides result;
  for (const Regions::Side& side : region.sides)
    result.emplace_back(side.loop, side.side);
  return result;
}

TEST(Regions, of_parallel_loops_around_a_vertex)
{
  const Flat_mesh mesh = flat_mesh(soups::octahedron());
  const std::vector<Flat_loop> loops = {loop_around_top(mesh, 0.25), loop_around_top(mesh, 0.75)};
  const Edge_crossings crossings(mesh, loops);
  const Regions regions(mesh, {{4}}, loops, crossings);
  ASSERT_EQ(regions.number_of_regions(), 3);
  EXPECT_EQ(regions.region_of_vertex(4), 0); // the pole's is number 0
  const int annulus = regions.region_beside(loops[0], 0, 0);
  const int bottom = regions.region_beside(loops[0], 0, 1);
  EXPECT_EQ(regions.region_beside(loops[1], 1, 0), 0);
  EXPECT_EQ(regions.region_beside(loops[1], 1, 1), annulus);
  for (int v : {0, 1, 2, 3, 5})
    EXPECT_EQ(regions.region_of_vertex(v), bottom);
  EXPECT_EQ(sides(regions.region(0)), (Sides{{1, 0}}));
  EXPECT_EQ(regions.region(0).poles, std::vector<int>{0});
  EXPECT_EQ(sides(regions.region(annulus)), (Sides{{0, 0}, {1, 1}}));
  EXPECT_EQ(sides(regions.region(bottom)), (Sides{{0, 1}}));
  for (int r = 0; r < 3; ++r)
  {
    EXPECT_EQ(regions.region(r).euler_characteristic, r == annulus ? 0 : 1);
    EXPECT_EQ(regions.region(r).genus(), 0);
  }
}

TEST(Regions, without_loops_are_the_whole_surface)
{
  for (const auto& [soup, genus] : std::vector<std::pair<Triangle_soup, int>>{
         {soups::tetrahedron(), 0}, {soups::seven_vertex_torus(), 1}})
  {
    const Flat_mesh mesh = flat_mesh(soup);
    const Edge_crossings crossings(mesh, {});
    const Regions regions(mesh, {{0}, {2}}, {}, crossings);
    ASSERT_EQ(regions.number_of_regions(), 1);
    EXPECT_EQ(regions.region(0).euler_characteristic, 2 - 2 * genus);
    EXPECT_EQ(regions.region(0).genus(), genus);
    EXPECT_EQ(regions.region(0).poles, (std::vector<int>{0, 1}));
  }
}

TEST(Regions, of_one_loop_of_the_seven_vertex_torus)
{
  const Flat_mesh mesh = flat_mesh(soups::seven_vertex_torus());
  const std::vector<Flat_loop> loops = {flat_loop(mesh, seven_vertex_torus_loop())};
  const Edge_crossings crossings(mesh, loops);
  const Regions regions(mesh, {}, loops, crossings);
  ASSERT_EQ(regions.number_of_regions(), 1);
  EXPECT_EQ(regions.region(0).euler_characteristic, 0);
  EXPECT_EQ(sides(regions.region(0)), (Sides{{0, 0}, {0, 1}})); // both sides of the loop
  EXPECT_EQ(regions.region(0).genus(), 0);
}

TEST(Regions, of_genus_one_behind_a_pole_loop)
{
  const Flat_mesh mesh = flat_mesh(soups::seven_vertex_torus());
  const std::vector<Flat_loop> loops = {tight_loop(mesh, {3}, 0, 1)};
  const Edge_crossings crossings(mesh, loops);
  const Regions regions(mesh, {{3}}, loops, crossings);
  ASSERT_EQ(regions.number_of_regions(), 2);
  EXPECT_EQ(regions.region(1).euler_characteristic, -1);
  EXPECT_EQ(regions.region(1).genus(), 1);
}

TEST(Regions, where_an_edge_crosses_two_loops)
{
  const Flat_loop_system system = octahedron_with_three_poles();
  const Regions regions(system.mesh, system.poles, system.loops, system.crossings);
  ASSERT_EQ(regions.number_of_regions(), 4);
  // a pair of pants: 1, 3 and 5 with the middles of the edges between the poles
  EXPECT_EQ(regions.region(3).euler_characteristic, -1);
  EXPECT_EQ(sides(regions.region(3)), (Sides{{0, 1}, {1, 1}, {2, 1}}));
  for (int v : {1, 3, 5})
    EXPECT_EQ(regions.region_of_vertex(v), 3);
  for (int p : {0, 1, 2})
    EXPECT_EQ(regions.region_of_vertex(system.poles[p][0]), p);
}

// ===  tight_loop

TEST(Tight_loop, runs_counterclockwise_around_a_vertex)
{
  const Flat_mesh mesh = flat_mesh(soups::seven_vertex_torus());
  for (int v = 0; v < mesh.number_of_vertices(); ++v)
  {
    const Flat_loop loop = tight_loop(mesh, {v}, 2, 0.5);
    EXPECT_EQ(loop.pole, 2);
    EXPECT_EQ(loop.height, 0.5);
    EXPECT_TRUE(loop.is_tight);
    ASSERT_EQ(static_cast<int>(loop.crossings.size()), mesh.degree(v));
    for (int i = 0; i < mesh.degree(v); ++i)
      EXPECT_EQ(loop.crossings[i].halfedge,
                opposite_of(mesh.ring(v)[i])); // the pole is to the left
    Problems problems;
    check_curve(mesh, {{v}}, loop, 0, problems);
    EXPECT_TRUE(problems.empty());
  }
}

TEST(Tight_loop, surrounds_a_line)
{
  const Flat_mesh mesh = flat_mesh(soups::torus(6, 5, 3, 1));
  const Pole line = {0, 5, 10};
  const Flat_loop loop = tight_loop(mesh, line, 0, 1);
  // all edges with one end on the line
  std::multiset<std::pair<int, int>> crossed, expected;
  for (const Flat_crossing& crossing : loop.crossings)
    crossed.emplace(mesh.source(crossing.halfedge), mesh.target(crossing.halfedge));
  for (int v : line)
    for (int h : mesh.ring(v))
      if (std::count(line.begin(), line.end(), mesh.target(h)) == 0)
        expected.emplace(mesh.target(h), v);
  EXPECT_EQ(crossed, expected);
  Problems problems;
  check_curve(mesh, {line}, loop, 0, problems);
  EXPECT_TRUE(problems.empty());
}

// ===  Checks

namespace {

void expect_kinds(const Problems& problems, const std::vector<Problem_kind>& kinds)
{
  std::vector<Problem_kind> found;
  std::string messages;
  for (const SMF::Problem& problem : problems)
  {
    found.push_back(problem.kind);
    messages += problem.message + "\n";
  }
  EXPECT_EQ(found, kinds) << messages;
}

Problems pole_problems(const Triangle_soup& soup, const std::vector<Pole>& poles)
{
  const Flat_mesh mesh = flat_mesh(soup);
  Problems problems;
  check_poles(mesh, poles, problems);
  for (const SMF::Problem& problem : problems)
    EXPECT_EQ(problem.kind, Problem_kind::INVALID_POLE);
  return problems;
}

Problems curve_problems(const Flat_mesh& mesh,
                        const std::vector<std::pair<int, int>>& halfedges,
                        double position = 0.5,
                        const std::vector<Pole>& poles = {})
{
  Problems problems;
  check_curve(mesh, poles, flat_loop(mesh, halfedges, position), 7, problems);
  for (const SMF::Problem& problem : problems)
  {
    EXPECT_EQ(problem.kind, Problem_kind::INVALID_LOOP);
    EXPECT_EQ(problem.loops, std::vector<std::size_t>{7});
  }
  return problems;
}

Problems disjointness_problems(const Flat_mesh& mesh, const std::vector<Flat_loop>& loops)
{
  Problems problems;
  const Edge_crossings crossings(mesh, loops);
  check_disjointness(mesh, loops, crossings, problems);
  return problems;
}

Problems system_problems(const Triangle_soup& soup,
                         const std::vector<Pole>& poles,
                         const std::vector<Flat_loop>& loops)
{
  Flat_loop_system system = unchecked_system(soup, poles, loops);
  Problems problems;
  complete(system, problems);
  return problems;
}

} // namespace

TEST(Pole_checks, of_vertices_and_lines)
{
  const Triangle_soup soup = soups::octahedron(); // only 0 1, 2 3 and 4 5 have no edge
  EXPECT_TRUE(pole_problems(soup, {{0}, {1}, {2, 4, 3}}).empty());
  EXPECT_EQ(pole_problems(soup, {{6}, {-1}}).size(), 2u);
  const Problems twice = pole_problems(soup, {{0}, {2, 0}});
  ASSERT_EQ(twice.size(), 1u);
  EXPECT_EQ(twice[0].vertices, std::vector<std::size_t>{0});
  EXPECT_EQ(pole_problems(soup, {{2, 4, 2}}).size(), 1u);
  const Problems gap = pole_problems(soup, {{4, 0, 1}});
  ASSERT_GE(gap.size(), 1u);
  EXPECT_EQ(gap[0].vertices, (std::vector<std::size_t>{0, 1}));
  const Problems chord = pole_problems(soup, {{0, 2, 4}});
  ASSERT_EQ(chord.size(), 1u);
  EXPECT_EQ(chord[0].vertices, (std::vector<std::size_t>{0, 4}));
}

TEST(Check_curve, of_crossings)
{
  const Flat_mesh mesh = flat_mesh(soups::octahedron());
  const std::vector<std::pair<int, int>> around = {{0, 4}, {2, 4}, {1, 4}, {3, 4}};
  EXPECT_TRUE(curve_problems(mesh, around).empty());
  for (double position : {0., 1., -0.5, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_EQ(curve_problems(mesh, around, position).size(), 4u) << position;
  EXPECT_TRUE(curve_problems(mesh, around, std::nextafter(1., 0.)).empty());
  EXPECT_EQ(curve_problems(mesh, {}).size(), 1u);
  EXPECT_EQ(curve_problems(mesh, {{0, 4}, {2, 4}, {1, 4}}).size(), 1u); // jumps
  EXPECT_EQ(curve_problems(mesh, {{0, 4}, {4, 0}}).size(), 2u);         // turns back, twice
  EXPECT_EQ(curve_problems(mesh, {{3, 4}, {1, 4}, {2, 4}, {0, 4}}).size(), 4u);
  EXPECT_EQ(curve_problems(mesh, around, 0.5, {{1, 4, 0}}).size(), 2u); // through a line
}

TEST(Check_heights, of_each_loop)
{
  std::vector<Flat_loop> loops(6);
  loops[1].height = 0;
  loops[2].height = std::numeric_limits<double>::infinity();
  loops[3].height = std::numeric_limits<double>::quiet_NaN();
  loops[4].height = std::nextafter(1e-300, 0.);
  loops[5].height = 1e-300;
  Problems problems;
  check_heights(loops, problems);
  expect_kinds(problems, std::vector<Problem_kind>(4, Problem_kind::INVALID_HEIGHT));
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(problems[i].loops, std::vector<std::size_t>{i + 1});
}

TEST(Disjointness_check, of_loops_with_several_crossings_of_an_edge)
{
  const Flat_mesh mesh = flat_mesh(soups::octahedron());
  const auto loop = [&](double position) { return loop_around_top(mesh, position); };
  EXPECT_TRUE(disjointness_problems(mesh, {loop(0.25), loop(0.75), loop(0.5)}).empty());
  // the same place
  const Problems coincide = disjointness_problems(mesh, {loop(0.25), loop(0.5), loop(0.25)});
  expect_kinds(coincide, std::vector<Problem_kind>(4, Problem_kind::INTERSECTING_LOOPS));
  EXPECT_EQ(coincide[0].loops, (std::vector<std::size_t>{0, 2}));
  // the order changes between two edges
  Flat_loop crossing = loop(0.5);
  crossing.crossings[1].position = 0.1;
  const Problems cross = disjointness_problems(mesh, {loop(0.25), crossing});
  ASSERT_FALSE(cross.empty());
  EXPECT_EQ(cross[0].kind, Problem_kind::INTERSECTING_LOOPS);
  EXPECT_EQ(cross[0].loops, (std::vector<std::size_t>{0, 1}));
}

TEST(Disjointness_check, of_a_loop_that_runs_twice_around)
{
  const Flat_mesh mesh = flat_mesh(soups::octahedron());
  Flat_loop loop = loop_around_top(mesh, 0.25);
  for (const Flat_crossing& crossing : loop_around_top(mesh, 0.75).crossings)
    loop.crossings.push_back(crossing);
  const Problems problems = disjointness_problems(mesh, {loop});
  ASSERT_FALSE(problems.empty()); // it must cross itself to close
  for (const SMF::Problem& problem : problems)
    EXPECT_EQ(problem.kind, Problem_kind::INVALID_LOOP);
}

TEST(Flat_loop_system, reports_the_first_stage_with_a_problem)
{
  const Triangle_soup octahedron = soups::octahedron(), torus = soups::seven_vertex_torus();
  const Flat_mesh mesh = flat_mesh(octahedron), torus_mesh = flat_mesh(torus);
  const auto around_top = [&](double position) { return loop_around_top(mesh, position); };
  const auto along_torus = [&](double position) {
    return flat_loop(torus_mesh, seven_vertex_torus_loop(), position);
  };
  expect_kinds(system_problems(octahedron, {}, {}), {Problem_kind::NO_LOOP});
  expect_kinds(system_problems(octahedron, {{4}}, {}), {Problem_kind::INESSENTIAL_LOOP});
  expect_kinds(system_problems(octahedron, {{0}, {4}, {5}}, {around_top(0.25)}),
               {Problem_kind::HOMOTOPIC_LOOPS});
  expect_kinds(system_problems(octahedron, {{4}, {4}}, {around_top(2)}),
               {Problem_kind::INVALID_POLE});
  expect_kinds(system_problems(torus, {}, {along_torus(0.5)}), {});
  expect_kinds(system_problems(torus, {}, {along_torus(0.5), along_torus(0.25)}),
               {Problem_kind::HOMOTOPIC_LOOPS, Problem_kind::HOMOTOPIC_LOOPS});
  Flat_loop around_other = around_top(0.25);
  around_other.pole = 0;
  Flat_loop_system wrong_pole = unchecked_system(octahedron, {{0}, {1}, {5}}, {});
  wrong_pole.loops[0] = around_other; // it surrounds vertex 4
  Problems problems;
  complete(wrong_pole, problems);
  ASSERT_FALSE(problems.empty());
  EXPECT_EQ(problems.back().kind, Problem_kind::INVALID_LOOP);
}

using Nodes_of_arc = std::vector<std::array<int, 2>>;

TEST(Flat_loop_system, merges_the_pole_loops_of_a_sphere_with_two)
{
  Flat_loop_system system = unchecked_system(soups::octahedron(), {{4}, {5}}, {});
  system.loops[0].height = 0.25;
  system.loops[1].height = 2;
  Problems problems;
  complete(system, problems);
  EXPECT_TRUE(problems.empty());
  EXPECT_EQ(system.merged_loops, std::vector<int>{1});
  ASSERT_EQ(system.number_of_arcs(), 1);
  EXPECT_EQ(system.height(0), 2.25);
  ASSERT_EQ(system.nodes.size(), 2u);
  for (int r : {0, 1})
  {
    EXPECT_EQ(system.nodes[r].pole, r);
    EXPECT_EQ(system.nodes[r].degree, 1);
    EXPECT_EQ(system.nodes[r].genus, 0);
    EXPECT_EQ(system.nodes[r].euler_characteristic, 1);
  }
  EXPECT_EQ(system.nodes_of_arc, (Nodes_of_arc{{0, 1}}));
  EXPECT_EQ(system.node_of_vertex, (std::vector<int>{1, 1, 1, 1, 0, 1}));
}

TEST(Flat_loop_system, has_the_dual_graph_of_its_loops)
{
  const Flat_loop_system star = octahedron_with_three_poles();
  ASSERT_EQ(star.nodes.size(), 4u);
  EXPECT_EQ(star.nodes_of_arc, (Nodes_of_arc{{0, 3}, {1, 3}, {2, 3}}));
  EXPECT_EQ(star.nodes[3].degree, 3);
  EXPECT_EQ(star.nodes[3].pole, -1);
  EXPECT_EQ(star.nodes[3].euler_characteristic, -1);
  const Flat_loop_system torus = torus_with_one_loop();
  ASSERT_EQ(torus.nodes.size(), 1u);
  EXPECT_EQ(torus.nodes_of_arc, (Nodes_of_arc{{0, 0}}));
  EXPECT_EQ(torus.nodes[0].degree, 2);
  EXPECT_EQ(torus.nodes[0].genus, 0);
  EXPECT_TRUE(torus.merged_loops.empty());
}

} // namespace test_flat_loops
