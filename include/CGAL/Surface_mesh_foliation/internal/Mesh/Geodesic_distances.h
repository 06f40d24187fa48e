// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_GEODESIC_DISTANCES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_GEODESIC_DISTANCES_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Surface_mesh_copy.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// by edge, in the unit of points_of_unit_size()
inline std::vector<double> edge_lengths(const Flat_mesh& mesh)
{
  const std::vector<Point> points = points_of_unit_size(mesh);
  std::vector<double> result(mesh.number_of_edges());
  for (int e = 0; e < mesh.number_of_edges(); ++e)
    result[e] = distance(points[mesh.source(halfedge_of(e))], points[mesh.target(halfedge_of(e))]);
  return result;
}

// The distances of the vertices from the nearest of several sources along the surface, in the unit
// of points_of_unit_size(): Dijkstra's algorithm with additional steps across triangles (Kimmel and
// Sethian, Computing geodesic paths on manifolds, 1998), from two vertices as if both distances
// were those from one point in the plane of the triangle. On a plane of acute triangles, distances
// from one source are exact.
//
// Every distance is a function of two others and of lengths of edges; nothing is summed over
// elements in the order of their numbers. So distances do not depend on this order, not even by
// rounding, unless two are equal. (Those of the heat method, which come from linear solves, do.)
class Geodesic_distances
{
public:
  Geodesic_distances(const Flat_mesh& mesh, const std::vector<int>& sources)
    : Geodesic_distances(mesh, edge_lengths(mesh), sources)
  {}

  // The lengths are those of `edge_lengths()`, computed once for many sources.
  Geodesic_distances(const Flat_mesh& mesh,
                     const std::vector<double>& lengths,
                     const std::vector<int>& sources)
    : Geodesic_distances(mesh, lengths, sources, [](int) { return true; })
  {}

  // Visits the vertices, the nearest first, as long as goes_on(v) returns true; the distances of
  // the others are upper bounds or infinite.
  template <class GoesOn>
  Geodesic_distances(const Flat_mesh& mesh,
                     const std::vector<double>& lengths,
                     const std::vector<int>& sources,
                     GoesOn goes_on)
    : m_distance(mesh.number_of_vertices(), std::numeric_limits<double>::infinity()),
      m_is_final(mesh.number_of_vertices(), 0)
  {
    for (int v : sources)
      lower(v, 0);
    while (!m_queue.empty())
    {
      const int v = m_queue.top().second;
      m_queue.pop();
      if (m_is_final[v])
        continue;
      m_is_final[v] = 1;
      if (!goes_on(v))
        return;
      for (int h : mesh.ring(v))
        if (!m_is_final[mesh.target(h)])
          lower(mesh.target(h), distance_over(mesh, lengths, h));
    }
  }

  const std::vector<double>& distances() const { return m_distance; }

private:
  using Entry = std::pair<double, int>; // distance, vertex

  void lower(int v, double distance)
  {
    if (!(distance < m_distance[v]))
      return;
    m_distance[v] = distance;
    m_queue.emplace(distance, v);
  }

  // of the target of a halfedge whose source became final last: along it, or across a triangle
  // beside it
  double distance_over(const Flat_mesh& mesh, const std::vector<double>& lengths, int h) const
  {
    const int v = mesh.source(h), g = opposite_of(h);
    const double length = lengths[edge_of(h)];
    const double to_left = lengths[edge_of(mesh.prev(h))],
                 to_right = lengths[edge_of(mesh.next(g))];
    const double from_left = lengths[edge_of(mesh.next(h))],
                 from_right = lengths[edge_of(mesh.prev(g))];
    const double left = distance_across(v, mesh.target(mesh.next(h)), to_left, length, from_left);
    const double right =
      distance_across(v, mesh.target(mesh.next(g)), to_right, length, from_right);
    return (std::min)({m_distance[v] + length, left, right});
  }

  // From the edge u v, of length `base`, to the opposite vertex of a triangle, or infinity. u is
  // the vertex that became final last, so it is the farther one: which of the two is u depends only
  // on distances.
  double distance_across(int u, int v, double base, double to_u, double to_v) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (!m_is_final[v])
      return infinity;
    // in the plane, with u at the origin and v on the axis; the vertex lies above, the source below
    const double from_u = m_distance[u];
    const auto foot = [&](double u_length, double v_length) {
      return ((u_length - v_length) / base * (u_length + v_length) + base) / 2;
    };
    const double w_x = foot(to_u, to_v), s_x = foot(from_u, m_distance[v]);
    const double w_y2 = (to_u - w_x) * (to_u + w_x), s_y2 = (from_u - s_x) * (from_u + s_x);
    if (!(w_y2 > 0 && s_y2 >= 0))
      return infinity;
    const double w_y = std::sqrt(w_y2), s_y = std::sqrt(s_y2);
    const double crossing = s_x + (w_x - s_x) * (s_y / (s_y + w_y));
    return crossing > 0 && crossing < base ? (std::max)(from_u, norm(w_x - s_x, w_y + s_y))
                                           : infinity;
  }

  std::vector<double> m_distance; // by vertex
  std::vector<char> m_is_final;   // by vertex
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> m_queue;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_GEODESIC_DISTANCES_H
