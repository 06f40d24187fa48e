// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How much a vertex stands out of a surface, by the modulus of the annuli around it.

#include "generators/meshes.h"
#include "generators/revolution.h"
#include "include/flat_meshes.h"

#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Pole_significance.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Proxy.h>
#include <CGAL/Surface_mesh_foliation/internal/Features/tip_near_cluster.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace test_pole_significance {

namespace {

namespace SI = CGAL::Surface_mesh_foliation::internal;
using namespace smf_test;
constexpr double pi = 3.14159265358979323846;

// of the tip of a capsule with two poles at its other end
double significance_of_tip(double length, std::size_t n)
{
  const auto [soup, ends] = soups::capsule(length, n);
  const SI::Flat_mesh mesh = flat_mesh(soup);
  const int tip = mesh.number_of_vertices() - 2;
  SI::Pole_significance significance(mesh, {});
  return significance(tip, {static_cast<int>(ends[2]), static_cast<int>(ends[3])});
}

} // namespace

// A limb gains its length divided by its circumference, less the logarithm of the area gained.
TEST(Pole_significance, grows_with_the_length_of_a_limb)
{
  const double expected = 3 / (2 * pi) - std::log(16. / 10) / (4 * pi);
  for (const std::size_t n : {36, 72})
    EXPECT_NEAR(significance_of_tip(6, n) - significance_of_tip(3, n), expected, 0.04)
      << n; // the disk has few vertices
  EXPECT_NEAR(significance_of_tip(3, 36), significance_of_tip(3, 72), 0.05);
}

TEST(Pole_significance, is_about_zero_on_the_side_of_a_limb_and_negative_beside_a_pole)
{
  constexpr std::size_t n = 40;
  const auto [soup, ends] = soups::capsule(6, n);
  const SI::Flat_mesh mesh = flat_mesh(soup);
  const int first = mesh.number_of_vertices() - 2, last = first + 1;
  const int side = first / 2 / static_cast<int>(n) * static_cast<int>(n);
  SI::Pole_significance significance(mesh, {});
  EXPECT_GT(significance(first, {last, side}), 0.3);
  EXPECT_LT(significance(side, {first, last}), 0.1);
  EXPECT_LT(significance(0, {first, last}), 0); // in the first circle around a tip
}

TEST(Pole_significance, is_infinite_where_a_foliation_needs_the_pole)
{
  const SI::Flat_mesh sphere = flat_mesh(soups::icosphere(3));
  SI::Pole_significance of_sphere(sphere, {});
  EXPECT_EQ(of_sphere(0, {}), std::numeric_limits<double>::infinity());
  EXPECT_EQ(of_sphere(0, {1}), std::numeric_limits<double>::infinity());
  EXPECT_LT(of_sphere(0, {1, 2}), 1);
  const SI::Flat_mesh torus = flat_mesh(soups::torus(80, 40, 3, 1));
  SI::Pole_significance of_torus(torus, {});
  EXPECT_LT(of_torus(0, {}), 0.1);
}

// whether bounds decide or the modulus itself
TEST(Pole_significance, is_at_least_what_it_is)
{
  for (const Triangle_soup& soup :
       {soups::limbed_sphere(5, 4), soups::capsule(6, 40).first, soups::torus(60, 30, 3, 1)})
  {
    const SI::Flat_mesh mesh = flat_mesh(soup);
    SI::Pole_significance significance(mesh, {});
    std::vector<int> others;
    for (int vertex = 0; others.size() < 6; vertex += mesh.number_of_vertices() / 6)
    {
      const double value = significance(vertex, others);
      if (std::isfinite(value))
        for (const double difference : {-0.8, -0.2, -0.05, -0.01, 0.01, 0.05, 0.2, 0.8})
          EXPECT_EQ(significance.is_at_least(value - difference, vertex, others), difference > 0)
            << value << " beside " << others.size();
      else
        EXPECT_TRUE(significance.is_at_least(1e9, vertex, others));
      others.push_back(vertex);
    }
  }
}

// whatever the coarser mesh is
TEST(Tip_near_cluster, is_the_tip_of_the_limb)
{
  constexpr std::size_t limbs = 5;
  const SI::Flat_mesh fine = flat_mesh(soups::limbed_sphere(limbs, 5));
  for (const int goal : {2000, 4000})
  {
    const SI::Proxy proxy(fine, {}, {}, goal);
    const SI::Tip_near_cluster tip_near(fine, proxy.clusters());
    for (const std::size_t tip : soups::limb_tips(limbs, 5))
    {
      const int v = static_cast<int>(tip);
      EXPECT_EQ(tip_near(proxy.clusters()[v]), v);
    }
  }
}

} // namespace test_pole_significance
