// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_ENGINE_ARRAYS_H
#define SMF_ENGINE_ARRAYS_H

#include "types.h"

#include <array>

namespace smf_engine {

// Meshes as arrays.

// The first corner of a face of a soup is the source of its halfedge.
inline std::array<Vertex, 3> corners_of(Face f, const Mesh& mesh)
{
  const Halfedge h = mesh.halfedge(f);
  return {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
}

inline Doubles positions_of(const Mesh& mesh)
{
  Doubles result;
  result.reserve(3 * mesh.number_of_vertices());
  for (const Vertex v : mesh.vertices())
    append(mesh.point(v), result);
  return result;
}

inline Indices triangles_of(const Mesh& mesh)
{
  Indices result;
  result.reserve(3 * mesh.number_of_faces());
  for (const Face f : mesh.faces())
    for (const Vertex v : corners_of(f, mesh))
      result.push_back(v);
  return result;
}

} // namespace smf_engine

#endif // SMF_ENGINE_ARRAYS_H
