// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_FOLIATION_STATISTICS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_FOLIATION_STATISTICS_H

#include <cstddef>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationFoliation
\smfHeader{Foliation/Foliation_statistics.h,Foliation_visitor.h}

tells how a solver ended, or how far it has come: the one report that is used everywhere from the
balance of forces to the visitor.
*/
struct Foliation_statistics
{
  /// linear systems solved on the mesh that is reported on, or sweeps of Whitehead moves
  std::size_t number_of_iterations = 0;
  double energy = 0; ///< \f$ \sum_e \alpha_e w_e^2 \f$, each edge counted once
  /// the largest excess of the force of one direction over all others at a free vertex, divided by
  /// the largest sum of forces at any vertex, without those of edges between poles; 0 exactly at
  /// the harmonic foliation
  double optimality = 0;
  /// `optimality` minus what rounding of the parameters of vertices can cause, which may exceed the
  /// tolerance if weights have very different sizes; it can be negative
  double resolved_optimality = 0;
  /// arrivals of vertices at nodes, and departures from them, in the last step of Newton's method;
  /// 0 if Whitehead moves are used
  std::size_t number_of_moves = 0;
  /// the number of vertices that moved in the last iteration of Newton's method to another arc, to
  /// a node, or away from one; 0 if Whitehead moves are used
  std::size_t number_of_changed_vertices = 0;
  /// `resolved_optimality` is below the tolerance
  bool has_converged = false;
  bool is_certified = false; ///< the certificate was checked and holds
};

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_FOLIATION_STATISTICS_H
