// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Solving on coarser meshes first changes nothing but the time: the coarse mesh is a mesh of the
// same surface with the same loops, a foliation on it is one on the fine mesh, and the harmonic
// foliation that is reached from there is that reached from fronts.

#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/Supernodal_cholesky_solver.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/lengths.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/certify.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Coarse_level.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Newton_solver.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/grow_fronts.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/start_from_coarse.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/tied_vertices.h>

#include "include/random_systems.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_coarse_to_fine {

using namespace smf_test;
using namespace CGAL::Surface_mesh_foliation::internal;

namespace {

SMF::Foliation_statistics solve(Foliation_state& state)
{
  SMF::Supernodal_cholesky_solver linear_solver;
  return Newton_solver(state, linear_solver)(Solver_options());
}

// of edge values, divided by the largest
double difference(const Foliation_state& a, const Foliation_state& b)
{
  double largest = 0, result = 0;
  for (int e = 0; e < a.mesh().number_of_edges(); ++e)
  {
    largest = std::max(largest, length_of_edge(a, e));
    result = std::max(result, std::abs(length_of_edge(a, e) - length_of_edge(b, e)));
  }
  return result / largest;
}

// calls test(system) for random systems on meshes of at least 100 vertices
template <class Test>
void for_each_system(int number, const Test& test)
{
  int found = 0;
  for (std::uint64_t seed = 1; found < number && seed < 1000; ++seed)
  {
    Random random(seed);
    const Mesh mesh = random_mesh(random);
    const std::vector<Item> items = Random_items(mesh, random)();
    if (items.empty() || num_vertices(mesh) < 100)
      continue;
    ++found;
    SCOPED_TRACE("seed " + std::to_string(seed) + ": " + to_string(items));
    test(SMF::Loop_system<Mesh>(mesh, poles_and_loops(items, mesh)).data().flat);
  }
  EXPECT_EQ(found, number);
}

// splits every eighth face by a vertex very close to one of its corners
Mesh with_tied_vertices(Mesh mesh)
{
  const std::size_t number_of_faces = num_faces(mesh);
  for (std::size_t f = 0; f < number_of_faces; f += 8)
  {
    const auto h = halfedge(Mesh::Face_index(static_cast<Mesh::size_type>(f)), mesh);
    const Mesh::Point corner = mesh.point(target(h, mesh));
    const Mesh::Point middle =
      CGAL::midpoint(mesh.point(source(h, mesh)), mesh.point(target(next(h, mesh), mesh)));
    mesh.point(target(CGAL::Euler::add_center_vertex(h, mesh), mesh)) =
      corner + 1e-5 * (middle - corner);
  }
  return mesh;
}

SMF::Poles_and_loops<Mesh> with_poles(const std::vector<std::size_t>& vertices)
{
  SMF::Poles_and_loops<Mesh> result;
  for (std::size_t v : vertices)
    result.add_pole(vertex(v));
  return result;
}

// Nodes may have other numbers, but arcs have the same.
void expect_same_graph(const Flat_loop_system& expected, const Flat_loop_system& actual)
{
  ASSERT_EQ(actual.number_of_arcs(), expected.number_of_arcs());
  ASSERT_EQ(actual.nodes.size(), expected.nodes.size());
  std::map<int, int> actual_node, expected_node;
  for (int a = 0; a < expected.number_of_arcs(); ++a)
    for (int end : {0, 1})
    {
      const int u = expected.node_of_end(a, end), v = actual.node_of_end(a, end);
      EXPECT_EQ(actual_node.emplace(u, v).first->second, v);
      EXPECT_EQ(expected_node.emplace(v, u).first->second, u);
      EXPECT_EQ(actual.nodes[v].genus, expected.nodes[u].genus);
      EXPECT_EQ(actual.nodes[v].pole, expected.nodes[u].pole);
    }
  EXPECT_EQ(actual_node.size(), expected.nodes.size());
}

} // namespace

TEST(Tied_vertices, are_those_of_edges_with_very_large_weights)
{
  const SMF::Loop_system<Mesh> system(icosphere(4), with_poles({0, 1, 2})),
    tied_system(with_tied_vertices(icosphere(4)), with_poles({0, 1, 2}));
  const auto state_of = [](const SMF::Loop_system<Mesh>& s) {
    const Flat_loop_system& flat = s.data().flat;
    return std::make_unique<Foliation_state>(flat, mean_value_weights(flat.mesh));
  };
  EXPECT_TRUE(tied_vertices(*state_of(system), 0.05).empty());
  const auto state = state_of(tied_system);
  const Flat_mesh& mesh = state->mesh();
  const std::vector<int> cluster = tied_vertices(*state, 0.05);
  ASSERT_EQ(static_cast<int>(cluster.size()), mesh.number_of_vertices());
  for (int v = 2562; v < mesh.number_of_vertices(); ++v) // those of the split faces
  {
    int number_of_corners = 0;
    for (int h : mesh.ring(v))
      number_of_corners += cluster[mesh.target(h)] == cluster[v];
    EXPECT_EQ(number_of_corners, 1);
  }
  EXPECT_EQ(std::set<int>(cluster.begin(), cluster.end()).size(), 2562u);
}

