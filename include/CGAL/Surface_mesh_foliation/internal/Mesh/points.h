// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_POINTS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_POINTS_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// does not overflow or underflow in between
inline double distance(const Point& p, const Point& q)
{
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

inline CGAL::Bbox_3 bounding_box(const std::vector<Point>& points)
{
  CGAL::Bbox_3 result;
  for (const Point& p : points)
    result += CGAL::Bbox_3(p[0], p[1], p[2], p[0], p[1], p[2]);
  return result;
}

inline double diagonal(const CGAL::Bbox_3& box)
{
  return std::hypot((box.max)(0) - (box.min)(0), (box.max)(1) - (box.min)(1),
                    (box.max)(2) - (box.min)(2));
}

// half the longest side, which does not overflow
inline double half_size(const CGAL::Bbox_3& box)
{
  double result = 0;
  for (int i : {0, 1, 2})
    result = (std::max)(result, (box.max)(i) / 2 - (box.min)(i) / 2);
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_POINTS_H
