// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_ARC_PATHS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_ARC_PATHS_H

#include <CGAL/Surface_mesh_foliation/internal/Leaves/Level_tracer.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// By arc, a path from its end 0 to its end 1 along as few edges as possible: one edge that passes
// the whole arc, or an edge that enters it, edges between its vertices, and one that leaves it. Its
// steps are stored as crossings of leaves, each over a halfedge that leads toward end 1.
//
// Such a path exists: the edges, cut where they pass nodes, join the two ends and the vertices of
// an arc, and around every piece of a face, consecutive ones meet at a vertex or at an end.
// Neighboring pieces share an edge, and the component is connected.
//
// The leaf at a level separates the ends, so it crosses the path an odd number of times.
class Arc_paths
{
public:
  explicit Arc_paths(const Foliation_state& state)
    : m_state(state), m_steps(state.system().number_of_arcs())
  {
    find_edges_through();
    find_paths_along_vertices();
    CGAL_assertion(std::none_of(m_steps.begin(), m_steps.end(),
                                [](const auto& steps) { return steps.empty(); }));
  }

  // a step of the path that leads from below the level to above it, by bisection
  Leaf_crossing step_at(int arc, double level) const
  {
    int below = 0, above = static_cast<int>(m_steps[arc].size());
    while (above - below > 1)
    {
      const int middle = below + (above - below) / 2;
      (is_above(arc, middle, level) ? above : below) = middle;
    }
    return m_steps[arc][below];
  }

  // all steps that cross the level, upward or downward, each in the direction in which a leaf
  // crosses it with the higher side to its left
  std::vector<Leaf_crossing> all_steps_at(int arc, double level) const
  {
    std::vector<Leaf_crossing> result;
    for (int i = 0; i < static_cast<int>(m_steps[arc].size()); ++i)
    {
      const Leaf_crossing step = m_steps[arc][i];
      const bool is_above_before = is_above(arc, i, level);
      if (is_above_before == is_above(arc, i + 1, level))
        continue;
      result.push_back(is_above_before ? reversed(step) : step);
    }
    return result;
  }

private:
  // whether the i-th station of the path, which lies before the i-th step, is above the level
  bool is_above(int arc, int i, double level) const
  {
    if (i == 0 || i == static_cast<int>(m_steps[arc].size()))
      return i != 0;
    return m_state.parameter(m_state.mesh().source(m_steps[arc][i].halfedge)) >= level;
  }

  Leaf_crossing reversed(const Leaf_crossing& step) const
  {
    return {opposite_of(step.halfedge), m_state.word_size(edge_of(step.halfedge)) - step.cell};
  }

  void find_edges_through()
  {
    for (int e = 0; e < m_state.mesh().number_of_edges(); ++e)
      for (int cell = 1; cell < m_state.word_size(e); ++cell)
      {
        const Leaf_crossing step = {halfedge_of(e), cell};
        if (!is_cell_arc(m_state, halfedge_of(e), cell))
          continue;
        std::vector<Leaf_crossing>& steps = m_steps[arc_of_cell(m_state, halfedge_of(e), cell)];
        if (steps.empty())
          steps.push_back(m_state.letter(halfedge_of(e), cell - 1).end() == 0 ? step
                                                                              : reversed(step));
      }
  }

  // breadth first, at once in all arcs that no single edge passes
  void find_paths_along_vertices()
  {
    constexpr int NONE = -1;
    const Flat_mesh& mesh = m_state.mesh();
    std::vector<Leaf_crossing> step_to(mesh.number_of_vertices(), {NONE, 0});
    std::vector<int> queue;
    const auto reach = [&](int v, const Leaf_crossing& step) {
      if (step_to[v].halfedge != NONE)
        return;
      step_to[v] = step;
      queue.push_back(v);
    };
    for (int v = 0; v < mesh.number_of_vertices(); ++v)
      if (!m_state.is_at_node(v) && m_steps[m_state.arc(v)].empty())
        if (const int h = spoke_to_end(v, 0); h >= 0)
          reach(v, reversed({h, 0}));
    for (std::size_t i = 0; i < queue.size(); ++i)
    {
      const int v = queue[i];
      if (!m_steps[m_state.arc(v)].empty())
        continue;
      if (const int h = spoke_to_end(v, 1); h >= 0)
        m_steps[m_state.arc(v)] = way_back({h, 0}, step_to);
      for (int h : mesh.ring(v))
        if (m_state.word_size(edge_of(h)) == 0)
          reach(mesh.target(h), {h, 0});
    }
  }

  // the first spoke of a vertex in an arc that leaves the arc by the given end, or -1
  int spoke_to_end(int v, int end) const
  {
    for (int h : m_state.mesh().ring(v))
      if (m_state.word_size(edge_of(h)) > 0 && m_state.first_end(h) == end)
        return h;
    return -1;
  }

  std::vector<Leaf_crossing> way_back(const Leaf_crossing& last,
                                      const std::vector<Leaf_crossing>& step_to) const
  {
    std::vector<Leaf_crossing> result = {last};
    do
      result.push_back(step_to[m_state.mesh().source(result.back().halfedge)]);
    while (m_state.word_size(edge_of(result.back().halfedge)) == 0);
    std::reverse(result.begin(), result.end());
    return result;
  }

  const Foliation_state& m_state;
  std::vector<std::vector<Leaf_crossing>> m_steps; // by arc
};

} // namespace internal

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_ARC_PATHS_H
