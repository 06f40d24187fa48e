// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Reeb graphs in graphs without bundles, and in property maps.

#include "include/example_systems.h"

#include <CGAL/Surface_mesh_foliation/reeb_graph.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/graph/subgraph.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/range/iterator_range.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace test_reeb_graph_in_maps {

namespace {

using smf_test::Mesh;
using smf_test::Solved_example;
namespace SMF = CGAL::Surface_mesh_foliation;

using Point = Mesh::Point;
using Node = SMF::Reeb_node<Point>;
using Arc = SMF::Reeb_arc<Point>;

template <class Out_edges, class Vertices, class Directed, class... Properties>
using List = boost::adjacency_list<Out_edges, Vertices, Directed, Properties...>;
using boost::bidirectionalS;
using boost::directedS;
using boost::listS;
using boost::undirectedS;
using boost::vecS;

// appends to a vector what is put
template <class Key, class Value>
struct Recorder
{
  using key_type = Key;
  using value_type = Value;
  using reference = void;
  using category = boost::writable_property_map_tag;
  std::vector<std::pair<Key, Value>>* record;
  friend void put(const Recorder& map, const Key& key, const Value& value)
  {
    map.record->emplace_back(key, value);
  }
};

template <class Graph>
void record_nodes_and_arcs()
{
  using Vertex = typename boost::graph_traits<Graph>::vertex_descriptor;
  using Edge = typename boost::graph_traits<Graph>::edge_descriptor;
  const Solved_example<> example(smf_test::theta_example());
  std::vector<std::pair<Vertex, Node>> nodes;
  std::vector<std::pair<Edge, Arc>> arcs;
  Graph graph;
  const auto descriptors = SMF::reeb_graph(
    example.foliation, graph,
    SMF::parameters::combine(SMF::parameters::node_map(Recorder<Vertex, Node>{&nodes}),
                             SMF::parameters::arc_map(Recorder<Edge, Arc>{&arcs})));
  ASSERT_EQ(nodes.size(), 2u);
  ASSERT_EQ(arcs.size(), 3u);
  for (std::size_t r = 0; r < 2; ++r)
  {
    EXPECT_EQ(nodes[r].first, descriptors[r]);
    EXPECT_EQ(nodes[r].second.id, r);
  }
  for (std::size_t a = 0; a < 3; ++a)
  {
    EXPECT_EQ(arcs[a].second.loop, a);
    EXPECT_EQ(source(arcs[a].first, graph), descriptors[example.system.node(a, 0)]);
  }
}

TEST(Graphs_without_bundles, write_to_property_maps)
{
  record_nodes_and_arcs<List<vecS, vecS, undirectedS>>();
  record_nodes_and_arcs<List<listS, listS, directedS>>();
  record_nodes_and_arcs<List<vecS, listS, bidirectionalS>>();
  record_nodes_and_arcs<List<vecS, vecS, undirectedS, std::string, std::string>>();
}

// the least that a graph must be: no bundled types, no operator []
struct Pair_of_nodes
{
  std::size_t id, from, to;
};

struct Least_graph
{
  using vertex_descriptor = std::size_t;
  using edge_descriptor = Pair_of_nodes;
  using directed_category = boost::directed_tag;
  using edge_parallel_category = boost::allow_parallel_edge_tag;
  using traversal_category = boost::incidence_graph_tag;
  std::size_t number_of_nodes = 0;
  std::vector<Pair_of_nodes> arcs;
};

std::size_t add_vertex(Least_graph& graph)
{
  return graph.number_of_nodes++;
}
std::pair<Pair_of_nodes, bool> add_edge(std::size_t from, std::size_t to, Least_graph& graph)
{
  graph.arcs.push_back({graph.arcs.size(), from, to});
  return {graph.arcs.back(), true};
}
std::size_t source(const Pair_of_nodes& arc, const Least_graph&)
{
  return arc.from;
}

TEST(Graphs_without_bundles, need_no_bundled_types)
{
  record_nodes_and_arcs<Least_graph>();
  const Solved_example<> example(smf_test::theta_example());
  Least_graph graph;
  SMF::reeb_graph(example.foliation, graph);
  EXPECT_EQ(graph.number_of_nodes, 2u);
  EXPECT_EQ(graph.arcs.size(), 3u);
}

// boost::subgraph has bundled properties, but no nested types of their names
TEST(Graphs_without_bundles, bundles_need_no_nested_types)
{
  const Solved_example<> example(smf_test::theta_example());
  using Indexed = List<vecS, vecS, directedS, Node, boost::property<boost::edge_index_t, int, Arc>>;
  boost::subgraph<Indexed> graph;
  SMF::reeb_graph(example.foliation, graph);
  ASSERT_EQ(num_vertices(graph), 2u);
  ASSERT_EQ(num_edges(graph), 3u);
  EXPECT_EQ(graph[vertex(1, graph)].id, 1u);
  for (const auto& e : boost::make_iterator_range(edges(graph)))
    EXPECT_EQ(graph[e].height, 1);
}

TEST(Graphs_without_bundles, keep_the_connectivity_only)
{
  const Solved_example<> example(smf_test::theta_example());
  List<vecS, vecS, undirectedS> plain;
  SMF::reeb_graph(example.foliation, plain);
  EXPECT_EQ(out_degree(0, plain), 3u);
  List<vecS, vecS, directedS, std::string, std::string> with_other_bundles;
  SMF::reeb_graph(example.foliation, with_other_bundles);
  EXPECT_EQ(with_other_bundles[0], "");
  EXPECT_EQ(num_edges(with_other_bundles), 3u);
}

TEST(Graphs_without_bundles, maps_come_before_bundles)
{
  using Graph = SMF::Reeb_graph<Point>;
  using Vertex = boost::graph_traits<Graph>::vertex_descriptor;
  const Solved_example<> example(smf_test::theta_example());
  std::vector<std::pair<Vertex, Node>> nodes;
  Graph graph;
  SMF::reeb_graph(example.foliation, graph,
                  SMF::parameters::node_map(Recorder<Vertex, Node>{&nodes}));
  EXPECT_EQ(nodes.size(), 2u);
  EXPECT_EQ(graph[1].id, 0u) << "the bundle must not be written";
  EXPECT_EQ(graph[*edges(graph).first].height, 1) << "this bundle must be written";
}

} // namespace

} // namespace test_reeb_graph_in_maps
