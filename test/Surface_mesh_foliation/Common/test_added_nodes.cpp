// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Surface_mesh_foliation/internal/Common/Added_nodes.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/subgraph.hpp>

#include <gtest/gtest.h>

#include <cstddef>

namespace test_added_nodes {

namespace {

namespace SI = CGAL::Surface_mesh_foliation::internal;

using Vector_graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;
using List_graph = boost::adjacency_list<boost::listS, boost::listS, boost::directedS>;
using Fixed_graph =
  boost::subgraph<boost::adjacency_list<boost::vecS,
                                        boost::vecS,
                                        boost::directedS,
                                        boost::no_property,
                                        boost::property<boost::edge_index_t, int>>>;

static_assert(SI::Can_remove_nodes<Vector_graph>::value);
static_assert(SI::Can_remove_nodes<List_graph>::value);
static_assert(!SI::Can_remove_nodes<Fixed_graph>::value);

template <class Graph>
struct Added_nodes : public ::testing::Test
{
  Added_nodes() { add_edge(add_vertex(graph), add_vertex(graph), graph); }

  // a loop at the first node, and two arcs from it to the second
  void add_arcs(const SI::Added_nodes<Graph>& added)
  {
    add_edge(added[0], added[0], graph);
    add_edge(added[0], added[1], graph);
    add_edge(added[1], added[0], graph);
  }

  Graph graph;
};

using Graphs = ::testing::Types<Vector_graph, List_graph>;
TYPED_TEST_SUITE(Added_nodes, Graphs, );

} // namespace

TYPED_TEST(Added_nodes, go_again_with_their_arcs)
{
  {
    SI::Added_nodes<TypeParam> added(this->graph, 3);
    for (int i = 0; i < 3; ++i)
      added.add();
    this->add_arcs(added);
    EXPECT_EQ(num_vertices(this->graph), 5u);
    EXPECT_EQ(num_edges(this->graph), 4u);
  }
  EXPECT_EQ(num_vertices(this->graph), 2u);
  EXPECT_EQ(num_edges(this->graph), 1u);
}

TYPED_TEST(Added_nodes, stay_if_they_are_kept)
{
  std::size_t number = 0;
  {
    SI::Added_nodes<TypeParam> added(this->graph, 2);
    added.add();
    added.add();
    this->add_arcs(added);
    number = added.keep().size();
  }
  EXPECT_EQ(number, 2u);
  EXPECT_EQ(num_vertices(this->graph), 4u);
  EXPECT_EQ(num_edges(this->graph), 4u);
}

} // namespace test_added_nodes
