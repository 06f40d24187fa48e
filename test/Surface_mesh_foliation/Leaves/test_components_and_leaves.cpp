// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/component_graph.h"
#include "include/edge_stretches.h"
#include "include/each_foliation.h"
#include "include/example_systems.h"
#include "include/polylines.h"

#include <CGAL/Surface_mesh_foliation/components.h>
#include <CGAL/Surface_mesh_foliation/leaves.h>
#include <CGAL/Surface_mesh_foliation/singularities.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace test_components_and_leaves {

namespace {

using smf_test::Cut_mesh;
using smf_test::distance;
using smf_test::Each_foliation;
using smf_test::edge_stretches;
using smf_test::Example;
using smf_test::Item;
using smf_test::length;
using smf_test::Mesh;
using smf_test::Solved_example;
namespace SMF = CGAL::Surface_mesh_foliation;
namespace soups = smf_test::soups;

using Point = Mesh::Point;
using Polyline = std::vector<Point>;
using Foliation = SMF::Measured_foliation<Mesh>;
using Critical_polyline = SMF::Critical_polyline<Point>;
using Singularity = SMF::Singularity<Mesh>;

double area(const Mesh& mesh)
{
  double result = 0;
  for (const auto f : faces(mesh))
  {
    const auto h = halfedge(f, mesh);
    const auto normal =
      CGAL::cross_product(mesh.point(target(h, mesh)) - mesh.point(source(h, mesh)),
                          mesh.point(target(next(h, mesh), mesh)) - mesh.point(source(h, mesh)));
    result += std::sqrt(normal.squared_length()) / 2;
  }
  return result;
}

class Components_and_leaves : public Each_foliation
{};

INSTANTIATE_TEST_SUITE_P(Examples,
                         Components_and_leaves,
                         ::testing::ValuesIn(smf_test::all_example_systems()),
                         smf_test::name_of_example);

// ===  Components

TEST_P(Components_and_leaves, cut_mesh_is_the_same_surface)
{
  const Cut_mesh cut(foliation);
  smf_test::expect_same_surface(cut, mesh);
  EXPECT_NEAR(area(cut.mesh), area(mesh), 1e-12 * area(mesh));
}

TEST_P(Components_and_leaves, cut_mesh_begins_with_the_vertices_of_the_input)
{
  const Cut_mesh cut(foliation);
  ASSERT_GE(num_vertices(cut.mesh), num_vertices(mesh));
  auto v = vertices(cut.mesh).begin();
  for (const auto u : vertices(mesh))
    EXPECT_EQ(cut.mesh.point(*v++), mesh.point(u));
}

TEST_P(Components_and_leaves, components_are_annuli_between_the_constrained_edges)
{
  const Cut_mesh cut(foliation);
  EXPECT_EQ(cut.number_of_components, system.number_of_arcs());
  smf_test::expect_annuli(cut, system.number_of_arcs());
}

TEST_P(Components_and_leaves, graph_of_components_is_that_of_the_loops)
{
  smf_test::expect_dual_graph(Cut_mesh(foliation), foliation);
}

TEST_P(Components_and_leaves, kinds_of_components_count_the_poles)
{
  std::size_t number_of_ends = 0;
  for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
    switch (SMF::component_kind(system, a))
    {
    case SMF::Component_kind::SPHERE:
      number_of_ends += 2;
      EXPECT_EQ(system.number_of_arcs(), 1u);
      break;
    case SMF::Component_kind::DISK:
      number_of_ends += 1;
      break;
    case SMF::Component_kind::CYLINDER:
      EXPECT_EQ(system.pole(system.node(a, 0)), -1);
      EXPECT_EQ(system.pole(system.node(a, 1)), -1);
    }
  EXPECT_EQ(number_of_ends, system.number_of_poles());
}

TEST_P(Components_and_leaves, vertices_lie_in_their_components)
{
  const Cut_mesh cut(foliation);
  auto v = vertices(cut.mesh).begin();
  for (const auto u : vertices(mesh))
  {
    const auto cell = foliation.cell(u);
    EXPECT_FALSE(cell.is_arc && cut.is_on_critical_leaf(*v));
    for (const auto f : CGAL::faces_around_target(halfedge(*v, cut.mesh), cut.mesh))
      if (cell.is_arc)
      {
        EXPECT_EQ(cut.component[f], cell.index) << u;
      }
      else if (!cut.is_at_node(f)) // its component ends at that node
      {
        EXPECT_TRUE(system.node(cut.component[f], 0) == cell.index ||
                    system.node(cut.component[f], 1) == cell.index);
      }
    ++v;
  }
}

TEST_P(Components_and_leaves, components_are_appended_and_the_input_stays)
{
  const smf_test::Triangle_soup before = smf_test::to_soup(mesh);
  const Cut_mesh cut(foliation);
  Mesh both = smf_test::octahedron();
  SMF::surface_components(foliation, both);
  EXPECT_EQ(num_vertices(both), num_vertices(cut.mesh) + 6);
  EXPECT_EQ(num_faces(both), num_faces(cut.mesh) + 8);
  EXPECT_EQ(num_edges(both), num_edges(cut.mesh) + 12);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(both));
  const smf_test::Triangle_soup octahedron = soups::octahedron(), soup = smf_test::to_soup(both);
  EXPECT_TRUE(std::equal(octahedron.points.begin(), octahedron.points.end(), soup.points.begin()));
  EXPECT_TRUE(
    std::equal(octahedron.triangles.begin(), octahedron.triangles.end(), soup.triangles.begin()));
  const smf_test::Triangle_soup after = smf_test::to_soup(mesh);
  EXPECT_EQ(after.points, before.points);
  EXPECT_EQ(after.triangles, before.triangles);
}

