// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_REPAIRED_SOUPS_H
#define SMF_TEST_REPAIRED_SOUPS_H

#include "generators/genus_soups.h"

#include <CGAL/Surface_mesh_foliation/repair.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <vector>

// Soups that are repaired, and what must hold of every result.

namespace smf_test {
namespace repaired_soups {

namespace SMF = CGAL::Surface_mesh_foliation;
using SMF::Polygon_soup;
using SMF::Repaired_soup;

inline Polygon_soup polygons(const Triangle_soup& soup)
{
  Polygon_soup result;
  result.points = soup.points;
  for (const auto& triangle : soup.triangles)
    result.polygons.emplace_back(triangle.begin(), triangle.end());
  return result;
}

inline std::size_t number_of_repairs(const SMF::Repair_report& report)
{
  return report.merged_vertices + report.triangulated_faces + report.degenerate_faces +
         report.repeated_faces + report.reversed_faces + report.duplicated_vertices +
         report.stitched_edges + report.unused_vertices;
}

inline std::size_t number_of_parts(const Triangle_soup& soup)
{
  SMF::internal::Disjoint_sets sets(soup.points.size());
  for (const auto& [a, b, c] : soup.triangles)
  {
    sets.union_set(a, b);
    sets.union_set(a, c);
  }
  std::set<std::size_t> representatives;
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    representatives.insert(sets.find_set(v));
  return representatives.size();
}

// Whatever was done: the result is a surface, perhaps with openings and of several parts, and the
// maps agree with each other and with positions.
inline void expect_sound(const Polygon_soup& input, const Repaired_soup& repaired)
{
  const Triangle_soup& soup = repaired.soup;
  for (const SMF::Problem& problem :
       SMF::check_triangle_soup(soup, SMF::parameters::allow_openings(true).allow_parts(true)))
    ADD_FAILURE() << problem.message;
  ASSERT_EQ(repaired.vertex_origins.size(), soup.points.size());
  ASSERT_EQ(repaired.face_origins.size(), soup.triangles.size());
  ASSERT_EQ(repaired.vertices.size(), input.points.size());
  ASSERT_EQ(repaired.first_faces.size(), input.polygons.size() + 1);
  EXPECT_TRUE(std::is_sorted(repaired.vertex_origins.begin(), repaired.vertex_origins.end()));
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    if (repaired.vertex_origins[v] != Repaired_soup::none)
    {
      EXPECT_EQ(soup.points[v], input.points.at(repaired.vertex_origins[v]));
    }
  for (std::size_t v = 0; v < input.points.size(); ++v)
    if (repaired.vertices[v] != Repaired_soup::none)
    {
      EXPECT_EQ(soup.points.at(repaired.vertices[v]), input.points[v]);
    }
  EXPECT_EQ(repaired.first_faces.front(), 0u);
  for (std::size_t f = 0; f < input.polygons.size(); ++f)
    for (std::size_t g = repaired.first_faces[f]; g < repaired.first_faces[f + 1]; ++g)
      EXPECT_EQ(repaired.face_origins.at(g), f);
  for (std::size_t g = repaired.first_faces.back(); g < soup.triangles.size(); ++g)
    EXPECT_EQ(repaired.face_origins[g], Repaired_soup::none);
  EXPECT_EQ(descriptions(repaired.report).empty(), number_of_repairs(repaired.report) == 0);
}

inline Repaired_soup repair(const Polygon_soup& input)
{
  const Repaired_soup result = SMF::repair_polygon_soup(input);
  expect_sound(input, result);
  return result;
}

inline bool is_closed(const Triangle_soup& soup)
{
  return SMF::check_triangle_soup(soup, SMF::parameters::allow_parts(true)).empty();
}

// the faces of a closed surface, each by its smallest corner and the two that follow
inline std::set<std::array<std::size_t, 3>> faces(const Triangle_soup& soup)
{
  std::set<std::array<std::size_t, 3>> result;
  for (auto triangle : soup.triangles)
  {
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()),
                triangle.end());
    result.insert(triangle);
  }
  return result;
}

inline const std::vector<Triangle_soup>& surfaces()
{
  static const std::vector<Triangle_soup> result = {
    soups::icosphere(2), soups::limbed_sphere(4, 3), soups::torus(9, 7, 3, 1),
    soups::genus_surface(2), soups::handle_surface(3)};
  return result;
}

} // namespace repaired_soups
} // namespace smf_test

#endif // SMF_TEST_REPAIRED_SOUPS_H
