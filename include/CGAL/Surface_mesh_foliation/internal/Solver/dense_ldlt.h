// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_DENSE_LDLT_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_DENSE_LDLT_H

#include <CGAL/Surface_mesh_foliation/internal/Common/Executor.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>

// The steps of a factorization L D L^T on one dense block, whose columns are stored one after
// another, `height` numbers each. Only what lies on and below the diagonal is read; above it there
// may be anything.

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

using Dense_block = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
using Const_dense_block = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

// below this number of operations, plain loops are quicker than Eigen's products
constexpr double work_of_small_product = 8000;

// Columns that are computed in one piece. Pieces do not depend on who computes them, so neither do
// results, to the last bit.
constexpr int columns_of_piece = 128;

// Eliminates the columns [first, end) from each other; the columns of L replace them, and their
// pivots are written. Returns whether no pivot is zero.
inline bool eliminate_columns(double* block, int height, int first, int end, double* pivots)
{
  for (int j = first; j < end; ++j)
  {
    double* const column = block + static_cast<std::ptrdiff_t>(j) * height;
    const double pivot = column[j];
    if (!(std::abs(pivot) > 0) || !std::isfinite(pivot))
      return false;
    pivots[j] = pivot;
    for (int k = j + 1; k < end; ++k)
    {
      double* const other = block + static_cast<std::ptrdiff_t>(k) * height;
      const double factor = column[k] / pivot;
      if (factor != 0)
        for (int i = k; i < height; ++i)
          other[i] -= factor * column[i];
    }
    const double inverse = 1 / pivot;
    for (int i = j + 1; i < height; ++i)
      column[i] *= inverse;
  }
  return true;
}

// Subtracts L D L^T from the lower triangle of a square matrix; what is above the diagonal becomes
// anything.
inline void subtract_product(const Const_dense_block& l,
                             const double* pivots,
                             double* square,
                             Eigen::MatrixXd& scratch,
                             const Executor& executor)
{
  const auto rows = l.rows(), columns = l.cols();
  if (static_cast<double>(rows) * static_cast<double>(rows * columns) < work_of_small_product)
  {
    for (Eigen::Index c = 0; c < columns; ++c)
      for (Eigen::Index j = 0; j < rows; ++j)
      {
        const double factor = pivots[c] * l(j, c);
        double* const column = square + j * rows;
        for (Eigen::Index i = j; i < rows; ++i)
          column[i] -= factor * l(i, c);
      }
    return;
  }
  scratch.noalias() = l * Eigen::Map<const Eigen::VectorXd>(pivots, columns).asDiagonal();
  const auto subtract = [&](int, int first, int last) {
    Dense_block(square + first * rows + first, rows - first, last - first,
                Eigen::OuterStride<>(rows))
      .noalias() -=
      l.bottomRows(rows - first) * scratch.middleRows(first, last - first).transpose();
  };
  executor(static_cast<int>(rows), subtract, columns_of_piece);
}

// Factors the first `width` columns of a block, and writes their pivots. Returns whether no pivot
// is zero.
inline bool factor_panel(double* block,
                         int height,
                         int width,
                         double* pivots,
                         Eigen::MatrixXd& scratch,
                         const Executor& executor)
{
  constexpr int step = 32;
  const auto part = [&](int row, int column, int rows, int columns) {
    return Dense_block(block + row + static_cast<std::ptrdiff_t>(column) * height, rows, columns,
                       Eigen::OuterStride<>(height));
  };
  for (int first = 0; first < width; first += step)
  {
    const int end = (std::min)(first + step, width);
    if (!eliminate_columns(block, height, first, end, pivots))
      return false;
    if (end == width)
      continue;
    scratch.noalias() = part(end, first, width - end, end - first) *
                        Eigen::Map<const Eigen::VectorXd>(pivots + first, end - first).asDiagonal();
    const auto subtract = [&](int, int from, int to) {
      const int row = end + from, rows = height - row;
      part(row, row, rows, to - from).noalias() -=
        part(row, first, rows, end - first) * scratch.middleRows(from, to - from).transpose();
    };
    executor(width - end, subtract, columns_of_piece);
  }
  return true;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_DENSE_LDLT_H
