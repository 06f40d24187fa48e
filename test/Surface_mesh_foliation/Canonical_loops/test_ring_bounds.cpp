// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Bounds for the moduli of loops on spheres, beside the moduli themselves.

#include "generators/genus_soups.h"
#include "generators/meshes.h"
#include "generators/revolution.h"
#include "include/flat_meshes.h"

#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Class_moduli.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Flat_loop_hierarchy.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Ring_bounds.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Vertex_potentials.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Geodesic_distances.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace test_ring_bounds {

namespace {

namespace SI = CGAL::Surface_mesh_foliation::internal;
using namespace smf_test;

struct Surface
{
  Surface(const Triangle_soup& soup, std::vector<SI::Pole> vertices)
    : mesh(flat_mesh(soup)),
      poles(std::move(vertices)),
      moduli(mesh, SI::edge_lengths(mesh), poles),
      hierarchy(mesh, SI::edge_lengths(mesh), poles),
      bounds(moduli.mesh(), moduli.weights())
  {}

  double bound(const SI::Flat_loop& loop) { return bounds(SI::poles_beside(mesh, poles, loop)); }

  const SI::Flat_mesh mesh;
  const std::vector<SI::Pole> poles;
  const SI::Class_moduli moduli;
  const SI::Flat_loop_hierarchy hierarchy;
  SI::Ring_bounds bounds;
};

std::vector<SI::Pole> random_vertices(const Triangle_soup& soup, std::size_t number, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<SI::Pole> result;
  while (result.size() < number)
  {
    const SI::Pole pole = {static_cast<int>(random() % soup.points.size())};
    if (std::find(result.begin(), result.end(), pole) == result.end())
      result.push_back(pole);
  }
  return result;
}

// the vertex nearest to some angle on a great circle along edges
int vertex_at(const Triangle_soup& icosphere, double angle)
{
  int result = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t v = 0; v < icosphere.points.size(); ++v)
  {
    const auto& p = icosphere.points[v];
    const double distance = std::hypot(p[0] - std::cos(angle), p[1] - std::sin(angle), p[2]);
    if (std::abs(p[2]) < 1e-9 && distance < least)
    {
      least = distance;
      result = static_cast<int>(v);
    }
  }
  return result;
}

double distance(const Triangle_soup& soup, int u, int v)
{
  const auto &p = soup.points[u], &q = soup.points[v];
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

} // namespace

// What flows out of a vertex is its source, and flows into the last one.
TEST(Vertex_potentials, have_the_flux)
{
  const SI::Flat_mesh mesh = flat_mesh(soups::icosphere(2));
  const int last = mesh.number_of_vertices() - 1;
  std::vector<double> weights;
  for (int e = 0; e < mesh.number_of_edges(); ++e)
    weights.push_back(1 + e % 5);
  SI::Vertex_potentials potentials(mesh, weights);
  for (const int source : {0, 7, last})
  {
    const Eigen::VectorXd u = potentials.of_source(source);
    EXPECT_EQ(u, potentials.of_kept_source(source));
    EXPECT_EQ(u[last], 0);
    for (int v = 0; v <= last; ++v)
    {
      double flux = 0;
      for (const int h : mesh.ring(v))
        flux += weights[SI::edge_of(h)] * (u[v] - u[mesh.target(h)]);
      EXPECT_NEAR(flux, (v == source ? 1 : 0) - (v == last ? 1 : 0), 1e-12);
    }
  }
}

// Where the ray begins at 1, the ring is symmetric; and the rings of d and 1 / d are those of one
// quadrilateral and its conjugate.
TEST(Ring_bounds, know_the_modulus_of_teichmueller_s_ring)
{
  EXPECT_NEAR(SI::modulus_of_teichmueller_ring(1), 0.5, 1e-15);
  for (const double d : {1e-6, 0.01, 0.3, 2., 50., 1e5})
  {
    EXPECT_NEAR(SI::modulus_of_teichmueller_ring(d) * SI::modulus_of_teichmueller_ring(1 / d), 0.25,
                1e-12);
    EXPECT_LE(SI::modulus_of_teichmueller_ring(d), std::log(16 * d + 8) / (2 * std::acos(-1.)));
  }
  EXPECT_NEAR(SI::modulus_of_teichmueller_ring(1e5), std::log(16e5 + 8) / (2 * std::acos(-1.)),
              1e-9);
  EXPECT_LT(SI::modulus_of_teichmueller_ring(0), 1e-9);
}

