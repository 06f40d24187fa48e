// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_HYPRE_OBJECTS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_HYPRE_OBJECTS_H

#if __has_include(<HYPRE_parcsr_ls.h>) && __has_include(<mpi.h>)
#define CGAL_SURFACE_MESH_FOLIATION_HAS_HYPRE

#include <HYPRE.h>
#include <HYPRE_IJ_mv.h>
#include <HYPRE_parcsr_ls.h>
#include <HYPRE_utilities.h>
#include <mpi.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <limits>
#include <memory>
#include <numeric>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Keeps MPI and hypre initialized from the first call until the program ends; MPI only if nothing
// else has initialized it.
inline void initialize_hypre()
{
  struct Session
  {
    Session()
    {
      int is_initialized = 0;
      MPI_Initialized(&is_initialized);
      is_owner = is_initialized == 0;
      if (is_owner)
        MPI_Init(nullptr, nullptr);
      HYPRE_Init();
    }

    ~Session()
    {
      int is_finalized = 0;
      MPI_Finalized(&is_finalized);
      if (!is_owner || is_finalized != 0)
        return;
      HYPRE_Finalize();
      MPI_Finalize();
    }

    bool is_owner;
  };
  static const Session session;
}

// A matrix with its multigrid levels and the conjugate gradient method, in one process.
class Hypre_objects
{
  static_assert(std::is_same<HYPRE_Complex, double>::value,
                "hypre must be built for real numbers of double precision");

  template <class Handle, HYPRE_Int (*destroy)(Handle)>
  struct Destroyer
  {
    using pointer = Handle;
    void operator()(Handle handle) const { destroy(handle); }
  };
  template <class Handle, HYPRE_Int (*destroy)(Handle)>
  using Owner = std::unique_ptr<std::remove_pointer_t<Handle>, Destroyer<Handle, destroy>>;

  using Matrix = Eigen::SparseMatrix<double>;
  using Vector = Eigen::VectorXd;

public:
  struct Result
  {
    bool has_converged;
    int number_of_iterations;
    double residual; // relative to the right-hand side, in the Euclidean norm
  };

  // matrix: symmetric, with all its entries, compressed; not empty
  explicit Hypre_objects(const Matrix& matrix)
    : m_rows(matrix.rows()),
      m_right_side(new_vector(matrix.rows())),
      m_solution(new_vector(matrix.rows()))
  {
    std::iota(m_rows.begin(), m_rows.end(), HYPRE_BigInt(0));
    std::vector<HYPRE_Int> sizes(size());
    for (int i = 0; i < size(); ++i)
      sizes[i] = matrix.outerIndexPtr()[i + 1] - matrix.outerIndexPtr()[i];
    HYPRE_IJMatrix handle = nullptr;
    HYPRE_IJMatrixCreate(MPI_COMM_SELF, 0, size() - 1, 0, size() - 1, &handle);
    m_matrix.reset(handle);
    HYPRE_IJMatrixSetObjectType(handle, HYPRE_PARCSR);
    HYPRE_IJMatrixSetDiagOffdSizes(handle, sizes.data(), std::vector<HYPRE_Int>(size()).data());
    HYPRE_IJMatrixInitialize(handle);
    std::vector<HYPRE_BigInt> columns;
    for (int i = 0; i < size(); ++i)
    {
      const int begin = matrix.outerIndexPtr()[i];
      columns.assign(matrix.innerIndexPtr() + begin, matrix.innerIndexPtr() + begin + sizes[i]);
      HYPRE_IJMatrixSetValues(handle, 1, &sizes[i], &m_rows[i], columns.data(),
                              matrix.valuePtr() + begin);
    }
    HYPRE_IJMatrixAssemble(handle);
  }

  // Computes the levels, and returns whether that was possible.
  bool set_up(double tolerance, int max_iterations)
  {
    HYPRE_ClearAllErrors();
    m_tolerance = tolerance;
    create_preconditioner();
    HYPRE_Solver handle = nullptr;
    HYPRE_ParCSRPCGCreate(MPI_COMM_SELF, &handle);
    m_conjugate_gradients.reset(handle);
    HYPRE_ParCSRPCGSetTol(handle, tolerance);
    HYPRE_ParCSRPCGSetMaxIter(handle, max_iterations);
    HYPRE_ParCSRPCGSetTwoNorm(handle, 1);
    HYPRE_ParCSRPCGSetPrecond(handle, HYPRE_BoomerAMGSolve, HYPRE_BoomerAMGSetup,
                              m_multigrid.get());
    HYPRE_ParCSRPCGSetup(handle, matrix(), values_of(m_right_side), values_of(m_solution));
    return HYPRE_GetError() == 0;
  }

