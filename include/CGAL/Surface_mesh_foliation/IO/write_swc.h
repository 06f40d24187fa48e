// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_IO_WRITE_SWC_H
#define CGAL_SURFACE_MESH_FOLIATION_IO_WRITE_SWC_H

#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/text_output.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/write_file.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

namespace internal {

// An embedded Reeb graph as a forest of points, as the SWC format wants it: arcs are walked along a
// spanning forest, away from its roots; an arc that closes a cycle ends in a copy of its last
// point.
class Swc_forest
{
public:
  // `add_arc()` is called for all arcs, then `text()`.
  explicit Swc_forest(std::size_t number_of_nodes) : m_arcs_at(number_of_nodes) {}

  void add_arc(std::size_t first,
               std::size_t last,
               std::vector<Point> points,
               std::vector<double> radii)
  {
    radii.resize(points.size(), 0);
    m_arcs_at[first].push_back(m_arcs.size());
    m_arcs_at[last].push_back(m_arcs.size());
    m_arcs.push_back({first, last, std::move(points), std::move(radii)});
  }

  std::string text()
  {
    m_number_of_node.assign(m_arcs_at.size(), not_reached);
    m_is_walked.assign(m_arcs.size(), false);
    for (std::size_t root = 0; root < m_arcs_at.size(); ++root)
      if (m_number_of_node[root] == not_reached && !m_arcs_at[root].empty())
        walk_from(root);
    return std::move(m_text);
  }

private:
  struct Arc
  {
    std::size_t first, last; // nodes
    std::vector<Point> points;
    std::vector<double> radii;
  };

  static constexpr int not_reached = 0; // points are numbered from 1
  static constexpr int no_parent = -1;

  void walk_from(std::size_t root)
  {
    const Arc& arc = m_arcs[m_arcs_at[root][0]];
    const std::size_t at_root = arc.first == root ? 0 : arc.points.size() - 1;
    m_number_of_node[root] =
      add_point(type_of_node(root), arc.points[at_root], arc.radii[at_root], no_parent);
    std::vector<std::size_t> nodes = {root}; // reached, their arcs not yet walked
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (const std::size_t a : m_arcs_at[nodes[i]])
        if (!m_is_walked[a])
        {
          m_is_walked[a] = true;
          const std::size_t end = m_arcs[a].first == nodes[i] ? m_arcs[a].last : m_arcs[a].first;
          const bool is_new = m_number_of_node[end] == not_reached;
          const int last_point = walk_along(m_arcs[a], nodes[i], end);
          if (is_new)
          {
            m_number_of_node[end] = last_point;
            nodes.push_back(end);
          }
        }
  }

  // returns the number of the last point
  int walk_along(const Arc& arc, std::size_t start, std::size_t end)
  {
    const bool is_forward = arc.first == start;
    const std::size_t size = arc.points.size();
    int parent = m_number_of_node[start];
    for (std::size_t i = 1; i < size; ++i)
    {
      const std::size_t j = is_forward ? i : size - 1 - i;
      const int type = i + 1 == size ? type_of_node(end) : sample_type;
      parent = add_point(type, arc.points[j], arc.radii[j], parent);
    }
    return parent;
  }

  int type_of_node(std::size_t node) const
  {
    return m_arcs_at[node].size() > 2    ? fork_type
           : m_arcs_at[node].size() == 1 ? end_type
                                         : sample_type;
  }

  int add_point(int type, const Point& p, double radius, int parent)
  {
    const int number = ++m_number_of_points;
    m_text += std::to_string(number) + ' ' + std::to_string(type);
    for (const double value : {p[0], p[1], p[2], radius})
    {
      m_text += ' ';
      append_number(m_text, value);
    }
    m_text += ' ' + std::to_string(parent) + '\n';
    return number;
  }

  // of the format
  static constexpr int sample_type = 0; // undefined
  static constexpr int fork_type = 5;
  static constexpr int end_type = 6;

  std::vector<std::vector<std::size_t>> m_arcs_at; // by node; an arc from a node to itself twice
  std::vector<Arc> m_arcs;
  std::vector<int> m_number_of_node; // that of its point
  std::vector<bool> m_is_walked;
  int m_number_of_points = 0;
  std::string m_text;
};

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationIO

writes an embedded Reeb graph in SWC, the format of traces of neurons: a point in each line, with
its number, type, coordinates, radius, and the number of the point before it.

A file describes trees: one for each part of the graph, whose root is its first node. Where an arc
closes a cycle, its last point is a copy of that of a node, at the same place. The type is 5 for
nodes where more than two arcs meet, 6 for nodes with one arc, and 0 for all other points. The
radius is that of the leaf, so it is 0 for poles at vertices.

\tparam Graph a model of `boost::VertexListGraph` and `boost::EdgeListGraph` whose vertex
  descriptors can be compared by `<`, such as `Reeb_graph<Point>` or a graph whose bundled
  properties derive from those of that type
\param file_name the name of the file
\param graph the graph
\param np an optional sequence of named parameters: `arc_map` as for `write_skeleton_ply()`

\throws Invalid_file_exception if the file cannot be written
*/
template <class Graph, class NamedParameters = CGAL::parameters::Default_named_parameters>
void write_skeleton_swc(const std::string& file_name,
                        const Graph& graph,
                        const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_parameters<internal_np::arc_map_t>(np);
  const auto reader = internal::reeb_graph_reader(graph, np);
  internal::Swc_forest forest(reader.number_of_node().size());
  for (const auto& e : reader.arcs())
  {
    const auto& arc = reader.arc(e);
    std::vector<internal::Point> points;
    for (const auto& p : arc.polyline)
      points.push_back(internal::coordinates(p));
    if (!points.empty())
      forest.add_arc(reader.source_of(e), reader.target_of(e), std::move(points), arc.radii);
  }
  internal::write_file(file_name, [&](std::ostream& output) {
    output << "# number type x y z radius previous\n" << forest.text();
  });
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_IO_WRITE_SWC_H
