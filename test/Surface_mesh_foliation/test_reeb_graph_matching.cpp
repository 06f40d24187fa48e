// Matching of Reeb graphs, against all permutations of the nodes and arcs of small graphs, and on
// the graphs of foliations.

#include <CGAL/Surface_mesh_foliation/internal/Graph_matcher.h>
#include <CGAL/Surface_mesh_foliation/internal/Labelled_graph.h>
#include <CGAL/Surface_mesh_foliation/internal/cheapest_assignment.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_matching.h>

#include "include/example_systems.h"
#include "include/test_models.h"
#include "include/test_random.h"

#include <CGAL/Simple_cartesian.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/vf2_sub_graph_iso.hpp>
#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace smf = CGAL::Surface_mesh_foliation;
using smf::internal::Assignment;
using smf::internal::Graph_matcher;
using smf::internal::Graph_matching;
using smf::internal::Labelled_graph;
using smf::parameters::use_pole_labels;
using smf_test::Example;
using smf_test::Mesh;
using smf_test::Random;
using smf_test::Solved_example;
namespace soups = smf_test::soups;

using Graph = smf::Reeb_graph<Mesh::Point>;
constexpr double infinity = std::numeric_limits<double>::infinity();

// the least of function(permutation) over all permutations of 0, ..., n - 1
template <class Function>
double least_over_permutations(std::size_t n, const Function& function)
{
  std::vector<std::size_t> permutation(n);
  std::iota(permutation.begin(), permutation.end(), std::size_t(0));
  double result = infinity;
  do
    result = (std::min)(result, function(permutation));
  while (std::next_permutation(permutation.begin(), permutation.end()));
  return result;
}

// ===  Assignments

TEST(Cheapest_assignment, is_the_best_of_all)
{
  Random random(1);
  int impossible = 0;
  for (int round = 0; round < 600; ++round)
  {
    const std::size_t n = random.index(7);
    std::vector<std::vector<double>> cost(n, std::vector<double>(n));
    for (auto& row : cost)
      for (double& c : row) // small integers: many ties
        c =
          random.index(3) == 0 ? infinity : static_cast<double>(random.index(round % 2 ? 4 : 999));
    const auto sum = [&](const auto& column_of_row) {
      double result = 0;
      for (std::size_t i = 0; i < n; ++i)
        result += cost[i][static_cast<std::size_t>(column_of_row[i])];
      return result;
    };
    const Assignment found = smf::internal::cheapest_assignment(
      n, [&](std::size_t i, std::size_t j) { return cost[i][j]; });
    const double expected = least_over_permutations(n, sum);
    EXPECT_EQ(found.cost, n == 0 ? 0 : expected);
    if (expected == infinity)
    {
      ++impossible;
      continue;
    }
    EXPECT_EQ(sum(found.column_of_row), found.cost);
    std::vector<int> columns = found.column_of_row;
    std::sort(columns.begin(), columns.end());
    for (std::size_t i = 0; i < n; ++i)
      EXPECT_EQ(columns[i], static_cast<int>(i));
  }
  EXPECT_GT(impossible, 50);
}

// ===  Random graphs

Labelled_graph random_graph(Random& random, std::size_t nodes, std::size_t arcs)
{
  Labelled_graph result;
  const std::size_t labels = 1 + random.index(2);
  for (std::size_t v = 0; v < nodes; ++v)
    result.labels.emplace_back(static_cast<int>(random.index(labels)), -1);
  for (std::size_t a = 0; a < arcs; ++a)
    result.arcs.push_back(
      {{static_cast<int>(random.index(nodes)), static_cast<int>(random.index(nodes))},
       {random.between(0, 1), random.between(0, 1), random.between(0, 1)}});
  return result;
}

// the same graph with nodes and arcs in another order, and other shares
Labelled_graph shuffled(const Labelled_graph& graph, Random& random, std::uint64_t seed)
{
  const auto place = Random(seed).permutation(graph.labels.size());
  const auto place_of_arc = Random(seed + 1).permutation(graph.arcs.size());
  Labelled_graph result = graph;
  for (std::size_t v = 0; v < graph.labels.size(); ++v)
    result.labels[place[v]] = graph.labels[v];
  for (std::size_t a = 0; a < graph.arcs.size(); ++a)
  {
    Labelled_graph::Arc& arc = result.arcs[place_of_arc[a]];
    arc = graph.arcs[a];
    for (int& node : arc.nodes)
      node = static_cast<int>(place[static_cast<std::size_t>(node)]);
    if (random.index(2) == 0)
      std::swap(arc.nodes[0], arc.nodes[1]);
    for (double& share : arc.shares)
      share += random.between(0, 0.5);
  }
  return result;
}

