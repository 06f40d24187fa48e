// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_GENERATORS_GENUS_SOUPS_H
#define SMF_GENERATORS_GENUS_SOUPS_H

#include "Random.h"
#include "soups.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

// Surfaces of any genus: plates with holes, and surfaces with handles.

namespace smf_test {
namespace soups {

// ===  Plates with holes

// A plate of cubes with holes right through it, in rows. Holes have the width of a cell, and a
// cell is between holes and around them; a cell has resolution^3 cubes.
class Plate_with_holes
{
public:
  Plate_with_holes(std::size_t number_of_holes, std::size_t resolution)
    : m_number_of_holes(number_of_holes), m_resolution(resolution)
  {
    while (m_columns * m_columns < number_of_holes)
      ++m_columns;
    const std::size_t rows =
      std::max<std::size_t>(1, (number_of_holes + m_columns - 1) / m_columns);
    m_size = {(2 * m_columns + 1) * resolution, (2 * rows + 1) * resolution, resolution};
  }

  // The diagonals of the squares are random.
  Triangle_soup boundary(Random& random) const
  {
    Triangle_soup soup;
    std::map<Cube, std::size_t> vertex_at;
    Cube cube;
    for (cube[0] = 0; cube[0] < m_size[0]; ++cube[0])
      for (cube[1] = 0; cube[1] < m_size[1]; ++cube[1])
        for (cube[2] = 0; cube[2] < m_size[2]; ++cube[2])
          for (std::size_t axis = 0; is_solid(cube) && axis < 3; ++axis)
            for (const bool is_upper : {false, true})
              if (!is_neighbor_solid(cube, axis, is_upper))
                add_square(soup, vertex_at, cube, axis, is_upper, random);
    return soup;
  }

private:
  using Cube = std::array<std::size_t, 3>;

  bool is_solid(const Cube& cube) const
  {
    const std::size_t column = cube[0] / m_resolution;
    const std::size_t row = cube[1] / m_resolution;
    if (column % 2 == 0 || row % 2 == 0)
      return true;
    return (row / 2) * m_columns + column / 2 >= m_number_of_holes;
  }

  bool is_neighbor_solid(Cube cube, std::size_t axis, bool is_upper) const
  {
    if (cube[axis] == (is_upper ? m_size[axis] - 1 : 0))
      return false;
    cube[axis] = is_upper ? cube[axis] + 1 : cube[axis] - 1;
    return is_solid(cube);
  }

  static void add_square(Triangle_soup& soup,
                         std::map<Cube, std::size_t>& vertex_at,
                         const Cube& cube,
                         std::size_t axis,
                         bool is_upper,
                         Random& random)
  {
    // counterclockwise seen from the upper side
    constexpr std::array<std::array<std::size_t, 2>, 4> offsets = {
      {{{0, 0}}, {{1, 0}}, {{1, 1}}, {{0, 1}}}};
    std::array<std::size_t, 4> corners;
    for (std::size_t i = 0; i < 4; ++i)
    {
      Cube place = cube;
      place[axis] += is_upper ? 1 : 0;
      place[(axis + 1) % 3] += offsets[i][0];
      place[(axis + 2) % 3] += offsets[i][1];
      const auto [entry, is_new] = vertex_at.emplace(place, soup.points.size());
      if (is_new)
        soup.points.push_back({static_cast<double>(place[0]), static_cast<double>(place[1]),
                               static_cast<double>(place[2])});
      corners[is_upper ? i : 3 - i] = entry->second;
    }
    const std::size_t i = random.index(2);
    soup.triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
    soup.triangles.push_back({corners[i], corners[i + 2], corners[(i + 3) % 4]});
  }

