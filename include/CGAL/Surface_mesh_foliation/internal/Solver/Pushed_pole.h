// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_PUSHED_POLE_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_PUSHED_POLE_H

#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/carried_map.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// What becomes of a foliation when one of its poles, a single vertex, moves to another vertex of
// its own arc, and nothing else changes except heights. The surface is pushed along a path of edges
// from the old place to the new one, so the leaves outside stay where they are; those inside the
// leaf through the new place are gathered there. (That is far from harmonic, but one linear solve
// spreads them.) The path crosses no other loop, so pushing carries the loops of one system to
// those of the other.
class Pushed_pole
{
public:
  // How to get from a foliation of one system to another system on a copy of the mesh; nothing if
  // this is not such a move.
  static std::optional<Pushed_pole> find(const Foliation_state& from, const Flat_loop_system& to)
  {
    const int pole = moved_pole(from.system(), to);
    if (pole == NONE || !has_only_poles_fixed(from))
      return std::nullopt;
    Pushed_pole result(from, pole, to.poles[pole][0]);
    if (!result.find_region() || !result.find_path())
      return std::nullopt;
    return result;
  }

  // the cocycle of the other system
  Deck_cocycle deck(const Flat_mesh& mesh) const
  {
    std::vector<Group_word> translations;
    for (int h : m_path) // the name of a lift is its deck translation
      translations.push_back(m_from->name_of_cell(opposite_of(h), 0));
    Deck_cocycle result(mesh, m_from->deck());
    result.push_pole(m_path, translations);
    return result;
  }

  // Whether a state of the other system can take the map: not if it has absorbed vertices next to
  // poles.
  static bool has_only_poles_fixed(const Foliation_state& state)
  {
    std::size_t poles = 0, fixed = 0;
    for (const Pole& pole : state.system().poles)
      poles += pole.size();
    for (int v = 0; v < state.mesh().number_of_vertices(); ++v)
      fixed += state.is_fixed(v);
    return fixed == poles;
  }

  // the map of a state of the other system with that cocycle
  Tree_map map(const Foliation_state& to) const
  {
    const Flat_mesh& mesh = to.mesh();
    Tree_map result = carried_map(*m_from, to);
    const double level = result.t[m_new];
    for (int v : m_region)
      result.t[v] = level;
    const Group_word name = m_from->name_of_cell(mesh.ring(m_old)[0], 0);
    result.cell[m_old] = Cell::arc(to.lift(m_arc, name));
    result.orientation[m_old] = result.orientation[m_new];
    for (int h : mesh.ring(m_old))
      is_forward(h) ? result.paths.pop_front(edge_of(h)) : result.paths.pop_back(edge_of(h));
    for (int h : mesh.ring(m_new))
    {
      const int lift = m_from->lift_in_edge_frame(h, m_from->map().cell[m_new].lift());
      const Letter letter(to.lift(m_arc, m_from->lifts().name(lift)), m_end);
      is_forward(h) ? result.paths.push_front(edge_of(h), letter)
                    : result.paths.push_back(edge_of(h), letter);
    }
    result.cell[m_new] = Cell::at_node(m_from->system().node_of_end(m_arc, m_end));
    result.t[m_new] = 0;
    return result;
  }

private:
  static constexpr int NONE = -1;

  Pushed_pole(const Foliation_state& from, int pole, int new_place)
    : m_from(&from), m_pole(pole), m_old(from.system().poles[pole][0]), m_new(new_place)
  {
    for (int a = 0; a < from.system().number_of_arcs(); ++a)
      for (int end : {0, 1})
        if (from.system().nodes[from.system().node_of_end(a, end)].pole == pole)
        {
          m_arc = a;
          m_end = end;
        }
  }

  // the loop of a pole, or NONE if it has been merged
  static int loop_of_pole(const Flat_loop_system& system, int pole)
  {
    for (int l = 0; l < system.number_of_arcs(); ++l)
      if (system.loops[l].pole == pole)
        return l;
    return NONE;
  }

