// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_VERSION_H
#define CGAL_SURFACE_MESH_FOLIATION_VERSION_H

/// \ingroup PkgSurfaceMeshFoliationRef
/// the version of the package, as a string
#define CGAL_SURFACE_MESH_FOLIATION_VERSION "0.1.0"

/// \ingroup PkgSurfaceMeshFoliationRef
/// the version of the package, as the number 10000 * major + 100 * minor + patch
#define CGAL_SURFACE_MESH_FOLIATION_VERSION_NR 100

#endif // CGAL_SURFACE_MESH_FOLIATION_VERSION_H
