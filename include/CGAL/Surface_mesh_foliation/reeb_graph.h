// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_REEB_GRAPH_H
#define CGAL_SURFACE_MESH_FOLIATION_REEB_GRAPH_H

#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>
#include <CGAL/Surface_mesh_foliation/components.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/Added_nodes.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/component_labels.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_embedding.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/use.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/range/iterator_range.hpp>

#include <cstddef>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/// \ingroup PkgSurfaceMeshFoliationGraph
/// is the kind of a node of the Reeb graph.
enum class Node_kind {
  POLE,    ///< a pole leaf
  SADDLE,  ///< a critical leaf through saddles
  REGULAR, ///< an artificial node on a regular leaf: a torus without poles has no singularity
  BOUNDARY ///< the border of an opening that is a pole
};

/// \ingroup PkgSurfaceMeshFoliationGraph
/// holds the properties of a node of the Reeb graph, a critical leaf.
template <class Point>
struct Reeb_node
{
  std::size_t id = 0;                 ///< the node of the loop system
  std::size_t part = 0;               ///< the part of the mesh, see `mesh_parts()`
  Node_kind kind = Node_kind::SADDLE; ///< what kind of leaf it is
  std::size_t genus = 0;              ///< the genus of its region, which the graph ignores
  int pole = -1;                      ///< the number of the pole, or -1
  Point point;                        ///< the centroid of the leaf
  double radius = 0;                  ///< see `Reeb_graph_embedding::node_radii`
};

/// \ingroup PkgSurfaceMeshFoliationGraph
/// holds the properties of an arc of the Reeb graph, a surface component.
template <class Point>
struct Reeb_arc
{
  std::size_t loop = 0; ///< the id of its loop, which is the number of the arc in the loop system
  std::size_t part = 0; ///< the part of the mesh, see `mesh_parts()`
  double height = 0;    ///< the transverse measure of its leaves
  double flux = 0;      ///< see `Measured_foliation::flux()`
  std::vector<Point> polyline; ///< from the point of the node at end 0 to that at end 1
  Component_kind component = Component_kind::CYLINDER; ///< the kind of its component
  std::vector<double> radii;                           ///< of its leaves, one per point
  double area = 0;                                     ///< of its component
};

/// \ingroup PkgSurfaceMeshFoliationGraph
/// is the default type of a Reeb graph.
template <class Point>
using Reeb_graph = boost::
  adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Reeb_node<Point>, Reeb_arc<Point>>;

/// \ingroup PkgSurfaceMeshFoliationGraph
/// returns the length of a polyline, for example of an embedded arc.
template <class Point>
double length(const std::vector<Point>& polyline)
{
  double result = 0;
  for (std::size_t i = 1; i < polyline.size(); ++i)
    result += internal::distance(internal::coordinates(polyline[i]),
                                 internal::coordinates(polyline[i - 1]));
  return result;
}

