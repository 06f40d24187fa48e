// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_TIED_VERTICES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_TIED_VERTICES_H

#include <CGAL/Surface_mesh_foliation/internal/Common/Disjoint_sets.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// the median of about a thousand edge weights from all over the mesh
inline double typical_weight(const Foliation_state& state)
{
  const int number_of_edges = state.mesh().number_of_edges();
  const int stride = (std::max)(number_of_edges / 1000, 1);
  std::vector<double> sample;
  for (int e = 0; e < number_of_edges; e += stride)
    sample.push_back(state.weight(e));
  const auto middle = sample.begin() + sample.size() / 2;
  std::nth_element(sample.begin(), middle, sample.end());
  return *middle;
}

// Vertices that edges of very large weight tie together, as on slivers, go to nearly the same place
// in T. A quadratic step moves them over a node one after another, and pulls them apart where they
// take different directions. Returns by vertex the number of its cluster, or nothing if there are
// fewer large weights than a share of all vertices.
inline std::vector<int> tied_vertices(const Foliation_state& state, double least_share)
{
  constexpr double large = 1000; // in units of a typical weight
  const Flat_mesh& mesh = state.mesh();
  const double limit = large * typical_weight(state);
  std::vector<int> strong;
  for (int e = 0; e < mesh.number_of_edges(); ++e)
    if (state.weight(e) > limit)
      strong.push_back(e);
  if (limit <= 0 || strong.empty() ||
      static_cast<double>(strong.size()) < least_share * mesh.number_of_vertices())
    return {};
  Disjoint_sets sets(mesh.number_of_vertices());
  for (int e : strong)
    sets.union_set(mesh.source(halfedge_of(e)), mesh.target(halfedge_of(e)));
  std::vector<int> result;
  result.reserve(mesh.number_of_vertices());
  for (int v = 0; v < mesh.number_of_vertices(); ++v)
    result.push_back(static_cast<int>(sets.find_set(v)));
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_TIED_VERTICES_H
