// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_POLE_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_POLE_H

#include <cstddef>
#include <initializer_list>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// A pole: one vertex, the vertices of a line in order, or the cap on an opening: the vertex in the
// middle of the cap, and then those of the border in order.
//
// The vertices are joined by edges to a tree: those of a line to the one before, those of a border
// to the middle of the cap. A thin tube around the tree is a disk, and is one puncture of the mesh.
class Pole
{
public:
  Pole() = default;
  Pole(std::initializer_list<int> vertices) : m_vertices(vertices) {}
  explicit Pole(std::vector<int> vertices, bool is_cap = false)
    : m_vertices(std::move(vertices)), m_is_cap(is_cap)
  {}

  bool is_cap() const { return m_is_cap; }
  bool is_line() const { return !m_is_cap && m_vertices.size() > 1; }

  std::size_t size() const { return m_vertices.size(); }
  int operator[](std::size_t i) const { return m_vertices[i]; }
  auto begin() const { return m_vertices.begin(); }
  auto end() const { return m_vertices.end(); }
  auto begin() { return m_vertices.begin(); }
  auto end() { return m_vertices.end(); }
  void push_back(int v) { m_vertices.push_back(v); }
  const std::vector<int>& vertices() const { return m_vertices; }

  friend bool operator==(const Pole& x, const Pole& y)
  {
    return x.m_is_cap == y.m_is_cap && x.m_vertices == y.m_vertices;
  }
  friend bool operator!=(const Pole& x, const Pole& y) { return !(x == y); }

  // the vertex that the i-th one is joined to in the tree; precondition: i > 0
  int parent(std::size_t i) const { return m_vertices[m_is_cap ? 0 : i - 1]; }

private:
  std::vector<int> m_vertices;
  bool m_is_cap = false;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_POLE_H
