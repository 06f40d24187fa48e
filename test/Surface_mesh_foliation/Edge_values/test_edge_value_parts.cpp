// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The steps from edge values to components, one by one.

#include "include/edge_value_examples.h"
#include "include/example_systems.h"
#include "include/flat_meshes.h"
#include "generators/Random.h"

#include <CGAL/Surface_mesh_foliation/internal/Edge_values/Critical_leaf_tracer.h>
#include <CGAL/Surface_mesh_foliation/internal/Edge_values/Disk_cut.h>
#include <CGAL/Surface_mesh_foliation/internal/Edge_values/Disk_function.h>
#include <CGAL/Surface_mesh_foliation/internal/Edge_values/Edge_value_components.h>
#include <CGAL/Surface_mesh_foliation/internal/Edge_values/Edge_value_foliation.h>
#include <CGAL/Surface_mesh_foliation/internal/Edge_values/Edge_value_places.h>
#include <CGAL/Surface_mesh_foliation/internal/Edge_values/Edge_value_surface.h>
#include <CGAL/Surface_mesh_foliation/internal/Edge_values/Leaf_intervals.h>
#include <CGAL/Surface_mesh_foliation/internal/Edge_values/Middle_leaves.h>
#include <CGAL/Surface_mesh_foliation/internal/Edge_values/Noise_removal.h>
#include <CGAL/Surface_mesh_foliation/internal/Edge_values/check_edge_values.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/lengths.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace test_edge_value_parts {

using namespace smf_test;
using namespace CGAL::Surface_mesh_foliation::internal;

namespace {

// a flat mesh with values, taken as far as to its components
struct Parts
{
  explicit Parts(const Edge_value_example& example) : mesh(flat_mesh(example.soup))
  {
    for (int e = 0; e < mesh.number_of_edges(); ++e)
      value.push_back(example.value(static_cast<std::size_t>(mesh.source(halfedge_of(e))),
                                    static_cast<std::size_t>(mesh.target(halfedge_of(e)))));
    make();
  }

  explicit Parts(const Example& example) : mesh(flat_mesh(example.soup))
  {
    const Solved_example<> solved(example);
    const Foliation_state& state = solved.foliation.state();
    for (int e = 0; e < mesh.number_of_edges(); ++e)
      value.push_back(length_of_edge(state, e));
    make();
  }

  void make()
  {
    foliation = std::make_unique<Edge_value_foliation>(mesh, value,
                                                       Edge_value_tolerances(1e-9, value), 100000);
  }

  Flat_mesh mesh;
  std::vector<double> value;
  std::unique_ptr<Edge_value_foliation> foliation;
};

// the indices other than 0, with how often they occur
std::map<int, int> indices(const Edge_value_places& places)
{
  std::map<int, int> result;
  for (const auto& place : places.places())
    if (place.index() != 0)
      ++result[place.index()];
  return result;
}

int number_of_edges_with_sign(const Edge_value_foliation& foliation, int sign)
{
  int result = 0;
  const auto& surface = foliation.surface();
  for (int e = 0; e < surface.mesh().number_of_edges(); ++e)
    result += foliation.cut().is_cut(e) && !surface.is_flat(e) &&
              foliation.function().transition(halfedge_of(e)).sign == sign;
  return result;
}

Edge_value_example equal_values()
{
  return {"tetrahedron", soups::tetrahedron(), [](std::size_t, std::size_t) { return 2.; }};
}

} // namespace

TEST(Edge_value_surface, tripods_are_subdivided)
{
  const Parts parts(equal_values());
  const Edge_value_surface& surface = parts.foliation->surface();
  EXPECT_EQ(surface.mesh().number_of_vertices(), 8);
  EXPECT_EQ(surface.mesh().number_of_faces(), 12);
  for (int f = 0; f < 12; ++f)
  {
    EXPECT_EQ(surface.origin_of_face(f), f / 3);
    EXPECT_TRUE(surface.is_center(surface.mesh().source(surface.closed_corner(f))));
  }
  for (int e = 0; e < surface.mesh().number_of_edges(); ++e)
  {
    const int input = surface.input_halfedge(halfedge_of(e));
    EXPECT_EQ(surface.value(e), input >= 0 ? 2 : 1);
    if (input >= 0)
    {
      EXPECT_EQ(parts.mesh.source(input), surface.mesh().source(halfedge_of(e)));
      EXPECT_EQ(parts.mesh.target(input), surface.mesh().target(halfedge_of(e)));
    }
  }
}

