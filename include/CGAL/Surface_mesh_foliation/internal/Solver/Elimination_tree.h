// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_ELIMINATION_TREE_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_ELIMINATION_TREE_H

#include <CGAL/Surface_mesh_foliation/internal/Common/compiled.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#if CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES
#include <Eigen/OrderingMethods>
#endif // CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The graph of a symmetric matrix that is given by its lower triangle: for each unknown, those that
// it shares an entry with.
class Matrix_graph
{
public:
  explicit Matrix_graph(const Eigen::SparseMatrix<double>& lower)
    : m_begin(static_cast<std::size_t>(lower.cols()) + 1, 0)
  {
    const auto for_each_entry = [&lower](const auto& visit) {
      for (int j = 0; j < lower.cols(); ++j)
        for (int p = lower.outerIndexPtr()[j]; p < lower.outerIndexPtr()[j + 1]; ++p)
          if (lower.innerIndexPtr()[p] != j)
            visit(lower.innerIndexPtr()[p], j);
    };
    for_each_entry([&](int i, int j) {
      ++m_begin[i + 1];
      ++m_begin[j + 1];
    });
    std::partial_sum(m_begin.begin(), m_begin.end(), m_begin.begin());
    m_neighbors.resize(m_begin.back());
    std::vector<int> end(m_begin.begin(), m_begin.end() - 1);
    for_each_entry([&](int i, int j) {
      m_neighbors[end[i]++] = j;
      m_neighbors[end[j]++] = i;
    });
  }

  int size() const { return static_cast<int>(m_begin.size()) - 1; }

  template <class Visit>
  void for_each_neighbor(int unknown, const Visit& visit) const
  {
    for (int i = m_begin[unknown]; i < m_begin[unknown + 1]; ++i)
      visit(m_neighbors[i]);
  }

private:
  std::vector<int> m_begin, m_neighbors;
};

// An order in which unknowns are eliminated, with the elimination tree: the parent of a place in
// the order is that of the first entry below the diagonal in its column of the factor. Parents come
// after all their descendants, which follow each other (postorder), and of several children the one
// with the longest column comes last. The order is one of approximately minimum degree.
class Elimination_tree
{
public:
  static constexpr int NONE = -1;

  explicit Elimination_tree(const Eigen::SparseMatrix<double>& lower);

  int size() const { return m_graph.size(); }

  // by place in the order: the unknown, the parent, the number of entries of the column
  int unknown(int k) const { return m_unknown[k]; }
  int parent(int k) const { return m_parent[k]; }
  int height(int k) const { return m_height[k]; }

  // by unknown: its place in the order
  const std::vector<int>& places() const { return m_place; }

  // the places of the neighbors of an unknown, in any order
  template <class Visit>
  void for_each_neighbor(int k, const Visit& visit) const
  {
    m_graph.for_each_neighbor(m_unknown[k], [&](int unknown) { visit(m_place[unknown]); });
  }

private:
  void find_places()
  {
    m_place.resize(size());
    for (int k = 0; k < size(); ++k)
      m_place[m_unknown[k]] = k;
  }

  // Liu's algorithm: paths to the roots are shortened as they are walked.
  void find_parents()
  {
    m_parent.assign(size(), NONE);
    std::vector<int> ancestor(size(), NONE);
    for (int k = 0; k < size(); ++k)
      for_each_neighbor(k, [&](int i) {
        while (i != NONE && i < k)
        {
          const int next = ancestor[i];
          ancestor[i] = k;
          if (next == NONE)
            m_parent[i] = k;
          i = next;
        }
      });
  }

  // Row k of the factor has an entry in the columns on the paths from the neighbors of k to k.
  void count_entries()
  {
    m_height.assign(size(), 1);
    std::vector<int> last_row(size(), NONE);
    for (int k = 0; k < size(); ++k)
    {
      last_row[k] = k;
      for_each_neighbor(k, [&](int i) {
        for (; i < k && last_row[i] != k; i = m_parent[i])
        {
          last_row[i] = k;
          ++m_height[i];
        }
      });
    }
  }

  void put_into_postorder()
  {
    const std::vector<int> order = postorder();
    std::vector<int> position(size());
    for (int k = 0; k < size(); ++k)
      position[order[k]] = k;
    std::vector<int> unknown(size()), parent(size()), height(size());
    for (int k = 0; k < size(); ++k)
    {
      unknown[k] = m_unknown[order[k]];
      parent[k] = m_parent[order[k]] == NONE ? NONE : position[m_parent[order[k]]];
      height[k] = m_height[order[k]];
    }
    m_unknown = std::move(unknown);
    m_parent = std::move(parent);
    m_height = std::move(height);
    find_places();
  }

  std::vector<int> postorder() const
  {
    // children of each place, and the roots as those of the last one
    std::vector<int> begin(size() + 2, 0), children(size());
    const auto parent = [&](int k) { return m_parent[k] == NONE ? size() : m_parent[k]; };
    for (int k = 0; k < size(); ++k)
      ++begin[parent(k) + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<int> end(begin.begin(), begin.end() - 1);
    for (int k = 0; k < size(); ++k)
      children[end[parent(k)]++] = k;
    for (int k = 0; k <= size(); ++k)
      std::sort(children.begin() + begin[k], children.begin() + begin[k + 1], [&](int i, int j) {
        return m_height[i] != m_height[j] ? m_height[i] < m_height[j] : i < j;
      });
    // depth first; the next child to visit of each place on the stack
    std::vector<int> result, stack = {size()}, next(begin.begin(), begin.end() - 1);
    result.reserve(size());
    while (!stack.empty())
    {
      const int k = stack.back();
      if (next[k] < begin[k + 1])
        stack.push_back(children[next[k]++]);
      else
      {
        stack.pop_back();
        if (k < size())
          result.push_back(k);
      }
    }
    return result;
  }

  const Matrix_graph m_graph;
  std::vector<int> m_unknown, m_parent, m_height; // by place
  std::vector<int> m_place;                       // by unknown
};

#if CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES
CGAL_SURFACE_MESH_FOLIATION_INLINE Elimination_tree::Elimination_tree(
  const Eigen::SparseMatrix<double>& lower)
  : m_graph(lower)
{
  // told that the matrix is symmetric, it is twice as fast
  Eigen::AMDOrdering<int>::PermutationType order;
  Eigen::AMDOrdering<int>()(lower.selfadjointView<Eigen::Lower>(), order);
  m_unknown.assign(order.indices().data(), order.indices().data() + size());
  find_places();
  find_parents();
  count_entries();
  put_into_postorder();
}
#endif // CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_ELIMINATION_TREE_H
