// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Conjugate gradients with BoomerAMG give the foliations of the default solver, and say when they
// do not come to an end. Built where hypre and MPI are installed.

#include <CGAL/Surface_mesh_foliation/Boomer_amg_solver.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Hypre_objects.h>

#include "include/edge_value_difference.h"
#include "generators/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace test_boomer_amg_solver {

using namespace smf_test;
namespace SMF = CGAL::Surface_mesh_foliation;

namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

// The lower triangle of the Laplacian of a mesh plus a small diagonal, with every 50th vertex
// decoupled by zeros, and with each 7th one oriented the other way.
Matrix signed_laplacian(const Mesh& mesh)
{
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto v : vertices(mesh))
    entries.emplace_back(static_cast<int>(v), static_cast<int>(v), 1e-4);
  for (const auto e : edges(mesh))
  {
    const int u = static_cast<int>(source(e, mesh)), v = static_cast<int>(target(e, mesh));
    const bool is_coupled = u % 50 != 0 && v % 50 != 0, is_turned = (u % 7 == 0) != (v % 7 == 0);
    entries.emplace_back(std::max(u, v), std::min(u, v), is_coupled ? is_turned ? 1 : -1 : 0);
    entries.emplace_back(u, u, 1);
    entries.emplace_back(v, v, 1);
  }
  const int n = static_cast<int>(num_vertices(mesh));
  Matrix result(n, n);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

double relative_residual(const Matrix& lower_triangle, const Vector& solution, const Vector& b)
{
  return (lower_triangle.selfadjointView<Eigen::Lower>() * solution - b).norm() / b.norm();
}

std::vector<Mesh> meshes()
{
  return {tetrahedron(), icosphere(4), torus(40, 24, 3, 1), genus_surface(5, 4, 3)};
}

SMF::Loop_system<Mesh> with_four_poles(const Mesh& mesh)
{
  SMF::Poles_and_loops<Mesh> input;
  for (std::size_t i = 0; i < 4; ++i)
    input.add_pole(vertex(i * (num_vertices(mesh) - 1) / 3));
  return SMF::Loop_system<Mesh>(mesh, input);
}

} // namespace

TEST(Boomer_amg_solver, solves_to_its_tolerance)
{
  for (const Mesh& mesh : meshes())
  {
    const Matrix matrix = signed_laplacian(mesh);
    const Vector b = Vector::LinSpaced(matrix.rows(), -1, 2);
    for (double tolerance : {1e-3, 1e-12})
    {
      SMF::Boomer_amg_solver solver(tolerance);
      solver.analyze_pattern(matrix);
      ASSERT_TRUE(solver.factorize(matrix));
      EXPECT_LT(relative_residual(matrix, solver.solve(b), b), 1.1 * tolerance);
      EXPECT_GT(solver.number_of_iterations(), 0);
      EXPECT_LT(solver.number_of_iterations(), 40);
    }
  }
}

TEST(Boomer_amg_solver, equal_systems_have_equal_solutions)
{
  const Matrix matrix = signed_laplacian(torus(40, 24, 3, 1));
  const Vector b = Vector::LinSpaced(matrix.rows(), -1, 2);
  SMF::Boomer_amg_solver used, fresh;
  ASSERT_TRUE(used.factorize(2 * matrix));
  used.solve(b.reverse());
  ASSERT_TRUE(used.factorize(matrix));
  used.solve(b.reverse());
  ASSERT_TRUE(fresh.factorize(matrix));
  EXPECT_EQ(used.solve(b), fresh.solve(b));
}

TEST(Boomer_amg_solver, systems_without_coupling_or_without_right_side)
{
  Matrix diagonal(3, 3);
  for (int i = 0; i < 3; ++i)
    diagonal.insert(i, i) = i + 1;
  diagonal.makeCompressed();
  SMF::Boomer_amg_solver solver;
  ASSERT_TRUE(solver.factorize(diagonal));
  EXPECT_LT((solver.solve(Eigen::Vector3d(1, 2, 3)) - Vector::Ones(3)).norm(), 1e-10);
  EXPECT_EQ(solver.solve(Vector::Zero(3)), Vector::Zero(3));
  EXPECT_EQ(solver.number_of_iterations(), 0);
}

