// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_GROW_FRONTS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_GROW_FRONTS_H

#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/forces.h>

#include <deque>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Lets the leaves spread from the loops over the mesh without regard to lengths: a vertex that sees
// exactly one direction from its node moves to the middle of that arc. Such a move is an isotopy of
// the leaves. First come, first served, so that fronts grow at equal speed; the vertices that stay
// at the nodes form a spine of each region.
inline void grow_fronts(Foliation_state& state)
{
  const Flat_mesh& mesh = state.mesh();
  std::deque<int> queue;
  std::vector<bool> is_queued(mesh.number_of_vertices(), false);
  const auto enqueue = [&](int v) {
    if (is_queued[v] || state.is_fixed(v) || !state.is_at_node(v))
      return;
    is_queued[v] = true;
    queue.push_back(v);
  };
  for (const Flat_loop& loop : state.system().loops)
    for (const Flat_crossing& crossing : loop.crossings)
    {
      enqueue(mesh.source(crossing.halfedge));
      enqueue(mesh.target(crossing.halfedge));
    }
  Directions directions;
  while (!queue.empty())
  {
    const int v = queue.front();
    queue.pop_front();
    is_queued[v] = false;
    find_directions(state, v, directions);
    if (directions.size() != 1)
      continue;
    const Letter letter = directions.letters[0];
    state.move_into_arc(v, letter, state.length_of_arc(letter) / 2);
    for (int h : mesh.ring(v))
      enqueue(mesh.target(h));
  }
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_GROW_FRONTS_H
