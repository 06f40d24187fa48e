// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Assignments and matchings of small graphs, against all permutations of columns, nodes and arcs,
// and of larger graphs against Boost.Graph.

#include <CGAL/Surface_mesh_foliation/internal/Matching/Graph_matcher.h>
#include <CGAL/Surface_mesh_foliation/internal/Matching/Labeled_graph.h>
#include <CGAL/Surface_mesh_foliation/internal/Matching/cheapest_assignment.h>

#include "generators/Random.h"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/vf2_sub_graph_iso.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace test_graph_matcher {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
using SMF::internal::Assignment;
using SMF::internal::Graph_matcher;
using SMF::internal::Graph_matching;
using SMF::internal::Labeled_graph;
using smf_test::Random;

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
    const Assignment found = SMF::internal::cheapest_assignment(
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

Labeled_graph random_graph(Random& random, std::size_t nodes, std::size_t arcs)
{
  Labeled_graph result;
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
Labeled_graph shuffled(const Labeled_graph& graph, Random& random, std::uint64_t seed)
{
  const auto place = Random(seed).permutation(graph.labels.size());
  const auto place_of_arc = Random(seed + 1).permutation(graph.arcs.size());
  Labeled_graph result = graph;
  for (std::size_t v = 0; v < graph.labels.size(); ++v)
    result.labels[place[v]] = graph.labels[v];
  for (std::size_t a = 0; a < graph.arcs.size(); ++a)
  {
    Labeled_graph::Arc& arc = result.arcs[place_of_arc[a]];
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

double difference(const Labeled_graph::Arc& a, const Labeled_graph::Arc& b)
{
  double result = 0;
  for (std::size_t q = 0; q < a.shares.size(); ++q)
    result += std::abs(a.shares[q] - b.shares[q]);
  return result;
}

using Bundles = std::map<std::array<int, 2>, std::vector<std::size_t>>;

Bundles bundles(const Labeled_graph& graph, const std::vector<std::size_t>& map)
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
double least_cost(const Labeled_graph& first, const Labeled_graph& second)
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

Subdivided subdivided(const Labeled_graph& graph)
{
  Subdivided result;
  for (const auto& label : graph.labels)
    add_vertex(label, result);
  for (const Labeled_graph::Arc& arc : graph.arcs)
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

bool is_isomorphic_to_boost(const Labeled_graph& first, const Labeled_graph& second)
{
  const Subdivided a = subdivided(first), b = subdivided(second);
  return boost::vf2_graph_iso(a, b, Stop_at_once(), get(boost::vertex_index, a),
                              get(boost::vertex_index, b), boost::vertex_order_by_mult(a),
                              boost::always_equivalent(),
                              [&](std::size_t u, std::size_t v) { return a[u] == b[v]; });
}

void expect_isomorphism(const Labeled_graph& first,
                        const Labeled_graph& second,
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
    const Labeled_graph first = random_graph(random, nodes, arcs);
    const Labeled_graph second =
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
    Labeled_graph first = random_graph(random, nodes, 3);
    for (std::size_t v = 1; v < nodes; ++v)
      first.arcs.push_back({{static_cast<int>(v), static_cast<int>(random.index(v))}, {}});
    Labeled_graph second = shuffled(first, random, 31 * round);
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
  Labeled_graph star = random_graph(random, 1, 0), brooms = random_graph(random, 2, 0);
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
  for (const Labeled_graph& graph : {star, brooms})
  {
    const Labeled_graph other = shuffled(graph, random, 5);
    const auto found = Graph_matcher(graph, other).cheapest_matching();
    ASSERT_TRUE(found);
    expect_isomorphism(graph, other, *found);
  }
  // on a line the cheapest assignment keeps the order
  Labeled_graph moved = star;
  for (Labeled_graph::Arc& arc : moved.arcs)
    arc.shares[0] = 3 * arc.shares[0] + 1;
  double expected = 0;
  for (std::size_t a = 0; a < star.arcs.size(); ++a)
    expected += difference(star.arcs[a], moved.arcs[a]);
  EXPECT_NEAR(Graph_matcher(star, moved).cheapest_matching()->cost, expected, 1e-12);
}

} // namespace

} // namespace test_graph_matcher
