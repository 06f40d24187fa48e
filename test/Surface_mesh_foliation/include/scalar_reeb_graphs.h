// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_SCALAR_REEB_GRAPHS_H
#define SMF_TEST_SCALAR_REEB_GRAPHS_H

#include <CGAL/Surface_mesh_foliation/Critical_kind.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_of_function.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/range/iterator_range.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <map>
#include <vector>

// Reeb graphs of functions with vertices, nodes and arcs by number, whatever the type of the mesh,
// and what holds for those with unfolded saddles.

namespace smf_test {

struct Numbered_reeb_graph
{
  struct Node
  {
    std::size_t vertex;
    CGAL::Surface_mesh_foliation::Critical_kind kind;
    std::size_t multiplicity, genus;
  };
  struct Arc
  {
    std::size_t lower, upper; // nodes
    std::size_t number_of_vertices;
  };

  std::vector<Node> nodes;
  std::vector<Arc> arcs;
  std::vector<std::size_t> arc_of_vertex;

  std::array<std::size_t, 2> ends(std::size_t arc) const
  {
    return {nodes[arcs[arc].lower].vertex, nodes[arcs[arc].upper].vertex};
  }
  std::size_t number_of_cycles() const { return arcs.size() + 1 - nodes.size(); }
};

template <class TriangleMesh, class NamedParameters>
Numbered_reeb_graph reeb_graph(const TriangleMesh& mesh,
                               const std::vector<double>& values,
                               const NamedParameters& np)
{
  namespace SMF = CGAL::Surface_mesh_foliation;
  using Graph = SMF::Scalar_reeb_graph<TriangleMesh>;
  std::map<typename boost::graph_traits<TriangleMesh>::vertex_descriptor, std::size_t> number;
  std::map<typename boost::graph_traits<TriangleMesh>::vertex_descriptor, double> function;
  for (const auto v : vertices(mesh))
  {
    const std::size_t i = number.size();
    number[v] = i;
    function[v] = values[i];
  }
  Graph graph;
  std::map<typename boost::graph_traits<TriangleMesh>::vertex_descriptor,
           typename boost::graph_traits<Graph>::edge_descriptor>
    arc_of_vertex;
  const auto nodes = SMF::reeb_graph_of_function(
    mesh, boost::make_assoc_property_map(function), graph,
    SMF::parameters::combine(
      np, SMF::parameters::vertex_to_arc_map(boost::make_assoc_property_map(arc_of_vertex))));
  EXPECT_EQ(nodes.size(), num_vertices(graph));

  Numbered_reeb_graph result;
  for (const auto node : nodes)
  {
    result.nodes.push_back({number.at(graph[node].vertex), graph[node].kind,
                            graph[node].multiplicity, graph[node].genus});
    EXPECT_EQ(graph[node].value, function.at(graph[node].vertex));
  }
  std::map<const void*, std::size_t> number_of_arc;
  for (const auto& arc : boost::make_iterator_range(edges(graph)))
  {
    number_of_arc[&graph[arc]] = result.arcs.size();
    result.arcs.push_back({source(arc, graph), target(arc, graph), graph[arc].number_of_vertices});
    EXPECT_EQ(graph[arc].lower, graph[source(arc, graph)].value);
    EXPECT_EQ(graph[arc].upper, graph[target(arc, graph)].value);
  }
  for (const auto v : vertices(mesh))
    result.arc_of_vertex.push_back(number_of_arc.at(&graph[arc_of_vertex.at(v)]));
  return result;
}

template <class TriangleMesh>
Numbered_reeb_graph reeb_graph(const TriangleMesh& mesh, const std::vector<double>& values)
{
  return reeb_graph(mesh, values, CGAL::parameters::default_values());
}

// the number of arcs at each node below and above it
inline std::vector<std::array<int, 2>> degrees(const Numbered_reeb_graph& result)
{
  std::vector<std::array<int, 2>> degree(result.nodes.size(), {{0, 0}});
  for (const Numbered_reeb_graph::Arc& arc : result.arcs)
  {
    ++degree[arc.lower][1];
    ++degree[arc.upper][0];
  }
  return degree;
}

inline void expect_simple_saddles(const Numbered_reeb_graph& result)
{
  using Kind = CGAL::Surface_mesh_foliation::Critical_kind;
  const auto degree = degrees(result);
  for (std::size_t i = 0; i < degree.size(); ++i)
  {
    const Numbered_reeb_graph::Node& node = result.nodes[i];
    EXPECT_EQ(node.genus, 0u);
    EXPECT_EQ(node.multiplicity, node.kind == Kind::SADDLE ? 1u : 0u);
    EXPECT_EQ(degree[i][0] + degree[i][1], node.kind == Kind::SADDLE ? 3 : 1);
    EXPECT_EQ(degree[i][0] == 0, node.kind == Kind::MINIMUM);
    EXPECT_EQ(degree[i][1] == 0, node.kind == Kind::MAXIMUM);
  }
}

} // namespace smf_test

#endif // SMF_TEST_SCALAR_REEB_GRAPHS_H
