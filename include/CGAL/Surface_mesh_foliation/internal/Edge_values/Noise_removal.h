// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_NOISE_REMOVAL_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_NOISE_REMOVAL_H

#include <CGAL/Surface_mesh_foliation/internal/Common/Disjoint_sets.h>
#include <CGAL/Surface_mesh_foliation/internal/Edge_values/Edge_value_surface.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Flattens the edges with value zero, and as few of those with values that may be noise as it takes
// to have no accidental pole. (A value that is tiny compared with its neighbors counts as zero: it
// is that of an edge along a leaf.)
//
// Where a foliation is constant up to rounding, on a limb without a pole, the signs of its
// differences are noise, and so are the singularities. The sum of the indices is fixed, so once no
// accidental pole is left, no saddle that goes with one is left either. A vertex or cluster of
// positive index absorbs its nearest neighbor: the edge between them is made flat, as long as its
// value can be noise. At an intended pole no value is that small.
//
// A flat side makes its triangle a fan, with two exceptions:
//  - the third side of a triangle with two flat ones is flat;
//  - so are all sides if the longest is, since the opposite vertex may lie between its ends.
class Noise_removal
{
public:
  explicit Noise_removal(Edge_value_surface& surface)
    : m_surface(surface),
      m_sets(static_cast<std::size_t>(surface.mesh().number_of_vertices())),
      m_index(surface.mesh().number_of_vertices(), 2),
      m_spokes(surface.mesh().number_of_vertices())
  {
    for (int f = 0; f < mesh().number_of_faces(); ++f)
      --m_index[mesh().source(surface.closed_corner(f))];
    for (int e = 0; e < mesh().number_of_edges(); ++e)
      if (is_zero(e))
        flatten(e);
    for (int v = 0; v < mesh().number_of_vertices(); ++v)
      if (place(v) == v)
        remove_pole(v);
  }

private:
  using Spoke = std::pair<double, int>; // its value, and its edge

  const Flat_mesh& mesh() const { return m_surface.mesh(); }
  bool is_zero(int e) const
  {
    const auto is_steep = [&](int h) {
      return (std::max)(m_surface.value(edge_of(mesh().next(h))),
                        m_surface.value(edge_of(mesh().prev(h)))) > m_surface.tolerances().snap();
    };
    return m_surface.value(e) <= 0 ||
           (m_surface.value(e) <= m_surface.tolerances().zero() &&
            (is_steep(halfedge_of(e)) || is_steep(opposite_of(halfedge_of(e)))));
  }

  // a place is identified by one of its vertices
  int place(int v) { return static_cast<int>(m_sets.find_set(static_cast<std::size_t>(v))); }

  void remove_pole(int v)
  {
    while (m_index[place(v)] > 0)
    {
      const int e = shortest_spoke(place(v));
      if (e < 0 || m_surface.value(e) > m_surface.tolerances().noise())
        return;
      flatten(e);
    }
  }

  // the edge with the least value from a place to another; -1 if there is none
  int shortest_spoke(int place)
  {
    std::vector<Spoke>& spokes = spokes_of(place);
    while (!spokes.empty())
    {
      const int e = spokes.front().second;
      if (!m_surface.is_flat(e) &&
          this->place(mesh().source(halfedge_of(e))) != this->place(mesh().target(halfedge_of(e))))
        return e;
      std::pop_heap(spokes.begin(), spokes.end(), std::greater<Spoke>());
      spokes.pop_back();
    }
    return -1;
  }

  // The spokes of a place, as a heap with the shortest first. Those of a single vertex are listed
  // when they are first asked for.
  std::vector<Spoke>& spokes_of(int place)
  {
    std::vector<Spoke>& spokes = m_spokes[place];
    if (spokes.empty())
    {
      for (int h : mesh().ring(place))
        spokes.emplace_back(m_surface.value(edge_of(h)), edge_of(h));
      std::make_heap(spokes.begin(), spokes.end(), std::greater<Spoke>());
    }
    return spokes;
  }

  void flatten(int first)
  {
    std::vector<int> stack = {first};
    while (!stack.empty())
    {
      const int e = stack.back();
      stack.pop_back();
      if (m_surface.is_flat(e))
        continue;
      const double value = m_surface.value(e);
      for (int h : halfedges_of_edge(e))
        if (m_surface.closed_corner(mesh().face(h)) != Edge_value_surface::NONE)
          ++m_index[place(mesh().source(m_surface.closed_corner(mesh().face(h))))];
      m_surface.flatten(e);
      const int joined = join(mesh().source(halfedge_of(e)), mesh().target(halfedge_of(e)));
      m_index[joined] -= 2;
      for (int h : halfedges_of_edge(e))
      {
        const int a = edge_of(mesh().next(h)), b = edge_of(mesh().prev(h));
        const bool is_longest = m_surface.value(a) <= value && m_surface.value(b) <= value;
        if (m_surface.is_flat(a) && m_surface.is_flat(b))
          m_index[joined] += 2;
        else if (m_surface.is_flat(a) || m_surface.is_flat(b) || is_longest)
          stack.insert(stack.end(), {a, b});
      }
    }
  }

  // joins the places of two vertices and returns the new one
  int join(int u, int v)
  {
    const int a = place(u), b = place(v);
    if (a == b)
      return a;
    m_sets.union_set(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
    const int joined = place(a), other = joined == a ? b : a;
    m_index[joined] += m_index[other];
    std::vector<Spoke> fewer = std::move(spokes_of(other));
    std::vector<Spoke>& more = spokes_of(joined);
    if (fewer.size() > more.size())
      std::swap(fewer, more);
    for (const Spoke& spoke : fewer)
    {
      more.push_back(spoke);
      std::push_heap(more.begin(), more.end(), std::greater<Spoke>());
    }
    return joined;
  }

  Edge_value_surface& m_surface;
  Disjoint_sets m_sets;
  std::vector<int> m_index;                 // by place: twice its Euler characteristic - its prongs
  std::vector<std::vector<Spoke>> m_spokes; // by place; empty if not yet listed
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_NOISE_REMOVAL_H
