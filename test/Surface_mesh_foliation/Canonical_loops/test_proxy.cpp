// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Coarser meshes in place of fine ones: loops keep their classes both ways.

#include "generators/meshes.h"
#include "include/disjoint_loops.h"
#include "include/flat_meshes.h"

#include <CGAL/Surface_mesh_foliation/internal/Automatic_loops/Proposed_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Automatic_loops/Sweep.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Flat_loop_hierarchy.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Proxy.h>
#include <CGAL/Surface_mesh_foliation/internal/Homotopy/Deck_cocycle.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/loop_checks.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Edge_collapses.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Geodesic_distances.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Mesh_clusters.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace test_proxy {

namespace {

namespace SI = CGAL::Surface_mesh_foliation::internal;
using namespace smf_test;

std::vector<SI::Flat_loop> proposed_loops(const SI::Flat_mesh& mesh,
                                          const std::vector<SI::Pole>& poles)
{
  const SI::Sweep sweep(SI::Geodesic_distances(mesh, {poles[0][0]}).distances(), poles);
  SI::Proposed_loops proposed(mesh, poles, sweep);
  proposed.reduce(true);
  return proposed.loops();
}

} // namespace

// A coarse edge stands for all fine edges between two clusters, each once.
TEST(Mesh_clusters, have_chains_of_all_edges_between_them)
{
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
  {
    const SI::Flat_mesh fine =
      flat_mesh(to_soup(noisy(genus_surface(seed - 1, 4, seed), 0.1, seed)));
    const int goal = fine.number_of_vertices() / 5;
    const SI::Mesh_clusters clusters(
      fine, SI::Edge_collapses(fine, std::vector<bool>(fine.number_of_vertices(), false), goal));
    EXPECT_EQ(clusters.mesh().genus(), fine.genus());
    EXPECT_LE(clusters.mesh().number_of_vertices(), fine.number_of_vertices() / 4);
    std::vector<int> times(fine.number_of_edges(), 0);
    for (int e = 0; e < clusters.mesh().number_of_edges(); ++e)
      clusters.for_each_in_chain(SI::halfedge_of(e), [&](int h) {
        ++times[SI::edge_of(h)];
        EXPECT_EQ(clusters.coarse_halfedge(h), SI::halfedge_of(e));
      });
    for (int e = 0; e < fine.number_of_edges(); ++e)
    {
      const int h = SI::halfedge_of(e);
      EXPECT_EQ(times[e], clusters.of_source(h) != clusters.of_target(h));
    }
    for (int c = 0; c < clusters.mesh().number_of_vertices(); ++c)
    {
      EXPECT_EQ(clusters[clusters.representative(c)], c);
      EXPECT_EQ(clusters.mesh().point(c), fine.point(clusters.representative(c)));
    }
  }
}

TEST(Proxy, keeps_the_classes_of_loops)
{
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
  {
    SCOPED_TRACE(seed);
    const SI::Flat_mesh fine =
      flat_mesh(to_soup(noisy(genus_surface(seed % 3, 5, seed), 0.1, seed)));
    const std::vector<SI::Pole> poles = {{0}, {50}, {100}, {150}};
    const SI::Deck_cocycle deck(fine, poles);
    const std::vector<SI::Flat_loop> loops = proposed_loops(fine, poles);
    ASSERT_FALSE(loops.empty());
    const SI::Proxy proxy(fine, poles, loops, 300);
    EXPECT_LT(proxy.mesh().number_of_vertices(), fine.number_of_vertices());
    std::vector<SI::Flat_loop> coarse, back;
    for (const SI::Flat_loop& loop : loops)
    {
      coarse.push_back(proxy.on_proxy(loop));
      back.push_back(proxy.on_fine_mesh(coarse.back()));
      EXPECT_EQ(class_of_loop(deck, back.back()), class_of_loop(deck, loop));
    }
    expect_simple_and_disjoint(proxy.mesh(), coarse);
    expect_simple_and_disjoint(fine, back);
    // and loops of the proxy's own
    const SI::Proxy coarsest(fine, poles, {}, 300);
    std::vector<SI::Flat_loop> carried;
    for (const SI::Flat_loop& loop : proposed_loops(coarsest.mesh(), coarsest.poles()))
      carried.push_back(coarsest.on_fine_mesh(loop));
    expect_simple_and_disjoint(fine, carried);
    for (const SI::Flat_loop& loop : carried)
      EXPECT_FALSE(class_of_loop(deck, loop).empty());
  }
}

} // namespace test_proxy
