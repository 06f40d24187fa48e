// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Loops in minimal position: geometric intersection numbers, and disjoint loops in given classes.

#include "generators/Random.h"
#include "generators/meshes.h"
#include "include/disjoint_loops.h"
#include "include/flat_meshes.h"

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Geodesic_distances.h>
#include <CGAL/Surface_mesh_foliation/internal/Automatic_loops/Proposed_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Automatic_loops/Sweep.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Flat_loop_hierarchy.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Minimal_position.h>
#include <CGAL/Surface_mesh_foliation/internal/Homotopy/Deck_cocycle.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/loop_checks.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

namespace test_minimal_position {

namespace {

namespace SI = CGAL::Surface_mesh_foliation::internal;
using namespace smf_test;

std::vector<SI::Flat_loop> loops_of_sweep(const SI::Flat_mesh& mesh,
                                          const std::vector<SI::Pole>& poles,
                                          const std::vector<int>& sources)
{
  const SI::Sweep sweep(SI::Geodesic_distances(mesh, sources).distances(), poles);
  SI::Proposed_loops proposed(mesh, poles, sweep);
  proposed.reduce(true);
  return proposed.loops();
}

// m by n vertices; loops along one line of the grid each
SI::Flat_loop loop_of_torus(const SI::Flat_mesh& mesh, int m, int n, bool is_across, int at)
{
  SI::Flat_loop result;
  const auto v = [&](int i, int j) { return (i + m) % m * n + (j + n) % n; };
  // a line between two rows of vertices crosses the edges between them, one straight and one
  // diagonal for each square
  for (int k = 0; k < (is_across ? n : m); ++k)
  {
    const auto cross = [&](int right, int left) {
      result.crossings.push_back({mesh.find_halfedge(right, left), 0.5});
    };
    if (is_across) // between columns at and at + 1, with falling j
    {
      cross(v(at, -k), v(at + 1, -k));
      cross(v(at, -k - 1), v(at + 1, -k));
    }
    else // between rows at and at + 1, with growing i
    {
      cross(v(k, at), v(k, at + 1));
      cross(v(k, at), v(k + 1, at + 1));
    }
  }
  return result;
}

// of genus 0 to 3, with four to eight poles
SI::Flat_mesh random_surface(Random& random, std::uint64_t seed)
{
  const Mesh mesh =
    random.index(2) == 0 ? limbed_sphere(4, 3) : genus_surface(random.index(4), 3, seed);
  return flat_mesh(to_soup(noisy(mesh, 0.2, seed)));
}

std::vector<SI::Pole> random_poles(const SI::Flat_mesh& mesh, Random& random)
{
  std::set<int> poles;
  const std::size_t number = 4 + random.index(5);
  while (poles.size() < number)
    poles.insert(static_cast<int>(random.index(SI::index(mesh.number_of_vertices()))));
  std::vector<SI::Pole> result;
  for (const int v : poles)
    result.push_back({v});
  return result;
}

} // namespace

TEST(Minimal_position, on_a_torus)
{
  constexpr int m = 12, n = 8;
  const SI::Flat_mesh mesh = flat_mesh(soups::torus(m, n, 3, 1));
  const std::vector<SI::Pole> poles = {{5}, {60}};
  const SI::Deck_cocycle deck(mesh, poles);
  const SI::Flat_loop along = loop_of_torus(mesh, m, n, false, 2);
  const SI::Flat_loop across = loop_of_torus(mesh, m, n, true, 3);
  expect_simple_and_disjoint(mesh, {along});
  expect_simple_and_disjoint(mesh, {across});
  EXPECT_EQ(SI::Minimal_position(deck, mesh, {along}, across).number_of_crossings(0), 1);
  EXPECT_EQ(SI::Minimal_position(deck, mesh, {across}, along).number_of_crossings(0), 1);
  EXPECT_TRUE(
    SI::Minimal_position(deck, mesh, {along}, loop_of_torus(mesh, m, n, false, 5)).is_disjoint());
}

// Two loops of one class that cross each other can be moved apart, whatever the sweeps were that
// they come from; those of two classes cross as often whichever of them is moved. Words alone tell
// the classes.
TEST(Minimal_position, agrees_with_classes_and_is_symmetric)
{
  int equal = 0, disjoint = 0, crossing = 0, removed = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const SI::Flat_mesh mesh = random_surface(random, seed);
    const std::vector<SI::Pole> poles = random_poles(mesh, random);
    const SI::Deck_cocycle deck(mesh, poles);
    const std::vector<SI::Flat_loop> first = loops_of_sweep(mesh, poles, {poles[0][0]});
    const std::vector<SI::Flat_loop> second =
      loops_of_sweep(mesh, poles, {poles[1][0], poles[2][0]});
    for (const SI::Flat_loop& x : first)
      for (const SI::Flat_loop& y : second)
      {
        const SI::Minimal_position position(deck, mesh, {x}, y);
        const int crossings = position.number_of_crossings(0);
        EXPECT_EQ(SI::Minimal_position(deck, mesh, {y}, x).number_of_crossings(0), crossings);
        EXPECT_EQ(class_of_loop(deck, position.loops()[0]), class_of_loop(deck, x));
        EXPECT_EQ(class_of_loop(deck, position.loops()[1]), class_of_loop(deck, y));
        expect_simple_and_disjoint(mesh, {position.loops()[1]});
        const bool are_equal = class_of_loop(deck, x) == class_of_loop(deck, y);
        if (are_equal)
        {
          EXPECT_EQ(crossings, 0);
        }
        if (crossings == 0)
          expect_simple_and_disjoint(mesh, position.loops());
        equal += are_equal;
        disjoint += crossings == 0;
        crossing += crossings > 0;
        removed += position.loops()[1].crossings.size() != y.crossings.size();
      }
    // all loops of one sweep stay where they are
    const std::vector<SI::Flat_loop> fixed(first.begin(), first.end() - (first.empty() ? 0 : 1));
    if (!first.empty())
    {
      EXPECT_TRUE(SI::Minimal_position(deck, mesh, fixed, first.back()).is_disjoint());
    }
    // one loop of the other sweep among all of the first
    for (const SI::Flat_loop& y : second)
    {
      const SI::Minimal_position position(deck, mesh, first, y);
      for (std::size_t i = 0; i < first.size(); ++i)
        EXPECT_EQ(position.number_of_crossings(static_cast<int>(i)),
                  SI::Minimal_position(deck, mesh, {first[i]}, y).number_of_crossings(0));
      if (position.is_disjoint())
        expect_simple_and_disjoint(mesh, position.loops());
    }
  }
  EXPECT_GT(equal, 10);
  EXPECT_GT(disjoint, equal);
  EXPECT_GT(crossing, 10);
  EXPECT_GT(removed, 10);
}

} // namespace test_minimal_position
