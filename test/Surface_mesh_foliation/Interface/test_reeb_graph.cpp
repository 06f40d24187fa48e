// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/component_graph.h"
#include "include/example_systems.h"

#include <CGAL/Surface_mesh_foliation/foliation_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_embedding.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/adjacency_matrix.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/graph/subgraph.hpp>
#include <boost/range/iterator_range.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_reeb_graph {

namespace {

using smf_test::Example;
using smf_test::Item;
using smf_test::Mesh;
using smf_test::Solved_example;
namespace SMF = CGAL::Surface_mesh_foliation;
namespace soups = smf_test::soups;

using Point = Mesh::Point;
using Node = SMF::Reeb_node<Point>;
using Arc = SMF::Reeb_arc<Point>;
using Foliation = SMF::Measured_foliation<Mesh>;

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

// ===  Graphs without bundles

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

// ===  One call

void expect_equal(const SMF::Reeb_graph<Point>& first, const SMF::Reeb_graph<Point>& second)
{
  ASSERT_EQ(num_vertices(first), num_vertices(second));
  ASSERT_EQ(num_edges(first), num_edges(second));
  for (const auto v : boost::make_iterator_range(vertices(first)))
  {
    EXPECT_EQ(first[v].point, second[v].point);
    EXPECT_EQ(first[v].kind, second[v].kind);
    EXPECT_EQ(first[v].pole, second[v].pole);
  }
  auto other = edges(second).first;
  for (const auto& e : boost::make_iterator_range(edges(first)))
  {
    EXPECT_EQ(source(e, first), source(*other, second));
    EXPECT_EQ(target(e, first), target(*other, second));
    EXPECT_EQ(first[e].loop, second[*other].loop);
    EXPECT_EQ(first[e].flux, second[*other].flux);
    EXPECT_EQ(first[e].polyline, second[*other].polyline);
    ++other;
  }
}

TEST_P(Reeb_graph_of_example, one_call_is_the_same_as_the_stages)
{
  SMF::Reeb_graph<Point> by_stages, by_one_call;
  SMF::reeb_graph(example.foliation, by_stages);
  const Foliation foliation = SMF::foliation_reeb_graph(*example.mesh, example.input, by_one_call);
  expect_equal(by_one_call, by_stages);
  EXPECT_EQ(foliation.statistics().energy, example.foliation.statistics().energy);
  EXPECT_EQ(&foliation.mesh(), example.mesh.get());
}

TEST(One_call, takes_a_range_of_poles)
{
  const Mesh mesh = smf_test::limbed_sphere(4, 3);
  std::vector<Mesh::Vertex_index> poles;
  SMF::Poles_and_loops<Mesh> input;
  for (const std::size_t tip : soups::limb_tips(4, 3))
  {
    poles.push_back(Mesh::Vertex_index(static_cast<Mesh::size_type>(tip)));
    input.add_pole(poles.back());
  }
  SMF::Reeb_graph<Point> first, second;
  SMF::foliation_reeb_graph(mesh, poles, first);
  SMF::foliation_reeb_graph(mesh, input, second);
  expect_equal(first, second);
  EXPECT_EQ(num_vertices(first), 5u);
}

TEST(One_call, passes_the_parameters_of_all_stages)
{
  const Solved_example<> example(smf_test::dumbbell_example());
  const auto weight =
    example.mesh->add_property_map<Mesh::Edge_index, double>("e:weight", 0.5).first;
  SMF::Reeb_graph<Point> by_stages, by_one_call;
  const Foliation foliation = SMF::harmonic_foliation(
    example.system, SMF::parameters::weights(weight).number_of_iterations(2));
  SMF::reeb_graph(foliation, by_stages, SMF::parameters::number_of_samples(5));
  const auto np = SMF::parameters::combine(
    SMF::parameters::number_of_samples(5).vertex_point_map(example.mesh->points()),
    SMF::parameters::weights(weight), CGAL::parameters::number_of_iterations(2));
  SMF::foliation_reeb_graph(*example.mesh, example.input, by_one_call, np);
  expect_equal(by_one_call, by_stages);
}

// ===  Exceptions leave the graph alone

template <class Call>
void expect_unchanged(const Call& call)
{
  SMF::Reeb_graph<Point> graph(2);
  graph[0].id = 17;
  add_edge(0, 1, graph);
  EXPECT_THROW(call(graph), SMF::Foliation_exception);
  EXPECT_EQ(num_vertices(graph), 2u);
  EXPECT_EQ(num_edges(graph), 1u);
  EXPECT_EQ(graph[0].id, 17u);
}

TEST(Exceptions_of_reeb_graph, leave_the_graph_unchanged)
{
  using Graph = SMF::Reeb_graph<Point>;
  const Solved_example<> example(smf_test::dumbbell_example());
  const Mesh& mesh = *example.mesh;
  const std::vector<Mesh::Vertex_index> twice(2, Mesh::Vertex_index(3)), none;
  expect_unchanged([&](Graph& graph) { SMF::foliation_reeb_graph(mesh, twice, graph); });
  expect_unchanged([&](Graph& graph) { SMF::foliation_reeb_graph(mesh, none, graph); });
  expect_unchanged([&](Graph& graph) { SMF::foliation_reeb_graph(Mesh(), twice, graph); });
  const auto few = SMF::parameters::number_of_samples(-1);
  expect_unchanged(
    [&](Graph& graph) { SMF::foliation_reeb_graph(mesh, example.input, graph, few); });
  expect_unchanged([&](Graph& graph) { SMF::reeb_graph(example.foliation, graph, few); });
  const auto bad_tolerance = SMF::parameters::tolerance(-1.);
  expect_unchanged(
    [&](Graph& graph) { SMF::foliation_reeb_graph(mesh, example.input, graph, bad_tolerance); });
  const auto zero = CGAL::Constant_property_map<Mesh::Edge_index, double>(0);
  expect_unchanged([&](Graph& graph) {
    SMF::foliation_reeb_graph(mesh, example.input, graph, SMF::parameters::weights(zero));
  });
}

} // namespace

} // namespace test_reeb_graph
