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
#include <CGAL/Surface_mesh_foliation/Supernodal_cholesky_solver.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/Executor.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Newton_solver.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/carried_map.h>
#include <CGAL/Surface_mesh_foliation/edge_weights.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Progress.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Pushed_pole.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/finish_certified.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/relax_folds.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/solver_options.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/solver_visitor.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/start_from_coarse.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

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

computes harmonic foliations one after another, step by step if desired, and keeps whatever the next
one can reuse. `harmonic_foliation()` is one run of it.

- If the mesh has the same connectivity as the previous one (the same mesh, or another pose of it),
  the symbolic analysis of the linear solver is kept.
- If it has the same weights, too, the factorization is kept, and updated as long as that is less
  work than another one (if the linear solver is a model of `UpdatableFoliationLinearSolver`).
- If the poles and the edges that the loops cross are the same, the run starts from the last
  solution, for example after a change of heights or weights, or in another pose. So it does if one
  pole, a vertex, has moved to another vertex of its component, as it does when it is dragged.
- Otherwise, say if a loop was added, it starts from the solution on coarser meshes.

A system that is made from the last one, by `Loop_system(const Loop_system&, const
Poles_and_loops&)`, spares the checks of the mesh and the computation of default weights.

Where a run starts has no influence on the foliation that it converges to.

\tparam TriangleMesh see `Loop_system`
\tparam LinearSolver a model of `FoliationLinearSolver`
\tparam ConcurrencyTag see `harmonic_foliation()`
*/
template <class TriangleMesh,
          class LinearSolver = Supernodal_cholesky_solver,
          class ConcurrencyTag = CGAL::Sequential_tag>
class Foliation_solver
{
public:
  /// constructs a solver with its own default-constructed linear solver.
  Foliation_solver()
    : m_own_linear_solver(std::make_unique<LinearSolver>()), m_linear_solver(*m_own_linear_solver)
  {}

  /// constructs a solver that uses the given linear solver, which must outlive it and which nothing
  /// else may use.
  explicit Foliation_solver(LinearSolver& linear_solver) : m_linear_solver(linear_solver) {}

  /// runs the solver to its end: `start()`, `iterate()` as long as needed and allowed, and
  /// `foliation()`. The named parameters and exceptions are those of `harmonic_foliation()`, except
  /// for the linear solver. An exception, from a visitor or otherwise, ends the run; the next may
  /// begin at once.
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
    const internal::Progress progress = internal::progress_of(internal::unwrapped(visitor));
    try
    {
      start(system,
            internal::select<internal_np::weights_t, internal_np::allow_any_weights_t,
                             internal_np::tolerance_t>(np),
            progress);
      for (int i = 0; i < max_iterations && !statistics().has_converged && !m_is_stopped; ++i)
      {
        iterate(progress.poll);
        m_is_stopped = !internal::unwrapped(visitor).after_iteration(statistics());
      }
      return foliation(progress.poll);
    }
    catch (...)
    {
      end_run();
      throw;
    }
  }

  /// \name Steps
  /// @{

  /// begins a run. Of the named parameters of `harmonic_foliation()` it takes `weights`,
  /// `allow_any_weights` and `tolerance`.
  ///
  /// \throws Invalid_parameter_exception if a weight is not finite and positive, or the tolerance
  ///   is not positive
  ///
  /// What the linear solver throws during its analysis is thrown here with `Parallel_tag`, and by
  /// `iterate()` otherwise. The previous run ends in any case; after an exception there is no
  /// current run.
  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  void start(const Loop_system<TriangleMesh>& system,
             const NamedParameters& np = CGAL::parameters::default_values())
  {
    start(system, np, internal::Progress());
  }

  /// does one iteration: solves one linear system and moves the vertices.
  /// \throws Solver_exception if a linear system cannot be factored or solved, or the solver has
  ///   not been started since `foliation()` was called
  void iterate() { iterate(internal::poll_nobody); }

  /// returns how far the run has come.
  /// \pre `start()` was called
  const Foliation_statistics& statistics() const { return m_data->statistics; }

  /// ends the run and returns its foliation. If the foliation has folds, which is possible if the
  /// solver has not converged, the solver continues until they are gone.
  /// \throws Certificate_exception if the certificate does not hold
  /// \throws Solver_exception as `iterate()`
  Measured_foliation<TriangleMesh> foliation() { return foliation(internal::poll_nobody); }

  /// @}
  /// \cond SKIP_IN_MANUAL
  // Declares that no further run will be started, so that a factorization need not be kept.
  void expect_no_more_runs() { m_is_last_run = true; }
  /// \endcond

