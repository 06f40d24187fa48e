// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_SUPERNODAL_FACTOR_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_SUPERNODAL_FACTOR_H

#include <CGAL/Surface_mesh_foliation/internal/Common/compiled.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/Executor.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Elimination_tree.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Supernodes.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/dense_ldlt.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The factorization A = P^T L D L^T P of a sparse symmetric matrix, by the multifrontal method
// (Duff and Reid, The multifrontal solution of indefinite sparse symmetric linear equations, 1983):
// the panel of each supernode receives its entries of A and what its children have left for it, is
// factored as a dense block, and leaves a dense square for its parent. Squares come and go like on
// a stack. Nearly all work is in products of dense blocks.
class Supernodal_factor
{
public:
  using Matrix = Eigen::SparseMatrix<double>;
  using Vector = Eigen::VectorXd;

  // The pattern: the lower triangle, compressed. The values mean nothing.
  explicit Supernodal_factor(const Matrix& lower) : Supernodal_factor(Elimination_tree(lower)) {}

  // Returns whether no pivot is zero. The result is the same, bit for bit, whatever the executor.
  bool factorize(const Matrix& lower, const Executor& executor)
  {
    m_values.assign(static_cast<std::size_t>(m_panel_begin.back()), 0);
    add_entries(lower);
    m_pivots.resize(size());
    std::vector<Values> squares(m_supernodes.size()); // of roots of subtrees, and above them
    std::vector<char> is_done(m_end_of_task.size(), 0);
    executor(
      static_cast<int>(m_end_of_task.size()),
      [&](int task, int, int) { is_done[task] = eliminate_subtrees(task, squares); }, 1);
    if (!std::all_of(is_done.begin(), is_done.end(), [](char done) { return done != 0; }))
      return false;
    Workspace workspace(size());
    for (int s : m_top)
    {
      squares[s] = new_values(size_of_square(s));
      std::vector<Square> children;
      for (int child : m_children_of_top[m_top_index[s]])
        children.push_back({child, squares[child].get()});
      assemble(s, children.data(), children.data() + children.size(), squares[s].get(), workspace);
      for (const Square& child : children)
        squares[child.supernode].reset();
      if (!eliminate(s, squares[s].get(), workspace, executor))
        return false;
    }
    return true;
  }

  int size() const { return static_cast<int>(m_place.size()); }
  const Supernodes& supernodes() const { return m_supernodes; }
  const Vector& pivots() const { return m_pivots; }
  // the row of an unknown
  int row(int unknown) const { return m_place[unknown]; }

  // L in the columns of a supernode: unit lower triangular, then the rows below
  Const_dense_block panel(int s) const
  {
    return Const_dense_block(m_values.data() + m_panel_begin[s], m_supernodes.height(s),
                             m_supernodes.width(s), Eigen::OuterStride<>(m_supernodes.height(s)));
  }

  // L^-1 P b
  Vector forward(const Vector& right_side) const;

  // P^T L^-T D^-1 z
  Vector backward(Vector x) const;

private:
  using Values = std::unique_ptr<double[]>;

  // what a supernode has left for its parent
  struct Square
  {
    int supernode;
    double* values;
  };

  // a supernode with all its descendants, which have the numbers just before it
  struct Subtree
  {
    int first, root;
    std::ptrdiff_t size_of_squares; // the most that they need at a time
  };

  struct Workspace
  {
    explicit Workspace(int size) : position(new int[static_cast<std::size_t>(size)]) {}
    std::unique_ptr<int[]> position; // by row: that in the front; of other rows, anything
    std::vector<int> places;
    Eigen::MatrixXd scratch;
  };

  static Values new_values(std::ptrdiff_t number)
  {
    return Values(new double[static_cast<std::size_t>(number)]);
  }

  explicit Supernodal_factor(const Elimination_tree& tree)
    : m_supernodes(tree), m_place(tree.places())
  {
    m_panel_begin.push_back(0);
    for (int s = 0; s < m_supernodes.size(); ++s)
      m_panel_begin.push_back(m_panel_begin.back() +
                              static_cast<std::ptrdiff_t>(m_supernodes.height(s)) *
                                m_supernodes.width(s));
    find_subtrees();
  }

  // The places are not kept: a matrix is rarely factored twice.
  void add_entries(const Matrix& lower)
  {
    for (int j = 0; j < lower.cols(); ++j)
      for (int p = lower.outerIndexPtr()[j]; p < lower.outerIndexPtr()[j + 1]; ++p)
      {
        const int k = m_place[lower.innerIndexPtr()[p]], l = m_place[j];
        m_values[static_cast<std::size_t>(place_of_entry((std::max)(k, l), (std::min)(k, l)))] +=
          lower.valuePtr()[p];
      }
  }

