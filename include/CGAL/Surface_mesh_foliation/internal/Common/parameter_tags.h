// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_PARAMETER_TAGS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_PARAMETER_TAGS_H

namespace CGAL {
namespace Surface_mesh_foliation {

// The tags of the named parameters of the package; `CGAL::Surface_mesh_foliation::parameters` has
// what makes them.
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

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_PARAMETER_TAGS_H
