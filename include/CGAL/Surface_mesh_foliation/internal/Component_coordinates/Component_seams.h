// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMPONENT_COORDINATES_COMPONENT_SEAMS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMPONENT_COORDINATES_COMPONENT_SEAMS_H

#include <CGAL/Surface_mesh_foliation/internal/Component_coordinates/Corner_nodes.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// A seam for each component: a path of as few edges as possible from end 0 to end 1. A walk once
// around the component, with end 1 to the left, starts on the right side of the seam and arrives at
// its left side, where the coordinate is larger by the circumference.
class Component_seams
{
public:
  Component_seams(const Corner_nodes& nodes, const std::vector<double>& height)
    : m_nodes(nodes), m_seam(height.size()), m_is_left(nodes.mesh().number_of_halfedges(), false)
  {
    find_seams(height);
    CGAL_assertion(
      std::none_of(m_seam.begin(), m_seam.end(), [](const auto& seam) { return seam.empty(); }));
    for (const std::vector<int>& seam : m_seam)
      mark_left_side(seam);
  }

  // the halfedges of the seam of an arc, from end 0 to end 1
  const std::vector<int>& seam(int arc) const { return m_seam[arc]; }

  // A node of the seam has two places, one on each side. They are numbered node by node.
  int number_of_places() const { return 2 * m_nodes.number_of_nodes(); }
  static int place(int node, bool is_left) { return 2 * node + is_left; }

  // Whether an end of a side of a face lies on the left side of the seam.
  bool is_source_left(int h) const { return m_is_left[h]; }
  bool is_target_left(int h) const
  {
    return m_nodes.is_pole(m_nodes.mesh().target(h)) ? m_seam[m_nodes.arc(h)].back() == h
                                                     : m_is_left[m_nodes.mesh().next(h)];
  }

private:
  // breadth first from end 0, in all components at once
  void find_seams(const std::vector<double>& height)
  {
    constexpr int NONE = Corner_nodes::NONE, ROOT = -2;
    std::vector<int> halfedge_to(m_nodes.number_of_nodes(), NONE), queue;
    for (int h = 0; h < m_nodes.mesh().number_of_halfedges(); ++h)
    {
      const int node = m_nodes.node_of_source(h);
      if (node != NONE && halfedge_to[node] == NONE && m_nodes.starts_at_first_end(h))
      {
        halfedge_to[node] = ROOT;
        queue.push_back(node);
      }
    }
    for (std::size_t i = 0; i < queue.size(); ++i)
      m_nodes.for_each_spoke(queue[i], [&](int h) {
        const int node = m_nodes.node_of_target(h), arc = m_nodes.arc(h);
        if (halfedge_to[node] != NONE || !m_seam[arc].empty())
          return;
        halfedge_to[node] = h;
        queue.push_back(node);
        if (m_nodes.leads_to_last_end(h, height[arc]))
          m_seam[arc] = way_back(h, halfedge_to);
      });
  }

  std::vector<int> way_back(int last, const std::vector<int>& halfedge_to) const
  {
    std::vector<int> result;
    for (int h = last; h >= 0; h = halfedge_to[m_nodes.node_of_source(h)])
      result.push_back(h);
    std::reverse(result.begin(), result.end());
    return result;
  }

  void mark_left_side(const std::vector<int>& seam)
  {
    const Flat_mesh& mesh = m_nodes.mesh();
    for (std::size_t i = 0; i < seam.size(); ++i)
    {
      m_is_left[seam[i]] = true;
      if (m_nodes.is_pole(mesh.source(seam[i])))
        continue; // only the spoke
      // up to the edge by which the seam comes in, or to the boundary
      const int last = i == 0 ? Corner_nodes::NONE : opposite_of(seam[i - 1]);
      for (int h = mesh.rotate(seam[i]); h != last && !m_nodes.is_critical(h); h = mesh.rotate(h))
        m_is_left[h] = true;
    }
    const int end = seam.back();
    if (m_nodes.is_pole(mesh.target(end)))
      return; // see is_target_left()
    int h = mesh.next(end);
    m_is_left[h] = true;
    while (!m_nodes.is_critical(h))
    {
      h = mesh.next(opposite_of(h)); // clockwise
      m_is_left[h] = true;
    }
  }

  const Corner_nodes& m_nodes;
  std::vector<std::vector<int>> m_seam; // by arc
  std::vector<bool> m_is_left;          // by corner; at a pole, by spoke
};

} // namespace internal

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMPONENT_COORDINATES_COMPONENT_SEAMS_H
