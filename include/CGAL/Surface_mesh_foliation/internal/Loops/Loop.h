// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LOOPS_LOOP_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LOOPS_LOOP_H

#include <boost/graph/graph_traits.hpp>

#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationLoops
\smfHeader{Loops/Loop.h,Loop.h}

is a place where a loop crosses an edge: from `face(halfedge, mesh)` to
`face(opposite(halfedge, mesh), mesh)`.

\tparam TriangleMesh a model of `FaceGraph`
*/
template <class TriangleMesh>
struct Crossing
{
  /// the crossed halfedge, on the side from which the loop comes; its target lies to the left
  typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge;

  /// where the edge is crossed, strictly between 0 at the source of `halfedge` and 1 at its target.
  /// Only the order of the crossings of one edge matters.
  double position;
};

/*!
\ingroup PkgSurfaceMeshFoliationLoops

is a closed curve in general position, given by the cyclic sequence of its crossings. Inside a
triangle it is a segment, so the halfedge of the next crossing belongs to the face that a crossing
leads into. Several loops may cross an edge, and one loop may cross it several times. The triangle
strips of Section 3.2 of the paper are the loops that cross every triangle at most once.

\tparam TriangleMesh a model of `FaceGraph`
*/
template <class TriangleMesh>
using Loop = std::vector<Crossing<TriangleMesh>>;

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LOOPS_LOOP_H