  std::size_t m_number_of_holes;
  std::size_t m_resolution;
  std::size_t m_columns = 1; // of holes
  Cube m_size;               // in cubes
};

// a closed connected surface of the given genus: a plate with holes, with rounded edges and uneven
inline Triangle_soup genus_surface(std::size_t genus,
                                   std::size_t resolution = 2,
                                   std::uint64_t seed = 1)
{
  Random random(seed);
  const Plate_with_holes plate(genus, resolution);
  const Triangle_soup rounded = smoothed(plate.boundary(random), static_cast<int>(resolution));
  return noisy(rounded, 0.1, seed);
}

// ===  Handles

inline Point barycenter(const Triangle_soup& soup, const Triangle& triangle)
{
  return scaled(
    sum(sum(soup.points[triangle[0]], soup.points[triangle[1]]), soup.points[triangle[2]]),
    1.0 / 3);
}

inline Point unit_normal(const Triangle_soup& soup, const Triangle& triangle)
{
  const Point& origin = soup.points[triangle[0]];
  return normalized(
    cross(sum(soup.points[triangle[1]], origin, -1), sum(soup.points[triangle[2]], origin, -1)));
}

// the corners of `triangle` in opposite order, turned so that they are near those of `target`
inline Triangle matched_corners(const Triangle_soup& soup,
                                const Triangle& triangle,
                                const Triangle& target)
{
  Triangle best = {triangle[2], triangle[1], triangle[0]};
  const auto total_distance = [&](const Triangle& candidate) {
    double total = 0;
    for (std::size_t i = 0; i < 3; ++i)
      total += distance(soup.points[candidate[i]], soup.points[target[i]]);
    return total;
  };
  Triangle candidate = best;
  for (int i = 0; i < 2; ++i)
  {
    std::rotate(candidate.begin(), candidate.begin() + 1, candidate.end());
    if (total_distance(candidate) < total_distance(best))
      best = candidate;
  }
  return best;
}

// a point of the cubic Bezier curve
inline Point bezier_point(const std::array<Point, 4>& control, double t)
{
  const double s = 1 - t;
  Point result = scaled(control[0], s * s * s);
  result = sum(result, control[1], 3 * s * s * t);
  result = sum(result, control[2], 3 * s * t * t);
  return sum(result, control[3], t * t * t);
}

// adds a tube with triangular rings between two faces that the caller removes. The faces are
// copies, as those of the soup move when new ones come.
inline void add_tube(Triangle_soup& soup, const Triangle first, const Triangle second)
{
  const Triangle last = matched_corners(soup, second, first);
  const double span = distance(barycenter(soup, first), barycenter(soup, second));
  const double ring_size = distance(soup.points[first[0]], soup.points[first[1]]);
  const double reach = 0.5 * span + ring_size;
  const auto segments =
    static_cast<std::size_t>(std::clamp(std::round(2 * reach / ring_size), 2.0, 16.0));
  const Point first_normal = unit_normal(soup, first);
  const Point second_normal = unit_normal(soup, second);

  Triangle ring = first;
  for (std::size_t i = 1; i <= segments; ++i)
  {
    Triangle next_ring = last;
    for (std::size_t j = 0; i < segments && j < 3; ++j)
    {
      const Point begin = soup.points[first[j]];
      const Point end = soup.points[last[j]];
      const std::array<Point, 4> control = {
        {begin, sum(begin, first_normal, reach), sum(end, second_normal, reach), end}};
      next_ring[j] = soup.points.size();
      soup.points.push_back(
        bezier_point(control, static_cast<double>(i) / static_cast<double>(segments)));
    }
    for (std::size_t j = 0; j < 3; ++j)
    {
      const std::size_t k = (j + 1) % 3;
      soup.triangles.push_back({ring[j], ring[k], next_ring[k]});
      soup.triangles.push_back({ring[j], next_ring[k], next_ring[j]});
    }
    ring = next_ring;
  }
}

// raises the genus of a closed connected surface by `count`: tubes join random pairs of faces. No
// two of these faces share a vertex; there must be enough of them. Tubes may cut one another in
// space.
inline Triangle_soup with_handles(Triangle_soup soup, std::size_t count, std::uint64_t seed)
{
  Random random(seed);
  std::vector<bool> is_used(soup.points.size(), false);
  std::vector<std::size_t> ends;
  for (const std::size_t face : random.permutation(soup.triangles.size()))
  {
    const auto [a, b, c] = soup.triangles[face];
    if (ends.size() == 2 * count || is_used[a] || is_used[b] || is_used[c])
      continue;
    is_used[a] = is_used[b] = is_used[c] = true;
    ends.push_back(face);
  }

  for (std::size_t i = 0; i < count; ++i)
    add_tube(soup, soup.triangles[ends.at(2 * i)], soup.triangles[ends.at(2 * i + 1)]);
  std::sort(ends.begin(), ends.end());
  for (std::size_t i = ends.size(); i-- > 0;)
    soup.triangles.erase(soup.triangles.begin() + static_cast<std::ptrdiff_t>(ends[i]));
  return soup;
}

// a closed connected surface of the given genus: a sphere with thick handles and, after a
// subdivision, about as many thin ones
inline Triangle_soup handle_surface(std::size_t genus, std::uint64_t seed = 1)
{
  const std::size_t thick_handles = (genus + 1) / 2;
  Triangle_soup soup = with_handles(icosphere(2), thick_handles, seed);
  soup = midpoint_subdivided(smoothed(midpoint_subdivided(soup), 1));
  return noisy(with_handles(soup, genus - thick_handles, seed + 1), 0.02, seed);
}

} // namespace soups
} // namespace smf_test

#endif // SMF_GENERATORS_GENUS_SOUPS_H
