// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SCALAR_REEB_GRAPH_LEAF_PRUNING_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SCALAR_REEB_GRAPH_LEAF_PRUNING_H

#include <CGAL/Surface_mesh_foliation/internal/Common/Disjoint_sets.h>
#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/Flat_scalar_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/Vertex_order.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Simplifies a Reeb graph of simple saddles: as long as possible, the shortest arc that joins an
// extremum to a saddle with another arc on the same side is removed, and the other two arcs of the
// saddle become one (Carr, Snoeyink and van de Panne, Simplifying flexible isosurfaces using local
// geometric measures, 2004). Only trees are cut off, so the cycles remain. A smaller persistence
// just stops earlier in the same process.
class Leaf_pruning
{
public:
  Leaf_pruning(Flat_scalar_reeb_graph& graph, const Vertex_order& order, double persistence)
    : m_graph(graph),
      m_order(order),
      m_persistence(persistence),
      m_arcs(graph.nodes.size()),
      m_top_piece(graph.arcs.size()),
      m_sets(graph.arcs.size())
  {
    for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a)
    {
      m_top_piece[a] = graph.arcs[a].first_piece;
      insert(graph.arcs[a].lower, up, a);
      insert(graph.arcs[a].upper, down, a);
    }
    for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a)
      enqueue(a);
    run();
    compact();
  }

private:
  static constexpr int none = -1;
  enum Side { down, up };

  // span; rank of the extremum, so that equal spans have an order; arc
  using Entry = std::tuple<double, int, int>;

  static Side other(Side side) { return side == down ? up : down; }

  int& end(int arc, Side side)
  {
    return side == down ? m_graph.arcs[arc].lower : m_graph.arcs[arc].upper;
  }

  void insert(int node, Side side, int arc)
  {
    CGAL_assertion(m_arcs[node][side][1] == none);
    m_arcs[node][side][m_arcs[node][side][0] == none ? 0 : 1] = arc;
  }

  void replace(int node, Side side, int arc, int new_arc)
  {
    std::array<int, 2>& arcs = m_arcs[node][side];
    arcs[arcs[0] == arc ? 0 : 1] = new_arc;
  }

  bool is_extremum(int node) const { return m_graph.nodes[node].kind != Critical_kind::SADDLE; }

  // whether the arc ends, on this side, in an extremum that can be pruned
  bool is_prunable(int arc, Side side)
  {
    const int saddle = end(arc, other(side));
    return is_extremum(end(arc, side)) && !is_extremum(saddle) && m_arcs[saddle][side][1] != none;
  }

  Entry entry(int arc, Side side)
  {
    const int low = m_graph.nodes[end(arc, down)].vertex, high = m_graph.nodes[end(arc, up)].vertex;
    return {m_order.value(high) - m_order.value(low), m_order.rank(side == down ? low : high), arc};
  }

  void enqueue(int arc)
  {
    for (Side side : {down, up})
      if (is_prunable(arc, side) && std::get<0>(entry(arc, side)) <= m_persistence)
        m_queue.push(entry(arc, side));
  }

  void run()
  {
    while (!m_queue.empty())
    {
      const Entry top = m_queue.top();
      m_queue.pop();
      const int arc = std::get<2>(top);
      for (Side side : {down, up})
        if (end(arc, side) != none && is_prunable(arc, side) && entry(arc, side) == top)
          prune(arc, side); // at most one end is an extremum
    }
  }

  void prune(int arc, Side side)
  {
    const int saddle = end(arc, other(side));
    const std::array<int, 2>& beside = m_arcs[saddle][side];
    int low = beside[beside[0] == arc ? 1 : 0], high = m_arcs[saddle][other(side)][0];
    if (side == up)
      std::swap(low, high);
    remove_node(end(arc, side));
    remove_node(saddle);
    end(low, up) = end(high, up);
    replace(end(high, up), down, high, low);
    m_graph.pieces[m_top_piece[low]].next = m_graph.arcs[high].first_piece;
    m_top_piece[low] = m_top_piece[high];
    remove_arc(arc, low);
    remove_arc(high, low);
    enqueue(low);
  }

  void remove_node(int node) { m_graph.nodes[node].vertex = none; }

  void remove_arc(int arc, int heir)
  {
    end(arc, down) = end(arc, up) = none;
    m_sets.union_set(static_cast<std::size_t>(arc), static_cast<std::size_t>(heir));
  }

  // renumbers what remains
  void compact()
  {
    std::vector<int> new_node(m_graph.nodes.size(), none);
    int n = 0;
    for (std::size_t v = 0; v < m_graph.nodes.size(); ++v)
      if (m_graph.nodes[v].vertex != none)
      {
        m_graph.nodes[n] = m_graph.nodes[v];
        new_node[v] = n++;
      }
    m_graph.nodes.resize(n);
    std::vector<int> new_arc(m_graph.arcs.size(), none); // by representative
    n = 0;
    for (std::size_t a = 0; a < new_arc.size(); ++a)
      if (m_graph.arcs[a].lower != none)
      {
        Flat_scalar_reeb_graph::Arc& arc = m_graph.arcs[n] = m_graph.arcs[a];
        arc.lower = new_node[arc.lower];
        arc.upper = new_node[arc.upper];
        new_arc[m_sets.find_set(a)] = n++;
      }
    m_graph.arcs.resize(n);
    for (int& a : m_graph.arc_of_vertex)
      a = new_arc[m_sets.find_set(static_cast<std::size_t>(a))];
  }

  Flat_scalar_reeb_graph& m_graph;
  const Vertex_order& m_order;
  double m_persistence;
  struct Arcs_of_node
  {
    std::array<std::array<int, 2>, 2> arcs{{{none, none}, {none, none}}}; // by side
    std::array<int, 2>& operator[](Side side) { return arcs[side]; }
  };
  std::vector<Arcs_of_node> m_arcs;
  std::vector<int> m_top_piece;
  Disjoint_sets m_sets; // of arcs that have been merged
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> m_queue;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SCALAR_REEB_GRAPH_LEAF_PRUNING_H
