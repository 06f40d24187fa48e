// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_RELAX_VERTEX_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_RELAX_VERTEX_H

#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/forces.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Moves one vertex to where the energy is least while all others stay fixed: one step of
// Gauss-Seidel relaxation, and the Whitehead move of Section 3.2. With a factor greater than 1, it
// goes that much farther inside its arc (over-relaxation).
class Vertex_relaxation
{
public:
  explicit Vertex_relaxation(Foliation_state& state, double factor = 1)
    : m_state(state), m_factor(factor)
  {}

  void operator()(int v)
  {
    if (m_state.is_fixed(v))
      return;
    // the energy decreases with every passage; the bound only guards against rounding
    for (int passages = 0; passages < 8; ++passages)
      if (!(m_state.is_at_node(v) ? leave_node(v) : slide(v)))
        return;
  }

  // The direction of a vertex at a node that outweighs all others together, or NONE; afterward,
  // `directions()` are those of the vertex.
  int strongest_direction(int v)
  {
    find_directions(m_state, v, m_directions);
    if (m_directions.letters.empty())
      return Directions::NONE;
    find_forces(m_state, v, m_directions);
    const auto strongest = std::max_element(m_directions.force.begin(), m_directions.force.end());
    const double excess = 2 * *strongest - m_directions.total_force;
    return excess > rounding * m_directions.total_force
             ? static_cast<int>(strongest - m_directions.force.begin())
             : Directions::NONE;
  }

  const Directions& directions() const { return m_directions; }

private:
  // Moves v within its arc; returns whether it arrives at a node.
  bool slide(int v)
  {
    double pull = 0;
    for (int h : m_state.mesh().ring(v))
      pull += pull_at_source(m_state, h);
    const double t = m_state.parameter(v) + m_factor * pull / m_state.total_weight(v);
    const Letter letter = m_state.half_arc(v, t > 0 ? 1 : 0);
    if (t > 0 && t < m_state.length_of_arc(letter))
    {
      m_state.set_parameter(v, t);
      return false;
    }
    m_state.move_to_node(v, letter);
    return true;
  }

  // Moves v from its node in the direction that outweighs all others, if there is one; returns
  // whether it arrives at the other end of that arc.
  bool leave_node(int v)
  {
    const int d = strongest_direction(v);
    if (d == Directions::NONE)
      return false;
    const Letter letter = m_directions.letters[d];
    const double excess = 2 * m_directions.force[d] - m_directions.total_force;
    const double step = excess / m_state.total_weight(v);
    const double length = m_state.length_of_arc(letter);
    const double t = letter.end() == 0 ? step : length - step;
    if (t > 0 && t < length)
    {
      m_state.move_into_arc(v, letter, t);
      return false;
    }
    if (step < length) // t is an end up to rounding
      return false;
    m_state.move_into_arc(v, letter, length / 2);
    m_state.move_to_node(v, letter.other_end());
    return true;
  }

  // an excess that may be due to rounding does not upset a balance of forces
  static constexpr double rounding = 1e-14;

  Foliation_state& m_state;
  double m_factor;
  Directions m_directions;
};

// Lets vertices leave their nodes until none needs to, each at most once: with weights of very
// different sizes, neighbors hold each other at a node, and are released only one after another.
inline void release_from_nodes(Foliation_state& state, const std::vector<int>& vertices)
{
  Vertex_relaxation relax(state);
  std::vector<bool> has_left(state.mesh().number_of_vertices(), false);
  std::vector<int> stack(vertices.rbegin(), vertices.rend());
  while (!stack.empty())
  {
    const int v = stack.back();
    stack.pop_back();
    if (has_left[v] || state.is_fixed(v) || !state.is_at_node(v))
      continue;
    relax(v);
    if (state.is_at_node(v))
      continue;
    has_left[v] = true;
    for (int h : state.mesh().ring(v))
      stack.push_back(state.mesh().target(h));
  }
}

// How wide the relaxed band is around places where words have changed.
constexpr int rings_of_band = 2;

// How long the band is relaxed after a step: the first step changes words all over the mesh, and
// relaxation costs as much as it saves; later bands are short, and long relaxation of them saves
// steps.
inline int sweeps_of_band(int number_of_steps)
{
  return number_of_steps > 1 ? 40 : 10;
}

// A few sweeps of relaxation over the given vertices and those within `rings` edges of them.
inline void relax_band(Foliation_state& state, const std::vector<int>& band, int rings, int sweeps)
{
  std::vector<bool> is_in_band(state.mesh().number_of_vertices(), false);
  std::vector<int> vertices;
  const auto add = [&](int v) {
    if (!is_in_band[v])
    {
      is_in_band[v] = true;
      vertices.push_back(v);
    }
  };
  for (int v : band)
    add(v);
  for (std::size_t first = 0; rings > 0; --rings)
    for (const std::size_t last = vertices.size(); first < last; ++first)
      for (int h : state.mesh().ring(vertices[first]))
        add(state.mesh().target(h));
  Vertex_relaxation relax(state);
  for (int sweep = 0; sweep < sweeps; ++sweep)
  {
    for (int v : vertices)
      relax(v);
    std::reverse(vertices.begin(), vertices.end());
  }
  release_from_nodes(state, vertices);
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_RELAX_VERTEX_H
