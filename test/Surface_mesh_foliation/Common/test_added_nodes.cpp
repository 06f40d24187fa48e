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
#include <memory>
#include <new>
#include <vector>

namespace test_added_nodes {

namespace {

int allocations_left = 0; // by lists of arcs

template <class T>
struct Scarce_allocator : std::allocator<T>
{
  template <class U>
  struct rebind
  {
    using other = Scarce_allocator<U>;
  };

  Scarce_allocator() = default;
  template <class U>
  Scarce_allocator(const Scarce_allocator<U>&)
  {}

  T* allocate(std::size_t n)
  {
    if (allocations_left == 0)
      throw std::bad_alloc();
    --allocations_left;
    return std::allocator<T>::allocate(n);
  }
};

struct Scarce_vectors // a selector of Boost's: nodes have vectors of arcs
{};

} // namespace

} // namespace test_added_nodes

namespace boost {

template <class T>
struct container_gen<test_added_nodes::Scarce_vectors, T>
{
  using type = std::vector<T, test_added_nodes::Scarce_allocator<T>>;
};
template <>
struct parallel_edge_traits<test_added_nodes::Scarce_vectors>
{
  using type = allow_parallel_edge_tag;
};

} // namespace boost

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
  Added_nodes()
  {
    allocations_left = 2;
    add_edge(add_vertex(graph), add_vertex(graph), graph);
  }

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

template <class Graph>
struct Added_nodes_without_memory : public Added_nodes<Graph>
{};

template <class VertexList, class Directed>
using Scarce_graph = boost::adjacency_list<Scarce_vectors, VertexList, Directed>;
using Scarce_graphs = ::testing::Types<Scarce_graph<boost::vecS, boost::undirectedS>,
                                       Scarce_graph<boost::vecS, boost::bidirectionalS>,
                                       Scarce_graph<boost::vecS, boost::directedS>,
                                       Scarce_graph<boost::listS, boost::undirectedS>,
                                       Scarce_graph<boost::listS, boost::bidirectionalS>,
                                       Scarce_graph<boost::listS, boost::directedS>>;
TYPED_TEST_SUITE(Added_nodes_without_memory, Scarce_graphs, );

template <class Graph>
std::size_t sum_of_degrees(const Graph& graph)
{
  std::size_t result = 0;
  for (auto [it, end] = vertices(graph); it != end; ++it)
    result += out_degree(*it, graph);
  return result;
}

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

// Then Boost leaves an arc that one of its ends knows, or neither.
TYPED_TEST(Added_nodes_without_memory, go_again_with_arcs_that_are_half_made)
{
  const std::size_t degrees = sum_of_degrees(this->graph);
  bool is_enough = false;
  int n = 0;
  for (; !is_enough; ++n)
  {
    try
    {
      SI::Added_nodes<TypeParam> added(this->graph, 2);
      added.add();
      added.add();
      allocations_left = n;
      this->add_arcs(added);
      is_enough = true;
    }
    catch (const std::bad_alloc&)
    {}
    EXPECT_EQ(num_vertices(this->graph), 2u) << n;
    EXPECT_EQ(num_edges(this->graph), 1u) << n;
    EXPECT_EQ(sum_of_degrees(this->graph), degrees) << n;
  }
  EXPECT_GT(n, 2);
}

} // namespace test_added_nodes
