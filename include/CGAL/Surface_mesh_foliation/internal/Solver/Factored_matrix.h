// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_FACTORED_MATRIX_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_FACTORED_MATRIX_H

#include <CGAL/Surface_mesh_foliation/internal/Common/Executor.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Updated_solutions.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/carried_map.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The matrix of a Newton_system as it was factored last, and what the linear solver knows about it:
// a row per vertex, the lower triangle, with an entry per vertex and per edge. It outlives the
// system, so that the next one on the same mesh need not begin anew.
template <class LinearSolver>
class Factored_matrix
{
  using Matrix = Eigen::SparseMatrix<double>;
  using Vector = Eigen::VectorXd;

public:
  explicit Factored_matrix(LinearSolver& solver) : m_solver(solver), m_updated(solver) {}

  Factored_matrix(const Factored_matrix&) = delete;
  Factored_matrix& operator=(const Factored_matrix&) = delete;

  // Makes the matrix one of this mesh with these weights. Keeps the analysis if the mesh is
  // connected as before, and the factorization if the diagonal is as before, too.
  void begin(const Foliation_state& state)
  {
    const bool is_same_mesh = m_mesh && have_same_connectivity(*m_mesh, state.mesh());
    if (!is_same_mesh)
      build_pattern(state.mesh());
    m_mesh = state.mesh();
    const bool is_same_diagonal = set_diagonal(state);
    m_is_analyzed = m_is_analyzed && is_same_mesh;
    m_is_factored = m_is_factored && is_same_mesh && is_same_diagonal;
    if (!m_is_factored)
      m_updated.forget();
  }

  // Frees the memory, but for the linear solver's.
  void clear()
  {
    m_mesh.reset();
    m_matrix = Matrix();
    m_entry_of_edge = {};
    m_is_analyzed = m_is_factored = false;
    m_updated.forget();
  }

  bool is_factored() const { return m_is_factored; }

  // off the diagonal
  double entry(int e) const { return m_matrix.valuePtr()[m_entry_of_edge[e]]; }
  int row(int e) const
  {
    return (std::max)(m_mesh->source(halfedge_of(e)), m_mesh->target(halfedge_of(e)));
  }
  int column(int e) const
  {
    return (std::min)(m_mesh->source(halfedge_of(e)), m_mesh->target(halfedge_of(e)));
  }

  // Analyzes the pattern, which does not depend on the entries.
  void analyze_pattern()
  {
    if (m_is_analyzed)
      return;
    m_solver.analyze_pattern(m_matrix);
    m_is_analyzed = true;
  }

  // Factors the matrix with the entries entry_of(e). Returns whether it could.
  template <class Entry_of>
  bool factorize(const Executor& executor, const Entry_of& entry_of)
  {
    m_is_factored = false;
    m_updated.forget();
    for_each_number(executor, m_mesh->number_of_edges(),
                    [&](int e) { m_matrix.valuePtr()[m_entry_of_edge[e]] = entry_of(e); });
    analyze_pattern();
    if constexpr (Takes_executor<LinearSolver>::value)
      m_solver.set_executor(executor);
    m_is_factored = m_solver.factorize(m_matrix);
    return m_is_factored;
  }

  Vector solve(const Vector& right_side) const { return m_solver.solve(right_side); }

  // The solution with other entries; nothing if another factorization would be less work.
  std::optional<Vector> solve(const Vector& right_side, const Matrix_change& change)
  {
    return m_updated(right_side, change);
  }

private:
  // Going through the rows in order fills each column in order.
  void build_pattern(const Flat_mesh& mesh)
  {
    const int n = mesh.number_of_vertices();
    m_matrix.resize(n, n);
    int* begin_of_column = m_matrix.outerIndexPtr();
    for (int e = 0; e < mesh.number_of_edges(); ++e)
    {
      const int h = halfedge_of(e);
      ++begin_of_column[(std::min)(mesh.source(h), mesh.target(h)) + 1];
    }
    for (int v = 0; v < n; ++v)
      begin_of_column[v + 1] += begin_of_column[v] + 1;
    m_matrix.resizeNonZeros(begin_of_column[n]);
    std::vector<int> end_of_column(begin_of_column, begin_of_column + n);
    const auto append = [&](int row, int column) {
      const int entry = end_of_column[column]++;
      m_matrix.innerIndexPtr()[entry] = row;
      m_matrix.valuePtr()[entry] = 0;
      return entry;
    };
    m_entry_of_edge.resize(mesh.number_of_edges());
    for (int v = 0; v < n; ++v)
    {
      append(v, v);
      for (int h : mesh.ring(v))
        if (mesh.target(h) < v)
          m_entry_of_edge[edge_of(h)] = append(v, mesh.target(h));
    }
  }

  // Returns whether nothing changed.
  bool set_diagonal(const Foliation_state& state)
  {
    bool is_same = true;
    for (int v = 0; v < state.mesh().number_of_vertices(); ++v)
    {
      // the vertex in the middle of a cap has no weight, and its equation is x = 0
      const double weight = state.total_weight(v);
      const double value = weight == 0 && state.mesh().is_cap_vertex(v) ? 1 : weight;
      double& entry = m_matrix.valuePtr()[m_matrix.outerIndexPtr()[v]];
      is_same = is_same && entry == value;
      entry = value;
    }
    return is_same;
  }

  LinearSolver& m_solver;
  std::conditional_t<Is_updatable<LinearSolver>::value, Updated_solutions<LinearSolver>, No_updates>
    m_updated;
  std::optional<Flat_mesh> m_mesh;
  Matrix m_matrix;
  std::vector<int> m_entry_of_edge;
  bool m_is_analyzed = false, m_is_factored = false;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_FACTORED_MATRIX_H
