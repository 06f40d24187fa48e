// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_NAMED_PARAMETERS_H
#define CGAL_SURFACE_MESH_FOLIATION_NAMED_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>

#include <type_traits>

namespace CGAL {
namespace Surface_mesh_foliation {

namespace internal_np {

enum weights_t { weights };
enum allow_any_weights_t { allow_any_weights };
enum tolerance_t { tolerance };
enum number_of_samples_t { number_of_samples };
enum use_uniform_levels_t { use_uniform_levels };
enum number_of_smoothing_steps_t { number_of_smoothing_steps };
enum use_pole_labels_t { use_pole_labels };
enum over_relaxation_t { over_relaxation };
enum use_literal_moves_t { use_literal_moves };
enum stage_critical_moves_t { stage_critical_moves };
enum spread_by_rings_t { spread_by_rings };
enum edge_value_map_t { edge_value_map };
enum node_map_t { node_map };
enum arc_map_t { arc_map };
enum face_component_map_t { face_component_map };
enum surface_point_map_t { surface_point_map };
enum persistence_t { persistence };
enum unfold_saddles_t { unfold_saddles };
enum vertex_to_arc_map_t { vertex_to_arc_map };
enum pole_detector_t { pole_detector };
enum number_of_poles_t { number_of_poles };
enum diffusion_time_t { diffusion_time };
enum number_of_eigenpairs_t { number_of_eigenpairs };
enum decimation_threshold_t { decimation_threshold };
enum blade_width_t { blade_width };
enum blade_flatness_t { blade_flatness };
enum least_line_length_t { least_line_length };
enum vertex_scalar_map_t { vertex_scalar_map };
enum use_poles_as_punctures_t { use_poles_as_punctures };
enum min_loop_length_t { min_loop_length };
enum min_relative_loop_length_t { min_relative_loop_length };
enum max_leaf_length_t { max_leaf_length };

} // namespace internal_np

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

namespace internal {

// Whether every parameter of the sequence has one of the given tags.
template <class NamedParameters, class... Tags>
struct Are_parameters_known;

template <class... Tags>
struct Are_parameters_known<CGAL::internal_np::No_property, Tags...> : std::true_type
{};

template <class T, class Tag, class Base, class... Tags>
struct Are_parameters_known<CGAL::Named_function_parameters<T, Tag, Base>, Tags...>
  : std::bool_constant<(std::is_same_v<Tag, CGAL::internal_np::all_default_t> || ... ||
                        std::is_same_v<Tag, Tags>)&&Are_parameters_known<Base, Tags...>::value>
{};

// The parameters of a sequence that have one of the given tags, as a sequence. It ends with \cgal's
// default, a parameter that every function knows.
template <class... Tags>
struct Selection
{
  template <class T, class Tag, class Base>
  static auto of(const CGAL::Named_function_parameters<T, Tag, Base>& np)
  {
    const auto rest = of_rest<Base>(np);
    if constexpr ((std::is_same_v<Tag, Tags> || ...))
      return CGAL::Named_function_parameters<T, Tag, std::decay_t<decltype(rest)>>(np.v, rest);
    else
      return rest;
  }

private:
  template <class Base, class NamedParameters>
  static auto of_rest(const NamedParameters& np)
  {
    if constexpr (std::is_same_v<Base, CGAL::internal_np::No_property>)
      return CGAL::parameters::default_values();
    else
      return of(static_cast<const Base&>(np));
  }
};

template <class... Tags, class NamedParameters>
auto select(const NamedParameters& np)
{
  return Selection<Tags...>::of(np);
}

// Misspelt and misplaced parameters are worse than none.
template <class... Tags, class NamedParameters>
constexpr void check_parameters(const NamedParameters&)
{
  static_assert(
    Are_parameters_known<NamedParameters, Tags...>::value,
    "this function of Surface_mesh_foliation does not know one of the named parameters");
}

} // namespace internal

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_NAMED_PARAMETERS_H
