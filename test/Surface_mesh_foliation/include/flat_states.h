// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_FLAT_STATES_H
#define SMF_TEST_FLAT_STATES_H

#include "flat_systems.h"

#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/lengths.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/grow_fronts.h>

#include <gtest/gtest.h>

#include <vector>

// Foliations of the octahedron of which every number is known.

namespace smf_test {

inline const std::vector<int> equator = {0, 1, 2, 3};

inline double length(const internal::Foliation_state& state, int u, int v)
{
  return length_of_edge(state, internal::edge_of(state.mesh().find_halfedge(u, v)));
}

inline int word_size(const internal::Foliation_state& state, int u, int v)
{
  return state.word_size(internal::edge_of(state.mesh().find_halfedge(u, v)));
}

// the face with the three corners, which begin at any of them
inline int face_of(const internal::Flat_mesh& mesh, int a, int b, int c)
{
  const int h = mesh.find_halfedge(a, b);
  EXPECT_EQ(mesh.target(mesh.next(h)), c);
  return mesh.face(h);
}

// -1 at nodes
inline std::vector<double> parameters(const internal::Foliation_state& state,
                                      const std::vector<int>& vertices)
{
  std::vector<double> result;
  for (int v : vertices)
    result.push_back(state.is_at_node(v) ? -1 : state.parameter(v));
  return result;
}

// Poles at the top (vertex 4, end 0) and the bottom (vertex 5) of one arc of height 2, and the
// vertices 0 to 3 of the equator at the given parameters.
struct Equator
{
  explicit Equator(const std::vector<double>& t, double weight = 1)
    : system(octahedron_with_two_poles()),
      state(system, std::vector<double>(system.mesh.number_of_edges(), weight))
  {
    internal::grow_fronts(state);
    for (int v : equator)
      state.set_parameter(v, t[v]);
  }

  internal::Flat_loop_system system;
  internal::Foliation_state state;
};

} // namespace smf_test

#endif // SMF_TEST_FLAT_STATES_H
