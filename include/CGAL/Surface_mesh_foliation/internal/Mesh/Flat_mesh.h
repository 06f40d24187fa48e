// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_FLAT_MESH_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_FLAT_MESH_H

#include <CGAL/Surface_mesh_foliation/internal/Common/Shared_array.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/halfedges.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

using Point = std::array<double, 3>;
using Triangle = std::array<int, 3>;

// A closed oriented triangle mesh as plain arrays, on which everything inside the package works.
// The halfedges that leave a vertex lie next to each other in counterclockwise order (`ring`), so
// that a walk around a vertex is a linear walk through memory. halfedges.h tells how halfedges and
// edges are numbered. Copies share their arrays.
//
// A mesh with openings is closed by caps (openings.h), whose vertices and faces come after those
// of the input. They are part of the surface for everything that is combinatorial, and never leave
// the package.
class Flat_mesh
{
public:
  Flat_mesh() = default;

  // The i-th halfedge of a face runs from its i-th corner to the next.
  // Precondition: the triangles form a closed oriented manifold without isolated vertices, in which
  // two vertices have at most one edge between them.
  Flat_mesh(std::vector<Point> points, const std::vector<Triangle>& triangles)
    : Flat_mesh(std::move(points), triangles, 0, static_cast<int>(triangles.size()))
  {}

  // The last vertices, and the faces from `first_cap_face` on, belong to caps.
  Flat_mesh(std::vector<Point> points,
            const std::vector<Triangle>& triangles,
            int number_of_caps,
            int first_cap_face)
    : m_number_of_vertices(static_cast<int>(points.size())),
      m_number_of_caps(number_of_caps),
      m_first_cap_face(first_cap_face),
      m_points(std::move(points))
  {
    [[maybe_unused]] const bool is_surface = build_halfedges(triangles) && build_rings();
    CGAL_assertion(is_surface);
  }

  // The mesh of triangles if they form a closed connected oriented manifold as above; otherwise
  // nothing, and the points stay. Precondition: each triangle has three different corners.
  static std::optional<Flat_mesh> of_closed_surface(std::vector<Point>& points,
                                                    const std::vector<Triangle>& triangles)
  {
    Flat_mesh result;
    result.m_number_of_vertices = static_cast<int>(points.size());
    result.m_first_cap_face = static_cast<int>(triangles.size());
    if (!result.build_halfedges(triangles) || !result.build_rings() || !result.is_connected())
      return std::nullopt;
    result.m_points = Shared_array<Point>(std::move(points));
    return result;
  }

  // whether one of two meshes is a copy of the other
  bool is_copy_of(const Flat_mesh& other) const { return m_points.is_shared_with(other.m_points); }

  int number_of_vertices() const { return m_number_of_vertices; }
  int number_of_halfedges() const { return static_cast<int>(m_next.size()); }
  int number_of_edges() const { return edge_of(number_of_halfedges()); }
  int number_of_faces() const { return static_cast<int>(m_face_halfedge.size()); }
  int euler_characteristic() const
  {
    return number_of_vertices() - number_of_edges() + number_of_faces();
  }
  int genus() const { return (2 - euler_characteristic()) / 2; }

  int number_of_caps() const { return m_number_of_caps; }
  int number_of_input_vertices() const { return number_of_vertices() - m_number_of_caps; }
  int number_of_input_faces() const { return m_first_cap_face; }
  bool is_cap_vertex(int v) const { return v >= number_of_input_vertices(); }
  bool is_cap_face(int f) const { return f >= m_first_cap_face; }
  // whether an edge has no face of the input
  bool is_cap_edge(int e) const
  {
    const auto [h, g] = halfedges_of_edge(e);
    return is_cap_face(m_face[h]) && is_cap_face(m_face[g]);
  }
  // whether an edge has a face of the input on one side only
  bool is_border_edge(int e) const
  {
    const auto [h, g] = halfedges_of_edge(e);
    return is_cap_face(m_face[h]) != is_cap_face(m_face[g]);
  }

  int next(int h) const { return m_next[h]; }
  int prev(int h) const { return m_next[m_next[h]]; }
  int target(int h) const { return m_target[h]; }
  int source(int h) const { return m_target[opposite_of(h)]; }
  int face(int h) const { return m_face[h]; }
  int halfedge_of_face(int f) const { return m_face_halfedge[f]; }
  const Point& point(int v) const { return m_points[v]; }
  const std::vector<Point>& points() const { return m_points.values(); }

  // the halfedges of face f, in order
  std::array<int, 3> halfedges(int f) const
  {
    const int h = m_face_halfedge[f];
    return {h, m_next[h], m_next[m_next[h]]};
  }

  // the next halfedge that leaves source(h), counterclockwise
  int rotate(int h) const { return opposite_of(prev(h)); }

  int degree(int v) const { return m_ring_begin[v + 1] - m_ring_begin[v]; }

  struct Ring
  {
    const int* first;
    const int* last;
    const int* begin() const { return first; }
    const int* end() const { return last; }
    int size() const { return static_cast<int>(last - first); }
    int operator[](int i) const { return first[i]; }
  };

  // the halfedges that leave v, counterclockwise
  Ring ring(int v) const
  {
    return {m_ring.data() + m_ring_begin[v], m_ring.data() + m_ring_begin[v + 1]};
  }

