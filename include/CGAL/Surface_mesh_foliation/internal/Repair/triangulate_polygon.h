// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_REPAIR_TRIANGULATE_POLYGON_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_REPAIR_TRIANGULATE_POLYGON_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/openings.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Points whose predicates are exact, as CGAL's hole filling and repairs need them.
using Exact_predicate_point = Exact_predicates_inexact_constructions_kernel::Point_3;

inline Exact_predicate_point exact_predicate_point(const Point& p)
{
  return Exact_predicate_point(p[0], p[1], p[2]);
}

// three corners of a polygon in its order
using Corner_triangle = std::array<std::size_t, 3>;

// The triangles into which CGAL cuts a closed polygon in space; nothing if it fails, or if one
// would be degenerate.
inline std::optional<std::vector<Corner_triangle>> triangulate_polygon(
  const std::vector<Point>& points)
{
  std::vector<Exact_predicate_point> polyline;
  polyline.reserve(points.size());
  for (const Point& p : points)
    polyline.push_back(exact_predicate_point(p));
  std::vector<CGAL::Triple<int, int, int>> triangles;
  Polygon_mesh_processing::triangulate_hole_polyline(polyline, std::back_inserter(triangles));
  if (triangles.size() + 2 != points.size())
    return std::nullopt;
  std::vector<Corner_triangle> result;
  for (const auto& triangle : triangles)
  {
    Corner_triangle corners = {static_cast<std::size_t>(triangle.first),
                               static_cast<std::size_t>(triangle.second),
                               static_cast<std::size_t>(triangle.third)};
    if (CGAL::collinear(polyline[corners[0]], polyline[corners[1]], polyline[corners[2]]))
      return std::nullopt;
    std::sort(corners.begin(), corners.end());
    result.push_back(corners);
  }
  return result;
}

using Diagonal = std::pair<std::size_t, std::size_t>; // two corners of a polygon in ascending order

inline std::vector<Diagonal> diagonals_of_triangulation(
  const std::vector<Corner_triangle>& triangles, std::size_t number_of_corners)
{
  std::vector<Diagonal> result;
  for (const auto& [i, j, k] : triangles)
    for (const auto& [first, last] : {Diagonal(i, j), Diagonal(j, k), Diagonal(i, k)})
      if (last - first > 1 && last - first < number_of_corners - 1)
        result.emplace_back(first, last);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

// the centroid of the sides of a polygon
inline Point centroid_of_polygon(const std::vector<Point>& points)
{
  Border corners(points.size());
  std::iota(corners.begin(), corners.end(), 0);
  return centroid_of_border(corners, points).point();
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_REPAIR_TRIANGULATE_POLYGON_H
