// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_POINTS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_POINTS_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Points are stored as arrays and computed with as vectors of Eigen. Two things are not left to
// Eigen, except where points have unit size (Normal_spreads.h): the norm, because Eigen's squares
// the coordinates, and sums of three products, because Eigen's order of addition depends on the
// instructions it is compiled for.

inline Eigen::Vector3d to_vector(const Point& p)
{
  return {p[0], p[1], p[2]};
}

inline Point coordinates(const Eigen::Vector3d& v)
{
  return {v[0], v[1], v[2]};
}

// of a point of a kernel
template <class Point_3>
Point coordinates(const Point_3& p)
{
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

// p - q
inline Eigen::Vector3d difference(const Point& p, const Point& q)
{
  return to_vector(p) - to_vector(q);
}

// from left to right on every machine
inline double dot(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// whether a sum of squares has not come near to overflow or underflow
inline bool is_safe_square(double square)
{
  return square > 1e-280 && square < 1e280;
}

// The largest coordinate is factored out, so that no square overflows or underflows. (The
// std::hypot() of three numbers of older libc++ does not do that.)
inline double scaled_norm(const Eigen::Vector3d& a)
{
  const double unit = a.cwiseAbs().maxCoeff();
  return unit > 0 ? unit * std::sqrt(dot(a / unit, a / unit)) : 0;
}

// does not overflow or underflow in between
inline double norm(const Eigen::Vector3d& a)
{
  const double square = dot(a, a);
  return is_safe_square(square) ? std::sqrt(square) : scaled_norm(a);
}

// The same in the plane. (The last digit of std::hypot() differs between libraries.)
inline double norm(double x, double y)
{
  const double square = x * x + y * y;
  return is_safe_square(square) ? std::sqrt(square) : std::hypot(x, y);
}

inline double distance(const Point& p, const Point& q)
{
  return norm(difference(p, q));
}

// p for share 0; for 1, q up to rounding
inline Point between(const Point& p, const Point& q, double share)
{
  return coordinates(Eigen::Vector3d(to_vector(p) + share * difference(q, p)));
}

// The largest coordinate is factored out first, so that no square overflows or underflows.
inline double distance_to_segment(const Point& p, const Point& a, const Point& b)
{
  const Eigen::Vector3d side = difference(b, a), way = difference(p, a);
  const double unit = (std::max)(side.cwiseAbs().maxCoeff(), way.cwiseAbs().maxCoeff());
  if (unit == 0)
    return 0;
  const Eigen::Vector3d direction = side / unit;
  const double square = dot(direction, direction);
  const double share = square > 0 ? std::clamp(dot(way / unit, direction) / square, 0., 1.) : 0;
  return distance(between(a, b, share), p);
}

// divides first, so that it does not overflow
inline Point centroid(const Point& p, const Point& q, const Point& r)
{
  Eigen::Vector3d sum(0, 0, 0); // 0 and not -0, whatever is added
  for (const Point* corner : {&p, &q, &r})
    sum += to_vector(*corner) / 3;
  return coordinates(sum);
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
  return scaled_norm(
    {(box.max)(0) - (box.min)(0), (box.max)(1) - (box.min)(1), (box.max)(2) - (box.min)(2)});
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
