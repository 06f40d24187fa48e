// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_SETTLE_AT_NODES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_SETTLE_AT_NODES_H

#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Letter.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Singular_places.h>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// whether a vertex inside an arc differs from an end of it by rounding only, and no pole is there
inline bool is_beside_node(const Foliation_state& state, int v, Letter end_of_arc)
{
  const double t = state.parameter(v), length = state.length_of_arc(end_of_arc);
  return (end_of_arc.end() == 0 ? t : length - t) < negligible_length(state, state.arc(v)) &&
         state.system().nodes[state.node_of_letter(end_of_arc)].pole < 0;
}

// Parameters decay along a limb or a chain of handles, until they differ from those at a node by
// rounding only. There, vertices may come to lie in a wrong order, in folds without size. Moves all
// that are so close to a node to the node itself, where they have no order. Returns whether there
// are any.
inline bool settle_at_nodes(Foliation_state& state)
{
  bool is_changed = false;
  for (int v = 0; v < state.mesh().number_of_vertices(); ++v)
    for (const int end : {0, 1})
      if (state.is_free_in_arc(v) && is_beside_node(state, v, state.half_arc(v, end)))
      {
        state.move_to_node(v, state.half_arc(v, end));
        is_changed = true;
      }
  return is_changed;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_SETTLE_AT_NODES_H
