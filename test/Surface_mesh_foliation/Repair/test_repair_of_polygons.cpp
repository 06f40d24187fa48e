// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Repair of meshes whose faces are polygons, alone and with many defects at once.

#include "generators/Random.h"
#include "generators/genus_soups.h"
#include "include/repaired_soups.h"

#include <CGAL/Surface_mesh_foliation/repair.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace test_repair_of_polygons {

namespace {

namespace soups = smf_test::soups;
using namespace smf_test::repaired_soups;
using smf_test::Triangle_soup;

// Joins pairs of neighboring triangles to quadrangles, and some of these with a third to pentagons.
Polygon_soup with_polygons(const Triangle_soup& soup)
{
  Polygon_soup result = polygons(soup);
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> face_of_side;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    for (int i : {0, 1, 2})
      face_of_side[{soup.triangles[f][i], soup.triangles[f][(i + 1) % 3]}] = f;
  std::vector<bool> is_gone(soup.triangles.size(), false), is_joined(is_gone);
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
  {
    if (is_gone[f] || is_joined[f])
      continue;
    for (int i : {0, 1, 2})
    {
      const std::size_t u = soup.triangles[f][i], v = soup.triangles[f][(i + 1) % 3];
      const std::size_t g = face_of_side.at({v, u});
      if (is_gone[g] || is_joined[g] || g == f || (f % 3 == 0 && i > 0))
        continue;
      std::size_t apex = 0;
      for (const std::size_t w : soup.triangles[g])
        if (w != u && w != v)
          apex = w;
      auto& face = result.polygons[f];
      const auto at_v = std::find(face.begin(), face.end(), v);
      if (at_v == face.end() || std::find(face.begin(), face.end(), apex) != face.end())
        continue;
      face.insert(at_v, apex);
      is_gone[g] = is_joined[f] = true;
      if (f % 2 == 0)
        break;
    }
  }
  std::vector<std::vector<std::size_t>> kept;
  for (std::size_t f = 0; f < result.polygons.size(); ++f)
    if (!is_gone[f])
      kept.push_back(result.polygons[f]);
  result.polygons = std::move(kept);
  return result;
}

TEST(Repair_of_polygons, cuts_polygons_into_triangles)
{
  for (const Triangle_soup& soup : surfaces())
  {
    const Polygon_soup input = with_polygons(soup);
    std::size_t number = 0;
    for (const auto& face : input.polygons)
      number += face.size() > 3;
    ASSERT_GT(number, 5u);
    const Repaired_soup result = repair(input);
    EXPECT_TRUE(is_closed(result.soup));
    EXPECT_EQ(result.report.triangulated_faces, number);
    EXPECT_EQ(number_of_repairs(result.report), number);
    EXPECT_EQ(soups::genus(result.soup), soups::genus(soup));
    for (std::size_t f = 0; f < input.polygons.size(); ++f)
    {
      const std::size_t pieces = result.first_faces[f + 1] - result.first_faces[f];
      const std::size_t corners = input.polygons[f].size();
      EXPECT_TRUE(pieces == corners - 2 || pieces == corners); // the latter around a new vertex
    }
  }
}

TEST(Repair_of_polygons, cuts_polygons_whose_diagonals_are_edges_elsewhere)
{
  // two quadrangles with the same corners: a pillow, whose diagonals would coincide
  const Polygon_soup input = {{{0, 0, 0}, {1, 0, 0.1}, {1, 1, 0}, {0, 1, 0.1}},
                              {{0, 1, 2, 3}, {3, 2, 1, 0}}};
  const Repaired_soup result = SMF::repair_polygon_soup(input);
  EXPECT_EQ(result.report.triangulated_faces, 2u);
  EXPECT_TRUE(is_closed(result.soup));
  EXPECT_EQ(number_of_parts(result.soup), 1u);
}

TEST(Repair_of_polygons, removes_repeated_corners)
{
  for (const Triangle_soup& soup : surfaces())
  {
    Polygon_soup input = polygons(soup);
    input.polygons[2].insert(input.polygons[2].begin() + 1, input.polygons[2][1]);
    input.polygons.push_back({4, 4, 5});
    input.polygons.push_back({4, 5});
    input.polygons.emplace_back();
    const Repaired_soup result = repair(input);
    EXPECT_EQ(result.report.degenerate_faces, 3u);
    EXPECT_EQ(number_of_repairs(result.report), 3u);
    EXPECT_EQ(result.soup.points, soup.points);
    EXPECT_EQ(faces(result.soup), faces(soup));
  }
}

// what happens to meshes in the course of their lives, at random
Polygon_soup damaged(const Triangle_soup& soup, smf_test::Random& random)
{
  Polygon_soup result = with_polygons(soup);
  for (int i = 0; i < 5; ++i)
  {
    auto& face = result.polygons[random.index(result.polygons.size())];
    std::reverse(face.begin(), face.end());
    result.polygons.push_back(result.polygons[random.index(result.polygons.size())]);
    result.points.push_back(result.points[random.index(result.points.size())]);
    auto& cut = result.polygons[random.index(result.polygons.size())]; // has a corner of its own
    result.points.push_back(result.points[cut[0]]);
    cut[0] = result.points.size() - 1;
    result.polygons.erase(result.polygons.begin() + random.index(result.polygons.size()));
    auto& wild = result.polygons[random.index(result.polygons.size())];
    wild[random.index(wild.size())] = random.index(result.points.size());
  }
  return result;
}

TEST(Repair_of_polygons, of_many_defects_at_once)
{
  smf_test::Random random(11);
  for (int round = 0; round < 40; ++round)
    for (const Triangle_soup& soup : surfaces())
    {
      const Polygon_soup input = damaged(soup, random);
      const Repaired_soup result = repair(input);
      EXPECT_GT(result.soup.triangles.size(), soup.triangles.size() / 2);
      // parts whose borders coincide may be joined the next time
      const auto again = repair(polygons(result.soup)).report;
      EXPECT_EQ(again.triangulated_faces + again.unused_vertices, 0u);
    }
}

// A fuzzer found it: the sides of the second polygon are longer than the largest number.
TEST(Repair_of_polygons, of_a_size_at_the_end_of_the_range)
{
  constexpr double large = 1.7e308;
  const Polygon_soup input = {
    {{large, large, large}, {1, 0, 0}, {3, -1e150, 1}, {0, 3, 3}, {large, large, large}},
    {{1, 3, 4}, {0, 3, 4, 2, 2, 4, 1}}};
  for (const auto& point : repair(input).soup.points)
    for (const double coordinate : point)
      EXPECT_TRUE(std::isfinite(coordinate));
}

} // namespace

} // namespace test_repair_of_polygons
