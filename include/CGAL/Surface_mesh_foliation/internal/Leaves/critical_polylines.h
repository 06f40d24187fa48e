// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_CRITICAL_POLYLINES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_CRITICAL_POLYLINES_H

#include <CGAL/Surface_mesh_foliation/internal/Leaves/Leaf_graph.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/Refined_mesh.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The critical edges as chains of vertices between those where more or fewer than two of them meet;
// cycles repeat their first vertex; vertices without critical edges are chains of one vertex. Edges
// of caps are left out.
class Critical_chains
{
public:
  Critical_chains(const Refined_mesh& refined, const Leaf_graph& graph)
    : m_refined(refined), m_graph(graph), m_is_used(graph.mesh().number_of_edges(), false)
  {
    const int n = graph.mesh().number_of_vertices();
    for (int v = 0; v < n; ++v)
      if (is_on_leaf(v) && number_of_strands(v) != 2)
        start_at(v);
    for (int v = 0; v < n; ++v)
      if (is_on_leaf(v) && number_of_strands(v) == 2)
        start_at(v);
  }

  std::vector<std::vector<int>>&& result() && { return std::move(m_result); }

private:
  bool is_on_leaf(int v) const
  {
    return m_graph.leaf_of_vertex(v) >= 0 && !m_refined.is_cap_vertex(v);
  }

  bool is_strand(int h) const
  {
    const Flat_mesh& mesh = m_graph.mesh();
    return m_graph.is_critical(edge_of(h)) &&
           (mesh.face(h) < m_refined.first_cap_face ||
            mesh.face(opposite_of(h)) < m_refined.first_cap_face);
  }

  int number_of_strands(int v) const
  {
    int result = 0;
    for (int h : m_graph.mesh().ring(v))
      result += is_strand(h);
    return result;
  }

  void start_at(int v)
  {
    if (number_of_strands(v) == 0)
      m_result.push_back({v});
    for (int h = unused_strand(v); h >= 0; h = unused_strand(v))
      follow(h);
  }

  int unused_strand(int v) const
  {
    for (int h : m_graph.mesh().ring(v))
      if (is_strand(h) && !m_is_used[edge_of(h)])
        return h;
    return -1;
  }

  void follow(int h)
  {
    const int first = m_graph.mesh().source(h);
    std::vector<int> chain = {first};
    while (h >= 0)
    {
      m_is_used[edge_of(h)] = true;
      const int v = m_graph.mesh().target(h);
      chain.push_back(v);
      h = v != first && number_of_strands(v) == 2 ? unused_strand(v) : -1;
    }
    m_result.push_back(std::move(chain));
  }

  const Refined_mesh& m_refined;
  const Leaf_graph& m_graph;
  std::vector<bool> m_is_used; // by edge
  std::vector<std::vector<int>> m_result;
};

inline std::vector<std::vector<int>> critical_polylines(const Refined_mesh& refined,
                                                        const Leaf_graph& graph)
{
  return Critical_chains(refined, graph).result();
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_CRITICAL_POLYLINES_H
