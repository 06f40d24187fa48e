// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_EDGE_COLLAPSES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_EDGE_COLLAPSES_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <random>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Coarsens a closed triangle mesh by half-edge collapses: vertices are merged into neighbors, in a
// shuffled order, until a given number is left or no collapse is possible. Each collapse satisfies
// the link condition, so the result is a closed manifold mesh of the same genus, with degrees from
// 4 to 11 where the mesh had such degrees. Clusters grow evenly.
class Edge_collapses
{
public:
  // is_kept: by vertex, whether it must not be merged into another
  Edge_collapses(const Flat_mesh& mesh, const std::vector<bool>& is_kept, int goal)
    : Edge_collapses(mesh, is_kept, {}, goal, 2)
  {}

  // Merges vertices only into others of the same set, as many as possible, without limiting how
  // clusters grow.
  Edge_collapses(const Flat_mesh& mesh,
                 const std::vector<bool>& is_kept,
                 const std::vector<int>& set_of_vertex)
    : Edge_collapses(mesh, is_kept, set_of_vertex, 0, mesh.number_of_vertices())
  {}

  // Merges vertices along the shortest edges first, so that the vertices that are left are spread
  // evenly over the surface, however they were spread before. `fineness`, if not empty, says by
  // vertex how many times closer to each other they are to be there.
  static Edge_collapses with_even_lengths(const Flat_mesh& mesh,
                                          const std::vector<bool>& is_kept,
                                          int goal,
                                          std::vector<double> fineness = {})
  {
    return Edge_collapses(mesh, is_kept, {}, goal, mesh.number_of_vertices(), &mesh.points(),
                          std::move(fineness));
  }

  int number_left() const { return m_number_left; }

  // the vertex that v ended in
  int representative(int v)
  {
    while (m_into[v] != v)
      v = m_into[v] = m_into[m_into[v]];
    return v;
  }

private:
  using Neighbors = boost::container::small_vector<int, 12>; // few have more than max_degree

  // what is looked up of a neighbor lies together in memory
  struct Vertex
  {
    int size = 1;        // of its cluster, if it is left
    int mark = -1;       // the last vertex whose neighbors were marked
    Neighbors neighbors; // in any order
  };

  // set_of_vertex: empty if there is one set
  Edge_collapses(const Flat_mesh& mesh,
                 const std::vector<bool>& is_kept,
                 const std::vector<int>& set_of_vertex,
                 int goal,
                 int largest_size,
                 const std::vector<Point>* points = nullptr,
                 std::vector<double> fineness = {})
    : m_points(points),
      m_fineness(std::move(fineness)),
      m_set(set_of_vertex),
      m_into(mesh.number_of_vertices()),
      m_vertices(mesh.number_of_vertices()),
      m_number_left(mesh.number_of_vertices())
  {
    std::iota(m_into.begin(), m_into.end(), 0);
    for (int v = 0; v < mesh.number_of_vertices(); ++v)
    {
      m_vertices[v].neighbors.reserve(mesh.degree(v) + 2);
      for (int h : mesh.ring(v))
        m_vertices[v].neighbors.push_back(mesh.target(h));
      if (degree(v) > hub_degree)
        for (int i = 0; i < degree(v); ++i)
          m_places_at_hub[v].emplace(m_vertices[v].neighbors[i], i);
    }
    const std::vector<int> order = shuffled(is_kept);
    if (m_points != nullptr)
      collapse_short_edges(mesh, order, goal);
    bool is_stuck = false; // clusters may have any size, yet hardly any can still grow
    while (m_number_left > goal && !is_stuck)
    {
      const int before = m_number_left;
      for (std::size_t i = 0; i < order.size() && m_number_left > goal; ++i)
        if (m_into[order[i]] == order[i])
          collapse(order[i], largest_size);
      is_stuck = m_number_left > 0.99 * before && largest_size >= mesh.number_of_vertices();
      if (m_number_left > 0.95 * before)
        largest_size = (std::min)(2 * largest_size, mesh.number_of_vertices());
    }
    m_set = {};
    m_fineness = {};
    m_vertices = {};
    m_places_at_hub = {};
  }

  // in passes, with a bound on lengths that grows from a fraction of what they will be in the end
  void collapse_short_edges(const Flat_mesh& mesh, const std::vector<int>& order, int goal)
  {
    constexpr double first = 0.1, growth = 1.15, last = 4;
    m_scale = 1 / half_size(bounding_box(*m_points));
    m_shortest_square.assign(mesh.number_of_vertices(), UNKNOWN);
    double squares = 0; // of all edges
    for (int e = 0; e < mesh.number_of_edges(); ++e)
      squares += square_of_length(mesh.source(halfedge_of(e)), mesh.target(halfedge_of(e)));
    const double ratio = static_cast<double>(mesh.number_of_vertices()) / (std::max)(goal, 1);
    const double final_square = ratio * squares / mesh.number_of_edges();
    for (double bound = first; bound < last && m_number_left > goal; bound *= growth)
    {
      m_longest_square = bound * bound * final_square;
      for (std::size_t i = 0; i < order.size() && m_number_left > goal; ++i)
        if (m_into[order[i]] == order[i])
          collapse(order[i], mesh.number_of_vertices());
    }
    m_longest_square = (std::numeric_limits<double>::infinity)();
    m_shortest_square = {};
  }

