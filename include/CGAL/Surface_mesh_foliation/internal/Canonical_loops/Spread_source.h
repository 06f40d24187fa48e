// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_SPREAD_SOURCE_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_SPREAD_SOURCE_H

#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Vertex_potentials.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Potentials of a unit source that is spread over some vertices so that the potential is the same
// in all of them: as if they, and what they enclose, were one place.
class Spread_source
{
public:
  Spread_source(const Vertex_potentials& potentials, std::vector<int> vertices)
    : m_vertices(std::move(vertices))
  {
    const auto m = static_cast<Eigen::Index>(m_vertices.size());
    m_potentials.reserve(m_vertices.size());
    for (const int v : m_vertices)
      m_potentials.push_back(potentials.of_source(v));
    // by vertex, its potential and that of the place; then the sum of all sources
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(m + 1, m + 1);
    for (Eigen::Index i = 0; i < m; ++i)
    {
      for (Eigen::Index j = 0; j < m; ++j)
        matrix(i, j) = m_potentials[j][m_vertices[i]];
      matrix(i, m) = matrix(m, i) = -1;
    }
    m_factor.compute(matrix);
  }

  // together with sinks of which the potential is given, with another sign
  Eigen::VectorXd minus(const Eigen::VectorXd& of_sinks) const
  {
    const auto m = static_cast<Eigen::Index>(m_vertices.size());
    Eigen::VectorXd right(m + 1);
    for (Eigen::Index i = 0; i < m; ++i)
      right[i] = of_sinks[m_vertices[i]];
    right[m] = -1;
    const Eigen::VectorXd sources = m_factor.solve(right);
    Eigen::VectorXd result = -of_sinks;
    for (Eigen::Index i = 0; i < m; ++i)
      result += sources[i] * m_potentials[i];
    return result;
  }

private:
  std::vector<int> m_vertices;
  std::vector<Eigen::VectorXd> m_potentials; // of a source in each vertex
  Eigen::PartialPivLU<Eigen::MatrixXd> m_factor;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_SPREAD_SOURCE_H
