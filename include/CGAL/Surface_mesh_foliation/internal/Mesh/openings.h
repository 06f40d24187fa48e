// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_OPENINGS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_OPENINGS_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Triangle_soup.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
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
inline std::vector<Border> find_openings(int number_of_vertices,
                                         const std::vector<Triangle>& triangles)
{
  // By vertex, the edges that leave it: those to larger vertices of faces, and those of opposite
  // directions.
  struct Side
  {
    int smaller, larger;
    bool is_upward;
    bool operator<(const Side& other) const
    {
      return smaller != other.smaller ? smaller < other.smaller : larger < other.larger;
    }
  };
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (const Triangle& t : triangles)
    for (int i : {0, 1, 2})
    {
      const int u = t[i], v = t[(i + 1) % 3];
      sides.push_back({(std::min)(u, v), (std::max)(u, v), u < v});
    }
  std::sort(sides.begin(), sides.end());
  std::vector<int> next(number_of_vertices, -1); // along the border, with the opening on the left
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    if (i + 1 < sides.size() && !(sides[i] < sides[i + 1]))
      ++i; // an edge with two faces
    else if (sides[i].is_upward)
      next[sides[i].larger] = sides[i].smaller;
    else
      next[sides[i].smaller] = sides[i].larger;
  }
  std::vector<Border> result;
  for (int first = 0; first < number_of_vertices; ++first)
    if (next[first] >= 0)
    {
      result.emplace_back();
      for (int v = first; next[v] >= 0; v = std::exchange(next[v], -1))
        result.back().push_back(v);
    }
  return result;
}

// the centroid of the border, weighted by length
inline Point center_of_opening(const Border& opening, const std::vector<Point>& points)
{
  Eigen::Vector3d result(0, 0, 0);
  double length = 0;
  for (std::size_t i = 0; i < opening.size(); ++i)
  {
    const Point &p = points[opening[i]], &q = points[opening[(i + 1) % opening.size()]];
    const double step = distance(p, q);
    length += step;
    if (length > 0)
      result += step / length * (to_vector(p) / 2 + to_vector(q) / 2 - result);
  }
  return coordinates(result);
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
    points.push_back(center_of_opening(opening, points));
    for (std::size_t i = 0; i < opening.size(); ++i)
      triangles.push_back({opening[i], opening[(i + 1) % opening.size()], middle});
  }
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_OPENINGS_H
