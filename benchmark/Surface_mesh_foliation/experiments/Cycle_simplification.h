// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_EXPERIMENTS_CYCLE_SIMPLIFICATION_H
#define SMF_EXPERIMENTS_CYCLE_SIMPLIFICATION_H

#include "Part_graph.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace smf_experiments {

// Removes cycles of the Reeb graph of a function whose span, from their lowest to their highest
// node, is at most a bound, the smallest first (Doraiswamy and Natarajan, Output-sensitive
// construction of Reeb graphs, 2009). Of each cycle the arc goes that closes it from below at its
// highest node; its faces are given to the arc that it runs beside there. Nodes that then have only
// two arcs go, too.
class Cycle_simplification
{
public:
  explicit Cycle_simplification(const Part_graph& graph) : m_value(graph.values)
  {
    for (const auto node : boost::make_iterator_range(vertices(graph.graph)))
      m_node.push_back(graph.graph[node]);
    for (const auto& arc : boost::make_iterator_range(edges(graph.graph)))
    {
      std::size_t lower = source(arc, graph.graph), upper = target(arc, graph.graph);
      if (m_value[upper] < m_value[lower])
        std::swap(lower, upper);
      m_arcs.push_back({lower, upper});
    }
    m_owner.resize(m_arcs.size());
    std::iota(m_owner.begin(), m_owner.end(), std::size_t(0));
  }

  void remove_cycles(double most)
  {
    while (remove_smallest_cycle(most))
      join_arcs();
  }

  Part_graph result(const Part_graph& original) const
  {
    Part_graph result;
    std::vector<std::size_t> number(m_node.size(), 0);
    std::vector<bool> is_used(m_node.size(), false);
    for (const Arc& arc : m_arcs)
      if (arc.exists)
        is_used[arc.lower] = is_used[arc.upper] = true;
    for (std::size_t v = 0; v < m_node.size(); ++v)
      if (is_used[v])
      {
        number[v] = add_vertex(result.graph);
        result.graph[number[v]] = m_node[v];
        result.values.push_back(m_value[v]);
      }
    std::vector<int> arc_number(m_arcs.size(), -1);
    for (std::size_t a = 0; a < m_arcs.size(); ++a)
      if (m_arcs[a].exists)
      {
        arc_number[a] = static_cast<int>(num_edges(result.graph));
        add_edge(number[m_arcs[a].lower], number[m_arcs[a].upper], result.graph);
      }
    for (const int arc : original.arc_of_face)
      result.arc_of_face.push_back(arc_number[owner(static_cast<std::size_t>(arc))]);
    return result;
  }

private:
  struct Arc
  {
    std::size_t lower, upper;
    bool exists = true;
  };

  std::size_t owner(std::size_t arc) const
  {
    while (m_owner[arc] != arc)
      arc = m_owner[arc];
    return arc;
  }

  void give(std::size_t arc, std::size_t other)
  {
    m_arcs[arc].exists = false;
    m_owner[arc] = other;
  }

  std::vector<std::size_t> arcs_at(std::size_t node) const
  {
    std::vector<std::size_t> result;
    for (std::size_t a = 0; a < m_arcs.size(); ++a)
      if (m_arcs[a].exists && (m_arcs[a].lower == node || m_arcs[a].upper == node))
        result.push_back(a);
    return result;
  }

  // Above each node, arcs are added by their upper ends until one closes a cycle.
  bool remove_smallest_cycle(double most)
  {
    std::vector<std::size_t> order;
    for (std::size_t a = 0; a < m_arcs.size(); ++a)
      if (m_arcs[a].exists)
        order.push_back(a);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return m_value[m_arcs[a].upper] < m_value[m_arcs[b].upper];
    });
    double least = std::numeric_limits<double>::infinity();
    std::size_t closing = m_arcs.size();
    for (std::size_t bottom = 0; bottom < m_node.size(); ++bottom)
    {
      const std::size_t a = first_closing_arc(order, m_value[bottom]);
      if (a < m_arcs.size() && m_value[m_arcs[a].upper] - m_value[bottom] < least)
      {
        least = m_value[m_arcs[a].upper] - m_value[bottom];
        closing = a;
      }
    }
    if (closing == m_arcs.size() || least > most)
      return false;
    const std::size_t top = m_arcs[closing].upper;
    for (const std::size_t a : arcs_at(top))
      if (a != closing && m_arcs[a].upper == top)
      {
        give(closing, a);
        return true;
      }
    return false;
  }

  std::size_t first_closing_arc(const std::vector<std::size_t>& order, double bottom) const
  {
    std::vector<std::size_t> root(m_node.size());
    std::iota(root.begin(), root.end(), std::size_t(0));
    const auto find = [&](std::size_t v) {
      while (root[v] != v)
        v = root[v] = root[root[v]];
      return v;
    };
    for (const std::size_t a : order)
    {
      if (m_value[m_arcs[a].lower] < bottom)
        continue;
      const std::size_t u = find(m_arcs[a].lower), v = find(m_arcs[a].upper);
      if (u == v)
        return a;
      root[u] = v;
    }
    return m_arcs.size();
  }

  // at nodes with one arc below and one above
  void join_arcs()
  {
    for (std::size_t v = 0; v < m_node.size(); ++v)
    {
      const std::vector<std::size_t> arcs = arcs_at(v);
      if (arcs.size() != 2)
        continue;
      const bool is_first_above = m_arcs[arcs[0]].lower == v;
      const std::size_t above = is_first_above ? arcs[0] : arcs[1],
                        below = is_first_above ? arcs[1] : arcs[0];
      if (m_arcs[above].lower != v || m_arcs[below].upper != v)
        continue;
      m_arcs[below].upper = m_arcs[above].upper;
      give(above, below);
    }
  }

  std::vector<double> m_value; // by node
  std::vector<SMF::Reeb_node<Point>> m_node;
  std::vector<Arc> m_arcs;
  std::vector<std::size_t> m_owner; // by arc: itself, or the one that has got its faces
};

inline Part_graph without_small_cycles(const Part_graph& graph, double share)
{
  const auto [least, largest] = std::minmax_element(graph.values.begin(), graph.values.end());
  Cycle_simplification simplification(graph);
  simplification.remove_cycles(share * (*largest - *least));
  return simplification.result(graph);
}

} // namespace smf_experiments

#endif // SMF_EXPERIMENTS_CYCLE_SIMPLIFICATION_H
