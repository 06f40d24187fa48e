// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_NEWTON_SYSTEM_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_NEWTON_SYSTEM_H

#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/balance.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/lengths.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Closest_signs.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Factored_matrix.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// As long as no word changes, the energy is a quadratic function, and this is its system: symmetric
// positive definite, with a row per vertex; vertices that cannot move are decoupled rows. The
// unknowns are the changes of the parameters times the orientations of the vertices (Tree_map), so
// a vertex that passes a node changes the matrix only where a singularity moves. The matrix is
// factored once, and updated as long as that is less work than another factorization; one that
// another system on the same mesh has factored is updated, too. Letters, words and frames: see the
// glossary in ARCHITECTURE.md.
template <class LinearSolver>
class Newton_system
{
  using Vector = Eigen::VectorXd;

public:
  Newton_system(Foliation_state& state, Factored_matrix<LinearSolver>& matrix)
    : m_state(state), m_matrix(matrix)
  {
    m_matrix.begin(state);
    m_is_factored_by_other = m_matrix.is_factored();
  }

  // Analyzes the pattern, which does not depend on where the leaves are.
  void analyze_pattern() { m_matrix.analyze_pattern(); }

  // the derivative of the energy along the last step at its beginning; negative
  double slope() const { return m_slope; }

  // by vertex: the change of its parameter that minimizes the quadratic; 0 for one that cannot move
  Vector step()
  {
    std::vector<double> pull;
    balance(m_state, pull);
    return step(pull);
  }

  // The same if the forces at the vertices, as `balance()` finds them, are known.
  Vector step(const std::vector<double>& pull)
  {
    Vector result = solve(pull);
    if (!result.allFinite())
      fail("has no finite solution");
    m_slope = -2 * m_right_side.dot(result);
    for (int v = 0; v < m_state.mesh().number_of_vertices(); ++v)
      result[v] *= m_state.orientation(v);
    return result;
  }

private:
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

  void assemble_right_side(const std::vector<double>& pull)
  {
    m_right_side.resize(m_state.mesh().number_of_vertices());
    for (int v = 0; v < m_state.mesh().number_of_vertices(); ++v)
      m_right_side[v] = m_state.orientation(v) * pull[v];
  }

  // Turns vertices so that entries have the signs of those that another system has factored.
  void align_with_other_system()
  {
    std::vector<signed char> agreement(m_state.mesh().number_of_edges());
    for_each_number(m_state.executor(), m_state.mesh().number_of_edges(), [&](int e) {
      const double product = entry(e) * m_matrix.entry(e);
      agreement[e] = static_cast<signed char>((product > 0) - (product < 0));
    });
    if (std::find(agreement.begin(), agreement.end(), -1) == agreement.end())
      return;
    const Closest_signs closest(m_state.mesh(), std::move(agreement));
    for (int v = 0; v < m_state.mesh().number_of_vertices(); ++v)
      if (closest.signs()[v] < 0)
        turn(v);
  }

  // Turns vertices whose entries disagree with those of the factored matrix by more weight than
  // they agree. The weight of the disagreeing entries decreases each time, so this terminates.
  void align_orientations()
  {
    const Flat_mesh& mesh = m_state.mesh();
    const std::vector<int> opposed = collected_numbers<int>(
      m_state.executor(), mesh.number_of_edges(), [&](int e, std::vector<int>& list) {
        if (entry(e) * m_matrix.entry(e) < 0)
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
        const double product = entry(edge_of(h)) * m_matrix.entry(edge_of(h));
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
    return {collected_numbers<Entry>(
      m_state.executor(), m_state.mesh().number_of_edges(), [&](int e, std::vector<Entry>& list) {
        const double difference = entry(e) - m_matrix.entry(e);
        if (difference != 0)
          list.push_back({m_matrix.row(e), m_matrix.column(e), difference});
      })};
  }

  Vector solve(const std::vector<double>& pull)
  {
    find_slopes();
    if constexpr (Is_updatable<LinearSolver>::value)
      if (m_matrix.is_factored())
      {
        if (m_is_factored_by_other)
          align_with_other_system();
        m_is_factored_by_other = false;
        align_orientations();
        assemble_right_side(pull);
        const std::optional<Vector> result = m_matrix.solve(m_right_side, change_of_matrix());
        if (result && result->allFinite() && relative_residual(*result) < largest_residual)
          return *result;
      }
    factorize();
    assemble_right_side(pull);
    return m_matrix.solve(m_right_side);
  }

  // of a solution of the current system, whose entries need not be those of `m_matrix`
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
    m_is_factored_by_other = false;
    if (!m_matrix.factorize(m_state.executor(), [&](int e) { return entry(e); }))
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
  Factored_matrix<LinearSolver>& m_matrix;
  bool m_is_factored_by_other;       // so that orientations have nothing to do with its entries
  std::vector<signed char> m_slopes; // by halfedge, of its source
  Vector m_right_side;
  double m_slope = 0;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_NEWTON_SYSTEM_H