  std::ptrdiff_t place_of_entry(int row, int column) const
  {
    const int s = m_supernodes.of_column(column), first = m_supernodes.first(s);
    const int* const rows = m_supernodes.rows(s);
    const std::ptrdiff_t i =
      row < first + m_supernodes.width(s)
        ? row - first
        : m_supernodes.width(s) +
            (std::lower_bound(rows, rows + m_supernodes.number_of_rows(s), row) - rows);
    return m_panel_begin[s] + i +
           static_cast<std::ptrdiff_t>(column - first) * m_supernodes.height(s);
  }

  std::ptrdiff_t size_of_square(int s) const
  {
    const std::ptrdiff_t rows = m_supernodes.number_of_rows(s);
    return rows * rows;
  }

  // Maximal subtrees with at most a sixteenth of the work each, which threads can share; the rest
  // is the top. Each task takes as many neighboring subtrees as are a sixty-fourth of the work.
  void find_subtrees()
  {
    constexpr double share = 1. / 16, share_of_task = 1. / 64;
    double work_of_task = 0;
    const int number = m_supernodes.size();
    std::vector<double> work(number, 0);
    std::vector<int> first(number);
    double total = 0;
    for (int s = 0; s < number; ++s)
      first[s] = s;
    for (int s = 0; s < number; ++s)
    {
      const double own = static_cast<double>(m_supernodes.width(s)) * m_supernodes.height(s) *
                         m_supernodes.height(s);
      total += own;
      work[s] += own;
      if (const int p = m_supernodes.parent(s); p != Supernodes::NONE)
      {
        work[p] += work[s];
        first[p] = (std::min)(first[p], first[s]);
      }
    }
    const auto is_small = [&](int s) { return work[s] <= share * total; };
    m_top_index.assign(number, Supernodes::NONE);
    for (int s = 0; s < number; ++s)
    {
      const int p = m_supernodes.parent(s);
      if (!is_small(s))
      {
        m_top_index[s] = static_cast<int>(m_top.size());
        m_top.push_back(s);
      }
      else if (p == Supernodes::NONE || !is_small(p))
      {
        m_subtrees.push_back({first[s], s, size_of_squares(first[s], s)});
        work_of_task += work[s];
        if (work_of_task < share_of_task * total)
          continue;
        m_end_of_task.push_back(m_subtrees.size());
        work_of_task = 0;
      }
    }
    if (m_end_of_task.empty() ? !m_subtrees.empty() : m_end_of_task.back() < m_subtrees.size())
      m_end_of_task.push_back(m_subtrees.size());
    m_children_of_top.resize(m_top.size());
    for (int s = 0; s < number; ++s)
      if (const int p = m_supernodes.parent(s); p != Supernodes::NONE && m_top_index[p] >= 0)
        m_children_of_top[m_top_index[p]].push_back(s);
  }

  // the most that the squares of a subtree need at a time
  std::ptrdiff_t size_of_squares(int first, int root) const
  {
    std::vector<int> stack;
    std::ptrdiff_t size = 0, most = 0;
    for (int s = first; s <= root; ++s)
    {
      most = (std::max)(most, size + size_of_square(s));
      for (; !stack.empty() && m_supernodes.parent(stack.back()) == s; stack.pop_back())
        size -= size_of_square(stack.back());
      stack.push_back(s);
      size += size_of_square(s);
    }
    return most;
  }

  bool eliminate_subtrees(int task, std::vector<Values>& squares)
  {
    Workspace workspace(size());
    for (std::size_t i = task == 0 ? 0 : m_end_of_task[task - 1]; i < m_end_of_task[task]; ++i)
      if (!eliminate_subtree(m_subtrees[i], workspace, squares[m_subtrees[i].root]))
        return false;
    return true;
  }

  // Squares lie on a stack: those of the children of a supernode are on its top, and its own is
  // moved to where they were.
  bool eliminate_subtree(const Subtree& subtree, Workspace& workspace, Values& result)
  {
    const Executor sequential;
    const Values squares = new_values(subtree.size_of_squares);
    std::vector<Square> stack;
    for (int s = subtree.first; s <= subtree.root; ++s)
    {
      std::size_t first_child = stack.size();
      while (first_child > 0 && m_supernodes.parent(stack[first_child - 1].supernode) == s)
        --first_child;
      double* const top = stack.empty()
                            ? squares.get()
                            : stack.back().values + size_of_square(stack.back().supernode);
      double* const place = first_child < stack.size() ? stack[first_child].values : top;
      assemble(s, stack.data() + first_child, stack.data() + stack.size(), top, workspace);
      if (!eliminate(s, top, workspace, sequential))
        return false;
      if (place != top)
        std::memmove(place, top, static_cast<std::size_t>(size_of_square(s)) * sizeof(double));
      stack.resize(first_child);
      stack.push_back({s, place});
    }
    result = new_values(size_of_square(subtree.root));
    std::copy(stack[0].values, stack[0].values + size_of_square(subtree.root), result.get());
    return true;
  }

