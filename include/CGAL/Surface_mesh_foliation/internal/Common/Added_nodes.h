// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_ADDED_NODES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_ADDED_NODES_H

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

template <class Graph, class = void>
struct Can_remove_nodes : std::false_type
{};
template <class Graph>
struct Can_remove_nodes<
  Graph,
  std::void_t<
    decltype(clear_vertex(std::declval<typename boost::graph_traits<Graph>::vertex_descriptor>(),
                          std::declval<Graph&>())),
    decltype(remove_vertex(std::declval<typename boost::graph_traits<Graph>::vertex_descriptor>(),
                           std::declval<Graph&>()))>> : std::true_type
{};

template <class Graph, class = void>
struct Has_list_of_edges : std::false_type
{};
template <class Graph>
struct Has_list_of_edges<Graph, std::void_t<decltype(std::declval<Graph&>().m_edges.pop_back())>>
  : std::true_type
{};

// Nodes that are added to a graph. If they are not kept, they go again, with their arcs, from a
// graph that can do that. Until then, all arcs that are added end at these nodes.
template <class Graph>
class Added_nodes
{
public:
  using Node = typename boost::graph_traits<Graph>::vertex_descriptor;

  Added_nodes(Graph& graph, std::size_t number) : m_graph(graph)
  {
    m_nodes.reserve(number);
    if constexpr (Has_list_of_edges<Graph>::value)
      m_number_of_edges = graph.m_edges.size();
  }

  ~Added_nodes()
  {
    if (!m_nodes.empty())
      remove();
  }

  Added_nodes(const Added_nodes&) = delete;
  Added_nodes& operator=(const Added_nodes&) = delete;

  Node operator[](std::size_t i) const { return m_nodes[i]; }

  // there is room for it
  Node add()
  {
    m_nodes.push_back(add_vertex(m_graph));
    return m_nodes.back();
  }

  std::vector<Node> keep() { return std::exchange(m_nodes, {}); }

private:
  void remove()
  {
    if constexpr (Can_remove_nodes<Graph>::value)
    {
      // An arc for which memory has run out may be known to one of its ends only. So no node goes
      // while there are arcs.
      for (const Node v : m_nodes)
        clear_vertex(v, m_graph);
      // Or to neither end, but to the list of all edges that Boost's graphs have.
      if constexpr (Has_list_of_edges<Graph>::value)
        while (m_graph.m_edges.size() > m_number_of_edges)
          m_graph.m_edges.pop_back();
      for (; !m_nodes.empty(); m_nodes.pop_back())
        remove_vertex(m_nodes.back(), m_graph);
    }
  }

  Graph& m_graph;
  std::vector<Node> m_nodes;
  std::size_t m_number_of_edges = 0; // before
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_ADDED_NODES_H
