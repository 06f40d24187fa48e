// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_SUPERNODAL_CHOLESKY_SOLVER_H
#define CGAL_SURFACE_MESH_FOLIATION_SUPERNODAL_CHOLESKY_SOLVER_H

#include <CGAL/Surface_mesh_foliation/internal/Solver/Supernodal_cholesky_solver.h>

#endif // CGAL_SURFACE_MESH_FOLIATION_SUPERNODAL_CHOLESKY_SOLVER_H
