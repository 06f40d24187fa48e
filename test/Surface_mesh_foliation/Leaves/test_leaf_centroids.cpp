// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Centroids of leaves and the embedding made of them, compared with leaves that are traced and with
// what is known of octahedra.

#include <CGAL/Surface_mesh_foliation/internal/Leaves/Arc_embedding.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/Leaf_centroids.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Centroid.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/Refined_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/essential_leaf.h>

#include "include/flat_states.h"
#include "include/flat_systems.h"
#include "include/refined_meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace test_leaf_centroids {

using namespace smf_test;
using namespace CGAL::Surface_mesh_foliation::internal;

namespace {

Centroid traced_centroid(const Foliation_state& state, int arc, double level)
{
  const std::vector<Leaf_crossing> leaf = essential_leaf(state, arc, level);
  Centroid result;
  for (std::size_t i = 0; i < leaf.size(); ++i)
    result.add(point_of_crossing(state, leaf[i], level),
               point_of_crossing(state, leaf[(i + 1) % leaf.size()], level));
  return result;
}

void expect_centroids_are_those_of_traced_leaves(const Foliation_state& state,
                                                 const std::vector<double>& shares)
{
  std::vector<std::vector<double>> levels(state.system().number_of_arcs());
  for (int a = 0; a < state.system().number_of_arcs(); ++a)
    for (double share : shares)
      levels[a].push_back(share * state.system().height(a));
  const Refined_mesh mesh = refined(state);
  const auto centroids = Leaf_centroids(mesh).of_levels(levels);
  ASSERT_EQ(centroids.size(), levels.size());
  for (std::size_t a = 0; a < levels.size(); ++a)
    for (std::size_t i = 0; i < levels[a].size(); ++i)
    {
      const Centroid expected = traced_centroid(state, static_cast<int>(a), levels[a][i]);
      ASSERT_FALSE(centroids[a][i].is_empty());
      EXPECT_NEAR(centroids[a][i].length(), expected.length(), 1e-13);
      expect_near(centroids[a][i].point(), expected.point());
    }
}

} // namespace

// ===  Leaf_centroids.h

TEST(Centroid, is_weighted_by_length)
{
  Centroid centroid;
  EXPECT_TRUE(centroid.is_empty());
  EXPECT_EQ(centroid.length(), 0);
  centroid.add({1, 2, 3}, {1, 2, 3});
  EXPECT_FALSE(centroid.is_empty());
  EXPECT_EQ(centroid.point(), (Point{1, 2, 3}));
  centroid.add({3, 2, 3}, {3, 2, 3});
  EXPECT_EQ(centroid.point(), (Point{2, 2, 3})); // the mean of points
  centroid.add({0, 0, 0}, {1, 0, 0});
  EXPECT_EQ(centroid.point(), (Point{0.5, 0, 0})); // points have no weight beside segments
  centroid.add({1, 0, 0}, {1, 3, 0});
  EXPECT_EQ(centroid.length(), 4);
  expect_near(centroid.point(), {0.25 * 0.5 + 0.75 * 1, 0.75 * 1.5, 0});
}

// of polygons: the square with corners at distance 2 from the center, its sides in two parts each
TEST(Centroid, has_a_radius)
{
  Centroid square;
  EXPECT_EQ(square.radius(), 0);
  const std::vector<Point> corners = {{7, 1, 5}, {5, 3, 5}, {3, 1, 5}, {5, -1, 5}};
  for (int i : {0, 2, 1, 3}) // the order does not matter
  {
    const Point &p = corners[i], &q = corners[(i + 1) % 4];
    const Point r = {0.25 * p[0] + 0.75 * q[0], 0.25 * p[1] + 0.75 * q[1], 5};
    square.add(p, r);
    square.add(r, q);
  }
  // a side has the distance sqrt(2) from the center and the length 2 sqrt(2): the mean of 2 + s^2
  // for s between -sqrt(2) and sqrt(2)
  EXPECT_NEAR(square.radius(), std::sqrt(2 + 2. / 3), 1e-15);
  expect_near(square.point(), {5, 1, 5});
  Centroid point;
  point.add({1, 2, 3}, {1, 2, 3});
  point.add({3, 2, 3}, {3, 2, 3});
  EXPECT_EQ(point.radius(), 0);
}

TEST(Centroid, overflows_only_with_its_coordinates)
{
  const double huge = 0.25 * std::numeric_limits<double>::max();
  Centroid centroid;
  centroid.add({huge, -huge, 0}, {huge, huge, 0});
  centroid.add({huge, huge, 0}, {huge, huge, 0});
  EXPECT_EQ(centroid.point(), (Point{huge, 0, 0}));
  EXPECT_NEAR(centroid.radius() / huge, 1 / std::sqrt(3), 1e-15);
  Centroid tiny;
  const double denormal = std::numeric_limits<double>::denorm_min();
  tiny.add({0, 0, 0}, {4 * denormal, 0, 0});
  EXPECT_EQ(tiny.point(), (Point{2 * denormal, 0, 0}));
}

