// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_LENGTHS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_LENGTHS_H

#include <CGAL/Surface_mesh_foliation/internal/Common/Executor.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>

#include <cmath>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// the same as `length_of_edge()`, for an edge whose word is not empty
inline double length_of_word(const Foliation_state& state, int e, double t_source, double t_target)
{
  const int h = halfedge_of(e);
  const int u = state.mesh().source(h), v = state.mesh().target(h);
  const Tree_paths& paths = state.map().paths;
  int first = 0, last = state.word_size(e);
  double result = 0;
  if (!state.is_at_node(u))
    result += state.distance_to_end(paths(e, first++), t_source);
  if (!state.is_at_node(v))
    result += state.distance_to_end(paths(e, --last), t_target);
  for (; first < last; first += 2)
    result += state.length_of_arc(paths(e, first));
  return result;
}

// w_e, if the ends of the forward halfedge of e were at the given parameters of their cells
inline double length_of_edge(const Foliation_state& state, int e, double t_source, double t_target)
{
  if (state.word_size(e) > 0)
    return length_of_word(state, e, t_source, t_target);
  return state.is_at_node(state.mesh().source(halfedge_of(e))) ? 0 : std::abs(t_source - t_target);
}

// w_e, the distance in T between the images of the ends of e
inline double length_of_edge(const Foliation_state& state, int e)
{
  const int h = halfedge_of(e);
  return length_of_edge(state, e, state.parameter(state.mesh().source(h)),
                        state.parameter(state.mesh().target(h)));
}

// sum of alpha_e w_e^2
inline double energy_of(const Foliation_state& state)
{
  return sum_of_numbers(state.executor(), state.mesh().number_of_edges(), [&](int e) {
    const double w = length_of_edge(state, e);
    return state.weight(e) * w * w;
  });
}

// The derivative of w_e with respect to the parameter of source(h); for an edge inside one arc,
// that of the signed difference of its ends along the forward halfedge. Precondition: source(h) is
// in an arc.
inline int slope_at_source(const Foliation_state& state, int h)
{
  if (state.word_size(edge_of(h)) == 0)
    return is_forward(h) ? 1 : -1;
  return state.first_end(h) == 0 ? 1 : -1;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_LENGTHS_H
