// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Weights on faces that are flat up to rounding. (Systems on meshes with such faces:
// test_random_systems.)

#include "generators/meshes.h"
#include "include/flat_faces.h"

#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/edge_weights.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/weights_of_flat_mesh.h>

#include <gtest/gtest.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace test_flat_faces {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
using namespace smf_test;

} // namespace

TEST(Flat_faces, have_weights_that_are_capped)
{
  Triangle_soup soup = soups::icosphere(3);
  soup.points[5][0] += 0.013; // so that the midpoint is rounded
  for (std::size_t face = 0; face < soup.triangles.size(); face += 97)
    add_flat_face(soup, face, 0.5, 1e-15);
  const Mesh mesh = to_mesh(soup);
  SMF::Poles_and_loops<Mesh> input;
  input.add_pole(Mesh::Vertex_index(0));
  input.add_pole(Mesh::Vertex_index(1));
  const SMF::Loop_system<Mesh> system(mesh, input);
  const SMF::internal::Flat_mesh& flat = system.data().flat.mesh;
  const std::vector<double> weights = SMF::internal::mean_value_weights(flat);
  double largest = 0; // sum of tangents
  for (int e = 0; e < flat.number_of_edges(); ++e)
  {
    EXPECT_GT(weights[e], 0);
    const int h = SMF::internal::halfedge_of(e);
    const double length = std::sqrt(CGAL::to_double(
      CGAL::squared_distance(mesh.point(vertex(SMF::internal::index(flat.source(h)))),
                             mesh.point(vertex(SMF::internal::index(flat.target(h)))))));
    largest = std::max(largest, 2 * weights[e] * length);
  }
  EXPECT_NEAR(largest, 1e5, 1e-6);
}

} // namespace test_flat_faces
