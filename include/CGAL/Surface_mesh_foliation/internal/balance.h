// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_BALANCE_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_BALANCE_H

#include <CGAL/Surface_mesh_foliation/internal/Foliation_state.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

struct Balance
{
  double energy = 0;
  // How far a foliation is from the harmonic one: the largest excess of one direction's force over
  // the sum of all others, at any vertex that is free to move, divided by the largest sum of forces
  // at any vertex. The squared distance of T separates to first order, so zero is necessary and
  // sufficient.
  double optimality = 0;
  // The same without what rounding of a vertex's parameter can cause. With weights of very
  // different sizes that can be more than a tolerance asks for.
  double resolved_optimality = 0;
};

// the excess of the strongest direction of a vertex at a node; negative if there is none
inline double excess_at_node(const Foliation_state& state, int v, Directions& directions)
{
  state.find_directions(v, directions);
  state.find_forces(v, directions);
  double strongest = 0;
  for (double force : directions.force)
    strongest = (std::max)(strongest, force);
  return 2 * strongest - directions.total_force;
}

inline Balance balance(const Foliation_state& state)
{
  const Flat_mesh& mesh = state.mesh();
  Balance result;
  Sum energy;
  std::vector<double> force(mesh.number_of_vertices(), 0), pull(mesh.number_of_vertices(), 0);
  for (int e = 0; e < mesh.number_of_edges(); ++e)
  {
    const int u = mesh.source(2 * e), v = mesh.target(2 * e);
    const double length = state.length(e), tension = state.weight(e) * length;
    energy.add(tension * length);
    force[u] += tension;
    force[v] += tension;
    if (state.word_size(e) == 0)
    {
      const double upwards = state.parameter(v) >= state.parameter(u) ? tension : -tension;
      pull[u] += upwards;
      pull[v] -= upwards;
    }
    else
      for (int h : {2 * e, 2 * e + 1})
        if (!state.is_at_node(mesh.source(h)))
          pull[mesh.source(h)] += state.pull(h, tension);
  }
  result.energy = energy.value();
  double largest_excess = 0, largest_resolved_excess = 0;
  Directions directions;
  for (int v = 0; v < mesh.number_of_vertices(); ++v)
  {
    if (state.is_fixed(v))
      continue;
    const bool is_at_node = state.is_at_node(v);
    const double excess = is_at_node ? excess_at_node(state, v, directions) : std::abs(pull[v]);
    const double rounding =
      is_at_node ? 0 : std::abs(state.total_weight(v)) * state.system().height(state.arc(v));
    largest_excess = (std::max)(largest_excess, excess);
    largest_resolved_excess = (std::max)(
      largest_resolved_excess, excess - 4 * std::numeric_limits<double>::epsilon() * rounding);
  }
  const double largest_force = *std::max_element(force.begin(), force.end());
  // leaves that cross edges make forces; where there are none, numbers have over- or underflown
  const bool is_meaningful = largest_force > 0 && std::isfinite(largest_force);
  const double infinity = (std::numeric_limits<double>::infinity)();
  result.optimality = is_meaningful ? largest_excess / largest_force : infinity;
  result.resolved_optimality = is_meaningful ? largest_resolved_excess / largest_force : infinity;
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_BALANCE_H