TEST(Leaf_centroids, are_those_of_traced_leaves)
{
  const std::vector<double> shares = {0.001, 0.25, 0.3, 0.5, 0.75, 0.9}; // some hit vertices
  for (const std::vector<double>& t : {std::vector<double>{0.5, 1, 1, 1.5},
                                       {1, 1, 1, 1},
                                       {0.1, 0.2, 1.9, 0.7},
                                       {0.5, 1.5, 0.5, 1.5}})
  {
    const Equator e(t);
    expect_centroids_are_those_of_traced_leaves(e.state, shares);
  }
  for (const Flat_loop_system& system : {octahedron_with_three_poles(), torus_with_one_loop()})
  {
    const Foliation_state state(system, unit_weights(system));
    expect_centroids_are_those_of_traced_leaves(state, shares);
  }
}

TEST(Leaf_centroids, of_a_level_through_vertices_only)
{
  const Equator e({1, 1, 1, 1});
  const Refined_mesh mesh = refined(e.state);
  const Centroid equator_leaf = Leaf_centroids(mesh).of_levels({{1}})[0][0];
  EXPECT_NEAR(equator_leaf.length(), 4 * std::sqrt(2.), 1e-14);
  expect_near(equator_leaf.point(), {0, 0, 0});
}

TEST(Leaf_centroids, of_nodes)
{
  const Flat_loop_system system = octahedron_with_three_poles();
  const Foliation_state state(system, unit_weights(system));
  const Refined_mesh mesh = refined(state);
  std::vector<Point> points;
  for (const Centroid& node : Leaf_centroids(mesh).of_nodes(4))
    points.push_back(node.point());
  for (int p : {0, 1, 2})
    EXPECT_EQ(points[p], system.mesh.point(2 * p));
  // By symmetry on the diagonal: three sides of length sqrt 2 with middles at (-1/2, -1/2, 0),
  // three of length sqrt(3/2) from (1/2, 1/2, 0) to (0, 0, -1), three from there to the center.
  const double side = std::sqrt(2.), down = std::sqrt(1.5), up = std::sqrt(1. / 6);
  const double coordinate_sums = side * -1 + down * 0 + up * 1;
  for (double x : points[3])
    EXPECT_NEAR(x, coordinate_sums / 3 / (side + down + up), 1e-14);
}

// ===  Arc_embedding.h

TEST(Arc_embedding, of_the_octahedron_along_its_axis)
{
  const Equator e({1, 1, 1, 1});
  const Refined_mesh mesh = refined(e.state);
  const Arc_embedding embedding(e.state, mesh);
  ASSERT_EQ(embedding.nodes().size(), 2u);
  EXPECT_EQ(embedding.nodes()[0].point(), (Point{0, 0, 1}));
  EXPECT_EQ(embedding.nodes()[1].point(), (Point{0, 0, -1}));
  ASSERT_EQ(embedding.uniform_samples(0).size(), 1u);
  EXPECT_TRUE(embedding.uniform_samples(0)[0].empty());
  const auto uniform = embedding.uniform_samples(3);
  ASSERT_EQ(uniform.size(), 1u);
  ASSERT_EQ(uniform[0].size(), 3u);
  for (int i : {0, 1, 2})
  {
    EXPECT_EQ(uniform[0][i].level, 0.5 * (i + 1));
    expect_near(uniform[0][i].point, {0, 0, 0.5 - 0.5 * i});
    EXPECT_NEAR(uniform[0][i].length, (i == 1 ? 4 : 2) * std::sqrt(2.), 1e-14);
  }
}

TEST(Arc_embedding, even_samples_have_equal_distances_whatever_the_parameters)
{
  // Leaves are squares around the axis, and their height is linear in the level above the equator
  // and below. Half an interval of the 32 that the inverse is interpolated in may be lost there.
  for (double t : {0.05, 0.6, 1., 1.97})
  {
    const Equator e({t, t, t, t});
    const Refined_mesh mesh = refined(e.state);
    const Arc_embedding embedding(e.state, mesh);
    for (int number : {0, 1, 2, 7})
    {
      const auto samples = embedding.even_samples(number);
      ASSERT_EQ(static_cast<int>(samples[0].size()), number);
      for (int i = 0; i < number; ++i)
        expect_near(samples[0][i].point, {0, 0, 1 - 2. * (i + 1) / (number + 1)},
                    t == 1 ? 1e-5 : 0.02);
    }
  }
}

TEST(Arc_embedding, of_arcs_without_vertex)
{
  const Flat_loop_system system = octahedron_with_three_poles();
  const Foliation_state state(system, unit_weights(system));
  const Refined_mesh mesh = refined(state);
  const Arc_embedding embedding(state, mesh);
  const auto samples = embedding.even_samples(3);
  ASSERT_EQ(samples.size(), 3u);
  for (const std::vector<Arc_embedding::Sample>& arc : samples)
  {
    ASSERT_EQ(arc.size(), 3u);
    for (int i : {0, 1, 2}) // leaves shrink to the pole, so their centroids move in proportion
      EXPECT_NEAR(arc[i].level, 0.25 * (i + 1), 1e-5);
  }
}

TEST(Arc_embedding, of_the_smallest_height_has_no_even_samples)
{
  Flat_loop_system system = torus_with_one_loop();
  system.loops[0].height = std::numeric_limits<double>::denorm_min();
  const Foliation_state state(system, unit_weights(system));
  const Refined_mesh mesh = refined(state);
  EXPECT_TRUE(Arc_embedding(state, mesh).even_samples(5)[0].empty());
}

} // namespace test_leaf_centroids
