// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_FACE_LOCATION_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_FACE_LOCATION_H

#include <CGAL/Surface_mesh_foliation/internal/Foliation/lengths.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/Level_tracer.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Tripod.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Where the foliation sends a point of a face. In a face, leaves are straight, and those that cut
// off the same corner are parallel: the point at position lambda has the distance w_ij lambda_j +
// w_ik lambda_k from corner i in T, as far as the leg of the corner reaches. Points that no leg
// reaches, in the middle of a tripod saddle, lie at the center.
//
// Points of a vertex, edge or face that lies at a node are recognized without numbers.
class Face_location
{
public:
  // share: nonnegative, with sum 1, by corner of the flat mesh
  Face_location(const Foliation_state& state, int face, const std::array<double, 3>& share)
    : m_state(state), m_tripod(state, face), m_share(share)
  {
    if (!find_among_corners())
      find_by_distance();
  }

  bool is_arc() const { return m_is_arc; }
  int index() const { return m_index; }    // of the arc or node
  double level() const { return m_level; } // in an arc

  // A crossing of the curve through the point at the level of the point, with the higher side to
  // its left. None where the entire face is at that level. Precondition: is_arc()
  std::optional<Leaf_crossing> crossing() const
  {
    const Level_tracer tracer(m_state);
    const auto is_crossed = [&](const Leaf_crossing& c) {
      return tracer.is_crossed_upwards(c.halfedge, c.cell, m_level);
    };
    if (m_cell < m_tripod.leg(m_corner))
    {
      const int h = m_tripod.out(m_corner), g = opposite_of(m_tripod.other_out(m_corner));
      for (const Leaf_crossing& c :
           {Leaf_crossing{h, m_cell}, Leaf_crossing{g, m_state.word_size(edge_of(g)) - m_cell}})
        if (is_crossed(c))
          return c;
      return crossing_below(m_state, m_tripod.corner(m_corner));
    }
    for (int i : {0, 1, 2})
      if (const Leaf_crossing c{m_tripod.out(i), m_tripod.leg(i)}; is_crossed(c))
        return c;
    const int corner = corner_at_level();
    return corner < 0 ? std::nullopt : crossing_below(m_state, m_tripod.corner(corner));
  }

  // The same for a vertex in an arc: over the first edge that comes from below. None at a minimum,
  // which exists only because of rounding.
  static std::optional<Leaf_crossing> crossing_below(const Foliation_state& state, int v)
  {
    const Level_tracer tracer(state);
    for (int h : state.mesh().ring(v))
      if (const Leaf_crossing c{opposite_of(h), state.word_size(edge_of(h))};
          tracer.is_crossed_upwards(c.halfedge, c.cell, state.parameter(v)))
        return c;
    return std::nullopt;
  }

private:
  void set_node(int node)
  {
    m_is_arc = false;
    m_index = node;
    m_level = 0;
  }

  // Rounding may have put a level onto or beyond an end of the arc.
  void set_arc(int corner, int cell, double level)
  {
    const int arc = arc_of_cell(m_state, m_tripod.out(corner), cell);
    const double height = m_state.system().height(arc);
    if (!(level > 0 && level < height))
      return set_node(m_state.system().node_of_end(arc, level > 0 ? 1 : 0));
    m_is_arc = true;
    m_index = arc;
    m_level = level;
    m_corner = corner;
    m_cell = cell;
  }

  // whether the point is a corner, or all corners that it lies between are at one node
  bool find_among_corners()
  {
    std::array<int, 3> support;
    int n = 0;
    for (int i : {0, 1, 2})
      if (m_share[i] > 0)
        support[n++] = i;
    const int v = m_tripod.corner(support[0]);
    if (n == 1 && !m_state.is_at_node(v))
    {
      set_arc(support[0], 0, m_state.parameter(v));
      return true;
    }
    for (int k = 0; k < n; ++k)
      if (!m_state.is_at_node(m_tripod.corner(support[k])) ||
          (k > 0 && distance_of_corners(support[0], support[k]) > 0))
        return false;
    set_node(m_state.node(v));
    return true;
  }

