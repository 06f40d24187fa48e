// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_WHITEHEAD_SOLVER_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_WHITEHEAD_SOLVER_H

#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/forces.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Singular_places.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/balance.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/relax_vertex.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// How a sweep moves the vertices, and which it leaves alone.
struct Whitehead_options
{
  double over_relaxation = 1;
  // The paper's own set of moves, which has no move for a vertex whose spokes all form one sector.
  bool are_moves_literal = false;
  // Zhao's staging [3.2]: critical moves wait until no other move spreads the leaves.
  bool are_critical_moves_staged = false;
  // A sweep moves only the vertices that leaves have reached before it, so that leaves spread by
  // one ring of triangles, whatever the order of the vertices.
  bool do_leaves_spread_by_rings = false;
};

// The paper's algorithm [3.2] on our state: sweeps of discrete Whitehead moves, one vertex after
// another, starting with all leaves in the loops. In terms of the equivariant map a move is a step
// of coordinate descent; the sectors of a vertex are its directions.
//
// A vertex whose spokes all form one sector is the tip of a fold, an accidental thorn. The paper's
// rule has no move for it, because the sum over the other sectors is empty, and foliations freeze
// with hundreds of such tips. Here the tip moves in its only direction, which pulls the fold back
// through all triangles that it reaches.
class Whitehead_solver
{
public:
  Whitehead_solver(Foliation_state& state, const Whitehead_options& options)
    : m_state(state),
      m_options(options),
      m_relax(state, options.over_relaxation),
      m_order(state.mesh().number_of_vertices()),
      m_is_first_stage(options.are_critical_moves_staged)
  {
    std::iota(m_order.begin(), m_order.end(), 0);
  }

  bool are_moves_literal() const { return m_options.are_moves_literal; }

  // the order in which a sweep goes over the vertices
  void set_order(std::vector<int> order) { m_order = std::move(order); }

  void sweep()
  {
    bool has_spread = false;
    if (m_options.do_leaves_spread_by_rings)
    {
      const std::vector<bool> is_reached = reached_vertices();
      for (int v : m_order)
        has_spread |= is_reached[v] && move(v);
    }
    else
      for (int v : m_order)
        has_spread |= move(v);
    if (m_is_first_stage && !has_spread)
      m_is_first_stage = false;
    ++m_number_of_sweeps;
  }

  // computes the balance, which takes as long as half a sweep
  Foliation_statistics statistics(double tolerance) const
  {
    Foliation_statistics result = balance(m_state);
    result.number_of_iterations = m_number_of_sweeps;
    result.has_converged = result.resolved_optimality < tolerance;
    return result;
  }

  // the tips of folds
  std::vector<int> vertices_with_one_sector()
  {
    std::vector<int> result;
    for (int v = 0; v < m_state.mesh().number_of_vertices(); ++v)
      if (!m_state.is_fixed(v) && has_one_sector(v))
        result.push_back(v);
    return result;
  }

  // The vertices whose moves were critical, in the order in which they were made: since the first
  // stage ended, if moves are staged.
  const std::vector<int>& critical_moves() const { return m_critical_moves; }
  bool is_in_first_stage() const { return m_is_first_stage; }

private:
  // those with an edge that leaves cross
  std::vector<bool> reached_vertices() const
  {
    std::vector<bool> result(m_state.mesh().number_of_vertices(), false);
    for (int h = 0; h < m_state.mesh().number_of_halfedges(); ++h)
      if (m_state.word_size(edge_of(h)) > 0 || !m_state.is_at_node(m_state.mesh().source(h)))
        result[m_state.mesh().source(h)] = true;
    return result;
  }

  // returns whether leaves reached an edge that had none
  bool move(int v)
  {
    if (m_state.is_fixed(v) || (m_options.are_moves_literal && has_one_sector(v)))
      return false;
    if (!m_options.are_critical_moves_staged || !m_state.is_at_node(v))
    {
      m_relax(v);
      return false;
    }
    return spread(v);
  }

  // all spokes begin in one direction, and none is zero
  bool has_one_sector(int v)
  {
    if (m_state.is_at_node(v))
    {
      find_directions(m_state, v, m_directions);
      return m_directions.size() == 1 &&
             std::find(m_directions.of_spoke.begin(), m_directions.of_spoke.end(),
                       Directions::NONE) == m_directions.of_spoke.end();
    }
    int ups = 0, downs = 0;
    for (int h : m_state.mesh().ring(v))
    {
      const double pull = pull_at_source(m_state, h);
      ups += pull >= 0;
      downs += pull <= 0;
    }
    return ups == 0 || downs == 0;
  }

  // Moves a vertex from a node, unless that is critical and not yet allowed.
  bool spread(int v)
  {
    const int direction = m_relax.strongest_direction(v);
    if (direction == Directions::NONE)
      return false;
    const std::vector<int>& of_spoke = m_relax.directions().of_spoke;
    const bool has_zero_spoke =
      std::find(of_spoke.begin(), of_spoke.end(), Directions::NONE) != of_spoke.end();
    if (is_critical(v, direction))
    {
      if (m_is_first_stage)
        return false;
      m_critical_moves.push_back(v);
    }
    m_relax(v);
    return has_zero_spoke;
  }

  // Whether the move of v in a direction turns a neighbor from a pole into a vertex that is not a
  // pole [3.2]. (By the index 2 - C + Z, vertices without leaves are poles.) A neighbor u along a
  // zero spoke gets a nonzero spoke; of its two closed corners beside that spoke, those open whose
  // other spoke goes in the same direction, from u as from v.
  bool is_critical(int v, int direction) const
  {
    const std::vector<int>& of_spoke = m_relax.directions().of_spoke;
    const Flat_mesh::Ring ring = m_state.mesh().ring(v);
    const int n = ring.size();
    for (int i = 0; i < n; ++i)
    {
      const int u = m_state.mesh().target(ring[i]);
      if (of_spoke[i] != Directions::NONE || m_state.is_fixed(u))
        continue;
      const int before = index_of_vertex(m_state, u);
      const int after = before - 1 + (of_spoke[(i + 1) % n] == direction) +
                        (of_spoke[(i + n - 1) % n] == direction);
      if (before > 0 && after <= 0)
        return true;
    }
    return false;
  }

  Foliation_state& m_state;
  Whitehead_options m_options;
  Vertex_relaxation m_relax;
  std::vector<int> m_order;
  bool m_is_first_stage;
  std::vector<int> m_critical_moves;
  Directions m_directions;
  std::size_t m_number_of_sweeps = 0;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_WHITEHEAD_SOLVER_H
