// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Matching of the Reeb graphs of foliations, and what they know that matching looks at.

#include <CGAL/Surface_mesh_foliation/components.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_embedding.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_matching.h>

#include "include/example_systems.h"
#include "generators/meshes.h"
#include "include/test_models.h"
#include "generators/Random.h"
#include "generators/soups.h"

#include <CGAL/Simple_cartesian.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/range/iterator_range.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <vector>

namespace test_reeb_graph_matching {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
using SMF::parameters::use_pole_labels;
using smf_test::Example;
using smf_test::Mesh;
using smf_test::Random;
using smf_test::Solved_example;
namespace soups = smf_test::soups;

using Graph = SMF::Reeb_graph<Mesh::Point>;

// ===  The graphs of foliations

Graph graph_of(const Solved_example<>& example)
{
  Graph result;
  SMF::reeb_graph(example.foliation, result);
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
      SMF::reeb_graph_embedding(solved.foliation, SMF::parameters::number_of_samples(3));
    Graph graph;
    SMF::reeb_graph(solved.foliation, graph, embedding);
    Mesh cut;
    const auto component = cut.add_property_map<Mesh::Face_index, std::size_t>("f:c").first;
    SMF::surface_components(solved.foliation, cut, SMF::parameters::face_component_map(component));
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
    EXPECT_TRUE(SMF::reeb_graphs_are_isomorphic(first, second));
    EXPECT_TRUE(SMF::reeb_graphs_are_isomorphic(first, second, use_pole_labels(false)));
    const auto matching = SMF::match_reeb_graphs(first, second);
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
    EXPECT_NEAR(SMF::match_reeb_graphs(second, first)->distance, matching->distance, 1e-14);
    EXPECT_EQ(SMF::match_reeb_graphs(first, first)->distance, 0);
    const auto freely = SMF::match_reeb_graphs(first, second, use_pole_labels(false));
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
  const auto by_label = SMF::match_reeb_graphs(graph, other);
  const auto by_shape = SMF::match_reeb_graphs(graph, other, use_pole_labels(false));
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
  EXPECT_FALSE(SMF::reeb_graphs_are_isomorphic(theta, dumbbell)) << "self-arcs or parallel ones";
  EXPECT_FALSE(SMF::match_reeb_graphs(theta, dumbbell));
  std::vector<Graph> graphs;
  for (const Example& example : smf_test::example_systems())
    graphs.push_back(graph_of(example));
  std::size_t pairs = 0;
  for (const Graph& a : graphs)
    for (const Graph& b : graphs)
      pairs += SMF::reeb_graphs_are_isomorphic(a, b);
  EXPECT_EQ(pairs, graphs.size() + 2) << "the line pole and the other torus with pole and loop";
}

TEST(Reeb_graphs, kinds_and_labels_count)
{
  Graph path;
  for (int i = 0; i < 3; ++i)
    add_vertex(path);
  add_edge(0, 1, path);
  add_edge(1, 2, path);
  path[0].kind = path[2].kind = SMF::Node_kind::POLE;
  path[0].pole = 0;
  path[2].pole = 1;
  Graph other = path;
  other[0].pole = 1;
  other[2].pole = 0;
  EXPECT_TRUE(SMF::reeb_graphs_are_isomorphic(path, other));
  other[2].pole = 5;
  EXPECT_FALSE(SMF::reeb_graphs_are_isomorphic(path, other));
  EXPECT_TRUE(SMF::reeb_graphs_are_isomorphic(path, other, use_pole_labels(false)));
  other[1].kind = SMF::Node_kind::REGULAR;
  EXPECT_FALSE(SMF::reeb_graphs_are_isomorphic(path, other, use_pole_labels(false)));
  other[1].kind = SMF::Node_kind::SADDLE;
  other[1].genus = 3;
  EXPECT_TRUE(SMF::reeb_graphs_are_isomorphic(path, other, use_pole_labels(false)));
  EXPECT_TRUE(SMF::reeb_graphs_are_isomorphic(Graph(), Graph()));
  EXPECT_EQ(SMF::match_reeb_graphs(Graph(), Graph())->distance, 0);
  EXPECT_FALSE(SMF::reeb_graphs_are_isomorphic(Graph(), path));
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
    first[i].kind = SMF::Node_kind::POLE;
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
  const auto matching = SMF::match_reeb_graphs(first, second);
  ASSERT_TRUE(matching);
  EXPECT_EQ(matching->length_distance, 0);
  EXPECT_NEAR(matching->flux_distance, 1. / 2 - 1. / 3, 1e-15);
  EXPECT_NEAR(matching->area_distance, 1. / 2, 1e-15) << "where there is none, all is missing";
  for (const double bad : {-1., std::nan(""), std::numeric_limits<double>::infinity()})
  {
    second[*edges(second).first].flux = bad;
    EXPECT_THROW(SMF::match_reeb_graphs(first, second), SMF::Invalid_parameter_exception);
    EXPECT_THROW(SMF::match_reeb_graphs(second, first), SMF::Invalid_parameter_exception);
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
      return SMF::match_reeb_graphs(graphs[static_cast<std::size_t>(i)],
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
  using SMF::parameters::arc_map;
  using SMF::parameters::combine;
  using SMF::parameters::node_map;
  const Solved_example<> example(smf_test::dumbbell_example());
  const Graph expected = graph_of(example);
  List_graph graph;
  std::map<Node, SMF::Reeb_node<Mesh::Point>> node;
  std::map<Arc, SMF::Reeb_arc<Mesh::Point>> arc;
  const auto nodes = boost::make_assoc_property_map(node);
  const auto arcs = boost::make_assoc_property_map(arc);
  SMF::reeb_graph(example.foliation, graph, combine(node_map(nodes), arc_map(arcs)));
  EXPECT_TRUE(SMF::reeb_graphs_are_isomorphic(graph, expected, node_map(nodes)));
  EXPECT_TRUE(SMF::reeb_graphs_are_isomorphic(expected, graph, combine(use_pole_labels(false)),
                                              node_map(nodes)));
  const auto matching = SMF::match_reeb_graphs(expected, graph, CGAL::parameters::default_values(),
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
      SMF::Reeb_graph<typename SMF::Loop_system<TypeParam>::Point> graph;
      SMF::reeb_graph(solved.foliation, graph);
      const auto matching = SMF::match_reeb_graphs(graph, graph_of(example));
      ASSERT_TRUE(matching);
      EXPECT_EQ(matching->distance, 0);
      for (const auto& [u, v] : matching->nodes)
        EXPECT_EQ(u, v);
    }
}

} // namespace

} // namespace test_reeb_graph_matching
