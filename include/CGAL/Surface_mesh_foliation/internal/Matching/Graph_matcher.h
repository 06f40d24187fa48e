// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MATCHING_GRAPH_MATCHER_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MATCHING_GRAPH_MATCHER_H

#include <CGAL/Surface_mesh_foliation/internal/Common/compiled.h>
#include <CGAL/Surface_mesh_foliation/internal/Matching/Labeled_graph.h>

#include <optional>
#include <vector>

#if CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES
#include <CGAL/Surface_mesh_foliation/internal/Matching/cheapest_assignment.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/vf2_sub_graph_iso.hpp>
#include <boost/range/iterator_range.hpp>

#include <cmath>
#include <cstddef>
#include <utility>
#endif // CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

struct Graph_matching
{
  double cost = 0;
  std::vector<int> node_of_node, arc_of_arc; // by those of the first graph
};

CGAL_SURFACE_MESH_FOLIATION_INLINE bool are_isomorphic(const Labeled_graph& first,
                                                       const Labeled_graph& second);
CGAL_SURFACE_MESH_FOLIATION_INLINE std::optional<Graph_matching> cheapest_matching(
  const Labeled_graph& first, const Labeled_graph& second);

#if CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES

// Finds the isomorphism of two graphs with the least sum of differences of the shares of matched
// arcs. Parallel arcs, arcs from a node to itself and trees are matched by assignments, in
// polynomial time; only the isomorphisms of the cores, which are simple graphs as Boost.Graph
// requires, are all tried.
class Graph_matcher
{
public:
  Graph_matcher(const Labeled_graph& first, const Labeled_graph& second)
    : m_first(first), m_second(second)
  {}

  bool is_isomorphic() { return match_cores(true); }

  std::optional<Graph_matching> cheapest_matching()
  {
    if (!match_cores(false))
      return std::nullopt;
    Graph_matching result;
    result.cost = m_best_cost;
    result.node_of_node.resize(m_first.number_of_nodes());
    result.arc_of_arc.resize(m_first.graph().arcs.size());
    for (std::size_t i = 0; i < m_core[0].nodes.size(); ++i)
      match_trees(m_core[0].nodes[i], m_core[1].nodes[m_best[i]], result);
    for (const auto& e : boost::make_iterator_range(edges(m_core[0].graph)))
      match_arcs(m_first.bundle(m_core[0].graph[e]), m_second.bundle(image(e, m_best)), result);
    return result;
  }

private:
  static constexpr double infinity = Hungarian_method::infinity;

  // each edge stores the number of its bundle
  using Boost_graph =
    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property, int>;
  using Edge = boost::graph_traits<Boost_graph>::edge_descriptor;

  struct Core
  {
    std::vector<int> nodes;
    Boost_graph graph;
  };

  // What Boost.Graph calls with each isomorphism of the cores. It is copied.
  struct Visitor
  {
    Graph_matcher* matcher;
    bool is_one_enough;

    template <class Map, class Inverse_map>
    bool operator()(const Map& map, const Inverse_map&) const
    {
      std::vector<std::size_t> image;
      for (const auto i : boost::make_iterator_range(vertices(matcher->m_core[0].graph)))
        image.push_back(get(map, i));
      matcher->keep_if_cheaper(std::move(image));
      return !is_one_enough;
    }
  };

  bool match_cores(bool is_one_enough)
  {
    m_best_cost = infinity;
    if (m_first.number_of_nodes() != m_second.number_of_nodes() ||
        m_first.graph().arcs.size() != m_second.graph().arcs.size())
      return false;
    if (m_first.number_of_nodes() == 0)
    {
      m_best_cost = 0;
      return true;
    }
    find_tree_costs();
    find_core_of(m_first, m_core[0]);
    find_core_of(m_second, m_core[1]);
    const Boost_graph &graph = m_core[0].graph, &other = m_core[1].graph;
    boost::vf2_graph_iso(
      graph, other, Visitor{this, is_one_enough}, get(boost::vertex_index, graph),
      get(boost::vertex_index, other), boost::vertex_order_by_mult(graph),
      [&](const Edge& e, const Edge& f) {
        return m_first.bundle(graph[e]).size() == m_second.bundle(other[f]).size();
      },
      [&](std::size_t i, std::size_t j) {
        return tree_cost(m_core[0].nodes[i], m_core[1].nodes[j]) < infinity;
      });
    return m_best_cost < infinity;
  }

