// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Soups that are no manifolds: they come apart where surfaces meet.

#include "generators/genus_soups.h"
#include "include/repaired_soups.h"

#include <CGAL/Surface_mesh_foliation/repair.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

namespace test_repair_of_non_manifolds {

namespace {

namespace soups = smf_test::soups;
using namespace smf_test::repaired_soups;
using smf_test::Triangle_soup;

// two copies of a surface that share the vertices listed
Polygon_soup siamese(const Triangle_soup& soup, const std::set<std::size_t>& shared)
{
  Polygon_soup result = polygons(soup);
  std::vector<std::size_t> twin(soup.points.size());
  for (std::size_t v = 0; v < soup.points.size(); ++v)
  {
    twin[v] = v;
    if (shared.count(v) > 0)
      continue;
    twin[v] = result.points.size();
    auto point = soup.points[v];
    for (double& coordinate : point)
      coordinate *= 3;
    result.points.push_back(point);
  }
  for (const auto& [a, b, c] : soup.triangles)
    result.polygons.push_back({twin[a], twin[b], twin[c]});
  return result;
}

TEST(Repair_of_non_manifolds, takes_surfaces_apart_that_share_vertices)
{
  for (const Triangle_soup& soup : surfaces())
  {
    const Repaired_soup result = repair(siamese(soup, {0}));
    EXPECT_EQ(result.report.duplicated_vertices, 1u);
    EXPECT_EQ(number_of_repairs(result.report), 1u);
    EXPECT_EQ(number_of_parts(result.soup), 2u);
    EXPECT_TRUE(is_closed(result.soup));
    EXPECT_EQ(result.vertex_origins[0], 0u);
    EXPECT_EQ(result.vertex_origins[1], 0u);
    EXPECT_EQ(result.vertices[0], 0u);
  }
}

TEST(Repair_of_non_manifolds, takes_surfaces_apart_that_share_edges)
{
  for (const Triangle_soup& soup : surfaces())
  {
    const auto& face = soup.triangles[0];
    // an edge, and a path of two edges, around whose middle each surface comes apart and is joined
    for (const std::set<std::size_t>& shared :
         {std::set<std::size_t>{face[0], face[1]}, std::set<std::size_t>(face.begin(), face.end())})
    {
      Polygon_soup input = siamese(soup, shared);
      if (shared.size() == 3) // the face itself is there twice
        input.polygons.erase(input.polygons.begin() + soup.triangles.size());
      const Repaired_soup result = repair(input);
      EXPECT_GT(result.report.duplicated_vertices, 1u);
      EXPECT_EQ(number_of_parts(result.soup), 2u + (shared.size() == 3));
    }
  }
}

TEST(Repair_of_non_manifolds, takes_fins_and_inner_walls_off)
{
  // a tetrahedron with a fin
  Polygon_soup fin = polygons(soups::tetrahedron());
  fin.points.push_back({5, 5, 5});
  fin.polygons.push_back({0, 1, 4});
  Repaired_soup result = repair(fin);
  EXPECT_EQ(result.report.duplicated_vertices, 2u);
  EXPECT_EQ(number_of_parts(result.soup), 2u);
  // two tetrahedra with the wall between them
  const Polygon_soup wall = {
    {{1, 0, 0}, {0, 1, 0}, {-1, -1, 0}, {0, 0, 1}, {0, 0, -1}},
    {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}, {0, 1, 2}}};
  result = repair(wall);
  EXPECT_EQ(result.report.duplicated_vertices, 6u);
  EXPECT_EQ(number_of_parts(result.soup), 3u);
}

TEST(Repair_of_non_manifolds, cuts_surfaces_that_cannot_be_oriented)
{
  // Moebius strips of several lengths, and the projective plane of six vertices
  for (const std::size_t length : {5, 8, 13})
  {
    Polygon_soup strip;
    for (std::size_t i = 0; i < length; ++i)
    {
      const double angle = 2 * std::acos(-1) * i / length;
      for (const double side : {-0.3, 0.3})
        strip.points.push_back({std::cos(angle) * (2 + side * std::cos(angle / 2)),
                                std::sin(angle) * (2 + side * std::cos(angle / 2)),
                                side * std::sin(angle / 2)});
    }
    for (std::size_t i = 0; i < length; ++i)
    {
      const bool is_last = i + 1 == length;
      const std::size_t a = 2 * i, b = 2 * i + 1, c = is_last ? 1 : 2 * i + 2,
                        d = is_last ? 0 : 2 * i + 3;
      strip.polygons.push_back({a, b, c});
      strip.polygons.push_back({b, d, c});
    }
    const Repaired_soup result = repair(strip);
    EXPECT_GT(result.report.duplicated_vertices, 0u);
    EXPECT_EQ(result.soup.triangles.size(), strip.polygons.size());
  }
  const Polygon_soup plane = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 1, 1.5}, {1, 0, 2}},
                              {{0, 1, 2},
                               {0, 2, 3},
                               {0, 3, 4},
                               {0, 4, 5},
                               {0, 5, 1},
                               {1, 2, 4},
                               {2, 3, 5},
                               {3, 4, 1},
                               {4, 5, 2},
                               {5, 1, 3}}};
  const Repaired_soup result = repair(plane);
  EXPECT_GT(result.report.duplicated_vertices, 0u);
  EXPECT_FALSE(is_closed(result.soup));
}

// Vertices 1, 3 and 4 lie on a line, and two faces hang together by the face without area there.
TEST(Repair_of_non_manifolds, takes_surfaces_apart_that_share_a_corner_of_a_face_without_area)
{
  Polygon_soup input;
  input.points = {{2, 1, 2}, {2, 2, 0}, {2, 0.5, 0}, {3, 1, 0}, {1, 3, 0}};
  input.polygons = {{1, 3, 4}, {1, 3, 2}, {3, 4, 0}};
  const Repaired_soup result = repair(input);
  EXPECT_EQ(result.report.degenerate_faces, 1u);
  EXPECT_EQ(result.report.duplicated_vertices, 1u);
  EXPECT_EQ(number_of_parts(result.soup), 2u);
}

// Vertices 0 and 1 are at one place, and faces 1 and 2 back to back. Since faces 0 and 3 are there,
// too, the edges at vertex 0 are not open in the beginning.
TEST(Repair_of_non_manifolds, leaves_one_of_two_faces_that_are_joined_along_three_edges)
{
  Polygon_soup input;
  input.points = {{0, 0, 0}, {0, 0, 0}, {0, 1, 1}, {1, 2, 0}};
  input.polygons = {{0, 0, 3}, {0, 3, 2}, {2, 3, 1}, {2, 0, 0}};
  const Repaired_soup result = repair(input);
  EXPECT_EQ(result.report.repeated_faces, 1u);
  EXPECT_EQ(result.report.stitched_edges, 2u);
  EXPECT_EQ(result.face_origins, std::vector<std::size_t>(1, 1));
}

} // namespace

} // namespace test_repair_of_non_manifolds
