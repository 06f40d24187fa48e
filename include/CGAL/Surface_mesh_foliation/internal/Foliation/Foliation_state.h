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
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Tree_paths.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// a parameter that rounding cannot have put onto an end of its arc
inline double inner_parameter(double t, double height)
{
  constexpr double margin = 4 * std::numeric_limits<double>::epsilon();
  return std::clamp(t, margin * height, (1 - margin) * height);
}

// Where the equivariant map sends the vertices and edges of the mesh: the part of the state that
// changes. A cell is a lift (>= 0), in the frame of the vertex, or ~node.
struct Tree_map
{
  std::vector<int> cell;
  std::vector<double> t; // distance from end 0 of the arc; 0 at a node
  Tree_paths paths;
  // Whether linear systems count the parameter of a vertex upwards (1) or downwards (-1). A vertex
  // that passes a node keeps its heading; at the node, this is the heading that it came with.
  std::vector<signed char> orientation;
};

// The directions of T at the image of a vertex that is met by spokes: the different first letters.
struct Directions
{
  static constexpr int NONE = -1;
  std::vector<int> letters;  // in the frame of the vertex
  std::vector<int> of_spoke; // index into letters, NONE for a spoke with empty word
  std::vector<double> force; // sum of weight times length over the spokes of a direction
  double total_force = 0;
};

