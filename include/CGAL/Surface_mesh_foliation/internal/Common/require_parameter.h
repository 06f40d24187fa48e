// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_REQUIRE_PARAMETER_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_REQUIRE_PARAMETER_H

#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The parts of the message say what is wrong with the parameter if the condition does not hold.
template <class... Part>
void require_parameter(bool is_right, const Part&... message)
{
  if (!is_right)
    throw Invalid_parameter_exception(problem(Problem_kind::INVALID_PARAMETER, message...));
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_REQUIRE_PARAMETER_H
