// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Lengths of the edges of a collapsed mesh along the surface that it stands for.

#include "generators/meshes.h"
#include "generators/revolution.h"
#include "include/flat_meshes.h"

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Edge_collapses.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Geodesic_distances.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Lengths_along_surface.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Mesh_clusters.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace test_lengths_along_surface {

namespace {

namespace SI = CGAL::Surface_mesh_foliation::internal;
using namespace smf_test;

struct Collapsed
{
  Collapsed(const Triangle_soup& soup, int number_of_vertices)
    : fine(flat_mesh(soup)),
      clusters(fine,
               SI::Edge_collapses::with_even_lengths(
                 fine, std::vector<bool>(soup.points.size(), false), number_of_vertices, {})),
      lengths(SI::Lengths_along_surface(fine, clusters).lengths()),
      chords(SI::edge_lengths(mesh()))
  {}

  const SI::Flat_mesh& mesh() const { return clusters.mesh(); }

  double chord(int e) const
  {
    const int h = SI::halfedge_of(e);
    return SI::distance(mesh().point(mesh().source(h)), mesh().point(mesh().target(h)));
  }

  double length(int e) const { return chord(e) * lengths[e] / chords[e]; }

  SI::Flat_mesh fine;
  SI::Mesh_clusters clusters;
  std::vector<double> lengths, chords;
};

void expect_triangles(const Collapsed& collapsed)
{
  for (int f = 0; f < collapsed.mesh().number_of_faces(); ++f)
  {
    std::vector<double> sides;
    for (int h : collapsed.mesh().halfedges(f))
      sides.push_back(collapsed.lengths[SI::edge_of(h)]);
    std::sort(sides.begin(), sides.end());
    EXPECT_GT(sides[0] + sides[1], sides[2]);
  }
}

} // namespace

TEST(Lengths_along_surface, are_those_of_arcs_on_a_sphere)
{
  for (const int number : {1000, 200, 50})
  {
    const Collapsed sphere(soups::icosphere(5), number);
    double error = 0, error_of_chords = 0;
    for (int e = 0; e < sphere.mesh().number_of_edges(); ++e)
    {
      const double arc = 2 * std::asin(sphere.chord(e) / 2);
      error = std::max(error, std::abs(sphere.length(e) / arc - 1));
      error_of_chords = std::max(error_of_chords, 1 - sphere.chord(e) / arc);
    }
    EXPECT_LT(error, 0.001) << number;
    EXPECT_GT(error_of_chords, 5 * error) << number;
    expect_triangles(sphere);
  }
}

// A cylinder can be unrolled.
TEST(Lengths_along_surface, are_those_of_helices_on_a_cylinder)
{
  constexpr double length = 20;
  const Collapsed tube(soups::capsule(length, 48).first, 200);
  double sum = 0, sum_of_chords = 0, expected = 0;
  int number = 0;
  for (int e = 0; e < tube.mesh().number_of_edges(); ++e)
  {
    const int h = SI::halfedge_of(e);
    const SI::Point& p = tube.mesh().point(tube.mesh().source(h));
    const SI::Point& q = tube.mesh().point(tube.mesh().target(h));
    const double turn = std::atan2(p[1] * q[2] - p[2] * q[1], p[1] * q[1] + p[2] * q[2]);
    if (std::min(p[0], q[0]) < 0 || std::max(p[0], q[0]) > length || std::abs(turn) > 2)
      continue; // in a cap, or almost half around, where the plane may run along the tube
    const double helix = std::hypot(turn, p[0] - q[0]);
    EXPECT_NEAR(tube.length(e), helix, 0.05 * helix);
    sum += tube.length(e);
    sum_of_chords += tube.chord(e);
    expected += helix;
    ++number;
  }
  EXPECT_GT(number, 200);
  EXPECT_LT(sum_of_chords, 0.98 * expected);
  EXPECT_LT(std::abs(sum - expected), 0.1 * (expected - sum_of_chords));
  expect_triangles(tube);
}

TEST(Lengths_along_surface, are_never_shorter_than_chords_and_make_triangles)
{
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
  {
    const Collapsed surface(to_soup(noisy(genus_surface(seed % 4, 6, seed), 0.3, seed)), 200);
    double longest = 1;
    for (int e = 0; e < surface.mesh().number_of_edges(); ++e)
    {
      EXPECT_GE(surface.lengths[e], surface.chords[e] * (1 - 1e-12));
      longest = std::max(longest, surface.lengths[e] / surface.chords[e]);
    }
    EXPECT_GT(longest, 1.02) << seed;
    expect_triangles(surface);
  }
}

// Around the rim of a sheet the way may be much longer than the chord through it, and no section by
// a plane tells its length.
TEST(Lengths_along_surface, lead_around_the_rims_of_thin_sheets)
{
  int number = 0, number_around = 0;
  for (const double thickness : {0.01, 0.03, 0.1})
    for (const int size : {500, 1000, 2000})
    {
      Triangle_soup soup = soups::icosphere(5);
      for (soups::Point& p : soup.points)
        p[2] *= thickness;
      const Collapsed sheet(soup, size);
      const std::vector<double> fine_lengths = SI::edge_lengths(sheet.fine);
      const double unit = SI::distance(sheet.fine.point(sheet.fine.source(0)),
                                       sheet.fine.point(sheet.fine.target(0))) /
                          fine_lengths[0];
      for (int e = 0; e < sheet.mesh().number_of_edges(); ++e)
      {
        const int h = SI::halfedge_of(e);
        const int from = sheet.clusters.representative(sheet.mesh().source(h));
        const int to = sheet.clusters.representative(sheet.mesh().target(h));
        const double way =
          unit * SI::Geodesic_distances(sheet.fine, fine_lengths, {from}, [to](int v) {
                   return v != to;
                 }).distances()[to];
        EXPECT_LT(sheet.length(e), 1.1 * way);
        if (way < 1.6 * sheet.chord(e))
          continue;
        ++number;
        number_around += sheet.length(e) > 0.9 * way ? 1 : 0;
      }
      expect_triangles(sheet);
    }
  EXPECT_GT(number, 500);
  EXPECT_GT(number_around, 0.4 * number); // the others made no triangles
}

TEST(Lengths_along_surface, are_those_of_edges_where_nothing_was_collapsed)
{
  for (const Triangle_soup& soup :
       {soups::torus(12, 6, 3, 1), soups::icosphere(1), soups::tetrahedron()})
  {
    const Collapsed surface(soup, static_cast<int>(soup.points.size()));
    EXPECT_EQ(surface.lengths, surface.chords);
  }
}

} // namespace test_lengths_along_surface
