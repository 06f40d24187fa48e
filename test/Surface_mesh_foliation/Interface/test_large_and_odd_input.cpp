// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Input that is large or odd in one respect: vertices with very many neighbors, thousands of poles,
// hundreds of loops and handles, loops that cross very many edges, coordinates near the ends of the
// range of numbers. Prints how many seconds of the CPU each takes.
//
// By default the sizes are a tenth; the environment variable SMF_TEST_SIZE says how many per cent
// of the full ones, which are those of the target large_and_odd_input.

#include "generators/genus_soups.h"
#include "generators/meshes.h"
#include "include/edge_value_difference.h"
#include "include/number_from_environment.h"

#include <CGAL/Surface_mesh_foliation/automatic_loops.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/loops.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_embedding.h>

#include <CGAL/Timer.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace test_large_and_odd_input {

using namespace smf_test;
namespace SMF = CGAL::Surface_mesh_foliation;
using Foliation = SMF::Measured_foliation<Mesh>;
using Input = SMF::Poles_and_loops<Mesh>;
using Loop = SMF::Loop<Mesh>;
using System = SMF::Loop_system<Mesh>;

namespace {

std::size_t part_of(std::size_t full_size)
{
  return full_size * number_from_environment("SMF_TEST_SIZE", 10) / 100;
}

// the foliation, its embedded graph, and how long they took
Foliation solved(const std::string& what, const Mesh& mesh, const Input& input)
{
  CGAL::Timer timer;
  timer.start();
  const System system(mesh, input);
  const double loop_seconds = timer.time();
  const Foliation foliation = SMF::harmonic_foliation(system);
  const double seconds = timer.time();
  SMF::Reeb_graph<Kernel::Point_3> graph;
  SMF::reeb_graph(foliation, graph, SMF::reeb_graph_embedding(foliation));
  std::cout << what << ", " << num_vertices(mesh) << " vertices: system " << loop_seconds
            << " s, foliation " << seconds - loop_seconds << " s, graph " << timer.time() - seconds
            << " s, " << foliation.statistics().number_of_iterations << " iterations" << std::endl;
  EXPECT_TRUE(foliation.statistics().has_converged);
  EXPECT_TRUE(foliation.statistics().is_certified);
  EXPECT_EQ(num_edges(graph), system.number_of_arcs());
  EXPECT_EQ(num_vertices(graph), system.number_of_nodes());
  return foliation;
}

Input poles(const std::vector<std::size_t>& vertices)
{
  Input result;
  for (const std::size_t v : vertices)
    result.add_pole(vertex(v));
  return result;
}

// ===  Vertices with many neighbors

TEST(Hubs, are_poles)
{
  const Mesh mesh = to_mesh(soups::spindle(part_of(100000), 1));
  solved("two hubs as poles", mesh, poles({0, 1}));
}

TEST(Hubs, lie_among_poles)
{
  const std::size_t valence = part_of(100000);
  const Mesh mesh = to_mesh(soups::spindle(valence, 3));
  solved("two hubs among poles", mesh,
         poles({2, 2 + valence / 3, 2 + valence, 2 + 2 * valence + valence / 2}));
}

TEST(Hubs, lie_inside_of_a_loop)
{
  const std::size_t valence = part_of(100000);
  const Mesh mesh = to_mesh(soups::spindle(valence, 2));
  Input input = poles({2, 3 + valence / 2, 2 + valence, 3 + valence + valence / 2});
  std::vector<Loop> loops;
  SMF::plane_section_loops(mesh, {0, 0, 1, -1.5}, std::back_inserter(loops));
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_EQ(loops[0].size(), 2 * valence);
  input.add_loop(loops[0]);
  solved("a loop around a hub", mesh, input);
}

// ===  Many poles and loops

TEST(Many, poles)
{
  const Mesh mesh = icosphere(part_of(100) > 50 ? 6 : 5);
  Input input;
  const std::size_t number = part_of(10000), step = num_vertices(mesh) / number;
  for (std::size_t i = 0; i < number; ++i)
    input.add_pole(vertex(i * step));
  const Foliation foliation = solved(std::to_string(number) + " poles", mesh, input);
  EXPECT_EQ(foliation.system().number_of_nodes(), number + 1);
}

// around all bars between holes, and between holes and the border, that a column of holes has
std::vector<Loop> loops_across(const Mesh& mesh, std::size_t column, std::size_t resolution)
{
  std::vector<Loop> result;
  const double x = (2 * static_cast<double>(column) + 1.5) * static_cast<double>(resolution);
  SMF::plane_section_loops(mesh, {1, 0, 0, -x}, std::back_inserter(result));
  return result;
}

TEST(Many, handle_loops)
{
  const std::size_t columns = part_of(100) > 50 ? 15 : 5, resolution = 3;
  const Mesh mesh = genus_surface(columns * columns, resolution);
  Input input;
  for (std::size_t column = 0; column < columns; ++column)
    for (Loop& loop : loops_across(mesh, column, resolution))
      input.add_loop(std::move(loop));
  EXPECT_EQ(input.size(), columns * (columns + 1));
  solved(std::to_string(input.size()) + " handle loops", mesh, input);
}

TEST(Many, handles)
{
  const std::size_t genus = part_of(500);
  const Mesh mesh = genus_surface(genus, 2);
  Input input = poles({0, num_vertices(mesh) - 1});
  const Foliation without = solved("genus " + std::to_string(genus), mesh, input);
  EXPECT_EQ(without.system().genus(), genus);
  const std::size_t number = SMF::propose_loops(mesh, input);
  EXPECT_GE(number, genus);
  solved("genus " + std::to_string(genus) + ", " + std::to_string(number) + " proposed loops", mesh,
         input);
}

// Halfway between the poles, parameters differ from those at the node by rounding only, and a few
// vertices come to lie in folds without size.
TEST(Many, handles_between_poles_that_are_far_apart)
{
  const Mesh mesh = genus_surface(400, 2);
  solved("genus 400 between poles", mesh, poles({0, num_vertices(mesh) - 1}));
}

// winds around a torus so often that it passes every vertex
TEST(Many, edges_crossed_by_a_loop)
{
  const std::size_t n = static_cast<std::size_t>(std::sqrt(part_of(50500))), m = n + 1;
  const Mesh mesh = torus(m, n, 3, 1);
  std::vector<Mesh::Vertex_index> cycle;
  for (std::size_t i = 0; i < m * n; ++i)
    cycle.push_back(vertex(i % m * n + i % n));
  Input input;
  input.add_loop(SMF::loop_from_edge_cycle(cycle, mesh));
  const std::size_t number = input.entries()[0].loop.size();
  EXPECT_GT(number, part_of(100000));
  solved("a loop that crosses " + std::to_string(number) + " edges", mesh, input);
}

// ===  Coordinates

TEST(Odd_coordinates, change_nothing)
{
  const Triangle_soup soup = soups::limbed_sphere(5, 4);
  const Input input = poles(soups::limb_tips(5, 4));
  const Mesh mesh = to_mesh(soup);
  const Foliation expected = SMF::harmonic_foliation(System(mesh, input));
  for (const double unit : {1e-150, 1e-100, 1e100, 1e150})
  {
    Triangle_soup scaled = soup;
    for (auto& point : scaled.points)
      point = soups::scaled(point, unit);
    const Mesh other = to_mesh(scaled);
    const Foliation foliation = solved("unit " + std::to_string(std::log10(unit)), other, input);
    EXPECT_LT(difference(expected, foliation), 1e-9) << unit;
  }
}

} // namespace

} // namespace test_large_and_odd_input
