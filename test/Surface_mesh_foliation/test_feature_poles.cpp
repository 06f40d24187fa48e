// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/feature_places.h"
#include "include/flat_meshes.h"
#include "include/test_meshes.h"
#include "include/test_models.h"
#include "include/test_soups.h"

#include <CGAL/Surface_mesh_foliation/IO/read_triangle_mesh.h>
#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/feature_poles.h>
#include <CGAL/Surface_mesh_foliation/internal/Average_geodesic_distances.h>
#include <CGAL/Surface_mesh_foliation/internal/Laplacian.h>
#include <CGAL/Surface_mesh_foliation/internal/Laplacian_spectrum.h>
#include <CGAL/Surface_mesh_foliation/internal/Surface_mesh_copy.h>
#include <CGAL/Surface_mesh_foliation/internal/checked_flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/decimated_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/heat_kernel_signature.h>
#include <CGAL/Surface_mesh_foliation/internal/require_parameter.h>
#include <CGAL/Surface_mesh_foliation/loops.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

// Poles found on shapes made here and, at the end, on real meshes.

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
namespace np = CGAL::Surface_mesh_foliation::parameters;

using smf_test::Mesh;
using smf_test::Triangle_soup;
using smf_test::soups::Point;
using Indices = std::vector<std::size_t>;

constexpr std::size_t number_of_limbs = 6;
constexpr int level = 4;

Triangle_soup star()
{
  return smf_test::soups::limbed_sphere(number_of_limbs, level);
}

// the positions in `vertices(mesh)` of the poles, in the order in which they are put out
template <class TriangleMesh, class NamedParameters>
Indices poles_of(const TriangleMesh& mesh, const NamedParameters& parameters)
{
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> poles;
  SMF::detect_feature_poles(mesh, std::back_inserter(poles), parameters);
  Indices result;
  for (const auto v : poles)
    result.push_back(SMF::internal::position_of_vertex(v, mesh));
  return result;
}

template <class Detector = SMF::Heat_kernel_signature>
Indices poles_of(const Triangle_soup& soup)
{
  return poles_of(smf_test::to_mesh(soup), np::pole_detector(Detector()));
}

Indices sorted(Indices indices)
{
  std::sort(indices.begin(), indices.end());
  return indices;
}

