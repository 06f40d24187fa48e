// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_NAMED_PARAMETERS_H
#define CGAL_SURFACE_MESH_FOLIATION_NAMED_PARAMETERS_H

#include <CGAL/Surface_mesh_foliation/internal/Common/check_parameters.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationParameters

contains the named parameters of this package. They are used like those of \cgal and mixed with
them: `parameters::tolerance(1e-9).vertex_point_map(vpm)` begins with one of ours and goes on with
\cgal's; any other order needs `parameters::combine()`.

A function refuses at compile time a named parameter that it does not know.
*/
namespace parameters {

#define CGAL_SURFACE_MESH_FOLIATION_PARAMETER(name)                              \
  template <class T>                                                             \
  CGAL::Named_function_parameters<T, internal_np::name##_t> name(const T& value) \
  {                                                                              \
    return CGAL::Named_function_parameters<T, internal_np::name##_t>(value);     \
  }

/// @{
/// makes the named parameter of the same name
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(weights)
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(allow_any_weights)
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(tolerance)
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(number_of_samples)
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(use_uniform_levels)
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(number_of_smoothing_steps)
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(use_pole_labels)
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(over_relaxation)
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(use_literal_moves)
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(stage_critical_moves)
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(spread_by_rings)
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(edge_value_map)
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(node_map)
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(arc_map)
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(face_component_map)
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(surface_point_map)
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(persistence)
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(unfold_saddles)
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(vertex_to_arc_map)
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(pole_detector)
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(number_of_poles)
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(diffusion_time)
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(number_of_eigenpairs)
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(decimation_threshold)
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(blade_width)
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(blade_flatness)
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(least_line_length)
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(vertex_scalar_map)
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(use_poles_as_punctures)
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(min_loop_length)
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(min_relative_loop_length)
CGAL_SURFACE_MESH_FOLIATION_PARAMETER(max_leaf_length)
/// @}

#undef CGAL_SURFACE_MESH_FOLIATION_PARAMETER

/// returns `np`
template <class NamedParameters>
NamedParameters combine(const NamedParameters& np)
{
  return np;
}

/// returns the named parameters `np`, `first` and `others` as one sequence; all but `np` are single
/// parameters
template <class NamedParameters, class T, class Tag, class... Others>
auto combine(const NamedParameters& np,
             const CGAL::Named_function_parameters<T, Tag>& first,
             const Others&... others)
{
  return combine(CGAL::Named_function_parameters<T, Tag, NamedParameters>(first.v, np), others...);
}

} // namespace parameters

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_NAMED_PARAMETERS_H