  // in letters
  int distance_of_corners(int i, int j) const
  {
    return m_state.word_size(edge_of(j == (i + 1) % 3 ? m_tripod.out(i) : m_tripod.other_out(i)));
  }

  // of the corner whose leg reaches farthest beyond the point
  void find_by_distance()
  {
    int nearest = 0;
    double distance = 0, farthest = 0;
    for (int i : {0, 1, 2})
    {
      const double depth =
        length_of_edge(m_state, edge_of(m_tripod.out(i))) * m_share[(i + 1) % 3] +
        length_of_edge(m_state, edge_of(m_tripod.other_out(i))) * m_share[(i + 2) % 3];
      const double beyond = reach(i) - depth;
      if (i == 0 || beyond > farthest)
      {
        nearest = i;
        farthest = beyond;
        distance = depth;
      }
    }
    if (farthest > 0)
      walk(nearest, distance);
    else if (m_tripod.is_center_arc())
      set_arc(0, m_tripod.leg(0), level_of_center());
    else
      set_node(m_tripod.node_of_center());
  }

  // the length of the leg of corner i; in an arc, the center is the middle one of three levels
  double reach(int i) const
  {
    return m_tripod.is_center_arc()
             ? length_up_to(m_state, m_tripod.out(i), m_tripod.leg(i), level_of_center())
             : m_tripod.length_of_leg(i);
  }

  double level_of_center() const
  {
    std::array<double, 3> level;
    for (int i : {0, 1, 2})
      level[i] = m_tripod.leg(i) == 0
                   ? m_state.parameter(m_tripod.corner(i))
                   : parameter_of_passage(m_state, m_tripod.out(i), m_tripod.leg(i) - 1);
    std::sort(level.begin(), level.end());
    return level[1];
  }

  // goes a distance along the leg of corner i
  void walk(int i, double distance)
  {
    const int h = m_tripod.out(i), leg = m_tripod.leg(i);
    for (int cell = m_state.is_at_node(m_tripod.corner(i)) ? 1 : 0; cell <= leg; cell += 2)
    {
      const double from = cell == 0 ? m_state.parameter(m_tripod.corner(i))
                                    : parameter_of_passage(m_state, h, cell - 1);
      const double to = cell < leg ? parameter_of_passage(m_state, h, cell) : level_of_center();
      const double length = std::abs(to - from);
      if (distance < length || cell == leg)
        return set_arc(i, cell,
                       length > 0 ? from + (to - from) * (std::min)(distance / length, 1.) : from);
      distance -= length;
      if (!(distance > 0))
        return set_node(node_of_cell(m_state, h, cell + 1));
    }
    set_node(m_tripod.node_of_center());
  }

  // The corner at which the curve touches the face: the point itself, an end of its edge if the
  // edge is level, or, because of rounding, a corner near the point. -1 in the middle of a level
  // face.
  int corner_at_level() const
  {
    int result = -1, number = 0, between = 0;
    for (int i : {0, 1, 2})
    {
      between += m_share[i] > 0;
      if (m_tripod.leg(i) > 0 || m_state.parameter(m_tripod.corner(i)) != m_level)
        continue;
      ++number;
      if (result < 0 || (m_share[i] > 0 && !(m_share[result] > 0)))
        result = i;
    }
    return number == 3 && between == 3 ? -1 : result;
  }

  const Foliation_state& m_state;
  Tripod m_tripod;
  std::array<double, 3> m_share;
  bool m_is_arc = false;
  int m_index = 0;
  double m_level = 0;
  int m_corner = 0,
      m_cell = 0; // the cell, seen along the leg of the corner; the last is the center
};

} // namespace internal

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_FACE_LOCATION_H
