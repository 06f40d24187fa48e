// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_WHITEHEAD_FOLIATION_H
#define CGAL_SURFACE_MESH_FOLIATION_WHITEHEAD_FOLIATION_H

#include <CGAL/Surface_mesh_foliation/Foliation_visitor.h>
#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/require_parameter.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Whitehead_solver.h>
#include <CGAL/Surface_mesh_foliation/edge_weights.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Newton_steps.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Progress.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/finish_certified.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/relax_folds.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/solver_options.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/solver_visitor.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

namespace internal {

using Whitehead_solver_parameters = Joined_parameters<Weight_parameters,
                                                      internal_np::over_relaxation_t,
                                                      internal_np::stage_critical_moves_t,
                                                      internal_np::spread_by_rings_t>;

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationFoliation

runs the paper's own algorithm [Section 3.2], sweep by sweep: discrete Whitehead moves of one vertex
after another, starting with all leaves in the loops. It is provided for comparison and study;
`harmonic_foliation()` finds its limit faster, and exactly.

A move at a vertex shortens the edges of one of its sectors, those that leave it in one direction,
by \f$ \delta \f$ and lengthens all others; \f$ \delta \f$ minimizes the energy. A vertex whose
edges are all in one sector is the tip of a fold, an accidental thorn pole. The paper has no move
for it, and with its <em>literal</em> set of moves, foliations freeze with hundreds of such tips.
The <em>repaired</em> moves pull folds back: the tip moves in its only direction. They converge to
the harmonic foliation.

\tparam TriangleMesh see `Loop_system`
*/
template <class TriangleMesh>
class Whitehead_foliation_solver
{
public:
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using edge_descriptor = typename boost::graph_traits<TriangleMesh>::edge_descriptor;

  /*!
  puts the leaves into the loops.

  \param system the loop system
  \param np an optional sequence of named parameters: `weights` and `allow_any_weights` as in
    `harmonic_foliation()`; `over_relaxation`, a factor strictly between 0 and 2 for moves inside
    arcs, by default `1`; `use_literal_moves`, by default `false`; `stage_critical_moves`, by
    default `false`: whether moves that are critical in the sense of Zhao et al. [Section 3.2],
    turning a neighbor from a pole of the uncovered part to a regular vertex, wait until no other
    move covers an edge; `spread_by_rings`, by default `false`: whether a sweep moves only the
    vertices that leaves have reached before it, so that leaves spread by one ring of triangles at a
    time, instead of all at once along a row of vertices in the order of the mesh

  \throws Invalid_parameter_exception if a weight is not finite and positive, or the factor is out
    of range
  */
  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Whitehead_foliation_solver(
    const Loop_system<TriangleMesh>& system,
    const NamedParameters& np = CGAL::parameters::default_values())
    : m_data(std::make_shared<internal::Foliation_data<TriangleMesh>>(
        system, internal::checked_weights(system, np))),
      m_solver(m_data->state, options(np))
  {
    internal::check_parameters<internal::Whitehead_solver_parameters,
                               internal_np::use_literal_moves_t>(np);
    statistics();
  }

  Whitehead_foliation_solver(const Whitehead_foliation_solver&) = delete;
  Whitehead_foliation_solver& operator=(const Whitehead_foliation_solver&) = delete;

  /// moves every vertex once, in the order of `vertices(mesh)`, in linear time.
  /// \throws Solver_exception after `foliation()`
  void sweep()
  {
    check_not_ended();
    m_solver.sweep();
  }

  /// returns the number of sweeps, the energy and the optimality of the current foliation, and
  /// whether it has converged to the tolerance, in linear time.
  Foliation_statistics statistics(double tolerance = 1e-12)
  {
    if (!m_is_ended)
      m_data->statistics = m_solver.statistics(tolerance);
    return m_data->statistics;
  }

  /// writes the current foliation values of all edges to a property map, in linear time.
  /// \tparam EdgeValueMap a model of `WritablePropertyMap` with
  ///   `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and a type constructible
  ///   from `double` as value type
  template <class EdgeValueMap>
  void edge_values(EdgeValueMap map) const
  {
    internal::write_edge_values(m_data->system, m_data->state, map);
  }

  /// returns whether critical moves are still held back.
  bool is_in_first_stage() const { return m_solver.is_in_first_stage(); }

  /// returns the vertices whose moves were critical, in the order of the moves; none without
  /// `stage_critical_moves`.
  std::vector<vertex_descriptor> critical_moves() const
  {
    return vertices_of(m_solver.critical_moves());
  }

  /// returns the tips of folds, accidental thorns: the vertices other than poles whose edges are
  /// all in one sector. Takes linear time.
  std::vector<vertex_descriptor> accidental_thorns()
  {
    return vertices_of(m_solver.vertices_with_one_sector());
  }

  /// ends the run and returns its foliation. If the foliation has folds, moves of the chosen kind
  /// continue until they are gone. Literal moves cannot remove accidental thorns, and are given up
  /// after 10,000 sweeps. The others remove them, but only slowly where weights differ by many
  /// orders of magnitude, as at faces that are nearly flat; after 1,000 sweeps, steps of
  /// `harmonic_foliation()` follow.
  /// \throws Certificate_exception if the foliation has accidental thorns that cannot be removed
  /// \throws Solver_exception if it is called twice, or if a linear system of those steps cannot be
  ///   solved, which cannot happen if weights are positive
  Measured_foliation<TriangleMesh> foliation(double tolerance = 1e-12)
  {
    return foliation(tolerance, false, internal::poll_nobody);
  }

