// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Openings are found, and closed by caps.

#include "generators/soups.h"

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/openings.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/vertex_areas.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace test_caps {

namespace {

namespace internal = CGAL::Surface_mesh_foliation::internal;
namespace soups = smf_test::soups;
using internal::Border;
using internal::Point;

// an octahedron without some of its faces
smf_test::Triangle_soup octahedron_without(const std::vector<std::size_t>& missing)
{
  const smf_test::Triangle_soup whole = soups::octahedron();
  smf_test::Triangle_soup result;
  result.points = whole.points;
  for (std::size_t f = 0; f < whole.triangles.size(); ++f)
    if (std::find(missing.begin(), missing.end(), f) == missing.end())
      result.triangles.push_back(whole.triangles[f]);
  return result;
}

} // namespace

TEST(Caps, openings_are_found_in_the_order_of_their_smallest_vertices)
{
  EXPECT_TRUE(internal::find_openings(octahedron_without({})).empty());
  // an opening runs like the face that is missing
  EXPECT_EQ(internal::find_openings(octahedron_without({0})), (std::vector<Border>{{0, 2, 4}}));
  EXPECT_EQ(internal::find_openings(octahedron_without({6, 0})),
            (std::vector<Border>{{0, 2, 4}, {1, 5, 3}}));
  // the upper half
  EXPECT_EQ(internal::find_openings(octahedron_without({0, 1, 2, 3})),
            (std::vector<Border>{{0, 2, 1, 3}}));
  // a single face, whose opening is its other side
  EXPECT_EQ(internal::find_openings({soups::octahedron().points, {{1, 3, 2}}}),
            (std::vector<Border>{{1, 2, 3}}));
}

TEST(Caps, centers)
{
  const std::vector<Point> rectangle = {{0, 0, 1}, {4, 0, 1}, {4, 2, 1}, {0, 2, 1}};
  EXPECT_EQ(internal::centroid_of_border({0, 1, 2, 3}, rectangle).point(), (Point{2, 1, 1}));
  // weighted by length, so that a further vertex on a side makes no difference
  const std::vector<Point> more = {{0, 0, 1}, {1, 0, 1}, {4, 0, 1}, {4, 2, 1}, {0, 2, 1}};
  const Point center = internal::centroid_of_border({0, 1, 2, 3, 4}, more).point();
  EXPECT_NEAR(center[0], 2, 1e-15);
  EXPECT_NEAR(center[1], 1, 1e-15);
}

TEST(Caps, have_a_center_where_lengths_overflow)
{
  constexpr double large = 1.7e308;
  const std::vector<Point> square = {
    {large, large, 1}, {-large, large, 1}, {-large, -large, 1}, {large, -large, 1}};
  const Point center = internal::centroid_of_border({0, 1, 2, 3}, square).point();
  EXPECT_NEAR(center[0] / large, 0, 1e-15);
  EXPECT_NEAR(center[1] / large, 0, 1e-15);
  EXPECT_NEAR(center[2], 1, 1e-15);
}

TEST(Caps, close_the_mesh_behind_its_elements)
{
  const smf_test::Triangle_soup soup = octahedron_without({0, 6});
  std::vector<Point> points = soup.points;
  std::vector<internal::Triangle> triangles;
  for (const auto& [a, b, c] : soup.triangles)
    triangles.push_back({static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)});
  const std::vector<Border> openings = internal::find_openings(soup);
  internal::add_caps(openings, points, triangles);
  const internal::Flat_mesh mesh(points, triangles, 2, 6);
  EXPECT_EQ(mesh.euler_characteristic(), 2);
  EXPECT_EQ(mesh.number_of_vertices(), 8);
  EXPECT_EQ(mesh.number_of_caps(), 2);
  EXPECT_EQ(mesh.number_of_input_vertices(), 6);
  EXPECT_EQ(mesh.number_of_input_faces(), 6);
  EXPECT_FALSE(mesh.is_cap_vertex(5));
  EXPECT_TRUE(mesh.is_cap_vertex(6));
  EXPECT_FALSE(mesh.is_cap_face(5));
  EXPECT_TRUE(mesh.is_cap_face(6));
  int border = 0, inside = 0;
  for (int e = 0; e < mesh.number_of_edges(); ++e)
  {
    border += mesh.is_border_edge(e);
    inside += mesh.is_cap_edge(e);
    EXPECT_FALSE(mesh.is_border_edge(e) && mesh.is_cap_edge(e));
  }
  EXPECT_EQ(border, 6);
  EXPECT_EQ(inside, 6);
  for (int h : mesh.ring(7))
    EXPECT_TRUE(mesh.is_cap_edge(internal::edge_of(h)));
  // the faces of the input are equal, and caps have no area
  const std::vector<double> areas = internal::vertex_areas(mesh);
  for (int v = 0; v < mesh.number_of_vertices(); ++v)
  {
    int faces = 0;
    for (int h : mesh.ring(v))
      faces += !mesh.is_cap_face(mesh.face(h));
    EXPECT_NEAR(areas[static_cast<std::size_t>(v)], faces / 18., 1e-15) << v;
  }
}

} // namespace test_caps
