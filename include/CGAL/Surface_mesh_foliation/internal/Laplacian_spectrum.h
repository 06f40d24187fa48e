// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LAPLACIAN_SPECTRUM_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LAPLACIAN_SPECTRUM_H

#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Laplacian.h>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <Spectra/SymEigsSolver.h>

#include <algorithm>
#include <random>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// x -> M^1/2 (S + shift M)^-1 M^1/2 x, in the form that Spectra asks for
class Inverse_laplacian
{
public:
  using Scalar = double;

  Inverse_laplacian(const Eigen::SparseMatrix<double>& matrix, const Eigen::VectorXd& mass)
    : m_factor(matrix), m_root(mass.cwiseSqrt())
  {
    if (m_factor.info() != Eigen::Success)
      throw Solver_exception(
        {Problem_kind::SOLVER_FAILURE, "the Laplacian could not be factored", {}, {}, {}});
  }

  Eigen::Index rows() const { return m_root.size(); }
  Eigen::Index cols() const { return m_root.size(); }
  const Eigen::VectorXd& root_of_mass() const { return m_root; }

  void perform_op(const double* x, double* y) const
  {
    const Eigen::VectorXd right = m_root.cwiseProduct(Eigen::Map<const Eigen::VectorXd>(x, rows()));
    Eigen::Map<Eigen::VectorXd>(y, rows()) = m_root.cwiseProduct(m_factor.solve(right));
  }

private:
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> m_factor;
  Eigen::VectorXd m_root;
};

// The smallest eigenvalues of the Laplacian of a surface scaled to area 1, in increasing order, 0
// first, and eigenfunctions of mean square 1, one a column.
struct Spectrum
{
  Eigen::VectorXd values;
  Eigen::MatrixXd functions;
};

// Shift and invert: the largest eigenvalues of the inverse, by Lanczos. It starts with a fixed
// vector that has no symmetry. Precondition: 1 < number < number of vertices.
inline Spectrum laplacian_spectrum(const Flat_mesh& mesh, int number)
{
  constexpr double shift = 1, tolerance = 1e-8;
  constexpr int max_restarts = 1000;
  const Laplacian laplacian(mesh);
  Inverse_laplacian inverse(laplacian.shifted(mesh, shift), laplacian.mass());

  std::mt19937 random; // the same numbers everywhere
  Eigen::VectorXd start = inverse.root_of_mass();
  for (double& x : start)
    x *= 0.5 + static_cast<double>(random()) / 4294967296.;
  Spectra::SymEigsSolver<Inverse_laplacian> solver(
    inverse, number, (std::min)(2 * number + 10, mesh.number_of_vertices()));
  solver.init(start.data());
  if (solver.compute(Spectra::SortRule::LargestAlge, max_restarts, tolerance) < number)
    throw Solver_exception({Problem_kind::SOLVER_FAILURE,
                            "the eigenfunctions of the Laplacian have not converged",
                            {},
                            {},
                            {}});
  Spectrum result;
  result.values = (solver.eigenvalues().cwiseInverse().array() - shift).max(0.);
  result.functions = inverse.root_of_mass().cwiseInverse().asDiagonal() * solver.eigenvectors();
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LAPLACIAN_SPECTRUM_H
