// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_CHOLMOD_SOLVER_H
#define CGAL_SURFACE_MESH_FOLIATION_CHOLMOD_SOLVER_H

#if __has_include(<suitesparse/cholmod.h>)
#include <suitesparse/cholmod.h>
#define CGAL_SURFACE_MESH_FOLIATION_HAS_CHOLMOD
#elif __has_include(<cholmod.h>)
#include <cholmod.h>
#define CGAL_SURFACE_MESH_FOLIATION_HAS_CHOLMOD
#endif

#if defined(CGAL_SURFACE_MESH_FOLIATION_HAS_CHOLMOD) || defined(DOXYGEN_RUNNING)

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationLinearSolvers

is the supernodal Cholesky factorization \f$ A = P^T L L^T P \f$ of CHOLMOD, which works on dense
blocks. It is slower than `Supernodal_cholesky_solver` for small meshes, and pays, with a fast BLAS,
for meshes of a million vertices and more. The class exists, and the macro
`CGAL_SURFACE_MESH_FOLIATION_HAS_CHOLMOD` is defined, if the headers of SuiteSparse are found; a
program that uses it is linked with the library `cholmod`.

It is a model of `UpdatableFoliationLinearSolver`.
*/
class Cholmod_solver
{
public:
  /// \cond SKIP_IN_MANUAL
  using Matrix = Eigen::SparseMatrix<double>;
  using Vector = Eigen::VectorXd;

  Cholmod_solver()
  {
    cholmod_start(&m_common);
    m_common.supernodal = CHOLMOD_SUPERNODAL;
    m_common.final_ll = 1;
    m_common.print = 0;
    m_common.quick_return_if_not_posdef = 1;
  }

  ~Cholmod_solver()
  {
    clear();
    cholmod_finish(&m_common);
  }

  Cholmod_solver(const Cholmod_solver&) = delete;
  Cholmod_solver& operator=(const Cholmod_solver&) = delete;

  void analyze_pattern(const Matrix& matrix)
  {
    clear();
    cholmod_sparse view = view_of(matrix);
    m_factor = cholmod_analyze(&view, &m_common);
    if (m_factor != nullptr && m_factor->is_super != 0)
      find_supernodes();
  }

  bool factorize(const Matrix& matrix)
  {
    if (m_factor == nullptr || m_factor->is_super == 0)
      return false;
    cholmod_sparse view = view_of(matrix);
    cholmod_factorize(&view, m_factor, &m_common);
    return m_common.status == CHOLMOD_OK && m_factor->minor == m_factor->n;
  }

  void clear() { cholmod_free_factor(&m_factor, &m_common); }

  Vector solve(const Vector& right_side) const { return backward(forward(right_side)); }

  Vector forward(const Vector& right_side) const
  {
    Vector result(right_side.size());
    for (int i = 0; i < size(); ++i)
      result[i] = right_side[permutation()[i]];
    return half_solve(CHOLMOD_L, result);
  }

  Vector backward(const Vector& halfway) const
  {
    const Vector permuted = half_solve(CHOLMOD_Lt, halfway);
    Vector result(halfway.size());
    for (int i = 0; i < size(); ++i)
      result[permutation()[i]] = permuted[i];
    return result;
  }

  std::vector<int> forward_rows(const std::vector<int>& unknowns) const
  {
    std::vector<int> result;
    for (int k : supernodes_reached(unknowns))
      for (int j = first_column(k); j < first_column(k + 1); ++j)
        result.push_back(j);
    return result;
  }

  Eigen::MatrixXd forward_columns(const std::vector<int>& unknowns,
                                  const std::vector<int>& rows) const
  {
    std::vector<int> position(size(), -1);
    for (std::size_t i = 0; i < rows.size(); ++i)
      position[rows[i]] = static_cast<int>(i);
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(rows.size(), unknowns.size());
    for (std::size_t c = 0; c < unknowns.size(); ++c)
      result(position[m_row_of_unknown[unknowns[c]]], c) = 1;
    for (int k : supernodes_reached(unknowns))
    {
      const int width = first_column(k + 1) - first_column(k), height = height_of(k);
      const Eigen::Map<const Eigen::MatrixXd> block(values(k), height, width);
      auto own = result.middleRows(position[first_column(k)], width);
      block.topRows(width).triangularView<Eigen::Lower>().solveInPlace(own);
      const Eigen::MatrixXd below = block.bottomRows(height - width) * own;
      for (int i = 0; i < height - width; ++i)
        result.row(position[row_indices(k)[width + i]]) -= below.row(i);
    }
    return result;
  }

