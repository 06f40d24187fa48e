// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_LOOP_SYSTEM_COUNTS_H
#define SMF_TEST_LOOP_SYSTEM_COUNTS_H

#include <CGAL/Surface_mesh_foliation/Loop_system.h>

#include <algorithm>
#include <array>
#include <cstddef>

// What the dual graph of a loop system has.

namespace smf_test {

template <class TriangleMesh>
std::size_t number_of_cycles(const CGAL::Surface_mesh_foliation::Loop_system<TriangleMesh>& system)
{
  return system.number_of_arcs() + 1 - system.number_of_nodes();
}

template <class TriangleMesh>
std::size_t total_region_genus(
  const CGAL::Surface_mesh_foliation::Loop_system<TriangleMesh>& system)
{
  std::size_t result = 0;
  for (std::size_t r = 0; r < system.number_of_nodes(); ++r)
    result += system.genus(r);
  return result;
}

// the nodes at the ends of an arc, in ascending order
template <class TriangleMesh>
std::array<std::size_t, 2> ends(
  const CGAL::Surface_mesh_foliation::Loop_system<TriangleMesh>& system, std::size_t arc)
{
  const auto [low, high] = std::minmax({system.node(arc, 0), system.node(arc, 1)});
  return {low, high};
}

} // namespace smf_test

#endif // SMF_TEST_LOOP_SYSTEM_COUNTS_H
