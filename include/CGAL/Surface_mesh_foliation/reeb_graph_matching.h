// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_REEB_GRAPH_MATCHING_H
#define CGAL_SURFACE_MESH_FOLIATION_REEB_GRAPH_MATCHING_H

#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Matching/Graph_matcher.h>
#include <CGAL/Surface_mesh_foliation/internal/Matching/Labeled_graph.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/Sum.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationMatching

is an isomorphism of two Reeb graphs, with the differences of what it matches; see
`match_reeb_graphs()`.

\tparam Graph1, Graph2 the types of the graphs
*/
template <class Graph1, class Graph2 = Graph1>
struct Reeb_graph_matching
{
  using Node_1 = typename boost::graph_traits<Graph1>::vertex_descriptor;
  using Node_2 = typename boost::graph_traits<Graph2>::vertex_descriptor;
  using Arc_1 = typename boost::graph_traits<Graph1>::edge_descriptor;
  using Arc_2 = typename boost::graph_traits<Graph2>::edge_descriptor;

  std::vector<std::pair<Node_1, Node_2>> nodes; ///< in the order of `vertices(graph1)`
  std::vector<std::pair<Arc_1, Arc_2>> arcs;    ///< in the order of `edges(graph1)`

  double distance = 0;        ///< the mean of the other three
  double length_distance = 0; ///< of the lengths of embedded arcs
  double area_distance = 0;   ///< of the areas of components
  double flux_distance = 0;   ///< of the fluxes of arcs
};

namespace internal {

// A graph with the labels of its nodes, and its descriptors by number.
template <class Graph>
struct Numbered_graph
{
  using Node = typename boost::graph_traits<Graph>::vertex_descriptor;
  using Arc = typename boost::graph_traits<Graph>::edge_descriptor;

  template <class NamedParameters>
  Numbered_graph(const Graph& graph, const NamedParameters& np, bool uses_pole_labels)
  {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    const auto map = choose_parameter(get_parameter(np, internal_np::node_map),
                                      Bundle_reader<Graph, Node>{&graph});
    std::map<Node, int> number;
    for (const Node v : boost::make_iterator_range(vertices(graph)))
    {
      number[v] = static_cast<int>(nodes.size());
      nodes.push_back(v);
      const auto& node = get(map, v);
      labeled.labels.emplace_back(static_cast<int>(node.kind), uses_pole_labels ? node.pole : -1);
    }
    for (const Arc& e : boost::make_iterator_range(edges(graph)))
    {
      arcs.push_back(e);
      labeled.arcs.push_back({{number[source(e, graph)], number[target(e, graph)]}, {}});
    }
  }

  template <class NamedParameters>
  void add_shares(const Graph& graph, const NamedParameters& np)
  {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    const auto map =
      choose_parameter(get_parameter(np, internal_np::arc_map), Bundle_reader<Graph, Arc>{&graph});
    for (std::size_t a = 0; a < arcs.size(); ++a)
    {
      const auto& arc = get(map, arcs[a]);
      labeled.arcs[a].shares = {length(arc.polyline), arc.area, arc.flux};
    }
    for (int q = 0; q < Labeled_graph::NUMBER_OF_QUANTITIES; ++q)
      turn_into_shares(q);
  }

  Labeled_graph labeled;
  std::vector<Node> nodes;
  std::vector<Arc> arcs;

private:
  void turn_into_shares(int quantity)
  {
    Sum sum;
    for (const Labeled_graph::Arc& arc : labeled.arcs)
    {
      if (!(arc.shares[quantity] >= 0))
        fail();
      sum.add(arc.shares[quantity]);
    }
    if (!std::isfinite(sum.value()))
      fail();
    if (sum.value() > 0)
      for (Labeled_graph::Arc& arc : labeled.arcs)
        arc.shares[quantity] /= sum.value();
  }

