// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/feature_poles_of.h"
#include "generators/meshes.h"
#include "include/test_models.h"
#include "generators/soups.h"

#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/feature_poles.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/require_parameter.h>
#include <CGAL/Surface_mesh_foliation/loops.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <vector>

namespace test_feature_poles {

// Poles found on shapes made here.

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
namespace np = CGAL::Surface_mesh_foliation::parameters;

using smf_test::Mesh;
using smf_test::poles_of;
using smf_test::Triangle_soup;
using smf_test::soups::Point;
using Indices = std::vector<std::size_t>;

constexpr std::size_t number_of_limbs = 6;
constexpr int level = 4;

Triangle_soup star()
{
  return smf_test::soups::limbed_sphere(number_of_limbs, level);
}

template <class Detector = SMF::Average_geodesic_distance>
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
    EXPECT_EQ(sorted(poles_of<TypeParam>(smf_test::soups::relabeled(soup, labels, seed + 1))),
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

TEST(Feature_poles, get_fewer_with_more_significance)
{
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Triangle_soup& soup : {star(), smf_test::soups::noisy(star(), 0.2, 1)})
  {
    const Mesh mesh = smf_test::to_mesh(soup);
    std::size_t most = poles_of(mesh, np::min_significance(-infinity)).size();
    EXPECT_GE(most, number_of_limbs);
    for (const double significance : {-0.5, 0., SMF::default_min_significance, 3.})
    {
      const std::size_t number = poles_of(mesh, np::min_significance(significance)).size();
      EXPECT_LE(number, most);
      most = number;
    }
    EXPECT_EQ(most, 2u); // those that a foliation needs
    EXPECT_EQ(poles_of(mesh, CGAL::parameters::default_values()).size(), number_of_limbs);
  }
}

TEST(Feature_poles, tell_their_significance)
{
  const Mesh mesh = smf_test::to_mesh(star());
  std::vector<double> significances;
  const Indices poles =
    poles_of(mesh, np::significance_output_iterator(std::back_inserter(significances)));
  ASSERT_EQ(significances.size(), poles.size());
  for (std::size_t i = 0; i < poles.size(); ++i)
    EXPECT_EQ(std::isinf(significances[i]), i < 2);
  for (const double significance : significances)
    EXPECT_GE(significance, SMF::default_min_significance);
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
  const auto heat = np::pole_detector(SMF::Heat_kernel_signature());
  EXPECT_EQ(poles_of(mesh, heat.diffusion_time(0.05)).size(), 9u);
  EXPECT_LT(poles_of(mesh, heat.diffusion_time(5.)).size(), 9u);
}

TEST(Feature_poles, are_about_the_same_with_fewer_eigenfunctions_or_samples)
{
  const Indices tips = smf_test::soups::limb_tips(number_of_limbs, level);
  const Mesh mesh = smf_test::to_mesh(star());
  for (int number : {20, 40, 100})
    expect_near(
      star(),
      poles_of(mesh, np::pole_detector(SMF::Heat_kernel_signature()).number_of_eigenpairs(number)),
      tips);
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
  expect_parameter_refused(np::min_significance(nan));
  expect_parameter_refused(np::diffusion_time(0.));
  expect_parameter_refused(np::diffusion_time(infinity));
  expect_parameter_refused(np::diffusion_time(nan));
  expect_parameter_refused(np::number_of_eigenpairs(1));
  expect_parameter_refused(np::number_of_samples(0));
  expect_parameter_refused(np::decimation_threshold(999));
}

TEST(Feature_poles, refuse_a_mesh_as_loop_systems_do)
{
  Mesh empty;
  Mesh two = smf_test::octahedron();
  two += smf_test::tetrahedron();
  for (const Mesh* mesh : {&empty, &two})
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

} // namespace

} // namespace test_feature_poles
