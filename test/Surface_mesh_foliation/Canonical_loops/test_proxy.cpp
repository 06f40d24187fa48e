// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Coarser meshes in place of fine ones: loops keep their classes both ways.

#include "generators/known_moduli.h"
#include "generators/meshes.h"
#include "generators/revolution.h"
#include "include/disjoint_loops.h"
#include "include/flat_meshes.h"

#include <CGAL/Surface_mesh_foliation/internal/Automatic_loops/Proposed_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Automatic_loops/Sweep.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Flat_loop_hierarchy.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Loops_on_proxy.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Proxy.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/Poll.h>
#include <CGAL/Surface_mesh_foliation/internal/Homotopy/Deck_cocycle.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/loop_checks.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Edge_collapses.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Geodesic_distances.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Mesh_clusters.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
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

// A thin torus has few edges around on a proxy of even edges. Its modulus is known: the torus is
// conformal to a flat one.
TEST(Loops_on_proxy, are_measured_on_a_finer_one_where_handles_are_thin)
{
  double error = 0, error_before = 0; // relative, their sums
  for (const double r : {0.06, 0.08, 0.1, 0.12, 0.15})
  {
    SCOPED_TRACE(r);
    const double expected = std::sqrt(9 - r * r) / r;
    const SI::Flat_mesh fine = flat_mesh(soups::torus(static_cast<std::size_t>(72 / r), 24, 3, r));
    const auto proxy =
      std::make_shared<const SI::Proxy>(fine, std::vector<SI::Pole>(), SI::Proxy::no_loops(), 1000);
    const SI::Loops_on_proxy found(fine, {}, proxy);
    ASSERT_EQ(found.hierarchy().loops().size(), 1u);
    EXPECT_TRUE(found.hierarchy().loops()[0].is_measured_again);
    const double modulus = found.hierarchy().loops()[0].modulus;
    EXPECT_NEAR(modulus, expected, 0.1 * expected);
    const double before =
      SI::Flat_loop_hierarchy(proxy->mesh(), proxy->lengths(), proxy->poles()).loops()[0].modulus;
    EXPECT_GT(std::abs(before - expected), std::abs(modulus - expected));
    error += std::abs(modulus / expected - 1);
    error_before += std::abs(before / expected - 1);
  }
  EXPECT_GT(error_before, 2 * error);
}

// With twenty vertices around, too, moduli depend on which edges were collapsed, by some percent.
TEST(Loops_on_proxy, are_measured_on_a_finer_one_where_handles_are_a_little_thin)
{
  for (const double r : {0.15, 0.2, 0.3})
  {
    SCOPED_TRACE(r);
    const double expected = std::sqrt(9 - r * r) / r;
    const Triangle_soup soup = soups::torus(static_cast<std::size_t>(108 / r), 36, 3, r);
    for (std::uint64_t seed = 1; seed <= 2; ++seed)
    {
      const SI::Flat_mesh fine =
        flat_mesh(soups::relabeled(soup, new_labels(soup.points.size(), seed), seed));
      const auto proxy = std::make_shared<const SI::Proxy>(fine, std::vector<SI::Pole>(),
                                                           SI::Proxy::no_loops(), 5000);
      const SI::Loops_on_proxy found(fine, {}, proxy);
      ASSERT_EQ(found.hierarchy().loops().size(), 1u);
      EXPECT_NEAR(found.hierarchy().loops()[0].modulus, expected, 0.015 * expected);
    }
  }
}

