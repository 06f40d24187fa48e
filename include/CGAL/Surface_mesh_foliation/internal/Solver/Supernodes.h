// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_SUPERNODES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_SUPERNODES_H

#include <CGAL/Surface_mesh_foliation/internal/Solver/Elimination_tree.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The columns of a Cholesky factor in groups of neighbors with, nearly, the same rows below them:
// supernodes, each of which is stored as a dense block, its panel. A supernode is merged with its
// parent where that adds few zeros, since large blocks are quicker than small ones.
class Supernodes
{
public:
  static constexpr int NONE = Elimination_tree::NONE;

  explicit Supernodes(const Elimination_tree& tree)
  {
    find_groups(tree);
    find_rows(tree);
  }

  int size() const { return static_cast<int>(m_first.size()) - 1; }

  // columns [first(s), first(s + 1))
  int first(int s) const { return m_first[s]; }
  int width(int s) const { return m_first[s + 1] - m_first[s]; }
  int of_column(int k) const { return m_supernode[k]; }

  // the rows below the columns, ascending
  const int* rows(int s) const { return m_rows.data() + m_row_begin[s]; }
  int number_of_rows(int s) const { return static_cast<int>(m_row_begin[s + 1] - m_row_begin[s]); }

  // columns and rows below them
  int height(int s) const { return width(s) + number_of_rows(s); }

  // the one with the first of the rows, or NONE
  int parent(int s) const { return number_of_rows(s) > 0 ? m_supernode[rows(s)[0]] : NONE; }

private:
  struct Group
  {
    int first, end, height; // of the first column
    double entries;         // without the zeros that merging adds
  };

  void find_groups(const Elimination_tree& tree)
  {
    std::vector<Group> groups;
    for (int k = 0; k < tree.size();)
    {
      Group group = {k, k, tree.height(k), 0};
      do
        group.entries += tree.height(group.end++);
      while (group.end < tree.size() && tree.parent(group.end - 1) == group.end &&
             tree.height(group.end - 1) == tree.height(group.end) + 1);
      k = group.end;
      while (!groups.empty() && is_to_merge(tree, groups.back(), group))
      {
        const Group& child = groups.back();
        group = {child.first, group.end, group.height + child.end - child.first,
                 group.entries + child.entries};
        groups.pop_back();
      }
      groups.push_back(group);
    }
    m_supernode.resize(tree.size());
    for (const Group& group : groups)
    {
      std::fill(m_supernode.begin() + group.first, m_supernode.begin() + group.end,
                static_cast<int>(m_first.size()));
      m_first.push_back(group.first);
    }
    m_first.push_back(tree.size());
  }

  // The bounds are those of CHOLMOD.
  static bool is_to_merge(const Elimination_tree& tree, const Group& child, const Group& group)
  {
    const int parent = tree.parent(child.end - 1);
    if (parent < group.first || parent >= group.end)
      return false;
    const double width = group.end - child.first, height = group.height + child.end - child.first;
    const double entries = width * height - width * (width - 1) / 2;
    const double zeros = 1 - (group.entries + child.entries) / entries;
    return width <= 4 || zeros < (width <= 16 ? 0.8 : width <= 48 ? 0.1 : 0.05);
  }

  void find_rows(const Elimination_tree& tree)
  {
    m_row_begin.push_back(0);
    std::vector<int> last(tree.size(), NONE); // by row: the last supernode that has it
    std::vector<int> first_child(size(), NONE), next_child(size(), NONE);
    std::vector<int> rows;
    for (int s = 0; s < size(); ++s)
    {
      rows.clear();
      const auto add = [&](int row) {
        if (row < m_first[s + 1] || last[row] == s)
          return;
        last[row] = s;
        rows.push_back(row);
      };
      for (int k = m_first[s]; k < m_first[s + 1]; ++k)
        tree.for_each_neighbor(k, add);
      for (int c = first_child[s]; c != NONE; c = next_child[c])
        for (std::ptrdiff_t i = m_row_begin[c]; i < m_row_begin[c + 1]; ++i)
          add(m_rows[i]);
      std::sort(rows.begin(), rows.end());
      m_rows.insert(m_rows.end(), rows.begin(), rows.end());
      m_row_begin.push_back(static_cast<std::ptrdiff_t>(m_rows.size()));
      if (const int p = parent(s); p != NONE)
      {
        next_child[s] = first_child[p];
        first_child[p] = s;
      }
    }
  }

  std::vector<int> m_first;     // by supernode, and the number of columns
  std::vector<int> m_supernode; // by column
  std::vector<std::ptrdiff_t> m_row_begin;
  std::vector<int> m_rows;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_SUPERNODES_H
