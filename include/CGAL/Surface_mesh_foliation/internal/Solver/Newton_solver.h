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
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// what the solver tells after each iteration
struct Iteration
{
  int number = 0;
  double energy = 0;
  double optimality = 0;
  double resolved_optimality = 0;     // without what rounding can cause
  int number_of_moves = 0;            // arrivals of vertices at nodes, and departures
  int number_of_changed_vertices = 0; // vertices whose cell changed
};

struct Solver_options
{
  double tolerance = 1e-12;
  int max_iterations = 100;
  std::function<bool(const Iteration&)> goes_on = [](const Iteration&) { return true; };
};

struct Solver_result
{
  Iteration last;
  bool has_converged = false;
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
  Newton_solver(Foliation_state& state, LinearSolver& linear_solver, bool is_pattern_known = false)
    : m_state(state), m_step(state), m_system(state, linear_solver, is_pattern_known)
  {}

  // Goes on from where the leaves are.
  Solver_result operator()(const Solver_options& options)
  {
    start(options.tolerance);
    while (!m_result.has_converged && m_result.last.number < options.max_iterations)
    {
      iterate_once(options.tolerance);
      if (!options.goes_on(m_result.last))
        break;
    }
    return m_result;
  }

  // Does what does not depend on where the leaves are, and the first iteration would do.
  void analyze_pattern() { m_system.analyze_pattern(); }

  Solver_result start(double tolerance)
  {
    if (m_state.deck().group().is_abelian())
      pin_a_vertex();
    m_result.last = report(0);
    m_result.has_converged = m_result.last.resolved_optimality < tolerance;
    return m_result;
  }

  // Does one more iteration, whatever the limits say.
  Solver_result iterate_once(double tolerance)
  {
    const std::vector<Cell> cells = m_state.map().cell;
    const int number_of_moves = iterate(m_result.last.energy);
    m_result.last = report(m_result.last.number + 1);
    m_result.last.number_of_moves = number_of_moves;
    for (std::size_t v = 0; v < cells.size(); ++v)
      m_result.last.number_of_changed_vertices += m_state.map().cell[v] != cells[v];
    m_result.has_converged = m_result.last.resolved_optimality < tolerance;
    return m_result;
  }

  int number_of_factorizations() const { return m_system.number_of_factorizations(); }

private:
  // A torus without pole has no singularity, and its foliation can slide along itself.
  void pin_a_vertex()
  {
    for (int v = 0; v < m_state.mesh().number_of_vertices(); ++v)
      if (m_state.is_free_in_arc(v))
        return m_state.fix(v);
  }

  // One step towards the minimum of the quadratic, halved as long as the energy rises (it is convex
  // along the step), then relaxation of the band where words changed or a vertex sits at a node.
  int iterate(double energy)
  {
    const Eigen::VectorXd step = m_system.step();
    const Tree_map before = m_state.map();
    m_step(step, 1);
    double duration = 1;
    for (int halvings = 0; halvings < 14 && !m_step.moved().empty() && is_too_far(energy);
         ++halvings)
    {
      m_state.set_map(before);
      duration /= 2;
      m_step(step, duration);
    }
    std::vector<int> band = m_step.moved();
    for (int v = 0; v < m_state.mesh().number_of_vertices(); ++v)
      if (m_state.is_at_node(v) && !m_state.is_fixed(v))
        band.push_back(v);
    relax_band(m_state, std::move(band), m_step.moved().empty() ? 0 : rings_of_band,
               sweeps_of_band(m_result.last.number + 1));
    return static_cast<int>(m_step.moved().size());
  }

  // Whether the energy is higher after the step than it was before. Close to the minimum it is
  // equal up to rounding; then the slopes, which are accurate there, tell whether the step ended
  // high on the other side.
  bool is_too_far(double energy_before) const
  {
    constexpr double rounding = 1e-12;
    const double change = energy_of(m_state) - energy_before;
    return std::abs(change) > rounding * energy_before ? change > 0
                                                       : 2 * m_step.slope() > -m_system.slope();
  }

  Iteration report(int number) const
  {
    Iteration result;
    result.number = number;
    const Balance now = balance(m_state);
    result.energy = now.energy;
    result.optimality = now.optimality;
    result.resolved_optimality = now.resolved_optimality;
    return result;
  }

  Foliation_state& m_state;
  Solver_result m_result;
  Geodesic_step m_step;
  Newton_system<LinearSolver> m_system;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_NEWTON_SOLVER_H
