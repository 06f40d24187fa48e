// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/each_foliation.h"
#include "include/example_systems.h"
#include "include/polylines.h"

#include <CGAL/Surface_mesh_foliation/components.h>
#include <CGAL/Surface_mesh_foliation/leaves.h>
#include <CGAL/Surface_mesh_foliation/singularities.h>
#include <CGAL/Surface_mesh_foliation/subdivide_saddle_faces.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/pending/disjoint_sets.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <vector>

namespace test_singularities {

namespace {

using smf_test::distance;
using smf_test::Each_foliation;
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

class Singularities_of_example : public Each_foliation
{};

INSTANTIATE_TEST_SUITE_P(Examples,
                         Singularities_of_example,
                         ::testing::ValuesIn(smf_test::all_example_systems()),
                         smf_test::name_of_example);

// ===  Singularities

TEST_P(Singularities_of_example, indices_add_up)
{
  std::vector<Singularity> singularities;
  SMF::singularities(foliation, std::back_inserter(singularities));
  std::vector<int> sum(system.number_of_nodes(), 0);
  int total = 0;
  for (const Singularity& singularity : singularities)
  {
    ASSERT_LT(singularity.node, system.number_of_nodes());
    sum[singularity.node] += singularity.index;
    total += singularity.index;
  }
  for (std::size_t r = 0; r < system.number_of_nodes(); ++r)
    EXPECT_EQ(sum[r],
              2 * (2 - 2 * static_cast<int>(system.genus(r)) - static_cast<int>(system.degree(r))))
      << "node " << r;
  EXPECT_EQ(total, 4 - 4 * static_cast<int>(system.genus()));
}

TEST_P(Singularities_of_example, kinds_of_singularities)
{
  std::vector<Singularity> singularities;
  SMF::singularities(foliation, std::back_inserter(singularities));
  std::map<Mesh::Vertex_index, int> expected; // positive indices: poles and nothing else
  for (std::size_t p = 0; p < system.number_of_poles(); ++p)
  {
    const auto vertices = system.pole_vertices(p);
    ++expected[vertices.front()];
    ++expected[vertices.back()];
  }
  std::map<Mesh::Vertex_index, int> positive;
  std::set<Mesh::Vertex_index> singular_vertices;
  std::set<Mesh::Face_index> singular_faces;
  for (const Singularity& singularity : singularities)
  {
    EXPECT_NE(singularity.index, 0);
    if (singularity.is_face)
    {
      EXPECT_EQ(singularity.index, -1);
      EXPECT_EQ(singularity.vertex, Mesh::null_vertex());
      EXPECT_TRUE(singular_faces.insert(singularity.face).second) << "twice";
      continue;
    }
    EXPECT_EQ(singularity.face, Mesh::null_face());
    EXPECT_TRUE(singular_vertices.insert(singularity.vertex).second) << "twice";
    EXPECT_FALSE(foliation.cell(singularity.vertex).is_arc);
    EXPECT_EQ(foliation.cell(singularity.vertex).index, singularity.node);
    if (singularity.index > 0)
      positive[singularity.vertex] = singularity.index;
  }
  EXPECT_EQ(positive, expected);
}

TEST_P(Singularities_of_example, kinds_and_orders_fit_the_indices)
{
  std::vector<Singularity> singularities;
  SMF::singularities(foliation, std::back_inserter(singularities));
  for (const Singularity& singularity : singularities)
  {
    EXPECT_EQ(singularity.kind, SMF::singularity_kind(singularity.index));
    EXPECT_EQ(singularity.order, std::max(0, -singularity.index));
    const bool is_pole = system.pole(singularity.node) >= 0;
    EXPECT_EQ(is_pole, singularity.kind == SMF::Singularity_kind::CENTER_POLE ||
                         singularity.kind == SMF::Singularity_kind::THORN_POLE);
    if (is_pole)
    {
      const auto pole = static_cast<std::size_t>(system.pole(singularity.node));
      EXPECT_EQ(singularity.kind == SMF::Singularity_kind::THORN_POLE,
                system.pole_vertices(pole).size() > 1);
    }
    if (singularity.is_face)
    {
      EXPECT_EQ(singularity.kind, SMF::Singularity_kind::TRIPOD);
    }
  }
}

TEST(Singularity_kind, of_all_indices)
{
  EXPECT_EQ(SMF::singularity_kind(2), SMF::Singularity_kind::CENTER_POLE);
  EXPECT_EQ(SMF::singularity_kind(1), SMF::Singularity_kind::THORN_POLE);
  EXPECT_EQ(SMF::singularity_kind(-1), SMF::Singularity_kind::TRIPOD);
  EXPECT_EQ(SMF::singularity_kind(-2), SMF::Singularity_kind::MORSE_SADDLE);
  EXPECT_EQ(SMF::singularity_kind(-3), SMF::Singularity_kind::HIGHER_SADDLE);
  EXPECT_EQ(SMF::singularity_kind(-8), SMF::Singularity_kind::HIGHER_SADDLE);
}

TEST_P(Singularities_of_example, complex_saddle_leaves_join_more_than_three_components)
{
  std::vector<SMF::Complex_saddle_leaf> leaves;
  SMF::complex_saddle_leaves(foliation, std::back_inserter(leaves));
  std::map<std::size_t, std::size_t> order, expected;
  for (const SMF::Complex_saddle_leaf& leaf : leaves)
    EXPECT_TRUE(order.emplace(leaf.node, leaf.order).second) << "twice";
  for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
    for (int end : {0, 1})
      ++expected[system.node(a, end)];
  for (auto it = expected.begin(); it != expected.end();)
    it = it->second > 3 ? std::next(it) : expected.erase(it);
  EXPECT_EQ(order, expected);
  if (GetParam().name == "limbs")
  {
    EXPECT_EQ(leaves.size(), 1u);
    EXPECT_EQ(leaves.at(0).order, 5u);
  }
}

// ===  Faces that are saddles, split

// The mesh with split faces, and what can be seen of it without the foliation.
struct Split_mesh
{
  explicit Split_mesh(const Foliation& foliation)
    : value(mesh.add_property_map<Mesh::Edge_index, double>("e:value", -1).first)
  {
    number = SMF::subdivide_saddle_faces(foliation, mesh, SMF::parameters::edge_value_map(value));
    for (const auto e : edges(mesh))
      largest = std::max(largest, value[e]);
  }