double distance(const smf_test::soups::Point& p, const smf_test::soups::Point& q)
{
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

// Each expected vertex has just one pole within 5% of the diameter, and there are no others.
void expect_near(const Triangle_soup& soup, const Indices& poles, const Indices& expected)
{
  double diameter = 0;
  for (const auto& p : soup.points)
    diameter = std::max(diameter, distance(p, soup.points[expected[0]]));
  EXPECT_EQ(poles.size(), expected.size());
  for (const std::size_t v : expected)
    EXPECT_EQ(std::count_if(poles.begin(), poles.end(),
                            [&](std::size_t pole) {
                              return distance(soup.points[pole], soup.points[v]) < 0.05 * diameter;
                            }),
              1)
      << "vertex " << v;
}

template <class Detector>
class Detectors : public ::testing::Test
{};

using All_detectors = ::testing::Types<SMF::Heat_kernel_signature, SMF::Average_geodesic_distance>;
TYPED_TEST_SUITE(Detectors, All_detectors);

TYPED_TEST(Detectors, find_the_limbs_of_a_star)
{
  for (std::size_t limbs : {2, 3, 6})
  {
    SCOPED_TRACE(limbs);
    const Triangle_soup soup = smf_test::soups::limbed_sphere(limbs, level);
    expect_near(soup, poles_of<TypeParam>(soup), smf_test::soups::limb_tips(limbs, level));
  }
}

TYPED_TEST(Detectors, do_not_care_for_position_orientation_and_scale)
{
  const Triangle_soup soup = star();
  for (double scale : {1e-150, 1e150})
  {
    Triangle_soup moved = soup;
    for (auto& p : moved.points)
      p = {scale * (0.36 * p[0] + 0.48 * p[1] - 0.8 * p[2] + 7),
           scale * (-0.8 * p[0] + 0.6 * p[1] - 3),
           scale * (0.48 * p[0] + 0.64 * p[1] + 0.6 * p[2])};
    EXPECT_EQ(sorted(poles_of<TypeParam>(moved)), sorted(poles_of<TypeParam>(soup))) << scale;
  }
}

TYPED_TEST(Detectors, do_not_care_for_the_order_of_vertices)
{
  const Triangle_soup soup = star();
  const Indices poles = sorted(poles_of<TypeParam>(soup));
  for (std::uint64_t seed : {1, 2})
  {
    const Indices labels = smf_test::new_labels(soup.points.size(), seed);
    Indices expected;
    for (const std::size_t pole : poles)
      expected.push_back(labels[pole]);
    EXPECT_EQ(sorted(poles_of<TypeParam>(smf_test::soups::relabelled(soup, labels, seed + 1))),
              sorted(expected))
      << seed;
  }
}

TYPED_TEST(Detectors, do_not_care_for_noise)
{
  const Triangle_soup soup = star();
  for (double amplitude : {0.01, 0.25})
    for (std::uint64_t seed : {1, 2})
    {
      SCOPED_TRACE(amplitude);
      const Triangle_soup noisy = smf_test::soups::noisy(soup, amplitude, seed);
      expect_near(noisy, poles_of<TypeParam>(noisy),
                  smf_test::soups::limb_tips(number_of_limbs, level));
    }
}

TYPED_TEST(Detectors, are_deterministic)
{
  EXPECT_EQ(poles_of<TypeParam>(star()), poles_of<TypeParam>(star()));
}

TYPED_TEST(Detectors, find_the_same_on_a_decimated_copy)
{
  for (int fine : {level, level + 1})
  {
    const Triangle_soup soup = smf_test::soups::limbed_sphere(number_of_limbs, fine);
    const Indices poles =
      poles_of(smf_test::to_mesh(soup),
               np::combine(np::pole_detector(TypeParam()), np::decimation_threshold(1000)));
    expect_near(soup, poles, smf_test::soups::limb_tips(number_of_limbs, fine));
  }
}

TYPED_TEST(Detectors, find_nothing_on_a_sphere)
{
  EXPECT_EQ(poles_of<TypeParam>(smf_test::soups::icosphere(4)), Indices());
}

TYPED_TEST(Detectors, accept_the_smallest_mesh)
{
  Triangle_soup soup = smf_test::soups::tetrahedron();
  soup.points[3] = {-9, -9, 9};
  const Indices poles = poles_of<TypeParam>(soup);
  ASSERT_FALSE(poles.empty());
  EXPECT_EQ(poles[0], 3u);
}

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
  Triangle_soup soup = star();
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
  for (const auto& soup : {star(), smf_test::soups::torus(60, 40, 2, 1)})
  {
    const auto fine = smf_test::flat_mesh(soup);
    const auto coarse = SMF::internal::decimated_mesh(fine, 1000);
    EXPECT_LT(coarse.number_of_vertices(), 1010);
    EXPECT_GT(coarse.number_of_vertices(), 900);
    EXPECT_EQ(coarse.genus(), fine.genus());
  }
}

// three types of meshes, the same vertices
template <class TriangleMesh>
class Feature_poles_of : public ::testing::Test
{};

using Models = ::testing::Types<smf_test::Polyhedron_model<smf_test::Kernel>,
                                smf_test::Linear_cell_complex_model<smf_test::Kernel>>;
TYPED_TEST_SUITE(Feature_poles_of, Models);

TYPED_TEST(Feature_poles_of, are_those_of_a_surface_mesh)
{
  const auto parameters = CGAL::parameters::default_values();
  EXPECT_EQ(poles_of(smf_test::to_mesh<TypeParam>(star()), parameters),
            poles_of(smf_test::to_mesh(star()), parameters));
}

TEST(Feature_poles, are_accepted_as_poles_of_a_loop_system)
{
  const Mesh mesh = smf_test::to_mesh(star());
  SMF::Poles_and_loops<Mesh> input;
  for (const std::size_t pole : poles_of<>(star()))
    input.add_pole(smf_test::vertex(pole));
  const SMF::Loop_system<Mesh> system(mesh, input);
  EXPECT_EQ(system.number_of_arcs(), number_of_limbs);
  EXPECT_EQ(system.number_of_nodes(), number_of_limbs + 1);
}

TEST(Feature_poles, come_from_the_given_points)
{
  const Mesh mesh = smf_test::icosphere(level);
  const Mesh other = smf_test::to_mesh(star());
  EXPECT_EQ(poles_of(mesh, CGAL::parameters::vertex_point_map(other.points())), poles_of<>(star()));
}

