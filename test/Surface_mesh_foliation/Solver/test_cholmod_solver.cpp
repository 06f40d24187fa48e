// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// CHOLMOD's factorization gives the foliations of the default solver, and its access to the factor
// is what UpdatableFoliationLinearSolver asks for. Built where SuiteSparse is installed.

#include <CGAL/Surface_mesh_foliation/Cholmod_solver.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>

#include "generators/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace test_cholmod_solver {

using namespace smf_test;
namespace SMF = CGAL::Surface_mesh_foliation;

namespace {

// the Laplacian of a mesh plus a small diagonal: its lower triangle
Eigen::SparseMatrix<double> laplacian(const Mesh& mesh)
{
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto v : vertices(mesh))
    entries.emplace_back(static_cast<int>(v), static_cast<int>(v), 1e-2);
  for (const auto e : edges(mesh))
  {
    const int u = static_cast<int>(source(e, mesh)), v = static_cast<int>(target(e, mesh));
    entries.emplace_back(std::max(u, v), std::min(u, v), -1);
    entries.emplace_back(u, u, 1);
    entries.emplace_back(v, v, 1);
  }
  const int n = static_cast<int>(num_vertices(mesh));
  Eigen::SparseMatrix<double> result(n, n);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

std::vector<Mesh> meshes()
{
  return {tetrahedron(), icosphere(4), torus(40, 24, 3, 1), genus_surface(5, 4, 3)};
}

} // namespace

TEST(Cholmod_solver, halves_are_those_of_the_factorization)
{
  for (const Mesh& mesh : meshes())
  {
    const Eigen::SparseMatrix<double> matrix = laplacian(mesh);
    SMF::Cholmod_solver solver;
    solver.analyze_pattern(matrix);
    ASSERT_TRUE(solver.factorize(matrix));
    const int n = static_cast<int>(matrix.rows());
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(n, -1, 2);
    const Eigen::VectorXd residual = matrix.selfadjointView<Eigen::Lower>() * solver.solve(b) - b;
    EXPECT_LT(residual.cwiseAbs().maxCoeff(), 1e-11);

    const std::vector<int> unknowns = {0, n / 2, n - 1};
    const std::vector<int> rows = solver.forward_rows(unknowns);
    EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end()));
    const Eigen::MatrixXd columns = solver.forward_columns(unknowns, rows);
    for (std::size_t k = 0; k < unknowns.size(); ++k)
    {
      Eigen::VectorXd all = solver.forward(Eigen::VectorXd::Unit(n, unknowns[k]));
      for (std::size_t i = 0; i < rows.size(); ++i)
      {
        EXPECT_NEAR(columns(static_cast<int>(i), static_cast<int>(k)), all[rows[i]], 1e-14);
        all[rows[i]] = 0;
      }
      EXPECT_EQ(all.cwiseAbs().maxCoeff(), 0); // nothing but these rows
    }
    EXPECT_GT(solver.work_of_factorization(), 0);
  }
}

TEST(Cholmod_solver, updates_solve_the_changed_system)
{
  for (const Mesh& mesh : meshes())
  {
    if (num_vertices(mesh) < 100)
      continue; // there a factorization is less work
    Eigen::SparseMatrix<double> matrix = laplacian(mesh);
    SMF::Cholmod_solver solver;
    solver.analyze_pattern(matrix);
    ASSERT_TRUE(solver.factorize(matrix));
    const auto e = *std::next(edges(mesh).begin(), 77);
    const int u = static_cast<int>(source(e, mesh)), v = static_cast<int>(target(e, mesh));
    SMF::internal::Matrix_change change;
    change.entries.push_back({std::max(u, v), std::min(u, v), 2});
    matrix.coeffRef(std::max(u, v), std::min(u, v)) += 2;
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(matrix.rows(), 2, -1);
    const auto x = SMF::internal::Updated_solutions(solver)(b, change);
    ASSERT_TRUE(x.has_value());
    const Eigen::VectorXd residual = matrix.selfadjointView<Eigen::Lower>() * *x - b;
    EXPECT_LT(residual.cwiseAbs().maxCoeff(), 1e-11);
  }
}

TEST(Cholmod_solver, a_matrix_that_is_not_positive_definite_is_reported)
{
  Eigen::SparseMatrix<double> matrix = laplacian(icosphere(2));
  SMF::Cholmod_solver solver;
  EXPECT_FALSE(solver.factorize(matrix)); // not analyzed
  solver.analyze_pattern(matrix);
  EXPECT_TRUE(solver.factorize(matrix));
  matrix.coeffRef(3, 3) = -1;
  EXPECT_FALSE(solver.factorize(matrix));
  matrix.coeffRef(3, 3) = 10;
  EXPECT_TRUE(solver.factorize(matrix));
}

TEST(Cholmod_solver, foliations_are_those_of_the_default_solver)
{
  for (const Mesh& mesh : meshes())
  {
    SMF::Poles_and_loops<Mesh> input;
    for (std::size_t i = 0; i < 4; ++i)
      input.add_pole(vertex(i * (num_vertices(mesh) - 1) / 3));
    const SMF::Loop_system<Mesh> system(mesh, input);
    SMF::Cholmod_solver solver;
    const auto a = SMF::harmonic_foliation(system);
    const auto b =
      SMF::harmonic_foliation(system, CGAL::parameters::sparse_linear_solver(std::ref(solver)));
    EXPECT_TRUE(b.statistics().has_converged);
    double largest = 0, difference = 0;
    for (const auto e : edges(mesh))
    {
      largest = std::max(largest, a.edge_value(e));
      difference = std::max(difference, std::abs(a.edge_value(e) - b.edge_value(e)));
    }
    EXPECT_LT(difference, 1e-11 * largest);
  }
}

} // namespace test_cholmod_solver