TEST(Edge_value_surface, faces_are_regular_fans_or_flat)
{
  const Parts parts(three_disks(true));
  const Edge_value_surface& surface = parts.foliation->surface();
  for (int f = 0; f < surface.mesh().number_of_faces(); ++f)
  {
    EXPECT_EQ(surface.closed_corner(f), Edge_value_surface::NONE);
    EXPECT_EQ(surface.is_face_flat(f), f == surface.mesh().number_of_faces() - 1);
  }
}

// ===  Noise

// the values of an example, changed at random by up to `noise`
static Edge_value_example noisy_example(Edge_value_example example,
                                        double noise,
                                        std::uint64_t seed)
{
  const Edge_value_function value = example.value;
  example.value = [=](std::size_t u, std::size_t v) {
    Random random(seed * 10000 + 100 * std::min(u, v) + std::max(u, v));
    return value(u, v) + random.between(0, noise);
  };
  return example;
}

TEST(Noise_removal, leaves_no_accidental_pole)
{
  for (std::uint64_t seed = 1; seed < 100; ++seed)
  {
    SCOPED_TRACE(seed);
    for (const Edge_value_example& example :
         {flat_equator(), three_disks(false), three_disks(true)})
    {
      SCOPED_TRACE(example.name);
      const Parts parts(noisy_example(example, 1e-12, seed));
      const std::size_t poles = example.name == flat_equator().name ? 2 : 3;
      EXPECT_EQ(parts.foliation->components().components().size(), poles == 2 ? 1u : 3u);
      EXPECT_EQ(indices(parts.foliation->places())[2], static_cast<int>(poles));
      EXPECT_EQ(indices(parts.foliation->places())[1], 0);
    }
  }
}

TEST(Noise_removal, flattens_hardly_anything_but_zeros)
{
  for (const Example& example : example_systems())
  {
    SCOPED_TRACE(example.name);
    const Parts parts(example);
    const Edge_value_surface& surface = parts.foliation->surface();
    for (int e = 0; e < surface.mesh().number_of_edges(); ++e)
    {
      const int input = surface.input_halfedge(halfedge_of(e));
      if (surface.is_flat(e) && input >= 0)
      {
        EXPECT_LT(parts.value[static_cast<std::size_t>(edge_of(input))], 1e-14);
      }
    }
  }
}

TEST(Edge_value_places, indices)
{
  using Indices = std::map<int, int>;
  EXPECT_EQ(indices(Parts(equal_values()).foliation->places()), (Indices{{2, 4}, {-1, 4}}));
  EXPECT_EQ(indices(Parts(three_disks(false)).foliation->places()), (Indices{{2, 3}, {-2, 1}}));
  EXPECT_EQ(indices(Parts(three_disks(true)).foliation->places()), (Indices{{2, 3}, {-2, 1}}));
  EXPECT_EQ(indices(Parts(flat_equator()).foliation->places()), (Indices{{2, 2}}));
  const Parts torus(linear_torus(8, 6, 1, 2));
  EXPECT_EQ(indices(torus.foliation->places()), Indices());
  EXPECT_FALSE(torus.foliation->places().is_singular());
  EXPECT_TRUE(torus.foliation->places().is_node(0));
}

