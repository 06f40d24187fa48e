// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_SOLVER_OPTIONS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_SOLVER_OPTIONS_H

#include <CGAL/Surface_mesh_foliation/internal/Common/require_parameter.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/Named_parameters.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/user_count.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Newton_solver.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Whether continuing would be useless, whatever tolerance the user has chosen.
inline bool is_at_end(const Foliation_statistics& statistics)
{
  return statistics.optimality < Solver_options().tolerance;
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
  require_parameter(result.tolerance > 0 && result.max_iterations >= 0,
                    "the tolerance must be positive and the number of iterations not negative");
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_SOLVER_OPTIONS_H
