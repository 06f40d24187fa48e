// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Coordinates in maps and meshes of several types, and by linear solvers of the user.

#include "include/example_systems.h"
#include "include/test_models.h"
#include "include/uv_mesh.h"

#include <CGAL/Surface_mesh_foliation/Component_coordinates.h>

#include <CGAL/boost/graph/iterator.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace test_coordinates_in_maps {

namespace {

using smf_test::areas;
using smf_test::Example;
using smf_test::Mesh;
using smf_test::size_of;
using smf_test::Solved_example;
using smf_test::Uv;
using smf_test::Uv_mesh;
namespace SMF = CGAL::Surface_mesh_foliation;

using Coordinates = SMF::Component_coordinates<Mesh>;

} // namespace

// ===  Values of maps

TEST(Component_coordinates, go_into_maps_of_any_pairs)
{
  for (const Example& example :
       {smf_test::theta_example(), smf_test::dumbbell_example(), smf_test::example_systems()[0]})
  {
    const Solved_example<> solved(example);
    const Coordinates coordinates(solved.foliation);
    const Uv_mesh expected(coordinates);
    using Point_2 = smf_test::Kernel::Point_2;
    using Pair = std::pair<double, double>;
    Mesh output, other;
    const auto points = output.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;
    const auto pairs = other.add_property_map<Mesh::Halfedge_index, Pair>("h:uv").first;
    coordinates.uv_mesh(output, points);
    coordinates.uv_mesh(other, pairs);
    for (const auto h : halfedges(output))
      if (expected.has_coordinates(face(h, output)))
      {
        EXPECT_EQ(points[h], Point_2(expected.uv[h][0], expected.uv[h][1]));
        EXPECT_EQ(pairs[h], Pair(expected.uv[h][0], expected.uv[h][1]));
      }
    for (std::size_t a = 0; a < solved.system.number_of_arcs(); ++a)
    {
      Mesh chart;
      CGAL::Surface_mesh<Point_2> flat_chart;
      coordinates.chart(a, chart);
      coordinates.chart(a, flat_chart);
      ASSERT_EQ(num_vertices(flat_chart), num_vertices(chart));
      EXPECT_EQ(num_faces(flat_chart), num_faces(chart));
      for (const auto v : vertices(chart))
        EXPECT_EQ(flat_chart.point(v), Point_2(chart.point(v).x(), chart.point(v).y()));
    }
  }
}

// ===  Models of meshes

template <class TriangleMesh>
class Coordinates_on : public ::testing::Test
{};

using Models = ::testing::Types<smf_test::Surface_mesh_model<smf_test::Kernel>,
                                smf_test::Polyhedron_model<smf_test::Kernel>,
                                smf_test::Linear_cell_complex_model<smf_test::Kernel>>;

// the last argument is empty, so that a comma is needed
TYPED_TEST_SUITE(Coordinates_on, Models, );

TYPED_TEST(Coordinates_on, all_models_are_equal)
{
  for (const Example& example :
       {smf_test::example_systems()[0], smf_test::theta_example(), smf_test::example_systems()[8]})
  {
    const Solved_example<> expected_example(example);
    const Coordinates expected(expected_example.foliation);
    const Uv_mesh expected_mesh(expected);
    std::vector<Uv> expected_uv;
    for (const auto f : faces(expected_mesh.mesh))
      for (const auto h :
           CGAL::halfedges_around_face(halfedge(f, expected_mesh.mesh), expected_mesh.mesh))
        expected_uv.push_back(expected_mesh.uv[h]);

    // not a Solved_example: a cell complex that is moved has its vertices in another order
    const TypeParam mesh = smf_test::to_mesh<TypeParam>(example.soup);
    const SMF::Loop_system<TypeParam> system(mesh, smf_test::poles_and_loops(example.items, mesh));
    const auto foliation = SMF::harmonic_foliation(system);
    const SMF::Component_coordinates<TypeParam> coordinates(foliation);
    TypeParam output;
    const auto uv = get(CGAL::dynamic_halfedge_property_t<Uv>(), output);
    coordinates.uv_mesh(output, uv);
    std::size_t i = 0;
    for (const auto f : faces(output))
      for (const auto h : CGAL::halfedges_around_face(halfedge(f, output), output))
      {
        EXPECT_EQ(get(uv, h), expected_uv.at(i)) << example.name;
        ++i;
      }
    EXPECT_EQ(i, expected_uv.size());
    for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
    {
      Mesh expected_chart;
      TypeParam chart;
      expected.chart(a, expected_chart);
      coordinates.chart(a, chart);
      EXPECT_EQ(num_faces(chart), num_faces(expected_chart));
      EXPECT_EQ(num_vertices(chart), num_vertices(expected_chart));
      EXPECT_NEAR(areas(chart)[0], size_of(expected_example.foliation, a),
                  1e-12 * size_of(expected_example.foliation, a));
      EXPECT_GT(areas(chart)[1], 0);
    }
  }
}

// ===  The linear solver

TEST(Component_coordinates, by_a_solver_of_the_user)
{
  const Solved_example<> solved(smf_test::theta_example());
  SMF::Supernodal_cholesky_solver solver;
  const Uv_mesh by_default((Coordinates(solved.foliation)));
  const Uv_mesh by_solver(
    Coordinates(solved.foliation, CGAL::parameters::sparse_linear_solver(std::ref(solver))));
  for (const auto h : halfedges(by_default.mesh))
    EXPECT_EQ(by_default.uv[h], by_solver.uv[h]);
}

struct Failing_solver
{
  void analyze_pattern(const Eigen::SparseMatrix<double>&) {}
  bool factorize(const Eigen::SparseMatrix<double>&) { return false; }
  Eigen::VectorXd solve(const Eigen::VectorXd& b) { return b; }
};

struct Infinite_solver
{
  void analyze_pattern(const Eigen::SparseMatrix<double>&) {}
  bool factorize(const Eigen::SparseMatrix<double>&) { return true; }
  Eigen::VectorXd solve(const Eigen::VectorXd& b)
  {
    return Eigen::VectorXd::Constant(b.size(), std::numeric_limits<double>::infinity());
  }
};

template <class LinearSolver>
void expect_failure()
{
  const Solved_example<> solved(smf_test::theta_example());
  LinearSolver solver;
  EXPECT_THROW(
    Coordinates(solved.foliation, CGAL::parameters::sparse_linear_solver(std::ref(solver))),
    SMF::Solver_exception);
}

TEST(Component_coordinates, report_a_solver_that_fails)
{
  expect_failure<Failing_solver>();
  expect_failure<Infinite_solver>();
}

} // namespace test_coordinates_in_maps
