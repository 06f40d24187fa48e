// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_LEVEL_TRACER_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_LEVEL_TRACER_H

#include <CGAL/Surface_mesh_foliation/internal/Foliation/Tripod.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// A crossing of a regular leaf: over halfedge `halfedge`, from its face to the opposite one, in the
// given cell of its image.
struct Leaf_crossing
{
  int halfedge;
  int cell;
};

// The leaf of an arc at a level. All decisions are combinatorial: a vertex whose parameter is at
// least the level counts as above it.
class Level_tracer
{
public:
  explicit Level_tracer(const Foliation_state& state) : m_state(state) {}

  // calls visit(arc, cell) for each cell of the image of edge e that its arc's level crosses
  template <class Levels, class Visit>
  void for_each_crossing(int e, const Levels& level, const Visit& visit) const
  {
    const int h = halfedge_of(e);
    for (int cell = 0; cell <= m_state.word_size(e); ++cell)
      if (is_cell_arc(m_state, h, cell))
      {
        const int arc = arc_of_cell(m_state, h, cell);
        if (is_above_before(h, cell, level[arc]) != is_above_after(h, cell, level[arc]))
          visit(arc, cell);
      }
  }

  // Whether the image of halfedge h comes from below the level to above it in an arc cell. A leaf
  // that crosses such a halfedge, from its face to the opposite one, has the higher side to its
  // left.
  bool is_crossed_upwards(int h, int cell, double level) const
  {
    return !is_above_before(h, cell, level) && is_above_after(h, cell, level);
  }

  // the closed leaf through a crossing
  std::vector<Leaf_crossing> trace(const Leaf_crossing& start, double level) const
  {
    std::vector<Leaf_crossing> result;
    Leaf_crossing crossing = start;
    do
    {
      result.push_back(crossing);
      crossing = next(crossing, level);
    } while (crossing.halfedge != start.halfedge || crossing.cell != start.cell);
    return result;
  }

private:
  bool is_above(int v, double level) const { return m_state.parameter(v) >= level; }

  // on which side of the level the image of h enters and leaves an arc cell
  bool is_above_before(int h, int cell, double level) const
  {
    return cell == 0 ? is_above(m_state.mesh().source(h), level)
                     : m_state.letter(h, cell - 1).end() == 1;
  }
  bool is_above_after(int h, int cell, double level) const
  {
    return cell == m_state.word_size(edge_of(h)) ? is_above(m_state.mesh().target(h), level)
                                                 : m_state.letter(h, cell).end() == 1;
  }

  // The leaf enters the face across crossing.halfedge, and leaves it across one of its other edges:
  // around the corner on whose leg it crosses, or, in the center cell, over the edge whose ends lie
  // on different sides.
  Leaf_crossing next(const Leaf_crossing& crossing, double level) const
  {
    const int g = opposite_of(crossing.halfedge);
    const int size = m_state.word_size(edge_of(g));
    const int cell = size - crossing.cell; // from source(g)
    const int before = m_state.mesh().prev(g), after = m_state.mesh().next(g);
    const int leg = leg_at_source(m_state, g);
    const bool is_around_source =
      cell < leg || (cell == leg && is_apex_with_target(g, cell, leg, level));
    return is_around_source ? Leaf_crossing{before, m_state.word_size(edge_of(before)) - cell}
                            : Leaf_crossing{after, size - cell};
  }

  // In the center cell: whether the apex of face(g) lies on the same side of the level as
  // target(g).
  bool is_apex_with_target(int g, int cell, int leg, double level) const
  {
    const int after = m_state.mesh().next(g);
    // the leg of target(g) in the word of `after`, which leads to the apex
    const int center = m_state.word_size(edge_of(g)) - leg;
    return is_above_after(after, center, level) == is_above_after(g, cell, level);
  }

  const Foliation_state& m_state;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_LEVEL_TRACER_H