TEST(Coarse_to_fine, tied_vertices_are_led_to_their_places_as_one)
{
  for (const Mesh& smooth : {icosphere(4), torus(60, 30, 3, 1), genus_surface(2, 5, 1)})
  {
    const Mesh mesh = with_tied_vertices(smooth);
    const SMF::Loop_system<Mesh> system(mesh, with_poles({0, 101, 202, 303}));
    const Flat_loop_system& flat = system.data().flat;
    SCOPED_TRACE("genus " + std::to_string(flat.mesh.genus()));
    const std::vector<double> weights = mean_value_weights(flat.mesh);
    Foliation_state cold(flat, weights), state(flat, weights);
    const int n = flat.mesh.number_of_vertices();

    Coarse_level level(state, tied_vertices(state, 0.05));
    const int clusters = level.state().mesh().number_of_vertices();
    EXPECT_LT(clusters, 0.95 * n);
    EXPECT_EQ(level.state().mesh().genus(), flat.mesh.genus());
    grow_fronts(level.state());
    EXPECT_TRUE(solve(level.state()).has_converged);
    state.set_map(level.prolonged());
    EXPECT_NEAR(energy_of(state) / energy_of(level.state()), 1, 1e-12);

    std::set<int> sizes;
    Foliation_state led(flat, weights);
    start_from_coarse(led, {[&](int size, const SMF::Foliation_statistics&) {
                        sizes.insert(size);
                        return true;
                      }});
    EXPECT_EQ(sizes.count(clusters), 1u);
    grow_fronts(cold);
    EXPECT_TRUE(solve(cold).has_converged);
    const SMF::Foliation_statistics end = solve(led);
    EXPECT_TRUE(end.has_converged);
    EXPECT_LE(end.number_of_iterations, 6u);
    EXPECT_LT(difference(cold, led), 1e-9);
    EXPECT_TRUE(certify(led, Extraction(led)).empty());
  }
}

TEST(Coarse_to_fine, coarse_systems_have_the_same_surface_and_graph)
{
  std::set<int> genera;
  int fewest = 100;
  for_each_system(60, [&](const Flat_loop_system& system) {
    const Foliation_state fine(system, mean_value_weights(system.mesh));
    Coarse_level level(fine, system.mesh.number_of_vertices() / 8);
    const Flat_loop_system& coarse = level.state().system();
    EXPECT_LE(coarse.mesh.number_of_vertices(), system.mesh.number_of_vertices());
    fewest =
      std::min(fewest, 100 * coarse.mesh.number_of_vertices() / system.mesh.number_of_vertices());
    EXPECT_EQ(coarse.mesh.genus(), system.mesh.genus());
    genera.insert(coarse.mesh.genus());

    // checked from its mesh, poles and loops alone, it is a valid system with the same dual graph
    Flat_loop_system again;
    again.mesh = coarse.mesh;
    again.poles = coarse.poles;
    again.loops = coarse.loops;
    Problems problems;
    complete(again, problems);
    ASSERT_TRUE(problems.empty()) << problems.front().message;
    expect_same_graph(system, again);
  });
  EXPECT_LT(fewest, 20); // percent
  EXPECT_GE(genera.size(), 4u);
}

TEST(Coarse_to_fine,
     what_is_certified_on_the_coarse_mesh_is_a_map_of_the_same_class_on_the_fine_one)
{
  for_each_system(60, [&](const Flat_loop_system& system) {
    Foliation_state fine(system, mean_value_weights(system.mesh));
    Coarse_level level(fine, system.mesh.number_of_vertices() / 4);
    grow_fronts(level.state());
    EXPECT_TRUE(solve(level.state()).has_converged);
    EXPECT_TRUE(certify(level.state(), Extraction(level.state())).empty());
    fine.set_map(level.prolonged());
    for (int f = 0; f < fine.mesh().number_of_faces(); ++f)
    {
      const Tripod tripod(fine, f);
      for (int i : {0, 1, 2})
        EXPECT_GE(tripod.leg(i), 0);
    }
    for (const Pole& pole : system.poles)
      for (int v : pole)
        EXPECT_TRUE(fine.map().cell[v] == Cell::at_node(system.node_of_vertex[v]));
    EXPECT_TRUE(solve(fine).has_converged);
    const std::vector<SMF::Problem> problems = certify(fine, Extraction(fine));
    EXPECT_TRUE(problems.empty()) << problems.front().message;
  });
}

