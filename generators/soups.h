// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_GENERATORS_SOUPS_H
#define SMF_GENERATORS_SOUPS_H

#include "Random.h"

#include <CGAL/Surface_mesh_foliation/IO/Triangle_soup.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Soup_edges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

// Closed surfaces made by formulas, and changes to surfaces, as triangle soups. The same arguments
// give the same soup everywhere. `meshes.h` makes meshes of them.

namespace smf_test {

using CGAL::Surface_mesh_foliation::Triangle_soup;

namespace soups {

using Point = std::array<double, 3>;
using Triangle = std::array<std::size_t, 3>;

constexpr double pi = 3.14159265358979323846;

// ===  Vectors

inline Point sum(const Point& p, const Point& q, double factor = 1)
{
  return {p[0] + factor * q[0], p[1] + factor * q[1], p[2] + factor * q[2]};
}

inline Point scaled(const Point& p, double factor)
{
  return {factor * p[0], factor * p[1], factor * p[2]};
}

inline double dot(const Point& p, const Point& q)
{
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

inline Point cross(const Point& p, const Point& q)
{
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

inline Point normalized(const Point& p)
{
  return scaled(p, 1 / std::sqrt(dot(p, p)));
}

inline double distance(const Point& p, const Point& q)
{
  const Point difference = sum(p, q, -1);
  return std::sqrt(dot(difference, difference));
}

// ===  Measures

inline double mean_edge_length(const Triangle_soup& soup)
{
  double total = 0;
  for (const auto& [a, b, c] : soup.triangles)
    total += distance(soup.points[a], soup.points[b]) + distance(soup.points[b], soup.points[c]) +
             distance(soup.points[c], soup.points[a]);
  return total / (3.0 * static_cast<double>(soup.triangles.size()));
}

// of a closed connected surface
inline std::size_t genus(const Triangle_soup& soup)
{
  // V - 3/2 F + F = 2 - 2g
  return (soup.triangles.size() / 2 + 2 - soup.points.size()) / 2;
}

// ===  Changes

inline Triangle_soup midpoint_subdivided(const Triangle_soup& soup)
{
  const CGAL::Surface_mesh_foliation::internal::Soup_edges edges(soup);
  Triangle_soup result{soup.points, {}};
  std::vector<std::size_t> midpoint(3 * soup.triangles.size());
  for (std::size_t edge = 0; edge < edges.size(); ++edge)
  {
    const std::size_t side = edges.side(edge, 0);
    for (std::size_t i = 0; i < edges.number_of_sides(edge); ++i)
      midpoint[edges.side(edge, i)] = result.points.size();
    const Point& source = soup.points[edges.source(side)];
    result.points.push_back(scaled(sum(source, soup.points[edges.target(side)]), 0.5));
  }
  for (std::size_t face = 0; face < soup.triangles.size(); ++face)
  {
    const auto [a, b, c] = soup.triangles[face];
    const std::size_t ab = midpoint[3 * face];
    const std::size_t bc = midpoint[3 * face + 1];
    const std::size_t ca = midpoint[3 * face + 2];
    for (const Triangle& triangle :
         {Triangle{a, ab, ca}, Triangle{b, bc, ab}, Triangle{c, ca, bc}, Triangle{ab, bc, ca}})
      result.triangles.push_back(triangle);
  }
  return result;
}

// moves every vertex by at most `amplitude` mean edge lengths in each coordinate
inline Triangle_soup noisy(Triangle_soup soup, double amplitude, std::uint64_t seed)
{
  Random random(seed);
  const double size = amplitude * mean_edge_length(soup);
  for (Point& point : soup.points)
    for (double& coordinate : point)
      coordinate += size * random.between(-1, 1);
  return soup;
}

// moves every vertex half way to the mean of its neighbors, several times
inline Triangle_soup smoothed(Triangle_soup soup, int iterations)
{
  for (int i = 0; i < iterations; ++i)
  {
    std::vector<Point> neighbor_sum(soup.points.size(), Point{0, 0, 0});
    std::vector<double> degree(soup.points.size(), 0);
    for (const Triangle& triangle : soup.triangles)
      for (std::size_t j = 0; j < 3; ++j)
      {
        const std::size_t vertex = triangle[j];
        neighbor_sum[vertex] = sum(neighbor_sum[vertex], soup.points[triangle[(j + 1) % 3]]);
        degree[vertex] += 1;
      }
    for (std::size_t vertex = 0; vertex < soup.points.size(); ++vertex)
      soup.points[vertex] =
        sum(scaled(soup.points[vertex], 0.5), neighbor_sum[vertex], 0.5 / degree[vertex]);
  }
  return soup;
}

// Vertex v of the soup becomes vertex new_index[v]. Faces come in a random order, too, and each
// begins with a random corner.
inline Triangle_soup relabeled(const Triangle_soup& soup,
                               const std::vector<std::size_t>& new_index,
                               std::uint64_t seed)
{
  Random random(seed);
  Triangle_soup result;
  result.points.resize(soup.points.size());
  for (std::size_t vertex = 0; vertex < soup.points.size(); ++vertex)
    result.points[new_index[vertex]] = soup.points[vertex];
  for (const std::size_t face : random.permutation(soup.triangles.size()))
  {
    const Triangle& triangle = soup.triangles[face];
    const std::size_t first = random.index(3);
    result.triangles.push_back({new_index[triangle[first]], new_index[triangle[(first + 1) % 3]],
                                new_index[triangle[(first + 2) % 3]]});
  }
  return result;
}

// ===  Spheres

inline Triangle_soup tetrahedron()
{
  return {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
          {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
}

inline Triangle_soup octahedron()
{
  return {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

inline Triangle_soup icosahedron()
{
  const double a = (1 + std::sqrt(5.0)) / 2;
  return {{{-1, a, 0},
           {1, a, 0},
           {-1, -a, 0},
           {1, -a, 0},
           {0, -1, a},
           {0, 1, a},
           {0, -1, -a},
           {0, 1, -a},
           {a, 0, -1},
           {a, 0, 1},
           {-a, 0, -1},
           {-a, 0, 1}},
          {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
           {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
           {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
}

// a unit sphere with 20 * 4^level faces
inline Triangle_soup icosphere(int level)
{
  Triangle_soup soup = icosahedron();
  for (int i = 0; i < level; ++i)
    soup = midpoint_subdivided(soup);
  for (Point& point : soup.points)
    point = normalized(point);
  return soup;
}

// `count` directions, spread over the sphere on a spiral
inline std::vector<Point> spread_directions(std::size_t count)
{
  const double golden_angle = pi * (3 - std::sqrt(5.0));
  std::vector<Point> directions;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double height = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(count);
    const double radius = std::sqrt(1 - height * height);
    const double angle = golden_angle * static_cast<double>(i);
    directions.push_back({radius * std::cos(angle), radius * std::sin(angle), height});
  }
  return directions;
}

// a ball with long limbs: an icosphere, blown up in some directions. The limbs get longer one by
// one, so that no two are alike.
inline Triangle_soup limbed_sphere(std::size_t number_of_limbs, int level)
{
  constexpr double width = 0.06;
  const std::vector<Point> directions = spread_directions(number_of_limbs);
  Triangle_soup soup = icosphere(level);
  for (Point& point : soup.points)
  {
    double radius = 1;
    for (std::size_t i = 0; i < directions.size(); ++i)
    {
      const double length = 2 + 0.2 * static_cast<double>(i);
      radius += length * std::exp((dot(point, directions[i]) - 1) / width);
    }
    point = scaled(point, radius);
  }
  return soup;
}

// for each limb of `limbed_sphere()`, the vertex at its tip
inline std::vector<std::size_t> limb_tips(std::size_t number_of_limbs, int level)
{
  const Triangle_soup sphere = icosphere(level);
  std::vector<std::size_t> tips;
  for (const Point& direction : spread_directions(number_of_limbs))
  {
    const auto is_nearer = [&](const Point& p, const Point& q) {
      return dot(p, direction) < dot(q, direction);
    };
    const auto tip = std::max_element(sphere.points.begin(), sphere.points.end(), is_nearer);
    tips.push_back(static_cast<std::size_t>(tip - sphere.points.begin()));
  }
  return tips;
}

// ===  Other surfaces

// m vertices around the axis and n around the tube; both at least 3
inline Triangle_soup torus(std::size_t m, std::size_t n, double large_radius, double small_radius)
{
  Triangle_soup soup;
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < n; ++j)
    {
      const double u = 2 * pi * static_cast<double>(i) / static_cast<double>(m);
      const double v = 2 * pi * static_cast<double>(j) / static_cast<double>(n);
      const double radius = large_radius + small_radius * std::cos(v);
      soup.points.push_back(
        {radius * std::cos(u), radius * std::sin(u), small_radius * std::sin(v)});
      const std::size_t next_i = (i + 1) % m;
      const std::size_t next_j = (j + 1) % n;
      const std::size_t corner = next_i * n + next_j;
      soup.triangles.push_back({i * n + j, next_i * n + j, corner});
      soup.triangles.push_back({i * n + j, corner, i * n + next_j});
    }
  return soup;
}

// two hubs, 0 and 1, joined by rings of `valence` vertices each
inline Triangle_soup spindle(std::size_t valence, std::size_t number_of_rings)
{
  Triangle_soup soup;
  soup.points = {{0, 0, 0}, {0, 0, static_cast<double>(number_of_rings) + 1}};
  for (std::size_t ring = 0; ring < number_of_rings; ++ring)
    for (std::size_t i = 0; i < valence; ++i)
    {
      const double angle = 2 * pi * static_cast<double>(i) / static_cast<double>(valence);
      soup.points.push_back({std::cos(angle), std::sin(angle), static_cast<double>(ring) + 1});
    }
  const auto at = [&](std::size_t ring, std::size_t i) { return 2 + ring * valence + i % valence; };
  for (std::size_t i = 0; i < valence; ++i)
  {
    soup.triangles.push_back({0, at(0, i + 1), at(0, i)});
    for (std::size_t ring = 0; ring + 1 < number_of_rings; ++ring)
    {
      soup.triangles.push_back({at(ring, i), at(ring, i + 1), at(ring + 1, i + 1)});
      soup.triangles.push_back({at(ring, i), at(ring + 1, i + 1), at(ring + 1, i)});
    }
    soup.triangles.push_back({1, at(number_of_rings - 1, i), at(number_of_rings - 1, i + 1)});
  }
  return soup;
}

} // namespace soups
} // namespace smf_test

#endif // SMF_GENERATORS_SOUPS_H
