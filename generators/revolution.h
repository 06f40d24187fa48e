// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_GENERATORS_REVOLUTION_H
#define SMF_GENERATORS_REVOLUTION_H

#include "generators/soups.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

// Surfaces of revolution.

namespace smf_test {
namespace soups {

// a circle of the surface: its place on the axis and its radius
using Profile_point = std::array<double, 2>;

inline Point point_of_revolution(const Profile_point& p, double angle)
{
  return {p[0], p[1] * std::cos(angle), p[1] * std::sin(angle)};
}

// The circles of a profile, n vertices on each, numbered circle by circle, without what closes the
// first and the last.
inline Triangle_soup tube_of_revolution(const std::vector<Profile_point>& profile, std::size_t n)
{
  Triangle_soup soup;
  for (std::size_t i = 0; i < profile.size(); ++i)
    for (std::size_t j = 0; j < n; ++j)
    {
      const double angle = 2 * pi * static_cast<double>(j) / static_cast<double>(n);
      soup.points.push_back(point_of_revolution(profile[i], angle));
      if (i == 0)
        continue;
      const std::size_t a = (i - 1) * n + j, b = (i - 1) * n + (j + 1) % n;
      soup.triangles.push_back({a, a + n, b + n});
      soup.triangles.push_back({a, b + n, b});
    }
  return soup;
}

// The same, closed by a vertex on the axis at each end, which come last.
inline Triangle_soup surface_of_revolution(const std::vector<Profile_point>& profile,
                                           std::size_t n,
                                           double first_tip,
                                           double last_tip)
{
  Triangle_soup soup = tube_of_revolution(profile, n);
  const std::size_t first = soup.points.size(), end = first - n;
  soup.points.push_back({first_tip, 0, 0});
  soup.points.push_back({last_tip, 0, 0});
  for (std::size_t j = 0; j < n; ++j)
  {
    soup.triangles.push_back({first, j, (j + 1) % n});
    soup.triangles.push_back({first + 1, end + (j + 1) % n, end + j});
  }
  return soup;
}

// A cylinder of radius 1 between two half-spheres, with edges about as long along it as around it,
// times `stretch`. Returns it with the numbers of four of its vertices: two opposite ones halfway
// up each half-sphere.
inline std::pair<Triangle_soup, std::array<std::size_t, 4>> capsule(double length,
                                                                    std::size_t n,
                                                                    double stretch = 1)
{
  const double step = stretch * 2 * pi / static_cast<double>(n);
  const auto steps = [&](double way) {
    return static_cast<std::size_t>(std::max(1., std::round(way / step)));
  };
  const std::size_t quarter = steps(pi / 4), middle = steps(length);
  std::vector<Profile_point> profile;
  for (std::size_t i = 1; i <= 2 * quarter; ++i)
  {
    const double angle = pi / 4 * static_cast<double>(i) / static_cast<double>(quarter);
    profile.push_back({-std::cos(angle), std::sin(angle)});
  }
  for (std::size_t i = 1; i <= middle; ++i)
    profile.push_back({length * static_cast<double>(i) / static_cast<double>(middle), 1});
  for (std::size_t i = 2 * quarter - 1; i > 0; --i)
  {
    const double angle = pi / 4 * static_cast<double>(i) / static_cast<double>(quarter);
    profile.push_back({length + std::cos(angle), std::sin(angle)});
  }
  const std::size_t first = (quarter - 1) * n, last = (profile.size() - quarter) * n;
  return {surface_of_revolution(profile, n, -1, length + 1),
          {first, first + n / 2, last, last + n / 2}};
}

// Two spheres of radius 1 joined by a cylinder, with edges about as long along it as around it.
// Returns it with the numbers of four of its vertices: two opposite ones on the largest circle of
// each sphere.
inline std::pair<Triangle_soup, std::array<std::size_t, 4>> dumbbell(double radius,
                                                                     double length,
                                                                     std::size_t n)
{
  const double step = 2 * pi / static_cast<double>(n);
  // Circles of a sphere at even distances after Mercator's projection, in which edges keep their
  // ratios. The last one is where the cylinder begins.
  const double quarter = -std::log(std::tan(std::asin(radius) / 2));
  const auto circles = static_cast<std::size_t>(std::round(quarter / step));
  const auto middle = static_cast<std::size_t>(std::round(length / (radius * step)));
  std::vector<Profile_point> profile;
  for (std::size_t i = 0; i <= 2 * circles; ++i)
  {
    const double way = quarter * (static_cast<double>(i) / static_cast<double>(circles) - 1);
    profile.push_back({std::tanh(way), 1 / std::cosh(way)});
  }
  const double half = profile.back()[0] + length / 2; // from the center of a sphere to the middle
  const std::vector<Profile_point> sphere = profile;
  for (std::size_t i = 1; i < middle; ++i)
    profile.push_back(
      {sphere.back()[0] + length * static_cast<double>(i) / static_cast<double>(middle), radius});
  std::transform(sphere.rbegin(), sphere.rend(), std::back_inserter(profile),
                 [half](const Profile_point& p) {
                   return Profile_point{2 * half - p[0], p[1]};
                 });
  const std::size_t first = circles * n, last = (profile.size() - 1 - circles) * n;
  return {surface_of_revolution(profile, n, -1, 2 * half + 1),
          {first, first + n / 2, last, last + n / 2}};
}

// a flat disk of radius 1; vertex i n + j lies on circle i, of `circles`, and the center comes last
inline Triangle_soup disk(std::size_t circles, std::size_t n)
{
  std::vector<Profile_point> profile;
  for (std::size_t i = 1; i <= circles; ++i)
    profile.push_back({0, static_cast<double>(i) / static_cast<double>(circles)});
  Triangle_soup soup = tube_of_revolution(profile, n);
  const std::size_t center = soup.points.size();
  soup.points.push_back({0, 0, 0});
  for (std::size_t j = 0; j < n; ++j)
    soup.triangles.push_back({center, j, (j + 1) % n});
  return soup;
}

} // namespace soups
} // namespace smf_test

#endif // SMF_GENERATORS_REVOLUTION_H
