// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_FOLIATION_STATE_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_FOLIATION_STATE_H

#include <CGAL/Surface_mesh_foliation/internal/Common/Executor.h>
#include <CGAL/Surface_mesh_foliation/internal/Homotopy/Deck_cocycle.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/Flat_loop_system.h>
#include <CGAL/Surface_mesh_foliation/internal/Homotopy/Lifts.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Letter.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Tree_map.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/absorb_enclosed_disks.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/leaves_in_loops.h>

#include <CGAL/assertions.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// A measured foliation in the class of a loop system, as an equivariant map f to the tree T
// dual to the lifts of the loops: w_e is the distance in T between the images of the ends of e.
//
// Which lift is which is decided by names (Lifts), never by lengths. A vertex moves over one
// half-arc H at a time: every spoke whose word begins with H loses that letter, and every other
// spoke gains it. So words stay reduced, every state is an equivariant map, and the energy sum
// alpha_e w_e^2 is convex along its moves.
//
// The class is the map with its moves. It starts with all leaves in the loops (leaves_in_loops.h);
// lengths.h and forces.h measure it. Letters, words and frames: see the glossary in
// ARCHITECTURE.md.
class Foliation_state
{
public:
  // weight: by edge, positive
  Foliation_state(const Flat_loop_system& system, std::vector<double> weight)
    : Foliation_state(system, std::move(weight), Deck_cocycle(system.mesh, system.poles))
  {}

  Foliation_state(const Flat_loop_system& system, std::vector<double> weight, Deck_cocycle deck)
    : m_system(system),
      m_deck(std::move(deck)),
      m_lifts(m_deck),
      m_weight(std::move(weight)),
      m_total_weight(system.mesh.number_of_vertices(), 0),
      m_is_fixed(system.mesh.number_of_vertices(), false)
  {
    for (int h = 0; h < mesh().number_of_halfedges(); ++h)
      m_total_weight[mesh().source(h)] += m_weight[edge_of(h)];
    for (const Pole& pole : system.poles)
      for (int v : pole)
        m_is_fixed[v] = true;
    m_map = leaves_in_loops(m_system, m_deck, m_lifts);
    for (int v : absorb_enclosed_disks(m_system, m_map))
      m_is_fixed[v] = true;
  }

  Foliation_state(const Foliation_state&) = delete;
  Foliation_state& operator=(const Foliation_state&) = delete;

  // runs the loops over the mesh
  const Executor& executor() const { return *m_executor; }
  void set_executor(const Executor& executor) { m_executor = &executor; }

  const Flat_loop_system& system() const { return m_system; }
  const Flat_mesh& mesh() const { return m_system.mesh; }
  const Deck_cocycle& deck() const { return m_deck; }
  const Lifts& lifts() const { return m_lifts; }
  const Tree_map& map() const { return m_map; }
  void set_map(Tree_map map) { m_map = std::move(map); }
  // the number for a lift of loop `arc` with this name, in whatever frame
  int lift(int arc, const Group_word& name) const { return m_lifts.intern(arc, name); }
  void set_parameter(int v, double t) { m_map.t[v] = t; }

  int orientation(int v) const { return m_map.orientation[v]; }
  void turn(int v) { m_map.orientation[v] = static_cast<signed char>(-m_map.orientation[v]); }

  double weight(int e) const { return m_weight[e]; }
  const std::vector<double>& weights() const { return m_weight; }
  double total_weight(int v) const { return m_total_weight[v]; }
  bool is_fixed(int v) const { return m_is_fixed[v]; }
  void fix(int v) { m_is_fixed[v] = true; }

  bool is_at_node(int v) const { return m_map.cell[v].is_node(); }
  bool is_free_in_arc(int v) const { return !is_at_node(v) && !m_is_fixed[v]; }
  int node(int v) const { return m_map.cell[v].node(); }
  int arc(int v) const { return m_lifts.arc(m_map.cell[v].lift()); }
  double parameter(int v) const { return m_map.t[v]; }

  // an end of the arc that v lies in, in the frame of v
  Letter half_arc(int v, int end) const { return Letter(m_map.cell[v].lift(), end); }

