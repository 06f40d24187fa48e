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

// Nodes that are added to a graph. If they are not kept, they go again, with their arcs, from a
// graph that can do that.
template <class Graph>
class Added_nodes
{
public:
  using Node = typename boost::graph_traits<Graph>::vertex_descriptor;

  Added_nodes(Graph& graph, std::size_t number) : m_graph(graph) { m_nodes.reserve(number); }

  ~Added_nodes()
  {
    if constexpr (Can_remove_nodes<Graph>::value)
      for (; !m_nodes.empty(); m_nodes.pop_back())
      {
        clear_vertex(m_nodes.back(), m_graph);
        remove_vertex(m_nodes.back(), m_graph);
      }
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
  Graph& m_graph;
  std::vector<Node> m_nodes;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_ADDED_NODES_H