// ===  Leaves

// The arc and level of a point of an edge, if it lies on the edge.
bool is_on_edge_at_level(
  const Foliation& foliation, Mesh::Edge_index e, const Point& p, std::size_t arc, double level)
{
  const Mesh& mesh = foliation.mesh();
  const auto h = halfedge(e, mesh);
  const Point &a = mesh.point(source(h, mesh)), &b = mesh.point(target(h, mesh));
  const double size = distance(a, b), share = distance(a, p) / size;
  if (distance(a, p) + distance(p, b) > size * (1 + 1e-9))
    return false;
  const double way = share * foliation.edge_value(e); // linear along the edge
  const double tolerance = 1e-6 * (foliation.edge_value(e) + foliation.system().height(arc));
  double gone = 0;
  for (const smf_test::Stretch& stretch : edge_stretches(foliation, h))
  {
    const double here = gone + std::abs(level - stretch.from);
    if (stretch.arc == arc && std::abs(here - way) < tolerance)
      return true;
    gone += std::abs(stretch.to - stretch.from);
  }
  return false;
}

TEST_P(Components_and_leaves, leaves_lie_on_the_surface_at_their_level)
{
  for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
    for (const double share : {0.2, 0.5, 0.9})
    {
      const double level = share * system.height(a);
      const Polyline leaf = SMF::leaf(foliation, a, level);
      for (std::size_t i = 1; i < leaf.size(); ++i)
        EXPECT_TRUE(std::any_of(
          edges(mesh).begin(), edges(mesh).end(),
          [&](const auto e) { return is_on_edge_at_level(foliation, e, leaf[i], a, level); }))
          << "arc " << a << ", share " << share << ", point " << i;
    }
}

TEST_P(Components_and_leaves, leaves_are_closed_and_cross_each_edge_of_their_level_once)
{
  for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
    for (const double share : {0.01, 0.5, 0.99})
    {
      const double level = share * system.height(a);
      const Polyline leaf = SMF::leaf(foliation, a, level);
      ASSERT_GE(leaf.size(), 4u);
      EXPECT_EQ(leaf.front(), leaf.back());
      EXPECT_GT(length(leaf), 0);
      std::size_t crossings = 0;
      for (const auto e : edges(mesh))
        for (const smf_test::Stretch& stretch : edge_stretches(foliation, halfedge(e, mesh)))
          crossings += stretch.arc == a && (stretch.from < level) != (stretch.to < level);
      EXPECT_EQ(leaf.size() - 1, crossings) << "arc " << a << ", share " << share;
    }
}

// Also between the edges, where a leaf must keep clear of critical leaves.
TEST_P(Components_and_leaves, leaves_lie_in_their_component)
{
  const Cut_mesh cut(foliation);
  const double size = std::sqrt(area(mesh));
  for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
    for (const double share : {0.02, 0.3, 0.98})
    {
      const Polyline leaf = SMF::leaf(foliation, a, share * system.height(a));
      const std::size_t stride = 1 + leaf.size() / 20; // a sample is enough
      for (std::size_t i = stride; i < leaf.size(); i += stride)
      {
        const Point p = CGAL::midpoint(leaf[i - 1], leaf[i]);
        EXPECT_TRUE(std::any_of(faces(cut.mesh).begin(), faces(cut.mesh).end(),
                                [&](const auto f) {
                                  const auto h = halfedge(f, cut.mesh);
                                  const smf_test::Kernel::Triangle_3 triangle(
                                    cut.mesh.point(source(h, cut.mesh)),
                                    cut.mesh.point(target(h, cut.mesh)),
                                    cut.mesh.point(target(next(h, cut.mesh), cut.mesh)));
                                  return cut.component[f] == a &&
                                         CGAL::squared_distance(p, triangle) < 1e-18 * size * size;
                                }))
          << "arc " << a << ", share " << share << ", point " << i;
      }
    }
}

TEST_P(Components_and_leaves, leaves_outside_of_their_arc_are_refused)
{
  const double k = system.height(0);
  for (const double bad : {0., k, -k / 2, 2 * k, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(SMF::leaf(foliation, 0, bad), SMF::Invalid_parameter_exception);
  EXPECT_THROW(SMF::leaf(foliation, system.number_of_arcs(), k / 2),
               SMF::Invalid_parameter_exception);
  EXPECT_NO_THROW(SMF::leaf(foliation, 0, k * 1e-9));
  EXPECT_NO_THROW(SMF::leaf(foliation, 0, k * (1 - 1e-9)));
}

} // namespace

} // namespace test_components_and_leaves
