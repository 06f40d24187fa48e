// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_USER_COUNT_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_USER_COUNT_H

#include <limits>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// How many of something a user asks for, in any number type, as an `int`: the largest `int` for
// anything larger, -1 for anything negative or not a number. (A plain conversion makes 0 of 2^32.)
template <class Number>
int user_count(Number number)
{
  constexpr int largest = (std::numeric_limits<int>::max)();
  const double value = static_cast<double>(number);
  if (!(value >= 0))
    return -1;
  return value < largest ? static_cast<int>(number) : largest;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_USER_COUNT_H
