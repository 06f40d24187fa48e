// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SCALAR_REEB_GRAPH_VERTEX_ORDER_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SCALAR_REEB_GRAPH_VERTEX_ORDER_H

#include <CGAL/Surface_mesh_foliation/internal/Common/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The vertices in ascending order of (value, vertex), in which no two are equal.
class Vertex_order
{
public:
  Vertex_order() = default;

  explicit Vertex_order(std::vector<double> values) : m_values(std::move(values))
  {
    const int n = static_cast<int>(m_values.size());
    std::vector<std::pair<double, int>> order(n);
    for (int v = 0; v < n; ++v)
    {
      if (!std::isfinite(m_values[v]))
        throw_not_finite(static_cast<std::size_t>(v));
      order[v] = {m_values[v], v};
    }
    std::sort(order.begin(), order.end());
    m_vertices.resize(n);
    m_ranks.resize(n);
    for (int r = 0; r < n; ++r)
    {
      m_vertices[r] = order[r].second;
      m_ranks[order[r].second] = r;
    }
  }

  int size() const { return static_cast<int>(m_ranks.size()); }
  double value(int v) const { return m_values[v]; }
  int rank(int v) const { return m_ranks[v]; }
  int vertex(int rank) const { return m_vertices[rank]; }

  // how many vertices have a value of at most `level`
  int number_up_to(double level) const
  {
    const auto is_above = [&](double bound, int v) { return bound < m_values[v]; };
    const auto end = std::upper_bound(m_vertices.begin(), m_vertices.end(), level, is_above);
    return static_cast<int>(end - m_vertices.begin());
  }

private:
  [[noreturn]] static void throw_not_finite(std::size_t v)
  {
    throw Invalid_parameter_exception(
      problem(Problem_kind::NOT_FINITE, "the value at ", vertex_name(v), " is not finite")
        .vertices({v}));
  }

  std::vector<double> m_values;
  std::vector<int> m_ranks, m_vertices;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SCALAR_REEB_GRAPH_VERTEX_ORDER_H
