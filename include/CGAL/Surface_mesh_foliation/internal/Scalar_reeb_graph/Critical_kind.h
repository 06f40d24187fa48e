// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SCALAR_REEB_GRAPH_CRITICAL_KIND_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SCALAR_REEB_GRAPH_CRITICAL_KIND_H

namespace CGAL {
namespace Surface_mesh_foliation {

/// \ingroup PkgSurfaceMeshFoliationGraph
/// is the kind of a node of the Reeb graph of a function.
enum class Critical_kind {
  MINIMUM, ///< a vertex that is lower than its neighbors
  MAXIMUM, ///< a vertex that is higher than its neighbors
  SADDLE   ///< a vertex around which lower and higher neighbors alternate at least four times
};

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SCALAR_REEB_GRAPH_CRITICAL_KIND_H
