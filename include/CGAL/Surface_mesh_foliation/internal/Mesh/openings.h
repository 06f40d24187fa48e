// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_OPENINGS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_OPENINGS_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Centroid.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Soup_edges.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Triangle_soup.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// An opening of a surface, by the vertices of its border, in the order in which a walker meets them
// who has the opening on the left. It begins with its smallest vertex.
using Border = std::vector<int>;

// The openings of an oriented manifold with borders, ordered by their smallest vertices. Every
// vertex of a border is left by one border edge, since its faces form one umbrella.
inline std::vector<Border> find_openings(const Triangle_soup& soup)
{
  const Soup_edges edges(soup);
  std::vector<int> next(soup.points.size(), -1); // along the border, against the side of the face
  for (std::size_t edge = 0; edge < edges.size(); ++edge)
    if (edges.number_of_sides(edge) == 1)
    {
      const std::size_t side = edges.side(edge, 0);
      next[edges.target(side)] = static_cast<int>(edges.source(side));
    }
  std::vector<Border> result;
  for (std::size_t first = 0; first < next.size(); ++first)
    if (next[first] >= 0)
    {
      result.emplace_back();
      for (int v = static_cast<int>(first); next[v] >= 0; v = std::exchange(next[v], -1))
        result.back().push_back(v);
    }
  return result;
}

inline Centroid centroid_of_border(const Border& border, const std::vector<Point>& points)
{
  Centroid result;
  for (std::size_t i = 0; i < border.size(); ++i)
    result.add(points[border[i]], points[border[(i + 1) % border.size()]]);
  return result;
}

// Closes openings by caps: a vertex in the middle, joined to all vertices of the border. Cap i has
// the i-th new vertex.
inline void add_caps(const std::vector<Border>& openings,
                     std::vector<Point>& points,
                     std::vector<Triangle>& triangles)
{
  for (const Border& opening : openings)
  {
    const int middle = static_cast<int>(points.size());
    points.push_back(centroid_of_border(opening, points).point());
    for (std::size_t i = 0; i < opening.size(); ++i)
      triangles.push_back({opening[i], opening[(i + 1) % opening.size()], middle});
  }
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_OPENINGS_H
