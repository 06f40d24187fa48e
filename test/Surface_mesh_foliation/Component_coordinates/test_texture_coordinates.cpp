// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Charts side by side in the unit square.

#include "include/each_foliation.h"
#include "include/conformal_tori.h"
#include "include/example_systems.h"
#include "generators/Random.h"
#include "include/uv_mesh.h"

#include <CGAL/Surface_mesh_foliation/Component_coordinates.h>
#include <CGAL/Surface_mesh_foliation/internal/Component_coordinates/Texture_layout.h>
#include <CGAL/Surface_mesh_foliation/internal/Component_coordinates/pack_boxes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace test_texture_coordinates {

namespace {

using smf_test::Each_foliation;
using smf_test::Example;
using smf_test::Mesh;
using smf_test::size_of;
using smf_test::Uv;
using smf_test::Uv_mesh;
namespace SMF = CGAL::Surface_mesh_foliation;

using Foliation = SMF::Measured_foliation<Mesh>;
using Coordinates = SMF::Component_coordinates<Mesh>;

class Texture_of_example : public Each_foliation
{};

INSTANTIATE_TEST_SUITE_P(Examples,
                         Texture_of_example,
                         ::testing::ValuesIn(smf_test::all_example_systems()),
                         smf_test::name_of_example);

// whether boxes do not even touch
bool are_apart(const SMF::Texture_chart& a, const SMF::Texture_chart& b, double gap)
{
  bool result = false;
  for (std::size_t i : {0, 1})
    result |= a.upper[i] + gap < b.lower[i] || b.upper[i] + gap < a.lower[i];
  return result;
}

} // namespace

TEST_P(Texture_of_example, charts_lie_side_by_side_in_the_unit_square)
{
  const Coordinates coordinates(foliation);
  const double gap = 1. / 400;
  for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
  {
    const SMF::Texture_chart chart = coordinates.texture_chart(a);
    for (std::size_t i : {0, 1})
    {
      EXPECT_GT(chart.scale[i], 0) << "nothing is turned over";
      EXPECT_GE(chart.lower[i], gap);
      EXPECT_LT(chart.lower[i], chart.upper[i]);
      EXPECT_LE(chart.upper[i], 1 - gap);
    }
    for (std::size_t b = 0; b < a; ++b)
      EXPECT_TRUE(are_apart(chart, coordinates.texture_chart(b), gap)) << a << ' ' << b;

    // the chart fills its box
    Mesh mesh_of_chart;
    coordinates.chart(a, mesh_of_chart);
    Uv lower = {1, 1}, upper = {0, 0};
    for (const auto v : vertices(mesh_of_chart))
    {
      const Uv texture = chart({mesh_of_chart.point(v).x(), mesh_of_chart.point(v).y()});
      for (std::size_t i : {0, 1})
      {
        lower[i] = std::min(lower[i], texture[i]);
        upper[i] = std::max(upper[i], texture[i]);
      }
    }
    for (std::size_t i : {0, 1})
    {
      EXPECT_NEAR(lower[i], chart.lower[i], 1e-12);
      EXPECT_NEAR(upper[i], chart.upper[i], 1e-12);
    }
  }
  EXPECT_THROW(coordinates.texture_chart(system.number_of_arcs()),
               SMF::Invalid_parameter_exception);
}

// The chart has the area of the component, and corners get the image of u and v.
TEST_P(Texture_of_example, texture_coordinates_are_to_scale)
{
  const Coordinates coordinates(foliation);
  const Uv_mesh uv_mesh(coordinates);
  Mesh output;
  using Point_2 = smf_test::Kernel::Point_2;
  const auto texture = output.add_property_map<Mesh::Halfedge_index, Point_2>("h:texture").first;
  coordinates.texture_mesh(output, texture);
  ASSERT_EQ(num_faces(output), num_faces(uv_mesh.mesh));
  std::vector<double> area(system.number_of_arcs(), 0);
  for (const auto f : faces(output))
  {
    const auto h = halfedge(f, output), g = next(h, output), i = next(g, output);
    if (!uv_mesh.has_coordinates(f))
    {
      EXPECT_TRUE(std::isnan(texture[h].x()));
      continue;
    }
    const SMF::Texture_chart chart = coordinates.texture_chart(uv_mesh.component[f]);
    for (const auto corner : {h, g, i})
    {
      const Uv expected = chart(uv_mesh.uv[corner]);
      EXPECT_EQ(texture[corner], Point_2(expected[0], expected[1]));
    }
    EXPECT_EQ(CGAL::orientation(texture[h], texture[g], texture[i]), CGAL::LEFT_TURN);
    area[uv_mesh.component[f]] +=
      std::sqrt(CGAL::squared_area(output.point(target(h, output)), output.point(target(g, output)),
                                   output.point(target(i, output))));
  }
  for (std::size_t a = 0; a < area.size(); ++a)
  {
    const SMF::Texture_chart chart = coordinates.texture_chart(a);
    const double stretch =
      chart.scale[0] * chart.scale[1] * coordinates.texture_size() * coordinates.texture_size();
    EXPECT_NEAR(stretch * size_of(foliation, a), area[a], 1e-12 * area[a]);
  }
}

