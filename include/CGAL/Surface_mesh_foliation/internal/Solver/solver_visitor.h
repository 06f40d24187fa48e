// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_SOLVER_VISITOR_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_SOLVER_VISITOR_H

#include <CGAL/Surface_mesh_foliation/internal/Common/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_statistics.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Progress.h>

#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

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

// Whether a visitor is asked whether it wants a result at all.
template <class Visitor, class = void>
struct Is_told_the_start : std::false_type
{};

template <class Visitor>
struct Is_told_the_start<
  Visitor,
  std::void_t<decltype(std::declval<Visitor&>().at_start(std::vector<std::size_t>()))>>
  : std::true_type
{};

template <class Visitor, class = void>
struct Is_polled : std::false_type
{};

template <class Visitor>
struct Is_polled<Visitor, std::void_t<decltype(std::declval<Visitor&>().go_on())>> : std::true_type
{};

// asks the visitor between the steps of an iteration
template <class Visitor>
Poll poll_of(Visitor& visitor)
{
  if constexpr (Is_polled<Visitor>::value)
    return [&visitor] {
      if (!visitor.go_on())
        throw Stopped_exception();
    };
  else
    return poll_nobody;
}

// The report for coarser meshes; has_converged refers to the mesh itself.
template <class Visitor>
Progress progress_of(Visitor& visitor)
{
  Progress result;
  result.poll = poll_of(visitor);
  if constexpr (Is_told_about_coarse_iterations<Visitor>::value)
    result.after_coarse_iteration = [&visitor](int number_of_vertices,
                                               Foliation_statistics statistics) {
      statistics.has_converged = false;
      return visitor.after_coarse_iteration(static_cast<std::size_t>(number_of_vertices),
                                            statistics);
    };
  if constexpr (Is_told_the_start<Visitor>::value)
    result.at_start = [&visitor](const std::vector<std::size_t>& arcs) { visitor.at_start(arcs); };
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_SOLVER_VISITOR_H
