// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_ENGINE_SKETCH_H
#define SMF_ENGINE_SKETCH_H

#include "types.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace smf_engine {

// Where the parts lie, nearly, when the solver has found its start; the same as in protocol.ts.
struct Sketch
{
  Indices part_labels; // the arc of each face of the mesh
  Indices ends;        // the nodes of each arc, two after two
};

using Show_sketch = std::function<void(const Sketch&)>;

// A face is in the arc that most of its vertices are in.
inline Sketch sketch_of(const System& system, const std::vector<std::size_t>& arcs_of_vertices)
{
  Sketch result;
  const Mesh& mesh = system.mesh();
  const std::size_t last = system.number_of_arcs() - 1;
  for (const auto f : mesh.faces())
  {
    std::array<std::size_t, 3> arcs{};
    std::size_t number = 0;
    for (const Vertex v : vertices_around_face(mesh.halfedge(f), mesh))
      arcs[number++] = arcs_of_vertices[v];
    std::sort(arcs.begin(), arcs.end()); // nodes come last
    result.part_labels.push_back(
      static_cast<Index>((std::min)(arcs[1] <= last ? arcs[1] : arcs[0], last)));
  }
  for (std::size_t arc = 0; arc <= last; ++arc)
    for (const int end : {0, 1})
      result.ends.push_back(static_cast<Index>(system.node(arc, end)));
  return result;
}

} // namespace smf_engine

#endif // SMF_ENGINE_SKETCH_H
