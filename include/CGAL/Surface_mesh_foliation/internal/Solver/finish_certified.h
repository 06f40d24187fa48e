// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_FINISH_CERTIFIED_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_FINISH_CERTIFIED_H

#include <CGAL/Surface_mesh_foliation/internal/Common/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Progress.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/settle_at_nodes.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/solver_options.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Nothing leaves a solver uncertified: each solver ends with one of these two functions, which
// throw unless the certificate holds. Both leave the extraction in `data`, for the later stages.

// Extracts again, and returns what the certificate finds wrong.
template <class Foliation_data>
std::vector<Problem> problems_of_extraction(Foliation_data& data, const Poll& poll)
{
  poll();
  data.extraction.emplace(data.state);
  poll();
  return data.problems();
}

template <class Foliation_data>
void check_certified(Foliation_data& data, const std::vector<Problem>& problems)
{
  if (!problems.empty())
    throw Certificate_exception(problems.front());
  data.statistics.is_certified = true;
}

// For a foliation that is finished, but perhaps for folds that are due to rounding.
template <class Foliation_data>
void finish_certified(Foliation_data& data, const Poll& poll = poll_nobody)
{
  std::vector<Problem> problems = problems_of_extraction(data, poll);
  if (!problems.empty() && settle_at_nodes(data.state))
    problems = problems_of_extraction(data, poll);
  check_certified(data, problems);
}

// For one that may have folds because its solver was stopped: the loops themselves may run back and
// forth over an edge, and a step may leave a vertex behind. The solver continues until the folds
// are smoothed out; `go_on()` does one round, and returns the statistics.
template <class Foliation_data, class Go_on>
void go_on_until_certified(Foliation_data& data, const Go_on& go_on, const Poll& poll)
{
  constexpr int max_rounds = 100;
  std::vector<Problem> problems = problems_of_extraction(data, poll);
  for (int i = 0; i < max_rounds && !problems.empty() && !is_at_end(data.statistics); ++i)
  {
    data.statistics = go_on();
    problems = problems_of_extraction(data, poll);
  }
  check_certified(data, problems);
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_FINISH_CERTIFIED_H
