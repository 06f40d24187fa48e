// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Moduli of homotopy classes of loops, against those that are known in closed form.

#include "generators/known_moduli.h"
#include "generators/meshes.h"
#include "generators/openings.h"
#include "generators/revolution.h"

#include <CGAL/Surface_mesh_foliation/Poles_and_loops.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/loop_modulus.h>
#include <CGAL/Surface_mesh_foliation/openings.h>

#include <CGAL/boost/graph/iterator.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace test_loop_modulus {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
namespace np = SMF::parameters;
using namespace smf_test;
using Input = SMF::Poles_and_loops<Mesh>;
double modulus_around_capsule(const Mesh& mesh,
                              const std::array<std::size_t, 4>& poles,
                              double level,
                              int number_of_proxy_vertices = 5000)
{
  Input input;
  for (const std::size_t v : poles)
    input.add_pole(vertex(v));
  input.add_loop(section(mesh, 0, level).at(0));
  return SMF::loop_modulus(mesh, input, 4, np::number_of_proxy_vertices(number_of_proxy_vertices));
}

} // namespace

TEST(Loop_modulus, of_capsules_converges_from_below)
{
  for (const double length : {1., 3.})
  {
    double last_error = 1;
    for (const std::size_t n : {20, 40, 80}) // about 5,000 vertices
    {
      const auto [soup, poles] = soups::capsule(length, n);
      const double error = 1 - modulus_around_capsule(to_mesh(soup), poles, 0.501 * length) /
                                 modulus_of_capsule(length);
      EXPECT_GT(error, 0) << length << ' ' << n;
      EXPECT_LT(error, 0.7 * last_error) << length << ' ' << n;
      last_error = error;
    }
    EXPECT_LT(last_error, 0.01) << length;
  }
}

TEST(Loop_modulus, does_not_depend_on_the_shapes_of_triangles)
{
  constexpr double length = 3;
  const double exact = modulus_of_capsule(length);
  const auto error = [&](const Mesh& mesh, const std::array<std::size_t, 4>& poles) {
    return std::abs(modulus_around_capsule(mesh, poles, 0.501 * length) / exact - 1);
  };
  for (const double stretch : {0.1, 0.25, 4., 10.})
  {
    const auto n = static_cast<std::size_t>(64 * std::sqrt(stretch)) / 2 * 2;
    const auto [soup, poles] = soups::capsule(length, n, stretch);
    EXPECT_LT(error(to_mesh(soup), poles), 0.015) << stretch;
  }
  const auto [soup, poles] = soups::capsule(length, 64);
  EXPECT_LT(error(flip_random_edges(to_mesh(soup), 0.1, 1), poles), 0.01);
  EXPECT_LT(error(noisy(to_mesh(soup), 0.05, 1), poles), 0.01);
}

// Faces of a washer reach from its inner to its outer border, where no vertex is between.
TEST(Loop_modulus, is_good_on_needles)
{
  constexpr double radius = 8; // of the outer border; that of the inner one is 1, as is the height
  const double exact = (2 * std::log(radius) + 1 / radius + 1) / (2 * soups::pi);
  double last_error = 1;
  for (const std::size_t n : {50, 200, 800})
  {
    Triangle_soup soup = soups::tube_of_revolution({{0, 1}, {0, radius}, {1, radius}, {1, 1}}, n);
    for (std::size_t i = 0; i < n; ++i)
    {
      const std::size_t j = (i + 1) % n;
      soup.triangles.push_back({3 * n + i, i, j});
      soup.triangles.push_back({3 * n + i, j, 3 * n + j});
    }
    const Mesh mesh = to_mesh(soup);
    Input input;
    input.add_loop(section(mesh, 0, 0.5).at(0));
    const double error = 1 - SMF::loop_modulus(mesh, input, 0) / exact;
    EXPECT_GT(error, 0) << n;
    EXPECT_LT(error, last_error) << n;
    last_error = error;
  }
  EXPECT_LT(last_error, 0.02);
}

TEST(Loop_modulus, of_a_coarser_mesh_is_nearly_the_same)
{
  const auto [soup, poles] = soups::capsule(3, 96);
  const Mesh mesh = to_mesh(soup);
  EXPECT_GT(num_vertices(mesh), 8000);
  const double exact = modulus_of_capsule(3);
  EXPECT_NEAR(modulus_around_capsule(mesh, poles, 1.501, 20000) / exact, 1, 0.01);
  EXPECT_NEAR(modulus_around_capsule(mesh, poles, 1.501, 5000) / exact, 1, 0.01);
  EXPECT_NEAR(modulus_around_capsule(mesh, poles, 1.501, 1000) / exact, 1, 0.02);
}

