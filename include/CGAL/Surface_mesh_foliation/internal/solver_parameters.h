// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_PARAMETERS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_PARAMETERS_H

#include <CGAL/Surface_mesh_foliation/Foliation_visitor.h>
#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>
#include <CGAL/Surface_mesh_foliation/edge_weights.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Certificate.h>
#include <CGAL/Surface_mesh_foliation/internal/Newton_solver.h>
#include <CGAL/Surface_mesh_foliation/internal/start_from_coarse.h>
#include <CGAL/Surface_mesh_foliation/internal/user_count.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// What the solvers have in common: their named parameters, what they tell, how they end.

inline Foliation_statistics statistics(const Iteration& iteration, bool has_converged)
{
  Foliation_statistics result;
  result.number_of_iterations = iteration.number;
  result.energy = iteration.energy;
  result.optimality = iteration.optimality;
  result.number_of_moves = iteration.number_of_moves;
  result.number_of_changed_vertices = iteration.number_of_changed_vertices;
  result.has_converged = has_converged;
  return result;
}

// a visitor, given by value or by `std::ref()`
template <class Visitor>
Visitor& unwrapped(Visitor& visitor)
{
  return visitor;
}

template <class Visitor>
Visitor& unwrapped(std::reference_wrapper<Visitor>& visitor)
{
  return visitor.get();
}

// Whether a visitor wants to know about iterations on coarser meshes.
template <class Visitor, class = void>
struct Is_told_about_coarse_iterations : std::false_type
{};

template <class Visitor>
struct Is_told_about_coarse_iterations<
  Visitor,
  std::void_t<decltype(std::declval<Visitor&>().after_coarse_iteration(
    std::size_t(), Foliation_statistics()))>> : std::true_type
{};

// what `start_from_coarse()` is to tell the visitor
template <class Visitor>
Coarse_progress coarse_progress(Visitor& visitor)
{
  if constexpr (Is_told_about_coarse_iterations<Visitor>::value)
    return [&visitor](int number_of_vertices, const Iteration& iteration) {
      return visitor.after_coarse_iteration(static_cast<std::size_t>(number_of_vertices),
                                            statistics(iteration, false));
    };
  else
    return [](int, const Iteration&) { return true; };
}

// the named parameters `tolerance` and `number_of_iterations`
template <class NamedParameters>
Solver_options solver_options(const NamedParameters& np, const Solver_options& defaults)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  Solver_options result;
  result.tolerance =
    choose_parameter(get_parameter(np, internal_np::tolerance), defaults.tolerance);
  result.max_iterations = user_count(choose_parameter(
    get_parameter(np, CGAL::internal_np::number_of_iterations), defaults.max_iterations));
  if (!(result.tolerance > 0) || result.max_iterations < 0)
    throw Invalid_parameter_exception(
      {Problem_kind::INVALID_PARAMETER,
       "the tolerance must be positive and the number of iterations "
       "not negative",
       {},
       {},
       {}});
  return result;
}

// the named parameters `weights` and `allow_any_weights`, checked
template <class TriangleMesh, class NamedParameters>
std::vector<double> checked_weights(const Loop_system<TriangleMesh>& system,
                                    const NamedParameters& np,
                                    const Block_loop& loop = block_loop<CGAL::Sequential_tag>())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  std::vector<double> result = weights_of(
    system, choose_parameter(get_parameter(np, internal_np::weights), Mean_value_weights()), loop);
  check_weights(system.data().flat.mesh, result,
                choose_parameter(get_parameter(np, internal_np::allow_any_weights), false));
  return result;
}

// Nothing leaves a solver uncertified. A state in which it was stopped may have folds: the loops
// themselves may run to and fro over an edge, and a step may leave a vertex behind. Then it goes
// on, by `go_on()`, until they are smoothed out.
template <class TriangleMesh, class Go_on>
void certify(Foliation_data<TriangleMesh>& data, const Go_on& go_on)
{
  constexpr int max_more_rounds = 100;
  const double least_tolerance = Solver_options().tolerance;
  data.certificate.emplace(data.state);
  for (int i = 0; i < max_more_rounds && !data.certificate->problems().empty() &&
                  data.statistics.optimality >= least_tolerance;
       ++i)
  {
    const Solver_result result = go_on();
    data.statistics = statistics(result.last, result.has_converged);
    data.certificate.emplace(data.state);
  }
  if (!data.certificate->problems().empty())
    throw Certificate_exception(data.certificate->problems().front());
  data.statistics.is_certified = true;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_PARAMETERS_H
