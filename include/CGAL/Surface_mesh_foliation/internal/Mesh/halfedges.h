// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_HALFEDGES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_HALFEDGES_H

#include <array>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// How the halfedges of a Flat_mesh are numbered: those of edge e are 2e, the forward one, and
// 2e + 1. Everything that has a direction and belongs to an edge (words, crossings, frames) is
// stored along the forward halfedge.

constexpr int edge_of(int h) noexcept
{
  return h / 2;
}

constexpr int opposite_of(int h) noexcept
{
  return h ^ 1;
}

constexpr bool is_forward(int h) noexcept
{
  return h % 2 == 0;
}

// the forward halfedge of edge e
constexpr int halfedge_of(int e) noexcept
{
  return 2 * e;
}

// both halfedges of edge e, the forward one first
constexpr std::array<int, 2> halfedges_of_edge(int e) noexcept
{
  return {2 * e, 2 * e + 1};
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_HALFEDGES_H
