// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/each_foliation.h"
#include "include/example_systems.h"
#include "include/polylines.h"
#include "generators/Random.h"

#include <CGAL/Surface_mesh_foliation/Leaf_tracer.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/Arc_paths.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/Face_location.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/essential_leaf.h>
#include <CGAL/Surface_mesh_foliation/leaves.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_embedding.h>
#include <CGAL/Surface_mesh_foliation/singularities.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <vector>

namespace test_leaf_tracer {

namespace {

using smf_test::distance;
using smf_test::Each_foliation;
using smf_test::length;
using smf_test::Mesh;
namespace SMF = CGAL::Surface_mesh_foliation;
namespace internal = SMF::internal;

using Point = Mesh::Point;
using Polyline = std::vector<Point>;
using Leaf = SMF::Leaf<Point>;
using Tracer = SMF::Leaf_tracer<Mesh>;
using Coordinates = Tracer::Barycentric_coordinates;

class Leaf_tracer_of_example : public Each_foliation
{};

INSTANTIATE_TEST_SUITE_P(Examples,
                         Leaf_tracer_of_example,
                         ::testing::ValuesIn(smf_test::all_example_systems()),
                         smf_test::name_of_example);

// whether two closed polylines are the same up to rounding, wherever they begin and which way
// they run
void expect_same_leaf(const Polyline& found, const Polyline& expected, double size)
{
  EXPECT_EQ(found.size(), expected.size());
  for (const Point& p : found)
    EXPECT_TRUE(std::any_of(expected.begin(), expected.end(),
                            [&](const Point& q) { return distance(p, q) < 1e-12 * size; }));
}

// the leaf that runs around, found among all curves of its level
Polyline leaf_by_search(const SMF::Measured_foliation<Mesh>& foliation,
                        std::size_t arc,
                        double level)
{
  Polyline result;
  for (const auto& crossing :
       internal::essential_leaf(foliation.state(), static_cast<int>(arc), level))
  {
    const auto p = internal::point_of_crossing(foliation.state(), crossing, level);
    result.emplace_back(p[0], p[1], p[2]);
  }
  result.push_back(result.front());
  return result;
}

std::array<Point, 3> corners(const Mesh& mesh, Mesh::Face_index f)
{
  const auto h = halfedge(f, mesh);
  return {mesh.point(source(h, mesh)), mesh.point(target(h, mesh)),
          mesh.point(target(next(h, mesh), mesh))};
}

Point point_at(const Mesh& mesh, Mesh::Face_index f, const Coordinates& c)
{
  const auto [p, q, r] = corners(mesh, f);
  return CGAL::barycenter(p, c[0], q, c[1], r, c[2]);
}

double distance_to(const Polyline& polyline, const Point& p)
{
  double result = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < polyline.size(); ++i)
  {
    const auto d = [](const Point& q) { return internal::coordinates(q); };
    result =
      std::min(result, internal::distance_to_segment(d(p), d(polyline[i - 1]), d(polyline[i])));
  }
  return result;
}

double size_of(const Mesh& mesh)
{
  double result = 0;
  for (const auto v : vertices(mesh))
    result = std::max(result, distance(mesh.point(v), mesh.point(*vertices(mesh).begin())));
  return result;
}

Coordinates random_coordinates(smf_test::Random& random)
{
  const double a = random.between(0, 1), b = random.between(0, 1);
  return a + b < 1 ? Coordinates{a, b, 1 - a - b} : Coordinates{1 - a, 1 - b, a + b - 1};
}

// whether parameters are equal to rounding somewhere: a region without loop to another pole
bool has_plateaus(const smf_test::Example& example)
{
  return example.name == "plateaus";
}

} // namespace

// ===  A leaf at a level

TEST_P(Leaf_tracer_of_example, leaf_of_the_tracer_is_that_found_by_search)
{
  const Tracer tracer(foliation);
  for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
    for (const double share : {1e-9, 0.01, 0.3, 0.5, 0.77, 1 - 1e-9})
    {
      const double level = share * system.height(a);
      const Leaf leaf = tracer.leaf(a, level);
      EXPECT_EQ(leaf.arc, a);
      EXPECT_EQ(leaf.level, level);
      EXPECT_EQ(leaf.points.front(), leaf.points.back());
      expect_same_leaf(leaf.points, leaf_by_search(foliation, a, level), size_of(mesh));
      EXPECT_NEAR(leaf.length, length(leaf.points), 1e-12 * leaf.length);
      EXPECT_EQ(SMF::leaf(foliation, a, level), leaf.points);
    }
}

// The levels of all vertices, where a leaf passes vertices.
TEST_P(Leaf_tracer_of_example, leaf_at_levels_of_vertices)
{
  const Tracer tracer(foliation);
  const double size = size_of(mesh);
  std::size_t i = 0;
  for (const auto v : vertices(mesh))
    if (foliation.cell(v).is_arc && ++i % 7 == 0)
    {
      const std::size_t a = foliation.cell(v).index;
      const double level = foliation.parameter(v);
      expect_same_leaf(tracer.leaf(a, level).points, leaf_by_search(foliation, a, level), size);
    }
}

