// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_IO_WRITE_REEB_GRAPH_H
#define CGAL_SURFACE_MESH_FOLIATION_IO_WRITE_REEB_GRAPH_H

#include <CGAL/Surface_mesh_foliation/IO/write_polylines.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/text_output.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/write_file.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>

#include <cstddef>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/// \ingroup PkgSurfaceMeshFoliationIO
/// returns the name of a kind of node: `pole`, `saddle` or `regular`.
inline std::string name(Node_kind kind)
{
  switch (kind)
  {
  case Node_kind::POLE:
    return "pole";
  case Node_kind::SADDLE:
    return "saddle";
  case Node_kind::BOUNDARY:
    return "boundary";
  default:
    return "regular";
  }
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

// of a node in a picture by Graphviz
inline const char* shape_of(Node_kind kind)
{
  return kind == Node_kind::POLE ? "circle" : kind == Node_kind::BOUNDARY ? "doublecircle" : "box";
}

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
  // the attributes added since the last call
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
  attributes.add("part", static_cast<int>(node.part));
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
  attributes.add("part", static_cast<int>(arc.part));
  attributes.add("height", arc.height);
  attributes.add("flux", arc.flux);
  attributes.add("length", length(arc.polyline));
  attributes.add("component", name(arc.component));
  attributes.add("area", arc.area);
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationIO

writes a Reeb graph in GraphML, with the properties of nodes and arcs as attributes (for the
polyline of an arc, its length). The edges are directed if the graph is.

\tparam Graph a model of `boost::VertexListGraph` and `boost::EdgeListGraph` whose vertex
  descriptors can be compared by `<`, such as `Reeb_graph<Point>` or a graph whose bundled
  properties derive from those of that type
\param file_name the name of the file
\param graph the graph
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
  below

\cgalNamedParamsBegin
  \cgalParamNBegin{node_map}
    \cgalParamDescription{a property map with the properties of the nodes}
    \cgalParamType{a class model of `ReadablePropertyMap` with
      `boost::graph_traits<Graph>::%vertex_descriptor` as key type and `Reeb_node<Point>`, or a type
      derived from it, as value type}
    \cgalParamDefault{the bundled properties, which must be or derive from `Reeb_node<Point>`}
  \cgalParamNEnd
  \cgalParamNBegin{arc_map}
    \cgalParamDescription{a property map with the properties of the arcs}
    \cgalParamType{a class model of `ReadablePropertyMap` with
      `boost::graph_traits<Graph>::%edge_descriptor` as key type and `Reeb_arc<Point>`, or a type
      derived from it, as value type}
    \cgalParamDefault{the bundled properties, which must be or derive from `Reeb_arc<Point>`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throws Invalid_file_exception if the file cannot be written
*/
template <class Graph, class NamedParameters = CGAL::parameters::Default_named_parameters>
void write_reeb_graph_graphml(const std::string& file_name,
                              const Graph& graph,
                              const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_parameters<internal_np::node_map_t, internal_np::arc_map_t>(np);
  const auto reader = internal::reeb_graph_reader(graph, np);
  internal::Graphml_attributes of_node("node"), of_arc("edge");
  std::string elements;
  std::size_t number = 0;
  for (const auto v : reader.nodes())
  {
    internal::add_attributes(reader.node(v), of_node);
    elements +=
      "    <node id=\"n" + std::to_string(number++) + "\">\n" + of_node.data() + "    </node>\n";
  }
  for (const auto& e : reader.arcs())
  {
    internal::add_attributes(reader.arc(e), of_arc);
    elements += "    <edge source=\"n" + std::to_string(reader.source_of(e)) + "\" target=\"n" +
                std::to_string(reader.target_of(e)) + "\">\n" + of_arc.data() + "    </edge>\n";
  }
  internal::write_file(file_name, [&](std::ostream& output) {
    output << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
              "<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n"
           << of_node.keys() << of_arc.keys() << "  <graph id=\"G\" edgedefault=\""
           << (boost::is_directed(graph) ? "directed" : "undirected") << "\">\n"
           << elements << "  </graph>\n</graphml>\n";
  });
}

/*!
\ingroup PkgSurfaceMeshFoliationIO

writes a Reeb graph in the DOT language of Graphviz: poles as circles, saddle leaves as boxes, arcs
labeled with their loops. The edges are directed if the graph is.

\tparam Graph a model of `boost::VertexListGraph` and `boost::EdgeListGraph` whose vertex
  descriptors can be compared by `<`, such as `Reeb_graph<Point>` or a graph whose bundled
  properties derive from those of that type
\param file_name the name of the file
\param graph the graph
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
  below

\cgalNamedParamsBegin
  \cgalParamNBegin{node_map}
    \cgalParamDescription{a property map with the properties of the nodes}
    \cgalParamType{a class model of `ReadablePropertyMap` with
      `boost::graph_traits<Graph>::%vertex_descriptor` as key type and `Reeb_node<Point>`, or a type
      derived from it, as value type}
    \cgalParamDefault{the bundled properties, which must be or derive from `Reeb_node<Point>`}
  \cgalParamNEnd
  \cgalParamNBegin{arc_map}
    \cgalParamDescription{a property map with the properties of the arcs}
    \cgalParamType{a class model of `ReadablePropertyMap` with
      `boost::graph_traits<Graph>::%edge_descriptor` as key type and `Reeb_arc<Point>`, or a type
      derived from it, as value type}
    \cgalParamDefault{the bundled properties, which must be or derive from `Reeb_arc<Point>`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throws Invalid_file_exception if the file cannot be written
*/
template <class Graph, class NamedParameters = CGAL::parameters::Default_named_parameters>
void write_reeb_graph_dot(const std::string& file_name,
                          const Graph& graph,
                          const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_parameters<internal_np::node_map_t, internal_np::arc_map_t>(np);
  const auto reader = internal::reeb_graph_reader(graph, np);
  const bool is_directed = boost::is_directed(graph);
  // not by Boost.Graph's writer: parsing its header takes too long
  internal::write_file(file_name, [&](std::ostream& output) {
    output.precision(internal::number_of_digits);
    output << (is_directed ? "digraph" : "graph") << " G {\n";
    for (const auto v : reader.nodes())
    {
      const auto& node = reader.node(v);
      output << reader.number_of_node().at(v) << "[label=\"" << name(node.kind) << ' '
             << (node.pole >= 0 ? static_cast<std::size_t>(node.pole) : node.id);
      if (node.genus > 0)
        output << "\\ngenus " << node.genus;
      output << "\", shape=" << internal::shape_of(node.kind) << "];\n";
    }
    for (const auto& e : reader.arcs())
    {
      const auto& arc = reader.arc(e);
      output << reader.source_of(e) << (is_directed ? "->" : "--") << reader.target_of(e)
             << " [label=\"" << arc.loop << "\", height=\"" << arc.height << "\"];\n";
    }
    output << "}\n";
  });
}

/*!
\ingroup PkgSurfaceMeshFoliationIO

writes the embedded arcs of a Reeb graph in PLY, as polylines, with the vertex properties `radius`
of the leaf, `arc`, the loop id, and `node`, the position in `vertices(graph)` of the node at an end
of the arc, or -1, and the edge properties `arc` and `height`.

\tparam Graph a model of `boost::VertexListGraph` and `boost::EdgeListGraph` whose vertex
  descriptors can be compared by `<`, such as `Reeb_graph<Point>` or a graph whose bundled
  properties derive from those of that type
\param file_name the name of the file
\param graph the graph
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
  below

\cgalNamedParamsBegin
  \cgalParamNBegin{arc_map}
    \cgalParamDescription{a property map with the properties of the arcs}
    \cgalParamType{a class model of `ReadablePropertyMap` with
      `boost::graph_traits<Graph>::%edge_descriptor` as key type and `Reeb_arc<Point>`, or a type
      derived from it, as value type}
    \cgalParamDefault{the bundled properties, which must be or derive from `Reeb_arc<Point>`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throws Invalid_file_exception if the file cannot be written
*/
template <class Graph, class NamedParameters = CGAL::parameters::Default_named_parameters>
void write_skeleton_ply(const std::string& file_name,
                        const Graph& graph,
                        const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_parameters<internal_np::arc_map_t>(np);
  const auto reader = internal::reeb_graph_reader(graph, np);
  using Arc = typename boost::graph_traits<Graph>::edge_descriptor;
  std::vector<std::decay_t<decltype(reader.arc(std::declval<Arc>()).polyline)>> polylines;
  std::vector<int> loops;
  std::vector<double> heights;
  std::vector<std::vector<double>> radii;
  std::vector<std::pair<std::size_t, std::size_t>> ends;
  for (const auto& e : reader.arcs())
  {
    const auto& arc = reader.arc(e);
    polylines.push_back(arc.polyline);
    loops.push_back(static_cast<int>(arc.loop));
    heights.push_back(arc.height);
    radii.push_back(arc.radii);
    radii.back().resize(arc.polyline.size(), 0);
    ends.emplace_back(reader.source_of(e), reader.target_of(e));
  }
  const auto node_at = [&](std::size_t i, std::size_t j) {
    return j == 0                         ? static_cast<int>(ends[i].first)
           : j + 1 == polylines[i].size() ? static_cast<int>(ends[i].second)
                                          : -1;
  };
  write_polylines_ply(
    file_name, polylines,
    {double_property("radius", [&](std::size_t i, std::size_t j) { return radii[i][j]; }),
     int_property("arc", [&](std::size_t i, std::size_t) { return loops[i]; }),
     int_property("node", node_at)},
    {int_property("arc", [&](std::size_t i, std::size_t) { return loops[i]; }),
     double_property("height", [&](std::size_t i, std::size_t) { return heights[i]; })});
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_IO_WRITE_REEB_GRAPH_H
