// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MATCHING_CHEAPEST_ASSIGNMENT_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MATCHING_CHEAPEST_ASSIGNMENT_H

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

struct Assignment
{
  double cost = 0; // infinite if there is none
  std::vector<int> column_of_row;
};

// The Hungarian method with shortest augmenting paths, in O(n^3). (Boost.Graph has maximum weighted
// matchings of any graph, which need not be perfect.)
class Hungarian_method
{
public:
  // costs: row by row; infinite ones exclude a pair
  Hungarian_method(int n, std::vector<double> costs)
    : m_n(n),
      m_costs(std::move(costs)),
      m_row_potential(n, 0),
      m_column_potential(n, 0),
      m_row_of_column(n, NONE),
      m_distance(n),
      m_previous(n),
      m_is_reached(n)
  {}

  Assignment operator()()
  {
    Assignment result;
    for (int row = 0; row < m_n; ++row)
      if (!add(row))
      {
        result.cost = infinity;
        return result;
      }
    result.column_of_row.resize(m_n);
    for (int column = 0; column < m_n; ++column)
      result.column_of_row[m_row_of_column[column]] = column;
    for (int row = 0; row < m_n; ++row)
      result.cost += cost(row, result.column_of_row[row]);
    return result;
  }

  static constexpr double infinity = std::numeric_limits<double>::infinity();

private:
  static constexpr int NONE = -1;

  double cost(int row, int column) const
  {
    return m_costs[static_cast<std::size_t>(row) * m_n + column];
  }

  // Finds a column for one more row, along a shortest alternating path; false if there is none.
  bool add(int row)
  {
    std::fill(m_distance.begin(), m_distance.end(), infinity);
    std::fill(m_is_reached.begin(), m_is_reached.end(), false);
    std::vector<int> tree = {NONE}; // reached columns; NONE stands for `row`
    int column = NONE;
    do
    {
      const int from = column == NONE ? row : m_row_of_column[column];
      const int next = nearest_column(from, column);
      if (next == NONE)
        return false;
      shift_potentials(row, tree, m_distance[next]);
      m_is_reached[next] = true;
      tree.push_back(column = next);
    } while (m_row_of_column[column] != NONE);
    for (int previous; column != NONE; column = previous)
    {
      previous = m_previous[column];
      m_row_of_column[column] = previous == NONE ? row : m_row_of_column[previous];
    }
    return true;
  }

  // Updates the distances of columns by those from a row that belongs to the reached column
  // `from_column`, and returns the nearest one not yet reached; NONE if all are infinitely far.
  int nearest_column(int row, int from_column)
  {
    int result = NONE;
    for (int column = 0; column < m_n; ++column)
    {
      if (m_is_reached[column])
        continue;
      const double distance = cost(row, column) - m_row_potential[row] - m_column_potential[column];
      if (distance < m_distance[column])
      {
        m_distance[column] = distance;
        m_previous[column] = from_column;
      }
      if (m_distance[column] < (result == NONE ? infinity : m_distance[result]))
        result = column;
    }
    return result;
  }

  void shift_potentials(int first_row, const std::vector<int>& tree, double distance)
  {
    for (int column : tree)
    {
      m_row_potential[column == NONE ? first_row : m_row_of_column[column]] += distance;
      if (column != NONE)
        m_column_potential[column] -= distance;
    }
    for (int column = 0; column < m_n; ++column)
      if (!m_is_reached[column])
        m_distance[column] -= distance;
  }

  int m_n;
  std::vector<double> m_costs, m_row_potential, m_column_potential;
  std::vector<int> m_row_of_column;
  std::vector<double> m_distance; // of a column from the row that is added
  std::vector<int> m_previous;
  std::vector<bool> m_is_reached;
};

// The assignment of n rows to n columns with the least sum of cost(row, column), which may be
// infinite where a row and a column do not match.
template <class Cost>
Assignment cheapest_assignment(std::size_t n, const Cost& cost)
{
  std::vector<double> costs;
  costs.reserve(n * n);
  for (std::size_t row = 0; row < n; ++row)
    for (std::size_t column = 0; column < n; ++column)
      costs.push_back(cost(row, column));
  if (n == 1 && costs[0] < Hungarian_method::infinity)
    return {costs[0], {0}};
  return Hungarian_method(static_cast<int>(n), std::move(costs))();
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MATCHING_CHEAPEST_ASSIGNMENT_H
