// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_VERTEX_AREAS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_VERTEX_AREAS_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/weights_of_flat_mesh.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// By vertex, the share of the area of the surface that belongs to it: a third of each of its faces.
// Caps have no area.
inline std::vector<double> vertex_areas(const Flat_mesh& mesh)
{
  std::vector<double> result(mesh.number_of_vertices(), 0);
  Corner_geometry corner(mesh);
  double total = 0;
  for (int f = 0; f < mesh.number_of_input_faces(); ++f)
  {
    double area = 0;
    for (int h : mesh.halfedges(f))
    {
      corner.visit(h);
      area = (std::max)(area, corner.area());
    }
    for (int h : mesh.halfedges(f))
      result[mesh.source(h)] += area / 3;
    total += area;
  }
  for (double& area : result)
    area /= total;
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_VERTEX_AREAS_H
