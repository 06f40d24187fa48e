// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MATCHING_LABELED_GRAPH_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MATCHING_LABELED_GRAPH_H

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// A graph with the labels and quantities by which its nodes and arcs are compared. There may be
// parallel arcs, and arcs from a node to itself.
struct Labeled_graph
{
  static constexpr int NUMBER_OF_QUANTITIES = 3;

  struct Arc
  {
    std::array<int, 2> nodes;
    std::array<double, NUMBER_OF_QUANTITIES> shares; // of the sums over all arcs
  };

  std::vector<std::pair<int, int>> labels; // by node: only equal ones match
  std::vector<Arc> arcs;
};

// The same graph without arcs from a node to itself, and with parallel arcs in one bundle: a simple
// graph. Its trees are peeled off, all leaves of a round at once, so that isomorphisms preserve
// rounds and parents. What remains is its core: the nodes on and between cycles and, for a
// component that is a tree, its center: one node, or two that are joined.
class Bundled_graph
{
public:
  struct Link
  {
    int node;
    int bundle;
  };
  static constexpr int CORE = -1;

  explicit Bundled_graph(const Labeled_graph& graph)
    : m_graph(graph),
      m_loops(graph.labels.size()),
      m_links(graph.labels.size()),
      m_children(graph.labels.size()),
      m_round(graph.labels.size(), CORE)
  {
    std::map<std::array<int, 2>, int> bundle_of_nodes;
    for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a)
    {
      std::array<int, 2> nodes = graph.arcs[a].nodes;
      if (nodes[0] == nodes[1])
      {
        m_loops[nodes[0]].push_back(a);
        continue;
      }
      if (nodes[0] > nodes[1])
        std::swap(nodes[0], nodes[1]);
      const int next = static_cast<int>(m_bundles.size());
      const auto [it, is_new] = bundle_of_nodes.emplace(nodes, next);
      if (is_new)
        add_bundle(nodes);
      m_bundles[it->second].push_back(a);
    }
    peel();
  }

  int number_of_nodes() const { return static_cast<int>(m_links.size()); }
  const Labeled_graph& graph() const { return m_graph; }
  const std::pair<int, int>& label(int v) const { return m_graph.labels[v]; }

  const std::vector<int>& bundle(int b) const { return m_bundles[b]; }     // arcs
  const std::vector<int>& loops(int v) const { return m_loops[v]; }        // arcs from v to v
  const std::vector<Link>& links(int v) const { return m_links[v]; }       // to other nodes
  const std::vector<Link>& children(int v) const { return m_children[v]; } // those peeled off
  int round(int v) const { return m_round[v]; } // in which v was peeled off; CORE: never

  // the nodes, children before parents, those of the core last
  std::vector<int> order() const
  {
    std::vector<int> result = m_peeled;
    for (int v = 0; v < number_of_nodes(); ++v)
      if (m_round[v] == CORE)
        result.push_back(v);
    return result;
  }

private:
  void add_bundle(const std::array<int, 2>& nodes)
  {
    const int b = static_cast<int>(m_bundles.size());
    m_bundles.emplace_back();
    m_links[nodes[0]].push_back({nodes[1], b});
    m_links[nodes[1]].push_back({nodes[0], b});
  }

  void peel()
  {
    std::vector<int> leaves;
    std::vector<std::size_t> degree;
    for (int v = 0; v < number_of_nodes(); ++v)
    {
      degree.push_back(m_links[v].size());
      if (degree[v] == 1)
        leaves.push_back(v);
    }
    for (int round = 0; !leaves.empty(); ++round)
    {
      std::vector<std::pair<int, Link>> cut;
      for (int leaf : leaves)
        for (const Link& link : m_links[leaf])
          if (degree[leaf] == 1 && m_round[link.node] == CORE && degree[link.node] != 1)
            cut.emplace_back(leaf, link);
      leaves.clear();
      for (const auto& [leaf, link] : cut)
      {
        m_round[leaf] = round;
        m_peeled.push_back(leaf);
        m_children[link.node].push_back({leaf, link.bundle});
        if (--degree[link.node] == 1)
          leaves.push_back(link.node);
      }
    }
  }

  const Labeled_graph& m_graph;
  std::vector<std::vector<int>> m_loops, m_bundles;
  std::vector<std::vector<Link>> m_links, m_children;
  std::vector<int> m_round, m_peeled;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MATCHING_LABELED_GRAPH_H
