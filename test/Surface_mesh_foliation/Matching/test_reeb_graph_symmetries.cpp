// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Symmetries of Reeb graphs: of graphs whose groups are known, and of shapes.

#include "generators/Random.h"
#include "generators/meshes.h"

#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/foliation_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/internal/Matching/Graph_symmetries.h>
#include <CGAL/Surface_mesh_foliation/internal/Matching/Labeled_graph.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_symmetries.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <set>
#include <vector>

namespace test_reeb_graph_symmetries {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
namespace SI = SMF::internal;
namespace np = SMF::parameters;
using namespace smf_test;
using Graph = SMF::Reeb_graph<Kernel::Point_3>;
using Permutation = SI::Graph_symmetries::Permutation;

SI::Labeled_graph labeled(std::size_t nodes, const std::vector<std::array<int, 2>>& arcs)
{
  SI::Labeled_graph result;
  result.labels.assign(nodes, {0, -1});
  for (const auto& arc : arcs)
    result.arcs.push_back({arc, {1, 1, 1}});
  return result;
}

// the size of the group that permutations generate
std::size_t order_of_group(const std::vector<Permutation>& generators, std::size_t size)
{
  Permutation identity(size);
  std::iota(identity.begin(), identity.end(), 0);
  std::set<Permutation> group = {identity};
  std::vector<Permutation> queue = {identity};
  for (std::size_t i = 0; i < queue.size(); ++i)
    for (const Permutation& generator : generators)
    {
      Permutation product(size);
      for (std::size_t x = 0; x < size; ++x)
        product[x] = generator[static_cast<std::size_t>(queue[i][x])];
      if (group.insert(product).second)
        queue.push_back(product);
    }
  return group.size();
}

std::size_t order_of_group(const SI::Labeled_graph& graph)
{
  const SI::Graph_symmetries symmetries(graph, 0.1);
  EXPECT_FALSE(symmetries.is_incomplete());
  return order_of_group(symmetries.generators(), graph.labels.size() + graph.arcs.size());
}

// Moves in turn the first of the numbers not yet used, as images of nodes and then of arcs.
std::size_t order_by_trying_all(const SI::Labeled_graph& graph)
{
  const std::size_t n = graph.labels.size(), m = graph.arcs.size();
  std::vector<int> nodes(n), arcs(m);
  std::iota(nodes.begin(), nodes.end(), 0);
  std::size_t result = 0;
  do
  {
    std::iota(arcs.begin(), arcs.end(), 0);
    do
    {
      bool is_symmetry = true;
      for (std::size_t a = 0; a < m && is_symmetry; ++a)
      {
        std::array<int, 2> image = {nodes[static_cast<std::size_t>(graph.arcs[a].nodes[0])],
                                    nodes[static_cast<std::size_t>(graph.arcs[a].nodes[1])]};
        const SI::Labeled_graph::Arc& other = graph.arcs[static_cast<std::size_t>(arcs[a])];
        std::array<int, 2> ends = other.nodes;
        std::sort(image.begin(), image.end());
        std::sort(ends.begin(), ends.end());
        is_symmetry = image == ends && other.shares == graph.arcs[a].shares;
      }
      result += is_symmetry;
    } while (std::next_permutation(arcs.begin(), arcs.end()));
  } while (std::next_permutation(nodes.begin(), nodes.end()));
  return result;
}

Graph graph_of(const Mesh& mesh, const std::vector<std::size_t>& poles)
{
  Graph graph;
  SMF::foliation_reeb_graph(mesh, vertex_range(poles), graph);
  return graph;
}

} // namespace

TEST(Graph_symmetries, of_known_groups)
{
  EXPECT_EQ(order_of_group(labeled(4, {{0, 1}, {1, 2}, {2, 3}})), 2u);                  // a path
  EXPECT_EQ(order_of_group(labeled(4, {{0, 1}, {0, 2}, {0, 3}})), 6u);                  // a star
  EXPECT_EQ(order_of_group(labeled(5, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 0}})), 10u); // a ring
  EXPECT_EQ(order_of_group(labeled(2, {{0, 1}, {0, 1}, {0, 1}})), 12u); // parallel arcs
  EXPECT_EQ(order_of_group(labeled(1, {{0, 0}, {0, 0}})), 2u);          // arcs to itself
  EXPECT_EQ(order_of_group(labeled(6, {{0, 1}, {0, 2}, {0, 3}, {3, 4}, {3, 5}})), 8u); // an H
  SI::Labeled_graph star = labeled(4, {{0, 1}, {0, 2}, {0, 3}});
  star.arcs[0].shares[1] = 1.05; // within the tolerance of 0.1
  EXPECT_EQ(order_of_group(star), 6u);
  star.arcs[0].shares[1] = 2;
  EXPECT_EQ(order_of_group(star), 2u);
  star.labels[2] = {1, -1};
  EXPECT_EQ(order_of_group(star), 1u);
}

