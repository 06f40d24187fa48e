// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_NEWTON_STEPS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_NEWTON_STEPS_H

#include <CGAL/Surface_mesh_foliation/internal/Common/compiled.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_statistics.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Newton_solver.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Progress.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Supernodal_cholesky_solver.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/start_from_coarse.h>

#include <cstddef>
#include <memory>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Steps of Newton's method for a foliation that another solver has brought close to the harmonic
// one. Nothing is computed before the first step.
class Newton_steps
{
public:
  Newton_steps(Foliation_state& state, double tolerance) : m_state(state), m_tolerance(tolerance) {}

  // Does one step; the report counts it as one of the other solver's iterations.
  Foliation_statistics next(std::size_t number_of_iterations, const Poll& poll);

private:
  Foliation_state& m_state;
  double m_tolerance;
  Supernodal_cholesky_solver m_linear;
  std::unique_ptr<Newton_solver<Supernodal_cholesky_solver>> m_solver;
};

#if CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES
CGAL_SURFACE_MESH_FOLIATION_INLINE Foliation_statistics
Newton_steps::next(std::size_t number_of_iterations, const Poll& poll)
{
  if (!m_solver)
  {
    m_solver = std::make_unique<Newton_solver<Supernodal_cholesky_solver>>(m_state, m_linear);
    m_solver->start(m_tolerance);
  }
  poll();
  if (move_tied_vertices_as_one(m_state, m_solver->statistics().number_of_iterations))
    m_solver->refresh();
  m_solver->find_step();
  poll();
  m_solver->take_step();
  Foliation_statistics result = m_solver->statistics();
  result.number_of_iterations = number_of_iterations + 1;
  return result;
}
#endif // CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_NEWTON_STEPS_H