private:
  using Data = internal::Foliation_data<TriangleMesh>;
  using Factored_matrix = internal::Factored_matrix<LinearSolver>;

  template <class NamedParameters>
  void start(const Loop_system<TriangleMesh>& system,
             const NamedParameters& np,
             const internal::Progress& progress)
  {
    internal::check_parameters<internal::Start_parameters>(np);
    end_run();
    m_is_stopped = false;
    const double tolerance = internal::solver_options(np, internal::Solver_options()).tolerance;
    const internal::Executor& executor = internal::executor_for<ConcurrencyTag>();
    const bool is_restart =
      m_data && internal::have_same_loops(m_data->state.system(), system.data().flat);
    const std::optional<internal::Pushed_pole> pushed_pole =
      is_restart ? std::nullopt : pushed_pole_of(system);
    const std::shared_ptr<Data> data =
      data_of(system, weights_for(system, np, executor), is_restart, pushed_pole);
    data->state.set_executor(executor);
    progress.poll();
    auto solver =
      std::make_unique<internal::Newton_solver<LinearSolver>>(data->state, *m_factored_matrix);
    if (is_restart)
      data->state.set_map(internal::carried_map(m_data->state, data->state));
    else if (pushed_pole && pushed_pole->has_only_poles_fixed(data->state))
      data->state.set_map(pushed_pole->map(data->state));
    else
      executor.run_ahead(
        [&] { solver->analyze_pattern(); },
        [&] { m_is_stopped = !internal::start_from_coarse(data->state, progress); });
    m_data = data;
    m_has_mean_value_weights = has_mean_value_weights<NamedParameters>();
    m_solver = std::move(solver);
    m_solver->start(tolerance);
    m_data->statistics = m_solver->statistics();
    if (progress.at_start)
      progress.at_start(arcs_of_vertices());
  }

  // by vertex of the mesh; the number of arcs for one at a node
  std::vector<std::size_t> arcs_of_vertices() const
  {
    const internal::Foliation_state& state = m_data->state;
    const auto none = static_cast<std::size_t>(state.system().number_of_arcs());
    std::vector<std::size_t> result(m_data->system.data().mesh_index.number_of_vertices(), none);
    for (std::size_t i = 0; i < result.size(); ++i)
      if (const int v = static_cast<int>(i); !state.is_at_node(v))
        result[i] = static_cast<std::size_t>(state.arc(v));
    return result;
  }

  // how the last foliation is carried to this system if a pole has moved inside its component
  std::optional<internal::Pushed_pole> pushed_pole_of(const Loop_system<TriangleMesh>& system) const
  {
    if (!m_data || !m_data->statistics.is_certified)
      return std::nullopt;
    return internal::Pushed_pole::find(m_data->state, system.data().flat);
  }

  // Lifts can be carried by their names if the cocycle is that of the last foliation.
  std::shared_ptr<Data> data_of(const Loop_system<TriangleMesh>& system,
                                std::vector<double> weights,
                                bool is_restart,
                                const std::optional<internal::Pushed_pole>& pushed_pole) const
  {
    const internal::Flat_mesh& mesh = system.data().flat.mesh;
    if (is_restart)
      return std::make_shared<Data>(system, std::move(weights),
                                    internal::Deck_cocycle(mesh, m_data->state.deck()));
    if (pushed_pole)
      return std::make_shared<Data>(system, std::move(weights), pushed_pole->deck(mesh));
    return std::make_shared<Data>(system, std::move(weights));
  }

  template <class NamedParameters>
  static constexpr bool has_mean_value_weights()
  {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    using Weights = decltype(choose_parameter(
      get_parameter(std::declval<NamedParameters>(), internal_np::weights), Mean_value_weights()));
    return std::is_same_v<std::decay_t<Weights>, Mean_value_weights>;
  }

  // Mean value weights of the last mesh are not computed again.
  template <class NamedParameters>
  std::vector<double> weights_for(const Loop_system<TriangleMesh>& system,
                                  const NamedParameters& np,
                                  const internal::Executor& executor) const
  {
    if (has_mean_value_weights<NamedParameters>() && m_has_mean_value_weights && m_data &&
        m_data->state.mesh().is_copy_of(system.data().flat.mesh))
      return m_data->state.weights();
    return internal::checked_weights(system, np, executor);
  }

  void iterate(const internal::Poll& poll)
  {
    check_started();
    poll();
    m_solver->analyze_pattern();
    poll();
    if (internal::move_tied_vertices_as_one(m_data->state, statistics().number_of_iterations))
      m_solver->refresh();
    m_solver->find_step();
    poll();
    m_solver->take_step();
    m_data->statistics = m_solver->statistics();
  }

  Measured_foliation<TriangleMesh> foliation(const internal::Poll& poll)
  {
    check_started();
    if (m_is_stopped && !internal::is_at_end(statistics()))
      relax_folds(poll);
    if (internal::is_at_end(statistics()))
    {
      end_run(); // frees memory: nothing is solved from here on
      if (m_is_last_run)
        clear_linear_solver();
      internal::finish_certified(*m_data, poll);
    }
    else
    {
      const auto go_on = [&] {
        iterate(poll);
        return statistics();
      };
      internal::go_on_until_certified(*m_data, go_on, poll);
      end_run();
    }
    return Measured_foliation<TriangleMesh>(m_data);
  }

  // A visitor that stops the solver does not want to wait for another linear system.
  void relax_folds(const internal::Poll& poll)
  {
    if (!internal::relax_folds(m_data->state, poll))
      return;
    m_solver->refresh();
    m_data->statistics = m_solver->statistics();
  }

  void end_run() { m_solver.reset(); }

  void clear_linear_solver()
  {
    m_factored_matrix->clear();
    if constexpr (internal::Is_clearable<LinearSolver>::value)
      m_linear_solver.clear();
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
  bool m_is_stopped = false;             // by the visitor
  bool m_has_mean_value_weights = false; // m_data
  std::unique_ptr<Factored_matrix> m_factored_matrix =
    std::make_unique<Factored_matrix>(m_linear_solver); // of the last run
  std::shared_ptr<Data> m_data; // of the last run; no longer changed once it has been returned
  std::unique_ptr<internal::Newton_solver<LinearSolver>> m_solver; // while a run is in progress
};

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_FOLIATION_SOLVER_H