// An open disk has Euler characteristic 1 and is connected.
TEST(Disk_cut, leaves_a_disk_without_the_given_vertices)
{
  for (std::size_t genus = 0; genus < 5; ++genus)
    for (const std::vector<int>& given : {std::vector<int>{0}, {3, 10, 11, 30}})
    {
      SCOPED_TRACE(genus);
      const Flat_mesh mesh = flat_mesh(soups::genus_surface(genus, 3));
      const Disk_cut cut(mesh, given);
      std::vector<bool> is_inside(mesh.number_of_vertices(), true);
      for (int v : given)
        is_inside[v] = false;
      Disjoint_sets faces(mesh.number_of_faces());
      int characteristic = mesh.number_of_faces();
      for (int e = 0; e < mesh.number_of_edges(); ++e)
        if (cut.is_cut(e))
          is_inside[mesh.source(halfedge_of(e))] = is_inside[mesh.target(halfedge_of(e))] = false;
        else
        {
          --characteristic;
          faces.union_set(mesh.face(halfedge_of(e)), mesh.face(opposite_of(halfedge_of(e))));
        }
      for (int v = 0; v < mesh.number_of_vertices(); ++v)
        characteristic += is_inside[v];
      EXPECT_EQ(characteristic, 1);
      for (int f = 0; f < mesh.number_of_faces(); ++f)
        EXPECT_EQ(faces.find_set(f), faces.find_set(0));
    }
}

// The cut joins the two given vertices by a shortest path.
TEST(Disk_cut, of_a_sphere_is_a_tree_of_shortest_paths)
{
  const Flat_mesh mesh = flat_mesh(soups::icosphere(3));
  const Disk_cut cut(mesh, {0, 3});
  double length = 0;
  for (int e = 0; e < mesh.number_of_edges(); ++e)
    if (cut.is_cut(e))
      length += soups::distance(mesh.point(mesh.source(halfedge_of(e))),
                                mesh.point(mesh.target(halfedge_of(e))));
  EXPECT_GT(length, 3); // half of a great circle at least
  EXPECT_LT(length, 4);
}

TEST(Disk_function, has_the_values_as_differences)
{
  for (const Example& example : example_systems())
  {
    SCOPED_TRACE(example.name);
    const Parts parts(example);
    const Edge_value_surface& surface = parts.foliation->surface();
    const Disk_function& function = parts.foliation->function();
    for (int h = 0; h < surface.mesh().number_of_halfedges(); ++h)
    {
      if (surface.is_flat(edge_of(h)))
        continue;
      const double difference = function.at_target(h) - function.at_source(h);
      EXPECT_NEAR(std::abs(difference), surface.value(edge_of(h)), 1e-12);
      EXPECT_EQ(difference > 0, function.goes_up(h));
      const Level_transition transition = function.transition(h);
      EXPECT_NEAR(transition(function.at_source(h)), function.at_target(opposite_of(h)), 1e-12);
      EXPECT_NEAR(transition(function.at_target(h)), function.at_source(opposite_of(h)), 1e-12);
      if (!parts.foliation->cut().is_cut(edge_of(h)))
      {
        EXPECT_EQ(transition.sign, 1);
        EXPECT_EQ(transition.shift, 0);
      }
    }
  }
}

// On a torus without singularity the leaves can be oriented; around a tripod they cannot.
TEST(Disk_function, transitions_are_of_both_kinds)
{
  const Parts torus(linear_torus(8, 6, 1, 2));
  EXPECT_EQ(number_of_edges_with_sign(*torus.foliation, -1), 0);
  EXPECT_GT(number_of_edges_with_sign(*torus.foliation, 1), 0);
  const Parts limbs(example_systems()[0]);
  EXPECT_GT(number_of_edges_with_sign(*limbs.foliation, -1), 0);
  EXPECT_GT(number_of_edges_with_sign(*limbs.foliation, 1), 0);
}

TEST(Critical_leaf_tracer, joins_all_prongs_by_leaves)
{
  for (const Example& example : example_systems())
  {
    SCOPED_TRACE(example.name);
    const Parts parts(example);
    const Edge_value_places& places = parts.foliation->places();
    const Critical_leaf_tracer& leaves = parts.foliation->leaves();
    std::size_t prongs = 0;
    for (const auto& place : places.places())
      if (place.is_node)
        for (int f : place.prongs)
        {
          ++prongs;
          EXPECT_TRUE(leaves.has_prong(f));
        }
    EXPECT_EQ(2 * leaves.ends().size(), prongs);
    for (int e = 0; e < parts.foliation->surface().mesh().number_of_edges(); ++e)
      for (const auto& crossing : leaves.crossings(e))
      {
        EXPECT_GE(crossing.way, 0);
        EXPECT_LE(crossing.way, parts.foliation->surface().value(e));
      }
  }
}

