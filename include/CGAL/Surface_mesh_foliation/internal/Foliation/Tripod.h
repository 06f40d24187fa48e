// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_TRIPOD_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_TRIPOD_H

#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>

#include <array>
#include <cmath>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The cells of T that the image of an edge passes are numbered along a halfedge h, from cell 0,
// which holds source(h), to cell word_size, which holds target(h); arcs and nodes alternate.
// Letters, words and frames: see the glossary in ARCHITECTURE.md.

inline bool is_cell_arc(const Foliation_state& state, int h, int cell)
{
  return state.is_at_node(state.mesh().source(h)) == (cell % 2 == 1);
}

// the arc of an arc cell
inline int arc_of_cell(const Foliation_state& state, int h, int cell)
{
  return cell == 0 ? state.arc(state.mesh().source(h))
                   : state.arc_of_letter(state.letter(h, cell - 1));
}

// the node of a node cell
inline int node_of_cell(const Foliation_state& state, int h, int cell)
{
  return cell == 0 ? state.node(state.mesh().source(h))
                   : state.node_of_letter(state.letter(h, cell - 1));
}

// the parameter of the end of an arc that the i-th letter along h names: 0 or the height
inline double parameter_of_passage(const Foliation_state& state, int h, int i)
{
  const Letter letter = state.letter(h, i);
  return letter.end() == 0 ? 0 : state.length_of_arc(letter);
}

// The length of the image of h from source(h) up to the parameter `t` of an arc cell.
inline double length_up_to(const Foliation_state& state, int h, int cell, double t)
{
  const double t_source = state.parameter(state.mesh().source(h));
  if (cell == 0)
    return std::abs(t - t_source);
  double result = std::abs(t - parameter_of_passage(state, h, cell - 1));
  for (int i = cell - 2; i >= 0; i -= 2)
    result += i == 0 ? state.distance_to_end(state.letter(h, 0), t_source)
                     : state.length_of_arc(state.letter(h, i));
  return result;
}

// The number of letters that the words of h and of the other edge of face(h) at source(h) have in
// common at their beginning.
inline int leg_at_source(const Foliation_state& state, int h)
{
  const Flat_mesh& mesh = state.mesh();
  return (state.word_size(edge_of(h)) + state.word_size(edge_of(mesh.prev(h))) -
          state.word_size(edge_of(mesh.next(h)))) /
         2;
}

// The image of a triangle in T: three legs from the corners to a center, whose numbers of letters
// are integers. The center is a node, or an arc that holds at least one corner.
class Tripod
{
public:
  Tripod(const Foliation_state& state, int face)
    : m_state(state), m_out(state.mesh().halfedges(face))
  {
    for (int i : {0, 1, 2})
      m_leg[i] = leg_at_source(state, m_out[i]);
  }

  // the halfedge of the face that leaves corner i
  int out(int i) const { return m_out[i]; }
  // the halfedge that leaves corner i along the other edge of the face
  int other_out(int i) const { return opposite_of(m_out[(i + 2) % 3]); }
  int corner(int i) const { return m_state.mesh().source(m_out[i]); }
  int leg(int i) const { return m_leg[i]; }

  bool is_center_arc() const { return is_cell_arc(m_state, m_out[0], m_leg[0]); }
  int arc_of_center() const { return arc_of_cell(m_state, m_out[0], m_leg[0]); }
  int node_of_center() const { return node_of_cell(m_state, m_out[0], m_leg[0]); }

  // the length in T of leg i; precondition: the center is a node
  double length_of_leg(int i) const
  {
    if (m_leg[i] == 0)
      return 0;
    const int last = m_leg[i] - 1;
    return length_up_to(m_state, m_out[i], last, parameter_of_passage(m_state, m_out[i], last));
  }

  // the center is inside the triangle: a tripod saddle
  bool is_singular() const
  {
    return m_leg[0] > 0 && m_leg[1] > 0 && m_leg[2] > 0 && !is_center_arc();
  }

  // the entire triangle lies at one node
  bool is_zero() const { return m_leg[0] + m_leg[1] + m_leg[2] == 0 && !is_center_arc(); }

private:
  const Foliation_state& m_state;
  std::array<int, 3> m_out;
  std::array<int, 3> m_leg;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_TRIPOD_H
