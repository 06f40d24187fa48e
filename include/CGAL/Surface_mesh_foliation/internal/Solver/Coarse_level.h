// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_COARSE_LEVEL_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_COARSE_LEVEL_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Edge_collapses.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Mesh_clusters.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/weights_of_flat_mesh.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// A loop system and its foliation on a coarser mesh of the same surface: its vertices are clusters
// of vertices, each formed by half-edge collapses. Poles and the vertices beside loops are kept, so
// that loops keep their crossings.
//
// A coarse edge stands for a chain of fine ones (Mesh_clusters). Its group element is the product
// along its chain, and foliations are carried from coarse to fine exactly.
class Coarse_level
{
public:
  // Merges vertices until `goal` are left. Precondition: the leaves of `fine` lie in its loops.
  Coarse_level(const Foliation_state& fine, int goal)
    : m_fine(fine), m_cluster(fine.mesh(), Edge_collapses(fine.mesh(), vertices_to_keep(), goal))
  {
    build_system();
    build_chains();
    build_state(clamped_weights(m_system.mesh));
  }

  // Merges as many as possible of the vertices that are tied to each other (`tied` gives, by
  // vertex, the number of its cluster). The weight of a coarse edge is the sum over its chain, so
  // the energy is that of the fine mesh if tied vertices move as one.
  Coarse_level(const Foliation_state& fine, const std::vector<int>& tied)
    : m_fine(fine), m_cluster(fine.mesh(), Edge_collapses(fine.mesh(), vertices_to_keep(), tied))
  {
    build_system();
    build_chains();
    build_state(summed_weights());
  }

  Coarse_level(const Coarse_level&) = delete;
  Coarse_level& operator=(const Coarse_level&) = delete;

  Foliation_state& state() { return *m_state; }

  // The same map on the fine mesh: every vertex lies where its cluster does.
  Tree_map prolonged() const
  {
    const Flat_mesh& fine = m_fine.mesh();
    const Tree_map& coarse = m_state->map();
    Tree_map result;
    result.paths = Tree_paths(fine.number_of_edges());
    for (int e = 0; e < fine.number_of_edges(); ++e)
      if (m_halfedge[e] >= 0)
        for (int i = 0; i < m_state->word_size(edge_of(m_halfedge[e])); ++i)
        {
          const Letter letter = m_state->letter(m_halfedge[e], i);
          result.paths.push_back(e, Letter(fine_lift(letter.lift(), m_way[e]), letter.end()));
        }
    for (int v = 0; v < fine.number_of_vertices(); ++v)
    {
      result.t.push_back(coarse.t[m_cluster[v]]);
      result.orientation.push_back(coarse.orientation[m_cluster[v]]);
    }
    prolong_cells(result.cell);
    return result;
  }

private:
  static constexpr int NONE = Mesh_clusters::NONE;

  // poles, and the ends of the edges that loops cross
  std::vector<bool> vertices_to_keep() const
  {
    const Flat_mesh& fine = m_fine.mesh();
    std::vector<bool> result(fine.number_of_vertices(), false);
    for (const Pole& pole : m_fine.system().poles)
      for (int v : pole)
        result[v] = true;
    for (const Flat_loop& loop : m_fine.system().loops)
      for (const Flat_crossing& crossing : loop.crossings)
        result[fine.source(crossing.halfedge)] = result[fine.target(crossing.halfedge)] = true;
    return result;
  }

  void build_system()
  {
    const Flat_loop_system& fine = m_fine.system();
    m_system.mesh = m_cluster.mesh();
    for (int v = 0; v < m_system.mesh.number_of_vertices(); ++v)
      m_system.node_of_vertex.push_back(fine.node_of_vertex[m_cluster.representative(v)]);
    m_system.poles = fine.poles;
    for (Pole& pole : m_system.poles)
      for (int& v : pole)
        v = m_cluster[v];
    m_system.loops = fine.loops;
    for (Flat_loop& loop : m_system.loops)
      for (Flat_crossing& crossing : loop.crossings)
        crossing.halfedge = m_cluster.coarse_halfedge(crossing.halfedge);
    m_system.crossings = Edge_crossings(m_system.mesh, m_system.loops);
    m_system.nodes = fine.nodes;
    m_system.nodes_of_arc = fine.nodes_of_arc;
    m_system.merged_loops = fine.merged_loops;
  }

  // walks along the chain of every coarse edge
  void build_chains()
  {
    const Flat_mesh &fine = m_fine.mesh(), &coarse = m_system.mesh;
    m_halfedge.assign(fine.number_of_edges(), NONE);
    m_way.assign(fine.number_of_edges(), 0);
    m_ways = {Group_word()};
    std::map<Group_word, int> index = {{Group_word(), 0}};
    for (int e = 0; e < coarse.number_of_edges(); ++e)
    {
      Group_word way; // from the frame of the coarse edge to the face of h
      m_cluster.for_each_in_chain(halfedge_of(e), [&](int h) {
        const Group_word next = product(way, h);
        const Group_word& to_frame = is_forward(h) ? way : next;
        const auto [it, is_new] = index.emplace(to_frame, static_cast<int>(m_ways.size()));
        if (is_new)
          m_ways.push_back(to_frame);
        m_way[edge_of(h)] = it->second;
        m_halfedge[edge_of(h)] = is_forward(h) ? halfedge_of(e) : opposite_of(halfedge_of(e));
        way = next;
      });
      m_elements.push_back(way);
    }
  }

