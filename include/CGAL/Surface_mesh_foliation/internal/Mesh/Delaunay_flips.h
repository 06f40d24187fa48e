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
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The edge u v, between the third corners of its faces to the left and to the right of the
// direction from u to v, is replaced by the edge from left to right, or, if `middle` is a vertex,
// divided at its middle, which becomes a neighbor of the four others.
struct Edge_change
{
  static constexpr int NONE = -1;

  int u, v, left, right;
  int middle = NONE;
};

// The intrinsic Delaunay triangulation of a surface with the metric of a mesh, as far as it is a
// mesh: edges are flipped until none is left whose opposite angles add up to more than pi, except
// where the other diagonal is an edge already, or may not become one. Edges that are much longer
// than most are divided, and so are those at a pole. Lengths are those along the surface, so the
// metric stays the same, while the mean of the cotangents of opposite angles becomes non-negative
// at all edges but those.
class Delaunay_flips
{
public:
  // lengths: by edge
  // Edges between two vertices with the same non-negative number, that of a pole, are neither
  // divided, flipped nor made. Precondition: those of each cap have one.
  Delaunay_flips(const Flat_mesh& mesh,
                 const std::vector<double>& lengths,
                 std::vector<int> group_of_vertex)
    : m_copy(surface_mesh_copy(mesh)),
      m_group(std::move(group_of_vertex)),
      m_length(num_edges(m_copy))
  {
    for (const Edge e : edges(m_copy))
    {
      const Halfedge h = halfedge(e, m_copy);
      m_length[e] = lengths[edge_of(mesh.find_halfedge(static_cast<int>(source(h, m_copy)),
                                                       static_cast<int>(target(h, m_copy))))];
    }
    flip_edges({edges(m_copy).begin(), edges(m_copy).end()});
    divide_long_edges();
    divide_edges_at_poles();
    build_mesh(mesh);
    m_copy = {};
    m_length = {};
  }

  // The vertices of the mesh before come first.
  const Flat_mesh& mesh() const { return m_mesh; }
  const std::vector<Edge_change>& changes() const { return m_changes; }

  // A set of vertices, by vertex of the mesh before, on `mesh()`: with the middles of edges between
  // two of them.
  std::vector<bool> with_middles(std::vector<bool> contains) const
  {
    contains.resize(m_mesh.number_of_vertices(), false);
    for (const Edge_change& change : m_changes)
      if (change.middle != Edge_change::NONE)
        contains[change.middle] = contains[change.u] && contains[change.v];
    return contains;
  }

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

  // those in the queue, and beside them; returns those that were flipped
  std::vector<Edge> flip_edges(std::deque<Edge> queue)
  {
    const std::size_t most_flips = 100 * queue.size(); // rounding may make flips go in circles
    std::vector<Edge> flipped;
    while (!queue.empty() && flipped.size() < most_flips)
    {
      const Edge e = queue.front();
      queue.pop_front();
      if (!flip(e))
        continue;
      flipped.push_back(e);
      const Halfedge h = halfedge(e, m_copy), g = opposite(h, m_copy);
      for (const Halfedge side :
           {next(h, m_copy), prev(h, m_copy), next(g, m_copy), prev(g, m_copy)})
        queue.push_back(edge(side, m_copy));
    }
    return flipped;
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
    note_change(h);
    CGAL::Euler::flip_edge(h, m_copy);
    m_length[edge(h, m_copy)] = diagonal;
    return true;
  }

  void note_change(Halfedge h, int middle = Edge_change::NONE)
  {
    const Halfedge g = opposite(h, m_copy);
    m_changes.push_back({static_cast<int>(source(h, m_copy)), static_cast<int>(target(h, m_copy)),
                         static_cast<int>(target(next(h, m_copy), m_copy)),
                         static_cast<int>(target(next(g, m_copy), m_copy)), middle});
  }

  // Across a face that is long and flat there are few vertices, too few for what runs through it.
  // So edges more than three times as long as in a mesh of equilateral triangles with as many
  // vertices are divided, the longest first, each followed by flips. There are few such edges in a
  // mesh that is anything like even.
  void divide_long_edges()
  {
    constexpr double longest = 3;
    const std::size_t most_vertices = 4 * static_cast<std::size_t>(num_vertices(m_copy));
    double double_areas = 0;
    for (const auto f : faces(m_copy))
      double_areas += double_area(halfedge(f, m_copy));
    const double bound = longest * std::sqrt(double_areas / static_cast<double>(num_faces(m_copy)) *
                                             2 / std::sqrt(3.));
    // Lengths that differ by rounding count as equal: these do not decide which one goes first.
    std::priority_queue<std::pair<float, Edge>> queue;
    const auto add = [&](Edge e) {
      if (m_length[e] > bound)
        queue.emplace(static_cast<float>(m_length[e]), e);
    };
    for (const Edge e : edges(m_copy))
      add(e);
    while (!queue.empty() && num_vertices(m_copy) < most_vertices)
    {
      const auto [length, e] = queue.top();
      queue.pop();
      if (length != static_cast<float>(m_length[e]) || !is_divisible(e)) // it has changed since
        continue;
      std::deque<Edge> around;
      for (const Halfedge h : halfedges_around_source(divide(e), m_copy))
      {
        add(edge(h, m_copy));
        around.push_back(edge(h, m_copy));
        around.push_back(edge(next(h, m_copy), m_copy));
      }
      for (const Edge flipped : flip_edges(std::move(around)))
        add(flipped);
    }
  }