  double value_of(Mesh::Halfedge_index h) const { return value[edge(h, mesh)]; }

  // The measure of the leaves that cut the corner of target(h) in the face of h off.
  double corner(Mesh::Halfedge_index h) const
  {
    const auto g = next(h, mesh);
    return (value_of(h) + value_of(g) - value_of(next(g, mesh))) / 2;
  }

  // 2 - C + Z, by numbers
  int index(Mesh::Vertex_index v) const
  {
    int result = 2;
    for (const auto h : CGAL::halfedges_around_target(v, mesh))
    {
      result -= corner(h) < tolerance * largest;
      result += value_of(h) < tolerance * largest;
    }
    return result;
  }

  static constexpr double tolerance = 1e-13;

  Mesh mesh;
  Mesh::Property_map<Mesh::Edge_index, double> value;
  std::size_t number;
  double largest = 0;
};

TEST_P(Singularities_of_example, split_mesh_is_the_same_surface_with_centers)
{
  std::vector<Mesh::Face_index> saddles;
  std::vector<Singularity> singularities;
  SMF::singularities(foliation, std::back_inserter(singularities));
  for (const Singularity& singularity : singularities)
    if (singularity.is_face)
      saddles.push_back(singularity.face);
  const Split_mesh split(foliation);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(split.mesh));
  EXPECT_TRUE(CGAL::is_closed(split.mesh));
  EXPECT_EQ(split.number, saddles.size());
  ASSERT_EQ(num_vertices(split.mesh), num_vertices(mesh) + saddles.size());
  ASSERT_EQ(num_faces(split.mesh), num_faces(mesh) + 2 * saddles.size());
  auto v = vertices(split.mesh).begin();
  for (const auto u : vertices(mesh))
    EXPECT_EQ(split.mesh.point(*v++), mesh.point(u));
  for (const auto f : saddles) // its center is joined to its corners
  {
    std::set<Point> corners, neighbors;
    for (const auto u : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      corners.insert(mesh.point(u));
    for (const auto u : CGAL::vertices_around_target(halfedge(*v, split.mesh), split.mesh))
      neighbors.insert(split.mesh.point(u));
    EXPECT_EQ(neighbors, corners);
    ++v;
  }
}

TEST_P(Singularities_of_example, split_mesh_has_regular_faces_and_singular_vertices)
{
  const Split_mesh split(foliation);
  for (const auto f : faces(split.mesh))
  {
    std::vector<double> values;
    for (const auto h : CGAL::halfedges_around_face(halfedge(f, split.mesh), split.mesh))
      values.push_back(split.value_of(h));
    std::sort(values.begin(), values.end());
    EXPECT_GE(values[0], 0);
    EXPECT_NEAR(values[0] + values[1], values[2], Split_mesh::tolerance * split.largest);
  }
  // the centers are tripods by numbers, too, and old edges keep their values
  auto v = std::next(vertices(split.mesh).begin(), static_cast<int>(num_vertices(mesh)));
  for (; v != vertices(split.mesh).end(); ++v)
    EXPECT_EQ(split.index(*v), -1);
  for (const auto e : edges(mesh))
  {
    const auto [h, exists] = halfedge(mesh.vertex(e, 0), mesh.vertex(e, 1), split.mesh);
    ASSERT_TRUE(exists);
    EXPECT_EQ(split.value_of(h), foliation.edge_value(e));
  }
}

// With numbers alone singularities can be found where no corner is nearly closed.
TEST(Subdivide_saddle_faces, shows_all_singularities_at_vertices)
{
  for (const Example& example : {smf_test::example_systems()[0], smf_test::theta_example()})
  {
    const Solved_example<> solved(example);
    const Split_mesh split(solved.foliation);
    std::vector<Singularity> singularities;
    SMF::singularities(solved.foliation, std::back_inserter(singularities));
    std::map<int, int> found, expected; // how many of each index
    for (const Singularity& singularity : singularities)
      ++expected[singularity.index];
    for (const auto v : vertices(split.mesh))
      if (const int index = split.index(v); index != 0)
        ++found[index];
    EXPECT_EQ(found, expected) << example.name;
  }
}

TEST(Subdivide_saddle_faces, appends)
{
  const Solved_example<> solved(smf_test::theta_example());
  Mesh both = smf_test::octahedron();
  SMF::subdivide_saddle_faces(solved.foliation, both);
  EXPECT_EQ(num_vertices(both), num_vertices(Split_mesh(solved.foliation).mesh) + 6);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(both));
}

// ===  Critical leaves

TEST_P(Singularities_of_example, critical_leaves_are_the_constrained_edges)
{
  std::vector<Critical_polyline> polylines;
  SMF::critical_leaves(foliation, std::back_inserter(polylines));
  double total = 0, expected = 0;
  for (const Critical_polyline& polyline : polylines)
    total += length(polyline.points);
  Mesh cut;
  const auto is_critical = cut.add_property_map<Mesh::Edge_index, bool>("e:critical").first;
  SMF::surface_components(foliation, cut, CGAL::parameters::edge_is_constrained_map(is_critical));
  for (const auto e : edges(cut))
    if (is_critical[e])
      expected += distance(cut.point(cut.vertex(e, 0)), cut.point(cut.vertex(e, 1)));
  EXPECT_NEAR(total, expected, 1e-12 * expected);
}

TEST_P(Singularities_of_example, critical_leaves_are_connected)
{
  std::vector<Critical_polyline> polylines;
  SMF::critical_leaves(foliation, std::back_inserter(polylines));
  std::map<std::size_t, std::vector<const Critical_polyline*>> of_node;
  for (const Critical_polyline& polyline : polylines)
  {
    ASSERT_LT(polyline.node, system.number_of_nodes());
    ASSERT_GE(polyline.points.size(), 1u);
    of_node[polyline.node].push_back(&polyline);
  }
  ASSERT_EQ(of_node.size(), system.number_of_nodes());
  for (const auto& [node, its_polylines] : of_node)
  {
    std::map<Point, std::size_t> ends; // with a number for each
    for (const Critical_polyline* polyline : its_polylines)
      for (const Point& p : {polyline->points.front(), polyline->points.back()})
        ends.emplace(p, ends.size());
    boost::disjoint_sets_with_storage<> sets(ends.size());
    for (const Critical_polyline* polyline : its_polylines)
      sets.union_set(ends[polyline->points.front()], ends[polyline->points.back()]);
    for (std::size_t i = 1; i < ends.size(); ++i)
      EXPECT_EQ(sets.find_set(i), sets.find_set(0)) << "node " << node;
  }
}

TEST_P(Singularities_of_example, critical_leaves_of_poles_are_the_poles)
{
  std::vector<Critical_polyline> polylines;
  SMF::critical_leaves(foliation, std::back_inserter(polylines));
  for (const Critical_polyline& polyline : polylines)
  {
    const int pole = system.pole(polyline.node);
    if (pole < 0)
    {
      EXPECT_GT(length(polyline.points), 0);
      continue;
    }
    Polyline expected;
    for (const auto v : system.pole_vertices(static_cast<std::size_t>(pole)))
      expected.push_back(mesh.point(v));
    if (expected.front() != polyline.points.front())
      std::reverse(expected.begin(), expected.end());
    EXPECT_EQ(polyline.points, expected);
  }
}

TEST(Critical_leaves, without_singularity_is_one_closed_polyline)
{
  const Solved_example<> example(
    {"", soups::torus(14, 9, 3, 1), {{Item::CYCLE, smf_test::meridian(3, 9), 2.5}}});
  std::vector<Singularity> singularities;
  SMF::singularities(example.foliation, std::back_inserter(singularities));
  EXPECT_TRUE(singularities.empty());
  std::vector<Critical_polyline> polylines;
  SMF::critical_leaves(example.foliation, std::back_inserter(polylines));
  ASSERT_EQ(polylines.size(), 1u);
  EXPECT_EQ(polylines[0].points.front(), polylines[0].points.back());
  EXPECT_NEAR(length(polylines[0].points), 6.28, 0.5); // once around the tube
}

} // namespace

} // namespace test_singularities
