// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_VERTEX_FARTHEST_FROM_CENTROID_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_VERTEX_FARTHEST_FROM_CENTROID_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Surface_mesh_copy.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// A choice of one vertex that depends, up to rounding, only on the shape: the one farthest from the
// centroid of the surface; the first if there are several.
inline int vertex_farthest_from_centroid(const Flat_mesh& mesh)
{
  const std::vector<Point> points = points_of_unit_size(mesh);
  Eigen::Vector3d sum(0, 0, 0);
  double area = 0; // twice
  for (int f = 0; f < mesh.number_of_faces(); ++f)
  {
    const std::array<int, 3> h = mesh.halfedges(f);
    const Point &a = points[mesh.source(h[0])], &b = points[mesh.source(h[1])],
                &c = points[mesh.source(h[2])];
    const Eigen::Vector3d normal = difference(b, a).cross(difference(c, a));
    // z first: another order rounds otherwise, and may choose another of vertices that are tied
    const double weight = norm({normal.z(), normal.x(), normal.y()});
    area += weight;
    sum += weight * (to_vector(a) + to_vector(b) + to_vector(c)) / 3;
  }
  int result = 0;
  double largest = -1;
  for (int v = 0; v < mesh.number_of_vertices(); ++v)
  {
    const double distance = norm(to_vector(points[v]) - sum / area);
    if (distance > largest)
    {
      largest = distance;
      result = v;
    }
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_VERTEX_FARTHEST_FROM_CENTROID_H