  // Around a pole that is one vertex, a foliation is like a square root of the distance, and the
  // error of its energy on triangles is proportional to their size there, while elsewhere it is so
  // to the square. So edges there are halved, and halved again. (Among very many poles, edges from
  // one to the next are all there is.)
  void divide_edges_at_poles()
  {
    constexpr std::size_t times = 2, new_vertices = 6 * times, largest_growth = 2;
    const std::vector<Vertex> poles = poles_of_one_vertex();
    if (new_vertices * poles.size() > (largest_growth - 1) * num_vertices(m_copy))
      return;
    for (std::size_t i = 0; i < times; ++i)
      for (const Vertex pole : poles)
        divide_edges_at(pole);
  }

  std::vector<Vertex> poles_of_one_vertex() const
  {
    std::vector<int> size(m_group.size(), 0); // by pole
    for (const int pole : m_group)
      if (pole >= 0)
        ++size[pole];
    std::vector<Vertex> result;
    for (const Vertex v : vertices(m_copy))
      if (m_group[v] >= 0 && size[m_group[v]] == 1)
        result.push_back(v);
    return result;
  }

  void divide_edges_at(Vertex pole)
  {
    std::vector<Edge> edges_at_pole;
    for (const Halfedge h : halfedges_around_target(pole, m_copy))
      edges_at_pole.push_back(edge(h, m_copy));
    std::deque<Edge> around;
    for (const Edge e : edges_at_pole)
      if (is_divisible(e))
        for (const Halfedge h : halfedges_around_source(divide(e), m_copy))
        {
          around.push_back(edge(h, m_copy));
          around.push_back(edge(next(h, m_copy), m_copy));
        }
    flip_edges(std::move(around));
  }

  bool is_divisible(Edge e) const
  {
    const Halfedge h = halfedge(e, m_copy), g = opposite(h, m_copy);
    return !are_in_one_group(source(h, m_copy), target(h, m_copy)) &&
           target(next(h, m_copy), m_copy) != target(next(g, m_copy), m_copy);
  }

  // from a corner to the middle of the side h of its face
  double length_of_median(Halfedge h) const
  {
    const double a = length(next(h, m_copy)), b = length(prev(h, m_copy)), c = length(h);
    return std::sqrt((std::max)(2 * (a * a + b * b) - c * c, 0.)) / 2;
  }

  // returns a halfedge from the new vertex
  Halfedge divide(Edge e)
  {
    Halfedge h = halfedge(e, m_copy), g = opposite(h, m_copy);
    const double half = m_length[e] / 2, to_left = length_of_median(h),
                 to_right = length_of_median(g);
    const auto middle =
      CGAL::midpoint(m_copy.point(source(h, m_copy)), m_copy.point(target(h, m_copy)));
    note_change(h, static_cast<int>(num_vertices(m_copy)));
    const Halfedge from_u = CGAL::Euler::split_edge(h, m_copy); // h is the other half
    m_copy.point(target(from_u, m_copy)) = middle;
    m_group.push_back(-1);
    set_length(from_u, half);
    set_length(h, half);
    set_length(CGAL::Euler::split_face(from_u, next(h, m_copy), m_copy), to_left);
    g = opposite(h, m_copy); // from v to the middle
    set_length(CGAL::Euler::split_face(g, next(opposite(from_u, m_copy), m_copy), m_copy),
               to_right);
    return h;
  }

  void set_length(Halfedge h, double length)
  {
    const Edge e = edge(h, m_copy);
    if (static_cast<std::size_t>(e) >= m_length.size())
      m_length.resize(static_cast<std::size_t>(e) + 1);
    m_length[e] = length;
  }

  // Faces of caps stay the last ones.
  void build_mesh(const Flat_mesh& before)
  {
    std::vector<Point> points;
    for (const auto v : vertices(m_copy))
    {
      const auto& p = m_copy.point(v);
      points.push_back({p.x(), p.y(), p.z()});
    }
    std::vector<Triangle> triangles, of_caps;
    for (const auto f : faces(m_copy))
    {
      const Halfedge h = halfedge(f, m_copy);
      const int number = static_cast<int>(f);
      (number >= before.number_of_input_faces() && number < before.number_of_faces() ? of_caps
                                                                                     : triangles)
        .push_back({static_cast<int>(source(h, m_copy)), static_cast<int>(target(h, m_copy)),
                    static_cast<int>(target(next(h, m_copy), m_copy))});
    }
    const int first_cap_face = static_cast<int>(triangles.size());
    triangles.insert(triangles.end(), of_caps.begin(), of_caps.end());
    m_mesh = Flat_mesh(std::move(points), triangles, before.number_of_caps(), first_cap_face);
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
  std::vector<int> m_group;     // by vertex
  std::vector<double> m_length; // by edge of the copy
  std::vector<Edge_change> m_changes;
  Flat_mesh m_mesh;
  std::vector<double> m_cotangents;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_DELAUNAY_FLIPS_H
