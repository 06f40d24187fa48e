// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_CENTROID_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_CENTROID_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>

#include <Eigen/Core>

#include <cmath>
#include <limits>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// A centroid weighted by length, assembled from segments; if all of them are points, their mean.
// Also the root mean square distance of their points from it, which is the radius for a circle;
// without it, segments are added in less time.
template <bool has_radius>
class Basic_centroid
{
public:
  // Running means, which do not overflow where sums of products would.
  void add(const Point& p, const Point& q)
  {
    const double length = distance(p, q);
    const Eigen::Vector3d middle = to_vector(p) / 2 + to_vector(q) / 2;
    m_length += length;
    ++m_number;
    if (!std::isfinite(m_length))
      add_beyond_range(middle);
    else if (m_length > 0)
      add_weighted(middle, length);
    else
      m_plain += (middle - m_plain) / m_number;
  }

  bool is_empty() const { return m_number == 0; }
  double length() const { return m_length; }
  // 0 if all segments are points
  double radius() const
  {
    static_assert(has_radius, "the radius has not been computed");
    return m_radius;
  }

  Point point() const { return coordinates(m_length > 0 ? m_weighted : m_plain); }

private:
  void add_weighted(const Eigen::Vector3d& middle, double length)
  {
    const double share = length / m_length;
    const Eigen::Vector3d way = middle - m_weighted;
    if constexpr (has_radius)
      add_to_radius(way, share, length);
    m_weighted += share * way;
  }

  // The variance of a union is the mean of the variances of its parts (that of a segment is a
  // twelfth of its squared length) plus the product of both shares and the squared distance of the
  // means.
  void add_to_radius(const Eigen::Vector3d& way, double share, double length)
  {
    const double square = (1 - share) * m_radius * m_radius + share * (1 - share) * dot(way, way) +
                          share / 12 * length * length;
    m_radius =
      is_safe_square(square)
        ? std::sqrt(square)
        : scaled_norm({std::sqrt(1 - share) * m_radius, std::sqrt(share * (1 - share)) * norm(way),
                       std::sqrt(share / 12) * length});
  }

  // Where lengths overflow, all segments count the same; differences of points might overflow, too.
  void add_beyond_range(const Eigen::Vector3d& middle)
  {
    const double share = 1. / m_number;
    m_weighted = (1 - share) * m_weighted + share * middle;
    m_length = m_radius = std::numeric_limits<double>::infinity();
  }

  Eigen::Vector3d m_weighted{0, 0, 0}, m_plain{0, 0, 0};
  double m_length = 0, m_radius = 0;
  int m_number = 0;
};

using Centroid = Basic_centroid<true>;
using Centroid_without_radius = Basic_centroid<false>;

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_CENTROID_H
