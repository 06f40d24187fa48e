// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_HOMOTOPY_DECK_COCYCLE_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_HOMOTOPY_DECK_COCYCLE_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Homotopy/Surface_group.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Pole.h>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The deck group of the universal cover of the surface minus its poles, as a cocycle on the dual
// edges. Every face f has a preferred lift; the face across halfedge h of that lift is
// element(h) times the preferred lift of face(opposite_of(h)). So the product of the elements along
// a closed walk over faces is its deck translation, and the product around a vertex that is not a
// pole is 1.
//
// Construction (tree-cotree): a breadth-first tree of vertices, a tree of faces over the other
// edges, whose elements are 1; the edges in neither tree, and one tree edge per pole beyond the
// first, carry the free generators; the relations of the other vertices, leaves first, determine
// the rest. The relation of the root is void at a pole; otherwise it is the relator of the closed
// surface.
//
// Elements are interned: 0 is the identity, and few edges have any other element. Letters, words
// and frames: see the glossary in ARCHITECTURE.md.
class Deck_cocycle
{
public:
  Deck_cocycle(const Flat_mesh& mesh, const std::vector<Pole>& poles)
    : m_mesh(mesh), m_element_of_edge(mesh.number_of_edges(), 0)
  {
    intern({});
    mark_poles(poles);
    const std::vector<int> order = build_vertex_tree(poles);
    build_face_tree();
    Group_word relator = assign_elements(order);
    m_group = poles.empty() ? Surface_group(m_rank, relator) : Surface_group(m_rank);
    compute_transports();
    m_kind = {};
    m_parent = {};
    m_pole_of_vertex = {};
  }

  // The cocycle that another one induces on a coarser mesh of the same surface, with the same
  // group: `elements` are those met when the forward halfedges of `mesh` are crossed.
  Deck_cocycle(const Flat_mesh& mesh,
               const std::vector<Pole>& poles,
               const Surface_group& group,
               const std::vector<Group_word>& elements)
    : m_mesh(mesh), m_group(group)
  {
    intern({});
    m_element_of_edge.reserve(mesh.number_of_edges());
    for (const Group_word& element : elements)
      m_element_of_edge.push_back(intern(element));
    mark_poles(poles);
    compute_transports();
    m_kind = {};
    m_pole_of_vertex = {};
  }

  // the same on a copy of the mesh
  Deck_cocycle(const Flat_mesh& mesh, const Deck_cocycle& other) : Deck_cocycle(mesh)
  {
    m_group = other.m_group;
    m_element_of_edge = other.m_element_of_edge;
    m_transport = other.m_transport;
    m_words = other.m_words;
    m_index = other.m_index;
  }

  // Moves a pole that is a single vertex along a path of halfedges, which meets no other pole: the
  // product around the vertex at the beginning becomes 1, and that around the vertex at the end no
  // longer is. Nothing else changes, so that what lies elsewhere keeps its name. `translations`
  // are, by halfedge of the path, the deck translations of a loop around the pole that begins in
  // the face to the right of the halfedge.
  void push_pole(const std::vector<int>& path, const std::vector<Group_word>& translations)
  {
    const bool is_counterclockwise = translations[0] == translation_around(path[0]);
    for (std::size_t i = 0; i < path.size(); ++i)
    {
      const int h = opposite_of(path[i]);
      set_element(h,
                  m_group.product(is_counterclockwise ? inverse(translations[i]) : translations[i],
                                  element(h)));
    }
    for (int h : path)
      compute_transports_around(m_mesh.source(h));
    for (int h : m_mesh.ring(m_mesh.target(path.back())))
      m_transport[h] = 0;
  }

  const Surface_group& group() const { return m_group; }

  // the element met when halfedge h is crossed from face(h)
  Group_word element(int h) const
  {
    const Group_word& word = m_words[m_element_of_edge[edge_of(h)]];
    return is_forward(h) ? word : inverse(word);
  }

  bool is_identity(int h) const { return m_element_of_edge[edge_of(h)] == 0; }

  // The frame of an edge is that of the face of its forward halfedge; the frame of a vertex that is
  // not a pole is that of one of its faces. Returns the interned element of the way from the frame
  // of source(h) to that of its edge.
  int transport(int h) const { return m_transport[h]; }

  const Group_word& word(int element) const { return m_words[element]; }

private:
  explicit Deck_cocycle(const Flat_mesh& mesh) : m_mesh(mesh) {}

  enum Edge_kind : char { FREE, VERTEX_TREE, FACE_TREE, POLE_TREE };

  int intern(const Group_word& word)
  {
    const auto [it, is_new] = m_index.emplace(word, static_cast<int>(m_words.size()));
    if (is_new)
      m_words.push_back(word);
    return it->second;
  }

  void mark_poles(const std::vector<Pole>& poles)
  {
    m_pole_of_vertex.assign(m_mesh.number_of_vertices(), -1);
    m_kind.assign(m_mesh.number_of_edges(), FREE);
    for (std::size_t p = 0; p < poles.size(); ++p)
      for (std::size_t i = 0; i < poles[p].size(); ++i)
      {
        m_pole_of_vertex[poles[p][i]] = static_cast<int>(p);
        if (i > 0)
          m_kind[edge_of(m_mesh.find_halfedge(poles[p][i], poles[p].parent(i)))] = POLE_TREE;
      }
  }

