// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Single steps of a foliation toward the harmonic one, on octahedra where every number is known:
// with two poles the vertices of the equator start at the lower node, and belong at t = 1.

#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/forces.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/lengths.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Geodesic_step.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/balance.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/carried_map.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/grow_fronts.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/relax_vertex.h>

#include "include/flat_states.h"
#include "include/flat_systems.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace test_tree_map_steps {

using namespace smf_test;
using namespace CGAL::Surface_mesh_foliation::internal;

// ===  grow_fronts.h

TEST(Grow_fronts, spread_over_all_that_sees_one_direction)
{
  const Flat_loop_system system = octahedron_with_two_poles();
  Foliation_state state(system, unit_weights(system));
  for (int v : equator)
    EXPECT_TRUE(state.is_at_node(v));
  EXPECT_EQ(word_size(state, 4, 0), 2); // the edge spans the whole arc
  EXPECT_EQ(length(state, 4, 0), 2);
  EXPECT_EQ(word_size(state, 0, 5), 0);
  grow_fronts(state);
  EXPECT_EQ(parameters(state, equator), (std::vector<double>{1, 1, 1, 1}));
  for (int v : equator)
    for (int pole : {4, 5})
    {
      EXPECT_EQ(word_size(state, v, pole), 1);
      EXPECT_EQ(length(state, v, pole), 1);
    }
  EXPECT_EQ(length(state, 0, 2), 0);
  EXPECT_EQ(energy_of(state), 8);
}

TEST(Grow_fronts, leave_a_spine)
{
  const Flat_loop_system star = octahedron_with_three_poles();
  Foliation_state state(star, unit_weights(star));
  grow_fronts(state); // 1, 3 and 5 see two poles each, and stay
  for (int v : {1, 3, 5})
    EXPECT_EQ(state.node(v), 3);
  const Flat_loop_system torus = torus_with_one_loop();
  Foliation_state on_torus(torus, unit_weights(torus));
  grow_fronts(on_torus); // every vertex has the loop on both sides
  for (int v = 0; v < 7; ++v)
    EXPECT_TRUE(on_torus.is_at_node(v));
}

// ===  balance.h

TEST(Balance, of_the_optimum_is_zero)
{
  const Equator e({1, 1, 1, 1});
  const CGAL::Surface_mesh_foliation::Foliation_statistics b = balance(e.state);
  EXPECT_EQ(b.energy, 8);
  EXPECT_EQ(b.optimality, 0);
  EXPECT_LE(b.resolved_optimality, 0);
}

TEST(Balance, is_the_largest_excess_by_the_largest_force)
{
  // Vertex 0 at 1.5, all others at 1: lengths 1.5 and 0.5 to the poles, 0.5 to vertices 2 and 3.
  // It is pulled up by 1.5 + 0.5 + 0.5, down by 0.5. Vertices 2 and 3 are pulled by 0.5 alone.
  // The poles have the forces 1.5 + 3 and 0.5 + 3.
  const Equator e({1.5, 1, 1, 1});
  const CGAL::Surface_mesh_foliation::Foliation_statistics b = balance(e.state);
  EXPECT_EQ(b.energy, 1.5 * 1.5 + 3 * 0.5 * 0.5 + 6);
  EXPECT_EQ(b.optimality, 2 / 4.5);
  EXPECT_LT(b.resolved_optimality, b.optimality);
  EXPECT_NEAR(b.resolved_optimality, b.optimality, 1e-14);
  // rounding errors of the sum of weights, 4, times the height, 2
  const double rounding = 16 * std::numeric_limits<double>::epsilon() * 4 * 2;
  EXPECT_NEAR((b.optimality - b.resolved_optimality) / (rounding / 4.5), 1, 0.02);
}

