// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_POLYGON_SOUP_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_POLYGON_SOUP_H

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationIO
\smfHeader{Mesh/Polygon_soup.h,IO/polygon_soup.h}

stores the vertices and faces of a polygon mesh as a file gives them, in the order of the file. The
faces can have any number of corners, and need not fit together; `repair_polygon_soup()` makes them
a surface of triangles.
*/
struct Polygon_soup
{
  /// the coordinates of the vertices
  std::vector<std::array<double, 3>> points;

  /// the faces, each by the indices of its corners in `points`
  std::vector<std::vector<std::size_t>> polygons;
};

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_POLYGON_SOUP_H
