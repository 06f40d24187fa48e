// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_SUPERNODAL_CHOLESKY_SOLVER_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_SUPERNODAL_CHOLESKY_SOLVER_H

#include <CGAL/Surface_mesh_foliation/internal/Common/compiled.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/Executor.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Supernodal_factor.h>

#include <CGAL/tags.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationLinearSolvers
\smfHeader{Solver/Supernodal_cholesky_solver.h,Supernodal_cholesky_solver.h}

is the default linear solver: \f$ A = P^T L D L^T P \f$ with the approximate minimum degree
ordering, factored in dense blocks by the multifrontal method \cgalCite{dr-mssil-83}. It needs
nothing but Eigen, and its result does not depend on the number of threads.

It is a model of `UpdatableFoliationLinearSolver`.
*/
class Supernodal_cholesky_solver
{
public:
  /// \cond SKIP_IN_MANUAL
  using Matrix = Eigen::SparseMatrix<double>;
  using Vector = Eigen::VectorXd;

  void analyze_pattern(const Matrix& matrix)
  {
    clear();
    m_factor.emplace(matrix);
  }

  // false without analysis, too
  bool factorize(const Matrix& matrix)
  {
    return m_factor && m_factor->factorize(matrix, *m_executor);
  }

  // runs parts of the next factorizations, and must outlive them
  void set_executor(const internal::Executor& executor) { m_executor = &executor; }

  Vector solve(const Vector& right_side) const { return backward(forward(right_side)); }
  Vector forward(const Vector& right_side) const { return m_factor->forward(right_side); }
  Vector backward(const Vector& halfway) const { return m_factor->backward(halfway); }

  std::vector<int> forward_rows(const std::vector<int>& unknowns) const
  {
    std::vector<int> result;
    for (int s : supernodes_reached(unknowns))
      for (int k = supernodes().first(s); k < supernodes().first(s + 1); ++k)
        result.push_back(k);
    return result;
  }

  Eigen::MatrixXd forward_columns(const std::vector<int>& unknowns,
                                  const std::vector<int>& rows) const;

  double pivot(int row) const { return m_factor->pivots()[row]; }

  double work_of_factorization() const
  {
    double result = 0;
    for (int s = 0; s < supernodes().size(); ++s)
      for (int k = supernodes().first(s); k < supernodes().first(s + 1); ++k)
        result += work_of_column(k) * work_of_column(k);
    return result;
  }

  double work_of_column(int row) const
  {
    const int s = supernodes().of_column(row);
    return supernodes().height(s) - (row - supernodes().first(s));
  }

  void clear() { m_factor.reset(); }
  /// \endcond

private:
  const internal::Supernodes& supernodes() const { return m_factor->supernodes(); }

  // those on the paths from the unknowns to the roots, ascending
  std::vector<int> supernodes_reached(const std::vector<int>& unknowns) const
  {
    std::vector<bool> is_reached(supernodes().size(), false);
    std::vector<int> result;
    for (int unknown : unknowns)
      for (int s = supernodes().of_column(m_factor->row(unknown)); s >= 0 && !is_reached[s];
           s = supernodes().parent(s))
      {
        is_reached[s] = true;
        result.push_back(s);
      }
    std::sort(result.begin(), result.end());
    return result;
  }

  const internal::Executor* m_executor = &internal::executor_for<CGAL::Sequential_tag>();
  std::optional<internal::Supernodal_factor> m_factor;
};

#if CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES
CGAL_SURFACE_MESH_FOLIATION_INLINE Eigen::MatrixXd Supernodal_cholesky_solver::forward_columns(
  const std::vector<int>& unknowns, const std::vector<int>& rows) const
{
  std::vector<int> position(m_factor->size(), -1);
  for (std::size_t i = 0; i < rows.size(); ++i)
    position[rows[i]] = static_cast<int>(i);
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(rows.size(), unknowns.size());
  for (std::size_t c = 0; c < unknowns.size(); ++c)
    result(position[m_factor->row(unknowns[c])], c) = 1;
  Eigen::MatrixXd below;
  for (int s : supernodes_reached(unknowns))
  {
    const int width = supernodes().width(s), number = supernodes().number_of_rows(s);
    const internal::Const_dense_block block = m_factor->panel(s);
    auto own = result.middleRows(position[supernodes().first(s)], width);
    block.topRows(width).triangularView<Eigen::UnitLower>().solveInPlace(own);
    below.resize(number, own.cols());
    internal::multiply(
      internal::rows_of(block, width, number),
      internal::rows_of(internal::block_of(result), position[supernodes().first(s)], width),
      internal::Dense_block(below.data(), number, own.cols(), Eigen::OuterStride<>(number)));
    for (int i = 0; i < number; ++i)
      result.row(position[supernodes().rows(s)[i]]) -= below.row(i);
  }
  return result;
}
#endif // CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_SUPERNODAL_CHOLESKY_SOLVER_H
