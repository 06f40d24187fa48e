// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Leaves are followed by combinatorial decisions only: levels that hit vertices, edges that span
// whole arcs, an arc without vertex, curves that do not run around.

#include <CGAL/Surface_mesh_foliation/internal/Leaves/Level_tracer.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/essential_leaf.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/grow_fronts.h>

#include "include/flat_states.h"
#include "include/flat_systems.h"
#include "generators/Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace test_leaf_tracing {

using namespace smf_test;
using namespace CGAL::Surface_mesh_foliation::internal;

namespace {

using Edges = std::set<std::pair<int, int>>; // by their ends, the smaller first

template <class Crossings>
Edges edges_of(const Flat_mesh& mesh, const Crossings& crossings)
{
  Edges result;
  for (const Leaf_crossing& crossing : crossings)
    result.insert(std::minmax({mesh.source(crossing.halfedge), mesh.target(crossing.halfedge)}));
  return result;
}

// A leaf leads from face to face, and to the face where it began.
void expect_is_closed_curve(const Flat_mesh& mesh, const std::vector<Leaf_crossing>& leaf)
{
  ASSERT_FALSE(leaf.empty());
  for (std::size_t i = 0; i < leaf.size(); ++i)
  {
    const int h = leaf[i].halfedge, next = leaf[(i + 1) % leaf.size()].halfedge;
    EXPECT_EQ(mesh.face(opposite_of(h)), mesh.face(next));
    EXPECT_NE(opposite_of(h), next);
  }
}

// the edges that the only leaf of arc 0 at a level crosses
Edges edges_of_leaf(const Foliation_state& state, double level)
{
  const std::vector<Leaf_crossing> crossings = crossings_of_level(state, 0, level);
  const std::vector<Leaf_crossing> leaf = essential_leaf(state, 0, level);
  expect_is_closed_curve(state.mesh(), leaf);
  EXPECT_EQ(leaf.size(), crossings.size());
  EXPECT_EQ(edges_of(state.mesh(), leaf), edges_of(state.mesh(), crossings));
  return edges_of(state.mesh(), leaf);
}

} // namespace

// ===  Level_tracer.h

TEST(Level_tracer, a_vertex_at_the_level_lies_above)
{
  const Equator e({0.5, 1, 1, 1.5});
  const Edges above_0 = {{0, 2}, {0, 3}, {0, 5}, {1, 4}, {2, 4}, {3, 4}};
  const Edges below_3 = {{0, 3}, {1, 3}, {3, 4}, {0, 5}, {1, 5}, {2, 5}};
  EXPECT_EQ(edges_of_leaf(e.state, 0.75), above_0);
  EXPECT_EQ(edges_of_leaf(e.state, 1), above_0);
  EXPECT_EQ(edges_of_leaf(e.state, std::nextafter(1., 2.)), below_3);
  EXPECT_EQ(edges_of_leaf(e.state, 1.5), below_3);
  EXPECT_EQ(edges_of_leaf(e.state, 0.5), (Edges{{0, 4}, {1, 4}, {2, 4}, {3, 4}}));
}

TEST(Level_tracer, of_a_plateau)
{
  const Equator e({1, 1, 1, 1});
  EXPECT_EQ(edges_of_leaf(e.state, 1), (Edges{{0, 4}, {1, 4}, {2, 4}, {3, 4}}));
  EXPECT_EQ(edges_of_leaf(e.state, std::nextafter(1., 2.)),
            (Edges{{0, 5}, {1, 5}, {2, 5}, {3, 5}}));
}

TEST(Level_tracer, an_edge_that_spans_two_arcs_is_crossed_in_both)
{
  const Flat_loop_system system = octahedron_with_three_poles();
  const Foliation_state state(system, unit_weights(system));
  const int h = system.mesh.find_halfedge(2, 4);
  std::vector<std::pair<int, int>> arcs_and_cells;
  Level_tracer(state).for_each_crossing(
    edge_of(h), std::vector<double>{0.5, 0.25, 0.75},
    [&](int arc, int cell) { arcs_and_cells.emplace_back(arc, cell); });
  // cells are counted along the forward halfedge
  const bool is_from_2 = is_forward(h);
  EXPECT_EQ(arcs_and_cells,
            (std::vector<std::pair<int, int>>{{is_from_2 ? 1 : 2, 1}, {is_from_2 ? 2 : 1, 3}}));
  for (double level : {1e-9, 0.5, 1 - 1e-9})
    EXPECT_EQ(edges_of_leaf(state, level), (Edges{{0, 2}, {0, 4}, {0, 3}, {0, 5}}));
}

TEST(Level_tracer, of_an_arc_without_vertex_on_a_torus)
{
  const Flat_loop_system system = torus_with_one_loop();
  const Foliation_state state(system, unit_weights(system));
  for (double level : {0.01, 0.5, 0.99})
  {
    const std::vector<Leaf_crossing> leaf = essential_leaf(state, 0, level);
    expect_is_closed_curve(system.mesh, leaf);
    EXPECT_EQ(leaf.size(), 14u); // as the loop
    Group_word loop;
    for (const Flat_crossing& crossing : system.loops[0].crossings)
      loop = state.deck().group().product(loop, state.deck().element(crossing.halfedge));
    const Group_word leaf_word = translation_of(state, leaf);
    EXPECT_FALSE(leaf_word.empty());
    EXPECT_TRUE(state.deck().group().are_equal(leaf_word, loop) ||
                state.deck().group().are_equal(leaf_word, inverse(loop)));
  }
}