  double pivot(int) const { return 1; }

  double work_of_factorization() const
  {
    double result = 0;
    for (int k = 0; k < number_of_supernodes(); ++k)
      for (int i = first_column(k); i < first_column(k + 1); ++i)
        result += work_of_column(i) * work_of_column(i);
    return result / speed_of_blocks;
  }

  double work_of_column(int row) const
  {
    const int k = m_supernode[row];
    return height_of(k) - (row - first_column(k));
  }
  /// \endcond

private:
  // how much faster CHOLMOD's blocks are than those of an update
  static constexpr double speed_of_blocks = 2;

  static cholmod_sparse view_of(const Matrix& matrix)
  {
    cholmod_sparse result{};
    result.nrow = result.ncol = static_cast<std::size_t>(matrix.rows());
    result.nzmax = static_cast<std::size_t>(matrix.nonZeros());
    result.p = const_cast<int*>(matrix.outerIndexPtr());
    result.i = const_cast<int*>(matrix.innerIndexPtr());
    result.x = const_cast<double*>(matrix.valuePtr());
    result.stype = -1; // the lower triangle
    result.itype = CHOLMOD_INT;
    result.xtype = CHOLMOD_REAL;
    result.dtype = CHOLMOD_DOUBLE;
    result.sorted = result.packed = 1;
    return result;
  }

  int size() const { return static_cast<int>(m_factor->n); }
  const int* permutation() const { return static_cast<const int*>(m_factor->Perm); }
  int number_of_supernodes() const { return static_cast<int>(m_factor->nsuper); }
  int first_column(int k) const { return static_cast<const int*>(m_factor->super)[k]; }
  int height_of(int k) const
  {
    const int* begin = static_cast<const int*>(m_factor->pi);
    return begin[k + 1] - begin[k];
  }
  const int* row_indices(int k) const
  {
    return static_cast<const int*>(m_factor->s) + static_cast<const int*>(m_factor->pi)[k];
  }
  const double* values(int k) const
  {
    return static_cast<const double*>(m_factor->x) + static_cast<const int*>(m_factor->px)[k];
  }

  void find_supernodes()
  {
    m_supernode.resize(m_factor->n);
    m_parent.assign(m_factor->nsuper, -1);
    m_row_of_unknown.resize(m_factor->n);
    for (int k = 0; k < number_of_supernodes(); ++k)
      for (int j = first_column(k); j < first_column(k + 1); ++j)
        m_supernode[j] = k;
    for (int k = 0; k < number_of_supernodes(); ++k)
    {
      const int width = first_column(k + 1) - first_column(k);
      if (height_of(k) > width)
        m_parent[k] = m_supernode[row_indices(k)[width]];
    }
    for (int i = 0; i < size(); ++i)
      m_row_of_unknown[permutation()[i]] = i;
  }

  // those on the paths from the unknowns to the roots, ascending
  std::vector<int> supernodes_reached(const std::vector<int>& unknowns) const
  {
    std::vector<bool> is_reached(m_factor->nsuper, false);
    std::vector<int> result;
    for (int unknown : unknowns)
      for (int k = m_supernode[m_row_of_unknown[unknown]]; k >= 0 && !is_reached[k];
           k = m_parent[k])
      {
        is_reached[k] = true;
        result.push_back(k);
      }
    std::sort(result.begin(), result.end());
    return result;
  }

  Vector half_solve(int system, const Vector& right_side) const
  {
    cholmod_dense b{};
    b.nrow = b.nzmax = b.d = static_cast<std::size_t>(right_side.size());
    b.ncol = 1;
    b.x = const_cast<double*>(right_side.data());
    b.xtype = CHOLMOD_REAL;
    b.dtype = CHOLMOD_DOUBLE;
    cholmod_dense* x = cholmod_solve(system, m_factor, &b, &m_common);
    if (x == nullptr) // out of memory: the result is not finite, and that is reported
      return Vector::Constant(right_side.size(), std::numeric_limits<double>::quiet_NaN());
    const Vector result = Eigen::Map<const Vector>(static_cast<double*>(x->x), right_side.size());
    cholmod_free_dense(&x, &m_common);
    return result;
  }

  mutable cholmod_common m_common;
  cholmod_factor* m_factor = nullptr;
  std::vector<int> m_supernode;      // by row of the factor
  std::vector<int> m_parent;         // by supernode
  std::vector<int> m_row_of_unknown; // the inverse of the permutation
};

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_HAS_CHOLMOD

#endif // CGAL_SURFACE_MESH_FOLIATION_CHOLMOD_SOLVER_H
