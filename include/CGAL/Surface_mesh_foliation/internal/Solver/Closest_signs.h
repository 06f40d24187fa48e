// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_CLOSEST_SIGNS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_CLOSEST_SIGNS_H

#include <CGAL/Surface_mesh_foliation/internal/Common/Disjoint_sets.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Signs of the vertices that bring one matrix close to another one with a row per vertex: given for
// each edge whether the two entries have the same sign (1), opposite signs (-1) or one of them is 0
// (0), finds s_v = +-1 such that s_u s_v is what is given on nearly all edges between u and v.
//
// Where the product of what is given around a face is negative, no signs fit: the face is odd. (So
// are faces as one between which lie edges with 0.) The matrix of a foliation is that of a double
// cover, branched at singularities of odd index, so the odd faces are those where one of two
// foliations has such a singularity, and mostly come in pairs close together. Whatever the signs,
// the edges that do not fit are crossed by paths from face to face that join the odd ones. Here the
// paths run along a minimum spanning tree of the odd faces, so they are short, though not always
// the shortest. On a surface with handles some closed curves may be added, along which the
// breadth-first tree of the vertices meets itself.
class Closest_signs
{
public:
  // agreement: by edge
  Closest_signs(const Flat_mesh& mesh, std::vector<signed char> agreement)
    : m_mesh(mesh), m_agreement(std::move(agreement))
  {
    find_odd_regions();
    grow_from_odd_regions();
    turn_edges_on_paths();
    spread_signs();
  }

  // by vertex
  const std::vector<signed char>& signs() const { return m_signs; }

private:
  static constexpr int NONE = -1;

  struct Meeting
  {
    int length, edge;
    bool operator<(const Meeting& other) const
    {
      return length != other.length ? length < other.length : edge < other.edge;
    }
  };

  struct Tree_edge
  {
    int region, edge;
  };

  // Numbers the odd regions, and starts from their faces.
  void find_odd_regions()
  {
    const int n = m_mesh.number_of_faces();
    Disjoint_sets regions(n);
    for (int e = 0; e < m_mesh.number_of_edges(); ++e)
      if (m_agreement[e] == 0)
        regions.union_set(m_mesh.face(halfedge_of(e)), m_mesh.face(opposite_of(halfedge_of(e))));
    std::vector<bool> is_odd(n, false); // by face that represents a region
    for (int e = 0; e < m_mesh.number_of_edges(); ++e)
      if (m_agreement[e] < 0)
        for (const int h : halfedges_of_edge(e))
        {
          const std::size_t region = regions.find_set(m_mesh.face(h));
          is_odd[region] = !is_odd[region];
        }
    std::vector<int> number(n, NONE);
    for (int f = 0; f < n; ++f)
      if (is_odd[f])
        number[f] = m_number_of_regions++;
    m_origin.resize(n);
    for (int f = 0; f < n; ++f)
      m_origin[f] = number[regions.find_set(f)];
  }

  // Breadth first over faces, from all odd regions at once, up to where they meet.
  void grow_from_odd_regions()
  {
    const int n = m_mesh.number_of_faces();
    m_entry.assign(n, NONE);
    std::vector<int> queue, distance(n, 0);
    for (int f = 0; f < n; ++f)
      if (m_origin[f] != NONE)
        queue.push_back(f);
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (const int h : m_mesh.halfedges(queue[i]))
      {
        const int f = m_mesh.face(opposite_of(h));
        if (m_origin[f] == NONE)
        {
          m_origin[f] = m_origin[queue[i]];
          m_entry[f] = h;
          distance[f] = distance[queue[i]] + 1;
          queue.push_back(f);
        }
        else if (m_origin[f] != m_origin[queue[i]] && is_forward(h))
          m_meetings.push_back({distance[f] + distance[queue[i]], edge_of(h)});
      }
    std::sort(m_meetings.begin(), m_meetings.end());
  }

  // the minimum spanning tree, by region: its neighbors and the edges where they meet
  std::vector<std::vector<Tree_edge>> spanning_tree() const
  {
    std::vector<std::vector<Tree_edge>> result(m_number_of_regions);
    Disjoint_sets joined(m_number_of_regions);
    for (const Meeting& meeting : m_meetings)
    {
      const int h = halfedge_of(meeting.edge);
      const int a = m_origin[m_mesh.face(h)], b = m_origin[m_mesh.face(opposite_of(h))];
      if (joined.find_set(a) == joined.find_set(b))
        continue;
      joined.union_set(a, b);
      result[a].push_back({b, meeting.edge});
      result[b].push_back({a, meeting.edge});
    }
    return result;
  }

  // Of the spanning tree, those edges that have an odd number of odd regions on each side are
  // paths.
  void turn_edges_on_paths()
  {
    if (m_number_of_regions == 0)
      return;
    const std::vector<std::vector<Tree_edge>> tree = spanning_tree();
    std::vector<Tree_edge> order = {{0, NONE}}; // from the root, with the edge to the parent
    std::vector<std::size_t> parent = {0};
    std::vector<bool> is_visited(m_number_of_regions, false);
    is_visited[0] = true;
    for (std::size_t i = 0; i < order.size(); ++i)
      for (const Tree_edge& next : tree[order[i].region])
        if (!is_visited[next.region])
        {
          is_visited[next.region] = true;
          order.push_back(next);
          parent.push_back(i);
        }
    std::vector<bool> is_odd(order.size(), true); // by subtree: its number of regions
    for (std::size_t i = order.size() - 1; i > 0; --i)
      if (is_odd[i])
      {
        turn_path(order[i].edge);
        is_odd[parent[i]] = !is_odd[parent[i]];
      }
  }

  // from the origin on one side of an edge to that on the other
  void turn_path(int edge)
  {
    turn(edge);
    for (const int h : halfedges_of_edge(edge))
      for (int f = m_mesh.face(h); m_entry[f] != NONE; f = m_mesh.face(m_entry[f]))
        turn(edge_of(m_entry[f]));
  }

  void turn(int edge) { m_agreement[edge] = static_cast<signed char>(-m_agreement[edge]); }

  void spread_signs()
  {
    m_signs.assign(m_mesh.number_of_vertices(), 0);
    std::vector<int> queue;
    for (int root = 0; root < m_mesh.number_of_vertices(); ++root)
    {
      if (m_signs[root] != 0)
        continue;
      m_signs[root] = 1;
      queue.assign(1, root);
      for (std::size_t i = 0; i < queue.size(); ++i)
        for (const int h : m_mesh.ring(queue[i]))
        {
          const int v = m_mesh.target(h);
          if (m_signs[v] != 0 || m_agreement[edge_of(h)] == 0)
            continue;
          m_signs[v] = static_cast<signed char>(m_signs[queue[i]] * m_agreement[edge_of(h)]);
          queue.push_back(v);
        }
    }
  }

  const Flat_mesh& m_mesh;
  std::vector<signed char> m_agreement; // by edge, turned on the paths
  int m_number_of_regions = 0;          // that are odd
  std::vector<int> m_origin;            // by face: the odd region that reached it first
  std::vector<int> m_entry;             // by face: the halfedge over which it was reached
  std::vector<Meeting> m_meetings;      // of two odd regions, shortest first
  std::vector<signed char> m_signs;     // by vertex
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_CLOSEST_SIGNS_H