TEST(Leaf_intervals, make_up_the_edges)
{
  const Parts parts(theta_example());
  const Edge_value_surface& surface = parts.foliation->surface();
  const Leaf_intervals& intervals = parts.foliation->intervals();
  std::vector<double> sum(surface.mesh().number_of_edges(), 0);
  for (int i = 0; i < intervals.size(); ++i)
  {
    const auto [from, to] = intervals.ways(i);
    EXPECT_LE(from, to);
    sum[intervals.edge(i)] += to - from;
    for (int h : halfedges_of_edge(intervals.edge(i)))
      EXPECT_EQ(intervals.number(intervals.seen_along(h, i)), i);
    EXPECT_EQ(
      intervals.number(intervals.reversed(intervals.seen_along(halfedge_of(intervals.edge(i)), i))),
      i);
  }
  for (int e = 0; e < surface.mesh().number_of_edges(); ++e)
    EXPECT_NEAR(sum[e], surface.value(e), 1e-15);
}

TEST(Edge_value_components, heights_and_nodes)
{
  for (const Example& example : all_example_systems())
  {
    SCOPED_TRACE(example.name);
    const Parts parts(example);
    const Solved_example<> solved(example);
    std::vector<double> heights, expected;
    for (const auto& component : parts.foliation->components().components())
      heights.push_back(component.height);
    for (std::size_t a = 0; a < solved.system.number_of_arcs(); ++a)
      expected.push_back(solved.system.height(a));
    std::sort(heights.begin(), heights.end());
    std::sort(expected.begin(), expected.end());
    ASSERT_EQ(heights.size(), expected.size());
    for (std::size_t a = 0; a < heights.size(); ++a)
      EXPECT_NEAR(heights[a], expected[a], 1e-12 * expected.back());
    EXPECT_EQ(parts.foliation->components().number_of_nodes(),
              static_cast<int>(solved.system.number_of_nodes()));
  }
}

TEST(Edge_value_components, parameters_increase_by_the_values)
{
  const Parts parts(flat_equator());
  const Edge_value_components& components = parts.foliation->components();
  ASSERT_EQ(components.components().size(), 1u);
  const bool begins_at_vertex_4 = parts.foliation->pole_at_end(0, 0) == std::vector<int>{4};
  for (int v : {0, 1, 2, 3})
  {
    EXPECT_EQ(components.component_of_vertex(v), 0);
    EXPECT_EQ(components.t(v), begins_at_vertex_4 ? 1 : 2);
  }
  for (int v : {4, 5})
    EXPECT_EQ(components.component_of_vertex(v), Edge_value_components::NONE);
}

TEST(Middle_leaves, are_closed_curves_with_end_0_on_their_left)
{
  int number_of_edges_inside = 0;
  for (const Example& example : example_systems())
  {
    SCOPED_TRACE(example.name);
    const Parts parts(example);
    const Edge_value_components& components = parts.foliation->components();
    const std::vector<Flat_loop>& loops = parts.foliation->middle_leaves().loops();
    ASSERT_EQ(loops.size(), components.components().size());
    for (int a = 0; a < static_cast<int>(loops.size()); ++a)
    {
      Problems problems;
      check_curve(parts.mesh, {}, loops[a], a, problems);
      EXPECT_TRUE(problems.empty());
      for (const auto& crossing : loops[a].crossings)
      {
        const int left = parts.mesh.target(crossing.halfedge),
                  right = parts.mesh.source(crossing.halfedge);
        if (components.component_of_vertex(left) != a || components.component_of_vertex(right) != a)
          continue;
        EXPECT_LT(components.t(left), components.t(right));
        ++number_of_edges_inside;
      }
      // t is measured from a pole if there is one
      EXPECT_TRUE(!parts.foliation->pole_at_end(a, 0).empty() ||
                  parts.foliation->pole_at_end(a, 1).empty());
    }
  }
  EXPECT_GT(number_of_edges_inside, 100);
}

} // namespace test_edge_value_parts
