// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FEATURES_PERSISTENT_MAXIMA_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FEATURES_PERSISTENT_MAXIMA_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// A local maximum, and its height over the level where its hill ends, usually the pass to a higher
// maximum: the ratio of the two values.
struct Maximum
{
  int vertex;
  double persistence;
};

// The local maxima of a positive function on the vertices of a mesh, the most persistent first, by
// a sweep from above that joins the hills around them: at a pass, the lower of two hills ends. The
// highest of all ends at the minimum, or, on a surface with handles, where it is a disk for the
// last time: below, it runs around a handle and has no tip, like the crest of a ring, whose highest
// vertex is nothing special. Equal values are ordered by vertex.
class Persistent_maxima
{
public:
  Persistent_maxima(const Flat_mesh& mesh, const std::vector<double>& values)
    : m_values(values), m_rank(values.size()), m_hill(values.size()), m_euler(values.size(), 0)
  {
    std::vector<int> order(values.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int u, int v) {
      return values[u] > values[v] || (values[u] == values[v] && u < v);
    });
    for (std::size_t i = 0; i < order.size(); ++i)
      m_rank[order[i]] = static_cast<int>(i);
    std::iota(m_hill.begin(), m_hill.end(), 0);
    int last_disk = order.front();
    for (int v : order)
    {
      m_euler[v] = new_euler_characteristic(mesh, v);
      for (int h : mesh.ring(v))
        if (m_rank[mesh.target(h)] < m_rank[v])
          join(v, mesh.target(h));
      const int hill = top(v);
      if (hill == order.front() && m_euler[hill] == 1)
        last_disk = v;
    }
    end(order.front(), mesh.genus() > 0 ? last_disk : order.back());
    std::stable_sort(m_maxima.begin(), m_maxima.end(), [](const Maximum& a, const Maximum& b) {
      return a.persistence > b.persistence;
    });
  }

  const std::vector<Maximum>& maxima() const { return m_maxima; }

private:
  // of the vertices, edges and faces that a vertex adds to those above
  int new_euler_characteristic(const Flat_mesh& mesh, int v) const
  {
    int result = 1;
    for (int h : mesh.ring(v))
    {
      const bool is_above = m_rank[mesh.target(h)] < m_rank[v];
      const bool is_next_above = m_rank[mesh.target(mesh.rotate(h))] < m_rank[v];
      result += (is_above && is_next_above) - is_above;
    }
    return result;
  }

  // the top of the hill of v
  int top(int v)
  {
    while (m_hill[v] != v)
      v = m_hill[v] = m_hill[m_hill[v]];
    return v;
  }

  // joins the hills of v, the lowest vertex so far, and its neighbor u
  void join(int v, int u)
  {
    int high = top(v), low = top(u);
    if (high == low)
      return;
    if (m_rank[low] < m_rank[high])
      std::swap(low, high);
    m_hill[low] = high;
    m_euler[high] += m_euler[low];
    if (low != v)
      end(low, v);
  }

  void end(int maximum, int last)
  {
    m_maxima.push_back({maximum, m_values[last] > 0 ? m_values[maximum] / m_values[last]
                                                    : std::numeric_limits<double>::infinity()});
  }

  const std::vector<double>& m_values;
  std::vector<int> m_rank;  // by vertex, from above
  std::vector<int> m_hill;  // by vertex: a vertex nearer to the top of its hill, or itself
  std::vector<int> m_euler; // by top: the Euler characteristic of its hill
  std::vector<Maximum> m_maxima;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FEATURES_PERSISTENT_MAXIMA_H
