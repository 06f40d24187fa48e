// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_LEAF_INTERVALS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_LEAF_INTERVALS_H

#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Edge_values/Critical_leaf_tracer.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The pieces into which critical leaves cut the edges. Interval k of an edge, counted along its
// forward halfedge, lies between crossings k - 1 and k. Intervals are numbered; flat edges have
// none.
//
// In a regular face with corners lo, middle and hi, in the order of their levels, the leaves around
// lo cross the sides lo-middle and lo-hi, in the same order from lo, and likewise around hi; at
// most one leaf runs from the middle to the side lo-hi.
class Leaf_intervals
{
public:
  static constexpr int NONE = -1;

  // An interval on its edge, counted from the source of a halfedge.
  struct Seen_interval
  {
    int halfedge;
    int position;
  };

  // Throws if the crossings of a face do not match.
  Leaf_intervals(const Edge_value_surface& surface, const Critical_leaf_tracer& leaves)
    : m_surface(surface), m_leaves(leaves), m_first(surface.mesh().number_of_edges() + 1, 0)
  {
    for (int e = 0; e < mesh().number_of_edges(); ++e)
      m_first[e + 1] = m_first[e] + (surface.is_flat(e) ? 0 : number_of_crossings(e) + 1);
    m_edge.resize(m_first.back());
    for (int e = 0; e < mesh().number_of_edges(); ++e)
      for (int i = m_first[e]; i < m_first[e + 1]; ++i)
        m_edge[i] = e;
    for (int f = 0; f < mesh().number_of_faces(); ++f)
      check_face(f);
  }

  int size() const { return m_first.back(); }
  int edge(int interval) const { return m_edge[interval]; }
  int number_on_edge(int e) const { return m_first[e + 1] - m_first[e]; }
  int number(const Seen_interval& seen) const
  {
    const int e = edge_of(seen.halfedge);
    return is_forward(seen.halfedge) ? m_first[e] + seen.position
                                     : m_first[e + 1] - 1 - seen.position;
  }
  Seen_interval seen_along(int h, int interval) const
  {
    const int e = edge_of(h);
    return {h, is_forward(h) ? interval - m_first[e] : m_first[e + 1] - 1 - interval};
  }
  Seen_interval reversed(const Seen_interval& seen) const
  {
    return {opposite_of(seen.halfedge), number_on_edge(edge_of(seen.halfedge)) - 1 - seen.position};
  }

  // the ways of both ends of an interval, along the forward halfedge
  std::array<double, 2> ways(int interval) const
  {
    const int e = m_edge[interval], k = interval - m_first[e];
    return {k == 0 ? 0 : m_leaves.crossings(e)[k - 1].way,
            k == number_of_crossings(e) ? m_surface.value(e) : m_leaves.crossings(e)[k].way};
  }
  // the leaf at the given end of an interval; NONE at a vertex
  int leaf_at_end(int interval, int end) const
  {
    const int e = m_edge[interval], k = interval - m_first[e] - 1 + end;
    return k < 0 || k >= number_of_crossings(e) ? NONE : m_leaves.crossings(e)[k].leaf;
  }

  // Calls visit(a, b) for each interval b that faces the given one, `a`, around a corner of a face.
  // Both are seen along halfedges that leave the corner.
  template <class Visit>
  void for_each_partner(int interval, const Visit& visit) const
  {
    for (int h : halfedges_of_edge(m_edge[interval]))
    {
      const Seen_interval seen = seen_along(h, interval), back = reversed(seen);
      const Seen_interval around_source = {opposite_of(mesh().prev(h)), seen.position};
      const Seen_interval around_target = {mesh().next(h), back.position};
      if (is_open(h) && around_source.position < number_on_edge(edge_of(around_source.halfedge)))
        visit(seen, around_source);
      if (!m_surface.is_flat(edge_of(mesh().next(h))) && is_open(mesh().next(h)) &&
          around_target.position < number_on_edge(edge_of(around_target.halfedge)))
        visit(back, around_target);
    }
  }

