// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_CELL_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_CELL_H

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// What a vertex lies in: an arc of T, given as a lift in the frame of the vertex, or a node. For a
// node, the lift is not stored; the words of the edges tell whether two vertices lie in the same
// one. Letters, words and frames: see the glossary in ARCHITECTURE.md.
class Cell
{
public:
  static constexpr Cell arc(int lift) noexcept { return Cell(lift); }
  static constexpr Cell at_node(int node) noexcept { return Cell(~node); }

  constexpr bool is_node() const noexcept { return m_code < 0; }
  constexpr int lift() const noexcept { return m_code; }  // precondition: an arc
  constexpr int node() const noexcept { return ~m_code; } // precondition: a node

  friend constexpr bool operator==(Cell a, Cell b) noexcept { return a.m_code == b.m_code; }
  friend constexpr bool operator!=(Cell a, Cell b) noexcept { return !(a == b); }

private:
  explicit constexpr Cell(int code) noexcept : m_code(code) {}

  int m_code; // the lift, or ~node
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_CELL_H