namespace internal {

using Graph_map_parameters = Parameter_list<internal_np::node_map_t, internal_np::arc_map_t>;
using Reeb_graph_parameters = Joined_parameters<Graph_map_parameters, Embedding_parameters>;

template <class Graph, class = void>
struct Allows_parallel_edges : std::false_type
{};

template <class Graph>
struct Allows_parallel_edges<
  Graph,
  std::void_t<typename boost::graph_traits<Graph>::edge_parallel_category>>
  : std::is_convertible<typename boost::graph_traits<Graph>::edge_parallel_category,
                        boost::allow_parallel_edge_tag>
{};

// whether a graph has a bundled property for a vertex or edge that takes the value
template <class Graph, class Key, class Value, class = void>
struct Has_bundle_for : std::false_type
{};

template <class Graph, class Key, class Value>
struct Has_bundle_for<Graph,
                      Key,
                      Value,
                      std::void_t<decltype(std::declval<Graph&>()[std::declval<const Key&>()] =
                                             std::declval<const Value&>())>> : std::true_type
{};

// what `graph[descriptor]` gives for a vertex or edge; nothing if the graph has no bundled
// properties
template <class Graph, class Key, class = void>
struct Bundle_of
{
  using type = void;
};

template <class Graph, class Key>
struct Bundle_of<Graph,
                 Key,
                 std::void_t<decltype(std::declval<Graph&>()[std::declval<const Key&>()])>>
{
  using type = decltype(std::declval<Graph&>()[std::declval<const Key&>()]);
};

// whether a type is an instance of a class template, or derives from one publicly
template <template <class> class Template, class T>
struct Derives_from_instance
{
  template <class Argument>
  static std::true_type test(const Template<Argument>*);
  static std::false_type test(const volatile void*);
  static constexpr bool value = decltype(test(std::declval<std::remove_reference_t<T>*>()))::value;
};

// whether a bundled property derives in any way from a value type, or from one with another point
// type
template <class Value, class Bundle>
struct Is_akin : std::is_base_of<Value, Bundle>
{};

template <template <class> class Template, class Argument, class Bundle>
struct Is_akin<Template<Argument>, Bundle>
  : std::disjunction<std::is_base_of<Template<Argument>, Bundle>,
                     Derives_from_instance<Template, Bundle>>
{};

// Where nodes or arcs are written by default: to the bundled properties if these can be assigned
// from them, or to the base that these derive from; otherwise nowhere.
template <class Graph, class Key, class Value>
struct Bundle_map
{
  Graph* graph;
  friend void put(const Bundle_map& map, const Key& key, const Value& value)
  {
    using Bundle = std::remove_reference_t<typename Bundle_of<Graph, Key>::type>;
    if constexpr (Has_bundle_for<Graph, Key, Value>::value)
      (*map.graph)[key] = value;
    else if constexpr (std::is_convertible_v<Bundle*, Value*>)
      static_cast<Value&>((*map.graph)[key]) = value;
    else
    {
      static_assert(!Is_akin<Value, Bundle>::value,
                    "the bundled property of this graph derives from what is to be written to it, "
                    "but privately, more than once, or with another point type, so that it cannot "
                    "be assigned: give a node_map or an arc_map");
      CGAL_USE(map);
      CGAL_USE(key);
      CGAL_USE(value);
    }
  }
};

// where the properties of nodes or arcs are found by default: in the bundled properties
template <class Graph, class Key>
struct Bundle_reader
{
  const Graph* graph;
  friend typename Bundle_of<const Graph, Key>::type get(const Bundle_reader& map, const Key& key)
  {
    return (*map.graph)[key];
  }
};

// A Reeb graph as seen by the functions that write it: the numbers of its nodes, in the order of
// iteration, and the properties of its nodes and arcs.
template <class Graph, class NodeMap, class ArcMap>
class Reeb_graph_reader
{
public:
  using Node = typename boost::graph_traits<Graph>::vertex_descriptor;
  using Arc = typename boost::graph_traits<Graph>::edge_descriptor;
  using Number_of_node = std::map<Node, std::size_t>;

  Reeb_graph_reader(const Graph& graph, NodeMap node_map, ArcMap arc_map)
    : m_graph(graph), m_node_map(std::move(node_map)), m_arc_map(std::move(arc_map))
  {
    for (const Node v : boost::make_iterator_range(vertices(graph)))
    {
      const std::size_t number = m_number_of_node.size();
      m_number_of_node[v] = number;
    }
  }

  const Graph& graph() const { return m_graph; }
  const Number_of_node& number_of_node() const { return m_number_of_node; }
  auto nodes() const { return boost::make_iterator_range(vertices(m_graph)); }
  auto arcs() const { return boost::make_iterator_range(edges(m_graph)); }
  std::size_t source_of(const Arc& e) const { return m_number_of_node.at(source(e, m_graph)); }
  std::size_t target_of(const Arc& e) const { return m_number_of_node.at(target(e, m_graph)); }