  // A leaf that comes across an interval continues into the face of the halfedge along which the
  // interval is seen here, and crosses another interval, which is returned as seen along a halfedge
  // of the face beyond. Only if the leaf may pass the middle vertex on either side does
  // is_beyond(interval) decide, called with the interval from lo or hi to the middle: it says
  // whether the level is outside that interval.
  template <class Is_beyond>
  Seen_interval next(const Seen_interval& seen, const Is_beyond& is_beyond) const
  {
    const int g = seen.halfedge, k = seen.position,
              closed = m_surface.closed_corner(mesh().face(g));
    const int next = mesh().next(g), prev = mesh().prev(g);
    const int k_from_target = number_on_edge(edge_of(g)) - 1 - k;
    const Seen_interval around_source = {opposite_of(prev), k};
    const Seen_interval around_target = reversed({next, k_from_target});
    if (closed == Edge_value_surface::NONE)
      return m_surface.is_flat(edge_of(next)) ? around_source : around_target;
    if (closed != prev)
      return closed == g ? around_target : around_source;
    const bool fits_source = k < number_on_edge(edge_of(prev));
    const bool fits_target = k_from_target < number_on_edge(edge_of(next));
    if (fits_source && fits_target)
      return is_beyond(around_source) ? around_target : around_source;
    return fits_source ? around_source : around_target;
  }

private:
  const Flat_mesh& mesh() const { return m_surface.mesh(); }
  int number_of_crossings(int e) const { return static_cast<int>(m_leaves.crossings(e).size()); }

  // the halfedge of a fan that leaves the corner opposite to its flat side
  int corner_of_fan(int f) const
  {
    int h = mesh().halfedge_of_face(f);
    while (!m_surface.is_flat(edge_of(mesh().next(h))))
      h = mesh().next(h);
    return h;
  }

  // whether leaves run around the corner that h leaves; precondition: h is not flat
  bool is_open(int h) const
  {
    const int closed = m_surface.closed_corner(mesh().face(h));
    return closed == Edge_value_surface::NONE ? !m_surface.is_flat(edge_of(mesh().prev(h)))
                                              : closed != h;
  }

  int leaf(int h, int k) const
  {
    const std::vector<Critical_leaf_tracer::Crossing>& crossings = m_leaves.crossings(edge_of(h));
    return crossings[is_forward(h) ? k : static_cast<int>(crossings.size()) - 1 - k].leaf;
  }

  void check_face(int f) const
  {
    const int closed = m_surface.closed_corner(f);
    bool is_good = true;
    if (closed != Edge_value_surface::NONE)
    {
      const int opposite = mesh().next(closed), before = mesh().prev(closed);
      is_good = number_of_crossings(edge_of(opposite)) == number_of_crossings(edge_of(closed)) +
                                                            number_of_crossings(edge_of(before)) +
                                                            (m_leaves.has_prong(f) ? 1 : 0) &&
                have_same_leaves(opposite, opposite_of(closed)) &&
                have_same_leaves(before, opposite_of(opposite));
    }
    else if (!m_surface.is_face_flat(f))
    {
      const int h = corner_of_fan(f), g = opposite_of(mesh().prev(h));
      is_good = number_on_edge(edge_of(h)) == number_on_edge(edge_of(g)) && have_same_leaves(h, g);
    }
    if (!is_good)
      throw Invalid_foliation_exception(
        problem(Problem_kind::UNRESOLVED_LEAF, "critical leaves cross in face ",
                m_surface.origin_of_face(f), ": they cannot be told apart at this tolerance")
          .faces({index(m_surface.origin_of_face(f))}));
  }

  // whether h and g, which leave the same vertex, are crossed by the same leaves as far as both
  // reach
  bool have_same_leaves(int h, int g) const
  {
    const int n = (std::min)(number_of_crossings(edge_of(h)), number_of_crossings(edge_of(g)));
    for (int k = 0; k < n; ++k)
      if (leaf(h, k) != leaf(g, k))
        return false;
    return true;
  }

  const Edge_value_surface& m_surface;
  const Critical_leaf_tracer& m_leaves;
  std::vector<int> m_first; // by edge: its first interval; and their number
  std::vector<int> m_edge;  // by interval
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_LEAF_INTERVALS_H
