// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_COMPONENT_GRAPH_H
#define SMF_TEST_COMPONENT_GRAPH_H

#include "generators/meshes.h"

#include <CGAL/Surface_mesh_foliation/components.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/pending/disjoint_sets.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

// What `surface_components()` outputs, and the graph of its components, which is made from nothing
// but that: no node or arc of the loop system is looked at. And what must hold for both.

namespace smf_test {

// the mesh cut along the critical leaves
struct Cut_mesh
{
  explicit Cut_mesh(const CGAL::Surface_mesh_foliation::Measured_foliation<Mesh>& foliation)
    : component(mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component", 9999).first),
      is_critical(mesh.add_property_map<Mesh::Edge_index, bool>("e:critical", false).first)
  {
    number_of_components = CGAL::Surface_mesh_foliation::surface_components(
      foliation, mesh,
      CGAL::Surface_mesh_foliation::parameters::face_component_map(component)
        .edge_is_constrained_map(is_critical));
    const auto& system = foliation.system();
    std::map<Mesh::Vertex_index, Mesh::Vertex_index> copy; // the first vertices are the input's
    auto v = vertices(mesh).begin();
    for (const auto u : vertices(foliation.mesh()))
      copy[u] = *v++;
    for (std::size_t p = 0; p < system.number_of_poles(); ++p)
      for (const auto u : system.pole_vertices(p))
        pole[copy[u]] = static_cast<int>(p);
  }

  // whether the foliation has no leaf in a face
  bool is_at_node(Mesh::Face_index f) const
  {
    const auto around = CGAL::halfedges_around_face(halfedge(f, mesh), mesh);
    return std::all_of(around.begin(), around.end(),
                       [&](auto h) { return is_critical[edge(h, mesh)]; });
  }

  bool is_on_critical_edge(Mesh::Vertex_index v) const
  {
    const auto around = CGAL::halfedges_around_target(v, mesh);
    return std::any_of(around.begin(), around.end(),
                       [&](auto h) { return is_critical[edge(h, mesh)]; });
  }

  // a pole alone is a critical leaf, too
  bool is_on_critical_leaf(Mesh::Vertex_index v) const
  {
    return pole.count(v) != 0 || is_on_critical_edge(v);
  }

  Mesh mesh;
  Mesh::Property_map<Mesh::Face_index, std::size_t> component;
  Mesh::Property_map<Mesh::Edge_index, bool> is_critical;
  std::map<Mesh::Vertex_index, int> pole;
  std::size_t number_of_components;
};

// by node the arcs that end there, a self-loop twice; sorted, so that equal ones are of graphs that
// differ by the names of their nodes only
using Incidences = std::vector<std::vector<std::size_t>>;

inline Incidences sorted(Incidences incidences)
{
  for (std::vector<std::size_t>& arcs : incidences)
    std::sort(arcs.begin(), arcs.end());
  std::sort(incidences.begin(), incidences.end());
  return incidences;
}

class Component_graph
{
public:
  // A connected set of critical edges, or a pole. Its neighborhood is the region of a node.
  struct Leaf
  {
    int pole = -1;
    int euler_characteristic = 0;
    std::vector<std::size_t> arcs; // by end of a component
  };

  explicit Component_graph(const Cut_mesh& cut)
    : m_cut(cut), m_mesh(cut.mesh), m_set(num_vertices(cut.mesh))
  {
    for (const auto e : edges(m_mesh))
      if (cut.is_critical[e])
        m_set.union_set(std::size_t(m_mesh.vertex(e, 0)), std::size_t(m_mesh.vertex(e, 1)));
    for (const auto v : vertices(m_mesh))
      if (cut.is_on_critical_leaf(v))
        add_vertex(v);
    for (const auto e : edges(m_mesh))
      if (cut.is_critical[e])
        --m_leaves.at(leaf(m_mesh.vertex(e, 0))).euler_characteristic;
    for (const auto f : faces(m_mesh))
      if (cut.is_at_node(f))
        ++m_leaves.at(leaf(target(halfedge(f, m_mesh), m_mesh))).euler_characteristic;
    add_ends();
  }

  // the number of the leaf through a vertex on a critical leaf
  std::size_t leaf(Mesh::Vertex_index v)
  {
    return m_number_of_leaf.at(m_set.find_set(std::size_t(v)));
  }

  const std::vector<Leaf>& leaves() const { return m_leaves; }

  Incidences incidences() const
  {
    Incidences result;
    for (const Leaf& leaf : m_leaves)
      result.push_back(leaf.arcs);
    return sorted(result);
  }

private:
  void add_vertex(Mesh::Vertex_index v)
  {
    if (m_number_of_leaf.emplace(m_set.find_set(std::size_t(v)), m_leaves.size()).second)
      m_leaves.emplace_back();
    Leaf& result = m_leaves[leaf(v)];
    ++result.euler_characteristic;
    const auto pole = m_cut.pole.find(v);
    if (pole == m_cut.pole.end())
      return;
    EXPECT_TRUE(result.pole < 0 || result.pole == pole->second) << "two poles on one leaf";
    result.pole = pole->second;
  }