// Far more would take long; then none is looked for, and that is told.
TEST(Graph_symmetries, of_many_equal_parts)
{
  for (const int parts : {100, 1000})
  {
    SI::Labeled_graph graph = labeled(2 * static_cast<std::size_t>(parts), {});
    for (int i = 0; i < parts; ++i)
      graph.arcs.push_back({{2 * i, 2 * i + 1}, {1, 1, 1}});
    const SI::Graph_symmetries symmetries(graph, 0.1);
    EXPECT_EQ(symmetries.is_incomplete(), parts == 1000);
    // each part turned around, and each exchanged with the next
    EXPECT_EQ(symmetries.generators().size(), parts == 100 ? 199u : 0u);
  }
}

TEST(Graph_symmetries, are_all_that_there_are)
{
  for (std::uint64_t seed = 1; seed <= 60; ++seed)
  {
    Random random(seed);
    const std::size_t nodes = 1 + random.index(5);
    SI::Labeled_graph graph = labeled(nodes, {});
    for (std::size_t i = random.index(6); i > 0; --i)
    {
      const double quantity = random.index(3) == 0 ? 2 : 1;
      graph.arcs.push_back(
        {{static_cast<int>(random.index(nodes)), static_cast<int>(random.index(nodes))},
         {quantity, 1, 1}});
    }
    EXPECT_EQ(order_of_group(graph), order_by_trying_all(graph)) << seed;
  }
}

TEST(Reeb_graph_symmetries, of_three_limbs_around_an_axis)
{
  // limbs in three directions, and a shorter one along the axis
  Triangle_soup soup = soups::icosphere(4);
  std::vector<std::size_t> tips;
  const std::vector<soups::Point> directions = {
    {1, 0, 0}, {-0.5, std::sqrt(0.75), 0}, {-0.5, -std::sqrt(0.75), 0}, {0, 0, 1}};
  for (std::size_t i = 0; i < directions.size(); ++i)
    tips.push_back(static_cast<std::size_t>(
      std::max_element(soup.points.begin(), soup.points.end(),
                       [&](const soups::Point& p, const soups::Point& q) {
                         return soups::dot(p, directions[i]) < soups::dot(q, directions[i]);
                       }) -
      soup.points.begin()));
  for (soups::Point& p : soup.points)
  {
    double radius = 1;
    for (std::size_t i = 0; i < directions.size(); ++i)
      radius += (i < 3 ? 2. : 0.7) * std::exp((soups::dot(p, directions[i]) - 1) / 0.06);
    p = soups::scaled(p, radius);
  }
  const Graph graph = graph_of(to_mesh(soup), tips);
  const SMF::Reeb_graph_symmetries<Graph> symmetries = SMF::reeb_graph_symmetries(graph);
  EXPECT_FALSE(symmetries.is_incomplete);
  EXPECT_EQ(symmetries.generators.size(), 2u);
  const std::set<std::size_t> classes(symmetries.arc_classes.begin(), symmetries.arc_classes.end());
  EXPECT_EQ(classes.size(), 2u);
  EXPECT_EQ(std::count(symmetries.arc_classes.begin(), symmetries.arc_classes.end(), 0u), 3);
  for (const auto& symmetry : symmetries.generators)
  {
    EXPECT_EQ(symmetry.nodes.size(), num_vertices(graph));
    EXPECT_EQ(symmetry.arcs.size(), num_edges(graph));
  }
}

TEST(Reeb_graph_symmetries, of_limbs_of_different_lengths_need_tolerance)
{
  const Graph graph =
    graph_of(limbed_sphere(4, 4), soups::limb_tips(4, 4)); // 2 to 2.6 long, and the same width
  EXPECT_TRUE(SMF::reeb_graph_symmetries(graph, np::tolerance(0.001)).generators.empty());
  const SMF::Reeb_graph_symmetries<Graph> all =
    SMF::reeb_graph_symmetries(graph, np::tolerance(1.));
  EXPECT_EQ(all.generators.size(), 3u);
  EXPECT_EQ(all.arc_classes, (std::vector<std::size_t>{0, 0, 0, 0}));
  EXPECT_EQ(all.node_classes, (std::vector<std::size_t>{0, 0, 0, 0, 4}));
  EXPECT_THROW(SMF::reeb_graph_symmetries(graph, np::tolerance(-0.1)),
               SMF::Invalid_parameter_exception);
  EXPECT_THROW(SMF::reeb_graph_symmetries(graph, np::tolerance(1.1)),
               SMF::Invalid_parameter_exception);
}

TEST(Reeb_graph_symmetries, of_an_empty_graph)
{
  const SMF::Reeb_graph_symmetries<Graph> symmetries = SMF::reeb_graph_symmetries(Graph());
  EXPECT_TRUE(symmetries.generators.empty());
  EXPECT_TRUE(symmetries.node_classes.empty());
}

} // namespace test_reeb_graph_symmetries
