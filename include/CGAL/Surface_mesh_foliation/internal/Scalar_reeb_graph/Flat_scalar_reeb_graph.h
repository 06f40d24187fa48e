// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SCALAR_REEB_GRAPH_FLAT_SCALAR_REEB_GRAPH_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SCALAR_REEB_GRAPH_FLAT_SCALAR_REEB_GRAPH_H

#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/Critical_kind.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

namespace internal {

// The Reeb graph of a function on a flat mesh. Nodes are in ascending order of their vertices and,
// at one vertex, of their steps.
struct Flat_scalar_reeb_graph
{
  struct Node
  {
    int vertex = -1;
    Critical_kind kind = Critical_kind::SADDLE;
    int step = 0;         // a saddle of multiplicity m is m simple ones: steps 0, ..., m - 1
    int multiplicity = 0; // of a saddle
    int genus = 0;        // of the surface near the critical level
  };

  struct Arc
  {
    int lower = -1, upper = -1; // nodes
    int first_piece = -1;       // lowest of the pieces that it is made of
    int number_of_vertices = 0; // strictly between the nodes
  };

  // An arc before simplification. Just above its lower node its contour crosses the halfedge, which
  // leaves the vertex of that node; and if this halfedge descends, it does so just below the
  // vertex.
  struct Piece
  {
    int lower_vertex = -1, upper_vertex = -1;
    int lower_step = 0;
    int halfedge = -1;
    int next = -1; // the piece above it in the same arc
  };

  std::vector<Node> nodes;
  std::vector<Arc> arcs;
  std::vector<Piece> pieces;
  std::vector<int> arc_of_vertex; // at the vertex of a node, one of its arcs
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SCALAR_REEB_GRAPH_FLAT_SCALAR_REEB_GRAPH_H
