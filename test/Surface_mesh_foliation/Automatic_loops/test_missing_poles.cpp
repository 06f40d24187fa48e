// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Poles of surfaces without limbs.

#include "generators/meshes.h"
#include "generators/openings.h"

#include <CGAL/Surface_mesh_foliation/add_missing_poles.h>
#include <CGAL/Surface_mesh_foliation/automatic_loops.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/openings.h>

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <map>

namespace test_missing_poles {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
using namespace smf_test;
using Input = SMF::Poles_and_loops<Mesh>;

double distance(const Mesh& mesh, const Input& input, std::size_t a, std::size_t b)
{
  return std::sqrt(CGAL::squared_distance(mesh.point(input.entries()[a].pole[0]),
                                          mesh.point(input.entries()[b].pole[0])));
}

} // namespace

TEST(Missing_poles, are_the_ends_of_a_diameter)
{
  for (const Mesh& mesh : {icosphere(3), tetrahedron(), octahedron(), limbed_sphere(5, 3)})
  {
    Input input;
    EXPECT_EQ(SMF::add_missing_poles(mesh, input), 2u);
    EXPECT_TRUE(
      SMF::harmonic_foliation(SMF::Loop_system<Mesh>(mesh, input)).statistics().is_certified);
  }
  const Mesh sphere = icosphere(4);
  Input input;
  SMF::add_missing_poles(sphere, input);
  EXPECT_GT(distance(sphere, input, 0, 1), 1.95);
}

TEST(Missing_poles, are_far_from_the_one_that_is_given)
{
  const Mesh sphere = icosphere(4);
  for (const Mesh::size_type v : {0u, 100u, 1000u})
  {
    Input input;
    input.add_pole(Mesh::Vertex_index(v));
    EXPECT_EQ(SMF::add_missing_poles(sphere, input), 1u);
    EXPECT_GT(distance(sphere, input, 0, 1), 1.95);
  }
  // a bowl, whose opening is an end
  const Mesh bowl = to_open_mesh(soups::part_below(soups::icosphere(4), 2, 0.3));
  Input input;
  SMF::add_border_poles(bowl, input);
  EXPECT_EQ(SMF::add_missing_poles(bowl, input), 1u);
  EXPECT_LT(bowl.point(input.entries()[1].pole[0]).z(), -0.95);
}

// The cap of an opening has no value of its own.
TEST(Proposed_loops, of_a_function_on_a_mesh_with_an_opening)
{
  const Mesh bowl = to_open_mesh(soups::part_below(soups::icosphere(4), 2, 0.3));
  std::map<Mesh::Vertex_index, double> height;
  for (const auto v : vertices(bowl))
    height[v] = bowl.point(v).z();
  Input input;
  SMF::add_border_poles(bowl, input);
  const boost::associative_property_map<std::map<Mesh::Vertex_index, double>> function(height);
  EXPECT_EQ(SMF::propose_loops(bowl, input, SMF::parameters::vertex_scalar_map(function)), 0u);
  SMF::add_missing_poles(bowl, input);
  EXPECT_EQ(SMF::propose_loops(bowl, input, SMF::parameters::vertex_scalar_map(function)), 0u);
}

TEST(Missing_poles, are_not_added_where_none_is_missing)
{
  const Mesh sphere = icosphere(2);
  Input two;
  two.add_pole(Mesh::Vertex_index(0));
  two.add_pole(Mesh::Vertex_index(1));
  EXPECT_EQ(SMF::add_missing_poles(sphere, two), 0u);
  for (std::size_t genus : {1u, 2u, 5u})
  {
    Input none;
    EXPECT_EQ(SMF::add_missing_poles(genus_surface(genus), none), 0u);
    EXPECT_EQ(none.size(), 0u);
  }
  // a triangle, whose vertices lie on its border
  Triangle_soup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  soup.triangles = {{0, 1, 2}};
  const Mesh triangle = to_open_mesh(soup);
  Input border;
  SMF::add_border_poles(triangle, border);
  EXPECT_EQ(SMF::add_missing_poles(triangle, border), 0u);
}

} // namespace test_missing_poles
