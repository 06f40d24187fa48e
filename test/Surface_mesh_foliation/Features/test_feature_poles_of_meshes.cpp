// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/feature_places.h"
#include "include/feature_poles_of.h"
#include "generators/meshes.h"

#include <CGAL/Surface_mesh_foliation/IO/read_triangle_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace test_feature_poles_of_meshes {

// Poles of real meshes, found with default parameters.

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;

using smf_test::Mesh;
using smf_test::poles_of;
using Indices = std::vector<std::size_t>;

// the diagonal of the bounding box
double diameter(const Mesh& mesh)
{
  CGAL::Bbox_3 box;
  for (const auto v : vertices(mesh))
    box += mesh.point(v).bbox();
  return std::hypot(box.x_span(), box.y_span(), box.z_span());
}

// the pole nearest to p
Mesh::Point nearest_pole(const Mesh& mesh, const Indices& poles, const Mesh::Point& p)
{
  const auto squared_distance = [&](std::size_t pole) {
    return CGAL::squared_distance(mesh.point(smf_test::vertex(pole)), p);
  };
  return mesh.point(smf_test::vertex(
    *std::min_element(poles.begin(), poles.end(), [&](std::size_t one, std::size_t other) {
      return squared_distance(one) < squared_distance(other);
    })));
}

double distance_from_poles(const Mesh& mesh, const Indices& poles, const Mesh::Point& p)
{
  if (poles.empty())
    return std::numeric_limits<double>::infinity();
  return std::sqrt(CGAL::squared_distance(nearest_pole(mesh, poles, p), p)) / diameter(mesh);
}

class Feature_poles_of_meshes : public ::testing::TestWithParam<smf_test::Shape>
{};

TEST_P(Feature_poles_of_meshes, are_where_a_person_would_put_them)
{
  const smf_test::Shape& shape = GetParam();
  if (shape.folder.empty())
    GTEST_SKIP() << "no folder with " << shape.file;
  Mesh mesh;
  SMF::read_triangle_mesh(shape.path(), mesh);
  const auto poles = poles_of(mesh, CGAL::parameters::default_values());
  EXPECT_GE(poles.size(), shape.places.size());
  EXPECT_LE(poles.size(), shape.most);
  for (const smf_test::Place& place : shape.places)
    EXPECT_LT(distance_from_poles(mesh, poles, mesh.point(smf_test::vertex(place.vertex))),
              place.radius)
      << place.name;
}

INSTANTIATE_TEST_SUITE_P(Meshes,
                         Feature_poles_of_meshes,
                         ::testing::ValuesIn(smf_test::shapes()),
                         [](const auto& one) { return one.param.file; });

// Two bodies with the same connectivity: the same vertex is the same place.
TEST(Feature_poles_of_poses, correspond_on_two_bodies)
{
  if (smf_test::shared_folder().empty())
    GTEST_SKIP() << "no shared meshes";
  Mesh man, woman;
  SMF::read_triangle_mesh(smf_test::shared_folder() + "/human_man_6890.off", man);
  SMF::read_triangle_mesh(smf_test::shared_folder() + "/human_woman_6890.off", woman);
  const auto poles = poles_of(man, CGAL::parameters::default_values()),
             others = poles_of(woman, CGAL::parameters::default_values());
  for (const std::size_t pole : poles)
    EXPECT_LT(distance_from_poles(woman, others, woman.point(smf_test::vertex(pole))), 0.05);
  for (const std::size_t pole : others)
    EXPECT_LT(distance_from_poles(man, poles, man.point(smf_test::vertex(pole))), 0.05);
}

// Two scorpions that differ in the mesh and in how they hold their tail: the poles of claws and
// legs are the same points of space, up to a translation.
TEST(Feature_poles_of_poses, correspond_on_two_scorpions)
{
  if (smf_test::shared_folder().empty())
    GTEST_SKIP() << "no shared meshes";
  const std::vector<smf_test::Shape> scorpions = {smf_test::shape("scorpion_6315"),
                                                  smf_test::shape("scorpion_49997")};
  std::vector<std::vector<Mesh::Point>> ends(2); // of all limbs but the tail
  double size = 0;
  for (std::size_t i : {0, 1})
  {
    Mesh mesh;
    SMF::read_triangle_mesh(scorpions[i].path(), mesh);
    size = diameter(mesh);
    const auto poles = poles_of(mesh, CGAL::parameters::default_values());
    ASSERT_FALSE(poles.empty());
    for (const smf_test::Place& place : scorpions[i].places)
      if (place.name != "tail")
        ends[i].push_back(nearest_pole(mesh, poles, mesh.point(smf_test::vertex(place.vertex))));
  }
  ASSERT_EQ(ends[0].size(), 10u);
  ASSERT_EQ(ends[1].size(), 10u);
  CGAL::Vector_3<smf_test::Kernel> translation(0, 0, 0);
  for (std::size_t j = 0; j < 10; ++j)
    translation = translation + (ends[1][j] - ends[0][j]) / 10;
  for (std::size_t j = 0; j < 10; ++j)
    EXPECT_LT(std::sqrt((ends[0][j] + translation - ends[1][j]).squared_length()), 0.05 * size)
      << j;
}

// Noise of a tenth of an edge length moves no pole far.
TEST(Feature_poles_of_poses, of_a_noisy_body_are_the_same)
{
  if (smf_test::shared_folder().empty())
    GTEST_SKIP() << "no shared meshes";
  Mesh man;
  SMF::read_triangle_mesh(smf_test::shared_folder() + "/human_man_6890.off", man);
  const Mesh noisy = smf_test::noisy(man, 0.1, 1);
  const auto poles = poles_of(noisy, CGAL::parameters::default_values());
  EXPECT_EQ(poles.size(), smf_test::places_of_body.size());
  for (const smf_test::Place& place : smf_test::places_of_body)
    EXPECT_LT(distance_from_poles(man, poles, man.point(smf_test::vertex(place.vertex))), 0.05)
      << place.name;
}

} // namespace

} // namespace test_feature_poles_of_meshes