// ===  essential_leaf.h

TEST(Essential_leaf, is_the_curve_that_runs_around)
{
  const Flat_loop_system system =
    flat_system(soups::midpoint_subdivided(soups::octahedron()), {{4}, {5}});
  Foliation_state state(system, unit_weights(system));
  grow_fronts(state);
  state.set_parameter(0, 1.5); // a peak, with all others at 1
  std::vector<std::vector<Leaf_crossing>> leaves;
  for_each_leaf(state, crossings_of_level(state, 0, 1.25), 1.25,
                [&](const std::vector<Leaf_crossing>& leaf) { leaves.push_back(leaf); });
  ASSERT_EQ(leaves.size(), 2u);
  int number_of_trivial_curves = 0;
  for (const std::vector<Leaf_crossing>& leaf : leaves)
  {
    EXPECT_EQ(leaf.size(), 4u); // around the peak, around the pole
    number_of_trivial_curves += translation_of(state, leaf).empty();
  }
  EXPECT_EQ(number_of_trivial_curves, 1);
  for (const auto& [u, v] : edges_of(system.mesh, essential_leaf(state, 0, 1.25)))
  {
    EXPECT_NE(u, 0);
    EXPECT_TRUE(u == 5 || v == 5);
  }
  EXPECT_TRUE(essential_leaf(state, 0, 1.75).size() == 4u);
}

// Whatever the parameters, every crossing is on just one closed curve, and one runs around.
TEST(For_each_leaf, curves_are_a_partition_of_the_crossings)
{
  const Flat_loop_system system =
    flat_system(soups::midpoint_subdivided(soups::octahedron()), {{4}, {5}});
  Foliation_state state(system, unit_weights(system));
  grow_fronts(state);
  Random random(7);
  std::size_t largest_number_of_curves = 0;
  for (int round = 0; round < 40; ++round)
  {
    for (int v = 0; v < system.mesh.number_of_vertices(); ++v)
      if (state.is_free_in_arc(v)) // many of them equal, and some at the level
        state.set_parameter(v, 0.5 + 0.25 * static_cast<double>(random.index(5)));
    const std::vector<Leaf_crossing> crossings = crossings_of_level(state, 0, 1);
    std::size_t number_of_crossings = 0, number_of_curves = 0, number_that_run_around = 0;
    Edges edges;
    for_each_leaf(state, crossings, 1, [&](const std::vector<Leaf_crossing>& leaf) {
      expect_is_closed_curve(system.mesh, leaf);
      edges.merge(edges_of(system.mesh, leaf));
      number_of_crossings += leaf.size();
      ++number_of_curves;
      number_that_run_around += !translation_of(state, leaf).empty();
    });
    EXPECT_EQ(number_of_crossings, crossings.size());
    EXPECT_EQ(edges, edges_of(system.mesh, crossings));
    EXPECT_EQ(number_that_run_around % 2, 1u); // to and fro
    largest_number_of_curves = std::max(largest_number_of_curves, number_of_curves);
  }
  EXPECT_GT(largest_number_of_curves, 1u);
}

TEST(Point_of_crossing, lies_where_the_level_is_reached)
{
  const Equator e({0.5, 1, 1, 1.5});
  const auto point = [&](int u, int v, int cell, double level) {
    return point_of_crossing(e.state, {e.system.mesh.find_halfedge(u, v), cell}, level);
  };
  EXPECT_EQ(point(0, 2, 0, 1), e.system.mesh.point(2)); // a level at a vertex is that vertex
  EXPECT_EQ(point(2, 0, 0, 1), e.system.mesh.point(2));
  EXPECT_EQ(point(0, 2, 0, 0.75), (Point{0.5, 0.5, 0}));
  EXPECT_EQ(point(4, 3, 1, 0.375), (Point{0, -0.25, 0.75}));
  EXPECT_EQ(point(3, 4, 0, 0.375), (Point{0, -0.25, 0.75}));
  EXPECT_EQ(point(1, 2, 0, 1), (Point{-0.5, 0.5, 0})); // of length zero: the middle

  const Flat_loop_system system = octahedron_with_three_poles();
  const Foliation_state state(system, unit_weights(system));
  const int h = system.mesh.find_halfedge(2, 4); // arcs 1 and 2, both of height 1
  EXPECT_EQ(point_of_crossing(state, {h, 1}, 0.5), (Point{0, 0.75, 0.25}));
  EXPECT_EQ(point_of_crossing(state, {h, 3}, 0.5), (Point{0, 0.25, 0.75}));
  EXPECT_EQ(point_of_crossing(state, {opposite_of(h), 1}, 0.5), (Point{0, 0.25, 0.75}));
}

} // namespace test_leaf_tracing
