// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/example_systems.h"
#include "include/tiny_edges.h"

#include <CGAL/Surface_mesh_foliation/edge_weights.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/property_map.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace test_edge_weights {

namespace {

using smf_test::Example;
using smf_test::Item;
using smf_test::Mesh;
using smf_test::Solved_example;
namespace SMF = CGAL::Surface_mesh_foliation;
namespace soups = smf_test::soups;

using System = SMF::Loop_system<Mesh>;
using Weight_map = Mesh::Property_map<Mesh::Edge_index, double>;
using SMF::parameters::weights;

struct Named_soup
{
  std::string name;
  smf_test::Triangle_soup soup;
};

std::vector<Named_soup> soups_to_weigh()
{
  const smf_test::Triangle_soup rough = soups::noisy(soups::genus_surface(2, 2), 0.3, 3);
  return {
    {"icosphere", soups::icosphere(2)},
    {"tetrahedron", soups::tetrahedron()},
    {"torus", soups::torus(12, 9, 3, 1)},
    {"rough plate", rough},
    {"flips", smf_test::to_soup(smf_test::flip_random_edges(smf_test::to_mesh(rough), 0.3, 4))},
    {"handles", soups::handle_surface(3)}};
}

// a mesh with a system, as weights are asked for by system
struct Weighed
{
  explicit Weighed(const smf_test::Triangle_soup& soup)
    : mesh(smf_test::to_mesh(soup)),
      system(mesh, smf_test::poles_and_loops(smf_test::pole_items({0, 1, 2}), mesh)),
      mean_value(mesh.add_property_map<Mesh::Edge_index, double>("e:mv", -1).first),
      cotangent(mesh.add_property_map<Mesh::Edge_index, double>("e:cot", -1).first)
  {
    SMF::edge_weights(system, SMF::Mean_value_weights(), mean_value);
    SMF::edge_weights(system, SMF::Cotangent_weights(), cotangent);
  }

