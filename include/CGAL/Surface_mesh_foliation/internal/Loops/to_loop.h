// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LOOPS_TO_LOOP_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LOOPS_TO_LOOP_H

#include <CGAL/Surface_mesh_foliation/internal/Loops/Flat_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/Loop.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Mesh_index.h>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// a loop with the halfedges of the mesh
template <class TriangleMesh>
Loop<TriangleMesh> to_loop(const Flat_loop& flat, const Mesh_index<TriangleMesh>& mesh_index)
{
  Loop<TriangleMesh> result;
  for (const Flat_crossing& crossing : flat.crossings)
    result.push_back({mesh_index.halfedge_descriptor_of(crossing.halfedge), crossing.position});
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LOOPS_TO_LOOP_H
