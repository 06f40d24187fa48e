// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_FLAT_SURFACE_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_FLAT_SURFACE_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/soup_element_checks.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/soup_problems.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Mesh_index.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <utility>
#include <vector>

// The connectivity of a mesh as a flat mesh, for algorithms that do not depend on the positions of
// vertices.

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// a vertex point map that gives the origin
struct Origin_map
{
  struct Origin
  {
    double x() const { return 0; }
    double y() const { return 0; }
    double z() const { return 0; }
  };
  template <class Vertex>
  friend Origin get(Origin_map, const Vertex&)
  {
    return {};
  }
};

// says what is wrong with a mesh that is not a closed connected triangle mesh
template <class TriangleMesh>
[[noreturn]] void throw_surface_problem(const Mesh_index<TriangleMesh>& index)
{
  std::vector<Problem> problems;
  const Triangle_soup soup = index.soup(Origin_map(), problems);
  if (problems.empty())
    problems = soup_problems(soup);
  if (problems.empty() || problems.front().kind == Problem_kind::DEGENERATE_FACE)
    throw Invalid_mesh_exception(problem(
      Problem_kind::NOT_CLOSED, "the mesh is not closed: two border edges have the same ends"));
  throw Invalid_mesh_exception(problems.front());
}

// whether every edge has two faces, one on each side
inline bool are_edges_closed(int number_of_vertices, const std::vector<Triangle>& triangles)
{
  std::vector<int> begin(number_of_vertices + 1, 0);
  for (const Triangle& t : triangles)
    for (int i : {0, 1, 2})
      ++begin[(std::min)(t[i], t[(i + 1) % 3]) + 1];
  for (int v = 0; v < number_of_vertices; ++v)
    begin[v + 1] += begin[v];
  std::vector<std::pair<int, bool>> sides(begin.back()); // larger end; whether it is the target
  std::vector<int> position(begin);
  for (const Triangle& t : triangles)
    for (int i : {0, 1, 2})
    {
      const int u = t[i], v = t[(i + 1) % 3];
      sides[position[(std::min)(u, v)]++] = {(std::max)(u, v), u < v};
    }
  for (int v = 0; v < number_of_vertices; ++v)
  {
    if ((begin[v + 1] - begin[v]) % 2 != 0)
      return false;
    std::sort(sides.begin() + begin[v], sides.begin() + begin[v + 1]);
    for (int i = begin[v]; i < begin[v + 1]; i += 2)
      if (sides[i].first != sides[i + 1].first || sides[i].second || !sides[i + 1].second)
        return false;
  }
  return true;
}

// Whether the faces at every vertex form one umbrella of at least three. (If there are two, they
// have the same corners.)
template <class TriangleMesh>
bool are_vertices_manifold(const Mesh_index<TriangleMesh>& index,
                           int number_of_vertices,
                           const std::vector<Triangle>& triangles)
{
  const TriangleMesh& mesh = index.mesh();
  std::vector<int> degree(number_of_vertices, 0);
  for (const Triangle& t : triangles)
    for (int v : t)
      ++degree[v];
  for (const auto f : faces(mesh))
  {
    auto first = halfedge(f, mesh);
    for (int i = 0; i < 3; ++i, first = next(first, mesh))
    {
      int& remaining = degree[index.index(target(first, mesh))];
      if (remaining < 0)
        continue; // walked around
      if (remaining < 3)
        return false;
      auto h = first;
      do
      {
        h = opposite(next(h, mesh), mesh);
        --remaining;
      } while (h != first && remaining > 0);
      if (h != first || remaining != 0)
        return false;
      remaining = -1;
    }
  }
  return std::all_of(degree.begin(), degree.end(), [](int d) { return d < 0; }); // none is isolated
}

// Checks that a mesh is a closed manifold triangle mesh, in linear time up to the logarithm of the
// largest degree. Whether it is connected is left to the caller.
template <class TriangleMesh>
Flat_mesh flat_surface(const Mesh_index<TriangleMesh>& index)
{
  const TriangleMesh& mesh = index.mesh();
  if (const auto excess = find_excess(index.number_of_faces()))
    throw Invalid_mesh_exception(*excess);
  std::vector<Triangle> triangles;
  triangles.reserve(index.number_of_faces());
  const int n = static_cast<int>(index.number_of_vertices());
  for (const auto f : faces(mesh))
  {
    const auto h0 = halfedge(f, mesh), h1 = next(h0, mesh), h2 = next(h1, mesh);
    const Triangle t = {index.index(source(h0, mesh)), index.index(source(h1, mesh)),
                        index.index(source(h2, mesh))};
    const auto is_border_beside = [&](const auto h) { return is_border(opposite(h, mesh), mesh); };
    if (next(h2, mesh) != h0 || is_border_beside(h0) || is_border_beside(h1) ||
        is_border_beside(h2) || t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
      throw_surface_problem(index);
    triangles.push_back(t);
  }
  if (triangles.empty() || !are_edges_closed(n, triangles) ||
      !are_vertices_manifold(index, n, triangles))
    throw_surface_problem(index);
  return Flat_mesh(std::vector<Point>(n), triangles);
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_FLAT_SURFACE_H
