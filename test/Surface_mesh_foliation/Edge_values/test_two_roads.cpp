// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The graph of a harmonic foliation, known from its loops, and the one found by integrating and
// tracing its edge values: two roads that share nothing but the values. On the examples, on
// generated meshes of genus 0 to 5, and, if there are any, on the shared ones and CGAL's elephant.

#include "include/each_foliation.h"
#include "include/named_meshes.h"
#include "include/random_systems.h"
#include "include/two_roads.h"

#include <CGAL/Surface_mesh_foliation/IO/read_triangle_mesh.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <string>
#include <vector>

namespace test_two_roads {

using namespace smf_test;

namespace {

class Two_roads : public Each_foliation
{};

std::vector<std::string> meshes_and_elephant()
{
  std::vector<std::string> result = all_meshes();
  const std::string data = SMF_DATA_DIR;
  if (!data.empty())
    result.push_back(data + "/elephant.off");
  return result;
}

class Two_roads_on_meshes : public testing::TestWithParam<std::string>
{
protected:
  Two_roads_on_meshes() : mesh(load(GetParam())) {}

  // poles, and from genus 1 on, if the mesh is not so large that looking for them takes long, up to
  // two handle loops that are valid together with them
  Input with_handles(Input input) const
  {
    Random random(1);
    Random_items items(mesh, random);
    const int attempts = genus(mesh) > 0 && !is_large() ? 20 : 0;
    for (int attempt = 0, found = 0; found < 2 && attempt < attempts; ++attempt)
    {
      const Item item = items.handle();
      Input more = input;
      if (item.vertices.empty())
        continue;
      add_item(item, mesh, more);
      if (!SMF::validate(mesh, more).empty())
        continue;
      input = more;
      ++found;
    }
    return input;
  }

  bool is_large() const { return num_vertices(mesh) > 10000; }

  Vertex at(double share) const
  {
    return Vertex(static_cast<Mesh::size_type>(share * static_cast<double>(num_vertices(mesh))));
  }

  Mesh mesh;
};

} // namespace

TEST_P(Two_roads, agree)
{
  expect_both_roads_agree(foliation);
}

INSTANTIATE_TEST_SUITE_P(Examples,
                         Two_roads,
                         testing::ValuesIn(all_example_systems()),
                         name_of_example);

TEST_P(Two_roads_on_meshes, agree_with_spread_poles)
{
  Input input;
  const std::vector<double> heights = {1, 0.5, 2, 1.5};
  for (std::size_t i = 0; i < 4; ++i)
    input.add_pole(at((2 * static_cast<double>(i) + 1) / 8), heights[i]);
  const SMF::Loop_system<Mesh> system(mesh, with_handles(input));
  const bool is_steep = expect_both_roads_agree(SMF::harmonic_foliation(system));
  std::cout << (is_steep ? "areas agree, too" : "plateaus at critical leaves") << std::endl;
}

// On whatever limbs there are the values are noise.
TEST_P(Two_roads_on_meshes, agree_with_adjacent_poles)
{
  if (is_large())
    GTEST_SKIP() << "that one is large";
  Input input;
  const Vertex v = at(0.333);
  input.add_pole(v);
  const auto neighbors = CGAL::vertices_around_target(v, mesh);
  auto neighbor = neighbors.begin();
  input.add_pole(*neighbor++);
  input.add_pole(*neighbor);
  const SMF::Loop_system<Mesh> system(mesh, with_handles(input));
  expect_both_roads_agree(SMF::harmonic_foliation(system));
}

INSTANTIATE_TEST_SUITE_P(Meshes,
                         Two_roads_on_meshes,
                         testing::ValuesIn(meshes_and_elephant()),
                         name_of_mesh);

TEST(Two_roads_on_random_systems, agree)
{
  int systems = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Mesh mesh = random_mesh(random);
    const std::vector<Item> items = Random_items(mesh, random)();
    if (items.empty())
      continue;
    ++systems;
    expect_both_roads_agree(
      SMF::harmonic_foliation(SMF::Loop_system<Mesh>(mesh, poles_and_loops(items, mesh))));
  }
  EXPECT_GT(systems, 20);
}

// Components thinner than the tolerance are noise, or leaves are not told apart; all others count.
TEST(Two_roads_on_random_systems, heights_below_the_tolerance)
{
  int agreed = 0, refused = 0, merged = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    Mesh mesh = random_mesh(random);
    std::vector<Item> items = Random_items(mesh, random)();
    if (items.empty())
      continue;
    for (Item& item : items)
      item.height = std::pow(10., random.between(-11, 0));
    const SMF::Loop_system<Mesh> system(mesh, poles_and_loops(items, mesh));
    const auto values = mesh.add_property_map<Mesh::Edge_index, double>("e:value").first;
    SMF::edge_values(SMF::harmonic_foliation(system), values);
    double largest = 0;
    for (const auto e : edges(mesh))
      largest = std::max(largest, values[e]);
    try
    {
      const auto foliation = SMF::integrate_foliation(mesh, values);
      const std::size_t arcs = foliation.system().number_of_arcs();
      ++(arcs == system.number_of_arcs() ? agreed : merged);
      std::size_t thick_arcs = 0;
      for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
        thick_arcs += system.height(a) > 2e-9 * largest;
      EXPECT_GE(arcs, thick_arcs);
      EXPECT_LE(arcs, system.number_of_arcs());
    }
    catch (const SMF::Invalid_foliation_exception& exception)
    {
      ++refused;
      EXPECT_FALSE(exception.problem().vertices.empty() && exception.problem().faces.empty());
    }
  }
  EXPECT_GT(agreed, 10);
  EXPECT_GT(refused, 2);
  EXPECT_LT(merged, agreed / 2) << "refused: " << refused;
}

// foliations that are far from harmonic
TEST(Two_roads_on_other_foliations, agree)
{
  int not_harmonic = 0;
  for (const Example& example : example_systems())
  {
    SCOPED_TRACE(example.name);
    const Solved_example<> solved(example);
    const auto foliation =
      SMF::harmonic_foliation(solved.system, CGAL::parameters::number_of_iterations(0));
    not_harmonic += !foliation.statistics().has_converged;
    expect_both_roads_agree(foliation);
  }
  EXPECT_GT(not_harmonic, 5);
}

} // namespace test_two_roads
