// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/component_graph.h"
#include "include/example_systems.h"

#include <CGAL/Surface_mesh_foliation/reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_embedding.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/adjacency_matrix.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <string>

namespace test_reeb_graph {

namespace {

using smf_test::Example;
using smf_test::Mesh;
using smf_test::Solved_example;
namespace SMF = CGAL::Surface_mesh_foliation;

using Point = Mesh::Point;
using Node = SMF::Reeb_node<Point>;
using Arc = SMF::Reeb_arc<Point>;

// ===  Which graph types

template <class Out_edges, class Vertices, class Directed, class... Properties>
using List = boost::adjacency_list<Out_edges, Vertices, Directed, Properties...>;
using boost::bidirectionalS;
using boost::directedS;
using boost::listS;
using boost::undirectedS;
using boost::vecS;

template <class Graph>
constexpr bool is_allowed = SMF::internal::Allows_parallel_edges<Graph>::value;

static_assert(is_allowed<SMF::Reeb_graph<Point>>);
static_assert(is_allowed<List<vecS, vecS, directedS>>);
static_assert(is_allowed<List<listS, listS, bidirectionalS>>);
static_assert(is_allowed<List<boost::multisetS, vecS, undirectedS>>);
static_assert(!is_allowed<List<boost::setS, vecS, undirectedS>>);
static_assert(!is_allowed<List<boost::hash_setS, vecS, directedS>>);
static_assert(!is_allowed<boost::adjacency_matrix<undirectedS>>);
static_assert(!is_allowed<boost::adjacency_matrix<directedS>>);

// bundles of the user's that take from ours what they want
struct Own_node
{
  Own_node& operator=(const Node& node)
  {
    id = node.id;
    pole = node.pole;
    return *this;
  }
  std::size_t id = 99;
  int pole = 99;
};

struct Own_arc
{
  Own_arc& operator=(const Arc& arc)
  {
    loop = arc.loop;
    height = arc.height;
    return *this;
  }
  std::size_t loop = 99;
  double height = 99;
};

// bundles of the user's that derive from ours
struct Derived_node : Node
{
  std::string label = "mine";
};

struct Derived_arc : Arc
{
  int weight = 17;
};

using Derived_graph = List<vecS, vecS, undirectedS, Derived_node, Derived_arc>;

// ===  The graph is that of the components, with the numbers of the loop system

std::size_t id_of(const Node& node)
{
  return node.id;
}
std::size_t id_of(const Own_node& node)
{
  return node.id;
}

template <class Graph>
class Graph_types : public ::testing::Test
{};

using Bundled_graphs = ::testing::Types<SMF::Reeb_graph<Point>,
                                        List<vecS, vecS, directedS, Node, Arc>,
                                        List<vecS, vecS, bidirectionalS, Node, Arc>,
                                        List<listS, listS, undirectedS, Node, Arc>,
                                        List<listS, listS, bidirectionalS, Node, Arc>,
                                        List<vecS, listS, directedS, Node, Arc>,
                                        List<boost::multisetS, vecS, undirectedS, Node, Arc>,
                                        List<vecS, vecS, undirectedS, Own_node, Own_arc>,
                                        List<listS, listS, directedS, Own_node, Own_arc>,
                                        Derived_graph,
                                        List<listS, listS, directedS, Derived_node, Derived_arc>>;
TYPED_TEST_SUITE(Graph_types, Bundled_graphs);

TYPED_TEST(Graph_types, graph_is_that_of_the_components)
{
  for (const Example& one : smf_test::example_systems())
  {
    const Solved_example<> example(one);
    const SMF::Loop_system<Mesh>& system = example.system;
    TypeParam graph;
    const auto nodes = SMF::reeb_graph(example.foliation, graph);
    EXPECT_EQ(num_vertices(graph), system.number_of_nodes());
    EXPECT_EQ(num_edges(graph), system.number_of_arcs());
    ASSERT_EQ(nodes.size(), system.number_of_nodes());
    for (std::size_t r = 0; r < nodes.size(); ++r)
    {
      EXPECT_EQ(id_of(graph[nodes[r]]), r);
      EXPECT_EQ(graph[nodes[r]].pole, system.pole(r));
    }
    smf_test::Incidences arcs_at(nodes.size());
    for (const auto& e : boost::make_iterator_range(edges(graph)))
    {
      const std::size_t a = graph[e].loop;
      ASSERT_LT(a, system.number_of_arcs());
      EXPECT_EQ(graph[e].height, system.height(a));
      EXPECT_EQ(source(e, graph), nodes[system.node(a, 0)]);
      EXPECT_EQ(target(e, graph), nodes[system.node(a, 1)]);
      arcs_at[id_of(graph[source(e, graph)])].push_back(a);
      arcs_at[id_of(graph[target(e, graph)])].push_back(a);
    }
    const smf_test::Cut_mesh cut(example.foliation);
    EXPECT_EQ(smf_test::sorted(arcs_at), smf_test::Component_graph(cut).incidences()) << one.name;
  }
}

TYPED_TEST(Graph_types, graph_is_appended)
{
  const Solved_example<> example(smf_test::dumbbell_example());
  TypeParam graph;
  const auto old = add_vertex(graph);
  add_edge(old, old, graph);
  const auto first = SMF::reeb_graph(example.foliation, graph);
  const auto second = SMF::reeb_graph(example.foliation, graph);
  EXPECT_EQ(num_vertices(graph), 5u);
  EXPECT_EQ(num_edges(graph), 7u);
  EXPECT_EQ(id_of(graph[second[1]]), 1u);
  std::map<typename boost::graph_traits<TypeParam>::vertex_descriptor, std::size_t> arcs;
  for (const auto& e : boost::make_iterator_range(edges(graph)))
    ++arcs[source(e, graph)];
  EXPECT_EQ(arcs[old], 1u);
  EXPECT_EQ(arcs[first[0]] + arcs[first[1]], 3u);
  EXPECT_EQ(arcs[second[0]] + arcs[second[1]], 3u);
}

// ===  What nodes and arcs know

class Reeb_graph_of_example : public ::testing::TestWithParam<Example>
{
protected:
  Reeb_graph_of_example() : example(GetParam()) {}
  Solved_example<> example;
};

INSTANTIATE_TEST_SUITE_P(Examples,
                         Reeb_graph_of_example,
                         ::testing::ValuesIn(smf_test::all_example_systems()),
                         smf_test::name_of_example);

TEST_P(Reeb_graph_of_example, nodes_know_their_leaves)
{
  const SMF::Loop_system<Mesh>& system = example.system;
  const auto embedding = SMF::reeb_graph_embedding(example.foliation);
  SMF::Reeb_graph<Point> graph;
  SMF::reeb_graph(example.foliation, graph, embedding);
  for (const auto v : boost::make_iterator_range(vertices(graph)))
  {
    const Node& node = graph[v];
    EXPECT_EQ(node.id, v);
    EXPECT_EQ(node.genus, system.genus(v));
    EXPECT_EQ(node.pole, system.pole(v));
    EXPECT_EQ(node.point, embedding.node_points[v]);
    EXPECT_EQ(node.kind == SMF::Node_kind::POLE, node.pole >= 0);
    // saddles are needed unless the leaf is one closed curve
    EXPECT_EQ(node.kind == SMF::Node_kind::REGULAR, node.genus == 0 && degree(v, graph) == 2);
    EXPECT_EQ(degree(v, graph), system.degree(v));
  }
}

TEST_P(Reeb_graph_of_example, arcs_know_their_components)
{
  const SMF::Loop_system<Mesh>& system = example.system;
  const auto embedding = SMF::reeb_graph_embedding(example.foliation);
  SMF::Reeb_graph<Point> graph;
  SMF::reeb_graph(example.foliation, graph, embedding);
  for (const auto& e : boost::make_iterator_range(edges(graph)))
  {
    const Arc& arc = graph[e];
    EXPECT_EQ(arc.height, system.height(arc.loop));
    EXPECT_EQ(arc.flux, example.foliation.flux(arc.loop));
    EXPECT_EQ(arc.component, SMF::component_kind(system, arc.loop));
    EXPECT_EQ(arc.polyline, embedding.arc_polylines[arc.loop]);
    EXPECT_EQ(arc.polyline.front(), graph[source(e, graph)].point);
    EXPECT_EQ(arc.polyline.back(), graph[target(e, graph)].point);
  }
}

// ===  Bundles that derive from nodes and arcs

TEST_P(Reeb_graph_of_example, derived_bundles_are_filled_in_their_part)
{
  SMF::Reeb_graph<Point> expected;
  Derived_graph graph;
  SMF::reeb_graph(example.foliation, expected);
  SMF::reeb_graph(example.foliation, graph);
  ASSERT_EQ(num_vertices(graph), num_vertices(expected));
  ASSERT_EQ(num_edges(graph), num_edges(expected));
  for (const auto v : boost::make_iterator_range(vertices(graph)))
  {
    EXPECT_EQ(graph[v].label, "mine");
    EXPECT_EQ(graph[v].id, expected[v].id);
    EXPECT_EQ(graph[v].kind, expected[v].kind);
    EXPECT_EQ(graph[v].genus, expected[v].genus);
    EXPECT_EQ(graph[v].pole, expected[v].pole);
    EXPECT_EQ(graph[v].point, expected[v].point);
    EXPECT_EQ(graph[v].radius, expected[v].radius);
  }
  auto other = edges(expected).first;
  for (const auto& e : boost::make_iterator_range(edges(graph)))
  {
    EXPECT_EQ(graph[e].weight, 17);
    EXPECT_EQ(graph[e].loop, expected[*other].loop);
    EXPECT_EQ(graph[e].height, expected[*other].height);
    EXPECT_EQ(graph[e].flux, expected[*other].flux);
    EXPECT_EQ(graph[e].polyline, expected[*other].polyline);
    EXPECT_EQ(graph[e].component, expected[*other].component);
    EXPECT_EQ(graph[e].radii, expected[*other].radii);
    EXPECT_EQ(graph[e].area, expected[*other].area);
    ++other;
  }
}

} // namespace

} // namespace test_reeb_graph
