// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MATCHING_GRAPH_SYMMETRIES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MATCHING_GRAPH_SYMMETRIES_H

#include <CGAL/Surface_mesh_foliation/internal/Common/Disjoint_sets.h>
#include <CGAL/Surface_mesh_foliation/internal/Matching/Labeled_graph.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The automorphisms of a labeled graph that map every arc to one whose quantities are equal up to a
// relative tolerance, by a set of them that generates all others.
//
// Nodes and arcs are treated alike, as elements: node v is element v, and the arcs come after the
// nodes. An automorphism is a permutation of elements that keeps what they are and which of them
// meet; so parallel arcs can be exchanged.
//
// For each element in turn, all automorphisms that fix the elements before it are looked at: for
// every image that it has under one of them but not under those found already, one is added [Sims].
class Graph_symmetries
{
public:
  using Permutation = std::vector<int>; // by element, its image

  Graph_symmetries(const Labeled_graph& graph, double tolerance)
    : m_graph(graph),
      m_tolerance(tolerance),
      m_number_of_nodes(static_cast<int>(graph.labels.size())),
      m_neighbors(graph.labels.size() + graph.arcs.size())
  {
    for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a)
      for (int v : graph.arcs[a].nodes)
      {
        m_neighbors[m_number_of_nodes + a].push_back(v);
        m_neighbors[v].push_back(m_number_of_nodes + a);
      }
    for (std::vector<int>& neighbors : m_neighbors)
      std::sort(neighbors.begin(), neighbors.end());
    sort_elements();
    m_is_incomplete = size() > most_elements;
    if (!m_is_incomplete)
      find_generators();
  }

  const std::vector<Permutation>& generators() const { return m_generators; }

  // whether the graph is too large, or the search ended before everything had been tried
  bool is_incomplete() const { return m_is_incomplete; }

private:
  int size() const { return static_cast<int>(m_neighbors.size()); }

  // by components, each element after one that it meets, so that most of its images are known to be
  // impossible at once
  void sort_elements()
  {
    std::vector<bool> is_met(size(), false);
    for (int first = 0; first < size(); ++first)
    {
      if (is_met[first])
        continue;
      is_met[first] = true;
      m_order.push_back(first);
      for (std::size_t i = m_order.size() - 1; i < m_order.size(); ++i)
        for (int x : m_neighbors[m_order[i]])
          if (!is_met[x])
          {
            is_met[x] = true;
            m_order.push_back(x);
          }
    }
  }

  bool are_alike(int x, int y) const
  {
    if ((x < m_number_of_nodes) != (y < m_number_of_nodes) ||
        m_neighbors[x].size() != m_neighbors[y].size())
      return false;
    if (x < m_number_of_nodes)
      return m_graph.labels[x] == m_graph.labels[y];
    const auto& first = m_graph.arcs[x - m_number_of_nodes].shares;
    const auto& second = m_graph.arcs[y - m_number_of_nodes].shares;
    for (int q = 0; q < Labeled_graph::NUMBER_OF_QUANTITIES; ++q)
      if (std::abs(first[q] - second[q]) > m_tolerance * (std::max)(first[q], second[q]))
        return false;
    return true;
  }

  void find_generators()
  {
    Disjoint_sets orbits(static_cast<std::size_t>(size()));
    for (int i = size() - 1; i >= 0; --i) // the stabilizers of most elements first
      for (int j = i + 1; j < size(); ++j)
      {
        const auto x = static_cast<std::size_t>(m_order[i]),
                   y = static_cast<std::size_t>(m_order[j]);
        if (!are_alike(m_order[i], m_order[j]) || orbits.find_set(x) == orbits.find_set(y))
          continue;
        Permutation found;
        if (!find(i, m_order[j], found))
          continue;
        unite(orbits, found);
        m_generators.push_back(std::move(found));
      }
  }

  static void unite(Disjoint_sets& orbits, const Permutation& permutation)
  {
    for (std::size_t x = 0; x < permutation.size(); ++x)
      orbits.union_set(x, static_cast<std::size_t>(permutation[x]));
  }

  // an automorphism that fixes the first i elements in order and maps the next one to y
  bool find(int i, int y, Permutation& result)
  {
    m_image.assign(size(), NONE);
    m_is_taken.assign(size(), false);
    m_steps = 0;
    for (int k = 0; k < i; ++k)
      assign(m_order[k], m_order[k]);
    if (!fits(m_order[i], y))
      return false;
    assign(m_order[i], y);
    if (!extend(i + 1))
      return false;
    result = m_image;
    return true;
  }

  void assign(int x, int y)
  {
    m_image[x] = y;
    m_is_taken[y] = true;
  }

  // whether y can be the image of x beside those that are known
  bool fits(int x, int y) const
  {
    if (m_is_taken[y] || !are_alike(x, y))
      return false;
    for (int z : m_neighbors[x])
      if (m_image[z] != NONE && !meet(y, m_image[z], times_met(x, z)))
        return false;
    return true;
  }

  int times_met(int x, int y) const
  {
    const auto [first, last] = std::equal_range(m_neighbors[x].begin(), m_neighbors[x].end(), y);
    return static_cast<int>(last - first);
  }

  bool meet(int x, int y, int times) const { return times_met(x, y) == times; }

  bool extend(int i)
  {
    if (i == size())
      return true;
    if (++m_steps > most_steps)
    {
      m_is_incomplete = true;
      return false;
    }
    const int x = m_order[i];
    for (int y : candidates(x))
      if (fits(x, y))
      {
        assign(x, y);
        if (extend(i + 1))
          return true;
        m_image[x] = NONE;
        m_is_taken[y] = false;
      }
    return false;
  }

  // what meets the image of an element that x meets
  std::vector<int> candidates(int x) const
  {
    for (int z : m_neighbors[x])
      if (m_image[z] != NONE)
        return m_neighbors[m_image[z]];
    return m_order;
  }

  static constexpr int NONE = -1, most_steps = 1000000, most_elements = 2000;

  const Labeled_graph& m_graph;
  double m_tolerance;
  int m_number_of_nodes;
  std::vector<std::vector<int>>
    m_neighbors; // by element, sorted; an arc from a node to itself twice
  std::vector<int> m_order;
  std::vector<Permutation> m_generators;
  Permutation m_image; // of the search
  std::vector<bool> m_is_taken;
  int m_steps = 0;
  bool m_is_incomplete = false;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MATCHING_GRAPH_SYMMETRIES_H
