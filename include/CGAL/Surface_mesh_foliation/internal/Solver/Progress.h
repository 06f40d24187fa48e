// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_PROGRESS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_PROGRESS_H

#include <CGAL/Surface_mesh_foliation/internal/Common/Poll.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_statistics.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The reports of the part of a solver that works on coarser meshes.
struct Progress
{
  // is called with the number of vertices of a coarse mesh after each iteration there; the solver
  // stops if it returns false
  std::function<bool(int, const Foliation_statistics&)> after_coarse_iteration =
    [](int, const Foliation_statistics&) { return true; };
  // is called with the arc of each vertex before the first iteration on the mesh itself; empty if
  // nobody wants to know
  std::function<void(const std::vector<std::size_t>&)> at_start = nullptr;
  Poll poll = poll_nobody;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_PROGRESS_H
