// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_CERTIFY_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_CERTIFY_H

#include <CGAL/Surface_mesh_foliation/internal/Common/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Newton_solver.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/solver_visitor.h>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Nothing leaves a solver uncertified. A state in which it was stopped may have folds: the loops
// themselves may run to and fro over an edge, and a step may leave a vertex behind. Then it goes
// on, by `go_on()`, until they are smoothed out.
template <class Foliation_data, class Go_on>
void certify(Foliation_data& data, const Go_on& go_on)
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

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_CERTIFY_H
