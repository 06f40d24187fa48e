// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_VERSION_H
#define CGAL_SURFACE_MESH_FOLIATION_VERSION_H

// The one place where the version is decided: CMake reads it here, package/set_version.sh changes
// it, and a test compares the files that repeat it.

/// \ingroup PkgSurfaceMeshFoliationRef
/// the version of the package, as a string
#define CGAL_SURFACE_MESH_FOLIATION_VERSION "0.2.0"

/// \ingroup PkgSurfaceMeshFoliationRef
/// the version of the package, as the number 10000 * major + 100 * minor + patch
#define CGAL_SURFACE_MESH_FOLIATION_VERSION_NR 200

#endif // CGAL_SURFACE_MESH_FOLIATION_VERSION_H
