// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Bounds for the modulus of annuli around a place, beside the modulus itself.

#include "generators/genus_soups.h"
#include "generators/meshes.h"
#include "generators/revolution.h"
#include "include/flat_meshes.h"

#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Class_moduli.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Potential_annuli.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Geodesic_distances.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace test_potential_annuli {

namespace {

namespace SI = CGAL::Surface_mesh_foliation::internal;
using namespace smf_test;
constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<bool> nearest_vertices(const SI::Flat_mesh& mesh, int vertex, int number)
{
  std::vector<bool> result(mesh.number_of_vertices(), false);
  const SI::Geodesic_distances nearest(mesh, SI::edge_lengths(mesh), {vertex}, [&](int v) {
    result[v] = number > 0;
    return number-- > 0;
  });
  return result;
}

struct Surface
{
  explicit Surface(const Triangle_soup& soup, const std::vector<SI::Pole>& poles = {})
    : mesh(flat_mesh(soup)),
      moduli(mesh, SI::edge_lengths(mesh), poles),
      annuli(moduli.mesh(), moduli.weights())
  {}

  double modulus(int vertex, const std::vector<bool>& cap, std::vector<SI::Pole> poles)
  {
    poles.push_back({vertex});
    moduli.set_poles(poles);
    return moduli.around_cap(static_cast<int>(poles.size()) - 1, cap);
  }

  const SI::Flat_mesh mesh;
  SI::Class_moduli moduli;
  SI::Potential_annuli annuli;
};

struct Surface_of_capsule
{
  explicit Surface_of_capsule(int number) : n(number), soup(soups::capsule(2, number).first), tip(0)
  {
    tip = static_cast<int>(soup.points.size()) - 2;
  }

  // of poles on opposite sides, beside each other, and at the other end
  std::vector<std::vector<SI::Pole>> pairs_of_poles() const
  {
    const int middle = tip / 2 / n * n;
    return {{{middle}, {middle + n / 2}}, {{middle}, {middle + n / 8}}, {{middle}, {tip + 1}}};
  }

  int n;
  Triangle_soup soup;
  int tip;
};

// Checks the bounds around random vertices, with random poles outside of the cap.
void expect_enclosed(const Triangle_soup& soup,
                     std::size_t least_poles,
                     double largest_loss,
                     double largest_gain)
{
  constexpr int size_of_cap = 7;
  constexpr double rounding = 1e-3; // the modulus is a little too small; see Class_moduli
  Surface surface(soup);
  std::mt19937 random(1);
  for (std::size_t number = least_poles; number < least_poles + 8; ++number)
  {
    const int n = surface.mesh.number_of_vertices();
    const int vertex = static_cast<int>(random() % n);
    const std::vector<bool> cap = nearest_vertices(surface.mesh, vertex, size_of_cap);
    std::vector<SI::Pole> poles;
    while (poles.size() < number)
    {
      const int v = static_cast<int>(random() % n);
      if (!cap[v] && std::find(poles.begin(), poles.end(), SI::Pole{v}) == poles.end())
        poles.push_back({v});
    }
    const double modulus = surface.modulus(vertex, cap, poles);
    const auto [lower, upper] = surface.annuli(vertex, cap, poles);
    EXPECT_LE(lower, modulus * (1 + rounding)) << number << " poles";
    EXPECT_GE(lower, modulus - largest_loss) << number << " poles";
    EXPECT_GE(upper, modulus) << number << " poles";
    const auto spread = surface.annuli.around_spread_source(cap, poles);
    EXPECT_LE(spread.lower, modulus * (1 + rounding)) << number << " poles";
    EXPECT_GE(spread.lower, modulus - largest_loss) << number << " poles";
    EXPECT_GE(spread.upper, modulus * (1 - rounding)) << number << " poles";
    if (surface.mesh.genus() == 0)
    {
      EXPECT_LE(spread.upper, modulus + largest_gain) << number << " poles";
    }
  }
}

} // namespace

TEST(Potential_annuli, enclose_the_modulus)
{
  expect_enclosed(soups::icosphere(4), 2, 0.25, 0.1);
  expect_enclosed(soups::limbed_sphere(5, 4), 2, 0.25, 0.1);
  expect_enclosed(soups::torus(60, 30, 3, 1), 1, 0.4, infinity);
  expect_enclosed(soups::genus_surface(2, 4), 0, 0.4, infinity);
}

// A sphere with a place and two poles is like any other one, up to a conformal map. For it, Koebe's
// bound is reached, by a slit from pole to pole. Equal sinks lose half of the radius, and with half
// of them in the saddle, in the middle of the slit, a factor of the square root of two. (That
// is for small round caps.)
TEST(Potential_annuli, are_known_with_two_poles_on_a_sphere)
{
  constexpr int n = 64;
  const Surface_of_capsule capsule(n);
  for (const auto& poles : capsule.pairs_of_poles())
  {
    Surface surface(capsule.soup);
    const std::vector<bool> cap = nearest_vertices(surface.mesh, capsule.tip, 1 + 2 * n);
    const double modulus = surface.modulus(capsule.tip, cap, poles);
    const auto [lower, upper] = surface.annuli(capsule.tip, cap, poles);
    EXPECT_NEAR(upper, modulus, 0.03);
    EXPECT_NEAR(lower, modulus - std::log(2.) / (4 * std::acos(-1.)), 0.03);
  }
}

// As on a finger beside its tip: a cap that contains the pole, and one that runs around it.
TEST(Potential_annuli, are_none_around_a_cap_with_a_pole)
{
  for (const Triangle_soup& soup :
       {soups::icosphere(3), soups::torus(30, 15, 3, 1), soups::genus_surface(2, 4)})
  {
    Surface surface(soup);
    std::vector<bool> cap = nearest_vertices(surface.mesh, 0, 30);
    const std::vector<SI::Pole> poles = {{0}, {surface.mesh.number_of_vertices() - 1}};
    const int vertex = surface.mesh.target(surface.mesh.ring(0)[0]);
    ASSERT_TRUE(cap[vertex]);
    for (const bool is_in_cap : {true, false})
    {
      cap[0] = is_in_cap;
      EXPECT_EQ(surface.annuli(vertex, cap, poles).lower, 0);
      EXPECT_EQ(surface.annuli.around_spread_source(cap, poles).lower, 0);
    }
  }
}

// What bounds a disk around a place on a torus is not known, and one pole is no plane.
TEST(Potential_annuli, have_no_upper_bound_with_handles_or_one_pole)
{
  for (const Triangle_soup& soup : {soups::torus(30, 15, 3, 1), soups::icosphere(3)})
  {
    Surface surface(soup);
    const auto [lower, upper] = surface.annuli(0, nearest_vertices(surface.mesh, 0, 5),
                                               {{surface.mesh.number_of_vertices() - 1}});
    EXPECT_GT(lower, 0);
    EXPECT_EQ(upper, infinity);
  }
}

} // namespace test_potential_annuli
