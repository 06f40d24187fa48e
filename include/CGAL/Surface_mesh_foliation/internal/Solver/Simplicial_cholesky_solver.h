// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_SIMPLICIAL_CHOLESKY_SOLVER_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_SIMPLICIAL_CHOLESKY_SOLVER_H

#include <Eigen/Core>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <memory>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationLinearSolvers
\smfHeader{Solver/Simplicial_cholesky_solver.h,Simplicial_cholesky_solver.h}

is `Eigen::SimplicialLDLT`: \f$ A = P^T L D L^T P \f$ with a column-by-column factorization and the
approximate minimum degree ordering. `Supernodal_cholesky_solver`, the default, is faster on all but
the smallest meshes.

It is a model of `UpdatableFoliationLinearSolver`.
*/
class Simplicial_cholesky_solver
{
public:
  /// \cond SKIP_IN_MANUAL
  using Matrix = Eigen::SparseMatrix<double>;
  using Vector = Eigen::VectorXd;
  using Row_matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  void analyze_pattern(const Matrix& matrix) { m_ldlt->analyzePattern(matrix); }

  bool factorize(const Matrix& matrix)
  {
    m_ldlt->factorize(matrix);
    m_pivots = m_ldlt->vectorD();
    return m_ldlt->info() == Eigen::Success;
  }

  Vector solve(const Vector& right_side) const { return backward(forward(right_side)); }

  Vector forward(const Vector& right_side) const
  {
    Vector result = m_ldlt->permutationP() * right_side;
    m_ldlt->matrixL().solveInPlace(result);
    return result;
  }

  Vector backward(Vector halfway) const
  {
    halfway.array() /= m_pivots.array();
    m_ldlt->matrixU().solveInPlace(halfway);
    return m_ldlt->permutationPinv() * halfway;
  }

  std::vector<int> forward_rows(const std::vector<int>& unknowns) const
  {
    std::vector<bool> is_reached(m_ldlt->rows(), false);
    std::vector<int> result;
    for (int unknown : unknowns)
      for (int j = row(unknown); j >= 0 && !is_reached[j]; j = parent(j))
      {
        is_reached[j] = true;
        result.push_back(j);
      }
    std::sort(result.begin(), result.end());
    return result;
  }

  Row_matrix forward_columns(const std::vector<int>& unknowns, const std::vector<int>& rows) const
  {
    std::vector<int> position(m_ldlt->rows(), -1);
    for (std::size_t i = 0; i < rows.size(); ++i)
      position[rows[i]] = static_cast<int>(i);
    Row_matrix result = Row_matrix::Zero(rows.size(), unknowns.size());
    for (std::size_t k = 0; k < unknowns.size(); ++k)
      result(position[row(unknowns[k])], k) = 1;
    const Matrix& l = factor();
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (Matrix::InnerIterator it(l, rows[i]); it; ++it)
        result.row(position[it.row()]) -= it.value() * result.row(i);
    return result;
  }

  double pivot(int row) const { return m_pivots[row]; }

  double work_of_factorization() const
  {
    double result = 0;
    for (int j = 0; j < m_ldlt->rows(); ++j)
      result += squared(column_size(j));
    return result;
  }

  double work_of_column(int row) const { return column_size(row); }

  void clear()
  {
    m_ldlt = std::make_unique<Factorization>();
    m_pivots = Vector();
  }
  /// \endcond

private:
  static double squared(double x) { return x * x; }

  // strictly below the diagonal, rows ascending
  const Matrix& factor() const { return m_ldlt->matrixL().nestedExpression(); }
  int row(int unknown) const { return m_ldlt->permutationP().indices()[unknown]; }
  int column_size(int j) const
  {
    return factor().outerIndexPtr()[j + 1] - factor().outerIndexPtr()[j];
  }

  // in the elimination tree; -1 at a root
  int parent(int j) const
  {
    return column_size(j) > 0 ? factor().innerIndexPtr()[factor().outerIndexPtr()[j]] : -1;
  }

  // The approximate minimum degree ordering, told that the matrix is symmetric, which
  // Eigen::AMDOrdering alone does not know in Eigen::SimplicialLDLT.
  struct Ordering
  {
    using PermutationType = Eigen::AMDOrdering<int>::PermutationType;
    void operator()(const Matrix& symmetric, PermutationType& permutation) const
    {
      Eigen::AMDOrdering<int>()(symmetric.selfadjointView<Eigen::Lower>(), permutation);
    }
  };

  using Factorization = Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Ordering>;

  std::unique_ptr<Factorization> m_ldlt = std::make_unique<Factorization>();
  Vector m_pivots;
};

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_SIMPLICIAL_CHOLESKY_SOLVER_H