TEST(Feature_poles, are_at_most_as_many_as_asked_for)
{
  const Mesh mesh = smf_test::to_mesh(star());
  const Indices all = poles_of(mesh, np::persistence(1.));
  ASSERT_GE(all.size(), number_of_limbs);
  for (std::size_t number = 0; number <= all.size(); ++number)
    EXPECT_EQ(poles_of(mesh, np::combine(np::number_of_poles(number), np::persistence(1.))),
              Indices(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(number)));
}

TEST(Feature_poles, get_fewer_with_more_persistence)
{
  const Mesh mesh = smf_test::to_mesh(star());
  Indices poles = poles_of(mesh, np::persistence(1.));
  for (double persistence : {1.15, 3., 6., 20., 1000.})
  {
    const Indices fewer = poles_of(mesh, np::persistence(persistence));
    ASSERT_LE(fewer.size(), poles.size());
    poles.resize(fewer.size());
    EXPECT_EQ(fewer, poles);
  }
  EXPECT_EQ(poles, Indices());
}

// After a long time only what is farthest from the rest is warmer.
TEST(Feature_poles, get_fewer_with_more_time)
{
  const Mesh mesh = smf_test::to_mesh(smf_test::soups::limbed_sphere(9, level));
  EXPECT_EQ(poles_of(mesh, np::diffusion_time(0.05)).size(), 9u);
  EXPECT_LT(poles_of(mesh, np::diffusion_time(5.)).size(), 9u);
}

TEST(Feature_poles, are_about_the_same_with_fewer_eigenfunctions_or_samples)
{
  const Indices tips = smf_test::soups::limb_tips(number_of_limbs, level);
  const Mesh mesh = smf_test::to_mesh(star());
  for (int number : {20, 40, 100})
    expect_near(star(), poles_of(mesh, np::number_of_eigenpairs(number)), tips);
  for (int number : {16, 64})
    expect_near(star(),
                poles_of(mesh, np::combine(np::number_of_samples(number),
                                           np::pole_detector(SMF::Average_geodesic_distance()))),
                tips);
}

template <class NamedParameters>
void expect_parameter_refused(const NamedParameters& parameters)
{
  const Mesh mesh = smf_test::octahedron();
  try
  {
    poles_of(mesh, parameters);
    ADD_FAILURE() << "accepted";
  }
  catch (const SMF::Invalid_parameter_exception& exception)
  {
    EXPECT_EQ(exception.problem().kind, SMF::Problem_kind::INVALID_PARAMETER);
  }
}

TEST(Feature_poles, refuse_parameters_out_of_range)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  expect_parameter_refused(np::number_of_poles(-1));
  expect_parameter_refused(np::persistence(0.99));
  expect_parameter_refused(np::persistence(nan));
  expect_parameter_refused(np::diffusion_time(0.));
  expect_parameter_refused(np::diffusion_time(infinity));
  expect_parameter_refused(np::diffusion_time(nan));
  expect_parameter_refused(np::number_of_eigenpairs(1));
  expect_parameter_refused(np::number_of_samples(0));
  expect_parameter_refused(np::decimation_threshold(999));
}

TEST(Feature_poles, refuse_a_mesh_as_loop_systems_do)
{
  Mesh open = smf_test::icosphere(1);
  CGAL::Euler::remove_face(halfedge(*faces(open).begin(), open), open);
  Mesh empty;
  Mesh two = smf_test::octahedron();
  two += smf_test::tetrahedron();
  for (const Mesh* mesh : {&open, &empty, &two})
  {
    const std::vector<SMF::Problem> expected = SMF::validate(*mesh, SMF::Poles_and_loops<Mesh>());
    ASSERT_FALSE(expected.empty());
    try
    {
      poles_of(*mesh, CGAL::parameters::default_values());
      ADD_FAILURE() << "accepted";
    }
    catch (const SMF::Invalid_mesh_exception& exception)
    {
      EXPECT_EQ(exception.problem().kind, expected[0].kind);
      EXPECT_STREQ(exception.what(), expected[0].message.c_str());
    }
  }
}

// ===  Real meshes, with default parameters

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
                         [](const auto& info) { return info.param.file; });

// Two bodies with the same connectivity: the same vertex is the same place.
TEST(Feature_poles, correspond_on_two_bodies)
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
TEST(Feature_poles, correspond_on_two_scorpions)
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
TEST(Feature_poles, of_a_noisy_body_are_the_same)
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
