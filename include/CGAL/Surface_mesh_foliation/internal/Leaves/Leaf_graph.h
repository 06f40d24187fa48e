// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_LEAF_GRAPH_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_LEAF_GRAPH_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/Refined_mesh.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The graph of critical leaves and the components between them [5.3], from the connectivity of the
// refined mesh and its critical edges alone: labels of arcs or nodes are not used.
class Leaf_graph
{
public:
  struct Component
  {
    int first_face = -1;
    int euler_characteristic = 0; // of the open component
    std::vector<int> ends;        // the critical leaf at each end
  };

  explicit Leaf_graph(const Refined_mesh& refined)
    : m_mesh(refined.points, triangles(refined)), m_is_critical(m_mesh.number_of_edges(), false)
  {
    for (int f = 0; f < m_mesh.number_of_faces(); ++f)
      for (int i : {0, 1, 2})
        if (refined.faces[f].is_critical[i])
          m_is_critical[edge_of(m_mesh.halfedges(f)[i])] = true;
    find_leaves(refined);
    find_components();
    find_ends();
    count_cells();
  }

  const Flat_mesh& mesh() const { return m_mesh; }
  bool is_critical(int e) const { return m_is_critical[e]; }

  bool has_critical_edge(int v) const
  {
    for (int h : m_mesh.ring(v))
      if (m_is_critical[edge_of(h)])
        return true;
    return false;
  }

  int number_of_leaves() const { return m_number_of_leaves; }
  int leaf_of_vertex(int v) const { return m_leaf_of_vertex[v]; } // -1: none

  const std::vector<Component>& components() const { return m_components; }
  int component_of_face(int f) const { return m_component_of_face[f]; } // -1: a part of a leaf

private:
  static std::vector<Triangle> triangles(const Refined_mesh& refined)
  {
    std::vector<Triangle> result;
    result.reserve(refined.faces.size());
    for (const Refined_mesh::Face& face : refined.faces)
      result.push_back(face.vertices);
    return result;
  }

  // A leaf is a class of vertices joined by critical edges. A vertex at a node without critical
  // edges is a leaf of its own: a pole.
  void find_leaves(const Refined_mesh& refined)
  {
    m_leaf_of_vertex.assign(m_mesh.number_of_vertices(), -1);
    for (int first = 0; first < m_mesh.number_of_vertices(); ++first)
    {
      if (refined.node[first] == Refined_mesh::NONE || m_leaf_of_vertex[first] >= 0)
        continue;
      std::vector<int> stack = {first};
      m_leaf_of_vertex[first] = m_number_of_leaves;
      while (!stack.empty())
      {
        const int v = stack.back();
        stack.pop_back();
        for (int h : m_mesh.ring(v))
          if (m_is_critical[edge_of(h)] && m_leaf_of_vertex[m_mesh.target(h)] < 0)
          {
            m_leaf_of_vertex[m_mesh.target(h)] = m_number_of_leaves;
            stack.push_back(m_mesh.target(h));
          }
      }
      ++m_number_of_leaves;
    }
  }

  bool is_part_of_leaf(int f) const
  {
    const std::array<int, 3> sides = m_mesh.halfedges(f);
    return m_is_critical[edge_of(sides[0])] && m_is_critical[edge_of(sides[1])] &&
           m_is_critical[edge_of(sides[2])];
  }

  void find_components()
  {
    m_component_of_face.assign(m_mesh.number_of_faces(), -1);
    for (int first = 0; first < m_mesh.number_of_faces(); ++first)
    {
      if (m_component_of_face[first] >= 0 || is_part_of_leaf(first))
        continue;
      const int component = static_cast<int>(m_components.size());
      m_components.emplace_back();
      m_components.back().first_face = first;
      m_component_of_face[first] = component;
      std::vector<int> stack = {first};
      while (!stack.empty())
      {
        const int f = stack.back();
        stack.pop_back();
        for (int h : m_mesh.halfedges(f))
        {
          const int g = m_mesh.face(opposite_of(h));
          if (!m_is_critical[edge_of(h)] && m_component_of_face[g] < 0)
          {
            m_component_of_face[g] = component;
            stack.push_back(g);
          }
        }
      }
    }
  }

  // An end of a component is a closed walk along critical edges with the component on its left, or
  // a vertex that is a leaf of its own.
  void find_ends()
  {
    std::vector<bool> is_walked(m_mesh.number_of_halfedges(), false);
    for (int first = 0; first < m_mesh.number_of_halfedges(); ++first)
    {
      const int component = m_component_of_face[m_mesh.face(first)];
      if (!m_is_critical[edge_of(first)] || is_walked[first] || component < 0)
        continue;
      m_components[component].ends.push_back(m_leaf_of_vertex[m_mesh.source(first)]);
      for (int h = first; !is_walked[h]; h = next_along_leaf(h))
        is_walked[h] = true;
    }
    for (int v = 0; v < m_mesh.number_of_vertices(); ++v)
      if (m_leaf_of_vertex[v] >= 0 && !has_critical_edge(v))
      {
        const int component = m_component_of_face[m_mesh.face(m_mesh.ring(v)[0])];
        m_components[component].ends.push_back(m_leaf_of_vertex[v]);
      }
  }

  int next_along_leaf(int h) const
  {
    int next = m_mesh.next(h);
    while (!m_is_critical[edge_of(next)])
      next = m_mesh.next(opposite_of(next));
    return next;
  }

  // cells that do not belong to a critical leaf lie in one component each
  void count_cells()
  {
    for (int f = 0; f < m_mesh.number_of_faces(); ++f)
      if (m_component_of_face[f] >= 0)
        ++m_components[m_component_of_face[f]].euler_characteristic;
    for (int e = 0; e < m_mesh.number_of_edges(); ++e)
      if (!m_is_critical[e])
        --m_components[m_component_of_face[m_mesh.face(halfedge_of(e))]].euler_characteristic;
    for (int v = 0; v < m_mesh.number_of_vertices(); ++v)
      if (m_leaf_of_vertex[v] < 0)
        ++m_components[m_component_of_face[m_mesh.face(m_mesh.ring(v)[0])]].euler_characteristic;
  }

  Flat_mesh m_mesh;
  std::vector<bool> m_is_critical; // by edge
  std::vector<int> m_leaf_of_vertex;
  std::vector<int> m_component_of_face;
  std::vector<Component> m_components;
  int m_number_of_leaves = 0;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_LEAF_GRAPH_H
