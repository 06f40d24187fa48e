// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_EDGE_VALUE_EXAMPLES_H
#define SMF_TEST_EDGE_VALUE_EXAMPLES_H

#include "generators/soups.h"

#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

// Foliations made by hand, as values on the edges of small meshes.

namespace smf_test {

// a value for the edge between two vertices, either way round
using Edge_value_function = std::function<double(std::size_t, std::size_t)>;

struct Edge_value_example
{
  std::string name;
  Triangle_soup soup;
  Edge_value_function value;
};

// The values |x| of differences between vertices of soups::torus(m, n, ...), where one step around
// the axis counts `a` and one around the tube `b`: the leaves are straight lines.
inline Edge_value_example linear_torus(std::size_t m, std::size_t n, double a, double b)
{
  const auto step = [](std::size_t from, std::size_t to, std::size_t period) {
    const std::size_t forward = (to + period - from) % period;
    return forward > period / 2 ? -static_cast<double>(period - forward)
                                : static_cast<double>(forward);
  };
  return {"linear torus", soups::torus(m, n, 3, 1), [=](std::size_t u, std::size_t v) {
            return std::abs(a * step(u / n, v / n, m) + b * step(u % n, v % n, n));
          }};
}

// Three poles, 0 to 2, between meridians that are critical leaves along edges, from vertex 3 or, if
// `is_wide`, from a face all of whose sides have value 0, to the last vertex.
inline Edge_value_example three_disks(bool is_wide)
{
  Triangle_soup soup;
  const auto on_circle = [](double turn, double radius, double z) {
    return soups::Point{radius * std::cos(2 * soups::pi * turn),
                        radius * std::sin(2 * soups::pi * turn), z};
  };
  const double third = 1. / 3;
  for (int i = 0; i < 3; ++i)
    soup.points.push_back(on_circle((i + 0.5) * third, 1, 0));
  for (int i = 0; i < (is_wide ? 3 : 1); ++i)
    soup.points.push_back(on_circle(i * third, is_wide ? 0.3 : 0, 1));
  const std::size_t middle = soup.points.size(), bottom = middle + 3;
  for (int i = 0; i < 3; ++i)
    soup.points.push_back(on_circle(i * third, 1, 0));
  soup.points.push_back({0, 0, -1});
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t j = (i + 1) % 3, top = is_wide ? 3 + i : 3, next_top = is_wide ? 3 + j : 3;
    soup.triangles.push_back({middle + i, i, top});
    soup.triangles.push_back({i, middle + j, next_top});
    soup.triangles.push_back({middle + i, bottom, i});
    soup.triangles.push_back({bottom, middle + j, i});
    if (is_wide)
      soup.triangles.push_back({i, next_top, top});
  }
  if (is_wide)
    soup.triangles.push_back({3, 4, 5});
  return {is_wide ? "face at a node" : "critical edges", soup, [](std::size_t u, std::size_t v) {
            return u < 3 ? 1. + static_cast<double>(u) : v < 3 ? 1. + static_cast<double>(v) : 0.;
          }};
}

// an octahedron with poles 4 and 5, whose equator is a closed leaf of edges
inline Edge_value_example flat_equator()
{
  return {"closed leaf of edges", soups::octahedron(), [](std::size_t u, std::size_t v) {
            const auto height = [](std::size_t w) { return w == 4 ? 1. : w == 5 ? -2. : 0.; };
            return std::abs(height(u) - height(v));
          }};
}

// A tetrahedron whose opposite edges have equal values, two of them the sum of the others: each
// vertex is a thorn.
inline Edge_value_example pillow()
{
  return {"pillow", soups::tetrahedron(), [](std::size_t u, std::size_t v) {
            return u + v == 3 ? 2. : 1.; // edges 0 3 and 1 2
          }};
}

} // namespace smf_test

#endif // SMF_TEST_EDGE_VALUE_EXAMPLES_H
