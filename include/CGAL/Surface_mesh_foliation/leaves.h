// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_LEAVES_H
#define CGAL_SURFACE_MESH_FOLIATION_LEAVES_H

#include <CGAL/Surface_mesh_foliation/Leaf_tracer.h>
#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/critical_polylines.h>

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationExtraction

is a part of a critical leaf.
*/
template <class Point>
struct Critical_polyline
{
  std::size_t node;          ///< the node that the critical leaf stands for
  std::vector<Point> points; ///< the first is repeated at the end of a closed polyline
};

/*!
\ingroup PkgSurfaceMeshFoliationExtraction

outputs the critical leaves [Section 5.2.4] as polylines on the mesh, between the points where more
or fewer than two strands meet. A pole at a vertex gives a polyline of one point.

\param foliation the foliation
\param out an output iterator for `Critical_polyline<Point>`, where `Point` is
  `Loop_system<TriangleMesh>::Point`

\returns the output iterator

The time is linear in the size of the mesh: nothing is traced.
*/
template <class TriangleMesh, class PolylineOutputIterator>
PolylineOutputIterator critical_leaves(const Measured_foliation<TriangleMesh>& foliation,
                                       PolylineOutputIterator out)
{
  using Point = typename Loop_system<TriangleMesh>::Point;
  const internal::Refined_mesh& refined = foliation.extraction().refined_mesh;
  for (const std::vector<int>& polyline :
       internal::critical_polylines(refined, foliation.extraction().leaf_graph))
  {
    Critical_polyline<Point> result = {static_cast<std::size_t>(refined.node[polyline[0]]), {}};
    for (int v : polyline)
      result.points.emplace_back(refined.points[v][0], refined.points[v][1], refined.points[v][2]);
    *out++ = std::move(result);
  }
  return out;
}

/*!
\ingroup PkgSurfaceMeshFoliationExtraction

returns the regular leaf of an arc at a distance `t` from its end 0 as a closed polyline, its first
point repeated at the end.

The leaf runs straight through each face of the mesh.

\param foliation the foliation
\param arc the arc
\param t the level, strictly between 0 and `foliation.system().height(arc)`

\throws Invalid_parameter_exception if there is no such arc or level

The time is linear in the number of edges. For many leaves, or the leaf through a point, see
`Leaf_tracer`.
*/
template <class TriangleMesh>
std::vector<typename Loop_system<TriangleMesh>::Point> leaf(
  const Measured_foliation<TriangleMesh>& foliation, std::size_t arc, double t)
{
  return Leaf_tracer<TriangleMesh>(foliation).leaf(arc, t).points;
}

namespace internal {

// A polyline of a critical leaf, with its node, or a regular leaf, with its arc and level.
template <class Point>
struct Labeled_leaf
{
  std::vector<Point> points;
  int arc, node; // -1: none
  double level;  // 0 for critical leaves
};

// The critical leaves, and the regular leaves that an embedding has sampled.
template <class TriangleMesh>
std::vector<Labeled_leaf<typename Loop_system<TriangleMesh>::Point>> all_leaves(
  const Measured_foliation<TriangleMesh>& foliation, const std::vector<std::vector<double>>& levels)
{
  using Mesh_point = typename Loop_system<TriangleMesh>::Point;
  std::vector<Labeled_leaf<Mesh_point>> result;
  std::vector<Critical_polyline<Mesh_point>> critical;
  critical_leaves(foliation, std::back_inserter(critical));
  for (Critical_polyline<Mesh_point>& polyline : critical)
    result.push_back({std::move(polyline.points), -1, static_cast<int>(polyline.node), 0});
  const Leaf_tracer<TriangleMesh> tracer(foliation);
  for (std::size_t a = 0; a < levels.size(); ++a)
    for (double level : levels[a])
      result.push_back({tracer.leaf(a, level).points, static_cast<int>(a), -1, level});
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_LEAVES_H
