// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_DELAUNAY_FLIPS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_DELAUNAY_FLIPS_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Surface_mesh_copy.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The edge u v is replaced by the one between the third corners of its faces, to the left and to
// the right of the direction from u to v.
struct Edge_flip
{
  int u, v, left, right;
};

// The intrinsic Delaunay triangulation of a surface with the metric of a mesh, as far as it is a
// mesh: edges are flipped until none is left whose opposite angles add up to more than pi, except
// where the other diagonal is an edge already, or may not become one. Lengths are those along the
// surface, so the metric stays the same, while the mean of the cotangents of opposite angles
// becomes non-negative at all edges but those.
class Delaunay_flips
{
public:
  // Edges between two vertices with the same non-negative number are neither flipped nor made.
  // Precondition: those of each cap have one.
  Delaunay_flips(const Flat_mesh& mesh, const std::vector<int>& group_of_vertex)
    : m_copy(surface_mesh_copy(mesh)), m_group(group_of_vertex), m_length(num_edges(m_copy))
  {
    for (const Edge e : edges(m_copy))
      m_length[e] =
        std::sqrt(CGAL::squared_distance(m_copy.point(source(halfedge(e, m_copy), m_copy)),
                                         m_copy.point(target(halfedge(e, m_copy), m_copy))));
    flip_edges();
    build_mesh(mesh);
    m_copy = {};
    m_length = {};
  }

  const Flat_mesh& mesh() const { return m_mesh; }
  const std::vector<Edge_flip>& flips() const { return m_flips; }

  // by edge of `mesh()`, the mean of the cotangents of the two opposite angles
  const std::vector<double>& cotangents() const { return m_cotangents; }

private:
  using Vertex = Surface_mesh_copy::Vertex_index;
  using Edge = Surface_mesh_copy::Edge_index;
  using Halfedge = Surface_mesh_copy::Halfedge_index;

  double length(Halfedge h) const { return m_length[edge(h, m_copy)]; }

  // twice the area of the face of h, by Kahan's formula
  double double_area(Halfedge h) const
  {
    std::array<double, 3> s = {length(h), length(next(h, m_copy)), length(prev(h, m_copy))};
    std::sort(s.begin(), s.end());
    const auto [c, b, a] = s;
    const double square = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
    return std::sqrt((std::max)(square, 0.)) / 2;
  }

  // the scalar product of the two sides of the corner at source(h)
  double dot_at_source(Halfedge h) const
  {
    const double a = length(h), b = length(prev(h, m_copy)), c = length(next(h, m_copy));
    return (a * a + (b - c) * (b + c)) / 2;
  }

  double angle_at_source(Halfedge h) const { return std::atan2(double_area(h), dot_at_source(h)); }

  // of a corner with a side of length 0: 0
  double cotangent_at_source(Halfedge h) const
  {
    constexpr double least_sine = 1e-14;
    const double product = length(h) * length(prev(h, m_copy));
    return product > 0 ? dot_at_source(h) / (std::max)(double_area(h), least_sine * product) : 0;
  }

  double cotangent_of(Edge e) const
  {
    const Halfedge h = halfedge(e, m_copy), g = opposite(h, m_copy);
    return (cotangent_at_source(prev(h, m_copy)) + cotangent_at_source(prev(g, m_copy))) / 2;
  }

  bool are_in_one_group(Vertex u, Vertex v) const
  {
    return m_group[u] >= 0 && m_group[u] == m_group[v];
  }

  void flip_edges()
  {
    const std::size_t most_flips =
      100 * static_cast<std::size_t>(num_edges(m_copy)); // rounding may make flips go in circles
    std::deque<Edge> queue(edges(m_copy).begin(), edges(m_copy).end());
    while (!queue.empty() && m_flips.size() < most_flips)
    {
      const Edge e = queue.front();
      queue.pop_front();
      const Halfedge h = halfedge(e, m_copy), g = opposite(h, m_copy);
      if (!flip(e))
        continue;
      for (const Halfedge side :
           {next(h, m_copy), prev(h, m_copy), next(g, m_copy), prev(g, m_copy)})
        queue.push_back(edge(side, m_copy));
    }
  }

  bool flip(Edge e)
  {
    constexpr double rounding = 1e-9;
    if (!(cotangent_of(e) < -rounding))
      return false;
    const Halfedge h = halfedge(e, m_copy), g = opposite(h, m_copy);
    const Vertex u = source(h, m_copy), v = target(h, m_copy);
    const Vertex left = target(next(h, m_copy), m_copy), right = target(next(g, m_copy), m_copy);
    if (left == right || halfedge(left, right, m_copy).second || degree(u, m_copy) <= 3 ||
        degree(v, m_copy) <= 3 || are_in_one_group(u, v) || are_in_one_group(left, right))
      return false;
    const double at_u = angle_at_source(h) + angle_at_source(next(g, m_copy));
    const double at_v = angle_at_source(g) + angle_at_source(next(h, m_copy));
    const double straight = std::acos(-1.) - rounding;
    if (at_u >= straight || at_v >= straight)
      return false;
    const double a = length(prev(h, m_copy)), b = length(next(g, m_copy));
    const double sine = std::sin(at_u / 2);
    const double diagonal = std::sqrt((a - b) * (a - b) + 4 * a * b * sine * sine);
    m_flips.push_back(
      {static_cast<int>(u), static_cast<int>(v), static_cast<int>(left), static_cast<int>(right)});
    CGAL::Euler::flip_edge(h, m_copy);
    m_length[edge(h, m_copy)] = diagonal;
    return true;
  }

  void build_mesh(const Flat_mesh& before)
  {
    std::vector<Triangle> triangles;
    for (const auto f : faces(m_copy))
    {
      const Halfedge h = halfedge(f, m_copy);
      triangles.push_back({static_cast<int>(source(h, m_copy)), static_cast<int>(target(h, m_copy)),
                           static_cast<int>(target(next(h, m_copy), m_copy))});
    }
    m_mesh = Flat_mesh(before.points(), triangles, before.number_of_caps(),
                       before.number_of_input_faces());
    m_cotangents.resize(m_mesh.number_of_edges());
    for (const Edge e : edges(m_copy))
    {
      const Halfedge h = halfedge(e, m_copy);
      m_cotangents[edge_of(m_mesh.find_halfedge(static_cast<int>(source(h, m_copy)),
                                                static_cast<int>(target(h, m_copy))))] =
        cotangent_of(e);
    }
  }

  Surface_mesh_copy m_copy;
  const std::vector<int>& m_group;
  std::vector<double> m_length; // by edge of the copy
  std::vector<Edge_flip> m_flips;
  Flat_mesh m_mesh;
  std::vector<double> m_cotangents;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_DELAUNAY_FLIPS_H