  [[noreturn]] static void fail()
  {
    throw Invalid_parameter_exception(
      problem(Problem_kind::INVALID_PARAMETER,
              "the length, area or flux of an arc of a Reeb graph is negative or not finite"));
  }
};

// half the sum of the differences of one quantity over matched arcs
inline double difference_of_shares(const Labeled_graph& first,
                                   const Labeled_graph& second,
                                   const Graph_matching& matching,
                                   int quantity)
{
  Sum sum;
  for (std::size_t a = 0; a < first.arcs.size(); ++a)
    sum.add(std::abs(first.arcs[a].shares[quantity] -
                     second.arcs[matching.arc_of_arc[a]].shares[quantity]));
  return sum.value() / 2;
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationMatching

returns whether two Reeb graphs are isomorphic: whether their nodes and arcs can be matched one to
one, so that matched arcs join matched nodes, and matched nodes have the same kind and the same
pole. Parallel arcs and arcs from a node to itself are taken into account; the genus and position of
nodes and the heights of arcs are not.

\tparam Graph1, Graph2 models of `boost::VertexListGraph` and `boost::EdgeListGraph`, undirected or
  treated as such, whose vertex descriptors can be compared by `<`
\param graph1, graph2 the graphs
\param np1, np2 optional sequences of \ref bgl_namedparameters "Named Parameters" among the ones
  listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{use_pole_labels}
    \cgalParamDescription{whether only poles of the same number match, rather than any two poles}
    \cgalParamType{Boolean}
    \cgalParamDefault{`true`}
    \cgalParamExtra{`np1` only}
  \cgalParamNEnd
  \cgalParamNBegin{node_map}
    \cgalParamDescription{a property map with the properties of the nodes}
    \cgalParamType{a class model of `ReadablePropertyMap` with the vertex descriptor of the graph as
      key type and a type with the members `kind` and `pole` of `Reeb_node` as value type}
    \cgalParamDefault{the bundled properties}
  \cgalParamNEnd
\cgalNamedParamsEnd

Time and memory are as for `match_reeb_graphs()`.
*/
template <class Graph1,
          class Graph2,
          class NamedParameters1 = CGAL::parameters::Default_named_parameters,
          class NamedParameters2 = CGAL::parameters::Default_named_parameters>
bool reeb_graphs_are_isomorphic(const Graph1& graph1,
                                const Graph2& graph2,
                                const NamedParameters1& np1 = CGAL::parameters::default_values(),
                                const NamedParameters2& np2 = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  internal::check_parameters<internal_np::use_pole_labels_t, internal_np::node_map_t>(np1);
  internal::check_parameters<internal_np::node_map_t>(np2);
  const bool uses_labels = choose_parameter(get_parameter(np1, internal_np::use_pole_labels), true);
  const internal::Numbered_graph<Graph1> first(graph1, np1, uses_labels);
  const internal::Numbered_graph<Graph2> second(graph2, np2, uses_labels);
  return internal::are_isomorphic(first.labeled, second.labeled);
}

/*!
\ingroup PkgSurfaceMeshFoliationMatching

matches the Reeb graphs of two shapes, such as two poses of one body, by the isomorphism for which
they differ least.

Three quantities of arcs are compared: the length of the embedded arc, the area of the component,
and the flux. Each is taken as a share \f$x_a\f$ of its sum over all arcs, so that the sizes of the
shapes and a common factor of all heights do not matter. Under a matching \f$\varphi\f$ they differ
by \f$\frac{1}{2} \sum_a |x_a - y_{\varphi(a)}|\f$, between 0 and 1: the share of one graph that
would have to be moved to obtain the other. `Reeb_graph_matching::distance` is the mean of these
three numbers, and the matching is one for which it is least. Since it adds up differences of
shares, the distance is symmetric and satisfies the triangle inequality. It is 0 for equal graphs;
but a distance of 0 does not mean that the shapes are equal.

\tparam Graph1, Graph2 see `reeb_graphs_are_isomorphic()`
\param graph1, graph2 the graphs
\param np1, np2 optional sequences of \ref bgl_namedparameters "Named Parameters": those of
  `reeb_graphs_are_isomorphic()` and the one listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{arc_map}
    \cgalParamDescription{a property map with the properties of the arcs}
    \cgalParamType{a class model of `ReadablePropertyMap` with the edge descriptor of the graph as
      key type and a type with the members `polyline`, `area` and `flux` of `Reeb_arc` as value
      type}
    \cgalParamDefault{the bundled properties}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns the matching, or nothing if the graphs are not isomorphic

\throws Invalid_parameter_exception if a length, area or flux is negative or not finite

Trees, parallel arcs and arcs from a node to itself take \f$O(n^2 d^3)\f$ time for \f$n\f$ nodes of
degree up to \f$d\f$, and \f$O(n^2)\f$ memory, however symmetric the graphs are. Once they are
removed, the nodes on and between cycles remain; `boost::vf2_graph_iso()` tries all isomorphisms of
these, which takes time proportional to their number.
*/
template <class Graph1,
          class Graph2,
          class NamedParameters1 = CGAL::parameters::Default_named_parameters,
          class NamedParameters2 = CGAL::parameters::Default_named_parameters>
std::optional<Reeb_graph_matching<Graph1, Graph2>> match_reeb_graphs(
  const Graph1& graph1,
  const Graph2& graph2,
  const NamedParameters1& np1 = CGAL::parameters::default_values(),
  const NamedParameters2& np2 = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  internal::check_parameters<internal::Graph_map_parameters, internal_np::use_pole_labels_t>(np1);
  internal::check_parameters<internal::Graph_map_parameters>(np2);
  const bool uses_labels = choose_parameter(get_parameter(np1, internal_np::use_pole_labels), true);
  internal::Numbered_graph<Graph1> first(graph1, np1, uses_labels);
  internal::Numbered_graph<Graph2> second(graph2, np2, uses_labels);
  first.add_shares(graph1, np1);
  second.add_shares(graph2, np2);
  const auto matching = internal::cheapest_matching(first.labeled, second.labeled);
  if (!matching)
    return std::nullopt;

  Reeb_graph_matching<Graph1, Graph2> result;
  for (std::size_t v = 0; v < first.nodes.size(); ++v)
    result.nodes.emplace_back(first.nodes[v], second.nodes[matching->node_of_node[v]]);
  for (std::size_t a = 0; a < first.arcs.size(); ++a)
    result.arcs.emplace_back(first.arcs[a], second.arcs[matching->arc_of_arc[a]]);
  double* const differences[] = {&result.length_distance, &result.area_distance,
                                 &result.flux_distance};
  for (int q = 0; q < internal::Labeled_graph::NUMBER_OF_QUANTITIES; ++q)
  {
    *differences[q] = internal::difference_of_shares(first.labeled, second.labeled, *matching, q);
    result.distance += *differences[q] / internal::Labeled_graph::NUMBER_OF_QUANTITIES;
  }
  return result;
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_REEB_GRAPH_MATCHING_H
