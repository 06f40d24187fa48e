// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_CRITICAL_KIND_H
#define CGAL_SURFACE_MESH_FOLIATION_CRITICAL_KIND_H

#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/Critical_kind.h>

#endif // CGAL_SURFACE_MESH_FOLIATION_CRITICAL_KIND_H
