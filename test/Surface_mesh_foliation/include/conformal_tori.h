// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_CONFORMAL_TORI_H
#define SMF_TEST_CONFORMAL_TORI_H

#include "generators/soups.h"

#include <cmath>
#include <cstddef>
#include <vector>

// Tori of which the conformal structure is known.

namespace smf_test {
namespace soups {

// The triangles of a torus with m rows of n vertices each, vertex i * n + j in row i; every other
// row is meant to be shifted by half a step. m is even.
inline std::vector<Triangle> staggered_triangles(std::size_t m, std::size_t n)
{
  std::vector<Triangle> result;
  const auto vertex = [&](std::size_t i, std::size_t j) { return i % m * n + j % n; };
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < n; ++j)
    {
      const std::size_t a = vertex(i, j), b = vertex(i, j + 1);
      const std::size_t c = vertex(i + 1, j), d = vertex(i + 1, j + 1);
      if (i % 2 == 0)
        result.insert(result.end(), {{a, c, b}, {b, c, d}});
      else
        result.insert(result.end(), {{a, d, b}, {a, c, d}});
    }
  return result;
}

// A torus of revolution, meshed by triangles that are about equilateral: Delaunay if there are
// enough of them. The metric (R + r cos psi)^2 dx^2 + r^2 dpsi^2 is, with
// tan(psi/2) = sqrt((R+r)/(R-r)) tan(y/2), a multiple of dx^2 + (r^2 / (R^2-r^2)) dy^2: that of a
// rectangle whose sides are as r to sqrt(R^2-r^2). `skew` bends the rows and columns, so that no
// symmetry helps. Rows are around the tube.
class Torus_of_revolution
{
public:
  Torus_of_revolution(double large_radius, double small_radius, double skew)
    : m_large_radius(large_radius), m_small_radius(small_radius), m_skew(skew)
  {}

  // around the tube, divided by around the axis
  double ratio() const
  {
    return m_small_radius /
           std::sqrt(m_large_radius * m_large_radius - m_small_radius * m_small_radius);
  }

  // for n vertices in a row
  std::size_t number_of_rows(std::size_t n) const
  {
    return 2 *
           static_cast<std::size_t>(std::round(static_cast<double>(n) / ratio() / std::sqrt(3.)));
  }

  Triangle_soup soup(std::size_t m, std::size_t n) const
  {
    Triangle_soup result = {{}, staggered_triangles(m, n)};
    for (std::size_t i = 0; i < m; ++i)
      for (std::size_t j = 0; j < n; ++j)
        result.points.push_back(point(2 * pi * static_cast<double>(i) / static_cast<double>(m),
                                      2 * pi * (static_cast<double>(j) + (i % 2 == 0 ? 0 : 0.5)) /
                                        static_cast<double>(n)));
    return result;
  }

private:
  Point point(double a, double b) const
  {
    const double x = a + m_skew * std::sin(b + 0.3);
    const double y = b + m_skew * (std::sin(a) + std::sin(2 * b + 1) / 2);
    const double stretch =
      std::sqrt((m_large_radius + m_small_radius) / (m_large_radius - m_small_radius));
    const double psi = 2 * std::atan2(stretch * std::sin(y / 2), std::cos(y / 2));
    const double distance = m_large_radius + m_small_radius * std::cos(psi);
    return {distance * std::cos(x), distance * std::sin(x), m_small_radius * std::sin(psi)};
  }

  double m_large_radius, m_small_radius, m_skew;
};

} // namespace soups
} // namespace smf_test

#endif // SMF_TEST_CONFORMAL_TORI_H
