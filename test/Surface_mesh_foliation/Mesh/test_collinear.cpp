// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Whether the corners of a face lie on a line: the exact test, beside CGAL's, and the filter before
// it.

#include <CGAL/Surface_mesh_foliation/internal/Mesh/are_collinear.h>

#include "generators/Random.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace test_collinear {

namespace {

using namespace CGAL::Surface_mesh_foliation::internal;
using smf_test::Random;
using Exact_point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Corners = std::array<std::array<double, 3>, 3>;

bool are_collinear_by_cgal(const Corners& p)
{
  return CGAL::collinear(Exact_point(p[0][0], p[0][1], p[0][2]),
                         Exact_point(p[1][0], p[1][1], p[1][2]),
                         Exact_point(p[2][0], p[2][1], p[2][2]));
}

} // namespace

// The filter before the exact test lets no degenerate face pass, at no scale.
TEST(Clearly_not_collinear, is_never_said_of_points_on_a_line)
{
  Random random(4);
  std::size_t clear = 0;
  for (int round = 0; round < 20000; ++round)
  {
    const double scale = std::pow(10., random.between(-160, 150));
    Corners p{};
    for (auto& point : p)
      for (double& coordinate : point)
        coordinate = scale * random.between(-1, 1);
    clear += are_clearly_not_collinear(p[0], p[1], p[2]);
    for (std::size_t i = 0; i < 3; ++i) // nearly on a line, or exactly
      p[2][i] = p[0][i] + (p[1][i] - p[0][i]) * random.index(3);
    if (are_clearly_not_collinear(p[0], p[1], p[2]))
    {
      EXPECT_FALSE(are_collinear_by_cgal(p));
    }
  }
  EXPECT_GT(clear, 18000u);
}

// at the ends of the range, where products of differences are no doubles
TEST(Collinear, are_points_of_any_size)
{
  using Limits = std::numeric_limits<double>;
  const double least = Limits::denorm_min(), largest = (Limits::max)();
  for (const double x : {least, 3 * least, Limits::min(), 1., 0.1, largest / 4})
  {
    EXPECT_TRUE(are_collinear({0, 0, 0}, {x, x, -x}, {-4 * x, -4 * x, 4 * x}));
    EXPECT_FALSE(are_collinear({0, 0, 0}, {x, x, -x}, {-4 * x, -4 * x, 3 * x}));
    EXPECT_FALSE(are_collinear({x, 0, 0}, {-x, least, 0}, {largest, 0, 0}));
    EXPECT_TRUE(are_collinear({x, 0, largest}, {x, 0, least}, {x, 0, -x}));
  }
}

// Points on a line, nearly on a line and anywhere, at all scales that CGAL's kernel can have, and
// with axes of different scales.
TEST(Collinear, are_points_that_are_for_cgal)
{
  Random random(5);
  std::size_t collinear = 0, others = 0;
  for (int round = 0; round < 20000; ++round)
  {
    Corners p{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      const int exponent = static_cast<int>(random.index(600)) - 300;
      const bool is_whole = random.index(2) == 0;
      for (std::size_t corner = 0; corner < 2; ++corner)
        p[corner][i] = std::ldexp(
          is_whole ? static_cast<double>(random.index(100)) - 50 : random.between(-1, 1), exponent);
      const double steps = round % 5; // the third point is on the line if this is exact
      p[2][i] = p[0][i] + (p[1][i] - p[0][i]) * steps;
    }
    if (random.index(4) == 0)
      p[2][0] = std::nextafter(p[2][0], 1e300);
    const bool expected = are_collinear_by_cgal(p);
    EXPECT_EQ(are_collinear(p[0], p[1], p[2]), expected);
    EXPECT_EQ(are_collinear(p[2], p[0], p[1]), expected);
    ++(expected ? collinear : others);
  }
  EXPECT_GT(collinear, 2000u);
  EXPECT_GT(others, 2000u);
}

} // namespace test_collinear