TEST(Balance, counts_every_vertex_at_a_node)
{
  const Flat_loop_system system = flat_system(soups::octahedron(), {{1}, {3}, {5}});
  std::vector<double> weights = unit_weights(system);
  weights[edge_of(system.mesh.find_halfedge(0, 3))] = 5; // against 1 toward pole 5
  // at pole 3: one edge of weight 5, one of weight 1, and two to other poles, which do not count
  EXPECT_EQ(balance(Foliation_state(system, weights)).optimality, 4. / 6);
}

TEST(Balance, is_not_negative)
{
  const Flat_loop_system system = flat_system(soups::octahedron(), {{0}, {1}, {2}, {3}});
  const Foliation_state state(system, unit_weights(system)); // four equal pulls at 4 and at 5
  Directions directions;
  EXPECT_EQ(excess_at_node(state, 4, directions), -2);
  EXPECT_EQ(balance(state).optimality, 0);
  EXPECT_EQ(balance(state).resolved_optimality, 0);
}

TEST(Balance, at_nodes_counts_what_outweighs_the_rest)
{
  const Flat_loop_system system = octahedron_with_three_poles();
  std::vector<double> weights = unit_weights(system);
  weights[edge_of(system.mesh.find_halfedge(1, 2))] = 5; // against 1 toward pole 4
  const Foliation_state state(system, weights);
  Directions directions;
  EXPECT_EQ(excess_at_node(state, 1, directions), 4);
  EXPECT_EQ(excess_at_node(state, 3, directions), 0);
  const CGAL::Surface_mesh_foliation::Foliation_statistics b = balance(state);
  // at pole 2: one edge of weight 5, one of weight 1, and two to other poles, which do not count
  EXPECT_EQ(b.optimality, 4. / 6);
  EXPECT_EQ(b.resolved_optimality, b.optimality);
}

TEST(Balance, of_forces_that_underflow_is_infinite)
{
  Flat_loop_system system = octahedron_with_two_poles();
  system.loops[0].height = 1e-200;
  const Foliation_state state(system, std::vector<double>(12, 1e-200));
  EXPECT_EQ(balance(state).optimality, std::numeric_limits<double>::infinity());
}

// ===  relax_vertex.h

TEST(Vertex_relaxation, moves_to_the_weighted_mean_inside_an_arc)
{
  Equator e({1.75, 1, 0.5, 0.75});
  Vertex_relaxation relax(e.state);
  relax(0); // the mean of 0, 2, 0.5 and 0.75
  EXPECT_EQ(parameters(e.state, equator), (std::vector<double>{0.8125, 1, 0.5, 0.75}));
  EXPECT_NEAR(balance(e.state).energy, energy_of(e.state), 1e-14);
  relax(4); // poles stay
  EXPECT_TRUE(e.state.is_at_node(4));
  Vertex_relaxation further(e.state, 1.5);
  e.state.set_parameter(0, 1.8125);
  further(0); // one and a half times as far
  EXPECT_EQ(e.state.parameter(0), 0.3125);
}

TEST(Vertex_relaxation, leaves_a_node_only_for_what_outweighs_the_rest)
{
  const Flat_loop_system system = octahedron_with_three_poles();
  for (double weight : {0.5, 1., 3.})
  {
    std::vector<double> weights = unit_weights(system);
    weights[edge_of(system.mesh.find_halfedge(1, 2))] = weight;
    Foliation_state state(system, weights);
    Vertex_relaxation relax(state);
    const int d = relax.strongest_direction(1);
    EXPECT_EQ(d == Directions::NONE, weight == 1);
    relax(1);
    EXPECT_EQ(state.is_at_node(1), weight == 1);
    if (weight == 1)
      continue;
    // toward pole 2 (arc 1) or pole 4 (arc 2): excess by the sum of the weights, from end 1
    EXPECT_EQ(state.arc(1), weight > 1 ? 1 : 2);
    EXPECT_DOUBLE_EQ(state.parameter(1), 1 - std::abs(weight - 1) / (weight + 3));
    relax(1); // and there it is balanced
    EXPECT_DOUBLE_EQ(state.parameter(1), 1 - std::abs(weight - 1) / (weight + 3));
  }
}

