// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_CARRIED_MAP_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_CARRIED_MAP_H

#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// whether two meshes have the same vertices, halfedges and faces, wherever their points are
inline bool have_same_connectivity(const Flat_mesh& a, const Flat_mesh& b)
{
  if (a.is_copy_of(b))
    return true;
  if (a.number_of_vertices() != b.number_of_vertices() ||
      a.number_of_halfedges() != b.number_of_halfedges())
    return false;
  for (int h = 0; h < a.number_of_halfedges(); ++h)
    if (a.target(h) != b.target(h) || a.next(h) != b.next(h))
      return false;
  return true;
}

// whether the loops of two systems on meshes with the same connectivity, except for one loop, cross
// the same edges in the same order
inline bool have_same_crossings(const Flat_loop_system& a, const Flat_loop_system& b, int except)
{
  if (a.loops.size() != b.loops.size())
    return false;
  for (int l = 0; l < a.number_of_arcs(); ++l)
  {
    const auto &x = a.loops[l].crossings, &y = b.loops[l].crossings;
    const auto are_same = [](const Flat_crossing& c, const Flat_crossing& d) {
      return c.halfedge == d.halfedge;
    };
    if (l != except && !std::equal(x.begin(), x.end(), y.begin(), y.end(), are_same))
      return false;
  }
  // disjoint loops that cross the same edges have the same order there unless they are parallel;
  // for parallel loops the order is compared
  const auto loops_of_edge = [&](const Flat_loop_system& system, int e) {
    std::vector<std::pair<int, int>> result; // with the number of the crossing
    for (int i = 0; i < system.crossings.size(e); ++i)
      if (const auto& entry = system.crossings.entry(e, i); entry.loop != except)
        result.emplace_back(entry.loop, entry.index);
    return result;
  };
  for (int e = 0; e < a.mesh.number_of_edges(); ++e)
    if (a.crossings.size(e) + b.crossings.size(e) > 0 && loops_of_edge(a, e) != loops_of_edge(b, e))
      return false;
  return true;
}

// whether two systems have the same poles and loops on the same mesh, whatever their heights
inline bool have_same_loops(const Flat_loop_system& a, const Flat_loop_system& b)
{
  constexpr int none = -1;
  return a.poles == b.poles && have_same_connectivity(a.mesh, b.mesh) &&
         have_same_crossings(a, b, none);
}

// The map of a state with the same loops but possibly other heights: parameters are stretched with
// their arcs. Both states have the same cocycle, so lifts are carried by their names.
inline Tree_map carried_map(const Foliation_state& from, const Foliation_state& to)
{
  std::vector<int> lift; // by lift of `from`, as they are met
  const auto carried = [&](int l) {
    if (l >= static_cast<int>(lift.size()))
      lift.resize(l + 1, -1);
    if (lift[l] < 0)
      lift[l] = to.lift(from.lifts().arc(l), from.lifts().name(l));
    return lift[l];
  };
  Tree_map result;
  result.orientation = from.map().orientation;
  result.paths = Tree_paths(from.mesh().number_of_edges());
  result.cell.reserve(from.mesh().number_of_vertices());
  result.t.reserve(from.mesh().number_of_vertices());
  for (int v = 0; v < from.mesh().number_of_vertices(); ++v)
  {
    if (from.is_at_node(v))
    {
      result.cell.push_back(from.map().cell[v]);
      result.t.push_back(0);
      continue;
    }
    const double height = to.system().height(from.arc(v));
    const double share = from.parameter(v) / from.system().height(from.arc(v));
    result.cell.push_back(Cell::arc(carried(from.map().cell[v].lift())));
    result.t.push_back(inner_parameter(share * height, height));
  }
  for (int e = 0; e < from.mesh().number_of_edges(); ++e)
    for (int i = 0; i < from.word_size(e); ++i)
    {
      const Letter letter = from.letter(halfedge_of(e), i);
      result.paths.push_back(e, Letter(carried(letter.lift()), letter.end()));
    }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_CARRIED_MAP_H
