// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Short leaves are taken away from the Reeb graph of a function, on graphs where it is known which
// ones, and what becomes of the arcs beside them.

#include <CGAL/Surface_mesh_foliation/Critical_kind.h>
#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/Flat_scalar_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/Leaf_pruning.h>
#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/Vertex_order.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <vector>

namespace test_leaf_pruning {

using namespace CGAL::Surface_mesh_foliation::internal;

namespace {

using Kind = CGAL::Surface_mesh_foliation::Critical_kind;
using Ints = std::vector<int>;

struct Graph_and_order
{
  Flat_scalar_reeb_graph graph;
  Vertex_order order;
};

// Node i is at vertex i, and one vertex more lies inside each arc; arcs are given by their nodes.
Graph_and_order graph_and_order(std::vector<double> values,
                                const std::vector<Kind>& kinds,
                                const std::vector<std::array<int, 2>>& arcs)
{
  Flat_scalar_reeb_graph graph;
  const int n = static_cast<int>(kinds.size());
  graph.arc_of_vertex.assign(kinds.size(), -1);
  for (int v = 0; v < n; ++v)
    graph.nodes.push_back({v, kinds[v], 0, kinds[v] == Kind::SADDLE, 0});
  for (const auto& [lower, upper] : arcs)
  {
    const int a = static_cast<int>(graph.arcs.size());
    graph.arcs.push_back({lower, upper, a, 0});
    graph.pieces.push_back({lower, upper, 0, -1, -1});
    graph.arc_of_vertex[lower] = graph.arc_of_vertex[upper] = a;
    graph.arc_of_vertex.push_back(a);
    values.push_back((values[lower] + values[upper]) / 2);
  }
  return {graph, Vertex_order(values)};
}

// the vertices at the ends of an arc, its pieces from below, and the vertices inside former arcs
struct Pruned_arc
{
  std::array<int, 2> ends;
  Ints pieces, former_arcs;

