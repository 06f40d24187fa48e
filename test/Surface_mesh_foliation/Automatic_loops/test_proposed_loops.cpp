// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The loops that a sweep comes to first.

#include "generators/meshes.h"
#include "include/flat_meshes.h"

#include <CGAL/Surface_mesh_foliation/internal/Automatic_loops/Proposed_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Automatic_loops/Sweep.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Geodesic_distances.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <set>
#include <vector>

namespace test_proposed_loops {

namespace {

namespace SI = CGAL::Surface_mesh_foliation::internal;
using namespace smf_test;

std::vector<int> halfedges(const SI::Flat_loop& loop)
{
  std::vector<int> result;
  for (const SI::Flat_crossing& crossing : loop.crossings)
    result.push_back(crossing.halfedge);
  return result;
}

// A loop is a contour at any level from the first to the last of these.
struct Levels
{
  int first, last;
};

Levels levels(const SI::Flat_mesh& mesh, const SI::Sweep& sweep, const SI::Flat_loop& loop)
{
  Levels result = {0, std::numeric_limits<int>::max()};
  for (const SI::Flat_crossing& crossing : loop.crossings)
  {
    const int u = sweep.order().rank(mesh.source(crossing.halfedge)),
              v = sweep.order().rank(mesh.target(crossing.halfedge));
    result.first = std::max(result.first, std::min(u, v) + 1);
    result.last = std::min(result.last, std::max(u, v));
  }
  return result;
}

} // namespace

TEST(First_loops, of_a_sweep_are_those_nearest_to_its_start)
{
  std::size_t number_in_order = 0;
  for (const std::size_t genus : {0, 1, 3, 6})
  {
    SCOPED_TRACE(genus);
    const SI::Flat_mesh mesh =
      flat_mesh(soups::genus_surface(genus, genus == 0 ? 12 : 4, genus + 1));
    const int n = mesh.number_of_vertices();
    const std::vector<SI::Pole> poles = {{0}, {n / 4}, {n / 2}, {3 * n / 4}};
    for (const int source : {0, n / 3, n - 1})
    {
      const SI::Sweep sweep(SI::Geodesic_distances(mesh, {source}).distances(), poles);
      SI::Proposed_loops proposed(mesh, poles, sweep);
      proposed.reduce(true);
      std::set<std::vector<int>> all;
      for (const SI::Flat_loop& loop : proposed.loops())
        all.insert(halfedges(loop));
      ASSERT_FALSE(all.empty());
      const std::vector<SI::Flat_loop> sorted = proposed.first_loops(1000);
      ASSERT_EQ(sorted.size(), all.size());
      for (std::size_t most = 0; most <= all.size(); ++most)
      {
        const std::vector<SI::Flat_loop> first = proposed.first_loops(most);
        ASSERT_EQ(first.size(), most);
        for (std::size_t i = 0; i < most; ++i)
        {
          EXPECT_EQ(halfedges(first[i]), halfedges(sorted[i]));
          EXPECT_EQ(all.count(halfedges(first[i])), 1u);
        }
      }
      for (std::size_t i = 0; i < sorted.size(); ++i)
        for (std::size_t j = i + 1; j < sorted.size(); ++j)
        {
          const Levels one = levels(mesh, sweep, sorted[i]), other = levels(mesh, sweep, sorted[j]);
          EXPECT_LE(one.first, other.last);
          number_in_order += one.last < other.first;
        }
    }
  }
  EXPECT_GT(number_in_order, 100u); // which would not pass the other way around
}

} // namespace test_proposed_loops
