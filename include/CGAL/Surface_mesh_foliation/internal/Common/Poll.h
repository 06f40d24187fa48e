// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_POLL_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_POLL_H

#include <functional>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Is called before each step that may take long, and throws if a result is no longer wanted. So all
// data must be valid, and ready for another run, wherever it is called.
using Poll = std::function<void()>;

inline void poll_nobody() {}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_POLL_H
