// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SCALAR_REEB_GRAPH_ARC_CONTOURS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SCALAR_REEB_GRAPH_ARC_CONTOURS_H

#include <CGAL/Surface_mesh_foliation/internal/Loops/Flat_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/Flat_scalar_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/Vertex_order.h>
#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/lower_wedges.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Where a contour crosses an edge upward. Crossings of one edge are ordered by (level, sublevel)
// from its lower vertex to the higher one. The level is 2r for the contours that have exactly the r
// lowest vertices below them, and 2r + 1 for those between the steps of a saddle of rank r.
struct Contour_crossing
{
  int halfedge;
  int level, sublevel;
};

using Contour = std::vector<Contour_crossing>;

// Traces contours of the arcs of the Reeb graph of a function, with larger values to their left.
class Arc_contours
{
public:
  Arc_contours(const Flat_mesh& mesh,
               const Vertex_order& order,
               const Flat_scalar_reeb_graph& graph)
    : m_mesh(mesh), m_order(order), m_graph(graph)
  {}

  // A contour halfway between the values at the ends of an arc, or as near to that as vertices with
  // the same values as the ends allow. Between steps of the same saddle, the contour just above the
  // lower step.
  Contour contour(int arc) const
  {
    const Flat_scalar_reeb_graph::Piece& first = m_graph.pieces[m_graph.arcs[arc].first_piece];
    const int low = m_graph.nodes[m_graph.arcs[arc].lower].vertex;
    const int high = m_graph.nodes[m_graph.arcs[arc].upper].vertex;
    if (low == high)
      return contour_between_steps(first);
    const double middle = m_order.value(low) / 2 + m_order.value(high) / 2;
    const int number_below =
      std::clamp(m_order.number_up_to(middle), m_order.rank(low) + 1, m_order.rank(high));
    return contour(arc, number_below);
  }

  // the contour of an arc with the given number of vertices below its level, which must lie inside
  // the arc
  Contour contour(int arc, int number_below) const
  {
    return contour_above(halfedge_across(arc, number_below), number_below);
  }

  // a halfedge by which the contour of an arc with the given number of vertices below its level is
  // crossed upward; the level must lie inside the arc
  int halfedge_across(int arc, int number_below) const
  {
    int p = m_graph.arcs[arc].first_piece;
    while (m_order.rank(m_graph.pieces[p].upper_vertex) < number_below)
      p = m_graph.pieces[p].next;
    // Upward from the lower vertex: inside the arc until the level is reached, so O(n) steps for
    // all arcs together.
    int h = m_graph.pieces[p].halfedge;
    CGAL_assertion(m_order.rank(m_mesh.source(h)) < number_below);
    while (m_order.rank(m_mesh.target(h)) < number_below)
      h = halfedge_up(m_mesh.target(h));
    return h;
  }

private:
  int halfedge_up(int v) const
  {
    const Flat_mesh::Ring ring = m_mesh.ring(v);
    return *std::find_if(ring.begin(), ring.end(),
                         [&](int h) { return m_order.rank(m_mesh.target(h)) > m_order.rank(v); });
  }

  // the contour with the given number of vertices below it
  Contour contour_above(int first, int number_below) const
  {
    Contour result;
    int h = first;
    do
    {
      result.push_back({h, 2 * number_below, 0});
      const int g = m_mesh.next(opposite_of(h));
      h = m_order.rank(m_mesh.target(g)) < number_below ? m_mesh.next(g) : g;
    } while (h != first);
    return result;
  }

  // The contour just above a step of a saddle s that is not the last one. There, the lower wedges
  // of this step and those before, with the upper wedges between them, are below; the saddle and
  // the other upper wedges lie above. So the edges from s into the upper wedges between them are
  // crossed twice: from s down to what is below, and from there up to the wedge.
  Contour contour_between_steps(const Flat_scalar_reeb_graph::Piece& piece) const
  {
    const int s = piece.lower_vertex, rank = m_order.rank(s);
    const std::vector<int> doubles = edges_crossed_twice(s, piece.lower_step);
    const auto is_double = [&](int halfedge) {
      return std::binary_search(doubles.begin(), doubles.end(), halfedge);
    };
    const auto is_below = [&](int v) { return m_order.rank(v) < rank; };
    const bool is_up = !is_below(m_mesh.target(piece.halfedge));
    const int first = is_up ? piece.halfedge : opposite_of(piece.halfedge);
    Contour result;
    int h = first;
    do
    {
      const bool is_reversed = m_mesh.target(h) == s && is_double(opposite_of(h));
      result.push_back(
        {h, 2 * rank + 1, is_reversed ? -piece.lower_step - 1 : piece.lower_step + 1});
      const int g = m_mesh.next(opposite_of(h)), x = m_mesh.target(g); // from source(h) to x
      const bool is_x_below = x == s ? is_double(m_mesh.next(g))
                              : m_mesh.target(h) == s
                                ? is_below(x) || is_double(opposite_of(m_mesh.next(g)))
                                : is_below(x);
      h = is_x_below ? m_mesh.next(g) : g;
    } while (h != first);
    return result;
  }

  std::vector<int> edges_crossed_twice(int s, int step) const
  {
    const Flat_mesh::Ring ring = m_mesh.ring(s);
    std::vector<int> ranks, wedges, result;
    for (int h : ring)
      ranks.push_back(m_order.rank(m_mesh.target(h)));
    find_lower_wedges(ranks, m_order.rank(s), wedges);
    for (int i = wedges[0]; i != wedges[step + 1]; i = (i + 1) % ring.size())
      if (ranks[i] > m_order.rank(s))
        result.push_back(ring[i]);
    std::sort(result.begin(), result.end());
    return result;
  }

  const Flat_mesh& m_mesh;
  const Vertex_order& m_order;
  const Flat_scalar_reeb_graph& m_graph;
};

// Makes loops of contours of different arcs: puts the crossings of each edge at equal distances.
inline std::vector<Flat_loop> loops_of_contours(const Flat_mesh& mesh,
                                                const Vertex_order& order,
                                                const std::vector<Contour>& contours)
{
  std::vector<std::tuple<int, int, int, int, int>> entries; // edge, level, sublevel, loop, index
  std::vector<Flat_loop> result(contours.size());
  for (std::size_t a = 0; a < contours.size(); ++a)
    for (std::size_t i = 0; i < contours[a].size(); ++i)
    {
      const Contour_crossing& crossing = contours[a][i];
      entries.emplace_back(edge_of(crossing.halfedge), crossing.level, crossing.sublevel,
                           static_cast<int>(a), static_cast<int>(i));
      result[a].crossings.push_back({crossing.halfedge, 0});
    }
  std::sort(entries.begin(), entries.end());
  for (std::size_t first = 0, last = 0; first < entries.size(); first = last)
  {
    const int edge = std::get<0>(entries[first]);
    while (last < entries.size() && std::get<0>(entries[last]) == edge)
      ++last;
    for (std::size_t k = first; k < last; ++k)
    {
      Flat_crossing& crossing = result[std::get<3>(entries[k])].crossings[std::get<4>(entries[k])];
      const int h = crossing.halfedge;
      const double share =
        static_cast<double>(k - first + 1) / static_cast<double>(last - first + 1);
      crossing.position =
        order.rank(mesh.source(h)) < order.rank(mesh.target(h)) ? share : 1 - share;
    }
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SCALAR_REEB_GRAPH_ARC_CONTOURS_H
