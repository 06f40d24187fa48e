// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_FOLIATION_SOLVER_H
#define CGAL_SURFACE_MESH_FOLIATION_FOLIATION_SOLVER_H

#include <CGAL/Surface_mesh_foliation/Foliation_visitor.h>
#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>
#include <CGAL/Surface_mesh_foliation/Simplicial_cholesky_solver.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/Executor.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Newton_solver.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/carried_map.h>
#include <CGAL/Surface_mesh_foliation/edge_weights.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/certify.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/solver_options.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/solver_visitor.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/start_from_coarse.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <memory>
#include <utility>

namespace CGAL {
namespace Surface_mesh_foliation {

namespace internal {

using Start_parameters = Joined_parameters<Weight_parameters, internal_np::tolerance_t>;
using Solver_parameters = Joined_parameters<Start_parameters,
                                            CGAL::internal_np::number_of_iterations_t,
                                            CGAL::internal_np::visitor_t>;

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationFoliation

computes harmonic foliations one after the other, step by step if need be, and keeps what the next
one can use. `harmonic_foliation()` is one run of it.

- If the mesh has the connectivity of the one before (the same mesh, or another pose of it), the
  symbolic analysis of the linear solver is kept.
- If, besides, the poles and the edges that the loops cross are the same, the run starts from the
  last solution: after a change of heights or weights, or in another pose.
- Otherwise, say if a pole was moved or a loop added, it starts from the solution on coarser meshes.

Where a run starts has no influence on the foliation that it converges to.

\tparam TriangleMesh see `Loop_system`
\tparam LinearSolver a model of `FoliationLinearSolver`
\tparam ConcurrencyTag see `harmonic_foliation()`
*/
template <class TriangleMesh,
          class LinearSolver = Simplicial_cholesky_solver,
          class ConcurrencyTag = CGAL::Sequential_tag>
class Foliation_solver
{
public:
  /// constructs a solver with a linear solver of its own, default constructed.
  Foliation_solver()
    : m_own_linear_solver(std::make_unique<LinearSolver>()), m_linear_solver(*m_own_linear_solver)
  {}

  /// constructs a solver that uses the given linear solver, which must live as long, and which
  /// nobody else uses.
  explicit Foliation_solver(LinearSolver& linear_solver) : m_linear_solver(linear_solver) {}

  /// runs the solver to its end: `start()`, `iterate()` as long as it is needed and allowed, and
  /// `foliation()`. The named parameters and exceptions are those of `harmonic_foliation()`, but
  /// for the linear solver.
  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  Measured_foliation<TriangleMesh> solve(
    const Loop_system<TriangleMesh>& system,
    const NamedParameters& np = CGAL::parameters::default_values())
  {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    internal::check_parameters<internal::Solver_parameters>(np);
    auto visitor =
      choose_parameter(get_parameter(np, CGAL::internal_np::visitor), Default_foliation_visitor());
    const int max_iterations =
      internal::solver_options(np, internal::Solver_options()).max_iterations;
    start(system, internal::select<internal::Start_parameters>(np),
          internal::coarse_progress(internal::unwrapped(visitor)));
    for (int i = 0; i < max_iterations && !statistics().has_converged && m_is_going_on; ++i)
    {
      iterate();
      if (!internal::unwrapped(visitor).after_iteration(statistics()))
        break;
    }
    return foliation();
  }

  /// \name Steps
  /// @{

  /// begins a run. Of the named parameters of `harmonic_foliation()` it takes `weights`,
  /// `allow_any_weights` and `tolerance`.
  ///
  /// \throws Invalid_parameter_exception if a weight is not finite and positive, or the tolerance
  ///   is not positive
  ///
  /// What the linear solver throws in its analysis comes from here with `Parallel_tag`, and from
  /// `iterate()` otherwise. The run before ends in any case; after an exception there is none.
  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  void start(const Loop_system<TriangleMesh>& system,
             const NamedParameters& np = CGAL::parameters::default_values())
  {
    start(system, np, [](int, const internal::Iteration&) { return true; });
  }

