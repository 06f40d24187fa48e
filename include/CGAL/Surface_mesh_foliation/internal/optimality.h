// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_OPTIMALITY_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_OPTIMALITY_H

#include <CGAL/Surface_mesh_foliation/internal/Foliation_state.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// How far a foliation is from the harmonic one: the largest excess of one direction's force over
// the sum of all others, at any vertex that is free to move, divided by the largest sum of forces
// at any vertex. The squared distance of T separates to first order, so zero is necessary and
// sufficient.
inline double optimality(const Foliation_state& state)
{
  double largest_excess = 0, largest_force = 0;
  Directions directions;
  for (int v = 0; v < state.mesh().number_of_vertices(); ++v)
  {
    double force = 0, pull = 0;
    for (int h : state.mesh().ring(v))
    {
      force += state.weight(h / 2) * state.length(h / 2);
      if (!state.is_at_node(v))
        pull += state.pull(h);
    }
    largest_force = (std::max)(largest_force, force);
    if (state.is_fixed(v))
      continue;
    double excess = std::abs(pull);
    if (state.is_at_node(v))
    {
      state.find_directions(v, directions);
      state.find_forces(v, directions);
      for (double f : directions.force)
        excess = (std::max)(excess, 2 * f - directions.total_force);
    }
    largest_excess = (std::max)(largest_excess, excess);
  }
  return largest_force > 0 ? largest_excess / largest_force : 0;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_OPTIMALITY_H