// With a few edges around each bar of a plate with holes, moduli depend on which edges were
// collapsed, by several percent, and with them the order of the loops.
TEST(Loops_on_proxy, do_not_depend_on_the_order_of_vertices_where_handles_are_thin)
{
  // Its bars are alike, and no two have the same modulus if it is bent.
  Triangle_soup soup = soups::genus_surface(4, 6);
  double width = 0;
  for (const soups::Point& p : soup.points)
    width = std::max(width, p[0]);
  for (soups::Point& p : soup.points)
  {
    const double x = p[0] / width, y = p[1] / width;
    p = {p[0] * (1 + 0.6 * x), p[1] * (1 + 0.6 * y * (1 + 0.3 * x)), p[2] * (1 + 0.6 * x * y)};
  }
  std::vector<double> expected;
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
  {
    SCOPED_TRACE(seed);
    const SI::Flat_mesh fine =
      flat_mesh(soups::relabeled(soup, new_labels(soup.points.size(), seed), seed));
    const auto proxy =
      std::make_shared<const SI::Proxy>(fine, std::vector<SI::Pole>(), SI::Proxy::no_loops(), 300);
    const SI::Loops_on_proxy found(fine, {}, proxy);
    EXPECT_EQ(found.hierarchy().size_of_pants_decomposition(), 9);
    ASSERT_EQ(found.hierarchy().loops().size(), 9u);
    if (expected.empty())
      for (const SI::Loop_class& loop : found.hierarchy().loops())
        expected.push_back(loop.modulus);
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_NEAR(found.hierarchy().loops()[i].modulus, expected[i], 0.02 * expected[i]);
  }
}

// The tubes have about ten vertices around on the proxy, which makes moduli a percent or two too
// small.
TEST(Loops_on_proxy, are_measured_on_a_finer_one_where_tubes_are_thin)
{
  constexpr double length = 3;
  for (const double radius : {0.15, 0.2, 0.3})
    for (std::uint64_t seed = 1; seed <= 2; ++seed)
    {
      SCOPED_TRACE(radius);
      const auto [soup, ends] = soups::dumbbell(radius, length, 64);
      const std::vector<std::size_t> label = new_labels(soup.points.size(), seed);
      const SI::Flat_mesh fine = flat_mesh(soups::relabeled(soup, label, seed));
      std::vector<SI::Pole> poles;
      for (const std::size_t v : ends)
        poles.push_back({static_cast<int>(label[v])});
      const SI::Loops_on_proxy found(
        fine, poles, std::make_shared<const SI::Proxy>(fine, poles, SI::Proxy::no_loops(), 1000));
      ASSERT_EQ(found.hierarchy().loops().size(), 1u);
      EXPECT_TRUE(found.hierarchy().loops()[0].is_measured_again);
      EXPECT_NEAR(found.hierarchy().loops()[0].modulus / modulus_of_dumbbell(radius, length), 1,
                  0.008);
    }
}

// Asked for loops above some modulus only, one gets the same ones.
TEST(Loops_on_proxy, do_not_depend_on_the_least_modulus)
{
  const auto [soup, ends] = soups::dumbbell(0.2, 3, 64);
  const SI::Flat_mesh fine = flat_mesh(soup);
  std::vector<SI::Pole> poles;
  for (const std::size_t v : ends)
    poles.push_back({static_cast<int>(v)});
  for (std::size_t i = 0; i < 4; ++i) // more of them on the first sphere
    poles.push_back({static_cast<int>(ends[0] + 8 * (i < 2 ? i + 1 : i + 3))});
  const auto proxy = std::make_shared<const SI::Proxy>(fine, poles, SI::Proxy::no_loops(), 1000);
  const SI::Loops_on_proxy all(fine, poles, proxy);
  ASSERT_EQ(all.hierarchy().loops().size(), 5u);
  for (const double least : {0.3, 0.6, 1.})
  {
    const SI::Loops_on_proxy found(fine, poles, proxy, SI::poll_nobody, least);
    ASSERT_EQ(found.hierarchy().loops().size(), 5u);
    for (std::size_t i = 0; i < 5; ++i)
      if (const double modulus = all.hierarchy().loops()[i].modulus; modulus >= least)
        EXPECT_EQ(found.hierarchy().loops()[i].modulus, modulus);
      else
        EXPECT_LT(found.hierarchy().loops()[i].modulus, least);
  }
}

TEST(Loops_on_proxy, stay_on_it_if_it_is_fine_enough)
{
  const SI::Flat_mesh fine = flat_mesh(soups::torus(60, 40, 3, 1.5));
  const auto proxy =
    std::make_shared<const SI::Proxy>(fine, std::vector<SI::Pole>(), SI::Proxy::no_loops(), 1500);
  const SI::Loops_on_proxy found(fine, {}, proxy);
  ASSERT_EQ(found.hierarchy().loops().size(), 1u);
  EXPECT_FALSE(found.hierarchy().loops()[0].is_measured_again);
}

} // namespace test_proxy