  static void find_core_of(const Bundled_graph& graph, Core& result)
  {
    result.nodes.clear();
    result.graph.clear();
    std::vector<std::size_t> position(graph.number_of_nodes());
    for (int v = 0; v < graph.number_of_nodes(); ++v)
      if (graph.round(v) == Bundled_graph::CORE)
      {
        position[v] = add_vertex(result.graph);
        result.nodes.push_back(v);
      }
    for (int v : result.nodes)
      for (const Bundled_graph::Link& link : graph.links(v))
        if (v < link.node && graph.round(link.node) == Bundled_graph::CORE)
          add_edge(position[v], position[link.node], link.bundle, result.graph);
  }

  // the bundle that an edge of the first core is mapped to
  int image(const Edge& e, const std::vector<std::size_t>& map) const
  {
    const Boost_graph &graph = m_core[0].graph, &other = m_core[1].graph;
    return other[edge(map[source(e, graph)], map[target(e, graph)], other).first];
  }

  void keep_if_cheaper(std::vector<std::size_t> map)
  {
    double cost = 0;
    for (std::size_t i = 0; i < map.size(); ++i)
      cost += tree_cost(m_core[0].nodes[i], m_core[1].nodes[map[i]]);
    for (const auto& e : boost::make_iterator_range(edges(m_core[0].graph)))
      cost += assigned(m_first.bundle(m_core[0].graph[e]), m_second.bundle(image(e, map))).cost;
    if (cost < m_best_cost)
    {
      m_best_cost = cost;
      m_best = std::move(map);
    }
  }

  // the least cost of matching the trees that were peeled off, with their roots
  double& tree_cost(int u, int v)
  {
    return m_tree_cost[static_cast<std::size_t>(u) * m_first.number_of_nodes() + v];
  }

  void find_tree_costs()
  {
    const std::size_t n = m_first.number_of_nodes();
    m_tree_cost.assign(n * n, infinity);
    const std::vector<int> others = m_second.order();
    for (int u : m_first.order())
      for (int v : others)
        if (m_first.round(u) == m_second.round(v) && m_first.label(u) == m_second.label(v) &&
            m_first.links(u).size() == m_second.links(v).size())
          tree_cost(u, v) =
            assigned(m_first.loops(u), m_second.loops(v)).cost + assigned_children(u, v).cost;
  }

  Assignment assigned_children(int u, int v)
  {
    const auto &children = m_first.children(u), &others = m_second.children(v);
    if (children.size() != others.size())
      return {infinity, {}};
    return cheapest_assignment(children.size(), [&](std::size_t i, std::size_t j) {
      return tree_cost(children[i].node, others[j].node) +
             assigned(m_first.bundle(children[i].bundle), m_second.bundle(others[j].bundle)).cost;
    });
  }

  Assignment assigned(const std::vector<int>& arcs, const std::vector<int>& others) const
  {
    if (arcs.size() != others.size())
      return {infinity, {}};
    return cheapest_assignment(arcs.size(), [&](std::size_t i, std::size_t j) {
      const auto &shares = m_first.graph().arcs[arcs[i]].shares,
                 &other_shares = m_second.graph().arcs[others[j]].shares;
      double result = 0;
      for (std::size_t q = 0; q < shares.size(); ++q)
        result += std::abs(shares[q] - other_shares[q]);
      return result;
    });
  }

  void match_arcs(const std::vector<int>& arcs,
                  const std::vector<int>& others,
                  Graph_matching& result) const
  {
    const Assignment assignment = assigned(arcs, others);
    for (std::size_t i = 0; i < arcs.size(); ++i)
      result.arc_of_arc[arcs[i]] = others[assignment.column_of_row[i]];
  }

  void match_trees(int u, int v, Graph_matching& result)
  {
    result.node_of_node[u] = v;
    match_arcs(m_first.loops(u), m_second.loops(v), result);
    const auto &children = m_first.children(u), &others = m_second.children(v);
    const Assignment assignment = assigned_children(u, v);
    for (std::size_t i = 0; i < children.size(); ++i)
    {
      const Bundled_graph::Link& other = others[assignment.column_of_row[i]];
      match_arcs(m_first.bundle(children[i].bundle), m_second.bundle(other.bundle), result);
      match_trees(children[i].node, other.node, result);
    }
  }

  Bundled_graph m_first, m_second;
  std::vector<double> m_tree_cost;
  Core m_core[2];
  double m_best_cost = infinity;
  std::vector<std::size_t> m_best; // the cheapest isomorphism of the cores so far
};

CGAL_SURFACE_MESH_FOLIATION_INLINE bool are_isomorphic(const Labeled_graph& first,
                                                       const Labeled_graph& second)
{
  return Graph_matcher(first, second).is_isomorphic();
}

CGAL_SURFACE_MESH_FOLIATION_INLINE std::optional<Graph_matching> cheapest_matching(
  const Labeled_graph& first, const Labeled_graph& second)
{
  return Graph_matcher(first, second).cheapest_matching();
}

#endif // CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MATCHING_GRAPH_MATCHER_H
