// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/flat_meshes.h"
#include "generators/soups.h"

#include <CGAL/Surface_mesh_foliation/internal/Features/Average_geodesic_distances.h>
#include <CGAL/Surface_mesh_foliation/internal/Features/Laplacian.h>
#include <CGAL/Surface_mesh_foliation/internal/Features/Laplacian_spectrum.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Surface_mesh_copy.h>
#include <CGAL/Surface_mesh_foliation/internal/Features/decimated_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Features/heat_kernel_signature.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace test_feature_functions {

// The functions whose maxima are poles, and what they are computed from.

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;

using smf_test::Triangle_soup;
using smf_test::soups::Point;

// l (l + 1), 2 l + 1 times each, on a sphere of area 4 pi
TEST(Laplacian_spectrum, is_known_on_a_sphere)
{
  const double pi = 3.14159265358979;
  const auto mesh = smf_test::flat_mesh(smf_test::soups::icosphere(4));
  const SMF::internal::Spectrum spectrum = SMF::internal::laplacian_spectrum(mesh, 16);
  int i = 0;
  for (int l : {0, 1, 2, 3})
    for (int m = -l; m <= l; ++m, ++i)
      EXPECT_NEAR(spectrum.values[i], 4 * pi * l * (l + 1), 0.03 * 4 * pi * l * (l + 1) + 1e-6);
  const Eigen::VectorXd mass = SMF::internal::Laplacian(mesh).mass();
  EXPECT_NEAR(mass.sum(), 1, 1e-12);
  const Eigen::MatrixXd products =
    spectrum.functions.transpose() * mass.asDiagonal() * spectrum.functions;
  EXPECT_LT((products - Eigen::MatrixXd::Identity(16, 16)).cwiseAbs().maxCoeff(), 1e-6);
}

// The rows of its matrix add up to zero, slivers or not, and nothing is negative.
TEST(Laplacian, is_positive_semidefinite_on_slivers)
{
  Triangle_soup soup = smf_test::soups::icosphere(2);
  for (Point& p : soup.points)
    p[2] *= 1e-9;
  const auto mesh = smf_test::flat_mesh(soup);
  const SMF::internal::Laplacian laplacian(mesh);
  const Eigen::SparseMatrix<double> lower = laplacian.shifted(mesh, 0);
  const Eigen::MatrixXd matrix = Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
  const double largest = matrix.cwiseAbs().maxCoeff();
  EXPECT_LT(matrix.rowwise().sum().cwiseAbs().maxCoeff(), 1e-12 * largest);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  EXPECT_GT(solver.eigenvalues()[0], -1e-12 * largest);
}

TEST(Heat_kernel_signature, is_the_same_all_over_a_sphere)
{
  const auto mesh = smf_test::flat_mesh(smf_test::soups::icosphere(3));
  const std::vector<double> heat = SMF::internal::heat_kernel_signature(mesh, 1, 49);
  // sum of (2 l + 1) exp(-l (l + 1) / 2)
  double expected = 0;
  for (int l = 0; l < 7; ++l)
    expected += (2 * l + 1) * std::exp(-l * (l + 1) / 2.);
  for (const double h : heat)
    EXPECT_NEAR(h, expected, 0.02 * expected);
}

TEST(Average_geodesic_distances, are_a_quarter_of_the_equator_on_a_sphere)
{
  const auto mesh = smf_test::flat_mesh(smf_test::soups::icosphere(4));
  const double radius = SMF::internal::points_of_unit_size(mesh)[0][0] / mesh.point(0)[0];
  for (const double d : SMF::internal::Average_geodesic_distances(mesh, 64).average())
    EXPECT_NEAR(d, radius * 3.14159265 / 2, 0.05 * radius);
}

TEST(Surface_mesh_copy, is_the_mesh_in_unit_size)
{
  Triangle_soup soup = smf_test::soups::limbed_sphere(6, 4);
  for (Point& p : soup.points)
    p = {1e200 * p[0], 1e200 * p[1] + 3e200, 1e200 * p[2]};
  const auto mesh = smf_test::flat_mesh(soup);
  const SMF::internal::Surface_mesh_copy copy = SMF::internal::surface_mesh_copy(mesh);
  EXPECT_EQ(num_vertices(copy), soup.points.size());
  EXPECT_EQ(num_faces(copy), soup.triangles.size());
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(copy);
  const double size = std::max({box.x_span(), box.y_span(), box.z_span()});
  EXPECT_GE(size, 1);
  EXPECT_LE(size, 2);
}

TEST(Decimated_mesh, is_a_smaller_mesh_of_the_same_genus)
{
  using namespace smf_test::soups;
  for (const Triangle_soup& soup : {limbed_sphere(6, 4), torus(60, 40, 2, 1)})
  {
    const auto fine = smf_test::flat_mesh(soup);
    const auto coarse = SMF::internal::decimated_mesh(fine, 1000);
    EXPECT_LT(coarse.number_of_vertices(), 1010);
    EXPECT_GT(coarse.number_of_vertices(), 900);
    EXPECT_EQ(coarse.genus(), fine.genus());
  }
}

} // namespace

} // namespace test_feature_functions
