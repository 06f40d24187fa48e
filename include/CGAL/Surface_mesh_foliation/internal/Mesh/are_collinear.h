// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_ARE_COLLINEAR_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_ARE_COLLINEAR_H

#include <CGAL/Surface_mesh_foliation/internal/Common/compiled.h>

#if CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES
#include <boost/multiprecision/cpp_int.hpp>
#endif // CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Whether three points are so far off a line that rounding need not be feared: a filter before the
// exact test, which takes much longer.
inline bool are_clearly_not_collinear(const std::array<double, 3>& a,
                                      const std::array<double, 3>& b,
                                      const std::array<double, 3>& c)
{
  constexpr double error = 16 * std::numeric_limits<double>::epsilon(), least = 1e-300;
  for (const std::size_t i : {0, 1, 2})
  {
    const std::size_t j = (i + 1) % 3;
    const double first = (b[i] - a[i]) * (c[j] - a[j]), second = (b[j] - a[j]) * (c[i] - a[i]);
    if (std::abs(first - second) > error * (std::abs(first) + std::abs(second)) + least)
      return true;
  }
  return false;
}

// Exact, of points with finite coordinates. (A kernel with exact predicates would do the same, but
// takes many times as long to compile.)
CGAL_SURFACE_MESH_FOLIATION_INLINE bool are_collinear(const std::array<double, 3>& a,
                                                      const std::array<double, 3>& b,
                                                      const std::array<double, 3>& c);

#if CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES
// Two edges are parallel if all components of their cross product vanish. All coordinates are
// multiples of one power of two, and only these whole numbers matter.
CGAL_SURFACE_MESH_FOLIATION_INLINE bool are_collinear(const std::array<double, 3>& a,
                                                      const std::array<double, 3>& b,
                                                      const std::array<double, 3>& c)
{
  using Integer = boost::multiprecision::cpp_int;
  constexpr int bits_of_fraction = std::numeric_limits<double>::digits - 1;
  int least = (std::numeric_limits<int>::max)();
  for (const auto& point : {a, b, c})
    for (const double x : point)
      if (x != 0)
        least = (std::min)(least, std::ilogb(x));
  const auto whole = [&](double x) {
    if (x == 0)
      return Integer(0);
    const int exponent = std::ilogb(x);
    const double digits = std::scalbn(x, bits_of_fraction - exponent);
    return Integer(Integer(static_cast<std::int64_t>(digits)) << (exponent - least));
  };
  const auto difference = [&](double x, double y) { return Integer(whole(x) - whole(y)); };
  for (const std::size_t i : {0, 1, 2})
  {
    const std::size_t j = (i + 1) % 3;
    const Integer first = difference(b[i], a[i]) * difference(c[j], a[j]);
    if (first != difference(b[j], a[j]) * difference(c[i], a[i]))
      return false;
  }
  return true;
}
#endif // CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_ARE_COLLINEAR_H