// A measured foliation in the class of a loop system, as an equivariant map f to the tree T
// dual to the lifts of the loops: w_e is the distance in T between the images of the ends of e.
//
// Which lift is which is decided by names (Lifts), never by lengths. A vertex moves over one
// half-arc H at a time: every spoke whose word begins with H loses that letter, every other gains
// it. So words stay reduced, every state is an equivariant map, and the energy
// sum alpha_e w_e^2 is convex along its moves.
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
      m_total_weight[mesh().source(h)] += m_weight[h / 2];
    for (const Pole& pole : system.poles)
      for (int v : pole)
        m_is_fixed[v] = true;
    put_leaves_into_loops();
  }

  Foliation_state(const Foliation_state&) = delete;
  Foliation_state& operator=(const Foliation_state&) = delete;

  // what runs loops over the mesh
  const Executor& executor() const { return *m_executor; }
  void set_executor(const Executor& executor) { m_executor = &executor; }

  const Flat_loop_system& system() const { return m_system; }
  const Flat_mesh& mesh() const { return m_system.mesh; }
  const Deck_cocycle& deck() const { return m_deck; }
  const Lifts& lifts() const { return m_lifts; }
  const Tree_map& map() const { return m_map; }
  void set_map(Tree_map map) { m_map = std::move(map); }
  // the number of a lift of loop `arc` that some frame knows by this name
  int lift(int arc, const Group_word& name) const { return m_lifts.intern(arc, name); }
  void set_parameter(int v, double t) { m_map.t[v] = t; }

  int orientation(int v) const { return m_map.orientation[v]; }
  void turn(int v) { m_map.orientation[v] = static_cast<signed char>(-m_map.orientation[v]); }

  double weight(int e) const { return m_weight[e]; }
  double total_weight(int v) const { return m_total_weight[v]; }
  bool is_fixed(int v) const { return m_is_fixed[v]; }
  void fix(int v) { m_is_fixed[v] = true; }

  bool is_at_node(int v) const { return m_map.cell[v] < 0; }
  bool is_free_in_arc(int v) const { return m_map.cell[v] >= 0 && !m_is_fixed[v]; }
  int node(int v) const { return ~m_map.cell[v]; }
  int arc(int v) const { return m_lifts.arc(m_map.cell[v]); }
  double parameter(int v) const { return m_map.t[v]; }

  int arc_of_letter(int letter) const { return m_lifts.arc(letter / 2); }
  double length_of_arc(int letter) const { return m_system.height(arc_of_letter(letter)); }
  int node_of_letter(int letter) const
  {
    return m_system.node_of_end[2 * arc_of_letter(letter) + letter % 2];
  }
  // how far the point t of the arc of `letter` is from the end that the letter names
  double distance_to_end(int letter, double t) const
  {
    return letter % 2 == 0 ? t : length_of_arc(letter) - t;
  }

  int word_size(int e) const { return m_map.paths.size(e); }

  // the i-th letter passed on the way along h, in the frame of the edge
  int letter(int h, int i) const
  {
    const int e = h / 2;
    return m_map.paths(e, h % 2 == 0 ? i : word_size(e) - 1 - i);
  }

  // the first letter passed on the way along h, in the frame of source(h);
  // precondition: the word is not empty and source(h) is no pole
  int first_letter(int h) const { return transport(h, letter(h, 0), true); }

  // a lift in the frame of source(h), seen from the frame of the edge, and the other way round
  int lift_in_edge_frame(int h, int lift) const { return transport(h, 2 * lift, false) / 2; }
  int lift_in_vertex_frame(int h, int lift) const { return transport(h, 2 * lift, true) / 2; }

  // which end of its arc the way along h leaves by first; the same in all frames
  int first_end(int h) const { return letter(h, 0) % 2; }

  // The lift that the image of h runs through in the given arc cell (cell 0 holds source(h)), in
  // the frame of face(h).
  Group_word name_of_cell(int h, int cell) const
  {
    const int n = word_size(h / 2);
    int lift;
    if (n == 0)
      lift = lift_in_edge_frame(h, m_map.cell[mesh().source(h)]);
    else
      lift = letter(h, cell > 0 ? cell - 1 : 0) / 2;
    const Group_word& name = m_lifts.name(lift);
    return h % 2 == 0 ? name : m_lifts.transported(name, m_deck.element(h ^ 1));
  }

  // w_e, if the source and the target of halfedge 2e were at the given parameters of their cells
  double length(int e, double t_source, double t_target) const
  {
    const int u = mesh().source(2 * e), v = mesh().target(2 * e), n = word_size(e);
    if (n == 0)
      return is_at_node(u) ? 0 : std::abs(t_source - t_target);
    int first = 0, last = n;
    double result = 0;
    if (!is_at_node(u))
      result += distance_to_end(m_map.paths(e, first++), t_source);
    if (!is_at_node(v))
      result += distance_to_end(m_map.paths(e, --last), t_target);
    for (; first < last; first += 2)
      result += length_of_arc(m_map.paths(e, first));
    return result;
  }

  // w_e
  double length(int e) const
  {
    return length(e, m_map.t[mesh().source(2 * e)], m_map.t[mesh().target(2 * e)]);
  }

  double energy() const
  {
    return sum_of_numbers(executor(), mesh().number_of_edges(), [&](int e) {
      const double w = length(e);
      return m_weight[e] * w * w;
    });
  }

  // the derivative of w_e by the parameter of source(h); precondition: source(h) is in an arc
  int slope(int h) const
  {
    if (word_size(h / 2) == 0)
      return h % 2 == 0 ? 1 : -1; // of the signed difference t(source) - t(target) of 2e
    return first_end(h) == 0 ? 1 : -1;
  }

  // The force that pulls source(h), in an arc, towards larger t along h; `force` is weight times
  // length of the edge.
  double pull(int h, double force) const
  {
    if (word_size(h / 2) == 0)
      return m_map.t[mesh().target(h)] >= m_map.t[mesh().source(h)] ? force : -force;
    return first_end(h) == 1 ? force : -force;
  }
  double pull(int h) const { return pull(h, m_weight[h / 2] * length(h / 2)); }

  // finds the directions at a vertex that lies at a node and is no pole
  void find_directions(int v, Directions& directions) const
  {
    directions.letters.clear();
    directions.of_spoke.clear();
    for (int h : mesh().ring(v))
    {
      if (word_size(h / 2) == 0)
      {
        directions.of_spoke.push_back(Directions::NONE);
        continue;
      }
      const int letter = first_letter(h);
      int d = 0;
      while (d < size(directions) && directions.letters[d] != letter)
        ++d;
      if (d == size(directions))
        directions.letters.push_back(letter);
      directions.of_spoke.push_back(d);
    }
  }

  // finds the force of each direction; `length_of` gives w of a spoke
  template <class Length>
  void find_forces(int v, Directions& directions, const Length& length_of) const
  {
    directions.force.assign(directions.letters.size(), 0);
    directions.total_force = 0;
    int i = 0;
    for (int h : mesh().ring(v))
    {
      const int d = directions.of_spoke[i++];
      if (d == Directions::NONE)
        continue;
      const double force = m_weight[h / 2] * length_of(h);
      directions.force[d] += force;
      directions.total_force += force;
    }
  }

  void find_forces(int v, Directions& directions) const
  {
    find_forces(v, directions, [&](int h) { return length(h / 2); });
  }

  static int size(const Directions& directions)
  {
    return static_cast<int>(directions.letters.size());
  }

  // moves v from its arc over the half-arc `letter` (in the frame of v) to the node behind it
  void move_to_node(int v, int letter)
  {
    CGAL_assertion(!m_is_fixed[v] && m_map.cell[v] == letter / 2);
    pass(v, letter);
    m_map.cell[v] = ~node_of_letter(letter);
    m_map.t[v] = 0;
    if (letter % 2 == 0)
      turn(v);
  }

  // moves v from its node over the half-arc `letter` into the arc, at parameter t
  void move_into_arc(int v, int letter, double t)
  {
    CGAL_assertion(!m_is_fixed[v] && is_at_node(v) && node(v) == node_of_letter(letter));
    pass(v, letter);
    m_map.cell[v] = letter / 2;
    m_map.t[v] = t;
    if (letter % 2 == 1)
      turn(v);
  }