  // whether all edges of v are too long; in most passes this is known from an earlier one
  bool has_long_edges_only(int v)
  {
    if (m_shortest_square.empty())
      return false;
    double& shortest = m_shortest_square[v];
    if (shortest == UNKNOWN)
    {
      shortest = (std::numeric_limits<double>::infinity)();
      for (int u : m_vertices[v].neighbors)
        shortest = (std::min)(shortest, square_of_length(u, v));
    }
    return shortest > m_longest_square;
  }

  double square_of_length(int u, int v) const
  {
    const Point &p = (*m_points)[u], &q = (*m_points)[v];
    const double scale =
      m_fineness.empty() ? m_scale : m_scale * (std::max)(m_fineness[u], m_fineness[v]);
    const double x = (p[0] - q[0]) * scale, y = (p[1] - q[1]) * scale, z = (p[2] - q[2]) * scale;
    return x * x + y * y + z * z;
  }

  static std::vector<int> shuffled(const std::vector<bool>& is_kept)
  {
    std::vector<int> result;
    for (std::size_t v = 0; v < is_kept.size(); ++v)
      if (!is_kept[v])
        result.push_back(static_cast<int>(v));
    std::mt19937 random; // the same numbers with every library, unlike std::shuffle
    for (std::size_t i = result.size(); i > 1; --i)
      std::swap(result[i - 1], result[random() % i]);
    return result;
  }

  // merges v into the neighbor where the degree and the cluster stay smallest, if any is suitable
  void collapse(int v, int largest_size)
  {
    if (has_long_edges_only(v))
      return;
    mark_neighbors(v);
    int best = -1;
    double least_cost = 0;
    for (int u : m_vertices[v].neighbors)
    {
      const int degree_of_result = degree(u) + degree(v) - 4;
      if (m_vertices[u].size + m_vertices[v].size > 2 * largest_size ||
          degree_of_result < min_degree || degree_of_result > max_degree || !are_in_one_set(u, v) ||
          is_too_long(u, v))
        continue;
      const double cost = degree_of_result + 0.5 * m_vertices[u].size;
      if ((best < 0 || cost < least_cost) && is_collapsible(v, u))
      {
        best = u;
        least_cost = cost;
      }
    }
    if (best >= 0)
      merge_into(v, best);
  }

  bool is_too_long(int u, int v) const
  {
    return m_points != nullptr && square_of_length(u, v) > m_longest_square;
  }
  bool are_in_one_set(int u, int v) const { return m_set.empty() || m_set[u] == m_set[v]; }
  int degree(int v) const { return static_cast<int>(m_vertices[v].neighbors.size()); }

  void mark_neighbors(int v)
  {
    for (int x : m_vertices[v].neighbors)
      m_vertices[x].mark = v;
  }

  // The link condition, and whether the two opposite vertices keep the minimum degree. The
  // neighbors of v must be marked. (Old marks do no harm: neighbors stay neighbors as long as both
  // remain.)
  bool is_collapsible(int v, int u) const
  {
    int common = 0;
    bool is_least_kept = true;
    for (int x : m_vertices[u].neighbors)
      if (m_vertices[x].mark == v)
      {
        ++common;
        is_least_kept = is_least_kept && degree(x) > min_degree;
      }
    return common == 2 && is_least_kept;
  }

  void merge_into(int v, int u)
  {
    mark_neighbors(u);
    for (int x : m_vertices[v].neighbors)
    {
      if (!m_shortest_square.empty())
        m_shortest_square[x] = UNKNOWN;
      if (x == u || m_vertices[x].mark == u)
      {
        put_neighbor(x, v, m_vertices[x].neighbors.back());
        m_vertices[x].neighbors.pop_back();
      }
      else
      {
        put_neighbor(x, v, u);
        m_vertices[u].neighbors.push_back(x);
      }
    }
    m_vertices[v].neighbors = {};
    m_into[v] = u;
    m_vertices[u].size += m_vertices[v].size;
    --m_number_left;
  }

  // puts u in the place of neighbor v of x. A hub may lose most of its neighbors one by one, so
  // they are not searched for.
  void put_neighbor(int x, int v, int u)
  {
    Neighbors& neighbors = m_vertices[x].neighbors;
    if (degree(x) <= hub_degree)
    {
      *std::find(neighbors.begin(), neighbors.end(), v) = u;
      return;
    }
    std::unordered_map<int, int>& places = m_places_at_hub.at(x);
    const int place = places.at(v);
    neighbors[place] = u;
    places[u] = place;
    if (u != v)
      places.erase(v);
  }

  static constexpr double UNKNOWN = -1;
  static constexpr int min_degree = 4;
  static constexpr int max_degree = 11;
  static constexpr int hub_degree = 64; // no vertex is merged into one that has so many neighbors

  const std::vector<Point>* m_points; // null if lengths do not matter
  std::vector<double> m_fineness;     // by vertex, or empty
  double m_scale = 1;                 // to about unit size
  double m_longest_square = (std::numeric_limits<double>::infinity)();
  std::vector<double> m_shortest_square; // by vertex, of its edges, or UNKNOWN; empty if not needed
  std::vector<int> m_set;
  std::vector<int> m_into; // by vertex: itself as long as it remains
  std::vector<Vertex> m_vertices;
  // by vertex with more than hub_degree neighbors: where each of them is in its list
  std::unordered_map<int, std::unordered_map<int, int>> m_places_at_hub;
  int m_number_left;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_EDGE_COLLAPSES_H