TEST(Loop_modulus, of_both_classes_of_a_torus_of_revolution)
{
  const Mesh mesh = torus(96, 48, 2, 1);
  const std::vector<SMF::Loop<Mesh>> around = section(mesh, 2, 0.01);
  const std::vector<SMF::Loop<Mesh>> across = section(mesh, 0, 0.01);
  ASSERT_EQ(around.size(), 2u);
  ASSERT_EQ(across.size(), 2u);
  const auto modulus = [&](const SMF::Loop<Mesh>& loop) {
    Input input;
    input.add_loop(loop);
    return SMF::loop_modulus(mesh, input, 0);
  };
  EXPECT_NEAR(modulus(across[0]) / std::sqrt(3.), 1, 0.01);
  EXPECT_NEAR(modulus(across[1]) / std::sqrt(3.), 1, 0.01);
  EXPECT_NEAR(modulus(around[0]) * std::sqrt(3.), 1, 0.01);
}

// The thinner the torus, the fewer vertices are around it, and a coarser mesh of 5,000 vertices has
// about a third as many as the finest. Its chords would make some moduli three percent too large.
TEST(Loop_modulus, of_thin_tori_hardly_depends_on_the_number_of_vertices)
{
  for (const double radius : {6., 10., 15., 25.})
    for (const double number : {5000., 20000., 40000.})
    {
      const double around = std::round(std::sqrt(number / radius));
      const auto across = 2 * static_cast<std::size_t>(std::round(around * radius / 2));
      const Mesh mesh = torus(across, static_cast<std::size_t>(around), radius, 1);
      Input input;
      input.add_loop(section(mesh, 0, 0.0123).at(0));
      EXPECT_NEAR(SMF::loop_modulus(mesh, input, 0) / std::sqrt(radius * radius - 1), 1, 0.01)
        << radius << ' ' << number;
    }
}

TEST(Loop_modulus, of_long_tubes_hardly_depends_on_the_number_of_vertices)
{
  for (const double length : {10., 40., 80.})
    for (const double number : {5000., 20000., 40000.})
    {
      const double side = std::sqrt(length / number / std::sqrt(0.75) * 2 * soups::pi);
      const auto around = 2 * static_cast<std::size_t>(soups::pi / side);
      const auto [soup, poles] = soups::capsule(length, around);
      EXPECT_NEAR(modulus_around_capsule(to_mesh(soup), poles, 0.501 * length) /
                    modulus_of_capsule(length),
                  1, 0.01)
        << length << ' ' << number;
    }
}

TEST(Loop_modulus, of_annuli_and_pants_around_an_opening)
{
  constexpr std::size_t circles = 24, n = 96;
  const Mesh mesh = to_open_mesh(soups::disk(circles, n));
  Input input;
  SMF::add_border_poles(mesh, input);
  ASSERT_EQ(input.size(), 1u);
  // two poles, halfway to the border: the annulus around the segment between them
  input.add_pole(vertex((circles / 2 - 1) * n));
  input.add_pole(vertex((circles / 2 - 1) * n + n / 2));
  EXPECT_NEAR(SMF::loop_modulus(mesh, input, 0) / (ratio_of_elliptic_integrals(0.25) / 8), 1, 0.02);
  EXPECT_EQ(SMF::loop_modulus(mesh, input, 1), std::numeric_limits<double>::infinity());
  EXPECT_THROW(SMF::loop_modulus(mesh, input, 3), SMF::Invalid_parameter_exception);
  // without the faces around the center, a ring with an inner radius of 1/24
  Triangle_soup ring = soups::disk(circles, n);
  ring.triangles.resize(ring.triangles.size() - n);
  ring.points.pop_back();
  const Mesh annulus = to_open_mesh(ring);
  Input openings;
  SMF::add_border_poles(annulus, openings);
  for (const std::size_t loop : {0, 1})
    EXPECT_NEAR(SMF::loop_modulus(annulus, openings, loop) /
                  (std::log(static_cast<double>(circles)) / (2 * soups::pi)),
                1, 0.02);
}

} // namespace test_loop_modulus