  /// does one iteration: solves one linear system and moves the vertices.
  /// \throws Solver_exception if a linear system cannot be factored or solved, or the solver has
  ///   not been started since `foliation()` was called
  void iterate()
  {
    check_started();
    keep(m_solver->iterate_once(m_tolerance));
  }

  /// returns how far the run has come.
  /// \pre `start()` was called
  const Foliation_statistics& statistics() const { return m_data->statistics; }

  /// ends the run and returns its foliation. If this has folds, as it may if it has not converged,
  /// the solver goes on until they are gone.
  /// \throws Certificate_exception if the certificate does not hold
  /// \throws Solver_exception as `iterate()`
  Measured_foliation<TriangleMesh> foliation()
  {
    check_started();
    const bool is_at_end = m_data->statistics.optimality < internal::Solver_options().tolerance;
    if (is_at_end)
      end_run(); // gives back memory
    if (is_at_end && m_is_last_run)
      clear_linear_solver();
    internal::certify(*m_data, [&] { return m_solver->iterate_once(m_tolerance); });
    end_run();
    return Measured_foliation<TriangleMesh>(m_data);
  }

  /// @}
  /// \cond SKIP_IN_MANUAL
  // Says that nothing will be started again, so that a factorization need not be kept.
  void expect_no_more_runs() { m_is_last_run = true; }
  /// \endcond

private:
  using Data = internal::Foliation_data<TriangleMesh>;

  template <class NamedParameters>
  void start(const Loop_system<TriangleMesh>& system,
             const NamedParameters& np,
             const internal::Coarse_progress& goes_on)
  {
    internal::check_parameters<internal::Start_parameters>(np);
    end_run();
    m_is_going_on = true;
    m_tolerance = internal::solver_options(np, internal::Solver_options()).tolerance;
    const internal::Executor& executor = internal::executor_for<ConcurrencyTag>();
    auto data = std::make_shared<Data>(system, internal::checked_weights(system, np, executor));
    data->state.set_executor(executor);
    const bool is_pattern_known = m_is_pattern_known && internal::have_same_connectivity(
                                                          m_data->state.mesh(), data->state.mesh());
    m_is_pattern_known = false; // unless nothing fails below
    auto solver = std::make_unique<internal::Newton_solver<LinearSolver>>(
      data->state, m_linear_solver, is_pattern_known);
    if (m_data && internal::have_same_loops(m_data->state.system(), data->state.system()))
      data->state.set_map(internal::carried_map(m_data->state, data->state));
    else
      executor.run_ahead(
        [&] { solver->analyze_pattern(); },
        [&] { m_is_going_on = internal::start_from_coarse(data->state, goes_on); });
    m_data = std::move(data);
    m_solver = std::move(solver);
    m_is_pattern_known = is_pattern_known;
    keep(m_solver->start(m_tolerance));
  }

  void keep(const internal::Solver_result& result)
  {
    m_data->statistics = internal::statistics(result.last, result.has_converged);
  }

  void end_run()
  {
    if (m_solver && m_solver->number_of_factorizations() > 0)
      m_is_pattern_known = true;
    m_solver.reset();
  }

  void clear_linear_solver()
  {
    if constexpr (internal::Is_clearable<LinearSolver>::value)
    {
      m_linear_solver.clear();
      m_is_pattern_known = false;
    }
  }

  void check_started() const
  {
    if (!m_solver)
      throw Solver_exception(
        internal::problem(Problem_kind::SOLVER_FAILURE, "the solver has not been started"));
  }

  std::unique_ptr<LinearSolver> m_own_linear_solver;
  LinearSolver& m_linear_solver;
  bool m_is_last_run = false;
  bool m_is_going_on = true;       // the visitor has not stopped the run on a coarse mesh
  bool m_is_pattern_known = false; // whether the linear solver has analyzed the mesh of m_data
  double m_tolerance = 0;
  std::shared_ptr<Data> m_data; // of the last run; not changed any more once it was returned
  std::unique_ptr<internal::Newton_solver<LinearSolver>> m_solver; // as long as a run goes on
};

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_FOLIATION_SOLVER_H
