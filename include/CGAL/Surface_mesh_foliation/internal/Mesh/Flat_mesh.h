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
  // Stands for the halfedge of a face from a corner, 3f + i, to the next.
  struct Corner
  {
    int larger_end, corner;
    bool is_from_smaller_end;
    friend bool operator<(const Corner& c, const Corner& d)
    {
      return c.larger_end != d.larger_end ? c.larger_end < d.larger_end : c.corner < d.corner;
    }
  };

  // Sorted by the smaller and then by the larger end, opposite halfedges become neighbors. Returns
  // whether each has one.
  bool build_halfedges(const std::vector<Triangle>& triangles)
  {
    const int n = static_cast<int>(3 * triangles.size());
    if (n % 2 != 0)
      return false;
    std::vector<int> halfedge_of_corner(n), next_of(n), target_of(n), face_of(n),
      face_halfedge(triangles.size());
    {
      std::vector<int> end;
      std::vector<Corner> corners = corners_by_smaller_end(triangles, end);
      for (int v = 0, begin = 0; v < number_of_vertices(); begin = end[v++])
      {
        std::sort(corners.begin() + begin, corners.begin() + end[v]);
        if (!are_pairs(corners, begin, end[v]))
          return false;
        for (int h = begin; h < end[v]; ++h)
        {
          const Corner& c = corners[h];
          target_of[h] = c.is_from_smaller_end ? c.larger_end : v;
          face_of[h] = c.corner / 3;
          halfedge_of_corner[c.corner] = h;
        }
      }
    }
    for (int f = 0; f < static_cast<int>(triangles.size()); ++f)
    {
      const int a = halfedge_of_corner[3 * f], b = halfedge_of_corner[3 * f + 1],
                c = halfedge_of_corner[3 * f + 2];
      face_halfedge[f] = a;
      next_of[a] = b;
      next_of[b] = c;
      next_of[c] = a;
    }
    m_next = Shared_array<int>(std::move(next_of));
    m_target = Shared_array<int>(std::move(target_of));
    m_face = Shared_array<int>(std::move(face_of));
    m_face_halfedge = Shared_array<int>(std::move(face_halfedge));
    return true;
  }

  // `end`: by vertex, of those whose smaller end it is
  std::vector<Corner> corners_by_smaller_end(const std::vector<Triangle>& triangles,
                                             std::vector<int>& end) const
  {
    end.assign(number_of_vertices() + 1, 0);
    for (const auto& [a, b, c] : triangles)
    {
      ++end[(std::min)(a, b) + 1];
      ++end[(std::min)(b, c) + 1];
      ++end[(std::min)(c, a) + 1];
    }
    std::partial_sum(end.begin(), end.end(), end.begin());
    std::vector<Corner> result(3 * triangles.size());
    const auto add = [&](int source, int target, int corner) {
      const bool is_from_smaller_end = source < target;
      const auto [smaller, larger] = std::minmax(source, target);
      result[end[smaller]++] = {larger, corner, is_from_smaller_end};
    };
    for (int f = 0; f < static_cast<int>(triangles.size()); ++f)
    {
      const auto& [a, b, c] = triangles[f];
      add(a, b, 3 * f);
      add(b, c, 3 * f + 1);
      add(c, a, 3 * f + 2);
    }
    return result;
  }

  // Whether those in [begin, end), sorted and with one smaller end, are pairs of opposite
  // halfedges, each with another larger end.
  static bool are_pairs(const std::vector<Corner>& corners, int begin, int end)
  {
    if ((end - begin) % 2 != 0)
      return false;
    for (int i = begin; i < end; i += 2)
    {
      const bool is_pair = corners[i].larger_end == corners[i + 1].larger_end &&
                           corners[i].is_from_smaller_end != corners[i + 1].is_from_smaller_end;
      if (!is_pair || (i > begin && corners[i].larger_end == corners[i - 1].larger_end))
        return false;
    }
    return true;
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
