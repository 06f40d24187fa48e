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
\headerfile internal/Foliation/Foliation_statistics.h <CGAL/Surface_mesh_foliation/Foliation_visitor.h>

says how a solver ended, or how far it has come.
*/
struct Foliation_statistics
{
  std::size_t number_of_iterations = 0; ///< linear systems solved, all on the mesh itself
  double energy = 0;                    ///< \f$ \sum_e \alpha_e w_e^2 \f$, each edge counted once
  /// the largest excess of the force of one direction over all others at a free vertex, divided by
  /// the largest sum of forces at any vertex; 0 exactly at the harmonic foliation
  double optimality = 0;
  std::size_t number_of_moves =
    0; ///< arrivals of vertices at nodes, and departures, in the last step
  /// the vertices whose place changed in the last iteration of Newton's method: to another arc, to
  /// a node, or away from one; 0 if Whitehead moves are used
  std::size_t number_of_changed_vertices = 0;
  /// `optimality` is below the tolerance, apart from what rounding of the parameters can cause
  bool has_converged = false;
  bool is_certified = false; ///< the certificate was checked and holds
};

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_FOLIATION_STATISTICS_H