// Four poles on a circle are the ends of the segment and of the ray, so that the bound is reached.
TEST(Ring_bounds, are_reached_on_a_round_sphere)
{
  const Triangle_soup soup = soups::icosphere(5);
  for (const double angle : {0.25, 0.5, 0.7})
  {
    std::array<int, 4> v;
    for (int i = 0; i < 4; ++i)
      v[i] = vertex_at(soup, (i < 2 ? 0 : std::acos(-1.)) + (i % 2 == 0 ? angle : -angle));
    Surface surface(soup, {{v[0]}, {v[1]}, {v[2]}, {v[3]}});
    ASSERT_EQ(surface.hierarchy.loops().size(), 1u);
    const SI::Loop_class& found = surface.hierarchy.loops()[0];
    const double ratio = distance(soup, v[0], v[3]) * distance(soup, v[1], v[2]) /
                         (distance(soup, v[0], v[1]) * distance(soup, v[2], v[3]));
    const double exact = SI::modulus_of_teichmueller_ring(ratio);
    EXPECT_NEAR(surface.bound(found.loop), exact, 0.005 * exact) << "angle " << angle;
    EXPECT_NEAR(found.modulus, exact, 0.02 * exact) << "angle " << angle;
    EXPECT_LT(found.modulus, exact) << "angle " << angle;
  }
}

TEST(Ring_bounds, are_above_all_moduli)
{
  std::size_t number_of_loops = 0;
  double largest_difference = 0;
  for (const Triangle_soup& soup :
       {soups::icosphere(4), soups::limbed_sphere(5, 4), soups::capsule(2, 24).first})
    for (unsigned number = 4; number < 11; number += 3)
    {
      Surface surface(soup, random_vertices(soup, number, number));
      for (const SI::Loop_class& found : surface.hierarchy.loops())
      {
        const double bound = surface.bound(found.loop);
        EXPECT_LT(found.modulus, bound + 0.01) << number << " poles";
        largest_difference = (std::max)(largest_difference, bound - found.modulus);
        ++number_of_loops;
      }
    }
  EXPECT_EQ(number_of_loops, 36u);
  EXPECT_LT(largest_difference, 1) << "they say something";
}

// Loops with smaller moduli are not looked at, and change nothing for the others.
TEST(Ring_bounds, change_no_loop_above_the_least_modulus)
{
  constexpr double least = 0.5;
  std::size_t number_of_loops = 0, number_left_out = 0;
  for (const Triangle_soup& soup : {soups::limbed_sphere(5, 4), soups::capsule(2, 24).first})
    for (unsigned number = 5; number < 12; number += 2)
    {
      const Surface surface(soup, random_vertices(soup, number, number));
      const SI::Flat_loop_hierarchy bounded(surface.mesh, SI::edge_lengths(surface.mesh),
                                            surface.poles, SI::poll_nobody, least);
      EXPECT_EQ(bounded.loops().size(), surface.hierarchy.loops().size());
      for (std::size_t i = 0; i < surface.hierarchy.loops().size(); ++i)
      {
        const double modulus = surface.hierarchy.loops()[i].modulus;
        number_left_out += bounded.loops()[i].modulus == 0 ? 1 : 0;
        if (modulus < least)
          EXPECT_LT(bounded.loops()[i].modulus, least);
        else
          EXPECT_NEAR(bounded.loops()[i].modulus, modulus, 1e-6);
        number_of_loops += modulus >= least ? 1 : 0;
      }
    }
  EXPECT_GT(number_of_loops, 5u);
  EXPECT_GT(number_left_out, 10u);
}

// A disk around one pole may be as small as it likes.
TEST(Ring_bounds, need_two_poles_on_either_side)
{
  const Triangle_soup soup = soups::icosphere(3);
  const SI::Flat_mesh mesh = flat_mesh(soup);
  SI::Ring_bounds bounds(mesh, std::vector<double>(mesh.number_of_edges(), 1));
  EXPECT_EQ(bounds({{{0, 1}, {2}}}), std::numeric_limits<double>::infinity());
  EXPECT_EQ(bounds({{{0}, {1, 2, 3}}}), std::numeric_limits<double>::infinity());
  EXPECT_LT(bounds({{{0, 1}, {2, 3}}}), 2);
}

} // namespace test_ring_bounds
