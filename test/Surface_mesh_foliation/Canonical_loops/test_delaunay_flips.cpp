// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Intrinsic Delaunay flips, and loops that are carried across them.

#include "generators/Random.h"
#include "generators/meshes.h"
#include "include/flat_meshes.h"

#include <CGAL/Surface_mesh_foliation/internal/Automatic_loops/Proposed_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Automatic_loops/Sweep.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Class_moduli.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/Flat_loop_system.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/Loop_after_flips.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Delaunay_flips.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Geodesic_distances.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace test_delaunay_flips {

namespace {

namespace SI = CGAL::Surface_mesh_foliation::internal;
using namespace smf_test;

SI::Flat_mesh bad_mesh(std::uint64_t seed)
{
  Random random(seed);
  const Mesh mesh = random.index(2) == 0 ? limbed_sphere(3 + random.index(3), 3)
                                         : genus_surface(1 + random.index(3), 2, seed);
  return flat_mesh(to_soup(flip_random_edges(noisy(mesh, 0.2, seed), 0.3, seed)));
}

SI::Flat_mesh mesh_of_needles(std::uint64_t seed)
{
  constexpr double stretch = 20;
  Triangle_soup soup = to_soup(seed % 2 == 0 ? limbed_sphere(3, 3) : genus_surface(2, 2, seed));
  for (auto& point : soup.points)
    point[0] *= stretch;
  return flat_mesh(soup);
}

int number_of_negative(const std::vector<double>& numbers)
{
  return static_cast<int>(
    std::count_if(numbers.begin(), numbers.end(), [](double x) { return x < -1e-6; }));
}

} // namespace

TEST(Delaunay_flips, leave_few_negative_weights)
{
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
  {
    SCOPED_TRACE(seed);
    const SI::Flat_mesh mesh = bad_mesh(seed);
    const SI::Delaunay_flips flips(mesh, SI::edge_lengths(mesh),
                                   std::vector<int>(mesh.number_of_vertices(), -1));
    EXPECT_FALSE(flips.changes().empty());
    EXPECT_GE(flips.mesh().number_of_vertices(), mesh.number_of_vertices());
    EXPECT_LT(flips.mesh().number_of_vertices(), 1.05 * mesh.number_of_vertices());
    EXPECT_EQ(flips.mesh().genus(), mesh.genus());
    EXPECT_LT(number_of_negative(flips.cotangents()), mesh.number_of_edges() / 50);
  }
}

TEST(Delaunay_flips, leave_a_regular_triangulation_alone)
{
  const SI::Flat_mesh mesh = flat_mesh(soups::icosphere(3));
  const SI::Delaunay_flips flips(mesh, SI::edge_lengths(mesh),
                                 std::vector<int>(mesh.number_of_vertices(), -1));
  EXPECT_TRUE(flips.changes().empty());
  EXPECT_EQ(number_of_negative(flips.cotangents()), 0);
}

TEST(Delaunay_flips, neither_flip_nor_make_edges_of_a_group)
{
  const SI::Flat_mesh mesh = bad_mesh(3);
  const SI::Delaunay_flips flips(mesh, SI::edge_lengths(mesh),
                                 std::vector<int>(mesh.number_of_vertices(), 0));
  EXPECT_TRUE(flips.changes().empty());
}

TEST(Delaunay_flips, divide_long_edges)
{
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
  {
    SCOPED_TRACE(seed);
    const SI::Flat_mesh mesh = mesh_of_needles(seed);
    const SI::Delaunay_flips flips(mesh, SI::edge_lengths(mesh),
                                   std::vector<int>(mesh.number_of_vertices(), -1));
    EXPECT_GT(flips.mesh().number_of_vertices(), 1.05 * mesh.number_of_vertices());
    EXPECT_LT(flips.mesh().number_of_vertices(), 3 * mesh.number_of_vertices());
    EXPECT_EQ(flips.mesh().genus(), mesh.genus());
  }
}

// A vertex in the middle of an edge of the set is in it, too.
TEST(Delaunay_flips, carry_sets_of_vertices)
{
  const SI::Flat_mesh mesh = mesh_of_needles(2);
  const SI::Delaunay_flips flips(mesh, SI::edge_lengths(mesh),
                                 std::vector<int>(mesh.number_of_vertices(), -1));
  const std::size_t before = mesh.number_of_vertices(), after = flips.mesh().number_of_vertices();
  EXPECT_EQ(flips.with_middles(std::vector<bool>(before, true)), std::vector<bool>(after, true));
  EXPECT_EQ(flips.with_middles(std::vector<bool>(before, false)), std::vector<bool>(after, false));
}

// Loops stay simple, disjoint, essential and in different classes, and cut the surface into the
// same pieces.
TEST(Loop_after_flips, is_in_its_class)
{
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
  {
    SCOPED_TRACE(seed);
    const SI::Flat_mesh mesh = seed % 2 == 0 ? bad_mesh(seed) : mesh_of_needles(seed);
    std::vector<SI::Pole> poles;
    for (const int v : {0, 20, 40, 60, 80})
      poles.push_back({v});
    const SI::Sweep sweep(SI::Geodesic_distances(mesh, {0, 20}).distances(), poles);
    SI::Proposed_loops proposed(mesh, poles, sweep);
    proposed.reduce(true);
    const SI::Delaunay_flips flips(mesh, SI::edge_lengths(mesh),
                                   SI::poles_of_vertices(mesh, poles));
    for (const SI::Flat_loop& loop : proposed.loops())
    {
      const auto pieces = [&](const SI::Flat_mesh& where, const SI::Flat_loop& moved) {
        SI::Flat_loop_system system;
        system.mesh = where;
        system.poles = poles;
        for (std::size_t p = 0; p < poles.size(); ++p)
        {
          system.loops.emplace_back();
          system.loops.back().pole = static_cast<int>(p);
          system.loops.back().is_tight = true;
        }
        system.loops.push_back(moved);
        SI::Problems problems;
        complete(system, problems);
        for (const auto& problem : problems)
          ADD_FAILURE() << problem.message;
        std::vector<std::vector<int>> result;
        for (const auto& node : system.nodes)
          result.push_back({node.pole, node.genus, node.degree});
        std::sort(result.begin(), result.end());
        return result;
      };
      EXPECT_EQ(pieces(mesh, loop), pieces(flips.mesh(), loop_after_flips(mesh, loop, flips)));
    }
  }
}

} // namespace test_delaunay_flips