TEST(Vertex_relaxation, passes_nodes_until_it_is_balanced)
{
  const Flat_loop_system system = octahedron_with_three_poles();
  std::vector<double> weights = unit_weights(system);
  weights[edge_of(system.mesh.find_halfedge(1, 2))] = 3;
  Foliation_state state(system, weights);
  Vertex_relaxation relax(state);
  // vertex 1 is put on the wrong arc, and comes back over the node
  Directions directions;
  find_directions(state, 1, directions);
  for (Letter letter : directions.letters)
    if (state.arc_of_letter(letter) == 2)
      state.move_into_arc(1, letter, 0.25);
  ASSERT_EQ(state.arc(1), 2);
  relax(1);
  EXPECT_EQ(state.arc(1), 1);
  EXPECT_DOUBLE_EQ(state.parameter(1), 1 - 2. / 6);
}

TEST(Release_from_nodes, lets_one_go_after_the_other)
{
  // only vertex 1 is out of balance at first
  const Flat_loop_system system = octahedron_with_three_poles();
  std::vector<double> weights = unit_weights(system);
  weights[edge_of(system.mesh.find_halfedge(1, 2))] = 3;
  Foliation_state state(system, weights);
  release_from_nodes(state, {3, 5, 1, 1});
  EXPECT_EQ(state.arc(1), 1);
  // 5 is a neighbor of pole 2 and of vertex 1, which have the same direction; 3 sees arc 1
  // through vertex 1 only, beside the arcs of poles 0 and 4
  EXPECT_FALSE(state.is_at_node(5));
  EXPECT_EQ(state.arc(5), 1);
}

TEST(Relax_band, converges_to_the_optimum)
{
  Equator e({0.25, 1.75, 0.5, 1.25});
  relax_band(e.state, {0}, 0, 30); // only vertex 0
  EXPECT_DOUBLE_EQ(e.state.parameter(0), (0 + 2 + 0.5 + 1.25) / 4);
  EXPECT_EQ(parameters(e.state, {1, 2, 3}), (std::vector<double>{1.75, 0.5, 1.25}));
  relax_band(e.state, {0}, 1, 1); // its neighbors, too
  EXPECT_EQ(e.state.parameter(1), 1.75);
  relax_band(e.state, {0}, 2, 60);
  for (int v : equator)
    EXPECT_NEAR(e.state.parameter(v), 1, 1e-14);
  EXPECT_LT(balance(e.state).optimality, 1e-14);
}

// ===  Geodesic_step.h

TEST(Geodesic_step, moves_by_speed_times_duration_inside_arcs)
{
  Equator e({1, 1, 1, 1});
  Geodesic_step step(e.state);
  const std::vector<double> speed = {0.5, -1, 0, 0.25, 9, 9}; // of poles none is taken
  step(speed, 0.5);
  EXPECT_EQ(parameters(e.state, equator), (std::vector<double>{1.25, 0.5, 1, 1.125}));
  EXPECT_TRUE(step.moved().empty());
  // the energy grows by 2 * pull * speed at the end of the step
  double expected = 0;
  const double h = 1e-6;
  Equator before({1.25 - 0.5 * h, 0.5 + h, 1, 1.125 - 0.25 * h});
  Equator behind({1.25 + 0.5 * h, 0.5 - h, 1, 1.125 + 0.25 * h});
  expected = (energy_of(behind.state) - energy_of(before.state)) / (2 * h);
  EXPECT_NEAR(step.slope(), expected, 1e-8);
}

TEST(Geodesic_step, waits_at_a_node_with_nothing_ahead)
{
  Equator e({1, 1, 1, 1});
  Geodesic_step step(e.state);
  step(std::vector<double>{2, 0, 0, 0, 0, 0}, 1); // would be at 3, but the arc ends at 2
  EXPECT_EQ(e.state.node(0), 1);
  EXPECT_EQ(step.moved(), std::vector<int>{0});
  EXPECT_EQ(length(e.state, 0, 5), 0);
  EXPECT_EQ(length(e.state, 0, 2), 1);
  step(std::vector<double>{-2, 0, 0, 0, 0, 0}, 1); // one at a node has no speed
  EXPECT_EQ(e.state.node(0), 1);
  EXPECT_TRUE(step.moved().empty());
}

