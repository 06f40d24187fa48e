// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_SOLVER_VISITOR_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_SOLVER_VISITOR_H

#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_statistics.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Newton_solver.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/start_from_coarse.h>

#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

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

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_SOLVER_VISITOR_H
