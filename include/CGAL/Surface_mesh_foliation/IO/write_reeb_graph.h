// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_IO_WRITE_REEB_GRAPH_H
#define CGAL_SURFACE_MESH_FOLIATION_IO_WRITE_REEB_GRAPH_H

#include <CGAL/Surface_mesh_foliation/IO/write_polylines.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/text_output.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>

#include <CGAL/number_utils.h>

#include <boost/graph/graphviz.hpp>
#include <boost/range/iterator_range.hpp>

#include <cstddef>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/// \ingroup PkgSurfaceMeshFoliationIO
/// returns the name of a kind of node: `pole`, `saddle` or `regular`.
inline std::string name(Node_kind kind)
{
  return kind == Node_kind::POLE ? "pole" : kind == Node_kind::SADDLE ? "saddle" : "regular";
}

/// \ingroup PkgSurfaceMeshFoliationIO
/// returns the name of a kind of component: `disk`, `cylinder` or `sphere`.
inline std::string name(Component_kind kind)
{
  return kind == Component_kind::DISK       ? "disk"
         : kind == Component_kind::CYLINDER ? "cylinder"
                                            : "sphere";
}

namespace internal {

// The attributes of nodes or arcs in GraphML. (Boost.Graph's writer gives numbers six digits only.)
class Graphml_attributes
{
public:
  explicit Graphml_attributes(const char* of_what) : m_of_what(of_what) {}

  void begin() { m_next = 0; }

  void add(const char* name, const std::string& value) { add(name, "string", value); }
  void add(const char* name, int value) { add(name, "int", std::to_string(value)); }
  void add(const char* name, double value)
  {
    std::string text;
    append_number(text, value);
    add(name, "double", text);
  }

  // the declarations of the attributes added so far
  const std::string& keys() const { return m_keys; }
  // the attributes added since this was called last
  std::string data() { return std::exchange(m_data, std::string()); }

private:
  void add(const char* name, const char* type, const std::string& value)
  {
    const std::string key = std::string(m_of_what) + "_" + name;
    if (m_next++ == m_number)
    {
      ++m_number;
      m_keys += "  <key id=\"" + key + "\" for=\"" + m_of_what + "\" attr.name=\"" + name +
                "\" attr.type=\"" + type + "\"/>\n";
    }
    m_data += "      <data key=\"" + key + "\">" + value + "</data>\n";
  }

  const char* m_of_what;
  int m_next = 0, m_number = 0;
  std::string m_keys, m_data;
};

template <class Point>
void add_attributes(const Reeb_node<Point>& node, Graphml_attributes& attributes)
{
  attributes.begin();
  attributes.add("id", static_cast<int>(node.id));
  attributes.add("kind", name(node.kind));
  attributes.add("genus", static_cast<int>(node.genus));
  attributes.add("pole", node.pole);
  attributes.add("x", CGAL::to_double(node.point.x()));
  attributes.add("y", CGAL::to_double(node.point.y()));
  attributes.add("z", CGAL::to_double(node.point.z()));
}

template <class Point>
void add_attributes(const Reeb_arc<Point>& arc, Graphml_attributes& attributes)
{
  attributes.begin();
  attributes.add("loop", static_cast<int>(arc.loop));
  attributes.add("height", arc.height);
  attributes.add("flux", arc.flux);
  attributes.add("length", length(arc.polyline));
  attributes.add("component", name(arc.component));
  attributes.add("area", arc.area);
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationIO

writes a Reeb graph in GraphML, with what nodes and arcs know as attributes (of the polyline of an
arc the length).

\param file_name the name of the file
\param graph the graph

\throws Invalid_file_exception if the file cannot be written
*/
template <class Point>
void write_reeb_graph_graphml(const std::string& file_name, const Reeb_graph<Point>& graph)
{
  internal::Graphml_attributes of_node("node"), of_arc("edge");
  std::string elements;
  for (const auto v : boost::make_iterator_range(vertices(graph)))
  {
    internal::add_attributes(graph[v], of_node);
    elements += "    <node id=\"n" + std::to_string(v) + "\">\n" + of_node.data() + "    </node>\n";
  }
  for (const auto& e : boost::make_iterator_range(edges(graph)))
  {
    internal::add_attributes(graph[e], of_arc);
    elements += "    <edge source=\"n" + std::to_string(source(e, graph)) + "\" target=\"n" +
                std::to_string(target(e, graph)) + "\">\n" + of_arc.data() + "    </edge>\n";
  }
  internal::write_file(file_name, [&](std::ostream& output) {
    output << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
              "<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n"
           << of_node.keys() << of_arc.keys() << "  <graph id=\"G\" edgedefault=\"undirected\">\n"
           << elements << "  </graph>\n</graphml>\n";
  });
}

/*!
\ingroup PkgSurfaceMeshFoliationIO

writes a Reeb graph in the DOT language of Graphviz: poles as circles, saddle leaves as boxes, arcs
labeled with their loops.

\param file_name the name of the file
\param graph the graph

\throws Invalid_file_exception if the file cannot be written
*/
template <class Point>
void write_reeb_graph_dot(const std::string& file_name, const Reeb_graph<Point>& graph)
{
  const auto write_node = [&](std::ostream& output, auto v) {
    const Reeb_node<Point>& node = graph[v];
    output << "[label=\"" << name(node.kind) << ' '
           << (node.pole >= 0 ? static_cast<std::size_t>(node.pole) : node.id);
    if (node.genus > 0)
      output << "\\ngenus " << node.genus;
    output << "\", shape=" << (node.kind == Node_kind::POLE ? "circle" : "box") << "]";
  };
  const auto write_arc = [&](std::ostream& output, const auto& e) {
    output << "[label=\"" << graph[e].loop << "\", height=\"" << graph[e].height << "\"]";
  };
  internal::write_file(file_name, [&](std::ostream& output) {
    output.precision(internal::number_of_digits);
    boost::write_graphviz(output, graph, write_node, write_arc);
  });
}

/*!
\ingroup PkgSurfaceMeshFoliationIO

writes the embedded arcs of a Reeb graph in PLY, as polylines, with the edge properties `arc` (the
loop id) and `height`.

\param file_name the name of the file
\param graph the graph

\throws Invalid_file_exception if the file cannot be written
*/
template <class Point>
void write_skeleton_ply(const std::string& file_name, const Reeb_graph<Point>& graph)
{
  std::vector<std::vector<Point>> polylines;
  std::vector<const Reeb_arc<Point>*> arcs;
  for (const auto& e : boost::make_iterator_range(edges(graph)))
  {
    polylines.push_back(graph[e].polyline);
    arcs.push_back(&graph[e]);
  }
  write_polylines_ply(
    file_name, polylines, {},
    {int_property("arc",
                  [&](std::size_t i, std::size_t) { return static_cast<int>(arcs[i]->loop); }),
     double_property("height", [&](std::size_t i, std::size_t) { return arcs[i]->height; })});
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_IO_WRITE_REEB_GRAPH_H
