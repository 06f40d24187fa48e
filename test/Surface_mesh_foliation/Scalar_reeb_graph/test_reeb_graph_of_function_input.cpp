// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The input of reeb_graph_of_function(): what it refuses, and the flat surface that it makes of a
// mesh.

#include "include/random_functions.h"
#include "include/scalar_reeb_graphs.h"
#include "generators/meshes.h"
#include "generators/soups.h"

#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Mesh_index.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/flat_surface.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_of_function.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/property_map.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace test_reeb_graph_of_function_input {

namespace {

using smf_test::Mesh;
using smf_test::reeb_graph;
using smf_test::Surface;
using smf_test::surfaces;
using smf_test::Triangle_soup;
using smf_test::vertex;
namespace SMF = CGAL::Surface_mesh_foliation;
namespace smf_np = CGAL::Surface_mesh_foliation::parameters;
namespace soups = smf_test::soups;

using Values = std::vector<double>;

// ===  Refusals

template <class Exception, class Run>
SMF::Problem refusal(const Run& run)
{
  try
  {
    run();
    ADD_FAILURE() << "it is accepted";
  }
  catch (const Exception& exception)
  {
    return exception.problem();
  }
  return {};
}

TEST(Reeb_graph_of_function_input, refuses_values_that_are_not_finite)
{
  const Mesh mesh = smf_test::icosphere(1);
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()})
  {
    Values values(num_vertices(mesh), 1);
    values[17] = values[20] = bad;
    const SMF::Problem problem =
      refusal<SMF::Invalid_parameter_exception>([&] { reeb_graph(mesh, values); });
    EXPECT_EQ(problem.kind, SMF::Problem_kind::NOT_FINITE);
    EXPECT_EQ(problem.vertices, std::vector<std::size_t>{17});
    EXPECT_NE(problem.message.find("vertex 17"), std::string::npos) << problem.message;
  }
}