TEST(Coarse_to_fine, the_solution_is_that_from_fronts_in_fewer_iterations)
{
  std::size_t cold_iterations = 0, iterations = 0;
  for_each_system(100, [&](const Flat_loop_system& system) {
    const std::vector<double> weights = mean_value_weights(system.mesh);
    Foliation_state cold(system, weights), state(system, weights);
    grow_fronts(cold);
    start_from_coarse(state, Progress(), 30);
    const SMF::Foliation_statistics from_cold = solve(cold), from_coarse = solve(state);
    EXPECT_TRUE(from_cold.has_converged);
    EXPECT_TRUE(from_coarse.has_converged);
    EXPECT_LT(difference(cold, state), 1e-9);
    cold_iterations += from_cold.number_of_iterations;
    iterations += from_coarse.number_of_iterations;
  });
  EXPECT_LT(iterations, cold_iterations);
}

TEST(Coarse_to_fine, coarse_meshes_have_room_for_saddles_and_short_arcs)
{
  struct Case
  {
    Mesh mesh;
    int poles;
    double height_of_first; // of the others: 1
    int size;
  };
  const Mesh sphere = icosphere(5), handles = genus_surface(6, 8); // 10,242 and 6,774 vertices
  for (const Case& c :
       {Case{sphere, 3, 1, 640}, Case{sphere, 9, 1, 1200}, Case{sphere, 40, 1, 5121},
        Case{sphere, 3, 0.011, 640}, Case{sphere, 3, 0.009, 3414}, Case{sphere, 3, 101, 3414},
        Case{sphere, 40, 101, 5121}, Case{handles, 2, 1, 2200}, Case{handles, 10, 1, 3387}})
  {
    SMF::Poles_and_loops<Mesh> input;
    for (int i = 0; i < c.poles; ++i)
      input.add_pole(vertex(20 * i), i == 0 ? c.height_of_first : 1);
    const SMF::Loop_system<Mesh> system(c.mesh, input);
    const Flat_loop_system& flat = system.data().flat;
    const Foliation_state state(flat, mean_value_weights(flat.mesh));
    EXPECT_EQ(size_of_coarse_mesh(state), c.size) << c.poles << ' ' << c.height_of_first;
  }
}

TEST(Coarse_to_fine, coarse_meshes_are_left_when_few_vertices_change_arcs)
{
  int left_early = 0;
  for (const Mesh& mesh : {icosphere(4), torus(60, 40, 3, 1), genus_surface(3, 8)})
  {
    const SMF::Loop_system<Mesh> system(mesh, with_poles({0, 100, 200, 300, 400}));
    const Flat_loop_system& flat = system.data().flat;
    Foliation_state state(flat, mean_value_weights(flat.mesh));
    std::vector<std::pair<int, SMF::Foliation_statistics>>
      iterations; // with the number of vertices
    start_from_coarse(state, {[&](int size, const SMF::Foliation_statistics& iteration) {
                        iterations.emplace_back(size, iteration);
                        return true;
                      }});
    ASSERT_FALSE(iterations.empty());
    for (std::size_t i = 0; i < iterations.size(); ++i)
    {
      const auto& [size, iteration] = iterations[i];
      const auto changed = static_cast<double>(iteration.number_of_changed_vertices);
      const bool is_last = i + 1 == iterations.size() || iterations[i + 1].first != size;
      if (!is_last)
        EXPECT_GE(changed * changed, size);
      else
        left_early += iteration.resolved_optimality > 1e-6;
    }
  }
  EXPECT_GT(left_early, 0);
}

TEST(Coarse_to_fine, meshes_of_150_vertices_and_more_start_from_a_coarse_one)
{
  for (const Mesh& mesh : {icosphere(2), torus(14, 10, 3, 1), torus(15, 10, 3, 1)}) // 162, 140, 150
  {
    const SMF::Loop_system<Mesh> system(mesh, with_poles({0, 30, 60}));
    const Flat_loop_system& flat = system.data().flat;
    Foliation_state state(flat, mean_value_weights(flat.mesh));
    bool has_coarse_mesh = false;
    const Progress progress = {
      [&](int, const SMF::Foliation_statistics&) { return has_coarse_mesh = true; }};
    EXPECT_TRUE(start_from_coarse(state, progress));
    EXPECT_EQ(has_coarse_mesh, num_vertices(mesh) >= 150);
  }
}

} // namespace test_coarse_to_fine
