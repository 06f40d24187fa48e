// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_UPDATED_SOLUTIONS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_UPDATED_SOLUTIONS_H

#include <CGAL/Surface_mesh_foliation/internal/Common/Executor.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/dense_ldlt.h>

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

// in place of Updated_solutions for other solvers
struct No_updates
{
  template <class LinearSolver>
  explicit No_updates(const LinearSolver&)
  {}
  void forget() {}
};

// Whether a linear solver has a member clear(), which frees its memory.
template <class LinearSolver, class = void>
struct Is_clearable : std::false_type
{};

template <class LinearSolver>
struct Is_clearable<LinearSolver, std::void_t<decltype(std::declval<LinearSolver&>().clear())>>
  : std::true_type
{};

// Whether a linear solver has a member set_executor(), and can run in parallel.
template <class LinearSolver, class = void>
struct Takes_executor : std::false_type
{};

template <class LinearSolver>
struct Takes_executor<LinearSolver,
                      std::void_t<decltype(std::declval<LinearSolver&>().set_executor(
                        std::declval<const Executor&>()))>> : std::true_type
{};

// an operation on dense columns takes about half the time of one in a sparse factorization
constexpr double dense_share = 0.5;

// Solves with matrices that differ from the one that was factored, by the formula of Woodbury. With
// A = L D L^T factored, E the unit vectors of the touched unknowns C and M the change of their
// block,
//   (A + E M E^T) x = b,   Y = L^-1 E,   G = Y^T D^-1 Y,   z = L^-1 b,
//   (I + G M) x_C = Y^T D^-1 z,   x = L^-T D^-1 (z - Y M x_C).
// Y and G do not depend on M, so they are kept: the changes of successive iterations touch mostly
// the same unknowns. Y lives on the paths from C to the root of the elimination tree; it is kept in
// blocks, one for each solve that touched further unknowns.
template <class LinearSolver>
class Updated_solutions
{
  using Vector = Eigen::VectorXd;

public:
  explicit Updated_solutions(const LinearSolver& solver) : m_solver(solver) {}

  // To be called whenever the solver has factored a matrix.
  void forget()
  {
    m_blocks.clear();
    m_place.clear();
    m_products.resize(0, 0);
  }

  // Returns nothing if a new factorization would be less work.
  std::optional<Vector> operator()(const Vector& right_side, const Matrix_change& change)
  {
    const std::vector<int> touched = change.unknowns();
    if (touched.empty())
      return m_solver.solve(right_side);
    m_place.resize(right_side.size(), NONE);
    std::vector<int> added = columns_to_add(touched);
    if (size() + added.size() > 2 * touched.size()) // most columns are of no use any more
    {
      forget();
      m_place.resize(right_side.size(), NONE);
      added = touched;
    }
    const std::vector<int> rows = added.empty() ? added : m_solver.forward_rows(added);
    if (dense_share * work(touched, added, rows) > m_solver.work_of_factorization())
      return std::nullopt;
    if (!added.empty())
      add_block(added, rows);
    return solve(right_side, change, touched);
  }

private:
  static constexpr int NONE = -1;

  // some columns of Y, where they are not zero
  struct Block
  {
    int first; // the place of its first unknown
    std::vector<int> rows;
    Eigen::MatrixXd y;
  };

  int size() const { return static_cast<int>(m_products.rows()); }

  std::vector<int> columns_to_add(const std::vector<int>& touched) const
  {
    std::vector<int> result;
    for (int unknown : touched)
      if (m_place[unknown] == NONE)
        result.push_back(unknown);
    return result;
  }

  double work(const std::vector<int>& touched,
              const std::vector<int>& added,
              const std::vector<int>& rows) const
  {
    const auto all = static_cast<double>(touched.size()), more = static_cast<double>(added.size());
    double result = all * all * all;
    for (int row : rows)
      result += more * (m_solver.work_of_column(row) + size() + more);
    return result;
  }

