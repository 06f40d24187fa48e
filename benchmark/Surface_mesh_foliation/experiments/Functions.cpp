// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Functions.h"

#include <CGAL/Surface_mesh_foliation/internal/Common/Executor.h>
#include <CGAL/Surface_mesh_foliation/internal/Features/Laplacian_spectrum.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/weights_of_flat_mesh.h>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace smf_experiments {

namespace {

Values heights(const Mesh& mesh, int coordinate)
{
  Values result;
  for (const Vertex v : vertices(mesh))
    result.push_back(mesh.point(v)[coordinate]);
  return result;
}

// The eigenfunctions of the Laplacian that others are made of.
class Spectral_functions
{
public:
  explicit Spectral_functions(const Mesh& mesh, int number = 30)
    : m_spectrum(SMF::internal::laplacian_spectrum(flat_mesh(mesh), number))
  {}

  // the first one that is not constant
  Values first_eigenfunction() const
  {
    const Eigen::VectorXd column = m_spectrum.functions.col(1);
    return {column.begin(), column.end()};
  }

  // the commute-time distance from the nearest of some vertices
  Values commute_time_distances(const std::vector<Vertex>& sources) const
  {
    const Eigen::Index n = m_spectrum.functions.rows(), last = m_spectrum.values.size() - 1;
    const Eigen::MatrixXd embedding =
      m_spectrum.functions.rightCols(last) *
      m_spectrum.values.tail(last).cwiseSqrt().cwiseInverse().asDiagonal();
    Values result;
    for (Eigen::Index v = 0; v < n; ++v)
    {
      double least = std::numeric_limits<double>::infinity();
      for (const Vertex s : sources)
        least = (std::min)(least, (embedding.row(v) - embedding.row(s.idx())).norm());
      result.push_back(least);
    }
    return result;
  }

private:
  SMF::internal::Spectrum m_spectrum;
};

enum class Weights { COTANGENT, MEAN_VALUE };

// The harmonic function that is 0 at the first pole and 1 at the others.
Values harmonic_function(const Mesh& mesh, const std::vector<Vertex>& poles, Weights kind)
{
  const SMF::internal::Flat_mesh flat = flat_mesh(mesh);
  const auto& executor = SMF::internal::executor_for<CGAL::Sequential_tag>();
  const std::vector<double> weights = kind == Weights::COTANGENT
                                        ? SMF::internal::cotangent_weights(flat, executor)
                                        : SMF::internal::mean_value_weights(flat, executor);
  const int n = flat.number_of_vertices();
  std::vector<double> fixed(n, -1);
  for (const Vertex pole : poles)
    fixed[pole.idx()] = pole == poles.front() ? 0 : 1;
  const auto is_free = [&](int v) { return fixed[v] < 0; };

  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  for (int v = 0; v < n; ++v)
    if (!is_free(v))
    {
      entries.emplace_back(v, v, 1);
      right[v] = fixed[v];
    }
  for (int e = 0; e < flat.number_of_edges(); ++e)
  {
    const int h = SMF::internal::halfedge_of(e), ends[] = {flat.source(h), flat.target(h)};
    for (const int i : {0, 1})
    {
      const int u = ends[i], v = ends[1 - i];
      if (!is_free(u))
        continue;
      entries.emplace_back(u, u, weights[e]);
      if (is_free(v))
        entries.emplace_back(u, v, -weights[e]);
      else
        right[u] += weights[e] * fixed[v];
    }
  }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
  if (factor.info() != Eigen::Success)
    throw std::runtime_error("a harmonic function cannot be computed");
  const Eigen::VectorXd solution = factor.solve(right);
  return {solution.begin(), solution.end()};
}

} // namespace

std::vector<Named_function> all_functions(const Mesh& mesh,
                                          int up,
                                          const std::vector<Vertex>& poles)
{
  const Spectral_functions spectral(mesh);
  return {{"height", heights(mesh, up)},
          {"geodesic distance", geodesic_distances(mesh, poles)},
          {"commute-time distance", spectral.commute_time_distances(poles)},
          {"first eigenfunction", spectral.first_eigenfunction()},
          {"harmonic (cotangent)", harmonic_function(mesh, poles, Weights::COTANGENT)},
          {"harmonic (mean value)", harmonic_function(mesh, poles, Weights::MEAN_VALUE)}};
}

} // namespace smf_experiments
