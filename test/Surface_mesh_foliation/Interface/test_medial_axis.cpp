// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The measure by which the experiments judge whether skeletons are centered, on shapes whose medial
// axes are known.

#include "benchmark/Surface_mesh_foliation/experiments/Medial_axis.h"
#include "generators/revolution.h"

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace test_medial_axis {

namespace {

namespace soups = smf_test::soups;
using smf_experiments::Medial_axis;
using smf_test::Mesh;
using Point = Medial_axis::Point;

constexpr double pi = 3.14159265358979323846;
constexpr std::size_t number_of_samples = 20000;

Medial_axis medial_axis(const smf_test::Triangle_soup& soup)
{
  return {smf_test::to_mesh(soup), number_of_samples, 1};
}

// all of the points are as far from the axis as they should be, and their balls are as large
void expect_distance(const Medial_axis& axis,
                     const std::vector<Point>& points,
                     double distance,
                     double radius,
                     double tolerance)
{
  for (const Point& p : points)
  {
    const auto [center, found] = axis.nearest_ball(p);
    EXPECT_NEAR(std::sqrt(CGAL::squared_distance(p, center)), distance, tolerance) << p;
    EXPECT_NEAR(found, radius, tolerance) << p;
  }
}

// parallel to the axis of a capsule of length 4
std::vector<Point> line(double shift)
{
  std::vector<Point> result;
  for (int i = 0; i <= 100; ++i)
    result.emplace_back(0.04 * i, 0.6 * shift, 0.8 * shift);
  return result;
}

// around the hole of a torus, in the plane of its middle
std::vector<Point> circle(double radius)
{
  std::vector<Point> result;
  for (int i = 0; i < 100; ++i)
    result.emplace_back(radius * std::cos(2 * pi * i / 100), radius * std::sin(2 * pi * i / 100),
                        0);
  return result;
}

TEST(Medial_axis, of_a_capsule_is_a_segment)
{
  const Medial_axis axis = medial_axis(soups::capsule(4, 64).first);
  for (const double shift : {0., 0.2, 0.5, 0.9})
    expect_distance(axis, line(shift), shift, 1, 0.05);
  // beyond its ends
  expect_distance(axis, {Point(-1, 0, 0), Point(5, 0, 0)}, 1, 1, 0.05);
}

TEST(Medial_axis, of_a_torus_is_a_circle)
{
  const Medial_axis axis = medial_axis(soups::torus(96, 48, 2, 0.5));
  for (const double radius : {1.6, 1.9, 2., 2.3})
    expect_distance(axis, circle(radius), std::abs(radius - 2), 0.5, 0.05);
}

TEST(Medial_axis, of_a_slab_has_a_sheet_halfway_between_its_sides)
{
  Mesh mesh;
  CGAL::make_hexahedron(Point(0, 0, 0), Point(4, 0, 0), Point(4, 4, 0), Point(0, 4, 0),
                        Point(0, 4, 1), Point(0, 0, 1), Point(4, 0, 1), Point(4, 4, 1), mesh);
  CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
  const Medial_axis axis(mesh, number_of_samples, 1);
  for (const double shift : {0., 0.25, 0.4})
  {
    std::vector<Point> points;
    for (int i = 0; i <= 10; ++i)
      for (int j = 0; j <= 10; ++j)
        points.emplace_back(1 + 0.2 * i, 1 + 0.2 * j, 0.5 + shift);
    expect_distance(axis, points, shift, 0.5, 0.1); // samples are half as far apart
  }
}

TEST(Medial_axis, lies_inside_and_has_no_sheets_at_flat_edges)
{
  // each edge of the cylinder has a sheet, from the axis to the edge, where two faces are close
  const Medial_axis axis = medial_axis(soups::capsule(4, 16).first);
  ASSERT_FALSE(axis.balls().empty());
  for (const auto& [center, radius] : axis.balls())
    EXPECT_LT(std::hypot(center.y(), center.z()), 0.2);
}

} // namespace

} // namespace test_medial_axis