TEST(Boomer_amg_solver, turning_vertices_saves_iterations)
{
  const Matrix matrix = signed_laplacian(icosphere(4));
  Matrix unsigned_matrix = matrix;
  for (int j = 0; j < matrix.cols(); ++j)
    for (Matrix::InnerIterator it(unsigned_matrix, j); it; ++it)
      if (it.row() != j)
        it.valueRef() = -std::abs(it.value());
  const Vector b = Vector::Unit(matrix.rows(), 1);
  SMF::Boomer_amg_solver solver;
  ASSERT_TRUE(solver.factorize(unsigned_matrix));
  solver.solve(b);
  const int iterations = solver.number_of_iterations();
  ASSERT_TRUE(solver.factorize(matrix));
  solver.solve(b);
  EXPECT_EQ(solver.number_of_iterations(), iterations);
}

TEST(Boomer_amg_solver, matrices_that_cannot_be_used_are_reported)
{
  Matrix matrix = signed_laplacian(icosphere(2));
  SMF::Boomer_amg_solver solver;
  EXPECT_TRUE(solver.factorize(matrix));
  for (double wrong :
       {-1., 0., std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
  {
    Matrix copy = matrix;
    copy.coeffRef(3, 3) = wrong;
    EXPECT_FALSE(solver.factorize(copy)) << wrong;
  }
  EXPECT_FALSE(solver.factorize(Matrix()));
  EXPECT_TRUE(solver.factorize(matrix));
}

TEST(Boomer_amg_solver, too_few_iterations_are_reported)
{
  const Matrix matrix = signed_laplacian(icosphere(4));
  const Vector b = Vector::LinSpaced(matrix.rows(), -1, 2);
  SMF::Boomer_amg_solver solver(1e-12, 2);
  ASSERT_TRUE(solver.factorize(matrix));
  try
  {
    solver.solve(b);
    ADD_FAILURE() << "solved in two iterations";
  }
  catch (const SMF::Solver_exception& exception)
  {
    EXPECT_EQ(exception.problem().kind, SMF::Problem_kind::SOLVER_FAILURE);
    EXPECT_NE(exception.problem().message.find("after 2 iterations"), std::string::npos)
      << exception.problem().message;
  }
  EXPECT_THROW(solver.solve(b / 0.), SMF::Solver_exception);
  // hypre forgets its errors
  SMF::Boomer_amg_solver patient(1e-12);
  ASSERT_TRUE(patient.factorize(matrix));
  EXPECT_LT(relative_residual(matrix, patient.solve(b), b), 1e-11);

  const Mesh mesh = icosphere(4);
  EXPECT_THROW(SMF::harmonic_foliation(with_four_poles(mesh),
                                       CGAL::parameters::sparse_linear_solver(std::ref(solver))),
               SMF::Solver_exception);
}

// one eigenvalue is negative: 1 - 2
TEST(Boomer_amg_solver, a_matrix_that_is_not_positive_definite_gives_no_wrong_solution)
{
  Matrix matrix(2, 2);
  matrix.insert(0, 0) = 1;
  matrix.insert(1, 0) = 2;
  matrix.insert(1, 1) = 1;
  matrix.makeCompressed();
  SMF::Boomer_amg_solver solver;
  const Vector b = Eigen::Vector2d(1, 5);
  try
  {
    if (solver.factorize(matrix))
    {
      EXPECT_LT(relative_residual(matrix, solver.solve(b), b), 1e-9);
    }
  }
  catch (const SMF::Solver_exception&)
  {}
}

TEST(Boomer_amg_solver, parameters_out_of_range_are_refused)
{
  for (double tolerance : {0., -1., 1., std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(SMF::Boomer_amg_solver{tolerance}, SMF::Invalid_parameter_exception);
  EXPECT_THROW(SMF::Boomer_amg_solver(1e-6, 0), SMF::Invalid_parameter_exception);
  const SMF::Boomer_amg_solver solver(1e-6, 7);
  EXPECT_EQ(solver.tolerance(), 1e-6);
  EXPECT_EQ(solver.max_iterations(), 7);
}

TEST(Boomer_amg_solver, foliations_are_those_of_the_default_solver)
{
  for (const Mesh& mesh : meshes())
  {
    const SMF::Loop_system<Mesh> system = with_four_poles(mesh);
    const auto expected = SMF::harmonic_foliation(system);
    for (double tolerance : {1e-2, 1e-10})
    {
      SMF::Boomer_amg_solver solver(tolerance);
      const auto foliation =
        SMF::harmonic_foliation(system, CGAL::parameters::sparse_linear_solver(std::ref(solver)));
      EXPECT_TRUE(foliation.statistics().has_converged);
      EXPECT_TRUE(foliation.statistics().is_certified);
      EXPECT_LT(difference(foliation, expected), 1e-10);
    }
  }
}

} // namespace test_boomer_amg_solver
