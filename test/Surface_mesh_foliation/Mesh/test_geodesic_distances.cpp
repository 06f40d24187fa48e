// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances on surfaces, and the vertex where they are measured from when there is no pole.

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Geodesic_distances.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/vertex_farthest_from_centroid.h>

#include "include/flat_meshes.h"
#include "generators/genus_soups.h"
#include "generators/meshes.h"
#include "generators/soups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace test_geodesic_distances {

namespace {

namespace internal = CGAL::Surface_mesh_foliation::internal;
namespace soups = smf_test::soups;

TEST(Geodesic_distances, are_near_to_those_on_a_sphere)
{
  const auto soup = soups::icosphere(4);
  const internal::Flat_mesh mesh = smf_test::flat_mesh(soup);
  const std::vector<int> sources = {5, 100};
  const auto distances = internal::Geodesic_distances(mesh, sources).distances();
  double largest = 0;
  for (std::size_t v = 0; v < distances.size(); ++v)
  {
    double angle = 10;
    for (int s : sources)
      angle =
        std::min(angle, std::acos(std::clamp(soups::dot(soup.points[v], mesh.point(s)), -1., 1.)));
    largest = std::max(largest, std::abs(distances[v] - angle));
  }
  EXPECT_LT(largest, 0.02); // along edges only, it would be 0.2
  EXPECT_EQ(distances[5], 0);
}

TEST(Geodesic_distances, do_not_depend_on_the_order_even_by_rounding)
{
  const auto soup = soups::noisy(soups::genus_surface(3, 3), 0.1, 1);
  const auto distances = internal::Geodesic_distances(smf_test::flat_mesh(soup), {7}).distances();
  const auto new_label = smf_test::new_labels(soup.points.size(), 5);
  const auto others =
    internal::Geodesic_distances(smf_test::flat_mesh(soups::relabeled(soup, new_label, 6)),
                                 {static_cast<int>(new_label[7])})
      .distances();
  for (std::size_t v = 0; v < distances.size(); ++v)
    EXPECT_EQ(distances[v], others[new_label[v]]);
}

TEST(Vertex_farthest_from_centroid, is_a_tip_wherever_the_surface_lies)
{
  for (const double offset : {0., 1e3})
  {
    auto soup = soups::icosphere(2);
    soup.points[17] = soups::scaled(soup.points[17], 1.5);
    for (auto& p : soup.points)
      p = {1e-200 * (p[0] + offset), 1e-200 * (p[1] - offset), 1e-200 * p[2]};
    EXPECT_EQ(internal::vertex_farthest_from_centroid(smf_test::flat_mesh(soup)), 17);
  }
}

} // namespace

} // namespace test_geodesic_distances
