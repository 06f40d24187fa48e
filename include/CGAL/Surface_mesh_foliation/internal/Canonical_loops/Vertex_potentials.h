// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_VERTEX_POTENTIALS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_VERTEX_POTENTIALS_H

#include <CGAL/Surface_mesh_foliation/internal/Common/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Potentials of sources in the vertices of a surface, each with its sink in the last vertex, where
// potentials are 0. If sources and sinks sum up to zero, so does what flows into the last vertex,
// and the sum of their potentials is the potential of all, up to a constant. They need one
// factorization for the surface, and a pair of triangular solves each.
class Vertex_potentials
{
public:
  // weights: by edge, positive
  Vertex_potentials(const Flat_mesh& mesh, const std::vector<double>& weights)
    : m_number_of_vertices(mesh.number_of_vertices()), m_factor(grounded_laplacian(mesh, weights))
  {
    if (m_factor.info() != Eigen::Success)
      throw Solver_exception(
        problem(Problem_kind::SOLVER_FAILURE, "the Laplacian of the mesh cannot be factored"));
  }

  // flux: by vertex
  Eigen::VectorXd operator()(const Eigen::VectorXd& flux) const
  {
    const Eigen::Index last = flux.size() - 1;
    Eigen::VectorXd result = Eigen::VectorXd::Zero(flux.size());
    result.head(last) = m_factor.solve(flux.head(last));
    return result;
  }

  Eigen::VectorXd of_source(int vertex) const
  {
    return (*this)(Eigen::VectorXd::Unit(m_number_of_vertices, vertex));
  }

  // The same, kept for the next time. The reference stays valid.
  const Eigen::VectorXd& of_kept_source(int vertex)
  {
    const auto [it, is_new] = m_kept.try_emplace(vertex);
    if (is_new)
      it->second = of_source(vertex);
    return it->second;
  }

private:
  // The last row and column are left out.
  static Eigen::SparseMatrix<double> grounded_laplacian(const Flat_mesh& mesh,
                                                        const std::vector<double>& weights)
  {
    const int last = mesh.number_of_vertices() - 1;
    std::vector<Eigen::Triplet<double>> entries;
    for (int e = 0; e < mesh.number_of_edges(); ++e)
    {
      const int u = mesh.source(halfedge_of(e)), v = mesh.target(halfedge_of(e));
      for (const int w : {u, v})
        if (w != last)
          entries.emplace_back(w, w, weights[e]);
      if (u != last && v != last)
        entries.emplace_back((std::max)(u, v), (std::min)(u, v), -weights[e]);
    }
    Eigen::SparseMatrix<double> result(last, last);
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  const int m_number_of_vertices;
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> m_factor;
  std::unordered_map<int, Eigen::VectorXd> m_kept; // by vertex
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_VERTEX_POTENTIALS_H
