// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Reeb graphs of functions, simplified up to a persistence: against a program that prunes their
// shortest leaf again and again, and what stays as it is.

#include "include/random_functions.h"
#include "include/scalar_reeb_graphs.h"
#include "generators/meshes.h"
#include "generators/Random.h"

#include <CGAL/Surface_mesh_foliation/Critical_kind.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_of_function.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace test_reeb_graph_simplification {

namespace {

using smf_test::degrees;
using smf_test::expect_simple_saddles;
using smf_test::for_each_function;
using smf_test::Mesh;
using smf_test::reeb_graph;
using smf_test::Surface;
namespace smf_np = CGAL::Surface_mesh_foliation::parameters;

using Kind = CGAL::Surface_mesh_foliation::Critical_kind;
using Result = smf_test::Numbered_reeb_graph;
using Values = std::vector<double>;

struct Leaf
{
  double span;
  std::size_t arc, extremum, saddle;
};

// the shortest leaf that can be pruned, or one of infinite span
Leaf shortest_leaf(const Result& graph, const Values& values)
{
  Leaf best = {std::numeric_limits<double>::infinity(), 0, 0, 0};
  const auto key = [&](double span, std::size_t extremum) {
    const std::size_t v = graph.nodes[extremum].vertex;
    return std::make_tuple(span, values[v], v);
  };
  const auto degree = degrees(graph);
  for (std::size_t a = 0; a < graph.arcs.size(); ++a)
    for (const bool is_minimum : {true, false})
    {
      const auto [low, high, size] = graph.arcs[a];
      const std::size_t extremum = is_minimum ? low : high, saddle = is_minimum ? high : low;
      const double span = values[graph.nodes[high].vertex] - values[graph.nodes[low].vertex];
      if (graph.nodes[extremum].kind != Kind::SADDLE && degree[saddle][is_minimum ? 0 : 1] == 2 &&
          key(span, extremum) < key(best.span, best.extremum))
        best = {span, a, extremum, saddle};
    }
  return best;
}

// Nodes that are gone have multiplicity 99, and arcs that are gone go from such a node to itself.
Result pruned(Result graph, const Values& values, double persistence)
{
  for (;;)
  {
    const Leaf leaf = shortest_leaf(graph, values);
    if (!(leaf.span <= persistence))
      return graph;
    std::size_t low = leaf.arc, high = leaf.arc;
    for (std::size_t a = 0; a < graph.arcs.size(); ++a)
      if (a != leaf.arc && graph.arcs[a].upper == leaf.saddle)
        low = a;
      else if (a != leaf.arc && graph.arcs[a].lower == leaf.saddle)
        high = a;
    EXPECT_TRUE(low != leaf.arc && high != leaf.arc);
    graph.arcs[low].upper = graph.arcs[high].upper;
    for (std::size_t& a : graph.arc_of_vertex)
      a = a == leaf.arc || a == high ? low : a;
    for (const std::size_t a : {leaf.arc, high})
      graph.arcs[a].lower = graph.arcs[a].upper = leaf.saddle;
    for (const std::size_t node : {leaf.extremum, leaf.saddle})
    {
      graph.nodes[node].kind = Kind::SADDLE;
      graph.nodes[node].multiplicity = 99;
    }
  }
}

// Arcs correspond to each other: the same vertices lie on them, and their ends are the same.
void expect_equal_arcs(const Result& result, const Result& expected)
{
  std::set<std::size_t> arcs, expected_arcs;
  std::set<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t v = 0; v < result.arc_of_vertex.size(); ++v)
  {
    const std::size_t a = result.arc_of_vertex[v], b = expected.arc_of_vertex[v];
    EXPECT_EQ(result.ends(a), expected.ends(b));
    arcs.insert(a);
    expected_arcs.insert(b);
    pairs.emplace(a, b);
  }
  EXPECT_EQ(pairs.size(), arcs.size());
  EXPECT_EQ(pairs.size(), expected_arcs.size());
}

