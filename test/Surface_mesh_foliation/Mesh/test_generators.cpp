// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "generators/meshes.h"
#include "include/test_models.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace test_generators {

namespace {

using CGAL::Surface_mesh_foliation::check_triangle_soup;
using CGAL::Surface_mesh_foliation::Problem;
using smf_test::Triangle_soup;

using Polyhedron = smf_test::Polyhedron_model<smf_test::Kernel>;
using Linear_cell_complex = smf_test::Linear_cell_complex_model<smf_test::Kernel>;

std::string problems_of(const Triangle_soup& soup)
{
  std::string messages;
  for (const Problem& problem : check_triangle_soup(soup))
    messages += problem.message + "\n";
  return messages;
}

void expect_valid(const Triangle_soup& soup, std::size_t genus)
{
  EXPECT_EQ(problems_of(soup), "");
  EXPECT_EQ(smf_test::soups::genus(soup), genus);
}

bool have_same_faces(const Triangle_soup& a, const Triangle_soup& b)
{
  return a.triangles == b.triangles;
}

double volume(const Triangle_soup& soup)
{
  using namespace smf_test::soups;
  double total = 0;
  for (const auto& [a, b, c] : soup.triangles)
    total += dot(soup.points[a], cross(soup.points[b], soup.points[c])) / 6;
  return total;
}

TEST(Test_soups, spheres_are_valid_and_oriented_outwards)
{
  for (const Triangle_soup& soup :
       {smf_test::soups::tetrahedron(), smf_test::soups::octahedron(),
        smf_test::soups::icosahedron(), smf_test::soups::icosphere(0),
        smf_test::soups::icosphere(3), smf_test::soups::limbed_sphere(6, 4)})
  {
    expect_valid(soup, 0);
    EXPECT_GT(volume(soup), 0);
  }
}

TEST(Test_soups, icosphere_has_the_right_size)
{
  const Triangle_soup soup = smf_test::soups::icosphere(3);
  EXPECT_EQ(soup.triangles.size(), 1280u);
  EXPECT_EQ(soup.points.size(), 642u);
  EXPECT_NEAR(volume(soup), 4 * smf_test::soups::pi / 3, 0.05);
}

TEST(Test_soups, tori_are_valid)
{
  expect_valid(smf_test::soups::torus(3, 3, 2, 1), 1);
  expect_valid(smf_test::soups::torus(24, 12, 2, 0.5), 1);
  EXPECT_GT(volume(smf_test::soups::torus(24, 12, 2, 0.5)), 0);
}

TEST(Test_soups, limb_tips_are_the_far_ends)
{
  const Triangle_soup soup = smf_test::soups::limbed_sphere(5, 4);
  const std::vector<std::size_t> tips = smf_test::soups::limb_tips(5, 4);
  ASSERT_EQ(tips.size(), 5u);
  for (const std::size_t tip : tips)
    EXPECT_GT(smf_test::soups::distance(soup.points[tip], {0, 0, 0}), 2.5);
}

TEST(Test_soups, plates_have_the_right_genus)
{
  for (std::size_t genus = 0; genus <= 12; ++genus)
    for (std::size_t resolution = 1; resolution <= 3; ++resolution)
    {
      SCOPED_TRACE(std::to_string(genus) + " holes, resolution " + std::to_string(resolution));
      const Triangle_soup soup = smf_test::soups::genus_surface(genus, resolution);
      expect_valid(soup, genus);
      EXPECT_GT(volume(soup), 0);
    }
}

TEST(Test_soups, surfaces_with_handles_have_the_right_genus)
{
  for (std::size_t genus = 0; genus <= 12; ++genus)
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
    {
      SCOPED_TRACE("genus " + std::to_string(genus) + ", seed " + std::to_string(seed));
      expect_valid(smf_test::soups::handle_surface(genus, seed), genus);
    }
  expect_valid(smf_test::soups::with_handles(smf_test::soups::torus(12, 8, 2, 1), 2, 7), 3);
}

TEST(Test_soups, changes_keep_the_surface_valid)
{
  const Triangle_soup soup = smf_test::soups::genus_surface(2, 2);
  expect_valid(smf_test::soups::noisy(soup, 0.3, 5), 2);
  expect_valid(smf_test::soups::smoothed(soup, 4), 2);
  expect_valid(smf_test::soups::midpoint_subdivided(soup), 2);
  EXPECT_EQ(smf_test::soups::midpoint_subdivided(soup).triangles.size(), 4 * soup.triangles.size());
}

TEST(Test_soups, noise_has_the_given_size)
{
  const Triangle_soup soup = smf_test::soups::icosphere(2);
  const Triangle_soup noisy = smf_test::soups::noisy(soup, 0.25, 5);
  const double bound = 0.25 * smf_test::soups::mean_edge_length(soup);
  double largest = 0;
  for (std::size_t vertex = 0; vertex < soup.points.size(); ++vertex)
    for (std::size_t axis = 0; axis < 3; ++axis)
      largest = std::max(largest, std::abs(noisy.points[vertex][axis] - soup.points[vertex][axis]));
  EXPECT_LE(largest, bound);
  EXPECT_GE(largest, 0.9 * bound);
}

TEST(Test_soups, same_seed_same_soup)
{
  const Triangle_soup soup = smf_test::soups::handle_surface(3, 11);
  EXPECT_EQ(soup.points, smf_test::soups::handle_surface(3, 11).points);
  EXPECT_NE(soup.points, smf_test::soups::handle_surface(3, 12).points);
}

template <class TriangleMesh>
class Test_meshes : public ::testing::Test
{};

using Models = ::testing::Types<smf_test::Mesh, Polyhedron, Linear_cell_complex>;
TYPED_TEST_SUITE(Test_meshes, Models);

TYPED_TEST(Test_meshes, meshes_are_the_soups_they_are_made_of)
{
  const Triangle_soup soup = smf_test::soups::genus_surface(4, 2);
  const auto mesh = smf_test::genus_surface<TypeParam>(4, 2);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  EXPECT_TRUE(CGAL::is_closed(mesh));
  EXPECT_TRUE(CGAL::is_triangle_mesh(mesh));
  EXPECT_EQ(smf_test::genus(mesh), 4u);
  const Triangle_soup back = smf_test::to_soup(mesh);
  EXPECT_EQ(back.points, soup.points);
  EXPECT_TRUE(have_same_faces(back, soup));
}

TYPED_TEST(Test_meshes, flips_keep_a_simplicial_complex)
{
  const auto mesh = smf_test::genus_surface<TypeParam>(2, 1);
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
  {
    const Triangle_soup flipped = smf_test::to_soup(smf_test::flip_random_edges(mesh, 3, seed));
    expect_valid(flipped, 2);
    EXPECT_FALSE(have_same_faces(flipped, smf_test::to_soup(mesh)));
  }
  // nothing can be flipped here
  const auto tetrahedron = smf_test::tetrahedron<TypeParam>();
  EXPECT_TRUE(have_same_faces(smf_test::to_soup(smf_test::flip_random_edges(tetrahedron, 3, 1)),
                              smf_test::to_soup(tetrahedron)));
}

TYPED_TEST(Test_meshes, relabeled_vertices_go_where_new_labels_says)
{
  const auto mesh = smf_test::genus_surface<TypeParam>(1, 1);
  const Triangle_soup soup = smf_test::to_soup(mesh);
  const Triangle_soup relabeled = smf_test::to_soup(smf_test::relabeled(mesh, 9));
  expect_valid(relabeled, 1);
  EXPECT_NE(relabeled.points, soup.points);
  const std::vector<std::size_t> labels = smf_test::new_labels(soup.points.size(), 9);
  for (std::size_t vertex = 0; vertex < soup.points.size(); ++vertex)
    EXPECT_EQ(relabeled.points[labels[vertex]], soup.points[vertex]);
}

TYPED_TEST(Test_meshes, all_functions_take_all_models)
{
  EXPECT_EQ(smf_test::genus(smf_test::octahedron<TypeParam>()), 0u);
  EXPECT_EQ(smf_test::genus(smf_test::icosphere<TypeParam>(1)), 0u);
  EXPECT_EQ(smf_test::genus(smf_test::torus<TypeParam>(6, 5, 2, 1)), 1u);
  EXPECT_EQ(smf_test::genus(smf_test::limbed_sphere<TypeParam>(3, 2)), 0u);
  EXPECT_EQ(smf_test::genus(smf_test::handle_surface<TypeParam>(2)), 2u);
  const auto torus = smf_test::torus<TypeParam>(6, 5, 2, 1);
  EXPECT_EQ(smf_test::genus(smf_test::midpoint_subdivided(torus)), 1u);
  EXPECT_EQ(smf_test::genus(smf_test::noisy(torus, 0.1, 1)), 1u);
  EXPECT_EQ(smf_test::genus(smf_test::with_handles(torus, 1, 1)), 2u);
  EXPECT_NEAR(smf_test::mean_edge_length(smf_test::octahedron<TypeParam>()), std::sqrt(2.0), 1e-12);
}

TEST(Test_mesh_functions, surface_mesh_with_removed_elements_gives_the_soup_of_the_rest)
{
  smf_test::Mesh mesh = smf_test::octahedron();
  CGAL::Euler::remove_center_vertex(halfedge(*vertices(mesh).begin(), mesh), mesh);
  const Triangle_soup soup = smf_test::to_soup(mesh);
  EXPECT_EQ(soup.points.size(), 5u);
}

TEST(Test_mesh_functions, shared_meshes_are_listed)
{
  EXPECT_TRUE(smf_test::all_shared_meshes("").empty());
  const std::string folder = SMF_SHARED_DIR;
  if (folder.empty())
    GTEST_SKIP() << "SMF_SHARED_DIR is not set";
  EXPECT_FALSE(smf_test::all_shared_meshes(folder + "/meshes").empty());
}

} // namespace

} // namespace test_generators
