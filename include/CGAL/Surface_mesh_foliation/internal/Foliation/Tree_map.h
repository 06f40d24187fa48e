// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_TREE_MAP_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_TREE_MAP_H

#include <CGAL/Surface_mesh_foliation/internal/Foliation/Cell.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Tree_paths.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// a parameter, moved off the ends of its arc if rounding has put it there
inline double inner_parameter(double t, double height)
{
  constexpr double margin = 4 * std::numeric_limits<double>::epsilon();
  return std::clamp(t, margin * height, (1 - margin) * height);
}

// Where an equivariant map to the tree T sends the vertices and edges of the mesh. Letters, words
// and frames: see the glossary in ARCHITECTURE.md.
struct Tree_map
{
  std::vector<Cell> cell;
  std::vector<double> t; // distance from end 0 of the arc; 0 at a node
  Tree_paths paths;
  // Whether linear systems measure the parameter of a vertex upward (1) or downward (-1). A vertex
  // that passes a node keeps its heading; at the node, this is the heading with which it arrived.
  std::vector<signed char> orientation;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_TREE_MAP_H