  /// \cond SKIP_IN_MANUAL
  // A visitor that has stopped the solver waits for at most twice as many sweeps as are needed.
  Measured_foliation<TriangleMesh> foliation(double tolerance,
                                             bool is_stopped,
                                             const internal::Poll& poll)
  {
    check_not_ended();
    if (is_stopped)
      internal::relax_folds(m_data->state, poll);
    statistics(tolerance);
    constexpr int most_sweeps = 100;            // between two attempts to certify
    constexpr std::size_t enough_sweeps = 1000; // for folds that sweeps smooth out
    int sweeps = is_stopped ? 1 : most_sweeps;
    const std::size_t first_sweep = m_data->statistics.number_of_iterations;
    internal::Newton_steps steps(m_data->state, tolerance);
    const auto go_on = [&] {
      const Foliation_statistics& last = m_data->statistics;
      if (!m_solver.are_moves_literal() && last.number_of_iterations >= first_sweep + enough_sweeps)
        return steps.next(last.number_of_iterations, poll);
      for (int i = 0; i < sweeps; ++i)
      {
        poll();
        m_solver.sweep();
      }
      sweeps = (std::min)(2 * sweeps, most_sweeps);
      return m_solver.statistics(tolerance);
    };
    internal::go_on_until_certified(*m_data, go_on, poll);
    m_is_ended = true;
    return Measured_foliation<TriangleMesh>(m_data);
  }
  /// \endcond

private:
  template <class NamedParameters>
  static internal::Whitehead_options options(const NamedParameters& np)
  {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    internal::Whitehead_options result;
    result.over_relaxation =
      choose_parameter(get_parameter(np, internal_np::over_relaxation), result.over_relaxation);
    result.are_moves_literal =
      choose_parameter(get_parameter(np, internal_np::use_literal_moves), false);
    result.are_critical_moves_staged =
      choose_parameter(get_parameter(np, internal_np::stage_critical_moves), false);
    result.do_leaves_spread_by_rings =
      choose_parameter(get_parameter(np, internal_np::spread_by_rings), false);
    internal::require_parameter(result.over_relaxation > 0 && result.over_relaxation < 2,
                                "the over-relaxation must lie between 0 and 2");
    return result;
  }

  void check_not_ended() const
  {
    if (m_is_ended)
      throw Solver_exception(
        internal::problem(Problem_kind::SOLVER_FAILURE, "the solver has ended"));
  }

  std::vector<vertex_descriptor> vertices_of(const std::vector<int>& indices) const
  {
    std::vector<vertex_descriptor> result;
    for (int v : indices)
      result.push_back(m_data->system.data().mesh_index.vertex(v));
    return result;
  }

  std::shared_ptr<internal::Foliation_data<TriangleMesh>> m_data;
  internal::Whitehead_solver m_solver;
  bool m_is_ended = false; // the data has been returned
};

/*!
\ingroup PkgSurfaceMeshFoliationFoliation

computes the harmonic measured foliation by repaired Whitehead moves, the paper's algorithm made to
converge; see `Whitehead_foliation_solver`.

\tparam TriangleMesh see `Loop_system`
\param system the loop system
\param np an optional sequence of named parameters: those of `Whitehead_foliation_solver` except
  `use_literal_moves`, and `tolerance` (by default `1e-12`), `number_of_iterations`, the largest
  number of sweeps (by default `1000000`), `visitor`, as in `harmonic_foliation()` (its `go_on()` is
  called before each sweep), and `edge_value_map`, a property map of edges that the foliation values
  are written to before each call of the visitor

\throws as `harmonic_foliation()`

A sweep takes linear time. The number of sweeps grows at least linearly with the number of edges
along a leaf-to-leaf path; over-relaxation by 1.9 divides it by ten or more.
*/
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
Measured_foliation<TriangleMesh> whitehead_foliation(
  const Loop_system<TriangleMesh>& system,
  const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  internal::check_parameters<internal::Whitehead_solver_parameters, internal_np::tolerance_t,
                             CGAL::internal_np::number_of_iterations_t,
                             CGAL::internal_np::visitor_t, internal_np::edge_value_map_t>(np);
  internal::Solver_options defaults;
  defaults.max_iterations = 1000000;
  const internal::Solver_options options = internal::solver_options(np, defaults);
  auto visitor =
    choose_parameter(get_parameter(np, CGAL::internal_np::visitor), Default_foliation_visitor());
  const auto map = get_parameter(np, internal_np::edge_value_map);
  Whitehead_foliation_solver<TriangleMesh> solver(
    system, internal::select<internal::Whitehead_solver_parameters>(np));
  const internal::Poll poll = internal::poll_of(internal::unwrapped(visitor));
  bool is_stopped = false, has_converged = false;
  for (int sweep = 0; sweep < options.max_iterations && !is_stopped && !has_converged; ++sweep)
  {
    poll();
    solver.sweep();
    const Foliation_statistics statistics = solver.statistics(options.tolerance);
    if constexpr (!std::is_same_v<std::decay_t<decltype(map)>, CGAL::internal_np::Param_not_found>)
      solver.edge_values(map);
    is_stopped = !internal::unwrapped(visitor).after_iteration(statistics);
    has_converged = statistics.has_converged;
  }
  return solver.foliation(options.tolerance, is_stopped, poll);
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_WHITEHEAD_FOLIATION_H
