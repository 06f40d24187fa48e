// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_DENSE_LDLT_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_DENSE_LDLT_H

#include <CGAL/Surface_mesh_foliation/internal/Common/compiled.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/Executor.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>

// Products of dense blocks, and the steps of a factorization L D L^T on one dense block, whose
// columns are stored one after another, `height` numbers each. Only what lies on and below the
// diagonal is read; above it there may be anything.

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

using Dense_block = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
using Const_dense_block = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

// All products are of these types, since each other one would be compiled once more.

inline Const_dense_block block_of(const Eigen::MatrixXd& matrix)
{
  return Const_dense_block(matrix.data(), matrix.rows(), matrix.cols(),
                           Eigen::OuterStride<>(matrix.rows()));
}

// parts of a block
inline Const_dense_block rows_of(const Const_dense_block& block, Eigen::Index first, Eigen::Index n)
{
  return Const_dense_block(block.data() + first, n, block.cols(),
                           Eigen::OuterStride<>(block.outerStride()));
}

inline Const_dense_block columns_of(const Const_dense_block& block,
                                    Eigen::Index first,
                                    Eigen::Index n)
{
  return Const_dense_block(block.data() + first * block.outerStride(), block.rows(), n,
                           Eigen::OuterStride<>(block.outerStride()));
}

// c = a b
CGAL_SURFACE_MESH_FOLIATION_INLINE void multiply(const Const_dense_block& a,
                                                 const Const_dense_block& b,
                                                 Dense_block c);

// c = a^T b
CGAL_SURFACE_MESH_FOLIATION_INLINE void multiply_transposed(const Const_dense_block& a,
                                                            const Const_dense_block& b,
                                                            Dense_block c);

// c -= a b^T
CGAL_SURFACE_MESH_FOLIATION_INLINE void subtract_product(const Const_dense_block& a,
                                                         const Const_dense_block& b,
                                                         Dense_block c);

#if CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES
CGAL_SURFACE_MESH_FOLIATION_INLINE void multiply(const Const_dense_block& a,
                                                 const Const_dense_block& b,
                                                 Dense_block c)
{
  c.noalias() = a * b;
}

CGAL_SURFACE_MESH_FOLIATION_INLINE void multiply_transposed(const Const_dense_block& a,
                                                            const Const_dense_block& b,
                                                            Dense_block c)
{
  c.noalias() = a.transpose() * b;
}

CGAL_SURFACE_MESH_FOLIATION_INLINE void subtract_product(const Const_dense_block& a,
                                                         const Const_dense_block& b,
                                                         Dense_block c)
{
  c.noalias() -= a * b.transpose();
}
#endif // CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES

// the columns of a block times the pivots
inline void scale_columns(const Const_dense_block& block,
                          const double* pivots,
                          Eigen::MatrixXd& result)
{
  result.resize(block.rows(), block.cols());
  for (Eigen::Index c = 0; c < block.cols(); ++c)
    for (Eigen::Index r = 0; r < block.rows(); ++r)
      result(r, c) = block(r, c) * pivots[c];
}

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
inline void subtract_square(const Const_dense_block& l,
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
  scale_columns(l, pivots, scratch);
  const auto subtract = [&](int, int first, int last) {
    subtract_product(rows_of(l, first, rows - first),
                     rows_of(block_of(scratch), first, last - first),
                     Dense_block(square + first * rows + first, rows - first, last - first,
                                 Eigen::OuterStride<>(rows)));
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
  const auto place = [&](int row, int column) {
    return block + row + static_cast<std::ptrdiff_t>(column) * height;
  };
  const Eigen::OuterStride<> stride(height);
  for (int first = 0; first < width; first += step)
  {
    const int end = (std::min)(first + step, width);
    if (!eliminate_columns(block, height, first, end, pivots))
      return false;
    if (end == width)
      continue;
    scale_columns(Const_dense_block(place(end, first), width - end, end - first, stride),
                  pivots + first, scratch);
    const auto subtract = [&](int, int from, int to) {
      const int row = end + from, rows = height - row;
      subtract_product(Const_dense_block(place(row, first), rows, end - first, stride),
                       rows_of(block_of(scratch), from, to - from),
                       Dense_block(place(row, row), rows, to - from, stride));
    };
    executor(width - end, subtract, columns_of_piece);
  }
  return true;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_DENSE_LDLT_H
