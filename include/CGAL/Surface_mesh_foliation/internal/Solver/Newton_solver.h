// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_NEWTON_SOLVER_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_NEWTON_SOLVER_H

#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/lengths.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Geodesic_step.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Newton_system.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/balance.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/relax_vertex.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

struct Solver_options
{
  double tolerance = 1e-12;
  int max_iterations = 100;
  // is called after each iteration; the solver stops if it returns false
  std::function<bool(const Foliation_statistics&)> goes_on = [](const Foliation_statistics&) {
    return true;
  };
};

// The harmonic foliation by Newton's method with an active set. As long as no word changes, the
// energy is a quadratic function of the parameters of the vertices in arcs; its minimum is one
// sparse symmetric positive definite solve away. The vertices are carried there along geodesics of
// T, which updates the words; then the vertices near those that changed are relaxed one by one. A
// solve after which no word changes is exact.
template <class LinearSolver>
class Newton_solver
{
public:
  Newton_solver(Foliation_state& state, LinearSolver& linear_solver)
    : m_own_matrix(std::make_unique<Factored_matrix<LinearSolver>>(linear_solver)),
      m_state(state),
      m_step(state),
      m_system(state, *m_own_matrix)
  {}

  // goes on with what another solver has factored
  Newton_solver(Foliation_state& state, Factored_matrix<LinearSolver>& matrix)
    : m_state(state), m_step(state), m_system(state, matrix)
  {}

  // Continues from where the leaves are.
  Foliation_statistics operator()(const Solver_options& options)
  {
    start(options.tolerance);
    for (int i = 0; i < options.max_iterations && !m_statistics.has_converged; ++i)
    {
      find_step();
      take_step();
      if (!options.goes_on(m_statistics))
        break;
    }
    return m_statistics;
  }

  // how far the solver has come since `start()`
  const Foliation_statistics& statistics() const { return m_statistics; }

  void start(double tolerance)
  {
    m_tolerance = tolerance;
    if (m_state.deck().group().is_abelian())
      pin_a_vertex();
    report(0);
  }

  // The parts of an iteration, regardless of the limits. (Between them a visitor may be asked.)

  // The part of the first iteration that does not depend on where the leaves are; it may run before
  // `start()`, and `find_step()` does whatever of it remains.
  void analyze_pattern() { m_system.analyze_pattern(); }

  // Solves the linear system. The leaves stay.
  void find_step() { m_direction = m_system.step(m_pull); }

  // Moves the leaves by the step that `find_step()` has found.
  void take_step()
  {
    const Moves moves = move_leaves();
    report(m_statistics.number_of_iterations + 1);
    m_statistics.number_of_moves = moves.number;
    m_statistics.number_of_changed_vertices = moves.number_of_changed_vertices;
  }

  // Notes that something else has moved the leaves between two iterations.
  void refresh() { report(m_statistics.number_of_iterations); }

private:
  struct Moves
  {
    std::size_t number; // of arrivals at nodes and departures
    std::size_t number_of_changed_vertices;
  };

  // A torus without poles has no singularity, and its foliation can slide along itself.
  void pin_a_vertex()
  {
    for (int v = 0; v < m_state.mesh().number_of_vertices(); ++v)
      if (m_state.is_free_in_arc(v))
        return m_state.fix(v);
  }

  // One step toward the minimum of the quadratic, halved as long as the energy rises (it is convex
  // along the step), then relaxation of the band where words have changed or a vertex is at a node.
  // If only a small part of the step is left, vertices cross nodes where others pull them back, and
  // would again. They stay at the node instead, until the next step has moved the others.
  Moves move_leaves()
  {
    constexpr double small_part = 1. / 8, least_part = 1e-9;
    const double energy = m_statistics.energy;
    const Tree_map before = m_state.map();
    double duration = 1;
    m_step(m_direction, duration);
    while (!m_step.moved().empty() && is_too_far(energy) && duration > least_part)
    {
      m_state.set_map(before);
      duration /= 2;
      m_step(m_direction, duration);
    }
    if (duration < small_part)
    {
      m_state.set_map(before);
      m_step.stopping_at_nodes(m_direction, duration);
      return moves_since(before);
    }
    std::vector<int> band = m_step.moved();
    for (int v = 0; v < m_state.mesh().number_of_vertices(); ++v)
      if (m_state.is_at_node(v) && !m_state.is_fixed(v))
        band.push_back(v);
    relax_band(m_state, band, m_step.moved().empty() ? 0 : rings_of_band,
               sweeps_of_band(static_cast<int>(m_statistics.number_of_iterations) + 1));
    return moves_since(before);
  }

  Moves moves_since(const Tree_map& before) const
  {
    Moves result = {m_step.moved().size(), 0};
    for (std::size_t v = 0; v < before.cell.size(); ++v)
      result.number_of_changed_vertices += m_state.map().cell[v] != before.cell[v];
    return result;
  }

  // Whether the energy is higher after the step than it was before. Close to the minimum the two
  // are equal up to rounding; then the slopes, which are accurate there, tell whether the step
  // ended too high on the other side.
  bool is_too_far(double energy_before) const
  {
    constexpr double rounding = 1e-12;
    const double change = energy_of(m_state) - energy_before;
    return std::abs(change) > rounding * energy_before ? change > 0
                                                       : 2 * m_step.slope() > -m_system.slope();
  }

  void report(std::size_t number_of_iterations)
  {
    m_statistics = balance(m_state, m_pull);
    m_statistics.number_of_iterations = number_of_iterations;
    m_statistics.has_converged = m_statistics.resolved_optimality < m_tolerance;
  }

  std::unique_ptr<Factored_matrix<LinearSolver>> m_own_matrix; // null if another one is used
  Foliation_state& m_state;
  double m_tolerance = 0;
  Foliation_statistics m_statistics;
  std::vector<double> m_pull;  // by vertex, where the leaves are
  Eigen::VectorXd m_direction; // of the next step
  Geodesic_step m_step;
  Newton_system<LinearSolver> m_system;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_NEWTON_SOLVER_H