  // the only pole that differs, if it is a vertex in both systems and nothing else differs
  static int moved_pole(const Flat_loop_system& a, const Flat_loop_system& b)
  {
    if (a.poles.size() != b.poles.size() || a.nodes_of_arc != b.nodes_of_arc)
      return NONE;
    int result = NONE;
    for (std::size_t p = 0; p < a.poles.size(); ++p)
      if (a.poles[p] != b.poles[p])
      {
        if (result != NONE || !is_vertex(a.poles[p]) || !is_vertex(b.poles[p]))
          return NONE;
        result = static_cast<int>(p);
      }
    if (result == NONE || !a.mesh.is_copy_of(b.mesh))
      return NONE;
    const int loop = loop_of_pole(a, result);
    return loop == loop_of_pole(b, result) && have_same_crossings(a, b, loop) ? result : NONE;
  }

  static bool is_vertex(const Pole& pole) { return pole.size() == 1 && !pole.is_cap(); }

  double distance_to_pole(int v) const
  {
    const double t = m_from->parameter(v);
    return m_end == 0 ? t : m_from->system().height(m_arc) - t;
  }

  bool is_in_arc(int v) const { return m_from->is_free_in_arc(v) && m_from->arc(v) == m_arc; }

  // Finds the vertices inside the leaf through the new place. Returns false if an edge between them
  // leaves the arc, which is possible on a very coarse mesh.
  bool find_region()
  {
    if (!is_in_arc(m_new))
      return false;
    const Flat_mesh& mesh = m_from->mesh();
    const double level = distance_to_pole(m_new);
    m_is_inside.assign(mesh.number_of_vertices(), false);
    m_is_inside[m_old] = true;
    m_region = {m_old};
    for (std::size_t i = 0; i < m_region.size(); ++i)
      for (int h : mesh.ring(m_region[i]))
      {
        const int v = mesh.target(h);
        if (!is_in_arc(v) || distance_to_pole(v) > level)
          continue;
        if (m_from->word_size(edge_of(h)) != (m_region[i] == m_old || v == m_old))
          return false;
        if (!m_is_inside[v])
          m_region.push_back(v);
        m_is_inside[v] = true;
      }
    return m_is_inside[m_new];
  }

  // Finds a path inside, breadth first, over edges that no other loop crosses.
  bool find_path()
  {
    const Flat_mesh& mesh = m_from->mesh();
    const int own_loop = loop_of_pole(m_from->system(), m_pole);
    const Edge_crossings& crossings = m_from->system().crossings;
    const auto is_crossed = [&](int e) {
      for (int i = 0; i < crossings.size(e); ++i)
        if (crossings.entry(e, i).loop != own_loop)
          return true;
      return false;
    };
    std::vector<int> queue = {m_old};
    std::unordered_map<int, int> entry = {{m_old, NONE}}; // the halfedge over which it was reached
    for (std::size_t i = 0; i < queue.size() && entry.count(m_new) == 0; ++i)
      for (int h : mesh.ring(queue[i]))
      {
        const int v = mesh.target(h);
        if (m_is_inside[v] && !is_crossed(edge_of(h)) && entry.emplace(v, h).second)
          queue.push_back(v);
      }
    if (entry.count(m_new) == 0)
      return false;
    for (int h = entry[m_new]; h != NONE; h = entry[mesh.source(h)])
      m_path.push_back(h);
    std::reverse(m_path.begin(), m_path.end());
    return true;
  }

  const Foliation_state* m_from;
  int m_pole;
  int m_old, m_new;            // its places
  int m_arc = NONE, m_end = 0; // its arc, and the end of the arc that is the pole
  std::vector<int> m_region; // the old place, and the vertices inside the leaf through the new one
  std::vector<bool> m_is_inside; // by vertex
  std::vector<int> m_path;       // halfedges
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_PUSHED_POLE_H
