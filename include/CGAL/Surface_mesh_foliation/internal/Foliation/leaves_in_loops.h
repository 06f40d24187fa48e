// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_LEAVES_IN_LOOPS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_LEAVES_IN_LOOPS_H

#include <CGAL/Surface_mesh_foliation/internal/Foliation/Tree_map.h>
#include <CGAL/Surface_mesh_foliation/internal/Homotopy/Deck_cocycle.h>
#include <CGAL/Surface_mesh_foliation/internal/Homotopy/Lifts.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/Flat_loop_system.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// the lifts met at the crossings of loop `a`, each in the frame of its edge
inline std::vector<int> lifts_along_loop(const Flat_loop_system& system,
                                         const Deck_cocycle& deck,
                                         int a,
                                         Lifts& lifts)
{
  const std::vector<Flat_crossing>& crossings = system.loops[a].crossings;
  const Surface_group& group = deck.group();
  Group_word translation;
  for (const Flat_crossing& crossing : crossings)
    translation = group.product(translation, deck.element(crossing.halfedge));
  if (group.is_abelian())
  {
    lifts.set_torus_loop(translation);
    translation.clear();
  }
  std::vector<int> result;
  Group_word way;
  for (const Flat_crossing& crossing : crossings)
  {
    const int h = crossing.halfedge;
    const Group_word next = group.product(way, deck.element(h));
    result.push_back(lifts.intern(a, lifts.transported(translation, is_forward(h) ? way : next)));
    way = next;
  }
  return result;
}

// A loop that was pushed off a walk with a chord may cross an edge back and forth; its word is then
// not reduced.
inline void append_reduced(Tree_paths& paths, int e, Letter letter)
{
  if (paths.size(e) > 0 && paths.back(e) == letter)
    paths.pop_back(e);
  else
    paths.push_back(e, letter);
}

// The foliation whose leaves all lie in the loops [3.2, Initialization]: every vertex is at the
// node of its region, and a crossing of loop l is a passage of the lift of l that the walk along l
// has reached there, whose name is P^-1 l P in the frame reached by the part P of the walk.
inline Tree_map leaves_in_loops(const Flat_loop_system& system,
                                const Deck_cocycle& deck,
                                Lifts& lifts)
{
  Tree_map result;
  for (int node : system.node_of_vertex)
    result.cell.push_back(Cell::at_node(node));
  result.t.assign(system.mesh.number_of_vertices(), 0);
  result.orientation.assign(system.mesh.number_of_vertices(), 1);
  result.paths = Tree_paths(system.mesh.number_of_edges());
  std::vector<std::vector<int>> lift_of_crossing;
  lift_of_crossing.reserve(system.loops.size());
  for (int a = 0; a < system.number_of_arcs(); ++a)
    lift_of_crossing.push_back(lifts_along_loop(system, deck, a, lifts));
  for (int e = 0; e < system.mesh.number_of_edges(); ++e)
    for (int i = 0; i < system.crossings.size(e); ++i)
    {
      // a walk to the target of the crossed halfedge meets the loop from its right side
      const Edge_crossings::Entry& entry = system.crossings.entry(e, i);
      const int lift = lift_of_crossing[entry.loop][entry.index];
      const Letter first(lift, is_forward(entry.halfedge) ? 1 : 0);
      append_reduced(result.paths, e, first);
      append_reduced(result.paths, e, first.other_end());
    }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_LEAVES_IN_LOOPS_H
