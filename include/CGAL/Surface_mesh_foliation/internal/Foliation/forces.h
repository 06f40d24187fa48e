// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_FORCES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_FORCES_H

#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/lengths.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The force that pulls source(h), in an arc, toward larger t along h; `tension` is weight times
// length of the edge. Letters, words and frames: see the glossary in ARCHITECTURE.md.
inline double pull_at_source(const Foliation_state& state, int h, double tension)
{
  if (state.word_size(edge_of(h)) > 0)
    return state.first_end(h) == 1 ? tension : -tension;
  // without a branch, which nobody could predict
  const bool is_downward =
    state.parameter(state.mesh().target(h)) < state.parameter(state.mesh().source(h));
  return tension * (1 - 2 * static_cast<int>(is_downward));
}

inline double pull_at_source(const Foliation_state& state, int h)
{
  const int e = edge_of(h);
  if (state.word_size(e) > 0)
    return pull_at_source(state, h, state.weight(e) * length_of_edge(state, e));
  return state.weight(e) *
         (state.parameter(state.mesh().target(h)) - state.parameter(state.mesh().source(h)));
}

// The directions of T at the image of a vertex in which spokes leave it: their different first
// letters.
struct Directions
{
  static constexpr int NONE = -1;
  std::vector<Letter> letters; // in the frame of the vertex
  std::vector<int> of_spoke;   // index into letters, NONE for a spoke with an empty word
  std::vector<double> force;   // sum of weight times length over the spokes of a direction
  double total_force = 0;

  int size() const { return static_cast<int>(letters.size()); }
};

// finds the directions at a vertex that lies at a node and is not a pole
inline void find_directions(const Foliation_state& state, int v, Directions& directions)
{
  directions.letters.clear();
  directions.of_spoke.clear();
  for (int h : state.mesh().ring(v))
  {
    if (state.word_size(edge_of(h)) == 0)
    {
      directions.of_spoke.push_back(Directions::NONE);
      continue;
    }
    const Letter letter = state.first_letter(h);
    int d = 0;
    while (d < directions.size() && directions.letters[d] != letter)
      ++d;
    if (d == directions.size())
      directions.letters.push_back(letter);
    directions.of_spoke.push_back(d);
  }
}

// finds the force of each direction; `length_of` gives w of a spoke
template <class Length>
void find_forces(const Foliation_state& state,
                 int v,
                 Directions& directions,
                 const Length& length_of)
{
  directions.force.assign(directions.letters.size(), 0);
  directions.total_force = 0;
  int i = 0;
  for (int h : state.mesh().ring(v))
  {
    const int d = directions.of_spoke[i++];
    if (d == Directions::NONE)
      continue;
    const double force = state.weight(edge_of(h)) * length_of(h);
    directions.force[d] += force;
    directions.total_force += force;
  }
}

inline void find_forces(const Foliation_state& state, int v, Directions& directions)
{
  find_forces(state, v, directions, [&](int h) { return length_of_edge(state, edge_of(h)); });
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_FORCES_H
