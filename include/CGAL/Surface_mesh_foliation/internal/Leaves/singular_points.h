// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_SINGULAR_POINTS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_SINGULAR_POINTS_H

#include <CGAL/Surface_mesh_foliation/internal/Leaves/Extraction.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The positions of the singular places of a certified foliation: those of vertices are where the
// vertices are, those of faces are the centers of their tripods. The centers are the last points of
// the refined mesh, in the order of the faces, as are the singular places.
inline std::vector<Point> singular_points(const Extraction& extraction)
{
  const std::vector<Point>& points = extraction.refined_mesh.points;
  int center = extraction.refined_mesh.first_center;
  std::vector<Point> result;
  for (const Singular_place& place : extraction.singular_places)
    result.push_back(points[place.is_face ? center++ : place.place]);
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_SINGULAR_POINTS_H