  Group_word product(const Group_word& way, int h) const
  {
    return m_fine.deck().is_identity(h)
             ? way
             : m_fine.deck().group().product(way, m_fine.deck().element(h));
  }

  void build_state(std::vector<double> weights)
  {
    m_state.emplace(m_system, std::move(weights),
                    Deck_cocycle(m_system.mesh, m_system.poles, m_fine.deck().group(), m_elements));
    m_state->set_executor(m_fine.executor());
  }

  std::vector<double> summed_weights() const
  {
    std::vector<double> result(m_system.mesh.number_of_edges(), 0);
    for (int e = 0; e < m_fine.mesh().number_of_edges(); ++e)
      if (m_halfedge[e] != NONE)
        result[edge_of(m_halfedge[e])] += m_fine.weight(e);
    return result;
  }

  // Mean value weights, whatever those of the fine mesh are, since the result is only a starting
  // point. Collapses leave faces that are nearly degenerate, with weights that no factorization can
  // handle.
  static std::vector<double> clamped_weights(const Flat_mesh& mesh)
  {
    std::vector<double> result = mean_value_weights(mesh), sorted;
    for (double weight : result)
      if (weight > 0)
        sorted.push_back(weight);
    if (sorted.empty())
      return std::vector<double>(result.size(), 1);
    const auto middle = sorted.begin() + sorted.size() / 2;
    std::nth_element(sorted.begin(), middle, sorted.end());
    for (double& weight : result)
      weight = weight > 0 ? std::clamp(weight, 0.05 * *middle, 20 * *middle) : *middle;
    return result;
  }

  // the lift at the end of way number `way` that starts in a coarse frame
  int fine_lift(int lift, int way) const
  {
    const auto [it, is_new] = m_fine_lifts.emplace(std::make_pair(lift, way), NONE);
    if (is_new)
      it->second =
        m_fine.lift(m_state->lifts().arc(lift),
                    m_fine.lifts().transported(m_state->lifts().name(lift), m_ways[way]));
    return it->second;
  }

  // Cells are lifts in the frames of vertices. They are carried across an edge that is in a chain
  // and, inside clusters, from vertex to vertex.
  void prolong_cells(std::vector<Cell>& cell) const
  {
    const Flat_mesh& fine = m_fine.mesh();
    std::vector<bool> is_known(fine.number_of_vertices(), false);
    std::vector<int> queue;
    cell = std::vector<Cell>(fine.number_of_vertices(), Cell::at_node(0)); // until known
    for (int v = 0; v < fine.number_of_vertices(); ++v)
    {
      const Cell coarse_cell = m_state->map().cell[m_cluster[v]];
      const int h = halfedge_in_chain(v);
      if (coarse_cell.is_node())
        cell[v] = coarse_cell;
      else if (h != NONE)
        cell[v] = Cell::arc(m_fine.lift_in_vertex_frame(
          h, fine_lift(m_state->lift_in_edge_frame(coarse_halfedge(h), coarse_cell.lift()),
                       m_way[edge_of(h)])));
      else
        continue;
      is_known[v] = true;
      queue.push_back(v);
    }
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (int h : fine.ring(queue[i]))
      {
        const int v = fine.target(h);
        if (is_known[v] || m_halfedge[edge_of(h)] != NONE)
          continue;
        const int lift = m_fine.lift_in_edge_frame(h, cell[queue[i]].lift());
        cell[v] = Cell::arc(m_fine.lift_in_vertex_frame(opposite_of(h), lift));
        is_known[v] = true;
        queue.push_back(v);
      }
  }

  int coarse_halfedge(int h) const
  {
    const int coarse = m_halfedge[edge_of(h)];
    return is_forward(h) ? coarse : opposite_of(coarse);
  }

  int halfedge_in_chain(int v) const
  {
    for (int h : m_fine.mesh().ring(v))
      if (m_halfedge[edge_of(h)] != NONE)
        return h;
    return NONE;
  }

  const Foliation_state& m_fine;
  Flat_loop_system m_system;
  const Mesh_clusters m_cluster;      // by fine vertex
  std::vector<int> m_halfedge;        // by fine edge: the coarse halfedge along it, or NONE
  std::vector<int> m_way;             // by fine edge: from the frame of its coarse edge to its own
  std::vector<Group_word> m_ways;     // by number of the way
  std::vector<Group_word> m_elements; // by coarse edge
  mutable std::map<std::pair<int, int>, int> m_fine_lifts; // by lift and way
  std::optional<Foliation_state> m_state;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_COARSE_LEVEL_H
