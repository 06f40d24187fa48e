// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LOOPS_REGIONS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LOOPS_REGIONS_H

#include <CGAL/Surface_mesh_foliation/internal/Common/Disjoint_sets.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/Flat_loops.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The pieces into which the loops cut the surface, found without cutting it: the loops cut the
// edges into intervals and the triangles into pieces, and a region is a class of intervals that
// meet in pieces. Precondition: the loops are simple and disjoint.
class Regions
{
public:
  // a side of a loop, 0 to its left and 1 to its right
  struct Side
  {
    int loop, side;
  };

  struct Region
  {
    int euler_characteristic = 0;
    std::vector<Side> sides;
    std::vector<int> poles;
    int genus() const { return (2 - static_cast<int>(sides.size()) - euler_characteristic) / 2; }
  };

  // The region that holds pole p gets number p, provided that no two poles share one.
  Regions(const Flat_mesh& mesh,
          const std::vector<Pole>& poles,
          const std::vector<Flat_loop>& loops,
          const Edge_crossings& crossings)
    : m_mesh(mesh), m_crossings(crossings), m_begin(mesh.number_of_edges() + 1, 0)
  {
    for (int e = 0; e < mesh.number_of_edges(); ++e)
      m_begin[e + 1] = m_begin[e] + crossings.size(e) + 1;
    number_regions(poles);
    count_cells();
    for (int a = 0; a < static_cast<int>(loops.size()); ++a)
      for (int side : {0, 1})
        m_regions[region_beside(loops[a], a, side)].sides.push_back({a, side});
  }

  int number_of_regions() const { return static_cast<int>(m_regions.size()); }
  const Region& region(int r) const { return m_regions[r]; }

  // the region that vertex v lies in
  int region_of_vertex(int v) const { return m_region[interval(m_mesh.ring(v)[0], 0)]; }

  // the region on one side of a loop
  int region_beside(const Flat_loop& loop, int a, int side) const
  {
    const int h = loop.crossings[0].halfedge;
    const int place = m_crossings.place(loop, a, 0);
    const bool is_toward_target = (side == 0) == is_forward(h);
    return m_region[m_begin[edge_of(h)] + place + (is_toward_target ? 1 : 0)];
  }

private:
  // the i-th interval of the edge of h, seen from source(h)
  int interval(int h, int i) const
  {
    const int e = edge_of(h);
    return m_begin[e] + (is_forward(h) ? i : m_crossings.size(e) - i);
  }

  int cuts(int h) const { return m_crossings.number_at_corner(m_mesh, h); }

  // All first intervals at a vertex lie in one region, so the vertex stands for them, and only the
  // intervals between two crossings of an edge have numbers of their own, behind the vertices.
  int place(int h, int i) const
  {
    const int e = edge_of(h), last = m_crossings.size(e);
    if (i == 0)
      return m_mesh.source(h);
    if (i == last)
      return m_mesh.target(h);
    return m_mesh.number_of_vertices() + m_begin[e] - e + (is_forward(h) ? i : last - i) - 1;
  }

  // Joins the places that meet inside an edge or a piece of a face.
  void join_places(Disjoint_sets& sets) const
  {
    for (int e = 0; e < m_mesh.number_of_edges(); ++e)
      if (m_crossings.size(e) == 0)
        sets.union_set(m_mesh.source(halfedge_of(e)), m_mesh.target(halfedge_of(e)));
      else
        for (int h : halfedges_of_edge(e))
          for (int i = cuts(h); i > 0; --i)
            sets.union_set(place(h, i), place(opposite_of(m_mesh.prev(h)), i));
  }

  void number_regions(const std::vector<Pole>& poles)
  {
    const int number_of_crossings = m_begin.back() - m_mesh.number_of_edges();
    const int number_of_places = m_mesh.number_of_vertices() + number_of_crossings;
    Disjoint_sets sets(number_of_places);
    join_places(sets);
    std::vector<int> number(number_of_places, -1);
    const auto meet = [&](int place) {
      int& result = number[sets.find_set(place)];
      if (result < 0)
      {
        result = number_of_regions();
        m_regions.emplace_back();
      }
      return result;
    };
    for (int p = 0; p < static_cast<int>(poles.size()); ++p)
      m_regions[meet(poles[p][0])].poles.push_back(p);
    m_region.reserve(m_begin.back());
    for (int e = 0; e < m_mesh.number_of_edges(); ++e)
      for (int i = 0; i <= m_crossings.size(e); ++i)
        m_region.push_back(meet(place(halfedge_of(e), i)));
  }

  void count_cells()
  {
    for (int region : m_region)
      --m_regions[region].euler_characteristic;
    for (int v = 0; v < m_mesh.number_of_vertices(); ++v)
      ++m_regions[region_of_vertex(v)].euler_characteristic;
    // loops cut off pieces at the corners of a face, and leave one in the middle
    for (int e = 0; e < m_mesh.number_of_edges(); ++e)
      if (m_crossings.size(e) > 0)
        for (int h : halfedges_of_edge(e))
          for (int i = 0; i < cuts(h); ++i)
            ++m_regions[m_region[interval(h, i)]].euler_characteristic;
    for (int f = 0; f < m_mesh.number_of_faces(); ++f)
    {
      const int h = m_mesh.halfedge_of_face(f);
      ++m_regions[m_region[interval(h, cuts(h))]].euler_characteristic;
    }
  }

  const Flat_mesh& m_mesh;
  const Edge_crossings& m_crossings;
  std::vector<int> m_begin;  // by edge, into m_region
  std::vector<int> m_region; // by interval
  std::vector<Region> m_regions;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LOOPS_REGIONS_H
