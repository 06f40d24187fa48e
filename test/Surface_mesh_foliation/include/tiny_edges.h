// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_TINY_EDGES_H
#define SMF_TEST_TINY_EDGES_H

#include "generators/meshes.h"

#include <CGAL/boost/graph/Euler_operations.h>

namespace smf_test {

// Splits a halfedge, and the faces beside it, at a part of the way from its target to its source.
// Returns the new vertex.
inline Mesh::Vertex_index add_vertex_beside_target(Mesh& mesh, Mesh::Halfedge_index h, double part)
{
  const Mesh::Point a = mesh.point(target(h, mesh)), b = mesh.point(source(h, mesh));
  const auto to_new = CGAL::Euler::split_edge(h, mesh);
  mesh.point(target(to_new, mesh)) = {
    a.x() + part * (b.x() - a.x()), a.y() + part * (b.y() - a.y()), a.z() + part * (b.z() - a.z())};
  CGAL::Euler::split_face(to_new, next(next(to_new, mesh), mesh), mesh);
  const auto back = prev(opposite(to_new, mesh), mesh);
  CGAL::Euler::split_face(back, next(next(back, mesh), mesh), mesh);
  return target(to_new, mesh);
}

} // namespace smf_test

#endif // SMF_TEST_TINY_EDGES_H
