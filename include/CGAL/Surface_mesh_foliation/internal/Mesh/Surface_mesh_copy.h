// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_SURFACE_MESH_COPY_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_SURFACE_MESH_COPY_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// the mesh that CGAL's algorithms work on
using Surface_mesh_copy = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

// The points of the mesh moved to the origin and scaled to a size between 1 and 2, so that no
// product of coordinates overflows or vanishes.
inline std::vector<Point> points_of_unit_size(const Flat_mesh& mesh)
{
  const CGAL::Bbox_3 box = bounding_box(mesh.points());
  const int exponent = -std::ilogb(half_size(box));
  std::vector<Point> result = mesh.points();
  for (Point& p : result)
    for (int i : {0, 1, 2})
      p[i] = std::scalbn(p[i] / 2 - ((box.min)(i) / 4 + (box.max)(i) / 4), exponent);
  return result;
}

inline Surface_mesh_copy surface_mesh_copy(const Flat_mesh& mesh)
{
  Surface_mesh_copy result;
  result.reserve(static_cast<unsigned int>(mesh.number_of_vertices()),
                 static_cast<unsigned int>(mesh.number_of_edges()),
                 static_cast<unsigned int>(mesh.number_of_faces()));
  std::vector<Surface_mesh_copy::Vertex_index> vertices;
  for (const Point& p : points_of_unit_size(mesh))
    vertices.push_back(result.add_vertex({p[0], p[1], p[2]}));
  for (int f = 0; f < mesh.number_of_faces(); ++f)
  {
    const std::array<int, 3> h = mesh.halfedges(f);
    result.add_face(vertices[mesh.source(h[0])], vertices[mesh.source(h[1])],
                    vertices[mesh.source(h[2])]);
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_SURFACE_MESH_COPY_H