TEST(Geodesic_step, does_not_arrive_at_the_very_end)
{
  Equator e({1, 1, 1, 1});
  Geodesic_step step(e.state);
  step(std::vector<double>{1, -1, 0, 0, 0, 0}, 1);
  EXPECT_TRUE(step.moved().empty());
  ASSERT_FALSE(e.state.is_at_node(0) || e.state.is_at_node(1));
  EXPECT_LT(e.state.parameter(0), 2); // strictly inside the arc
  EXPECT_GT(e.state.parameter(1), 0);
  EXPECT_NEAR(e.state.parameter(0), 2, 1e-14);
}

TEST(Geodesic_step, passes_a_node_toward_the_strongest_pull)
{
  const Flat_loop_system system = octahedron_with_three_poles();
  std::vector<double> weights = unit_weights(system);
  weights[edge_of(system.mesh.find_halfedge(1, 2))] = 9;
  Foliation_state state(system, weights);
  Vertex_relaxation relax(state);
  Directions directions;
  find_directions(state, 1, directions);
  for (Letter letter : directions.letters)
    if (state.arc_of_letter(letter) == 2)
      state.move_into_arc(1, letter, 0.75);
  ASSERT_EQ(state.arc(1), 2);
  Geodesic_step step(state);
  step(std::vector<double>{0, 0.5, 0, 0, 0, 0}, 1); // 0.25 to the node, and as much beyond
  EXPECT_EQ(state.arc(1), 1);
  EXPECT_DOUBLE_EQ(state.parameter(1), 0.75);
  EXPECT_EQ(step.moved(), (std::vector<int>{1, 1})); // arrived and left
}

TEST(Geodesic_step, stops_at_nodes_if_asked_to)
{
  Equator e({1, 1, 1, 1});
  Geodesic_step step(e.state);
  step.stopping_at_nodes(std::vector<double>{1, -4, 3, 0.5, 0, 0}, 0.5);
  EXPECT_EQ(step.moved(), (std::vector<int>{1, 2}));
  EXPECT_EQ(e.state.node(1), 0);
  EXPECT_EQ(e.state.node(2), 1);
  EXPECT_EQ(e.state.parameter(0), 1.5);
  EXPECT_EQ(e.state.parameter(3), 1.25);
  step.stopping_at_nodes(std::vector<double>{0.5, 9, -9, 0, 0, 0}, 0.5); // none arrives
  EXPECT_TRUE(step.moved().empty());
  EXPECT_EQ(e.state.parameter(0), 1.75);
  EXPECT_EQ(e.state.node(1), 0);
}

TEST(Geodesic_step, stays_at_a_node_that_it_would_pass)
{
  const Flat_loop_system system = octahedron_with_three_poles();
  Foliation_state state(system, unit_weights(system));
  Directions directions;
  find_directions(state, 1, directions);
  const Letter letter = directions.letters[0];
  const double length = state.length_of_arc(letter);
  state.move_into_arc(1, letter, letter.end() == 0 ? 0.25 : length - 0.25);
  const int node = state.node_of_letter(letter);
  Geodesic_step step(state);
  step.stopping_at_nodes(std::vector<double>{0, letter.end() == 0 ? -1. : 1., 0, 0, 0, 0}, 1);
  ASSERT_TRUE(state.is_at_node(1));
  EXPECT_EQ(state.node(1), node);
  EXPECT_EQ(step.moved(), std::vector<int>{1});
}

// ===  carried_map.h

