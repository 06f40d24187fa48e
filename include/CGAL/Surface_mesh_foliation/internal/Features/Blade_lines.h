// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FEATURES_BLADE_LINES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FEATURES_BLADE_LINES_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Features/Normal_spreads.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Blades are connected sets of vertices around which the normals of both sides cancel but are
// parallel. The line of a blade is the longest path along its rim, where they cancel within a
// smaller ball already: it is a shortest path for lengths that make detours through flat parts
// expensive.
class Blade_lines
{
public:
  Blade_lines(const Flat_mesh& mesh,
              const std::vector<Point>& points,
              Blade_measures measures,
              double least_alignment,
              double least_length)
    : m_mesh(mesh),
      m_points(points),
      m_sharpness(std::move(measures.sharpness)),
      m_blade(mesh.number_of_vertices(), NONE),
      m_cost(mesh.number_of_vertices()),
      m_length(mesh.number_of_vertices()),
      m_previous(mesh.number_of_vertices())
  {
    for (int v = 0; v < mesh.number_of_vertices(); ++v)
      if (measures.wide.mean[v] < largest_mean && measures.wide.alignment[v] > least_alignment)
        m_blade[v] = UNSEEN;
    for (int v = 0; v < mesh.number_of_vertices(); ++v)
      if (m_blade[v] == UNSEEN)
        find_line(v, least_length);
  }

  // each an induced path, no two with a vertex in common
  const std::vector<std::vector<int>>& lines() const { return m_lines; }

private:
  static constexpr int NONE = -2, UNSEEN = -1;
  static constexpr double largest_mean = 0.5, largest_mean_at_rim = 0.8;

  void find_line(int seed, double least_length)
  {
    const int blade = static_cast<int>(m_blades++);
    std::vector<int> vertices = {seed};
    m_blade[seed] = blade;
    for (std::size_t i = 0; i < vertices.size(); ++i)
      for (int h : m_mesh.ring(vertices[i]))
        if (m_blade[m_mesh.target(h)] == UNSEEN)
        {
          m_blade[m_mesh.target(h)] = blade;
          vertices.push_back(m_mesh.target(h));
        }
    const int sharpest = *std::min_element(vertices.begin(), vertices.end(), [&](int u, int v) {
      return m_sharpness[u] < m_sharpness[v] || (m_sharpness[u] == m_sharpness[v] && u < v);
    });
    if (m_sharpness[sharpest] >= largest_mean_at_rim)
      return;
    const int begin = farthest_on_rim(sharpest, vertices);
    const int end = farthest_on_rim(begin, vertices);
    if (m_length[end] >= least_length)
      m_lines.push_back(induced_path(begin, end));
  }

  // Finds the cheapest paths from a vertex to all vertices of its blade, and returns the vertex of
  // the rim to which the path is longest.
  int farthest_on_rim(int start, const std::vector<int>& vertices)
  {
    using Entry = std::pair<double, int>;
    for (int v : vertices)
      m_cost[v] = std::numeric_limits<double>::infinity();
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    reach(start, 0, 0, NONE, queue);
    int result = start;
    while (!queue.empty())
    {
      const auto [cost, u] = queue.top();
      queue.pop();
      if (cost > m_cost[u])
        continue;
      if (m_sharpness[u] < largest_mean_at_rim && m_length[u] > m_length[result])
        result = u;
      for (int h : m_mesh.ring(u))
      {
        const int v = m_mesh.target(h);
        const double length = distance(u, v);
        const double next_cost = cost + length * std::pow(m_sharpness[v], 4);
        if (m_blade[v] == m_blade[start] && next_cost < m_cost[v])
          reach(v, next_cost, m_length[u] + length, u, queue);
      }
    }
    return result;
  }

  double distance(int u, int v) const { return internal::distance(m_points[u], m_points[v]); }

  template <class Queue>
  void reach(int v, double cost, double length, int previous, Queue& queue)
  {
    m_cost[v] = cost;
    m_length[v] = length;
    m_previous[v] = previous;
    queue.emplace(cost, v);
  }

  // The path found last, shortened where edges join two of its vertices that are not consecutive:
  // the path through its vertices with the fewest edges.
  std::vector<int> induced_path(int begin, int end)
  {
    std::vector<int> path;
    for (int v = end; v != NONE; v = m_previous[v])
      path.push_back(v);
    std::sort(path.begin(), path.end());
    const auto is_on_path = [&](int v) { return std::binary_search(path.begin(), path.end(), v); };
    std::vector<int> reached = {end};
    for (int v : path)
      m_previous[v] = NONE;
    for (std::size_t i = 0; i < reached.size() && m_previous[begin] == NONE; ++i)
      for (int h : m_mesh.ring(reached[i]))
      {
        const int v = m_mesh.target(h);
        if (v != end && m_previous[v] == NONE && is_on_path(v))
        {
          m_previous[v] = reached[i];
          reached.push_back(v);
        }
      }
    std::vector<int> result;
    for (int v = begin; v != NONE; v = m_previous[v])
      result.push_back(v);
    return result;
  }

  const Flat_mesh& m_mesh;
  const std::vector<Point>& m_points;
  std::vector<double> m_sharpness; // by vertex, 1 where flat
  std::vector<int> m_blade;        // by vertex
  std::size_t m_blades = 0;
  std::vector<double> m_cost, m_length; // by vertex, of the path from the start to it
  std::vector<int> m_previous;          // by vertex, on this path
  std::vector<std::vector<int>> m_lines;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FEATURES_BLADE_LINES_H
