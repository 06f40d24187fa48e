// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_AUTOMATIC_LOOPS_PROPOSED_LOOPS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_AUTOMATIC_LOOPS_PROPOSED_LOOPS_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>
#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/Arc_contours.h>
#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/Contour_sweep.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/Flat_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/Flat_scalar_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/internal/Automatic_loops/Loop_families.h>
#include <CGAL/Surface_mesh_foliation/internal/Automatic_loops/Sweep.h>
#include <CGAL/Surface_mesh_foliation/internal/Automatic_loops/fill_short_handles.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The loops that a sweep over a surface with poles proposes. The Reeb graph of the sweep, whose
// saddles are simple, is the graph of the surface cut along one contour for each arc. Its nodes are
// planar pieces: an extremum is a disk and a saddle a pair of pants. A pole inside an arc makes one
// more node, an annulus. So it is known which loops are superfluous before any of them is traced,
// and only those that are kept are traced.
class Proposed_loops
{
public:
  Proposed_loops(const Flat_mesh& mesh, const std::vector<Pole>& poles, const Sweep& sweep)
    : m_mesh(mesh),
      m_poles(poles),
      m_sweep(sweep),
      m_graph(Contour_sweep(mesh, sweep.order()).take_graph()),
      m_piece_of_vertex(mesh.number_of_vertices(), -1)
  {
    build_pieces();
    build_families();
  }

  void reduce(bool uses_poles_as_punctures) { m_families.reduce(uses_poles_as_punctures); }

  void fill_handles_shorter_than(double bound, bool uses_poles_as_punctures)
  {
    std::vector<double> lengths(m_levels.size(), 0);
    for (int f = 0; f < m_families.number_of_families(); ++f)
      if (m_families.family(f).is_alive)
        lengths[f] = length(f);
    fill_short_handles(m_families, lengths, bound, uses_poles_as_punctures);
  }

  std::vector<Flat_loop> loops() const { return loops_of_families(families_left()); }

  // those of them, not more than some number, that the sweep comes to first
  std::vector<Flat_loop> first_loops(std::size_t most) const
  {
    std::vector<int> families = families_left();
    std::stable_sort(families.begin(), families.end(),
                     [&](int f, int g) { return first_rank(f) < first_rank(g); });
    families.resize((std::min)(families.size(), most));
    return loops_of_families(families);
  }

private:
  static constexpr int between_steps = 0; // of a saddle
  static constexpr int no_level = -1;

  // where the loop of a family runs
  struct Level
  {
    int arc;
    int number_below;
  };

  // ===  The graph

  // The piece of a vertex lies just above the level at which the vertex is reached; so at a saddle
  // it is the last of the pieces that belong to the steps.
  void build_pieces()
  {
    for (const auto& node : m_graph.nodes)
      m_piece_of_vertex[node.vertex] = m_families.add_piece();
    for (const Pole& pole : m_poles)
      for (int v : pole)
        if (m_piece_of_vertex[v] < 0)
          m_piece_of_vertex[v] = m_families.add_piece();
    for (const Pole& pole : m_poles)
      m_families.add_pole(m_piece_of_vertex[pole[0]]);
  }

  void build_families()
  {
    const std::vector<std::vector<int>> poles_of_arc = poles_inside_arcs();
    m_first_ranks = first_ranks_inside_arcs();
    for (int a = 0; a < static_cast<int>(m_graph.arcs.size()); ++a)
    {
      const auto& arc = m_graph.arcs[a];
      int lower_vertex = m_graph.nodes[arc.lower].vertex, lower_piece = arc.lower;
      for (int v : poles_of_arc[a])
      {
        add_family(a, lower_vertex, lower_piece, v, m_piece_of_vertex[v]);
        lower_vertex = v;
        lower_piece = m_piece_of_vertex[v];
      }
      add_family(a, lower_vertex, lower_piece, m_graph.nodes[arc.upper].vertex, arc.upper);
    }
    // No contour that meets a line pole is a loop. All levels along an edge of a line pole have
    // such contours, so the vertices of the pole end up in one piece.
    for (int f = 0; f < m_families.number_of_families(); ++f)
      if (m_levels[f].number_below == no_level)
        m_families.drop(f);
  }

  // by arc, the vertices of poles inside it from below
  std::vector<std::vector<int>> poles_inside_arcs() const
  {
    std::vector<std::vector<int>> result(m_graph.arcs.size());
    for (const Pole& pole : m_poles)
      for (int v : pole)
        if (m_piece_of_vertex[v] >= static_cast<int>(m_graph.nodes.size()))
          result[m_graph.arc_of_vertex[v]].push_back(v);
    for (std::vector<int>& vertices : result)
      std::sort(vertices.begin(), vertices.end(),
                [&](int u, int v) { return m_sweep.order().rank(u) < m_sweep.order().rank(v); });
    return result;
  }