// Weights and heights change measures, but neither the shape of a chart nor its size.
TEST(Texture, of_a_thin_torus_has_its_lengths_whatever_the_weights)
{
  const double large_radius = 10, small_radius = 1, pi = std::acos(-1.);
  const std::size_t n = 32;
  const smf_test::soups::Torus_of_revolution torus(large_radius, small_radius, 0);
  const std::size_t m = torus.number_of_rows(n);
  const Mesh mesh = smf_test::to_mesh(torus.soup(m, n));
  // sides of the rectangle of the same area that the torus can be mapped to conformally
  const double area = 4 * pi * pi * large_radius * small_radius;
  const double tube = std::sqrt(area * torus.ratio()), axis = std::sqrt(area / torus.ratio());
  EXPECT_NEAR(tube, 2 * pi * small_radius, 0.01 * tube);
  EXPECT_NEAR(axis, 2 * pi * large_radius, 0.01 * axis);
  for (const bool is_meridian : {true, false})
    for (const double height : {1e-3, 1., 50.})
    {
      const SMF::Loop_system<Mesh> system(
        mesh, smf_test::poles_and_loops(
                {{smf_test::Item::CYCLE,
                  is_meridian ? smf_test::meridian(0, n) : smf_test::longitude(0, m, n), height}},
                mesh));
      const auto expect_lengths = [&](const Foliation& foliation) {
        const Coordinates coordinates(foliation);
        const SMF::Texture_chart chart = coordinates.texture_chart(0);
        const double side = coordinates.texture_size();
        const double around = foliation.flux(0) * chart.scale[0] * side;
        const double along = height * chart.scale[1] * side;
        EXPECT_NEAR(around, is_meridian ? tube : axis, 0.02 * around);
        EXPECT_NEAR(along, is_meridian ? axis : tube, 0.02 * along);
        EXPECT_NEAR(chart.upper[1] - chart.lower[1], along / side, 1e-12);
      };
      using SMF::parameters::weights;
      expect_lengths(SMF::harmonic_foliation(system));
      expect_lengths(SMF::harmonic_foliation(system, weights(SMF::Cotangent_weights())));
      expect_lengths(SMF::harmonic_foliation(
        system, weights(CGAL::Constant_property_map<Mesh::Edge_index, double>(1000))));
    }
}

// With cotangent weights the Dirichlet energy is height times circumference, so that the chart has
// the modulus that the foliation tells.
TEST(Texture, has_the_modulus_with_cotangent_weights)
{
  using smf_test::soups::icosphere;
  const auto sphere = icosphere(4);
  for (const Example& example :
       {Example{"sphere", sphere,
                smf_test::pole_items({smf_test::extreme_vertex(sphere, {0, 0, 1}),
                                      smf_test::extreme_vertex(sphere, {1, 0, -1})})},
        Example{"three poles", sphere,
                smf_test::pole_items({smf_test::extreme_vertex(sphere, {0, 0, 1}),
                                      smf_test::extreme_vertex(sphere, {1, 0, 0}),
                                      smf_test::extreme_vertex(sphere, {0, 1, -1})})}})
  {
    const Mesh mesh = smf_test::to_mesh(example.soup);
    const SMF::Loop_system<Mesh> system(mesh, smf_test::poles_and_loops(example.items, mesh));
    const Foliation foliation =
      SMF::harmonic_foliation(system, SMF::parameters::weights(SMF::Cotangent_weights()));
    const Coordinates coordinates(foliation);
    for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
    {
      const SMF::Texture_chart chart = coordinates.texture_chart(a);
      EXPECT_NEAR(chart.scale[0] / chart.scale[1], 1, 0.02) << example.name;
    }
  }
}

// ===  Boxes in a square

TEST(Boxes, are_packed_without_overlap)
{
  smf_test::Random random(7);
  for (std::size_t number : {1, 2, 3, 10, 100})
    for (const double slimness : {1., 30.})
    {
      std::vector<std::array<double, 2>> sizes;
      double area = 0, largest = 0;
      for (std::size_t i = 0; i < number; ++i)
      {
        sizes.push_back({random.between(0.1, 1) * slimness, random.between(0.01, 1) / slimness});
        if (i % 2 == 1)
          std::swap(sizes[i][0], sizes[i][1]);
        area += sizes[i][0] * sizes[i][1];
        largest = std::max({largest, sizes[i][0], sizes[i][1]});
      }
      const SMF::internal::Packed_boxes packed = SMF::internal::pack_boxes(sizes);
      ASSERT_EQ(packed.corners.size(), number);
      EXPECT_LE(packed.side, 3.2 * std::max(largest, std::sqrt(area)));
      const double gap = packed.side / 410;
      for (std::size_t i = 0; i < number; ++i)
        for (std::size_t k : {0, 1})
        {
          EXPECT_GE(packed.corners[i][k], gap);
          EXPECT_LE(packed.corners[i][k] + sizes[i][k], packed.side - gap);
        }
      for (std::size_t i = 0; i < number; ++i)
        for (std::size_t j = 0; j < i; ++j)
        {
          bool is_apart = false;
          for (std::size_t k : {0, 1})
            is_apart |= packed.corners[i][k] + sizes[i][k] + gap < packed.corners[j][k] ||
                        packed.corners[j][k] + sizes[j][k] + gap < packed.corners[i][k];
          EXPECT_TRUE(is_apart) << number << ' ' << slimness << ' ' << i << ' ' << j;
        }
    }
}

} // namespace test_texture_coordinates
