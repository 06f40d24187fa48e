// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_GENERATORS_JUG_H
#define SMF_GENERATORS_JUG_H

#include "generators/genus_soups.h"
#include "generators/revolution.h"
#include "generators/soups.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace smf_test {
namespace soups {

// A jug of genus 3 around the first axis, with three handles that a turn by a third exchanges, and
// the outermost vertex of each handle.
inline std::pair<Triangle_soup, std::array<std::size_t, 3>> jug_with_three_handles()
{
  constexpr std::size_t n = 12; // around the axis
  std::vector<Profile_point> profile;
  for (const double x : {-1., -0.75, -0.5, -0.25, 0., 0.25, 0.5, 0.75, 1.})
    profile.push_back({1.2 * x, 0.7 + 0.3 * std::cos(1.2 * x + 0.6)});
  Triangle_soup soup = surface_of_revolution(profile, n, -1.35, 1.4);

  // each quadrilateral of the profile has two faces, in the order of the loops of the tube
  const auto face = [](std::size_t row, std::size_t column) { return 2 * (row * n + column); };
  std::vector<std::size_t> ends;
  for (const std::size_t column : {0, 4, 8})
  {
    const std::size_t first = face(1, column), second = face(6, column);
    add_tube(soup, soup.triangles[first], soup.triangles[second]);
    ends.push_back(first);
    ends.push_back(second);
  }
  std::sort(ends.begin(), ends.end());
  for (std::size_t i = ends.size(); i-- > 0;)
    soup.triangles.erase(soup.triangles.begin() + static_cast<std::ptrdiff_t>(ends[i]));
  soup = smoothed(midpoint_subdivided(smoothed(midpoint_subdivided(soup), 1)), 1);

  std::array<std::size_t, 3> tips = {0, 0, 0};
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double angle = 2 * pi * (static_cast<double>(i) / 3 + 1. / 24);
      const Point direction = {0, std::cos(angle), std::sin(angle)};
      if (dot(soup.points[v], direction) > dot(soup.points[tips[i]], direction))
        tips[i] = v;
    }
  return {soup, tips};
}

} // namespace soups
} // namespace smf_test

#endif // SMF_GENERATORS_JUG_H
