// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_ALL_VERTICES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_ALL_VERTICES_H

#include <boost/graph/graph_traits.hpp>

#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// the vertices that the numbers in a loops file mean by default
template <class TriangleMesh>
std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> all_vertices(
  const TriangleMesh& mesh)
{
  return {vertices(mesh).begin(), vertices(mesh).end()};
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_ALL_VERTICES_H