TEST(Carried_map, stretches_parameters_with_their_arcs)
{
  const Equator from({0.5, 1, 1.25, 1.5});
  Flat_loop_system higher = from.system;
  higher.loops[0].height = 6;
  ASSERT_TRUE(have_same_loops(from.system, higher));
  Foliation_state to(higher, unit_weights(higher));
  to.set_map(carried_map(from.state, to));
  EXPECT_EQ(parameters(to, equator), (std::vector<double>{1.5, 3, 3.75, 4.5}));
  for (int e = 0; e < from.system.mesh.number_of_edges(); ++e)
    EXPECT_DOUBLE_EQ(length_of_edge(to, e), 3 * length_of_edge(from.state, e));
  Flat_loop_system lower = from.system;
  lower.loops[0].height = 1e-300;
  Foliation_state tiny(lower, unit_weights(lower));
  tiny.set_map(carried_map(from.state, tiny));
  EXPECT_GT(tiny.parameter(0), 0);
  EXPECT_LT(tiny.parameter(3), 1e-300);
}

TEST(Carried_map, keeps_words_and_nodes)
{
  const Flat_loop_system system = octahedron_with_three_poles();
  std::vector<double> weights = unit_weights(system);
  weights[edge_of(system.mesh.find_halfedge(1, 2))] = 3;
  Foliation_state from(system, weights), to(system, weights);
  Vertex_relaxation relax(from);
  relax(1);
  to.set_map(carried_map(from, to));
  EXPECT_EQ(to.arc(1), 1);
  EXPECT_EQ(to.node(3), 3);
  EXPECT_EQ(energy_of(to), energy_of(from));
  relax_band(to, {1}, 2, 3); // it is a state to go on from
  EXPECT_LT(energy_of(to), energy_of(from));
}

TEST(Have_same_loops, compares_what_matters)
{
  const Flat_loop_system two = octahedron_with_two_poles(), three = octahedron_with_three_poles();
  EXPECT_TRUE(have_same_loops(two, octahedron_with_two_poles()));
  EXPECT_FALSE(have_same_loops(two, three));
  EXPECT_TRUE(have_same_connectivity(two.mesh, three.mesh));
  EXPECT_FALSE(have_same_connectivity(two.mesh, flat_mesh(soups::tetrahedron())));
  Triangle_soup renamed = soups::octahedron();
  for (auto& triangle : renamed.triangles)
    for (std::size_t& v : triangle)
      v = v == 0 ? 4 : v == 4 ? 0 : v;
  EXPECT_FALSE(have_same_connectivity(two.mesh, flat_mesh(renamed)));
  Triangle_soup moved = soups::octahedron(), turned = soups::octahedron();
  moved.points[0] = {7, 0, 0};
  EXPECT_TRUE(have_same_loops(two, flat_system(moved, {{4}, {5}})));
  std::swap(turned.triangles[0], turned.triangles[1]); // faces are numbered differently
  EXPECT_FALSE(have_same_loops(two, flat_system(turned, {{5}, {4}})));
  // the same loop at another position, and one that begins elsewhere
  const Flat_loop_system torus = torus_with_one_loop();
  Flat_loop_system other = torus;
  for (Flat_crossing& crossing : other.loops[0].crossings)
    crossing.position = 0.125;
  EXPECT_TRUE(have_same_loops(torus, other));
  std::rotate(other.loops[0].crossings.begin(), other.loops[0].crossings.begin() + 2,
              other.loops[0].crossings.end());
  EXPECT_FALSE(have_same_loops(torus, other));
  // a loop that crosses an edge twice, and passes to the other side of itself
  const auto twice = [&](double first, double second) {
    Flat_loop_system result = torus;
    result.loops[0].crossings = {{0, first}, {0, second}};
    result.crossings = Edge_crossings(result.mesh, result.loops);
    return result;
  };
  EXPECT_TRUE(have_same_loops(twice(0.25, 0.75), twice(0.5, 0.625)));
  EXPECT_FALSE(have_same_loops(twice(0.25, 0.75), twice(0.75, 0.25)));
}

} // namespace test_tree_map_steps
