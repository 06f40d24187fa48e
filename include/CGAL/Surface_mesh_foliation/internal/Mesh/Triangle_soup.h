// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_TRIANGLE_SOUP_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_TRIANGLE_SOUP_H

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationIO
\smfHeader{Mesh/Triangle_soup.h,IO/Triangle_soup.h}

stores the vertices and faces of a triangle mesh as a file gives them: in the order of the file,
with nothing renumbered, repaired or merged (but for corners at equal positions in STL files, see
`read_triangle_soup()`). It need not be a surface; `check_triangle_soup()` tells whether it is.
*/
struct Triangle_soup
{
  /// the coordinates of the vertices
  std::vector<std::array<double, 3>> points;

  /// the faces, each by the indices of its corners in `points`, counterclockwise seen from outside
  std::vector<std::array<std::size_t, 3>> triangles;
};

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_TRIANGLE_SOUP_H
