// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_BRUTE_FORCE_REEB_GRAPH_H
#define SMF_TEST_BRUTE_FORCE_REEB_GRAPH_H

#include "generators/soups.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

// The Reeb graph of a function by its definition: all contours on all levels, each found as the
// edges that triangles connect.

namespace smf_test {

// the edges of a soup, and those of each triangle
class Edges_of_soup
{
public:
  explicit Edges_of_soup(const Triangle_soup& soup)
  {
    std::map<std::array<std::size_t, 2>, std::size_t> numbers;
    for (const auto& t : soup.triangles)
      for (std::size_t i = 0; i < 3; ++i)
      {
        const std::size_t u = t[i], v = t[(i + 1) % 3];
        const std::array<std::size_t, 2> key = {std::min(u, v), std::max(u, v)};
        const auto [entry, is_new] = numbers.emplace(key, ends.size());
        if (is_new)
          ends.push_back(key);
        of_triangles.push_back(entry->second);
      }
  }

  std::vector<std::array<std::size_t, 2>> ends;
  std::vector<std::size_t> of_triangles; // three by three; the i-th leaves the i-th corner
};

class Brute_force_reeb_graph
{
public:
  struct Node
  {
    std::size_t lower_wedges, upper_wedges; // of neighbors
    std::size_t contours_below, contours_above;
  };

  std::map<std::size_t, Node> nodes;                // by vertex
  std::vector<std::array<std::size_t, 2>> arcs;     // vertices, the lower one first
  std::map<std::size_t, std::size_t> arc_of_vertex; // without those of nodes

  Brute_force_reeb_graph(const Triangle_soup& soup,
                         const Edges_of_soup& edges,
                         const std::vector<double>& values)
    : m_soup(soup), m_edges(edges), m_rank(values.size()), m_arc_of_edge(edges.ends.size())
  {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t u, std::size_t v) { return values[u] < values[v]; });
    for (std::size_t r = 0; r < order.size(); ++r)
      m_rank[order[r]] = r;
    m_contour = contours(0);
    for (const std::size_t v : order)
      pass(v);
  }

private:
  bool is_crossed(std::size_t e, std::size_t number_below) const
  {
    const auto [u, v] = m_edges.ends[e];
    return (m_rank[u] < number_below) != (m_rank[v] < number_below);
  }

  // for each edge that is crossed by a contour with `number_below` vertices below it, the first
  // edge that this contour crosses
  std::vector<std::size_t> contours(std::size_t number_below) const
  {
    std::vector<std::size_t> parent(m_edges.ends.size());
    std::iota(parent.begin(), parent.end(), std::size_t(0));
    const auto find = [&](std::size_t e) {
      while (parent[e] != e)
        e = parent[e] = parent[parent[e]];
      return e;
    };
    for (std::size_t t = 0; t < m_edges.of_triangles.size(); t += 3)
    {
      std::vector<std::size_t> crossed;
      for (std::size_t i = t; i < t + 3; ++i)
        if (is_crossed(m_edges.of_triangles[i], number_below))
          crossed.push_back(find(m_edges.of_triangles[i]));
      if (!crossed.empty())
        parent[std::max(crossed[0], crossed[1])] = std::min(crossed[0], crossed[1]);
    }
    for (std::size_t e = 0; e < parent.size(); ++e)
      parent[e] = find(e);
    return parent;
  }

  // the number of connected pieces of the part of the link of v that is lower, or higher
  std::size_t number_of_wedges(std::size_t v, bool is_lower) const
  {
    std::set<std::size_t> neighbors;
    std::size_t number_of_edges = 0;
    for (const auto& t : m_soup.triangles)
    {
      if (std::find(t.begin(), t.end(), v) == t.end())
        continue;
      std::size_t count = 0;
      for (const std::size_t u : t)
        if (u != v && (m_rank[u] < m_rank[v]) == is_lower)
        {
          neighbors.insert(u);
          ++count;
        }
      number_of_edges += count == 2;
    }
    return neighbors.size() - number_of_edges; // 0 also for the whole circle
  }

  // contours that cross an edge of v, and all others
  void pass(std::size_t v)
  {
    const std::vector<std::size_t> above = contours(m_rank[v] + 1);
    std::set<std::size_t> ending, beginning;
    for (std::size_t e = 0; e < above.size(); ++e)
      if (m_edges.ends[e][0] == v || m_edges.ends[e][1] == v)
      {
        if (is_crossed(e, m_rank[v]))
          ending.insert(m_contour[e]);
        if (is_crossed(e, m_rank[v] + 1))
          beginning.insert(above[e]);
      }
    const Node node{number_of_wedges(v, true), number_of_wedges(v, false), ending.size(),
                    beginning.size()};
    std::map<std::size_t, std::size_t> new_arc; // of contours above
    if (node.lower_wedges == 1 && node.upper_wedges == 1)
      new_arc[*beginning.begin()] = arc_of_vertex[v] = m_arc_of_edge[*ending.begin()];
    else
    {
      nodes.emplace(v, node);
      for (const std::size_t contour : ending)
        arcs[m_arc_of_edge[contour]][1] = v;
      for (const std::size_t contour : beginning)
      {
        new_arc[contour] = arcs.size();
        arcs.push_back({v, v});
      }
    }
    for (std::size_t e = 0; e < above.size(); ++e)
      if (is_crossed(e, m_rank[v] + 1) && new_arc.count(above[e]) > 0)
        m_arc_of_edge[e] = new_arc.at(above[e]);
    m_contour = above;
  }

  const Triangle_soup& m_soup;
  const Edges_of_soup& m_edges;
  std::vector<std::size_t> m_rank;
  std::vector<std::size_t> m_contour;     // of crossed edges on the present level
  std::vector<std::size_t> m_arc_of_edge; // of crossed edges on the present level
};

} // namespace smf_test

#endif // SMF_TEST_BRUTE_FORCE_REEB_GRAPH_H
