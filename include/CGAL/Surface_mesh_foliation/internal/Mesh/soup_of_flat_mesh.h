// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_SOUP_OF_FLAT_MESH_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_SOUP_OF_FLAT_MESH_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Triangle_soup.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// without caps
inline Triangle_soup soup_of(const Flat_mesh& mesh)
{
  Triangle_soup result;
  result.points = mesh.points();
  result.points.resize(mesh.number_of_input_vertices());
  for (int f = 0; f < mesh.number_of_input_faces(); ++f)
  {
    const std::array<int, 3> h = mesh.halfedges(f);
    result.triangles.push_back({static_cast<std::size_t>(mesh.source(h[0])),
                                static_cast<std::size_t>(mesh.source(h[1])),
                                static_cast<std::size_t>(mesh.source(h[2]))});
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_SOUP_OF_FLAT_MESH_H