  decltype(auto) node(const Node& v) const
  {
    static_assert(Derives_from_instance<Reeb_node, decltype(get(m_node_map, v))>::value,
                  "the bundled property of a vertex, or what the node_map gives, must be or derive "
                  "from Reeb_node");
    return get(m_node_map, v);
  }
  decltype(auto) arc(const Arc& e) const
  {
    static_assert(Derives_from_instance<Reeb_arc, decltype(get(m_arc_map, e))>::value,
                  "the bundled property of an edge, or what the arc_map gives, must be or derive "
                  "from Reeb_arc");
    return get(m_arc_map, e);
  }

private:
  const Graph& m_graph;
  NodeMap m_node_map;
  ArcMap m_arc_map;
  Number_of_node m_number_of_node;
};

template <class Graph, class NamedParameters>
auto reeb_graph_reader(const Graph& graph, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Node = typename boost::graph_traits<Graph>::vertex_descriptor;
  using Arc = typename boost::graph_traits<Graph>::edge_descriptor;
  const auto node_map =
    choose_parameter(get_parameter(np, internal_np::node_map), Bundle_reader<Graph, Node>{&graph});
  const auto arc_map =
    choose_parameter(get_parameter(np, internal_np::arc_map), Bundle_reader<Graph, Arc>{&graph});
  return Reeb_graph_reader<Graph, std::decay_t<decltype(node_map)>,
                           std::decay_t<decltype(arc_map)>>(graph, node_map, arc_map);
}

template <class Point, class TriangleMesh>
Reeb_node<Point> node_of_reeb_graph(const Loop_system<TriangleMesh>& system,
                                    const Reeb_graph_embedding<Point>& embedding,
                                    std::size_t node)
{
  Reeb_node<Point> result;
  result.id = node;
  result.genus = system.genus(node);
  result.pole = system.pole(node);
  const bool is_regular = system.degree(node) == 2 && result.genus == 0;
  if (result.pole >= 0)
    result.kind = system.is_border_pole(static_cast<std::size_t>(result.pole)) ? Node_kind::BOUNDARY
                                                                               : Node_kind::POLE;
  else
    result.kind = is_regular ? Node_kind::REGULAR : Node_kind::SADDLE;
  result.point = embedding.node_points[node];
  result.radius = embedding.node_radii[node];
  return result;
}

template <class Point, class TriangleMesh>
Reeb_arc<Point> arc_of_reeb_graph(const Measured_foliation<TriangleMesh>& foliation,
                                  const Reeb_graph_embedding<Point>& embedding,
                                  std::size_t arc,
                                  double area)
{
  Reeb_arc<Point> result;
  result.loop = arc;
  result.height = foliation.system().height(arc);
  result.flux = foliation.flux(arc);
  result.polyline = embedding.arc_polylines[arc];
  result.component = component_kind(foliation.system(), arc);
  result.radii.push_back(embedding.node_radii[foliation.system().node(arc, 0)]);
  result.radii.insert(result.radii.end(), embedding.leaf_radii[arc].begin(),
                      embedding.leaf_radii[arc].end());
  result.radii.push_back(embedding.node_radii[foliation.system().node(arc, 1)]);
  result.area = area;
  return result;
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationGraph

appends the Reeb graph of a foliation to a graph [Section 5.3 of the paper]: a node for each
critical leaf and an arc for each surface component, with a given embedding.

\tparam TriangleMesh see `Loop_system`
\tparam Point the point type, `Loop_system<TriangleMesh>::Point`
\tparam Graph a model of `boost::MutableGraph` that allows parallel edges and self-loops. If its
  bundled vertex and edge properties can be assigned from `Reeb_node<Point>` and `Reeb_arc<Point>`,
  like those of `Reeb_graph<Point>`, or derive from them, they are set; members that a derived type
  adds are left alone. Bundled properties of any other type are left alone entirely. Those that
  derive from a node or an arc but cannot be assigned, for instance because the point types differ,
  are rejected at compile time.
\param foliation the foliation
\param graph the graph to append to
\param embedding its embedding, from `reeb_graph_embedding()`
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
  below

\cgalNamedParamsBegin
  \cgalParamNBegin{node_map}
    \cgalParamDescription{a property map to which the nodes are written}
    \cgalParamType{a class model of `WritablePropertyMap` with
      `boost::graph_traits<Graph>::%vertex_descriptor` as key type and `Reeb_node<Point>` as value
      type}
    \cgalParamDefault{the bundled properties, if they are or derive from nodes}
  \cgalParamNEnd
  \cgalParamNBegin{arc_map}
    \cgalParamDescription{a property map to which the arcs are written}
    \cgalParamType{a class model of `WritablePropertyMap` with
      `boost::graph_traits<Graph>::%edge_descriptor` as key type and `Reeb_arc<Point>` as value
      type}
    \cgalParamDefault{the bundled properties, if they are or derive from arcs}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns the vertex descriptors of the nodes, by their number in the loop system

If anything is thrown, `graph` is unchanged.

The time is linear in the sizes of the result and of the mesh.
*/
template <class TriangleMesh,
          class Point,
          class Graph,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<typename boost::graph_traits<Graph>::vertex_descriptor> reeb_graph(
  const Measured_foliation<TriangleMesh>& foliation,
  Graph& graph,
  const Reeb_graph_embedding<Point>& embedding,
  const NamedParameters& np = CGAL::parameters::default_values())
{
  static_assert(internal::Allows_parallel_edges<Graph>::value,
                "a Reeb graph needs a graph type that allows parallel edges and self-loops");
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  internal::check_parameters<internal::Graph_map_parameters>(np);
  using Node = typename boost::graph_traits<Graph>::vertex_descriptor;
  using Arc = typename boost::graph_traits<Graph>::edge_descriptor;

  const auto nodes = choose_parameter(get_parameter(np, internal_np::node_map),
                                      internal::Bundle_map<Graph, Node, Reeb_node<Point>>{&graph});
  const auto arcs = choose_parameter(get_parameter(np, internal_np::arc_map),
                                     internal::Bundle_map<Graph, Arc, Reeb_arc<Point>>{&graph});
  const Loop_system<TriangleMesh>& system = foliation.system();
  // All is computed before the graph is touched.
  const std::vector<double> areas = internal::areas_of_components(
    foliation.extraction().refined_mesh, foliation.extraction().leaf_graph,
    foliation.state().system().number_of_arcs());
  std::vector<Reeb_node<Point>> values_of_nodes;
  for (std::size_t r = 0; r < system.number_of_nodes(); ++r)
    values_of_nodes.push_back(internal::node_of_reeb_graph(system, embedding, r));
  std::vector<Reeb_arc<Point>> values_of_arcs;
  for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
    values_of_arcs.push_back(internal::arc_of_reeb_graph(foliation, embedding, a, areas[a]));
  internal::Added_nodes<Graph> added(graph, values_of_nodes.size());
  for (const Reeb_node<Point>& value : values_of_nodes)
    put(nodes, added.add(), value);
  for (std::size_t a = 0; a < values_of_arcs.size(); ++a)
  {
    const Arc arc = add_edge(added[system.node(a, 0)], added[system.node(a, 1)], graph).first;
    put(arcs, arc, values_of_arcs[a]);
  }
  return added.keep();
}

/*!
\ingroup PkgSurfaceMeshFoliationGraph

appends the Reeb graph of a foliation to a graph, with the embedding that `reeb_graph_embedding()`
computes.

\param foliation the foliation
\param graph the graph to append to
\param np an optional sequence of named parameters: those of `reeb_graph_embedding()` and of the
  overload
  that takes an embedding

\returns the vertex descriptors of the nodes, by their number in the loop system
*/
template <class TriangleMesh,
          class Graph,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<typename boost::graph_traits<Graph>::vertex_descriptor> reeb_graph(
  const Measured_foliation<TriangleMesh>& foliation,
  Graph& graph,
  const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_parameters<internal::Reeb_graph_parameters>(np);
  const auto embedding =
    reeb_graph_embedding(foliation, internal::select<internal::Embedding_parameters>(np));
  return reeb_graph(foliation, graph, embedding,
                    internal::select<internal::Graph_map_parameters>(np));
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_REEB_GRAPH_H