private:
  int transport(int h, int letter, bool is_backward) const
  {
    const int element = m_deck.transport(h);
    return element == 0 ? letter
                        : 2 * m_lifts.transport(letter / 2, element, is_backward) + letter % 2;
  }

  void pass(int v, int letter)
  {
    for (int h : mesh().ring(v))
    {
      const int e = h / 2, here = transport(h, letter, false);
      const bool is_from_front = h % 2 == 0;
      Tree_paths& paths = m_map.paths;
      if (paths.size(e) > 0 && (is_from_front ? paths.front(e) : paths.back(e)) == here)
        is_from_front ? paths.pop_front(e) : paths.pop_back(e);
      else
        is_from_front ? paths.push_front(e, here) : paths.push_back(e, here);
    }
  }

  // The foliation whose leaves all lie in the loops [3.2, Initialization]: every vertex is at the
  // node of its region, and a crossing of loop l is a passage of the lift of l that the walk along
  // l has reached there, called P^-1 l P in the frame reached by its part P.
  void put_leaves_into_loops()
  {
    const int n = mesh().number_of_vertices();
    m_map.cell.resize(n);
    m_map.t.assign(n, 0);
    m_map.orientation.assign(n, 1);
    for (int v = 0; v < n; ++v)
      m_map.cell[v] = ~m_system.node_of_vertex[v];
    m_map.paths = Tree_paths(mesh().number_of_edges());
    std::vector<std::vector<int>> lift_of_crossing(m_system.number_of_arcs());
    for (int a = 0; a < m_system.number_of_arcs(); ++a)
      lift_of_crossing[a] = lifts_along_loop(a);
    for (int e = 0; e < mesh().number_of_edges(); ++e)
      for (int i = 0; i < m_system.crossings.size(e); ++i)
      {
        // who walks to the target of the crossed halfedge meets the loop from its right side
        const Edge_crossings::Entry& entry = m_system.crossings.entry(e, i);
        const int lift = lift_of_crossing[entry.loop][entry.index];
        const int side = entry.halfedge % 2 == 0 ? 1 : 0;
        append(e, 2 * lift + side);
        append(e, 2 * lift + 1 - side);
      }
  }

  // A loop that crosses an edge to and fro, as one may that was pushed off a walk with a chord,
  // gives a word that is not reduced.
  void append(int e, int letter)
  {
    if (m_map.paths.size(e) > 0 && m_map.paths.back(e) == letter)
      m_map.paths.pop_back(e);
    else
      m_map.paths.push_back(e, letter);
  }

  // the lifts met at the crossings of a loop, each in the frame of its edge
  std::vector<int> lifts_along_loop(int a)
  {
    const std::vector<Flat_crossing>& crossings = m_system.loops[a].crossings;
    const Surface_group& group = m_deck.group();
    Group_word translation;
    for (const Flat_crossing& crossing : crossings)
      translation = group.product(translation, m_deck.element(crossing.halfedge));
    if (group.is_abelian())
    {
      m_lifts.set_torus_loop(translation);
      translation.clear();
    }
    std::vector<int> result;
    Group_word way;
    for (const Flat_crossing& crossing : crossings)
    {
      const int h = crossing.halfedge;
      const Group_word next = group.product(way, m_deck.element(h));
      result.push_back(
        m_lifts.intern(a, m_lifts.transported(translation, h % 2 == 0 ? way : next)));
      way = next;
    }
    return result;
  }

  const Flat_loop_system& m_system;
  const Executor* m_executor = &executor_for<CGAL::Sequential_tag>();
  Deck_cocycle m_deck;
  mutable Lifts m_lifts;              // numbers lifts as they are met; what they mean never changes
  std::vector<double> m_weight;       // by edge
  std::vector<double> m_total_weight; // by vertex: sum over its edges
  std::vector<bool> m_is_fixed;       // by vertex
  Tree_map m_map;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_FOLIATION_STATE_H
