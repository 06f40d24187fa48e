// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FEATURES_LAPLACIAN_SPECTRUM_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FEATURES_LAPLACIAN_SPECTRUM_H

#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Features/Laplacian.h>

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
        problem(Problem_kind::SOLVER_FAILURE, "the Laplacian could not be factored"));
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
// first, and eigenfunctions of mean square 1, one per column.
struct Spectrum
{
  Eigen::VectorXd values;
  Eigen::MatrixXd functions;
};

// The same without eigenvectors that are already known: these get the eigenvalue 0.
class Deflated_operator
{
public:
  using Scalar = double;

  Deflated_operator(const Inverse_laplacian& inverse, const Spectrum& known)
    : m_inverse(inverse), m_known(known)
  {}

  Eigen::Index rows() const { return m_inverse.rows(); }
  Eigen::Index cols() const { return m_inverse.cols(); }

  void perform_op(const double* x, double* y) const
  {
    m_inverse.perform_op(x, y);
    const Eigen::VectorXd components =
      m_known.functions.transpose() * Eigen::Map<const Eigen::VectorXd>(x, rows());
    Eigen::Map<Eigen::VectorXd>(y, rows()) -=
      m_known.functions * m_known.values.cwiseProduct(components);
  }

private:
  const Inverse_laplacian& m_inverse;
  const Spectrum& m_known;
};

// The largest eigenvalues of an operator, in decreasing order, by Lanczos. It starts with a fixed
// vector without symmetry.
template <class Operator>
Spectrum largest_eigenvalues(Operator& op, int number)
{
  constexpr double tolerance = 1e-8;
  constexpr int max_restarts = 1000;
  std::mt19937 random; // the same numbers everywhere
  Eigen::VectorXd start(op.rows());
  for (double& x : start)
    x = 0.5 + static_cast<double>(random()) / 4294967296.;
  Spectra::SymEigsSolver<Operator> solver(op, number,
                                          (std::min)(2 * number + 10, static_cast<int>(op.rows())));
  solver.init(start.data());
  if (solver.compute(Spectra::SortRule::LargestAlge, max_restarts, tolerance) < number)
    throw Solver_exception(problem(Problem_kind::SOLVER_FAILURE,
                                   "the eigenfunctions of the Laplacian have not converged"));
  return {solver.eigenvalues(), solver.eigenvectors()};
}

// Inserts the eigenpairs of `more` into `all`, sorted by value, and drops as many of the smallest.
inline void insert(const Spectrum& more, Spectrum& all)
{
  for (Eigen::Index i = 0; i < more.values.size(); ++i)
    for (Eigen::Index j = 0; j < all.values.size(); ++j)
      if (more.values[i] > all.values[j])
      {
        for (Eigen::Index k = all.values.size() - 1; k > j; --k)
        {
          all.values[k] = all.values[k - 1];
          all.functions.col(k) = all.functions.col(k - 1);
        }
        all.values[j] = more.values[i];
        all.functions.col(j) = more.functions.col(i);
        break;
      }
}

// By shift and invert. On a symmetric mesh an eigenvalue has several eigenfunctions, of which
// Lanczos may miss some; so the space orthogonal to all that have been found is searched for more,
// until nothing in it is larger than the smallest of those found. Precondition: 1 < number < number
// of vertices.
inline Spectrum laplacian_spectrum(const Flat_mesh& mesh, int number)
{
  constexpr double shift = 1, rounding = 1e-6;
  const Laplacian laplacian(mesh);
  Inverse_laplacian inverse(laplacian.shifted(mesh, shift), laplacian.mass());
  Spectrum result = largest_eigenvalues(inverse, number);
  for (int i = 0; i < number; ++i)
  {
    Deflated_operator rest(inverse, result);
    const Spectrum missed = largest_eigenvalues(rest, (std::min)(4, mesh.number_of_vertices() - 1));
    if (missed.values[0] <= (1 + rounding) * result.values[number - 1])
      break;
    insert(missed, result);
  }
  result.values = (result.values.cwiseInverse().array() - shift).max(0.);
  result.functions = (inverse.root_of_mass().cwiseInverse().asDiagonal() * result.functions).eval();
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FEATURES_LAPLACIAN_SPECTRUM_H
