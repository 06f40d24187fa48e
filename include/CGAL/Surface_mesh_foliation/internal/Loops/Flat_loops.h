// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LOOPS_FLAT_LOOPS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LOOPS_FLAT_LOOPS_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Pole.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// A loop crosses `halfedge` from its face to the opposite one, at `position` in (0,1) from source
// to target. Target lies to the left of the loop, source to the right.
struct Flat_crossing
{
  int halfedge;
  double position;
};

// A loop with its height. A pole loop knows its pole; a tight one has no other loop between itself
// and the pole, regardless of positions.
struct Flat_loop
{
  std::vector<Flat_crossing> crossings;
  double height = 1;
  int pole = -1;
  bool is_tight = false;
};

// The crossings of all loops, in order along each edge.
class Edge_crossings
{
public:
  struct Entry
  {
    int loop;
    int index;    // in the loop
    int halfedge; // its direction is the one in which the loop crosses
    int rank;     // -1, 1: tight around source, target of the edge's forward halfedge; 0: neither
    double position; // along the forward halfedge
  };

  Edge_crossings() = default;

  Edge_crossings(const Flat_mesh& mesh, const std::vector<Flat_loop>& loops)
    : m_begin(mesh.number_of_edges() + 1, 0)
  {
    for (const Flat_loop& loop : loops)
      for (const Flat_crossing& crossing : loop.crossings)
        ++m_begin[edge_of(crossing.halfedge) + 1];
    for (int e = 0; e < mesh.number_of_edges(); ++e)
      m_begin[e + 1] += m_begin[e];
    m_entries.resize(m_begin.back());
    std::vector<int> position(m_begin);
    for (std::size_t a = 0; a < loops.size(); ++a)
      for (std::size_t i = 0; i < loops[a].crossings.size(); ++i)
        m_entries[position[edge_of(loops[a].crossings[i].halfedge)]++] =
          make_entry(loops[a], static_cast<int>(a), static_cast<int>(i));
    for (int first = 0, last = 0; first < m_begin.back(); first = last)
    {
      last = m_begin[edge_of(m_entries[first].halfedge) + 1];
      std::sort(m_entries.begin() + first, m_entries.begin() + last, is_before);
    }
  }

  int size(int e) const { return m_begin[e + 1] - m_begin[e]; }
  const Entry& entry(int e, int i) const { return m_entries[m_begin[e] + i]; }

  // the i-th crossing of the edge of h, seen from source(h)
  const Entry& from_source(int h, int i) const
  {
    return entry(edge_of(h), is_forward(h) ? i : size(edge_of(h)) - 1 - i);
  }

  // the number of segments of loops that cut off the corner at source(h) in face(h)
  int number_at_corner(const Flat_mesh& mesh, int h) const
  {
    return (size(edge_of(h)) + size(edge_of(mesh.prev(h))) - size(edge_of(mesh.next(h)))) / 2;
  }

  // the place of a crossing on its edge
  int place(const Flat_loop& loop, int a, int index) const
  {
    const int e = edge_of(loop.crossings[index].halfedge);
    for (int i = 0; i < size(e); ++i)
      if (entry(e, i).loop == a && entry(e, i).index == index)
        return i;
    return -1;
  }

  // whether two crossings of one edge have no order
  static bool coincide(const Entry& x, const Entry& y)
  {
    return x.rank == y.rank && x.position == y.position;
  }

private:
  static Entry make_entry(const Flat_loop& loop, int a, int i)
  {
    const Flat_crossing& crossing = loop.crossings[i];
    const bool is_along_edge = is_forward(crossing.halfedge);
    // a tight loop has its pole on the left, at the target of the crossed halfedge
    const int rank = !loop.is_tight ? 0 : is_along_edge ? 1 : -1;
    return {a, i, crossing.halfedge, rank,
            is_along_edge ? crossing.position : 1 - crossing.position};
  }

  static bool is_before(const Entry& x, const Entry& y)
  {
    if (x.rank != y.rank)
      return x.rank < y.rank;
    if (x.position != y.position)
      return x.position < y.position;
    return x.loop != y.loop ? x.loop < y.loop : x.index < y.index;
  }

  std::vector<int> m_begin; // by edge
  std::vector<Entry> m_entries;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LOOPS_FLAT_LOOPS_H
