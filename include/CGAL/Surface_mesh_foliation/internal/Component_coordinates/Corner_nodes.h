// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMPONENT_COORDINATES_CORNER_NODES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMPONENT_COORDINATES_CORNER_NODES_H

#include <CGAL/Surface_mesh_foliation/internal/Leaves/Leaf_graph.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/Refined_mesh.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The closed components, each cut loose from the others, as surfaces with boundary: their points,
// called nodes here, and what lies where. A vertex inside a component is one node; a vertex on a
// critical leaf is one node per sector between critical edges; and a pole that is one vertex is
// blown up into a circle with a node per spoke.
//
// A corner of a face is identified by the halfedge that leaves it, in the mesh of the leaf graph.
class Corner_nodes
{
public:
  static constexpr int NONE = -1;

  Corner_nodes(const Refined_mesh& refined, const Leaf_graph& graph)
    : m_refined(refined), m_graph(graph), m_node(graph.mesh().number_of_halfedges(), NONE)
  {
    for (int v = 0; v < graph.mesh().number_of_vertices(); ++v)
      number_corners_of(v);
  }

  const Refined_mesh& refined() const { return m_refined; }
  const Flat_mesh& mesh() const { return m_graph.mesh(); }
  bool is_critical(int h) const { return m_graph.is_critical(edge_of(h)); }
  int number_of_nodes() const { return static_cast<int>(m_first_corner.size()); }

  // a pole that is blown up
  bool is_pole(int v) const
  {
    return m_graph.leaf_of_vertex(v) >= 0 && !m_graph.has_critical_edge(v);
  }

  // the component of the face of h; NONE if all of it lies at a node
  int arc(int h) const { return m_refined.faces[mesh().face(h)].arc; }

  // the ends of a side of a face; NONE in faces that lie at a node
  int node_of_source(int h) const { return m_node[h]; }
  int node_of_target(int h) const
  {
    return is_pole(mesh().target(h)) ? m_node[opposite_of(h)] : m_node[mesh().next(h)];
  }

  // the parameter of source(h) in the arc of its face
  double parameter(int h) const
  {
    const std::array<int, 3> halfedges = mesh().halfedges(mesh().face(h));
    const int i = halfedges[0] == h ? 0 : halfedges[1] == h ? 1 : 2;
    return m_refined.faces[mesh().face(h)].t[i];
  }
  double parameter_of_target(int h) const { return parameter(mesh().next(h)); }

  // Whether a side of a face leaves from end 0 of its component, or leads to end 1. (Parameters do
  // not tell: in an arc of the least positive height, those inside it are rounded to its ends.)
  bool starts_at_first_end(int h) const
  {
    return m_refined.node[mesh().source(h)] != Refined_mesh::NONE && parameter(h) == 0;
  }
  bool leads_to_last_end(int h, double height) const
  {
    return m_refined.node[mesh().target(h)] != Refined_mesh::NONE &&
           parameter_of_target(h) == height;
  }

  // calls visit(h) for the halfedges that lead from a node into its component
  template <class Visit>
  void for_each_spoke(int node, const Visit& visit) const
  {
    const int first = m_first_corner[node];
    if (is_pole(mesh().source(first)))
      return visit(first);
    int h = first;
    do
    {
      if (!is_critical(h))
        visit(h);
      h = mesh().rotate(h);
    } while (h != first && !is_critical(h));
  }

private:
  void number_corners_of(int v)
  {
    const Flat_mesh::Ring ring = mesh().ring(v);
    if (is_pole(v))
    {
      for (int h : ring)
        m_node[h] = new_node(h);
      return;
    }
    int first = 0; // where a sector begins
    if (m_graph.has_critical_edge(v))
      while (!is_critical(ring[first]))
        ++first;
    int node = NONE;
    for (int i = 0; i < ring.size(); ++i)
    {
      const int h = ring[(first + i) % ring.size()];
      if (arc(h) == Refined_mesh::NONE)
        continue;
      if (i == 0 || is_critical(h))
        node = new_node(h);
      m_node[h] = node;
    }
  }

  int new_node(int corner)
  {
    m_first_corner.push_back(corner);
    return number_of_nodes() - 1;
  }

  const Refined_mesh& m_refined;
  const Leaf_graph& m_graph;
  std::vector<int> m_node;         // by corner; of a spoke at a pole
  std::vector<int> m_first_corner; // by node; the first one clockwise
};

} // namespace internal

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMPONENT_COORDINATES_CORNER_NODES_H