  // the halfedge from u to v, or -1
  int find_halfedge(int u, int v) const
  {
    for (int h : ring(u))
      if (m_target[h] == v)
        return h;
    return -1;
  }

private:
  // Corner 3f + i stands for the halfedge from corner i of face f to the next. Sorted by the
  // smaller and then by the larger end, opposite halfedges become neighbors. Returns whether each
  // has one.
  bool build_halfedges(const std::vector<Triangle>& triangles)
  {
    const int n = static_cast<int>(3 * triangles.size());
    if (n % 2 != 0)
      return false;
    const auto source = [&](int c) { return triangles[c / 3][c % 3]; };
    const auto target = [&](int c) { return triangles[c / 3][next3(c)]; };
    using Item = std::pair<int, int>; // the smaller end, and the corner
    const std::vector<Item> by_larger_end = sorted_by_vertex<Item>(
      n, [&](int c) { return (std::max)(source(c), target(c)); },
      [&](int c) { return Item((std::min)(source(c), target(c)), c); });
    const std::vector<int> corners = sorted_by_vertex<int>(
      n, [&](int i) { return by_larger_end[i].first; },
      [&](int i) { return by_larger_end[i].second; });
    std::vector<int> halfedge_of_corner(n), next_of(n), target_of(n), face_of(n),
      face_halfedge(triangles.size());
    for (int h = 0; h < n; ++h)
      halfedge_of_corner[corners[h]] = h;
    for (int h = 0; h < n; h += 2)
    {
      const int a = source(corners[h]), b = target(corners[h]);
      const bool are_opposite = source(corners[h + 1]) == b && target(corners[h + 1]) == a;
      const bool has_more = h + 2 < n && std::minmax(a, b) == std::minmax(source(corners[h + 2]),
                                                                          target(corners[h + 2]));
      if (!are_opposite || has_more)
        return false;
    }
    for (int c = 0; c < n; ++c)
    {
      const int h = halfedge_of_corner[c];
      next_of[h] = halfedge_of_corner[c - c % 3 + next3(c)];
      target_of[h] = target(c);
      face_of[h] = c / 3;
      if (c % 3 == 0)
        face_halfedge[c / 3] = h;
    }
    m_next = Shared_array<int>(std::move(next_of));
    m_target = Shared_array<int>(std::move(target_of));
    m_face = Shared_array<int>(std::move(face_of));
    m_face_halfedge = Shared_array<int>(std::move(face_halfedge));
    return true;
  }

  static int next3(int c) { return (c % 3 + 1) % 3; }

  // The items i = 0, ..., n - 1 in the order of vertex_of(i), then of i, in linear time. Memory is
  // read in order, since the order of a mesh may be random.
  template <class Item, class Vertex_of, class Item_of>
  std::vector<Item> sorted_by_vertex(int n,
                                     const Vertex_of& vertex_of,
                                     const Item_of& item_of) const
  {
    std::vector<int> position(number_of_vertices() + 1, 0);
    for (int i = 0; i < n; ++i)
      ++position[vertex_of(i) + 1];
    std::partial_sum(position.begin(), position.end(), position.begin());
    std::vector<Item> result(n);
    for (int i = 0; i < n; ++i)
      result[position[vertex_of(i)]++] = item_of(i);
    return result;
  }

  // Returns whether the halfedges that leave a vertex form one ring, of at least three.
  bool build_rings()
  {
    std::vector<int> begin(number_of_vertices() + 1, 0), ring(number_of_halfedges());
    for (int h = 0; h < number_of_halfedges(); ++h)
      ++begin[source(h) + 1];
    for (int v = 0; v < number_of_vertices(); ++v)
    {
      if (begin[v + 1] < 3)
        return false;
      begin[v + 1] += begin[v];
    }
    std::vector<bool> is_done(number_of_vertices(), false);
    for (int h = 0; h < number_of_halfedges(); ++h)
    {
      const int v = source(h);
      if (is_done[v])
        continue;
      is_done[v] = true;
      int position = begin[v];
      int g = h;
      do
      {
        ring[position++] = g;
        g = rotate(g);
      } while (g != h);
      if (position != begin[v + 1])
        return false;
    }
    m_ring_begin = Shared_array<int>(std::move(begin));
    m_ring = Shared_array<int>(std::move(ring));
    return true;
  }

  bool is_connected() const
  {
    std::vector<bool> is_reached(number_of_vertices(), false);
    std::vector<int> stack = {0};
    is_reached[0] = true;
    int number = 0;
    while (!stack.empty())
    {
      const int v = stack.back();
      stack.pop_back();
      ++number;
      for (int h : ring(v))
        if (!is_reached[m_target[h]])
        {
          is_reached[m_target[h]] = true;
          stack.push_back(m_target[h]);
        }
    }
    return number == number_of_vertices();
  }

  int m_number_of_vertices = 0, m_number_of_caps = 0, m_first_cap_face = 0;
  Shared_array<Point> m_points;
  Shared_array<int> m_next, m_target, m_face, m_face_halfedge;
  Shared_array<int> m_ring_begin, m_ring;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_FLAT_MESH_H