  int arc_of_letter(Letter letter) const { return m_lifts.arc(letter.lift()); }
  double length_of_arc(Letter letter) const { return m_system.height(arc_of_letter(letter)); }
  int node_of_letter(Letter letter) const
  {
    return m_system.node_of_end(arc_of_letter(letter), letter.end());
  }
  // how far the point t of the arc of `letter` is from the end that the letter names
  double distance_to_end(Letter letter, double t) const
  {
    return letter.end() == 0 ? t : length_of_arc(letter) - t;
  }

  int word_size(int e) const { return m_map.paths.size(e); }

  // the i-th letter passed along h, in the frame of the edge
  Letter letter(int h, int i) const
  {
    const int e = edge_of(h);
    return m_map.paths(e, is_forward(h) ? i : word_size(e) - 1 - i);
  }

  // the first letter passed along h, in the frame of source(h); precondition: the word is not empty
  // and source(h) is not a pole
  Letter first_letter(int h) const { return transport(h, letter(h, 0), true); }

  // a lift in the frame of source(h), as seen from the frame of the edge, and vice versa
  int lift_in_edge_frame(int h, int lift) const
  {
    return transport(h, Letter(lift, 0), false).lift();
  }
  int lift_in_vertex_frame(int h, int lift) const
  {
    return transport(h, Letter(lift, 0), true).lift();
  }

  // by which end of its arc the path along h first leaves; the same in all frames
  int first_end(int h) const { return letter(h, 0).end(); }

  // The lift that the image of h runs through in the given arc cell (cell 0 holds source(h)), in
  // the frame of face(h).
  Group_word name_of_cell(int h, int cell) const
  {
    const int n = word_size(edge_of(h));
    int lift;
    if (n == 0)
      lift = lift_in_edge_frame(h, m_map.cell[mesh().source(h)].lift());
    else
      lift = letter(h, cell > 0 ? cell - 1 : 0).lift();
    const Group_word& name = m_lifts.name(lift);
    return is_forward(h) ? name : m_lifts.transported(name, m_deck.element(opposite_of(h)));
  }

  // moves v from its arc over the half-arc `letter` (in the frame of v) to the node at its end
  void move_to_node(int v, Letter letter)
  {
    CGAL_assertion(!m_is_fixed[v] && m_map.cell[v] == Cell::arc(letter.lift()));
    pass(v, letter);
    m_map.cell[v] = Cell::at_node(node_of_letter(letter));
    m_map.t[v] = 0;
    if (letter.end() == 0)
      turn(v);
  }

  // moves v from its node over the half-arc `letter` into the arc, at parameter t
  void move_into_arc(int v, Letter letter, double t)
  {
    CGAL_assertion(!m_is_fixed[v] && is_at_node(v) && node(v) == node_of_letter(letter));
    pass(v, letter);
    m_map.cell[v] = Cell::arc(letter.lift());
    m_map.t[v] = t;
    if (letter.end() == 1)
      turn(v);
  }

private:
  Letter transport(int h, Letter letter, bool is_backward) const
  {
    const int element = m_deck.transport(h);
    return element == 0
             ? letter
             : Letter(m_lifts.transport(letter.lift(), element, is_backward), letter.end());
  }

  void pass(int v, Letter letter)
  {
    for (int h : mesh().ring(v))
    {
      const int e = edge_of(h);
      const Letter here = transport(h, letter, false);
      const bool is_from_front = is_forward(h);
      Tree_paths& paths = m_map.paths;
      if (paths.size(e) > 0 && (is_from_front ? paths.front(e) : paths.back(e)) == here)
        is_from_front ? paths.pop_front(e) : paths.pop_back(e);
      else
        is_from_front ? paths.push_front(e, here) : paths.push_back(e, here);
    }
  }

  const Flat_loop_system& m_system;
  const Executor* m_executor = &executor_for<CGAL::Sequential_tag>();
  Deck_cocycle m_deck;
  mutable Lifts m_lifts;              // numbers lifts as they are met; numbers keep their meaning
  std::vector<double> m_weight;       // by edge
  std::vector<double> m_total_weight; // by vertex: sum over its edges
  std::vector<bool> m_is_fixed;       // by vertex
  Tree_map m_map;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_FOLIATION_STATE_H
