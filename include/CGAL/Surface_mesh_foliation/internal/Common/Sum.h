// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_SUM_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_SUM_H

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// A sum of nonnegative numbers, by Kahan's algorithm: its rounding error does not grow with their
// number.
class Sum
{
public:
  void add(double x)
  {
    const double term = x - m_error, sum = m_sum + term;
    m_error = (sum - m_sum) - term;
    m_sum = sum;
  }
  double value() const { return m_sum; }

private:
  double m_sum = 0, m_error = 0;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_SUM_H
