// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_REPAIR_TRACED_SOUP_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_REPAIR_TRACED_SOUP_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Polygon_soup.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// the number of a vertex or face that does not exist
constexpr std::size_t no_element = (std::numeric_limits<std::size_t>::max)();

// A polygon soup while it is repaired. It remembers what its vertices and faces come from in the
// input: `no_element` if they are new.
struct Traced_soup
{
  using Face = std::vector<std::size_t>;
  using Edge = std::pair<std::size_t, std::size_t>; // in ascending order

  explicit Traced_soup(const Polygon_soup& soup)
    : points(soup.points),
      faces(soup.polygons),
      vertex_origins(soup.points.size()),
      face_origins(soup.polygons.size())
  {
    std::iota(vertex_origins.begin(), vertex_origins.end(), std::size_t(0));
    std::iota(face_origins.begin(), face_origins.end(), std::size_t(0));
  }

  std::size_t add_new_vertex(const Point& point)
  {
    points.push_back(point);
    vertex_origins.push_back(no_element);
    return points.size() - 1;
  }

  // Replaces all faces. `origins` are faces of the soup as it was.
  void set_faces(std::vector<Face> new_faces, const std::vector<std::size_t>& origins)
  {
    std::vector<std::size_t> new_origins;
    new_origins.reserve(origins.size());
    for (const std::size_t f : origins)
      new_origins.push_back(face_origins[f]);
    faces = std::move(new_faces);
    face_origins = std::move(new_origins);
  }

  // the edges of all faces, sorted; an edge of several faces comes several times
  std::vector<Edge> edges_of_faces() const
  {
    std::vector<Edge> result;
    for (const Face& face : faces)
      for (std::size_t i = 0; i < face.size(); ++i)
      {
        const std::size_t u = face[i], v = face[(i + 1) % face.size()];
        if (u != v)
          result.emplace_back((std::min)(u, v), (std::max)(u, v));
      }
    std::sort(result.begin(), result.end());
    return result;
  }

  std::vector<bool> is_used() const
  {
    std::vector<bool> result(points.size(), false);
    for (const Face& face : faces)
      for (const std::size_t v : face)
        result[v] = true;
    return result;
  }

  std::vector<Point> points;
  std::vector<Face> faces;
  std::vector<std::size_t> vertex_origins, face_origins;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_REPAIR_TRACED_SOUP_H
