// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_BALANCE_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_BALANCE_H

#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_statistics.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/forces.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/lengths.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// the excess of the strongest direction of a vertex at a node; negative if there is none
inline double excess_at_node(const Foliation_state& state, int v, Directions& directions)
{
  find_directions(state, v, directions);
  find_forces(state, v, directions);
  double strongest = 0;
  for (double force : directions.force)
    strongest = (std::max)(strongest, force);
  return 2 * strongest - directions.total_force;
}

// how far one vertex is from being balanced, or the largest such value of many
struct Vertex_balance
{
  double force = 0;         // the sum over its edges
  double movable_force = 0; // over those that have an end which is not fixed
  double excess = 0, resolved_excess = 0;

  void include(const Vertex_balance& other)
  {
    force = (std::max)(force, other.force);
    movable_force = (std::max)(movable_force, other.movable_force);
    excess = (std::max)(excess, other.excess);
    resolved_excess = (std::max)(resolved_excess, other.resolved_excess);
  }
};

// tension: by edge, weight times length. `pull` becomes the force toward larger t if the vertex is
// free to move in its arc. The excess of a vertex at a node is left out.
inline Vertex_balance balance_of_vertex(const Foliation_state& state,
                                        const std::vector<double>& tension,
                                        int v,
                                        double& pull)
{
  Vertex_balance result;
  const bool is_free = state.is_free_in_arc(v), is_fixed = state.is_fixed(v);
  for (int h : state.mesh().ring(v))
  {
    result.force += tension[edge_of(h)];
    if (!is_fixed || !state.is_fixed(state.mesh().target(h)))
      result.movable_force += tension[edge_of(h)];
    if (is_free)
      pull += pull_at_source(state, h, tension[edge_of(h)]);
  }
  if (!is_free)
    return result;
  // of the parameters of the ends of all edges, and of the solution of the linear system
  constexpr double rounding_errors = 16;
  const double largest = std::abs(state.total_weight(v)) * state.system().height(state.arc(v));
  result.excess = std::abs(pull);
  result.resolved_excess =
    result.excess - rounding_errors * std::numeric_limits<double>::epsilon() * largest;
  return result;
}

// The energy, and how far a foliation is from the harmonic one: the largest excess of one
// direction's force over the sum of all others, at any vertex that is free to move, divided by the
// largest sum of forces at any vertex, of which those between fixed vertices tell nothing, however
// large they are. The squared distance of T separates to first order, so zero
// is necessary and sufficient. `pull` becomes, by vertex, the force toward larger t; 0 for one that
// is not free to move in an arc.
inline Foliation_statistics balance(const Foliation_state& state, std::vector<double>& pull)
{
  const int n = state.mesh().number_of_vertices();
  Foliation_statistics result;
  std::vector<double> tension(state.mesh().number_of_edges());
  pull.assign(n, 0);
  result.energy = sum_of_numbers(state.executor(), state.mesh().number_of_edges(), [&](int e) {
    const double length = length_of_edge(state, e);
    tension[e] = state.weight(e) * length;
    return tension[e] * length;
  });
  std::vector<Vertex_balance> largest(Executor::number_of_blocks(n));
  state.executor()(n, [&](int block, int first, int last) {
    for (int v = first; v < last; ++v)
      largest[block].include(balance_of_vertex(state, tension, v, pull[v]));
  });
  Vertex_balance all;
  for (const Vertex_balance& block : largest)
    all.include(block);
  Directions directions; // looked up in tables that grow, hence sequentially
  for (int v = 0; v < n; ++v)
    if (state.is_at_node(v) && !state.is_fixed(v))
    {
      const double excess = excess_at_node(state, v, directions);
      all.include({0, 0, excess, excess});
    }
  // leaves that cross edges make forces; if there are no forces, numbers have overflowed or
  // underflowed
  const bool is_meaningful = all.force > 0 && std::isfinite(all.force);
  const double infinity = (std::numeric_limits<double>::infinity)();
  const double scale = all.movable_force > 0 ? all.movable_force : all.force;
  result.optimality = is_meaningful ? all.excess / scale : infinity;
  result.resolved_optimality = is_meaningful ? all.resolved_excess / scale : infinity;
  return result;
}

inline Foliation_statistics balance(const Foliation_state& state)
{
  std::vector<double> pull;
  return balance(state, pull);
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_BALANCE_H
