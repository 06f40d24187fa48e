// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_ALL_LEAVES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_ALL_LEAVES_H

#include <CGAL/Surface_mesh_foliation/Leaf_tracer.h>
#include <CGAL/Surface_mesh_foliation/leaves.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_embedding.h>

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// A polyline of a critical leaf, with its node, or a regular leaf, with its arc and level.
template <class Point>
struct Labelled_leaf
{
  std::vector<Point> points;
  int arc, node; // -1: none
  double level;  // 0 for critical leaves
};

// The critical leaves, and the regular leaves that an embedding has sampled.
template <class TriangleMesh>
std::vector<Labelled_leaf<typename Loop_system<TriangleMesh>::Point>> all_leaves(
  const Measured_foliation<TriangleMesh>& foliation,
  const Reeb_graph_embedding<typename Loop_system<TriangleMesh>::Point>& embedding)
{
  using Point = typename Loop_system<TriangleMesh>::Point;
  std::vector<Labelled_leaf<Point>> result;
  std::vector<Critical_polyline<Point>> critical;
  critical_leaves(foliation, std::back_inserter(critical));
  for (Critical_polyline<Point>& polyline : critical)
    result.push_back({std::move(polyline.points), -1, static_cast<int>(polyline.node), 0});
  const Leaf_tracer<TriangleMesh> tracer(foliation);
  for (std::size_t a = 0; a < embedding.levels.size(); ++a)
    for (double level : embedding.levels[a])
      result.push_back({tracer.leaf(a, level).points, static_cast<int>(a), -1, level});
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_ALL_LEAVES_H