TEST(Persistence, prunes_the_shortest_leaf_again_and_again)
{
  smf_test::Random random(2);
  for_each_function(60, [&](const Surface& surface, const Values& values) {
    const double persistence = random.index(4) == 0 ? 0 : random.between(0, 2);
    const Result result = reeb_graph(surface.mesh, values, smf_np::persistence(persistence));
    EXPECT_EQ(result.number_of_cycles(), surface.genus);
    expect_simple_saddles(result);
    const Result expected = pruned(reeb_graph(surface.mesh, values), values, persistence);
    std::vector<std::size_t> vertices, expected_vertices;
    for (const Result::Node& node : result.nodes)
      vertices.push_back(node.vertex);
    for (const Result::Node& node : expected.nodes)
      if (node.multiplicity != 99)
        expected_vertices.push_back(node.vertex);
    EXPECT_EQ(vertices, expected_vertices);
    expect_equal_arcs(result, expected);
    std::size_t count = std::set<std::size_t>(vertices.begin(), vertices.end()).size();
    for (const Result::Arc& arc : result.arcs)
      count += arc.number_of_vertices;
    EXPECT_EQ(count, values.size()) << "every vertex is on an arc or at a node";
  });
}

void expect_contours_around_nodes(const Result& folded)
{
  const auto degree = degrees(folded);
  for (std::size_t i = 0; i < degree.size(); ++i)
  {
    const Result::Node& node = folded.nodes[i];
    const auto contours = static_cast<std::size_t>(degree[i][0] + degree[i][1]);
    EXPECT_EQ(2 * node.genus + contours, node.kind == Kind::SADDLE ? 2 + node.multiplicity : 1);
  }
}

TEST(Persistence, folded_graphs_keep_cycles_and_vertices)
{
  smf_test::Random random(2);
  bool has_vertices_inside_saddles = false;
  for_each_function(100, [&](const Surface& surface, const Values& values) {
    const auto np = smf_np::persistence(random.between(0, 2));
    const Result unfolded = reeb_graph(surface.mesh, values, np);
    const Result result =
      reeb_graph(surface.mesh, values, smf_np::combine(np, smf_np::unfold_saddles(false)));
    expect_contours_around_nodes(result);
    std::size_t genus = result.number_of_cycles();
    for (const Result::Node& node : result.nodes)
      genus += node.genus;
    EXPECT_EQ(genus, surface.genus);
    std::size_t count = result.nodes.size();
    for (const Result::Arc& arc : result.arcs)
      count += arc.number_of_vertices;
    EXPECT_EQ(count, values.size());
    for (std::size_t v = 0; v < values.size(); ++v)
    {
      const auto ends = result.ends(result.arc_of_vertex[v]);
      const auto unfolded_ends = unfolded.ends(unfolded.arc_of_vertex[v]);
      const bool is_inside_saddle = unfolded_ends[0] == unfolded_ends[1];
      has_vertices_inside_saddles = has_vertices_inside_saddles || is_inside_saddle;
      EXPECT_TRUE(is_inside_saddle ? ends[1] == unfolded_ends[1] : ends == unfolded_ends);
    }
  });
  EXPECT_TRUE(has_vertices_inside_saddles);
}

TEST(Persistence, a_large_one_leaves_an_arc_of_a_sphere)
{
  const Mesh mesh = smf_test::icosphere(3);
  smf_test::Random random(1);
  Values values;
  for (std::size_t v = 0; v < num_vertices(mesh); ++v)
    values.push_back(random.between(0, 1));
  EXPECT_GT(reeb_graph(mesh, values).nodes.size(), 100u);
  const Result result = reeb_graph(mesh, values, smf_np::persistence(1));
  ASSERT_EQ(result.arcs.size(), 1u);
  EXPECT_EQ(result.arcs[0].number_of_vertices, values.size() - 2);
}

TEST(Persistence, of_zero_removes_what_only_ties_make)
{
  const Mesh mesh = smf_test::icosphere(3);
  const Values constant(num_vertices(mesh), 1.5);
  EXPECT_GT(reeb_graph(mesh, constant).arcs.size(), 1u);
  EXPECT_EQ(reeb_graph(mesh, constant, smf_np::persistence(0)).arcs.size(), 1u);
  EXPECT_EQ(reeb_graph(mesh, constant, smf_np::persistence(-0.)).arcs.size(), 1u);
}

} // namespace

} // namespace test_reeb_graph_simplification