TEST_P(Leaf_tracer_of_example, leaves_agree_with_the_embedding)
{
  const Tracer tracer(foliation);
  const auto embedding =
    SMF::reeb_graph_embedding(foliation, SMF::parameters::number_of_samples(5));
  const double size = size_of(mesh);
  for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
    for (std::size_t i = 0; i < embedding.levels[a].size(); ++i)
    {
      const Leaf leaf = tracer.leaf(a, embedding.levels[a][i]);
      EXPECT_NEAR(leaf.length, embedding.leaf_lengths[a][i], 1e-9 * size);
      EXPECT_LT(distance(leaf.centroid, embedding.arc_polylines[a][i + 1]), 1e-9 * size);
    }
}

TEST_P(Leaf_tracer_of_example, leaves_are_evenly_spaced)
{
  const Tracer tracer(foliation);
  for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
  {
    std::vector<Leaf> leaves;
    tracer.evenly_spaced_leaves(a, 4, std::back_inserter(leaves));
    ASSERT_EQ(leaves.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(leaves[i].level, system.height(a) * static_cast<double>(i + 1) / 5,
                  1e-15 * system.height(a));
    tracer.evenly_spaced_leaves(a, 0, std::back_inserter(leaves));
    EXPECT_EQ(leaves.size(), 4u);
  }
}

// A leaf keeps what is above to its left: who crosses an edge on it leaves the face of that side.
TEST_P(Leaf_tracer_of_example, leaves_have_larger_levels_to_their_left)
{
  const internal::Foliation_state& state = foliation.state();
  const internal::Arc_paths paths(state);
  const internal::Level_tracer tracer(state);
  for (int a = 0; a < static_cast<int>(system.number_of_arcs()); ++a)
  {
    const double level = 0.4 * system.height(static_cast<std::size_t>(a));
    for (const internal::Leaf_crossing& c : tracer.trace(paths.step_at(a, level), level))
      EXPECT_TRUE(tracer.is_crossed_upwards(c.halfedge, c.cell, level));
    const auto steps = paths.all_steps_at(a, level);
    EXPECT_EQ(steps.size() % 2, 1u);
    for (const internal::Leaf_crossing& c : steps)
      EXPECT_TRUE(tracer.is_crossed_upwards(c.halfedge, c.cell, level));
  }
}

TEST_P(Leaf_tracer_of_example, the_tracer_refuses_leaves_that_do_not_exist)
{
  const Tracer tracer(foliation);
  const double k = system.height(0);
  for (const double bad : {0., k, -k / 2, 2 * k, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(tracer.leaf(0, bad), SMF::Invalid_parameter_exception);
  std::vector<Leaf> leaves;
  EXPECT_THROW(tracer.leaf(system.number_of_arcs(), k / 2), SMF::Invalid_parameter_exception);
  EXPECT_THROW(tracer.evenly_spaced_leaves(system.number_of_arcs(), 3, std::back_inserter(leaves)),
               SMF::Invalid_parameter_exception);
}

// ===  The leaf through a point

TEST_P(Leaf_tracer_of_example, leaves_pass_their_points)
{
  const Tracer tracer(foliation);
  smf_test::Random random(11);
  const double size = size_of(mesh);
  const std::size_t stride = 1 + num_faces(mesh) / 150;
  std::size_t i = 0, number = 0, missing = 0;
  for (const auto f : faces(mesh))
  {
    if (i++ % stride != 0)
      continue;
    const Coordinates c = random_coordinates(random);
    const Tracer::Location place = tracer.locate(f, c);
    const std::optional<Leaf> leaf = tracer.leaf_through(f, c);
    ++number;
    if (!place.is_arc)
    {
      EXPECT_FALSE(leaf);
      EXPECT_EQ(place.level, 0);
    }
    missing += place.is_arc && !leaf;
    if (!leaf)
      continue;
    EXPECT_EQ(leaf->arc, place.index);
    EXPECT_EQ(leaf->level, place.level);
    EXPECT_LT(distance_to(leaf->points, point_at(mesh, f, c)), 1e-9 * size) << f;
    expect_same_leaf(leaf->points, leaf_by_search(foliation, place.index, place.level), size);
  }
  if (!has_plateaus(GetParam()))
  {
    EXPECT_EQ(missing, 0u);
  }
  EXPECT_LT(missing, number);
}

// the coordinates of source(h) in its face
Coordinates corner_of_source(const Mesh& mesh, Mesh::Halfedge_index h)
{
  const auto first = halfedge(face(h, mesh), mesh);
  Coordinates result = {0, 0, 0};
  result[h == first ? 0 : h == next(first, mesh) ? 1 : 2] = 3; // need not be normalized
  return result;
}

TEST_P(Leaf_tracer_of_example, leaves_pass_their_vertices)
{
  const Tracer tracer(foliation);
  const double size = size_of(mesh);
  std::size_t i = 0, missing = 0;
  const std::size_t stride = 1 + num_vertices(mesh) / 100;
  for (const auto v : vertices(mesh))
  {
    if (i++ % stride != 0)
      continue;
    const std::optional<Leaf> leaf = tracer.leaf_through(v);
    if (!foliation.cell(v).is_arc)
    {
      EXPECT_FALSE(leaf);
    }
    else if (!leaf)
      ++missing;
    else
    {
      EXPECT_EQ(leaf->arc, foliation.cell(v).index);
      EXPECT_EQ(leaf->level, foliation.parameter(v));
      EXPECT_LT(distance_to(leaf->points, mesh.point(v)), 1e-12 * size);
    }
    // from each of its faces the same
    for (const auto h : CGAL::halfedges_around_source(v, mesh))
    {
      const Coordinates c = corner_of_source(mesh, h);
      const Tracer::Location place = tracer.locate(face(h, mesh), c);
      EXPECT_EQ(place.is_arc, foliation.cell(v).is_arc);
      EXPECT_EQ(place.index, foliation.cell(v).index);
      EXPECT_EQ(place.level, foliation.parameter(v));
      const std::optional<Leaf> same = tracer.leaf_through(face(h, mesh), c);
      EXPECT_EQ(same.has_value(), leaf.has_value());
      if (same && leaf)
      {
        expect_same_leaf(same->points, leaf->points, size);
      }
    }
  }
  if (!has_plateaus(GetParam()))
  {
    EXPECT_EQ(missing, 0u);
  }
}

// Points of edges and faces that lie at a node as a whole, whatever rounding makes of sums.
TEST_P(Leaf_tracer_of_example, points_of_critical_edges_lie_on_critical_leaves)
{
  const Tracer tracer(foliation);
  for (const auto f : faces(mesh))
  {
    const auto first = halfedge(f, mesh);
    std::array<Mesh::Halfedge_index, 3> h = {first, next(first, mesh),
                                             next(next(first, mesh), mesh)};
    for (std::size_t i : {0, 1, 2})
    {
      const auto cell = foliation.cell(source(h[i], mesh));
      if (cell.is_arc || !foliation.path(h[i]).empty())
        continue;
      Coordinates c = {0, 0, 0};
      c[i] = 0.1;
      c[(i + 1) % 3] = 0.7;
      const Tracer::Location place = tracer.locate(f, c);
      EXPECT_FALSE(place.is_arc);
      EXPECT_EQ(place.index, cell.index);
      EXPECT_FALSE(tracer.leaf_through(f, c));
    }
  }
}

// Beside the middle of a tripod every corner has leaves; the middle has none.
TEST_P(Leaf_tracer_of_example, middles_of_tripods_lie_on_critical_leaves)
{
  const Tracer tracer(foliation);
  std::vector<SMF::Singularity<Mesh>> singularities;
  SMF::singularities(foliation, std::back_inserter(singularities));
  for (const auto& singularity : singularities)
  {
    if (!singularity.is_face)
      continue;
    const auto first = halfedge(singularity.face, mesh);
    std::array<double, 3> value; // of the edge opposite to corner i
    auto h = next(first, mesh);
    for (double& w : value)
    {
      w = foliation.edge_value(edge(h, mesh));
      h = next(h, mesh);
    }
    const auto reach = [&](std::size_t i) {
      return (value[(i + 1) % 3] + value[(i + 2) % 3] - value[i]) / 2;
    };
    Coordinates middle = {0, 0, 0}; // of the three places where edges meet the critical leaf
    for (std::size_t i : {0, 1, 2})
      for (std::size_t j : {(i + 1) % 3, (i + 2) % 3})
        middle[i] += reach(j) / (reach(i) + reach(j)) / 3;
    const Tracer::Location place = tracer.locate(singularity.face, middle);
    EXPECT_FALSE(place.is_arc);
    EXPECT_EQ(place.index, singularity.node);
    for (std::size_t i : {0, 1, 2}) // near corner i
    {
      Coordinates c = {1e-3, 1e-3, 1e-3};
      c[i] = 1;
      const Tracer::Location beside = tracer.locate(singularity.face, c);
      if (reach(i) > 3e-3 * (value[0] + value[1] + value[2]))
      {
        EXPECT_TRUE(beside.is_arc);
      }
    }
  }
}

TEST_P(Leaf_tracer_of_example, bad_coordinates_are_refused_with_their_face)
{
  const Tracer tracer(foliation);
  const auto f = *std::next(faces(mesh).begin(), 3);
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Coordinates& bad : {Coordinates{0, 0, 0}, Coordinates{-0.1, 0.6, 0.5},
                                 Coordinates{infinity, 1, 1}, Coordinates{0.5, 0.5, std::nan("")}})
    try
    {
      tracer.leaf_through(f, bad);
      ADD_FAILURE() << "accepted";
    }
    catch (const SMF::Invalid_parameter_exception& exception)
    {
      EXPECT_EQ(exception.problem().faces, std::vector<std::size_t>{3});
    }
}

} // namespace test_leaf_tracer
