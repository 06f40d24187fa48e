// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FEATURES_LAPLACIAN_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FEATURES_LAPLACIAN_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/weights_of_flat_mesh.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The finite element Laplacian S (cotangents) and the lumped masses m of a surface scaled to area
// 1. A sliver is treated as a triangle whose largest cotangent is exactly `largest_cotangent`: its
// entire stiffness is scaled, so that S stays positive semidefinite.
class Laplacian
{
public:
  explicit Laplacian(const Flat_mesh& mesh)
    : m_weight(mesh.number_of_edges(), 0), m_mass(Eigen::VectorXd::Zero(mesh.number_of_vertices()))
  {
    Corner_geometry corner(mesh);
    for (int f = 0; f < mesh.number_of_faces(); ++f)
    {
      const std::array<int, 3> halfedges = mesh.halfedges(f);
      std::array<double, 3> cotangents;
      double largest = largest_cotangent, area = 0;
      for (int i : {0, 1, 2})
      {
        corner.visit(halfedges[i]);
        cotangents[i] = corner.cotangent();
        largest = (std::max)(largest, std::abs(cotangents[i]));
        area = (std::max)(area, corner.area());
      }
      for (int i : {0, 1, 2})
      {
        m_weight[edge_of(mesh.next(halfedges[i]))] +=
          cotangents[i] * (largest_cotangent / largest) / 2;
        m_mass[mesh.source(halfedges[i])] += area / 3;
      }
    }
    m_mass /= m_mass.sum();
    const double least_mass = 1e-12 / static_cast<double>(m_mass.size());
    m_mass = m_mass.cwiseMax(least_mass);
  }

  const Eigen::VectorXd& mass() const { return m_mass; }

  // S + shift * diag(m); only the lower half is set
  Eigen::SparseMatrix<double> shifted(const Flat_mesh& mesh, double shift) const
  {
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd diagonal = shift * m_mass;
    for (int e = 0; e < mesh.number_of_edges(); ++e)
    {
      const int u = mesh.source(halfedge_of(e)), v = mesh.target(halfedge_of(e));
      diagonal[u] += m_weight[e];
      diagonal[v] += m_weight[e];
      entries.emplace_back((std::max)(u, v), (std::min)(u, v), -m_weight[e]);
    }
    for (int v = 0; v < mesh.number_of_vertices(); ++v)
      entries.emplace_back(v, v, diagonal[v]);
    Eigen::SparseMatrix<double> result(mesh.number_of_vertices(), mesh.number_of_vertices());
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

private:
  static constexpr double largest_cotangent = 1e5;

  std::vector<double> m_weight; // by edge
  Eigen::VectorXd m_mass;       // by vertex
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FEATURES_LAPLACIAN_H