  // Breadth first from the first pole (or vertex 0); the tree of a pole is entered all at once, so
  // that all its edges are in the tree. `m_parent[v]` is the halfedge from v to its parent.
  std::vector<int> build_vertex_tree(const std::vector<Pole>& poles)
  {
    m_parent.assign(m_mesh.number_of_vertices(), -1);
    std::vector<bool> is_reached(m_mesh.number_of_vertices(), false);
    std::vector<int> order;
    const int root = poles.empty() ? 0 : poles[0][0];
    is_reached[root] = true;
    order.push_back(root);
    reach_pole(root, is_reached, order);
    for (std::size_t i = 0; i < order.size(); ++i)
      for (int h : m_mesh.ring(order[i]))
      {
        const int v = m_mesh.target(h);
        if (is_reached[v])
          continue;
        is_reached[v] = true;
        m_parent[v] = opposite_of(h);
        m_kind[edge_of(h)] = VERTEX_TREE;
        order.push_back(v);
        reach_pole(v, is_reached, order);
      }
    return order;
  }

  // reaches the vertices of the pole that v lies on
  void reach_pole(int v, std::vector<bool>& is_reached, std::vector<int>& order)
  {
    if (m_pole_of_vertex[v] < 0)
      return;
    for (std::size_t i = order.size() - 1; i < order.size(); ++i)
      for (int h : m_mesh.ring(order[i]))
        if (m_kind[edge_of(h)] == POLE_TREE && !is_reached[m_mesh.target(h)])
        {
          is_reached[m_mesh.target(h)] = true;
          m_parent[m_mesh.target(h)] = opposite_of(h);
          order.push_back(m_mesh.target(h));
        }
  }

  void build_face_tree()
  {
    std::vector<bool> is_reached(m_mesh.number_of_faces(), false);
    std::vector<int> queue = {0};
    is_reached[0] = true;
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (int h : m_mesh.halfedges(queue[i]))
      {
        const int f = m_mesh.face(opposite_of(h));
        if (m_kind[edge_of(h)] != FREE || is_reached[f])
          continue;
        is_reached[f] = true;
        m_kind[edge_of(h)] = FACE_TREE;
        queue.push_back(f);
      }
  }

  void set_element(int h, const Group_word& word)
  {
    m_element_of_edge[edge_of(h)] = intern(is_forward(h) ? word : inverse(word));
  }

  // the product over the spokes after `first`, counterclockwise around its source, up to `last`
  Group_word product_around(int first, int last) const
  {
    Group_word result;
    for (int h = m_mesh.rotate(first); h != last; h = m_mesh.rotate(h))
      if (!is_identity(h))
        multiply(result, element(opposite_of(h)));
    return result;
  }

  // the deck translation of the walk around source(h), counterclockwise, from the face to the right
  // of h
  Group_word translation_around(int h) const
  {
    return m_group.product(element(opposite_of(h)), product_around(h, h));
  }

  // gives every edge its element and returns the relation of the root
  Group_word assign_elements(const std::vector<int>& order)
  {
    for (int e = 0; e < m_mesh.number_of_edges(); ++e)
      if (m_kind[e] == FREE)
        set_element(halfedge_of(e), {++m_rank});
    for (std::size_t i = order.size() - 1; i > 0; --i)
    {
      const int v = order[i], parent = m_parent[v];
      if (m_kind[edge_of(parent)] == POLE_TREE)
        continue;
      if (m_pole_of_vertex[v] >= 0)
        set_element(parent, {++m_rank});
      else
        set_element(opposite_of(parent), inverse(product_around(parent, parent)));
    }
    const int h = m_mesh.ring(order[0])[0];
    Group_word relator = element(opposite_of(h));
    multiply(relator, product_around(h, h));
    return relator;
  }

  void compute_transports()
  {
    m_transport.assign(m_mesh.number_of_halfedges(), 0);
    for (int v = 0; v < m_mesh.number_of_vertices(); ++v)
      if (m_pole_of_vertex[v] < 0)
        compute_transports_around(v);
  }

  void compute_transports_around(int v)
  {
    Group_word way; // from the frame of v to face(h)
    for (int h : m_mesh.ring(v))
    {
      if (h != m_mesh.ring(v)[0] && !is_identity(h))
        way = m_group.product(way, element(opposite_of(h)));
      if (is_forward(h))
        m_transport[h] = way.empty() ? 0 : intern(way);
      else if (!way.empty() || !is_identity(h))
        m_transport[h] = intern(m_group.product(way, element(h)));
      else
        m_transport[h] = 0;
    }
  }

  const Flat_mesh& m_mesh;
  Surface_group m_group;
  int m_rank = 0;
  std::vector<int> m_element_of_edge; // met when the forward halfedge is crossed
  std::vector<int> m_transport;       // by halfedge
  std::vector<Group_word> m_words;    // by interned element
  std::map<Group_word, int> m_index;
  std::vector<int> m_pole_of_vertex; // -1: no pole
  std::vector<Edge_kind> m_kind;
  std::vector<int> m_parent;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_HOMOTOPY_DECK_COCYCLE_H