std::array<int, 2> sorted_nodes(std::array<int, 2> nodes)
{
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

double difference(const Labelled_graph::Arc& a, const Labelled_graph::Arc& b)
{
  double result = 0;
  for (std::size_t q = 0; q < a.shares.size(); ++q)
    result += std::abs(a.shares[q] - b.shares[q]);
  return result;
}

using Bundles = std::map<std::array<int, 2>, std::vector<std::size_t>>;

Bundles bundles(const Labelled_graph& graph, const std::vector<std::size_t>& map)
{
  Bundles result;
  for (std::size_t a = 0; a < graph.arcs.size(); ++a)
  {
    const auto& nodes = graph.arcs[a].nodes;
    result[sorted_nodes({static_cast<int>(map[static_cast<std::size_t>(nodes[0])]),
                         static_cast<int>(map[static_cast<std::size_t>(nodes[1])])})]
      .push_back(a);
  }
  return result;
}

// with nothing but permutations
double least_cost(const Labelled_graph& first, const Labelled_graph& second)
{
  if (first.labels.size() != second.labels.size() || first.arcs.size() != second.arcs.size())
    return infinity;
  std::vector<std::size_t> identity(second.labels.size());
  std::iota(identity.begin(), identity.end(), std::size_t(0));
  const Bundles others = bundles(second, identity);
  return least_over_permutations(first.labels.size(), [&](const std::vector<std::size_t>& map) {
    for (std::size_t v = 0; v < map.size(); ++v)
      if (first.labels[v] != second.labels[map[v]])
        return infinity;
    double cost = 0;
    for (const auto& bundle : bundles(first, map))
    {
      const auto& arcs = bundle.second;
      const auto other = others.find(bundle.first);
      if (other == others.end() || other->second.size() != arcs.size())
        return infinity;
      cost += least_over_permutations(arcs.size(), [&](const auto& permutation) {
        double sum = 0;
        for (std::size_t i = 0; i < permutation.size(); ++i)
          sum += difference(first.arcs[arcs[i]], second.arcs[other->second[permutation[i]]]);
        return sum;
      });
    }
    return cost;
  });
}

// With a vertex in the middle of each arc, a self-loop with two, the graph is simple, and that is
// what Boost.Graph's algorithm is for.
using Subdivided =
  boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, std::pair<int, int>>;

Subdivided subdivided(const Labelled_graph& graph)
{
  Subdivided result;
  for (const auto& label : graph.labels)
    add_vertex(label, result);
  for (const Labelled_graph::Arc& arc : graph.arcs)
  {
    const auto middle = add_vertex({99, 0}, result), other = add_vertex({99, 0}, result);
    add_edge(static_cast<std::size_t>(arc.nodes[0]), middle, result);
    add_edge(middle, other, result);
    add_edge(other, static_cast<std::size_t>(arc.nodes[1]), result);
  }
  return result;
}

struct Stop_at_once
{
  template <class Map, class Inverse_map>
  bool operator()(const Map&, const Inverse_map&) const
  {
    return false;
  }
};

bool is_isomorphic_to_boost(const Labelled_graph& first, const Labelled_graph& second)
{
  const Subdivided a = subdivided(first), b = subdivided(second);
  return boost::vf2_graph_iso(a, b, Stop_at_once(), get(boost::vertex_index, a),
                              get(boost::vertex_index, b), boost::vertex_order_by_mult(a),
                              boost::always_equivalent(),
                              [&](std::size_t u, std::size_t v) { return a[u] == b[v]; });
}

void expect_isomorphism(const Labelled_graph& first,
                        const Labelled_graph& second,
                        const Graph_matching& matching)
{
  std::vector<int> nodes = matching.node_of_node, arcs = matching.arc_of_arc;
  for (std::size_t v = 0; v < nodes.size(); ++v)
    EXPECT_EQ(first.labels[v], second.labels[static_cast<std::size_t>(nodes[v])]);
  double cost = 0;
  for (std::size_t a = 0; a < arcs.size(); ++a)
  {
    const auto& other = second.arcs[static_cast<std::size_t>(arcs[a])];
    const auto& ends = first.arcs[a].nodes;
    EXPECT_EQ(sorted_nodes({nodes[static_cast<std::size_t>(ends[0])],
                            nodes[static_cast<std::size_t>(ends[1])]}),
              sorted_nodes(other.nodes));
    cost += difference(first.arcs[a], other);
  }
  EXPECT_NEAR(matching.cost, cost, 1e-12);
  for (std::vector<int>* numbers : {&nodes, &arcs})
  {
    std::sort(numbers->begin(), numbers->end());
    for (std::size_t i = 0; i < numbers->size(); ++i)
      EXPECT_EQ((*numbers)[i], static_cast<int>(i)) << "one to one";
  }
}

TEST(Graph_matcher, finds_the_best_of_all_isomorphisms)
{
  Random random(2);
  int isomorphic = 0, others = 0;
  for (std::uint64_t round = 0; round < 1500; ++round)
  {
    const std::size_t nodes = 1 + random.index(5), arcs = random.index(7);
    const Labelled_graph first = random_graph(random, nodes, arcs);
    const Labelled_graph second =
      round % 2 == 0 ? shuffled(first, random, 17 * round) : random_graph(random, nodes, arcs);
    const double expected = least_cost(first, second);
    EXPECT_EQ(Graph_matcher(first, second).is_isomorphic(), expected < infinity);
    EXPECT_EQ(is_isomorphic_to_boost(first, second), expected < infinity);
    const std::optional<Graph_matching> found = Graph_matcher(first, second).cheapest_matching();
    ASSERT_EQ(found.has_value(), expected < infinity) << "round " << round;
    ++(found ? isomorphic : others);
    if (!found)
      continue;
    EXPECT_NEAR(found->cost, expected, 1e-12);
    expect_isomorphism(first, second, *found);
  }
  EXPECT_GT(isomorphic, 700);
  EXPECT_GT(others, 300);
}

// connected graphs as foliations have them: a few cycles, and trees
TEST(Graph_matcher, agrees_with_boost_on_larger_graphs)
{
  Random random(3);
  int isomorphic = 0;
  for (std::uint64_t round = 0; round < 300; ++round)
  {
    const std::size_t nodes = 6 + random.index(8);
    Labelled_graph first = random_graph(random, nodes, 3);
    for (std::size_t v = 1; v < nodes; ++v)
      first.arcs.push_back({{static_cast<int>(v), static_cast<int>(random.index(v))}, {}});
    Labelled_graph second = shuffled(first, random, 31 * round);
    if (round % 2 == 1) // one arc is moved
      second.arcs[random.index(3)].nodes[0] = static_cast<int>(random.index(nodes));
    const auto found = Graph_matcher(first, second).cheapest_matching();
    ASSERT_EQ(found.has_value(), is_isomorphic_to_boost(first, second)) << "round " << round;
    EXPECT_TRUE(found || round % 2 == 1);
    isomorphic += found.has_value();
    if (found)
      expect_isomorphism(first, second, *found);
  }
  EXPECT_LT(isomorphic, 250);
}

// 40! isomorphisms of the star, and (20! 2^20)^2 of the two brooms with double arcs
TEST(Graph_matcher, symmetric_trees_take_no_time)
{
  Random random(4);
  Labelled_graph star = random_graph(random, 1, 0), brooms = random_graph(random, 2, 0);
  brooms.labels[1] = brooms.labels[0];
  brooms.arcs.push_back({{0, 1}, {}});
  for (int i = 1; i <= 40; ++i)
  {
    star.labels.emplace_back(7, -1);
    star.arcs.push_back({{0, i}, {random.between(0, 1), 0, 0}});
    brooms.labels.emplace_back(7, -1);
    for (int twice : {0, 1})
      brooms.arcs.push_back({{i % 2, i + 1}, {0, random.between(0, twice), 0}});
  }
  for (const Labelled_graph& graph : {star, brooms})
  {
    const Labelled_graph other = shuffled(graph, random, 5);
    const auto found = Graph_matcher(graph, other).cheapest_matching();
    ASSERT_TRUE(found);
    expect_isomorphism(graph, other, *found);
  }
  // on a line the cheapest assignment keeps the order
  Labelled_graph moved = star;
  for (Labelled_graph::Arc& arc : moved.arcs)
    arc.shares[0] = 3 * arc.shares[0] + 1;
  double expected = 0;
  for (std::size_t a = 0; a < star.arcs.size(); ++a)
    expected += difference(star.arcs[a], moved.arcs[a]);
  EXPECT_NEAR(Graph_matcher(star, moved).cheapest_matching()->cost, expected, 1e-12);
}

// ===  The graphs of foliations

Graph graph_of(const Solved_example<>& example)
{
  Graph result;
  smf::reeb_graph(example.foliation, result);
  return result;
}

Graph graph_of(const Example& example)
{
  return graph_of(Solved_example<>(example));
}

// another pose: bent, and a little larger
Example bent(Example example)
{
  for (auto& p : example.soup.points)
    p = {1.2 * p[0], 1.2 * p[1], 1.2 * p[2] + 0.04 * p[0] * p[0]};
  return example;
}

std::vector<Example> examples_without_planes()
{
  std::vector<Example> result;
  for (const Example& example : smf_test::example_systems())
    if (std::none_of(example.items.begin(), example.items.end(),
                     [](const auto& item) { return item.kind == smf_test::Item::PLANE; }))
      result.push_back(example);
  return result;
}

// what arcs and nodes know that matching looks at, against the cut mesh and the embedding
TEST(Reeb_graphs, know_areas_and_radii)
{
  for (const Example& example : smf_test::example_systems())
  {
    SCOPED_TRACE(example.name);
    const Solved_example<> solved(example);
    const auto embedding =
      smf::reeb_graph_embedding(solved.foliation, smf::parameters::number_of_samples(3));
    Graph graph;
    smf::reeb_graph(solved.foliation, graph, embedding);
    Mesh cut;
    const auto component = cut.add_property_map<Mesh::Face_index, std::size_t>("f:c").first;
    smf::surface_components(solved.foliation, cut, smf::parameters::face_component_map(component));
    std::vector<double> area(num_edges(graph), 0);
    for (const auto f : faces(cut))
    {
      const auto h = halfedge(f, cut);
      area[component[f]] += CGAL::approximate_sqrt(
        CGAL::squared_area(cut.point(source(h, cut)), cut.point(target(h, cut)),
                           cut.point(target(next(h, cut), cut))));
    }
    for (const auto& e : boost::make_iterator_range(edges(graph)))
    {
      const std::size_t a = graph[e].loop;
      EXPECT_NEAR(graph[e].area, area[a], 1e-12 * area[a]);
      std::vector<double> radii = embedding.leaf_radii[a];
      radii.insert(radii.begin(), graph[source(e, graph)].radius);
      radii.push_back(graph[target(e, graph)].radius);
      EXPECT_EQ(graph[e].radii, radii);
    }
    for (const auto v : boost::make_iterator_range(vertices(graph)))
      EXPECT_EQ(graph[v].radius, embedding.node_radii[v]);
  }
}

TEST(Reeb_graphs, match_in_another_pose)
{
  for (const Example& example : examples_without_planes())
  {
    SCOPED_TRACE(example.name);
    const Graph first = graph_of(example), second = graph_of(bent(example));
    EXPECT_TRUE(smf::reeb_graphs_are_isomorphic(first, second));
    EXPECT_TRUE(smf::reeb_graphs_are_isomorphic(first, second, use_pole_labels(false)));
    const auto matching = smf::match_reeb_graphs(first, second);
    ASSERT_TRUE(matching);
    EXPECT_LT(matching->distance, 0.15);
    for (const double d :
         {matching->length_distance, matching->area_distance, matching->flux_distance})
    {
      EXPECT_GE(d, 0);
      EXPECT_LT(d, 0.3);
    }
    EXPECT_NEAR(matching->distance,
                (matching->length_distance + matching->area_distance + matching->flux_distance) / 3,
                1e-15);
    for (const auto& [u, v] : matching->nodes)
      EXPECT_EQ(first[u].pole, second[v].pole);
    EXPECT_NEAR(smf::match_reeb_graphs(second, first)->distance, matching->distance, 1e-14);
    EXPECT_EQ(smf::match_reeb_graphs(first, first)->distance, 0);
    const auto freely = smf::match_reeb_graphs(first, second, use_pole_labels(false));
    EXPECT_LE(freely->distance, matching->distance + 1e-14);
  }
}

// poles in another order: their numbers differ, and the shapes tell which is which
TEST(Reeb_graphs, poles_are_found_again_by_shape)
{
  const std::vector<std::size_t> tips = soups::limb_tips(5, 3);
  Example first = {"", soups::limbed_sphere(5, 3), smf_test::pole_items(tips)}, second = first;
  for (Example* example : {&first, &second}) // no two limbs are alike
    for (auto& p : example->soup.points)
      p = {p[0] * (1 + 0.2 * p[0]), p[1] * (1.3 + 0.1 * p[1]), p[2] * (1.1 + 0.3 * p[2])};
  std::reverse(second.items.begin(), second.items.end());
  const Graph graph = graph_of(first), other = graph_of(second);
  const auto by_label = smf::match_reeb_graphs(graph, other);
  const auto by_shape = smf::match_reeb_graphs(graph, other, use_pole_labels(false));
  ASSERT_TRUE(by_label && by_shape);
  EXPECT_GT(by_label->distance, 0.01);
  EXPECT_LT(by_shape->distance, 1e-6);
  for (const auto& [u, v] : by_shape->nodes)
    EXPECT_EQ(graph[u].pole, graph[u].pole < 0 ? other[v].pole : 4 - other[v].pole);
  for (const auto& [e, f] : by_shape->arcs)
    EXPECT_NEAR(graph[e].area, other[f].area, 1e-6 * graph[e].area);
}

TEST(Reeb_graphs, of_different_systems_differ)
{
  const Graph theta = graph_of(smf_test::theta_example());
  const Graph dumbbell = graph_of(smf_test::dumbbell_example());
  ASSERT_EQ(num_vertices(theta), num_vertices(dumbbell));
  ASSERT_EQ(num_edges(theta), num_edges(dumbbell));
  EXPECT_FALSE(smf::reeb_graphs_are_isomorphic(theta, dumbbell)) << "self-arcs or parallel ones";
  EXPECT_FALSE(smf::match_reeb_graphs(theta, dumbbell));
  std::vector<Graph> graphs;
  for (const Example& example : smf_test::example_systems())
    graphs.push_back(graph_of(example));
  std::size_t pairs = 0;
  for (const Graph& a : graphs)
    for (const Graph& b : graphs)
      pairs += smf::reeb_graphs_are_isomorphic(a, b);
  EXPECT_EQ(pairs, graphs.size() + 2) << "the line pole and the other torus with pole and loop";
}

TEST(Reeb_graphs, kinds_and_labels_count)
{
  Graph path;
  for (int i = 0; i < 3; ++i)
    add_vertex(path);
  add_edge(0, 1, path);
  add_edge(1, 2, path);
  path[0].kind = path[2].kind = smf::Node_kind::POLE;
  path[0].pole = 0;
  path[2].pole = 1;
  Graph other = path;
  other[0].pole = 1;
  other[2].pole = 0;
  EXPECT_TRUE(smf::reeb_graphs_are_isomorphic(path, other));
  other[2].pole = 5;
  EXPECT_FALSE(smf::reeb_graphs_are_isomorphic(path, other));
  EXPECT_TRUE(smf::reeb_graphs_are_isomorphic(path, other, use_pole_labels(false)));
  other[1].kind = smf::Node_kind::REGULAR;
  EXPECT_FALSE(smf::reeb_graphs_are_isomorphic(path, other, use_pole_labels(false)));
  other[1].kind = smf::Node_kind::SADDLE;
  other[1].genus = 3;
  EXPECT_TRUE(smf::reeb_graphs_are_isomorphic(path, other, use_pole_labels(false)));
  EXPECT_TRUE(smf::reeb_graphs_are_isomorphic(Graph(), Graph()));
  EXPECT_EQ(smf::match_reeb_graphs(Graph(), Graph())->distance, 0);
  EXPECT_FALSE(smf::reeb_graphs_are_isomorphic(Graph(), path));
}

// the definition, on a graph that can be looked through
TEST(Reeb_graphs, distance_is_the_share_to_be_moved)
{
  Graph first;
  for (int i = 0; i < 4; ++i)
    add_vertex(first);
  for (std::size_t i : {1, 2, 3})
  {
    const auto e = add_edge(0, i, first).first;
    first[i].kind = smf::Node_kind::POLE;
    first[i].pole = static_cast<int>(i);
    first[e].polyline = {{0, 0, 0}, {1, 0, 0}};
    first[e].area = first[e].flux = 2;
  }
  Graph second = first;
  for (const auto& e : boost::make_iterator_range(edges(second))) // 1 : 1 : 2 instead of 1 : 1 : 1
  {
    second[e].flux *= target(e, second) == 3 ? 20 : 10;
    second[e].area = 0;
  }
  const auto matching = smf::match_reeb_graphs(first, second);
  ASSERT_TRUE(matching);
  EXPECT_EQ(matching->length_distance, 0);
  EXPECT_NEAR(matching->flux_distance, 1. / 2 - 1. / 3, 1e-15);
  EXPECT_NEAR(matching->area_distance, 1. / 2, 1e-15) << "where there is none, all is missing";
  for (const double bad : {-1., std::nan(""), infinity})
  {
    second[*edges(second).first].flux = bad;
    EXPECT_THROW(smf::match_reeb_graphs(first, second), smf::Invalid_parameter_exception);
    EXPECT_THROW(smf::match_reeb_graphs(second, first), smf::Invalid_parameter_exception);
  }
}

TEST(Reeb_graphs, distances_satisfy_the_triangle_inequality)
{
  Random random(6);
  const Graph base = graph_of(smf_test::example_systems()[0]);
  for (int round = 0; round < 50; ++round)
  {
    std::vector<Graph> graphs(3, base);
    for (Graph& graph : graphs)
      for (const auto& e : boost::make_iterator_range(edges(graph)))
      {
        graph[e].flux = random.between(0, 1);
        graph[e].area = random.between(0, 1);
        graph[e].polyline = {{0, 0, 0}, {random.between(0, 1), 0, 0}};
      }
    const auto distance = [&](int i, int j) {
      return smf::match_reeb_graphs(graphs[static_cast<std::size_t>(i)],
                                    graphs[static_cast<std::size_t>(j)], use_pole_labels(false))
        ->distance;
    };
    EXPECT_LE(distance(0, 2), distance(0, 1) + distance(1, 2) + 1e-14);
    EXPECT_LE(distance(0, 2), 1);
    EXPECT_NEAR(distance(0, 2), distance(2, 0), 1e-14);
  }
}

// ===  Types of graphs and meshes

TEST(Reeb_graphs, of_other_types_with_property_maps)
{
  // descriptors are pointers, and there are no bundled properties
  using List_graph = boost::adjacency_list<boost::listS, boost::listS, boost::undirectedS>;
  using Node = boost::graph_traits<List_graph>::vertex_descriptor;
  using Arc = boost::graph_traits<List_graph>::edge_descriptor;
  using smf::parameters::arc_map;
  using smf::parameters::combine;
  using smf::parameters::node_map;
  const Solved_example<> example(smf_test::dumbbell_example());
  const Graph expected = graph_of(example);
  List_graph graph;
  std::map<Node, smf::Reeb_node<Mesh::Point>> node;
  std::map<Arc, smf::Reeb_arc<Mesh::Point>> arc;
  const auto nodes = boost::make_assoc_property_map(node);
  const auto arcs = boost::make_assoc_property_map(arc);
  smf::reeb_graph(example.foliation, graph, combine(node_map(nodes), arc_map(arcs)));
  EXPECT_TRUE(smf::reeb_graphs_are_isomorphic(graph, expected, node_map(nodes)));
  EXPECT_TRUE(smf::reeb_graphs_are_isomorphic(expected, graph, combine(use_pole_labels(false)),
                                              node_map(nodes)));
  const auto matching = smf::match_reeb_graphs(expected, graph, CGAL::parameters::default_values(),
                                               combine(node_map(nodes), arc_map(arcs)));
  ASSERT_TRUE(matching);
  EXPECT_EQ(matching->distance, 0);
  for (const auto& [e, f] : matching->arcs)
    EXPECT_EQ(expected[e].loop, arc.at(f).loop);
}

template <class TriangleMesh>
class Matching_models : public ::testing::Test
{};

using Models = ::testing::Types<smf_test::Polyhedron_model<smf_test::Kernel>,
                                smf_test::Linear_cell_complex_model<smf_test::Kernel>,
                                smf_test::Surface_mesh_model<CGAL::Simple_cartesian<double>>>;
TYPED_TEST_SUITE(Matching_models, Models);

// genus 0, 1 and 2
TYPED_TEST(Matching_models, give_the_same_graphs)
{
  for (const Example& example : smf_test::example_systems())
    if (example.name == "limbs" || example.name == "torus with poles" || example.name == "dumbbell")
    {
      SCOPED_TRACE(example.name);
      const Solved_example<TypeParam> solved(example);
      smf::Reeb_graph<typename smf::Loop_system<TypeParam>::Point> graph;
      smf::reeb_graph(solved.foliation, graph);
      const auto matching = smf::match_reeb_graphs(graph, graph_of(example));
      ASSERT_TRUE(matching);
      EXPECT_EQ(matching->distance, 0);
      for (const auto& [u, v] : matching->nodes)
        EXPECT_EQ(u, v);
    }
}

} // namespace
