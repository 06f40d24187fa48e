// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_BOOMER_AMG_SOLVER_H
#define CGAL_SURFACE_MESH_FOLIATION_BOOMER_AMG_SOLVER_H

#include <CGAL/Surface_mesh_foliation/internal/Solver/Hypre_objects.h>

#if defined(CGAL_SURFACE_MESH_FOLIATION_HAS_HYPRE) || defined(DOXYGEN_RUNNING)

#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/balanced_signs.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>
#include <string>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationLinearSolvers

is the conjugate gradient method preconditioned by one V-cycle of BoomerAMG, the algebraic multigrid
of hypre: an iterative solver for meshes whose factor does not fit into memory. It takes memory
linear in the size of the mesh, and about fifty to a hundred iterations per system, hardly more for
larger meshes.

A V-cycle works best for matrices whose entries off the diagonal are negative. Those of a foliation
have signs, which depend on how vertices are oriented; the solver flips vertices along a
breadth-first tree; the entries that cannot be made negative lie along curves that join
singularities.

The class exists, and the macro `CGAL_SURFACE_MESH_FOLIATION_HAS_HYPRE` is defined, if the headers
`HYPRE_parcsr_ls.h` of hypre and `mpi.h` are found; a program that uses it is linked with the
libraries `HYPRE` and `mpi`. hypre runs in a single process here, but still needs MPI: if MPI has
not been initialized when the first solver is constructed, the solver initializes it, and MPI is
finalized at the end of the program. A program that uses MPI itself must initialize it before that,
and finalize it after its last solver is destroyed. hypre keeps global data: only one thread at a
time may use solvers.

Equal systems have equal solutions, bit by bit, on one machine.

It is a model of `FoliationLinearSolver`. A result that is less accurate than that of a
factorization costs `harmonic_foliation()` at most a few more iterations: it iterates until the
foliation itself meets the tolerance of that function.
*/
class Boomer_amg_solver
{
public:
  /// constructs a solver.
  ///
  /// \param tolerance how large the residual of a solution may be relative to the right-hand side,
  ///   both in the Euclidean norm; between 0 and 1
  /// \param max_iterations how many iterations one system may take; positive
  ///
  /// \throws Invalid_parameter_exception if a parameter is out of its range
  explicit Boomer_amg_solver(double tolerance = 1e-10, int max_iterations = 1000)
    : m_tolerance(tolerance), m_max_iterations(max_iterations)
  {
    if (!(tolerance > 0 && tolerance < 1))
      refuse(internal::text("the tolerance of the linear solver must lie between 0 and 1, not ",
                            tolerance));
    if (max_iterations < 1)
      refuse(internal::text("the linear solver must be allowed at least one iteration, not ",
                            max_iterations));
    internal::initialize_hypre();
  }

  /// returns the tolerance.
  double tolerance() const { return m_tolerance; }

  /// returns how many iterations one system may take.
  int max_iterations() const { return m_max_iterations; }

  /// returns how many iterations the last system took.
  int number_of_iterations() const { return m_number_of_iterations; }

  /// \cond SKIP_IN_MANUAL
  using Matrix = Eigen::SparseMatrix<double>;
  using Vector = Eigen::VectorXd;

  // multigrid computes its levels anew for each matrix
  void analyze_pattern(const Matrix&) {}

  // A matrix that is finite and has a positive diagonal, but is not positive definite, is not
  // detected here; if the iterations do not notice it either, what they return counts as a
  // solution.
  bool factorize(const Matrix& matrix)
  {
    m_objects.reset();
    if (matrix.rows() == 0 || !matrix.coeffs().allFinite() ||
        !(matrix.diagonal().array() > 0).all())
      return false;
    // hypre makes a copy of the matrix
    m_objects = std::make_unique<internal::Hypre_objects>(with_balanced_signs(matrix));
    return m_objects->set_up(m_tolerance, m_max_iterations);
  }

  Vector solve(const Vector& right_side)
  {
    Vector result = m_signs.cwiseProduct(right_side);
    const auto [has_converged, iterations, residual] = m_objects->solve(result);
    m_number_of_iterations = iterations;
    if (!has_converged)
      throw Solver_exception(internal::problem(
        Problem_kind::SOLVER_FAILURE, "the linear solver stopped at the relative residual ",
        residual, ", above its tolerance ", m_tolerance, ", after ", iterations, " iterations"));
    return m_signs.cwiseProduct(result);
  }
  /// \endcond

private:
  [[noreturn]] static void refuse(const std::string& message)
  {
    throw Invalid_parameter_exception(internal::problem(Problem_kind::INVALID_PARAMETER, message));
  }

  // all entries except zeros; chooses `m_signs`
  Matrix with_balanced_signs(const Matrix& lower_triangle)
  {
    Matrix result = lower_triangle.selfadjointView<Eigen::Lower>();
    result.prune([](int, int, double value) { return value != 0; });
    m_signs = internal::balanced_signs(result);
    for (int j = 0; j < result.cols(); ++j)
      for (Matrix::InnerIterator it(result, j); it; ++it)
        it.valueRef() *= m_signs[it.row()] * m_signs[j];
    return result;
  }

  double m_tolerance;
  int m_max_iterations;
  int m_number_of_iterations = 0;
  Vector m_signs; // how the given matrix differs from the one that hypre has
  std::unique_ptr<internal::Hypre_objects> m_objects;
};

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_HAS_HYPRE

#endif // CGAL_SURFACE_MESH_FOLIATION_BOOMER_AMG_SOLVER_H
