// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/model_summary.h"
#include "include/test_models.h"
#include "include/wrapped_mesh.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/Graph_with_descriptor_with_graph.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

namespace test_mesh_models {

// The same results on all types of meshes; for the kernels see test_kernels.cpp.

namespace {

using smf_test::Example;
using smf_test::Item;
using smf_test::Mesh;
using smf_test::Summary;
namespace SMF = CGAL::Surface_mesh_foliation;
namespace soups = smf_test::soups;

template <class TriangleMesh>
class Mesh_models : public ::testing::Test
{};

using Models = ::testing::Types<smf_test::Polyhedron_model<smf_test::Kernel>,
                                smf_test::Linear_cell_complex_model<smf_test::Kernel>,
                                smf_test::Surface_mesh_model<CGAL::Simple_cartesian<double>>>;
TYPED_TEST_SUITE(Mesh_models, Models);

TYPED_TEST(Mesh_models, give_equal_results)
{
  for (const Example& example : smf_test::examples_for_models())
  {
    SCOPED_TRACE(example.name);
    const TypeParam mesh = smf_test::to_mesh<TypeParam>(example.soup);
    TypeParam output;
    expect_equal(smf_test::summary(mesh, example.items, output),
                 smf_test::expected_summary(example));
  }
}

// ===  Meshes of one type

TEST(Surface_mesh, points_come_through_the_named_parameter_only)
{
  for (const Example& example : smf_test::examples_for_models())
  {
    SCOPED_TRACE(example.name);
    Mesh mesh = smf_test::to_mesh(example.soup);
    const auto points = mesh.add_property_map<Mesh::Vertex_index, Mesh::Point>("v:other").first;
    for (const auto v : vertices(mesh))
    {
      points[v] = mesh.point(v);
      mesh.point(v) = CGAL::ORIGIN; // whoever looks here sees degenerate faces
    }
    Mesh output;
    expect_equal(
      smf_test::summary(mesh, example.items, output, CGAL::parameters::vertex_point_map(points)),
      smf_test::expected_summary(example));
  }
}

TEST(Surface_mesh, with_removed_elements_at_the_beginning)
{
  for (const Example& example : smf_test::examples_for_models())
  {
    SCOPED_TRACE(example.name);
    Mesh mesh = smf_test::octahedron();
    const Mesh octahedron = mesh;
    std::vector<Mesh::Vertex_index> added;
    for (const auto& p : example.soup.points)
      added.push_back(mesh.add_vertex(Mesh::Point(p[0], p[1], p[2])));
    for (const auto& [a, b, c] : example.soup.triangles)
      mesh.add_face(added[b], added[c], added[a]); // `halfedge(f)` goes from a to b
    for (const auto f : faces(octahedron))
      mesh.remove_face(f);
    for (const auto e : edges(octahedron))
      mesh.remove_edge(e);
    for (const auto v : vertices(octahedron))
      mesh.remove_vertex(v);
    ASSERT_TRUE(mesh.has_garbage());
    ASSERT_EQ(mesh.number_of_vertices(), example.soup.points.size());
    Mesh output;
    expect_equal(smf_test::summary(mesh, example.items, output),
                 smf_test::expected_summary(example));
  }
}

// a mesh after edge collapses, and the same elements in the same order without gaps
struct Collapsed_mesh
{
  Collapsed_mesh() : mesh(smf_test::icosphere(3))
  {
    const std::vector<Mesh::Edge_index> all(edges(mesh).begin(), edges(mesh).end());
    for (std::size_t i = 0; i < all.size(); i += 7)
      if (!mesh.is_removed(all[i]) && CGAL::Euler::does_satisfy_link_condition(all[i], mesh))
        CGAL::Euler::collapse_edge(all[i], mesh);
    std::vector<std::size_t> position(mesh.number_of_vertices() +
                                      mesh.number_of_removed_vertices());
    for (const auto v : vertices(mesh))
    {
      position[v] = soup.points.size();
      soup.points.push_back({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
    }
    for (const auto f : faces(mesh))
    {
      const auto h = halfedge(f, mesh); // a soup's triangle begins where `halfedge(f)` starts
      soup.triangles.push_back({position[source(h, mesh)], position[target(h, mesh)],
                                position[target(next(h, mesh), mesh)]});
    }
  }

  Mesh mesh;
  smf_test::Triangle_soup soup;
};

TEST(Surface_mesh, with_removed_elements_all_over)
{
  const Collapsed_mesh collapsed;
  ASSERT_TRUE(collapsed.mesh.has_garbage());
  ASSERT_LT(collapsed.mesh.number_of_vertices(), 600u);
  const std::size_t last = collapsed.soup.points.size() - 1;
  const Example example = {
    "", collapsed.soup, {{Item::POLE, {0}}, {Item::POLE, {last / 2}, 3}, {Item::POLE, {last}}}};
  Mesh output;
  expect_equal(smf_test::summary(collapsed.mesh, example.items, output),
               smf_test::expected_summary(example));
}

// ===  Descriptors never meet the wrong mesh

TEST(Descriptors, belong_to_their_mesh)
{
  using Wrapper = smf_test::Wrapped_mesh<Mesh::Point>; // asserts that
  for (const Example& example : smf_test::examples_for_models())
  {
    SCOPED_TRACE(example.name);
    Mesh mesh = smf_test::to_mesh(example.soup), output_mesh;
    const Wrapper wrapper(mesh);
    Wrapper output(output_mesh);
    expect_equal(smf_test::summary(wrapper, example.items, output),
                 smf_test::expected_summary(example));
  }
}

TEST(Descriptors, wrapper_detects_the_wrong_mesh)
{
  using Wrapper = smf_test::Wrapped_mesh<Mesh::Point>;
  Mesh first = smf_test::octahedron(), second = smf_test::octahedron();
  const Wrapper one(first), other(second);
  EXPECT_ANY_THROW(halfedge(*vertices(one).begin(), other))
    << "so that the test above means something";
}

} // namespace

} // namespace test_mesh_models