TEST(Reeb_graph_of_function_input, refuses_a_persistence_that_is_no_length)
{
  const Mesh mesh = smf_test::icosphere(1);
  const Values values(num_vertices(mesh), 1);
  for (const double bad : {-1e-300, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_EQ(refusal<SMF::Invalid_parameter_exception>([&] {
                reeb_graph(mesh, values, smf_np::persistence(bad));
              }).kind,
              SMF::Problem_kind::INVALID_PARAMETER);
}

void expect_refusal(const Mesh& mesh, SMF::Problem_kind kind)
{
  SMF::Scalar_reeb_graph<Mesh> graph;
  const CGAL::Constant_property_map<Mesh::Vertex_index, double> constant(1);
  EXPECT_EQ(refusal<SMF::Invalid_mesh_exception>([&] {
              SMF::reeb_graph_of_function(mesh, constant, graph);
            }).kind,
            kind);
  EXPECT_EQ(num_vertices(graph), 0u) << "nothing has been appended";
}

Mesh two_triangles_back_to_back()
{
  Mesh mesh;
  const auto a = mesh.add_vertex(Mesh::Point(0, 0, 0)), b = mesh.add_vertex(Mesh::Point(1, 0, 0)),
             c = mesh.add_vertex(Mesh::Point(0, 1, 0));
  mesh.add_face(a, b, c);
  mesh.add_face(a, c, b);
  return mesh;
}

TEST(Reeb_graph_of_function_input, refuses_what_is_no_closed_connected_triangle_mesh)
{
  using Problem = SMF::Problem_kind;
  expect_refusal(Mesh(), Problem::EMPTY_MESH);
  Mesh open = smf_test::icosphere(1);
  CGAL::Euler::remove_face(halfedge(*faces(open).begin(), open), open);
  expect_refusal(open, Problem::NOT_CLOSED);
  Mesh two = smf_test::tetrahedron();
  two += smf_test::octahedron();
  expect_refusal(two, Problem::NOT_CONNECTED);
  Mesh isolated = smf_test::tetrahedron();
  isolated.add_vertex(Mesh::Point(5, 5, 0));
  expect_refusal(isolated, Problem::ISOLATED_VERTEX);
  Mesh quads = smf_test::tetrahedron();
  CGAL::Euler::join_face(halfedge(*edges(quads).begin(), quads), quads);
  expect_refusal(quads, Problem::NOT_TRIANGLE_MESH);
  expect_refusal(two_triangles_back_to_back(), Problem::NOT_MANIFOLD);
}

// a tetrahedron and an octahedron with a common vertex
Mesh two_umbrellas()
{
  Mesh mesh = smf_test::tetrahedron();
  mesh += smf_test::octahedron();
  const auto first = vertex(0), second = vertex(4);
  const auto spokes = CGAL::halfedges_around_target(second, mesh);
  for (const auto h : std::vector<Mesh::Halfedge_index>(spokes.begin(), spokes.end()))
    mesh.set_target(h, first);
  mesh.remove_vertex(second);
  return mesh;
}

TEST(Reeb_graph_of_function_input, refuses_a_vertex_with_two_umbrellas)
{
  expect_refusal(two_umbrellas(), SMF::Problem_kind::NOT_MANIFOLD);
}

TEST(Reeb_graph_of_function_input, refuses_a_slit)
{
  Mesh mesh = smf_test::octahedron();
  const auto side = *halfedges(mesh).begin(), other_side = mesh.add_edge();
  const auto back = opposite(other_side, mesh), before = prev(side, mesh),
             behind = next(side, mesh);
  mesh.set_target(other_side, target(side, mesh));
  mesh.set_target(back, source(side, mesh));
  mesh.set_next(before, other_side);
  mesh.set_next(other_side, behind);
  mesh.set_face(other_side, face(side, mesh));
  mesh.set_halfedge(face(side, mesh), other_side);
  mesh.set_next(side, back); // around the slit
  mesh.set_next(back, side);
  mesh.set_face(side, Mesh::null_face());
  ASSERT_TRUE(mesh.is_valid());
  expect_refusal(mesh, SMF::Problem_kind::NOT_CLOSED);
}

// ===  Flat surfaces

using Flat_triangles = std::vector<SMF::internal::Triangle>;

Flat_triangles flat_triangles(const Triangle_soup& soup)
{
  Flat_triangles result;
  for (const auto& [a, b, c] : soup.triangles)
    result.push_back({static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)});
  return result;
}

void expect_flat_surface(const Mesh& mesh, const Triangle_soup& soup)
{
  const SMF::internal::Mesh_index<Mesh> index(mesh);
  const SMF::internal::Flat_mesh flat = SMF::internal::flat_surface(index);
  const std::vector<SMF::internal::Point> origins(soup.points.size(), {{0, 0, 0}});
  const SMF::internal::Flat_mesh expected(origins, flat_triangles(soup));
  EXPECT_EQ(flat.points(), origins);
  EXPECT_EQ(flat.number_of_faces(), expected.number_of_faces());
  ASSERT_EQ(flat.number_of_halfedges(), expected.number_of_halfedges());
  for (int h = 0; h < flat.number_of_halfedges(); ++h)
  {
    EXPECT_EQ(flat.source(h), expected.source(h));
    EXPECT_EQ(flat.target(h), expected.target(h));
    EXPECT_EQ(flat.next(h), expected.next(h));
    EXPECT_EQ(flat.face(h), expected.face(h));
  }
}

TEST(Flat_surface, is_the_connectivity_of_the_mesh)
{
  for (const Surface& surface : surfaces())
    expect_flat_surface(surface.mesh, surface.soup);
  Mesh mesh = smf_test::tetrahedron(); // is removed again, but leaves its numbers
  mesh += smf_test::to_mesh(soups::torus(7, 5, 3, 1));
  for (int f = 0; f < 4; ++f)
    CGAL::Euler::remove_face(halfedge(Mesh::Face_index(f), mesh), mesh);
  expect_flat_surface(mesh, soups::torus(7, 5, 3, 1));
}

TEST(Flat_surface, edges_are_closed_with_one_face_on_each_side)
{
  using SMF::internal::are_edges_closed;
  const Flat_triangles closed = flat_triangles(soups::octahedron());
  EXPECT_TRUE(are_edges_closed(6, closed));
  for (std::size_t f = 0; f < closed.size(); ++f)
  {
    Flat_triangles hole = closed, reversed = closed, twice = closed;
    hole.erase(hole.begin() + static_cast<std::ptrdiff_t>(f));
    std::swap(reversed[f][0], reversed[f][1]);
    twice.push_back(closed[f]);
    for (const Flat_triangles& triangles : {hole, reversed, twice})
      EXPECT_FALSE(are_edges_closed(6, triangles)) << f;
  }
  // two tetrahedra with the common edge 0, 1: two faces on each side
  EXPECT_FALSE(are_edges_closed(
    6, {{0, 1, 2}, {1, 0, 3}, {1, 3, 2}, {0, 2, 3}, {0, 1, 4}, {1, 0, 5}, {1, 5, 4}, {0, 4, 5}}));
  // two faces back to back have closed edges
  EXPECT_TRUE(are_edges_closed(3, {{0, 1, 2}, {0, 2, 1}}));
}

bool has_manifold_vertices(const Mesh& mesh)
{
  const SMF::internal::Mesh_index<Mesh> index(mesh);
  std::vector<SMF::Problem> problems;
  const Triangle_soup soup = index.soup(SMF::internal::Origin_map(), problems);
  return SMF::internal::are_vertices_manifold(index, static_cast<int>(soup.points.size()),
                                              flat_triangles(soup));
}

TEST(Flat_surface, vertices_are_manifold_with_one_umbrella_of_three_faces)
{
  EXPECT_TRUE(has_manifold_vertices(smf_test::tetrahedron()));
  Mesh two = smf_test::tetrahedron();
  two += smf_test::octahedron();
  EXPECT_TRUE(has_manifold_vertices(two));
  EXPECT_FALSE(has_manifold_vertices(two_umbrellas()));
  EXPECT_FALSE(has_manifold_vertices(two_triangles_back_to_back()));
  two.add_vertex(Mesh::Point(5, 5, 0)); // isolated
  EXPECT_FALSE(has_manifold_vertices(two));
}

} // namespace

} // namespace test_reeb_graph_of_function_input
