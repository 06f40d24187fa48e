// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_FOLIATION_VISITOR_H
#define CGAL_SURFACE_MESH_FOLIATION_FOLIATION_VISITOR_H

#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_statistics.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationFoliation

is the default visitor of `harmonic_foliation()`, a model of `FoliationVisitor`: it does nothing. A
visitor that derives from it needs to define only the functions it cares about.
*/
struct Default_foliation_visitor
{
  /// is called after each iteration; the solver stops, with a certified result, if it returns
  /// `false`.
  bool after_iteration(const Foliation_statistics&) { return true; }

  /// is called after each iteration on a coarser mesh with the given number of vertices, where the
  /// solver finds its starting point; the solver stops, with a certified result, if it returns
  /// `false`.
  bool after_coarse_iteration(std::size_t, const Foliation_statistics&) { return true; }

  /// is called when the leaves have come to the mesh itself, before the first iteration there, with
  /// the arc of each vertex.
  void at_start(const std::vector<std::size_t>&) {}

  /// is called before each step that may take long; if it returns `false`, there is no result, and
  /// a `Stopped_exception` is thrown.
  bool go_on() { return true; }
};

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_FOLIATION_VISITOR_H