  Mesh mesh;
  System system;
  Weight_map mean_value, cotangent;
};

// ===  Formulas

// the angle of face(h) at its source
double angle(Mesh::Halfedge_index h, const Mesh& mesh)
{
  const Mesh::Point &p = mesh.point(source(h, mesh)), &q = mesh.point(target(h, mesh)),
                    &r = mesh.point(target(next(h, mesh), mesh));
  const auto cross = CGAL::cross_product(q - p, r - p);
  return std::atan2(std::sqrt(cross.squared_length()), CGAL::scalar_product(q - p, r - p));
}

double length(Mesh::Halfedge_index h, const Mesh& mesh)
{
  return std::sqrt(
    CGAL::squared_distance(mesh.point(source(h, mesh)), mesh.point(target(h, mesh))));
}

// half of the sum over both ends
double naive_mean_value(Mesh::Edge_index e, const Mesh& mesh)
{
  double sum = 0;
  for (const auto h : {halfedge(e, mesh), opposite(halfedge(e, mesh), mesh)})
  {
    const double left = angle(h, mesh); // at source(h), on both sides of the edge
    const double right = angle(next(opposite(h, mesh), mesh), mesh);
    sum += (std::tan(left / 2) + std::tan(right / 2)) / length(h, mesh);
  }
  return sum / 2;
}

double naive_cotangent(Mesh::Edge_index e, const Mesh& mesh)
{
  double sum = 0;
  for (const auto h : {halfedge(e, mesh), opposite(halfedge(e, mesh), mesh)})
    sum += 1 / std::tan(angle(prev(h, mesh), mesh)); // opposite to the edge
  return sum / 2;
}

TEST(Edge_weights, agree_with_the_formulas)
{
  for (const Named_soup& named : soups_to_weigh())
  {
    SCOPED_TRACE(named.name);
    const Weighed weighed(named.soup);
    for (const auto e : edges(weighed.mesh))
    {
      const double mean_value = naive_mean_value(e, weighed.mesh);
      EXPECT_NEAR(weighed.mean_value[e], mean_value, 1e-10 * mean_value) << e;
      EXPECT_NEAR(weighed.cotangent[e], naive_cotangent(e, weighed.mesh), 1e-9) << e;
    }
  }
}

TEST(Edge_weights, of_a_regular_tetrahedron)
{
  const Weighed weighed(soups::tetrahedron());
  for (const auto e : edges(weighed.mesh)) // all angles are 60 degrees, all lengths sqrt(8)
  {
    EXPECT_NEAR(weighed.mean_value[e], 2 * std::tan(soups::pi / 6) / std::sqrt(8.), 1e-15);
    EXPECT_NEAR(weighed.cotangent[e], 1 / std::sqrt(3.), 1e-15);
  }
}

TEST(Edge_weights, mean_value_ones_are_positive_whatever_the_mesh)
{
  // slivers: a vertex almost on the edge opposite to it
  smf_test::Triangle_soup slivers = soups::icosphere(1);
  for (const double height : {1e-3, 1e-9, 1e-15})
  {
    const auto& [a, b, c] = slivers.triangles[0];
    const soups::Point middle =
      soups::scaled(soups::sum(slivers.points[a], slivers.points[b]), 0.5);
    slivers.points[c] = soups::sum(soups::scaled(middle, 1 - height), slivers.points[c], height);
    const Weighed weighed(slivers);
    bool has_obtuse_angles = false;
    for (const auto e : edges(weighed.mesh))
    {
      EXPECT_GT(weighed.mean_value[e], 0) << e;
      EXPECT_TRUE(std::isfinite(weighed.mean_value[e])) << e;
      has_obtuse_angles = has_obtuse_angles || weighed.cotangent[e] < 0;
    }
    EXPECT_TRUE(has_obtuse_angles) << "so that the test means something";
  }
}

TEST(Edge_weights, under_motion_and_scale)
{
  for (const Named_soup& named : soups_to_weigh())
    for (const double scale : {1., 0x1p-10, 3e5})
    {
      SCOPED_TRACE(named.name);
      smf_test::Triangle_soup moved = named.soup;
      for (auto& p : moved.points) // turned by 120 degrees about a diagonal, and moved
        p = {scale * (p[1] - 2), scale * (p[2] + 0.5), scale * (p[0] + 1)};
      const Weighed before(named.soup), after(moved);
      for (const auto e : edges(before.mesh))
      {
        EXPECT_NEAR(after.mean_value[e] * scale, before.mean_value[e], 1e-9 * before.mean_value[e]);
        EXPECT_NEAR(after.cotangent[e], before.cotangent[e],
                    1e-9 * (1 + std::abs(before.cotangent[e])));
      }
    }
}

TEST(Edge_weights, and_foliations_of_tiny_and_huge_meshes)
{
  for (const Example& example : {smf_test::dumbbell_example(), smf_test::theta_example()})
  {
    const Solved_example<> reference(example);
    for (const double scale : {1e-200, 1e-100, 1e100, 1e200})
    {
      SCOPED_TRACE(scale);
      Example scaled = example;
      for (auto& p : scaled.soup.points)
        p = soups::scaled(p, scale);
      for (Item& item : scaled.items)
        item.plane[3] *= scale;
      Mesh mesh = smf_test::to_mesh(scaled.soup);
      SMF::Poles_and_loops<Mesh> input; // the same crossings: no section is needed
      for (const auto& entry : reference.input.entries())
        input.add_loop(entry.loop, entry.height);
      const System system(mesh, input);
      const auto foliation = SMF::harmonic_foliation(system);
      EXPECT_TRUE(foliation.statistics().has_converged);
      EXPECT_TRUE(std::isfinite(foliation.statistics().energy));
      for (const auto e : edges(mesh))
        EXPECT_NEAR(foliation.edge_value(e), reference.foliation.edge_value(e), 1e-9) << e;
    }
  }
}

// Of an edge between a vertex, which lies at the origin, and one beside it, on another edge.
double weight_beside_origin(const smf_test::Triangle_soup& soup, double part)
{
  smf_test::Triangle_soup moved = soup;
  for (auto& p : moved.points)
    p = soups::sum(p, soup.points[0], -1);
  Mesh mesh = smf_test::to_mesh(moved);
  const Mesh::Vertex_index origin(0);
  const auto beside = smf_test::add_vertex_beside_target(mesh, halfedge(origin, mesh), part);
  const System system(mesh, smf_test::poles_and_loops(smf_test::pole_items({1, 2, 3}), mesh));
  const Weight_map map = mesh.add_property_map<Mesh::Edge_index, double>("e:mv", -1).first;
  SMF::edge_weights(system, SMF::Mean_value_weights(), map);
  return map[edge(halfedge(origin, beside, mesh).first, mesh)];
}

// Fuzzers found it: vertices so close together have weights beside which rounding swallows others.
TEST(Edge_weights, of_edges_that_are_short_beside_their_faces_grow_no_more)
{
  for (const Named_soup& named : soups_to_weigh())
  {
    SCOPED_TRACE(named.name);
    const double weight = weight_beside_origin(named.soup, 1e-5);
    EXPECT_NEAR(weight_beside_origin(named.soup, 1e-6) / weight, 10, 1e-3);
    EXPECT_NEAR(weight_beside_origin(named.soup, 1e-7) / weight, 100, 1e-2);
    const double largest = weight_beside_origin(named.soup, 1e-10);
    EXPECT_LT(largest, 2000 * weight);
    EXPECT_NEAR(weight_beside_origin(named.soup, 1e-18) / largest, 1, 1e-6);
    EXPECT_NEAR(weight_beside_origin(named.soup, 1e-100) / largest, 1, 1e-6);
  }
}

TEST(Edge_weights, go_into_maps_of_other_numbers)
{
  Weighed weighed(soups::icosphere(2));
  const auto floats = weighed.mesh.add_property_map<Mesh::Edge_index, float>("e:float").first;
  SMF::edge_weights(weighed.system, SMF::Mean_value_weights(), floats);
  for (const auto e : edges(weighed.mesh))
    EXPECT_EQ(floats[e], static_cast<float>(weighed.mean_value[e]));
}

// ===  Weights of the user's

// a property map computed on the fly
struct Length_map
{
  using key_type = Mesh::Edge_index;
  using value_type = double;
  using reference = double;
  using category = boost::readable_property_map_tag;
  const Mesh* mesh;
  friend double get(const Length_map& map, key_type e)
  {
    return length(halfedge(e, *map.mesh), *map.mesh);
  }
};

double energy(const SMF::Measured_foliation<Mesh>& foliation, const Weight_map& weight)
{
  double result = 0;
  for (const auto e : edges(foliation.mesh()))
    result += weight[e] * foliation.edge_value(e) * foliation.edge_value(e);
  return result;
}

TEST(Given_weights, may_come_from_any_readable_map)
{
  Weighed weighed(soups::icosphere(2));
  const auto double_lengths = weighed.mesh.add_property_map<Mesh::Edge_index, double>("e:d").first;
  const auto ones = weighed.mesh.add_property_map<Mesh::Edge_index, int>("e:i", 1).first;
  for (const auto e : edges(weighed.mesh))
    double_lengths[e] = length(halfedge(e, weighed.mesh), weighed.mesh);
  const auto by_length =
    SMF::harmonic_foliation(weighed.system, weights(Length_map{&weighed.mesh}));
  EXPECT_TRUE(by_length.statistics().has_converged);
  EXPECT_EQ(by_length.statistics().energy,
            SMF::harmonic_foliation(weighed.system, weights(double_lengths)).statistics().energy);
  const auto uniform = SMF::harmonic_foliation(
    weighed.system, weights(CGAL::Constant_property_map<Mesh::Edge_index, double>(1)));
  EXPECT_EQ(uniform.statistics().energy,
            SMF::harmonic_foliation(weighed.system, weights(ones)).statistics().energy);
  EXPECT_NE(uniform.statistics().energy, by_length.statistics().energy);
}

// each foliation has the least energy for its own weights
TEST(Given_weights, are_what_the_energy_is_made_of)
{
  Weighed weighed(soups::noisy(soups::icosphere(3), 0.2, 5));
  const Weight_map random = weighed.mesh.add_property_map<Mesh::Edge_index, double>("e:r").first;
  smf_test::Random generator(9);
  for (const auto e : edges(weighed.mesh))
    random[e] = std::exp(generator.between(-3, 3));
  const auto first = SMF::harmonic_foliation(weighed.system);
  const auto second = SMF::harmonic_foliation(weighed.system, weights(random));
  EXPECT_NEAR(first.statistics().energy, energy(first, weighed.mean_value), 1e-9);
  EXPECT_NEAR(second.statistics().energy, energy(second, random), 1e-9 * energy(second, random));
  EXPECT_LT(first.statistics().energy, energy(second, weighed.mean_value));
  EXPECT_LT(second.statistics().energy, energy(first, random));
}

TEST(Given_weights, that_are_not_positive_and_finite_are_refused)
{
  Weighed weighed(soups::icosphere(1));
  for (const double bad :
       {0., -0., -1e-300, -1., std::numeric_limits<double>::quiet_NaN(),
        std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()})
  {
    const Weight_map map = weighed.mesh.add_property_map<Mesh::Edge_index, double>("e:w", 1).first;
    const Mesh::Edge_index e(37);
    map[e] = bad;
    try
    {
      SMF::harmonic_foliation(weighed.system, weights(map));
      ADD_FAILURE() << bad << " is accepted";
    }
    catch (const SMF::Invalid_parameter_exception& exception)
    {
      std::vector<std::size_t> ends = {source(e, weighed.mesh), target(e, weighed.mesh)};
      std::vector<std::size_t> named = exception.problem().vertices;
      EXPECT_EQ(exception.problem().kind, SMF::Problem_kind::INVALID_WEIGHT);
      for (const std::size_t end : ends)
        EXPECT_NE(std::string(exception.what()).find(std::to_string(end)), std::string::npos);
      std::sort(ends.begin(), ends.end());
      std::sort(named.begin(), named.end());
      EXPECT_EQ(named, ends);
    }
    map[e] = 1;
    EXPECT_NO_THROW(SMF::harmonic_foliation(weighed.system, weights(map)));
  }
}

TEST(Given_weights, that_are_not_finite_are_refused_even_if_any_are_allowed)
{
  Weighed weighed(soups::icosphere(1));
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
  {
    const Weight_map map = weighed.mesh.add_property_map<Mesh::Edge_index, double>("e:w", 1).first;
    map[Mesh::Edge_index(5)] = bad;
    try
    {
      SMF::harmonic_foliation(weighed.system, weights(map).allow_any_weights(true));
      ADD_FAILURE();
    }
    catch (const SMF::Invalid_parameter_exception& exception)
    {
      EXPECT_EQ(std::string(exception.what()).find("allow_any_weights"), std::string::npos)
        << "it does not help";
    }
  }
}

TEST(Cotangent_weights, are_refused_where_the_mesh_is_not_delaunay)
{
  const Weighed weighed(soups_to_weigh()[3].soup);
  const bool has_negative_ones =
    std::any_of(edges(weighed.mesh).begin(), edges(weighed.mesh).end(),
                [&](const auto e) { return weighed.cotangent[e] <= 0; });
  ASSERT_TRUE(has_negative_ones);
  try
  {
    SMF::harmonic_foliation(weighed.system, weights(SMF::Cotangent_weights()));
    ADD_FAILURE();
  }
  catch (const SMF::Invalid_parameter_exception& exception)
  {
    const std::string message = exception.what();
    const std::vector<std::size_t>& ends = exception.problem().vertices;
    ASSERT_EQ(ends.size(), 2u);
    EXPECT_NE(message.find("the edge between the vertices " + std::to_string(ends[0]) + " and " +
                           std::to_string(ends[1]) + " is -"),
              std::string::npos)
      << message;
    EXPECT_NE(message.find("allow_any_weights"), std::string::npos) << message;
    EXPECT_NE(message.find("intrinsically Delaunay"), std::string::npos) << message;
    EXPECT_NE(message.find("mean value weights"), std::string::npos) << message;
  }
  EXPECT_THROW(SMF::harmonic_foliation(weighed.system,
                                       weights(SMF::Cotangent_weights()).allow_any_weights(false)),
               SMF::Invalid_parameter_exception);
}

// Nothing is guaranteed then, but that a result is certified and a failure an exception of ours.
TEST(Cotangent_weights, run_on_the_users_word)
{
  int successes = 0;
  for (const Named_soup& named : soups_to_weigh())
  {
    SCOPED_TRACE(named.name);
    const Weighed weighed(named.soup);
    try
    {
      const auto foliation = SMF::harmonic_foliation(
        weighed.system, weights(SMF::Cotangent_weights()).allow_any_weights(true));
      EXPECT_TRUE(foliation.statistics().is_certified);
      ++successes;
    }
    catch (const SMF::Foliation_exception& exception)
    {
      EXPECT_TRUE(exception.problem().kind == SMF::Problem_kind::SOLVER_FAILURE ||
                  exception.problem().kind == SMF::Problem_kind::CERTIFICATE_FAILURE)
        << exception.what();
    }
  }
  EXPECT_GE(successes, 2) << "the first two have positive weights";
}

} // namespace

} // namespace test_edge_weights
