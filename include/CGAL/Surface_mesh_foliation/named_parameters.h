// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_NAMED_PARAMETERS_H
#define CGAL_SURFACE_MESH_FOLIATION_NAMED_PARAMETERS_H

#include <CGAL/Surface_mesh_foliation/internal/Common/Named_parameters.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/check_parameters.h>

#endif // CGAL_SURFACE_MESH_FOLIATION_NAMED_PARAMETERS_H