  // Replaces a right-hand side by its solution.
  Result solve(Vector& vector)
  {
    if (!vector.allFinite())
      return {false, 0, std::numeric_limits<double>::quiet_NaN()};
    if (vector.isZero(0))
      return {true, 0, 0};
    HYPRE_ClearAllErrors();
    HYPRE_IJVectorSetValues(m_right_side.get(), size(), m_rows.data(), vector.data());
    vector.setZero();
    HYPRE_IJVectorSetValues(m_solution.get(), size(), m_rows.data(), vector.data());
    const HYPRE_Solver solver = m_conjugate_gradients.get();
    HYPRE_ParCSRPCGSolve(solver, matrix(), values_of(m_right_side), values_of(m_solution));
    const bool is_without_error = HYPRE_GetError() == 0;
    HYPRE_ClearAllErrors();
    HYPRE_IJVectorGetValues(m_solution.get(), size(), m_rows.data(), vector.data());
    HYPRE_Int iterations = 0;
    HYPRE_Real residual = 0;
    HYPRE_ParCSRPCGGetNumIterations(solver, &iterations);
    HYPRE_ParCSRPCGGetFinalRelativeResidualNorm(solver, &residual);
    return {is_without_error && residual <= m_tolerance && vector.allFinite(),
            static_cast<int>(iterations), residual};
  }

private:
  using Owned_vector = Owner<HYPRE_IJVector, HYPRE_IJVectorDestroy>;

  int size() const { return static_cast<int>(m_rows.size()); }

  static Owned_vector new_vector(Eigen::Index size)
  {
    HYPRE_IJVector handle = nullptr;
    HYPRE_IJVectorCreate(MPI_COMM_SELF, 0, static_cast<HYPRE_BigInt>(size - 1), &handle);
    Owned_vector result(handle);
    HYPRE_IJVectorSetObjectType(handle, HYPRE_PARCSR);
    HYPRE_IJVectorInitialize(handle);
    HYPRE_IJVectorAssemble(handle);
    return result;
  }

  static HYPRE_ParVector values_of(const Owned_vector& vector)
  {
    void* result = nullptr;
    HYPRE_IJVectorGetObject(vector.get(), &result);
    return static_cast<HYPRE_ParVector>(result);
  }

  HYPRE_ParCSRMatrix matrix() const
  {
    void* result = nullptr;
    HYPRE_IJMatrixGetObject(m_matrix.get(), &result);
    return static_cast<HYPRE_ParCSRMatrix>(result);
  }

  // One V-cycle. Its smoother is symmetric, as the conjugate gradient method requires.
  void create_preconditioner()
  {
    constexpr HYPRE_Int pmis_coarsening = 8, symmetric_gauss_seidel = 6;
    HYPRE_Solver handle = nullptr;
    HYPRE_BoomerAMGCreate(&handle);
    m_multigrid.reset(handle);
    HYPRE_BoomerAMGSetPrintLevel(handle, 0);
    HYPRE_BoomerAMGSetMaxIter(handle, 1);
    HYPRE_BoomerAMGSetTol(handle, 0);
    HYPRE_BoomerAMGSetCoarsenType(handle, pmis_coarsening);
    HYPRE_BoomerAMGSetRelaxType(handle, symmetric_gauss_seidel);
  }

  std::vector<HYPRE_BigInt> m_rows; // 0, 1, 2, ...: which rows values are given for
  Owned_vector m_right_side, m_solution;
  Owner<HYPRE_IJMatrix, HYPRE_IJMatrixDestroy> m_matrix;
  Owner<HYPRE_Solver, HYPRE_BoomerAMGDestroy> m_multigrid;
  Owner<HYPRE_Solver, HYPRE_ParCSRPCGDestroy> m_conjugate_gradients;
  double m_tolerance = 0;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_HAS_HYPRE

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_HYPRE_OBJECTS_H