  // By arc, the rank of the lowest vertex inside it. The two arcs from one saddle to another have
  // the same span; this tells them apart whatever the order of vertices in the mesh.
  std::vector<int> first_ranks_inside_arcs() const
  {
    std::vector<int> result(m_graph.arcs.size(), m_mesh.number_of_vertices());
    for (int r = m_mesh.number_of_vertices() - 1; r >= 0; --r)
    {
      const int v = m_sweep.order().vertex(r), piece = m_piece_of_vertex[v];
      if (piece < 0 || piece >= static_cast<int>(m_graph.nodes.size()))
        result[m_graph.arc_of_vertex[v]] = r;
    }
    return result;
  }

  void add_family(int arc, int lower_vertex, int lower_piece, int upper_vertex, int upper_piece)
  {
    int level = between_steps;
    if (lower_vertex != upper_vertex)
      level = m_sweep.level_between(lower_vertex, upper_vertex);
    else if (is_on_line_pole(lower_vertex))
      level = no_level;
    m_levels.push_back({arc, level});
    const double span = m_sweep.value(upper_vertex) / 2 - m_sweep.value(lower_vertex) / 2;
    m_families.add_family(lower_piece, upper_piece, {span, -m_first_ranks[arc]});
  }

  bool is_on_line_pole(int v) const
  {
    const int p = m_sweep.pole_of_vertex(v);
    return p >= 0 && m_poles[p].size() > 1;
  }

  // ===  Loops

  std::vector<int> families_left() const
  {
    std::vector<int> result;
    for (int f = 0; f < m_families.number_of_families(); ++f)
      if (m_families.family(f).is_alive)
        result.push_back(f);
    return result;
  }

  std::vector<Flat_loop> loops_of_families(const std::vector<int>& families) const
  {
    std::vector<Contour> contours;
    contours.reserve(families.size());
    for (const int f : families)
      contours.push_back(contour(f));
    return loops_of_contours(m_mesh, m_sweep.order(), contours);
  }

  // of the vertices above the loop of a family
  int first_rank(int family) const
  {
    const Level& level = m_levels[family];
    return level.number_below == between_steps
             ? m_sweep.order().rank(m_graph.nodes[m_graph.arcs[level.arc].lower].vertex)
             : level.number_below;
  }

  Contour contour(int family) const
  {
    const Arc_contours contours(m_mesh, m_sweep.order(), m_graph);
    const Level& level = m_levels[family];
    return level.number_below == between_steps ? contours.contour(level.arc)
                                               : contours.contour(level.arc, level.number_below);
  }

  // The length of a contour along its exact course, with the function linear in every triangle.
  double length(int family) const
  {
    const Contour crossings = contour(family);
    const int number_below = m_levels[family].number_below;
    const auto& order = m_sweep.order();
    const int above = number_below == between_steps
                        ? m_graph.nodes[m_graph.arcs[m_levels[family].arc].lower].vertex
                        : order.vertex(number_below);
    const int below = number_below == between_steps ? above : order.vertex(number_below - 1);
    const double value = m_sweep.value(below) / 2 + m_sweep.value(above) / 2;
    double result = 0;
    Point previous = place(crossings.back().halfedge, value);
    for (const Contour_crossing& crossing : crossings)
    {
      const Point next = place(crossing.halfedge, value);
      result += distance(next, previous);
      previous = next;
    }
    return (std::min)(result, (std::numeric_limits<double>::max)());
  }

  // the point on the edge of h at which the function has a value
  Point place(int h, double value) const
  {
    const int u = m_mesh.source(h), v = m_mesh.target(h);
    const double from = m_sweep.value(u), to = m_sweep.value(v);
    const double share = from == to ? 0.5 : (value / 2 - from / 2) / (to / 2 - from / 2);
    const double t = std::clamp(share, 0., 1.);
    return coordinates(
      Eigen::Vector3d((1 - t) * to_vector(m_mesh.point(u)) + t * to_vector(m_mesh.point(v))));
  }

  const Flat_mesh& m_mesh;
  const std::vector<Pole>& m_poles;
  const Sweep& m_sweep;
  const Flat_scalar_reeb_graph m_graph;
  std::vector<int> m_piece_of_vertex; // of nodes of the graph and of poles; others have -1
  Loop_families m_families;           // its first pieces are the nodes of the graph
  std::vector<int> m_first_ranks;     // by arc
  std::vector<Level> m_levels;        // by family
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_AUTOMATIC_LOOPS_PROPOSED_LOOPS_H