  // A component has an end at each of its boundary curves, and at each pole that is one vertex.
  void add_ends()
  {
    std::set<Mesh::Halfedge_index> is_walked;
    for (const auto first : halfedges(m_mesh))
    {
      const auto f = face(first, m_mesh);
      if (!m_cut.is_critical[edge(first, m_mesh)] || m_cut.is_at_node(f) || is_walked.count(first))
        continue;
      m_leaves[leaf(target(first, m_mesh))].arcs.push_back(m_cut.component[f]);
      for (auto h = first; is_walked.insert(h).second;)
        for (h = next(h, m_mesh); !m_cut.is_critical[edge(h, m_mesh)];)
          h = next(opposite(h, m_mesh), m_mesh);
    }
    for (const auto& [v, pole] : m_cut.pole)
      if (!m_cut.is_on_critical_edge(v))
        m_leaves[leaf(v)].arcs.push_back(m_cut.component[face(halfedge(v, m_mesh), m_mesh)]);
  }

  const Cut_mesh& m_cut;
  const Mesh& m_mesh;
  boost::disjoint_sets_with_storage<> m_set; // vertices joined by critical edges
  std::map<std::size_t, std::size_t> m_number_of_leaf;
  std::vector<Leaf> m_leaves;
};

inline Incidences incidences(const CGAL::Surface_mesh_foliation::Loop_system<Mesh>& system)
{
  Incidences result(system.number_of_nodes());
  for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
    for (int end : {0, 1})
      result[system.node(a, end)].push_back(a);
  return sorted(result);
}

// ===  What must hold

inline int euler_characteristic(const Mesh& mesh)
{
  return static_cast<int>(num_vertices(mesh) + num_faces(mesh)) - static_cast<int>(num_edges(mesh));
}

inline void expect_same_surface(const Cut_mesh& cut, const Mesh& mesh)
{
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(cut.mesh));
  EXPECT_TRUE(CGAL::is_triangle_mesh(cut.mesh));
  EXPECT_TRUE(CGAL::is_closed(cut.mesh));
  EXPECT_EQ(euler_characteristic(cut.mesh), euler_characteristic(mesh));
}

// Without critical leaves every component is connected and an open annulus: an annulus, or a disk
// or a sphere with its poles.
inline void expect_annuli(const Cut_mesh& cut, std::size_t number_of_arcs)
{
  boost::disjoint_sets_with_storage<> pieces(num_faces(cut.mesh));
  std::map<std::size_t, int> characteristic;
  for (const auto e : edges(cut.mesh))
    if (!cut.is_critical[e])
    {
      const auto f = face(halfedge(e, cut.mesh), cut.mesh);
      const auto g = face(opposite(halfedge(e, cut.mesh), cut.mesh), cut.mesh);
      pieces.union_set(std::size_t(f), std::size_t(g));
      EXPECT_EQ(cut.component[f], cut.component[g]) << "another component without critical leaf";
      --characteristic[cut.component[f]];
    }
  std::map<std::size_t, std::set<std::size_t>> pieces_of_component;
  for (const auto f : faces(cut.mesh))
    if (!cut.is_at_node(f))
    {
      pieces_of_component[cut.component[f]].insert(pieces.find_set(std::size_t(f)));
      ++characteristic[cut.component[f]];
    }
  for (const auto v : vertices(cut.mesh))
    if (!cut.is_on_critical_leaf(v))
      ++characteristic[cut.component[face(halfedge(v, cut.mesh), cut.mesh)]];
  EXPECT_EQ(pieces_of_component.size(), number_of_arcs);
  for (const auto& [arc, its_pieces] : pieces_of_component)
  {
    EXPECT_LT(arc, number_of_arcs);
    EXPECT_EQ(its_pieces.size(), 1u) << "arc " << arc;
    EXPECT_EQ(characteristic[arc], 0) << "arc " << arc;
  }
}

// The graph of the components is that of the loop system, arc by arc; vertices at a node, and they
// alone, lie on its leaf.
inline void expect_dual_graph(
  const Cut_mesh& cut, const CGAL::Surface_mesh_foliation::Measured_foliation<Mesh>& foliation)
{
  const auto& system = foliation.system();
  Component_graph graph(cut);
  EXPECT_EQ(graph.incidences(), incidences(system));
  std::map<std::size_t, std::size_t> leaf_of_node, node_of_leaf;
  auto v = vertices(cut.mesh).begin();
  for (const auto u : vertices(foliation.mesh()))
  {
    const auto cell = foliation.cell(u);
    EXPECT_EQ(cut.is_on_critical_leaf(*v), !cell.is_arc) << u;
    if (!cell.is_arc && cut.is_on_critical_leaf(*v))
    {
      const std::size_t leaf = graph.leaf(*v);
      EXPECT_EQ(leaf_of_node.emplace(cell.index, leaf).first->second, leaf) << u;
      EXPECT_EQ(node_of_leaf.emplace(leaf, cell.index).first->second, cell.index) << u;
    }
    ++v;
  }
  for (const auto& [number, node] : node_of_leaf)
  {
    const Component_graph::Leaf& leaf = graph.leaves()[number];
    EXPECT_EQ(leaf.pole, system.pole(node)) << "node " << node;
    EXPECT_EQ(leaf.euler_characteristic,
              2 - 2 * static_cast<int>(system.genus(node)) - static_cast<int>(system.degree(node)))
      << "node " << node;
    std::vector<std::size_t> expected;
    for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
      for (int end : {0, 1})
        if (system.node(a, end) == node)
          expected.push_back(a);
    std::vector<std::size_t> arcs = leaf.arcs;
    std::sort(arcs.begin(), arcs.end());
    EXPECT_EQ(arcs, expected) << "node " << node;
  }
}

} // namespace smf_test

#endif // SMF_TEST_COMPONENT_GRAPH_H
