// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_SOUP_EDGES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_SOUP_EDGES_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Triangle_soup.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// determines which sides of the triangles of a soup are the same edge.
//
// Side 3f+i of the soup goes from corner i of face f to its next corner. Sides with the same two
// vertices, in whatever order, form an edge. Indices of the soup must be valid and the corners of
// each face must differ. Time O(n log d), where d is the largest number of sides at a vertex.
class Soup_edges
{
public:
  explicit Soup_edges(const Triangle_soup& soup) : m_soup(soup)
  {
    sort_sides();
    find_first_sides();
  }

  std::size_t size() const { return m_first.size() - 1; }

  // the number of sides of an edge: 1 at the border, 2 inside a surface
  std::size_t number_of_sides(std::size_t edge) const { return m_first[edge + 1] - m_first[edge]; }

  // the i-th side of an edge, in ascending order
  std::size_t side(std::size_t edge, std::size_t i) const { return m_sides[m_first[edge] + i]; }

  std::size_t source(std::size_t side) const { return m_soup.triangles[side / 3][side % 3]; }
  std::size_t target(std::size_t side) const { return m_soup.triangles[side / 3][next(side) % 3]; }

  static std::size_t face(std::size_t side) { return side / 3; }
  static std::size_t next(std::size_t side) { return side % 3 == 2 ? side - 2 : side + 1; }

private:
  using Number = std::uint32_t; // half the memory
  using Vertex_pair = std::pair<Number, Number>;

  Vertex_pair vertex_pair(std::size_t side) const
  {
    const auto a = static_cast<Number>(source(side)), b = static_cast<Number>(target(side));
    return a < b ? Vertex_pair(a, b) : Vertex_pair(b, a);
  }

  // by smaller vertex (counting sort), larger vertex, and number
  void sort_sides()
  {
    const auto number_of_sides = static_cast<Number>(3 * m_soup.triangles.size());
    std::vector<Number> bucket_end(m_soup.points.size() + 1, 0);
    for (Number side = 0; side < number_of_sides; ++side)
      ++bucket_end[vertex_pair(side).first + 1];
    for (std::size_t vertex = 0; vertex < m_soup.points.size(); ++vertex)
      bucket_end[vertex + 1] += bucket_end[vertex];

    std::vector<Vertex_pair> sides(number_of_sides); // larger vertex and side
    for (Number side = 0; side < number_of_sides; ++side)
    {
      const auto [smaller_vertex, larger_vertex] = vertex_pair(side);
      sides[bucket_end[smaller_vertex]++] = {larger_vertex, side};
    }
    auto begin = sides.begin();
    for (std::size_t vertex = 0; vertex < m_soup.points.size(); ++vertex)
    {
      const auto end = sides.begin() + static_cast<std::ptrdiff_t>(bucket_end[vertex]);
      std::sort(begin, end);
      begin = end;
    }
    m_sides.reserve(number_of_sides);
    for (const auto& [larger_vertex, side] : sides)
      m_sides.push_back(side);
  }

  void find_first_sides()
  {
    m_first.reserve(m_sides.size() / 2 + 1);
    for (std::size_t i = 0; i < m_sides.size(); ++i)
      if (i == 0 || vertex_pair(m_sides[i]) != vertex_pair(m_sides[i - 1]))
        m_first.push_back(static_cast<Number>(i));
    m_first.push_back(static_cast<Number>(m_sides.size()));
  }

  const Triangle_soup& m_soup;
  std::vector<Number> m_sides; // sides of the same edge are neighbors
  std::vector<Number> m_first; // the place in m_sides of the first side of each edge
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_SOUP_EDGES_H
