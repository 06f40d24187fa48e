// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_ESSENTIAL_LEAF_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_ESSENTIAL_LEAF_H

#include <CGAL/Surface_mesh_foliation/internal/Foliation/lengths.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/Level_tracer.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// the deck translation of a closed leaf, seen from the face that it starts in
inline Group_word translation_of(const Foliation_state& state,
                                 const std::vector<Leaf_crossing>& leaf)
{
  Group_word result;
  for (const Leaf_crossing& crossing : leaf)
    result = state.deck().group().product(result, state.deck().element(crossing.halfedge));
  return result;
}

// calls visit(leaf) for each of the closed curves that pass the given crossings of one level
template <class Visit>
void for_each_leaf(const Foliation_state& state,
                   const std::vector<Leaf_crossing>& crossings,
                   double level,
                   const Visit& visit)
{
  const Level_tracer tracer(state);
  std::set<std::pair<int, int>> is_traced; // edge and cell, along the forward halfedge
  for (const Leaf_crossing& start : crossings)
  {
    if (is_traced.count({edge_of(start.halfedge), start.cell}) > 0)
      continue;
    const std::vector<Leaf_crossing> leaf = tracer.trace(start, level);
    for (const auto& [h, cell] : leaf)
      is_traced.insert({edge_of(h), is_forward(h) ? cell : state.word_size(edge_of(h)) - cell});
    visit(leaf);
  }
}

// All places, on forward halfedges, where the leaves of an arc at a level cross edges.
inline std::vector<Leaf_crossing> crossings_of_level(const Foliation_state& state,
                                                     int arc,
                                                     double level)
{
  std::vector<Leaf_crossing> result;
  std::vector<double> levels(state.system().number_of_arcs(), -1);
  levels[arc] = level;
  const Level_tracer tracer(state);
  for (int e = 0; e < state.mesh().number_of_edges(); ++e)
    tracer.for_each_crossing(e, levels, [&](int a, int cell) {
      if (a == arc)
        result.push_back({halfedge_of(e), cell});
    });
  return result;
}

// The leaf of an arc at a level: the curve that runs around. (Where the foliation is flat up to
// rounding, there may also be null-homotopic curves.)
inline std::vector<Leaf_crossing> essential_leaf(const Foliation_state& state,
                                                 int arc,
                                                 double level)
{
  std::vector<Leaf_crossing> result;
  for_each_leaf(state, crossings_of_level(state, arc, level), level,
                [&](const std::vector<Leaf_crossing>& leaf) {
                  if (!state.deck().group().are_equal(translation_of(state, leaf), {}))
                    result = leaf;
                });
  return result;
}

// where a leaf crosses its halfedge
inline Point point_of_crossing(const Foliation_state& state,
                               const Leaf_crossing& crossing,
                               double level)
{
  const int h = crossing.halfedge;
  const Point &p = state.mesh().point(state.mesh().source(h)),
              &q = state.mesh().point(state.mesh().target(h));
  const double length = length_of_edge(state, edge_of(h));
  const double way = length_up_to(state, h, crossing.cell, level);
  const double share = length > 0 ? std::clamp(way / length, 0., 1.) : 0.5;
  return between(p, q, share);
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_ESSENTIAL_LEAF_H
