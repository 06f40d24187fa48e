// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_NEWTON_SYSTEM_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_NEWTON_SYSTEM_H

#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/lengths.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Updated_solutions.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// As long as no word changes, the energy is a quadratic function, and this is its system: symmetric
// positive definite, with a row per vertex; vertices that cannot move are decoupled rows. The
// unknowns are the changes of the parameters times the orientations of the vertices (Tree_map), so
// a vertex that passes a node changes the matrix only where a singularity moves. The matrix is
// factored once, and updated as long as that is less work than another factorization. Letters,
// words and frames: see the glossary in ARCHITECTURE.md.
template <class LinearSolver>
class Newton_system
{
  using Matrix = Eigen::SparseMatrix<double>;
  using Vector = Eigen::VectorXd;

public:
  // is_pattern_known: whether the linear solver has analyzed the pattern of this mesh already
  Newton_system(Foliation_state& state, LinearSolver& solver, bool is_pattern_known)
    : m_state(state),
      m_solver(solver),
      m_updated(solver),
      m_is_pattern_known(is_pattern_known),
      m_right_side(state.mesh().number_of_vertices())
  {
    build_pattern();
  }

  int number_of_factorizations() const { return m_number_of_factorizations; }

  // Analyzes the pattern, which does not depend on where the leaves are.
  void analyze_pattern()
  {
    if (!m_is_pattern_known)
      m_solver.analyze_pattern(m_matrix);
    m_is_pattern_known = true;
  }

  // the derivative of the energy along the last step at its beginning; negative
  double slope() const { return m_slope; }

  // by vertex: the change of its parameter that minimizes the quadratic; 0 for one that cannot move
  Vector step()
  {
    Vector result = solve();
    if (!result.allFinite())
      fail("has no finite solution");
    m_slope = -2 * m_right_side.dot(result);
    for (int v = 0; v < m_state.mesh().number_of_vertices(); ++v)
      result[v] *= m_state.orientation(v);
    return result;
  }

private:
  // The lower triangle: one entry per vertex and per edge. Going through the rows in order fills
  // each column in order.
  void build_pattern()
  {
    const Flat_mesh& mesh = m_state.mesh();
    const int n = mesh.number_of_vertices();
    m_matrix.resize(n, n);
    int* begin_of_column = m_matrix.outerIndexPtr();
    for (int e = 0; e < mesh.number_of_edges(); ++e)
      ++begin_of_column[column(e) + 1];
    for (int v = 0; v < n; ++v)
      begin_of_column[v + 1] += begin_of_column[v] + 1;
    m_matrix.resizeNonZeros(begin_of_column[n]);
    std::vector<int> end_of_column(begin_of_column, begin_of_column + n);
    const auto append = [&](int row, int column, double value) {
      const int entry = end_of_column[column]++;
      m_matrix.innerIndexPtr()[entry] = row;
      m_matrix.valuePtr()[entry] = value;
      return entry;
    };
    m_entry_of_edge.resize(mesh.number_of_edges());
    for (int v = 0; v < n; ++v)
    {
      // the vertex in the middle of a cap has no weight, and its equation is x = 0
      const double diagonal = m_state.total_weight(v);
      append(v, v, diagonal == 0 && mesh.is_cap_vertex(v) ? 1 : diagonal);
      for (int h : mesh.ring(v))
        if (mesh.target(h) < v)
          m_entry_of_edge[edge_of(h)] = append(v, mesh.target(h), 0);
    }
  }

  int row(int e) const
  {
    return (std::max)(m_state.mesh().source(halfedge_of(e)), m_state.mesh().target(halfedge_of(e)));
  }
  int column(int e) const
  {
    return (std::min)(m_state.mesh().source(halfedge_of(e)), m_state.mesh().target(halfedge_of(e)));
  }

  // How each w_e changes with the unknowns of its ends; 0 where a vertex cannot move.
  void find_slopes()
  {
    const Flat_mesh& mesh = m_state.mesh();
    m_slopes.assign(mesh.number_of_halfedges(), 0);
    for_each_number(m_state.executor(), mesh.number_of_halfedges(), [&](int h) {
      if (m_state.is_free_in_arc(mesh.source(h)))
        m_slopes[h] = static_cast<signed char>(slope_at_source(m_state, h) *
                                               m_state.orientation(mesh.source(h)));
    });
  }

  double entry(int e) const
  {
    return m_state.weight(e) * m_slopes[halfedge_of(e)] * m_slopes[opposite_of(halfedge_of(e))];
  }

  void turn(int v)
  {
    m_state.turn(v);
    for (int h : m_state.mesh().ring(v))
      m_slopes[h] = static_cast<signed char>(-m_slopes[h]);
  }

  // w_e, signed like its slopes
  double signed_length(int e) const
  {
    const int u = m_state.mesh().source(halfedge_of(e)), v = m_state.mesh().target(halfedge_of(e));
    const bool is_inside_arc = m_state.word_size(e) == 0 && !m_state.is_at_node(u);
    return is_inside_arc ? m_state.parameter(u) - m_state.parameter(v) : length_of_edge(m_state, e);
  }

