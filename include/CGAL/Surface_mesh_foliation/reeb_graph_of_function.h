// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_REEB_GRAPH_OF_FUNCTION_H
#define CGAL_SURFACE_MESH_FOLIATION_REEB_GRAPH_OF_FUNCTION_H

#include <CGAL/Surface_mesh_foliation/Critical_kind.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/Added_nodes.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/Flat_scalar_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Mesh_index.h>
#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/Vertex_order.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/flat_surface.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/require_parameter.h>
#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/scalar_reeb_graph_of_flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/// \ingroup PkgSurfaceMeshFoliationGraph
/// holds the properties of a node of the Reeb graph of a function, a critical vertex.
template <class TriangleMesh>
struct Scalar_reeb_node
{
  /// the critical vertex
  typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex;

  double value = 0;                           ///< the value there
  Critical_kind kind = Critical_kind::SADDLE; ///< what kind of vertex it is

  /// for a saddle, one less than the number of wedges of lower neighbors around the vertex; less if
  /// part of the saddle has been unfolded into other nodes, or simplified away. 0 for an extremum.
  std::size_t multiplicity = 0;

  /// the genus of the surface near the critical level, which the graph cannot show; 0 if saddles
  /// are unfolded
  std::size_t genus = 0;
};

/// \ingroup PkgSurfaceMeshFoliationGraph
/// holds the properties of an arc of the Reeb graph of a function, a family of contours. The source
/// of an arc, as added to the graph, is its lower node.
struct Scalar_reeb_arc
{
  double lower = 0; ///< the value at its lower end
  double upper = 0; ///< the value at its upper end, not less than `lower`

  /// the number of vertices of the mesh on the arc; those of nodes are not counted
  std::size_t number_of_vertices = 0;
};

/// \ingroup PkgSurfaceMeshFoliationGraph
/// is the default type of the Reeb graph of a function.
template <class TriangleMesh>
using Scalar_reeb_graph = boost::adjacency_list<boost::vecS,
                                                boost::vecS,
                                                boost::undirectedS,
                                                Scalar_reeb_node<TriangleMesh>,
                                                Scalar_reeb_arc>;