  bool operator==(const Pruned_arc& other) const
  {
    return ends == other.ends && pieces == other.pieces && former_arcs == other.former_arcs;
  }
};

std::vector<Pruned_arc> pruned(const Graph_and_order& input, double persistence)
{
  Flat_scalar_reeb_graph graph = input.graph;
  Leaf_pruning(graph, input.order, persistence);
  std::vector<Pruned_arc> result;
  std::set<int> nodes;
  for (const auto& arc : graph.arcs)
  {
    nodes.insert({arc.lower, arc.upper});
    result.push_back(
      {{graph.nodes.at(arc.lower).vertex, graph.nodes.at(arc.upper).vertex}, {}, {}});
    for (int p = arc.first_piece; p >= 0; p = graph.pieces[p].next)
      result.back().pieces.push_back(p);
  }
  EXPECT_EQ(nodes.size(), graph.nodes.size()) << "nodes that are left are at an arc";
  const std::size_t n = input.graph.nodes.size();
  for (std::size_t v = n; v < graph.arc_of_vertex.size(); ++v)
    result.at(graph.arc_of_vertex[v]).former_arcs.push_back(static_cast<int>(v - n));
  for (const auto& node : graph.nodes)
  {
    const auto& [lower, upper] = result.at(graph.arc_of_vertex[node.vertex]).ends;
    EXPECT_TRUE(lower == node.vertex || upper == node.vertex);
    EXPECT_EQ(node.kind, input.graph.nodes[node.vertex].kind);
  }
  return result;
}

// Saddle 2 joins the minima 0 and 1, saddle 3 has maximum 4 beside it, saddle 5 a branch which
// saddle 6 splits into maxima 7 and 8; two arcs go from saddle 9 to saddle 10, and one to maximum
// 11.
Graph_and_order branches_and_a_cycle()
{
  const Kind saddle = Kind::SADDLE, maximum = Kind::MAXIMUM;
  return graph_and_order({0, 1, 2, 3, 3.5, 4, 5, 5.75, 8, 9, 10, 20},
                         {Kind::MINIMUM, Kind::MINIMUM, saddle, saddle, maximum, saddle, saddle,
                          maximum, maximum, saddle, saddle, maximum},
                         {{0, 2},
                          {1, 2}, // span 1
                          {2, 3},
                          {3, 4}, // span 0.5
                          {3, 5},
                          {5, 6},
                          {5, 9},
                          {6, 7}, // span 0.75; then 5-6-8 is an arc of span 4
                          {6, 8},
                          {9, 10},
                          {9, 10},
                          {10, 11}});
}

void expect_pruned(double from, double below, const std::vector<Pruned_arc>& expected)
{
  const Graph_and_order input = branches_and_a_cycle();
  EXPECT_TRUE(pruned(input, from) == expected) << from;
  EXPECT_TRUE(pruned(input, std::nextafter(below, 0.)) == expected) << "just below " << below;
}

TEST(Leaf_pruning, takes_leaves_away_when_the_persistence_reaches_their_spans)
{
  const Pruned_arc leaf_1 = {{1, 2}, {1}, {1}}, u_9 = {{5, 9}, {6}, {6}};
  const Pruned_arc once = {{9, 10}, {9}, {9}}, twice = {{9, 10}, {10}, {10}};
  const Pruned_arc top = {{10, 11}, {11}, {11}};
  expect_pruned(0, 0.5,
                {{{0, 2}, {0}, {0}},
                 leaf_1,
                 {{2, 3}, {2}, {2}},
                 {{3, 4}, {3}, {3}},
                 {{3, 5}, {4}, {4}},
                 {{5, 6}, {5}, {5}},
                 u_9,
                 {{6, 7}, {7}, {7}},
                 {{6, 8}, {8}, {8}},
                 once,
                 twice,
                 top});
  expect_pruned(0.5, 0.75,
                {{{0, 2}, {0}, {0}},
                 leaf_1,
                 {{2, 5}, {2, 4}, {2, 3, 4}},
                 {{5, 6}, {5}, {5}},
                 u_9,
                 {{6, 7}, {7}, {7}},
                 {{6, 8}, {8}, {8}},
                 once,
                 twice,
                 top});
  expect_pruned(0.75, 1,
                {{{0, 2}, {0}, {0}},
                 leaf_1,
                 {{2, 5}, {2, 4}, {2, 3, 4}},
                 {{5, 8}, {5, 8}, {5, 7, 8}},
                 u_9,
                 once,
                 twice,
                 top});
  // The arc from 0 to 2, of span 2, is a leaf no more, nor that from 6 to 8, of span 3.
  expect_pruned(
    1, 4,
    {{{0, 5}, {0, 2, 4}, {0, 1, 2, 3, 4}}, {{5, 8}, {5, 8}, {5, 7, 8}}, u_9, once, twice, top});
  // The cycle stays.
  expect_pruned(4, std::numeric_limits<double>::infinity(),
                {{{0, 9}, {0, 2, 4, 6}, {0, 1, 2, 3, 4, 5, 6, 7, 8}}, once, twice, top});
}

// Saddle 2 joins the minima 0 and 1, and saddle 4 them and minimum 3. Arc 0 is a leaf of span 2,
// until it becomes one of span 9.
TEST(Leaf_pruning, forgets_the_spans_of_leaves_that_have_grown)
{
  const Graph_and_order input = graph_and_order(
    {0, 1, 2, 3, 9, 20},
    {Kind::MINIMUM, Kind::MINIMUM, Kind::SADDLE, Kind::MINIMUM, Kind::SADDLE, Kind::MAXIMUM},
    {{0, 2}, {1, 2}, {2, 4}, {3, 4}, {4, 5}});
  EXPECT_TRUE(
    pruned(input, std::nextafter(6., 0.)) ==
    (std::vector<Pruned_arc>{{{0, 4}, {0, 2}, {0, 1, 2}}, {{3, 4}, {3}, {3}}, {{4, 5}, {4}, {4}}}));
  EXPECT_TRUE(pruned(input, 6) == (std::vector<Pruned_arc>{{{0, 5}, {0, 2, 4}, {0, 1, 2, 3, 4}}}));
}

TEST(Leaf_pruning, of_equal_spans_begins_with_the_lowest_extremum)
{
  // maxima 2 and 3 above saddle 1, with a tie
  const Graph_and_order two_maxima =
    graph_and_order({0, 1, 2, 2}, {Kind::MINIMUM, Kind::SADDLE, Kind::MAXIMUM, Kind::MAXIMUM},
                    {{0, 1}, {1, 2}, {1, 3}});
  EXPECT_EQ(pruned(two_maxima, std::nextafter(1., 0.)).size(), 3u);
  EXPECT_TRUE(pruned(two_maxima, 1) == (std::vector<Pruned_arc>{{{0, 3}, {0, 2}, {0, 1, 2}}}));
  // minima 0 and 1 below saddle 2, with a tie
  const Graph_and_order two_minima =
    graph_and_order({0, 0, 1, 2}, {Kind::MINIMUM, Kind::MINIMUM, Kind::SADDLE, Kind::MAXIMUM},
                    {{0, 2}, {1, 2}, {2, 3}});
  EXPECT_EQ(pruned(two_minima, std::nextafter(1., 0.)).size(), 3u);
  EXPECT_TRUE(pruned(two_minima, 1) == (std::vector<Pruned_arc>{{{1, 3}, {1, 2}, {0, 1, 2}}}));
}

TEST(Leaf_pruning, up_to_zero_takes_away_what_only_ties_make)
{
  const Graph_and_order input =
    graph_and_order({0, 1, 1, 1.5}, {Kind::MINIMUM, Kind::SADDLE, Kind::MAXIMUM, Kind::MAXIMUM},
                    {{0, 1}, {1, 2}, {1, 3}});
  for (const double zero : {0., -0.})
    EXPECT_TRUE(pruned(input, zero) == (std::vector<Pruned_arc>{{{0, 3}, {0, 2}, {0, 1, 2}}}));
}

} // namespace

} // namespace test_leaf_pruning