  void assemble_right_side()
  {
    const Flat_mesh& mesh = m_state.mesh();
    for_each_number(m_state.executor(), mesh.number_of_vertices(), [&](int v) {
      double sum = 0;
      if (m_state.is_free_in_arc(v))
        for (int h : mesh.ring(v))
          sum -= m_state.weight(edge_of(h)) * signed_length(edge_of(h)) * m_slopes[h];
      m_right_side[v] = sum;
    });
  }

  // the matrix that was factored last, off the diagonal
  double factored_entry(int e) const { return m_matrix.valuePtr()[m_entry_of_edge[e]]; }

  // Turns vertices whose entries disagree with those of the factored matrix by more weight than
  // they agree. The weight of the disagreeing entries decreases each time, so this terminates.
  void align_orientations()
  {
    const Flat_mesh& mesh = m_state.mesh();
    const std::vector<int> opposed = collected_numbers<int>(
      m_state.executor(), mesh.number_of_edges(), [&](int e, std::vector<int>& list) {
        if (entry(e) * factored_entry(e) < 0)
          list.insert(list.end(), {mesh.source(halfedge_of(e)), mesh.target(halfedge_of(e))});
      });
    std::deque<int> queue(opposed.begin(), opposed.end());
    while (!queue.empty())
    {
      const int v = queue.front();
      queue.pop_front();
      double opposition = 0, total = 0;
      for (int h : mesh.ring(v))
      {
        const double product = entry(edge_of(h)) * factored_entry(edge_of(h));
        const double weight = std::abs(m_state.weight(edge_of(h)));
        opposition += product < 0 ? weight : product > 0 ? -weight : 0;
        total += weight;
      }
      if (opposition <= least_gain * total)
        continue;
      turn(v);
      for (int h : mesh.ring(v))
        queue.push_back(mesh.target(h));
    }
  }

  Matrix_change change_of_matrix() const
  {
    using Entry = Matrix_change::Entry;
    return {collected_numbers<Entry>(m_state.executor(), m_state.mesh().number_of_edges(),
                                     [&](int e, std::vector<Entry>& list) {
                                       const double difference = entry(e) - factored_entry(e);
                                       if (difference != 0)
                                         list.push_back({row(e), column(e), difference});
                                     })};
  }

  Vector solve()
  {
    find_slopes();
    if constexpr (Is_updatable<LinearSolver>::value)
      if (m_number_of_factorizations > 0)
      {
        align_orientations();
        assemble_right_side();
        const std::optional<Vector> result = m_updated(m_right_side, change_of_matrix());
        if (result && result->allFinite() && relative_residual(*result) < largest_residual)
          return *result;
      }
    factorize();
    assemble_right_side();
    return m_solver.solve(m_right_side);
  }

  // of a solution of the current system, which need not be that of `m_matrix`
  double relative_residual(const Vector& solution) const
  {
    const Flat_mesh& mesh = m_state.mesh();
    Vector residual(m_right_side.size());
    for_each_number(m_state.executor(), mesh.number_of_vertices(), [&](int v) {
      double image = m_state.total_weight(v) * solution[v];
      for (int h : mesh.ring(v))
        image += entry(edge_of(h)) * solution[mesh.target(h)];
      residual[v] = m_right_side[v] - image;
    });
    const double size = m_right_side.cwiseAbs().maxCoeff();
    return size > 0 ? residual.cwiseAbs().maxCoeff() / size : 0;
  }

  void factorize()
  {
    for_each_number(m_state.executor(), m_state.mesh().number_of_edges(),
                    [&](int e) { m_matrix.valuePtr()[m_entry_of_edge[e]] = entry(e); });
    analyze_pattern();
    ++m_number_of_factorizations;
    m_updated.forget();
    if constexpr (Takes_executor<LinearSolver>::value)
      m_solver.set_executor(m_state.executor());
    if (!m_solver.factorize(m_matrix))
      fail("could not be factored");
  }

  [[noreturn]] static void fail(const char* what)
  {
    throw Solver_exception(
      problem(Problem_kind::SOLVER_FAILURE, "the linear system of the foliation ", what));
  }

  // of the weight of a vertex: smaller gains may be due to rounding
  static constexpr double least_gain = 1e-9;
  // of an updated solution, which may lose accuracy if the matrix was nearly singular; the next
  // iteration reduces the remaining error
  static constexpr double largest_residual = 1e-6;

  Foliation_state& m_state;
  LinearSolver& m_solver;
  std::conditional_t<Is_updatable<LinearSolver>::value, Updated_solutions<LinearSolver>, No_updates>
    m_updated;
  bool m_is_pattern_known;
  Matrix m_matrix; // the lower triangle, as it was factored last
  std::vector<int> m_entry_of_edge;
  std::vector<signed char> m_slopes; // by halfedge, of its source
  Vector m_right_side;
  double m_slope = 0;
  int m_number_of_factorizations = 0;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_NEWTON_SYSTEM_H