namespace internal {

template <class TriangleMesh, class VertexScalarMap>
Vertex_order vertex_order(const Mesh_index<TriangleMesh>& index,
                          int number_of_vertices,
                          VertexScalarMap function)
{
  std::vector<double> values(number_of_vertices);
  for (int v = 0; v < number_of_vertices; ++v)
    values[v] = CGAL::to_double(get(function, index.vertex(v)));
  return Vertex_order(std::move(values));
}

template <class NamedParameters>
std::optional<double> persistence_parameter(const NamedParameters& np)
{
  using Tag = internal_np::persistence_t;
  if constexpr (CGAL::parameters::is_default_parameter<NamedParameters, Tag>::value)
    return std::nullopt;
  else
  {
    const double result = CGAL::to_double(CGAL::parameters::get_parameter(np, Tag()));
    require_parameter(result >= 0, "the persistence is ", std::to_string(result),
                      ", not at least 0");
    return result;
  }
}

template <class TriangleMesh>
Scalar_reeb_node<TriangleMesh> node_of_scalar_reeb_graph(const Flat_scalar_reeb_graph::Node& node,
                                                         const Mesh_index<TriangleMesh>& index,
                                                         const Vertex_order& order)
{
  Scalar_reeb_node<TriangleMesh> result;
  result.vertex = index.vertex(node.vertex);
  result.value = order.value(node.vertex);
  result.kind = node.kind;
  result.multiplicity = static_cast<std::size_t>(node.multiplicity);
  result.genus = static_cast<std::size_t>(node.genus);
  return result;
}

inline Scalar_reeb_arc arc_of_scalar_reeb_graph(const Flat_scalar_reeb_graph& graph,
                                                const Flat_scalar_reeb_graph::Arc& arc,
                                                const Vertex_order& order)
{
  Scalar_reeb_arc result;
  result.lower = order.value(graph.nodes[arc.lower].vertex);
  result.upper = order.value(graph.nodes[arc.upper].vertex);
  result.number_of_vertices = static_cast<std::size_t>(arc.number_of_vertices);
  return result;
}

template <class TriangleMesh, class Graph, class NodeMap, class ArcMap, class VertexToArcMap>
std::vector<typename boost::graph_traits<Graph>::vertex_descriptor> append_scalar_reeb_graph(
  const Flat_scalar_reeb_graph& reeb,
  const Mesh_index<TriangleMesh>& index,
  const Vertex_order& order,
  Graph& graph,
  NodeMap nodes,
  ArcMap arcs,
  VertexToArcMap vertex_to_arc)
{
  Added_nodes<Graph> added(graph, reeb.nodes.size());
  for (const Flat_scalar_reeb_graph::Node& node : reeb.nodes)
    put(nodes, added.add(), node_of_scalar_reeb_graph(node, index, order));
  std::vector<typename boost::graph_traits<Graph>::edge_descriptor> arc_descriptors;
  for (const Flat_scalar_reeb_graph::Arc& arc : reeb.arcs)
  {
    arc_descriptors.push_back(add_edge(added[arc.lower], added[arc.upper], graph).first);
    put(arcs, arc_descriptors.back(), arc_of_scalar_reeb_graph(reeb, arc, order));
  }
  for (int v = 0; v < order.size(); ++v)
    put(vertex_to_arc, index.vertex(v), arc_descriptors[reeb.arc_of_vertex[v]]);
  return added.keep();
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationGraph

appends to a graph the Reeb graph of the piecewise linear function that is given by its values at
the vertices of a closed surface: a node for each critical vertex, and an arc for each family of
contours (connected components of level sets) between them.

Any finite function will do. Of two vertices with the same value, the one that comes first in
`vertices(mesh)` counts as lower; so a plateau becomes a slope, and no two critical vertices are at
the same level. Only comparisons of values decide: there is no tolerance. Where values are equal,
the graph may have arcs of span 0, which `persistence(0)` removes.

A saddle of multiplicity \f$ m \f$, with \f$ m + 1 \f$ wedges of lower neighbors, is unfolded into
\f$ m \f$ simple ones at the same vertex, each of which has three arcs. Then the graph has exactly
\f$ g \f$ independent cycles on a surface of genus \f$ g \f$ \cgalCite{cehnp-lrg2m-04}, and its arcs
cut the surface into planar pieces. With `unfold_saddles(false)` they form one node with all the
arcs, as in the quotient space of the surface that Reeb defined; then some handles can hide in
saddles (a torus may have just a minimum, a maximum and a saddle of multiplicity 2), and \f$ g \f$
is the number of cycles and the sum of `Scalar_reeb_node::genus`.

\tparam TriangleMesh a model of `FaceListGraph` and `VertexListGraph`
\tparam VertexScalarMap a model of `ReadablePropertyMap` with
  `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a number type as value
  type. Values are converted to `double`.
\tparam Graph a model of `boost::MutableGraph` that allows parallel edges. If its bundled vertex and
  edge properties can be assigned from `Scalar_reeb_node<TriangleMesh>` and `Scalar_reeb_arc`, as
  those of `Scalar_reeb_graph<TriangleMesh>`, they are set.
\param mesh a closed connected triangle mesh. The positions of its vertices do not matter.
\param function the values, finite
\param graph the graph to append to
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
  below

\cgalNamedParamsBegin
  \cgalParamNBegin{persistence}
    \cgalParamDescription{simplifies the graph: consider the arcs that join an extremum to a saddle
      with another arc on the same side, and whose difference of values is at most this number. As
      long as there are any, the one with the least difference is removed with both its ends, and
      the other two arcs of the saddle become one \cgalCite{csv-sfilgm-04}, to which its vertices
      are given. Cycles remain.}
    \cgalParamType{a number type, in the unit of the function, at least 0}
    \cgalParamDefault{no simplification}
  \cgalParamNEnd
  \cgalParamNBegin{unfold_saddles}
    \cgalParamDescription{whether a saddle of multiplicity \f$ m \f$ becomes \f$ m \f$ nodes}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_to_arc_map}
    \cgalParamDescription{a property map to which the arc of each vertex of `mesh` is written. The
      vertex of a node gets one of the arcs at its nodes.}
    \cgalParamType{a class model of `WritablePropertyMap` with
      `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and
      `boost::graph_traits<Graph>::%edge_descriptor` as value type}
    \cgalParamDefault{nothing is written}
  \cgalParamNEnd
  \cgalParamNBegin{node_map}
    \cgalParamDescription{a property map to which the nodes are written}
    \cgalParamType{a class model of `WritablePropertyMap` with
      `boost::graph_traits<Graph>::%vertex_descriptor` as key type and
      `Scalar_reeb_node<TriangleMesh>` as value type}
    \cgalParamDefault{the bundled properties, if they fit}
  \cgalParamNEnd
  \cgalParamNBegin{arc_map}
    \cgalParamDescription{a property map to which the arcs are written}
    \cgalParamType{a class model of `WritablePropertyMap` with
      `boost::graph_traits<Graph>::%edge_descriptor` as key type and `Scalar_reeb_arc` as value
      type}
    \cgalParamDefault{the bundled properties, if they fit}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns the vertex descriptors of the nodes, in ascending order of their vertices on the mesh by
  value, and by position in `vertices(mesh)` where values are equal; nodes at the same vertex from
  below

\throws Invalid_mesh_exception if the mesh is not a closed connected triangle mesh
\throws Invalid_parameter_exception if a value is not finite (the exception names the first such
  vertex), or the persistence is negative or not a number

If anything is thrown, `graph` is unchanged.

The time is \f$ O(n \log n) \f$ in the worst case and the memory \f$ O(n) \f$, for a mesh with
\f$ n \f$ vertices.

\sa `isoline_loops()`
*/
template <class TriangleMesh,
          class VertexScalarMap,
          class Graph,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<typename boost::graph_traits<Graph>::vertex_descriptor> reeb_graph_of_function(
  const TriangleMesh& mesh,
  VertexScalarMap function,
  Graph& graph,
  const NamedParameters& np = CGAL::parameters::default_values())
{
  static_assert(internal::Allows_parallel_edges<Graph>::value,
                "a Reeb graph needs a graph type that allows parallel edges and self-loops");
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  internal::check_parameters<internal_np::persistence_t, internal_np::unfold_saddles_t,
                             internal_np::vertex_to_arc_map_t, internal::Graph_map_parameters>(np);
  using Node = typename boost::graph_traits<Graph>::vertex_descriptor;
  using Arc = typename boost::graph_traits<Graph>::edge_descriptor;
  using Vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  const std::optional<double> persistence = internal::persistence_parameter(np);
  const bool unfolds = choose_parameter(get_parameter(np, internal_np::unfold_saddles), true);
  const auto vertex_to_arc = choose_parameter(get_parameter(np, internal_np::vertex_to_arc_map),
                                              CGAL::Constant_property_map<Vertex, Arc>());
  const auto nodes =
    choose_parameter(get_parameter(np, internal_np::node_map),
                     internal::Bundle_map<Graph, Node, Scalar_reeb_node<TriangleMesh>>{&graph});
  const auto arcs = choose_parameter(get_parameter(np, internal_np::arc_map),
                                     internal::Bundle_map<Graph, Arc, Scalar_reeb_arc>{&graph});

  const internal::Mesh_index<TriangleMesh> index(mesh);
  const internal::Flat_mesh flat = internal::flat_surface(index);
  const internal::Vertex_order order =
    internal::vertex_order(index, flat.number_of_vertices(), function);
  const internal::Flat_scalar_reeb_graph reeb =
    internal::scalar_reeb_graph(flat, order, persistence, unfolds);
  if (internal::number_of_components(reeb) != 1)
    internal::throw_surface_problem(index);
  return internal::append_scalar_reeb_graph(reeb, index, order, graph, nodes, arcs, vertex_to_arc);
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_REEB_GRAPH_OF_FUNCTION_H