  // Adds the squares of the children of a supernode to its panel and its own square.
  void assemble(int s,
                const Square* first_child,
                const Square* end_of_children,
                double* square,
                Workspace& workspace)
  {
    const int width = m_supernodes.width(s), number = m_supernodes.number_of_rows(s);
    std::fill(square, square + size_of_square(s), 0.);
    for (int i = 0; i < width; ++i)
      workspace.position[m_supernodes.first(s) + i] = i;
    for (int i = 0; i < number; ++i)
      workspace.position[m_supernodes.rows(s)[i]] = width + i;
    for (const Square* child = first_child; child != end_of_children; ++child)
      add_square(*child, s, square, workspace);
  }

  // Factors the assembled panel of a supernode, and completes its square.
  bool eliminate(int s, double* square, Workspace& workspace, const Executor& executor)
  {
    const int width = m_supernodes.width(s), height = m_supernodes.height(s);
    const int number = height - width;
    double* const block = m_values.data() + m_panel_begin[s];
    double* const pivots = m_pivots.data() + m_supernodes.first(s);
    if (!factor_panel(block, height, width, pivots, workspace.scratch, executor))
      return false;
    if (number > 0)
      subtract_square(Const_dense_block(block + width, number, width, Eigen::OuterStride<>(height)),
                      pivots, square, workspace.scratch, executor);
    return true;
  }

  // Adds the square of a child to panel and square of a supernode.
  void add_square(const Square& child, int s, double* square, Workspace& workspace)
  {
    const int width = m_supernodes.width(s), height = m_supernodes.height(s);
    const int size = m_supernodes.number_of_rows(child.supernode);
    workspace.places.resize(size);
    for (int i = 0; i < size; ++i)
      workspace.places[i] = workspace.position[m_supernodes.rows(child.supernode)[i]];
    const int* const place = workspace.places.data();
    double* const block = m_values.data() + m_panel_begin[s];
    const double* column = child.values;
    for (int j = 0; j < size; ++j, column += size)
    {
      // a column of the front, whose first `width` ones are the panel
      double* const target =
        place[j] < width
          ? block + static_cast<std::ptrdiff_t>(place[j]) * height
          : square + static_cast<std::ptrdiff_t>(place[j] - width) * (height - width) - width;
      for (int i = j; i < size; ++i)
        target[place[i]] += column[i];
    }
  }

  const Supernodes m_supernodes;
  std::vector<int> m_place;                  // by unknown
  std::vector<std::ptrdiff_t> m_panel_begin; // by supernode, in m_values
  std::vector<Subtree> m_subtrees;
  std::vector<std::size_t> m_end_of_task;          // in m_subtrees
  std::vector<int> m_top;                          // other supernodes, ascending
  std::vector<int> m_top_index;                    // by supernode: its place in m_top, or NONE
  std::vector<std::vector<int>> m_children_of_top; // by place in m_top, ascending
  std::vector<double> m_values;
  Vector m_pivots; // by row
};

#if CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES
CGAL_SURFACE_MESH_FOLIATION_INLINE Supernodal_factor::Vector Supernodal_factor::forward(
  const Vector& right_side) const
{
  Vector x(size());
  for (int unknown = 0; unknown < size(); ++unknown)
    x[m_place[unknown]] = right_side[unknown];
  Vector below;
  for (int s = 0; s < m_supernodes.size(); ++s)
  {
    const int first = m_supernodes.first(s), width = m_supernodes.width(s);
    const int number = m_supernodes.number_of_rows(s);
    const Const_dense_block block = panel(s);
    auto own = x.segment(first, width);
    if (width > 1)
      block.topRows(width).triangularView<Eigen::UnitLower>().solveInPlace(own);
    below.noalias() = block.bottomRows(number) * own;
    for (int i = 0; i < number; ++i)
      x[m_supernodes.rows(s)[i]] -= below[i];
  }
  return x;
}

CGAL_SURFACE_MESH_FOLIATION_INLINE Supernodal_factor::Vector Supernodal_factor::backward(
  Vector x) const
{
  x.array() /= m_pivots.array();
  Vector below;
  for (int s = m_supernodes.size() - 1; s >= 0; --s)
  {
    const int first = m_supernodes.first(s), width = m_supernodes.width(s);
    const int number = m_supernodes.number_of_rows(s);
    const Const_dense_block block = panel(s);
    below.resize(number);
    for (int i = 0; i < number; ++i)
      below[i] = x[m_supernodes.rows(s)[i]];
    auto own = x.segment(first, width);
    own.noalias() -= block.bottomRows(number).transpose() * below;
    if (width > 1)
      block.topRows(width).triangularView<Eigen::UnitLower>().transpose().solveInPlace(own);
  }
  Vector result(size());
  for (int unknown = 0; unknown < size(); ++unknown)
    result[unknown] = x[m_place[unknown]];
  return result;
}
#endif // CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_SUPERNODAL_FACTOR_H
