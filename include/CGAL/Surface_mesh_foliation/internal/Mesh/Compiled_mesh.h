// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_COMPILED_MESH_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_COMPILED_MESH_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// the type of mesh for which the compiled library has function templates
using Compiled_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_COMPILED_MESH_H
