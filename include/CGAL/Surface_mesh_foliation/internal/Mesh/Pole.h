// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_POLE_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_POLE_H

#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// A pole: one vertex, or the vertices of a line in order.
using Pole = std::vector<int>;

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_POLE_H
