// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_SOLVE_UPDATED_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_SOLVE_UPDATED_H

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// A symmetric change of a few entries of a matrix.
struct Matrix_change
{
  struct Entry
  {
    int row, column; // row > column; each pair once
    double value;    // new minus old
  };
  std::vector<Entry> entries;

  // the rows and columns touched, ascending
  std::vector<int> unknowns() const
  {
    std::vector<int> result;
    for (const Entry& entry : entries)
      result.insert(result.end(), {entry.row, entry.column});
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }
};

// whether a solver is a model of UpdatableFoliationLinearSolver
template <class LinearSolver, class = void>
struct Is_updatable : std::false_type
{};

template <class LinearSolver>
struct Is_updatable<LinearSolver,
                    std::void_t<decltype(std::declval<const LinearSolver&>().forward_rows(
                      std::declval<const std::vector<int>&>()))>> : std::true_type
{};

// Whether a linear solver has a member clear(), which frees its memory.
template <class LinearSolver, class = void>
struct Is_clearable : std::false_type
{};

template <class LinearSolver>
struct Is_clearable<LinearSolver, std::void_t<decltype(std::declval<LinearSolver&>().clear())>>
  : std::true_type
{};

// an operation on dense columns takes about half the time of one in a sparse factorization
constexpr double dense_share = 0.5;

// Solves with the changed matrix by the formula of Woodbury. With A = L D L^T factored, E the unit
// vectors of the touched unknowns C and M the change of their block,
//   (A + E M E^T) x = b,   Y = L^-1 E,   G = Y^T D^-1 Y,   z = L^-1 b,
//   (I + G M) x_C = Y^T D^-1 z,   x = L^-T D^-1 (z - Y M x_C).
// Y lives on the paths from C to the root of the elimination tree. Returns nothing if a new
// factorization would be less work.
template <class LinearSolver>
std::optional<Eigen::VectorXd> solve_updated(const LinearSolver& solver,
                                             const Eigen::VectorXd& right_side,
                                             const Matrix_change& change)
{
  const std::vector<int> unknowns = change.unknowns();
  if (unknowns.empty())
    return solver.solve(right_side);
  const std::vector<int> rows = solver.forward_rows(unknowns);
  const double k = static_cast<double>(unknowns.size());
  double work = k * k * k;
  for (int row : rows)
    work += k * (solver.work_of_column(row) + k);
  if (dense_share * work > solver.work_of_factorization())
    return std::nullopt;

  const auto y = solver.forward_columns(unknowns, rows);
  Eigen::VectorXd z = solver.forward(right_side);
  Eigen::VectorXd z_rows(rows.size()), inverse_pivots(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    inverse_pivots[i] = 1 / solver.pivot(rows[i]);
    z_rows[i] = z[rows[i]] * inverse_pivots[i];
  }
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(unknowns.size(), unknowns.size());
  const auto position = [&](int unknown) {
    return std::lower_bound(unknowns.begin(), unknowns.end(), unknown) - unknowns.begin();
  };
  for (const Matrix_change::Entry& entry : change.entries)
  {
    const auto i = position(entry.row), j = position(entry.column);
    m(i, j) = m(j, i) = entry.value;
  }
  Eigen::MatrixXd g(unknowns.size(), unknowns.size()); // symmetric: only its lower triangle is set
  g.triangularView<Eigen::Lower>() = y.transpose() * (inverse_pivots.asDiagonal() * y);
  Eigen::MatrixXd q = g.selfadjointView<Eigen::Lower>() * m;
  q.diagonal().array() += 1;
  const Eigen::VectorXd x = q.partialPivLu().solve(y.transpose() * z_rows);
  const Eigen::VectorXd correction = y * (m * x);
  for (std::size_t i = 0; i < rows.size(); ++i)
    z[rows[i]] -= correction[i];
  return solver.backward(z);
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_SOLVE_UPDATED_H