  void add_block(const std::vector<int>& added, const std::vector<int>& rows)
  {
    const int before = size(), more = static_cast<int>(added.size());
    m_products.conservativeResize(before + more, before + more);
    m_blocks.push_back({before, rows, m_solver.forward_columns(added, rows)});
    for (int i = 0; i < more; ++i)
      m_place[added[i]] = before + i;
    const Block& block = m_blocks.back();
    Vector inverse_pivots(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
      inverse_pivots[i] = 1 / m_solver.pivot(rows[i]);
    const Eigen::MatrixXd scaled = inverse_pivots.asDiagonal() * block.y;
    for (int first = 0; first < more; first += columns_of_piece) // its lower triangle
      set_products(columns_of(block_of(block.y), first, more - first), before + first,
                   columns_of(block_of(scaled), first, (std::min)(columns_of_piece, more - first)),
                   before + first);
    for (std::size_t b = 0; b + 1 < m_blocks.size(); ++b)
      multiply_blocks(m_blocks[b], block, scaled);
  }

  // Sets the products of columns of Y, in whatever rows, whose places begin at `i` and `j`.
  void set_products(const Const_dense_block& x, int i, const Const_dense_block& scaled, int j)
  {
    Dense_block products(m_products.data() + i + j * m_products.rows(), x.cols(), scaled.cols(),
                         Eigen::OuterStride<>(m_products.rows()));
    multiply_transposed(x, scaled, products);
    for (int k = 0; k < x.cols(); ++k)
      for (int l = 0; l < scaled.cols(); ++l)
        m_products(j + l, i + k) = m_products(i + k, j + l);
  }

  // Sets the products of the columns of two blocks; only rows in both of them count.
  void multiply_blocks(const Block& x, const Block& y, const Eigen::MatrixXd& scaled)
  {
    std::vector<int> x_rows, y_rows;
    for (std::size_t i = 0, j = 0; i < x.rows.size() && j < y.rows.size();)
      if (x.rows[i] < y.rows[j])
        ++i;
      else if (x.rows[i] > y.rows[j])
        ++j;
      else
      {
        x_rows.push_back(static_cast<int>(i++));
        y_rows.push_back(static_cast<int>(j++));
      }
    const Eigen::MatrixXd x_part = x.y(x_rows, Eigen::all), y_part = scaled(y_rows, Eigen::all);
    set_products(block_of(x_part), x.first, block_of(y_part), y.first);
  }

  Vector solve(const Vector& right_side,
               const Matrix_change& change,
               const std::vector<int>& touched) const
  {
    Vector z = m_solver.forward(right_side), y_z(size());
    for (const Block& block : m_blocks)
    {
      Vector z_rows(block.rows.size());
      for (std::size_t i = 0; i < block.rows.size(); ++i)
        z_rows[i] = z[block.rows[i]] / m_solver.pivot(block.rows[i]);
      y_z.segment(block.first, block.y.cols()).noalias() = block.y.transpose() * z_rows;
    }
    std::vector<int> places;
    places.reserve(touched.size());
    for (int unknown : touched)
      places.push_back(m_place[unknown]);
    const Eigen::MatrixXd g = m_products(places, places);
    Eigen::MatrixXd q = Eigen::MatrixXd::Identity(g.rows(), g.cols());
    const auto position = [&](int unknown) {
      return std::lower_bound(touched.begin(), touched.end(), unknown) - touched.begin();
    };
    for (const Matrix_change::Entry& entry : change.entries)
    {
      const auto i = position(entry.row), j = position(entry.column);
      q.col(i) += entry.value * g.col(j);
      q.col(j) += entry.value * g.col(i);
    }
    const Vector x = q.partialPivLu().solve(Vector(y_z(places)));
    Vector m_x = Vector::Zero(size());
    for (const Matrix_change::Entry& entry : change.entries)
    {
      const auto i = position(entry.row), j = position(entry.column);
      m_x[places[i]] += entry.value * x[j];
      m_x[places[j]] += entry.value * x[i];
    }
    for (const Block& block : m_blocks)
    {
      const Vector correction = block.y * m_x.segment(block.first, block.y.cols());
      for (std::size_t i = 0; i < block.rows.size(); ++i)
        z[block.rows[i]] -= correction[i];
    }
    return m_solver.backward(z);
  }

  const LinearSolver& m_solver;
  std::vector<int> m_place; // by unknown: that of its column, or NONE
  std::vector<Block> m_blocks;
  Eigen::MatrixXd m_products; // G
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_UPDATED_SOLUTIONS_H
