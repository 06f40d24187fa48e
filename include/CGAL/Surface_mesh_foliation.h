// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_H
#define CGAL_SURFACE_MESH_FOLIATION_H

/// \file
/// includes the package, except for `feature_poles.h`, `Cholmod_solver.h` and
/// `Boomer_amg_solver.h`, which need further libraries.

#include <CGAL/Surface_mesh_foliation/Component_coordinates.h>
#include <CGAL/Surface_mesh_foliation/Critical_kind.h>
#include <CGAL/Surface_mesh_foliation/Foliation_solver.h>
#include <CGAL/Surface_mesh_foliation/Foliation_visitor.h>
#include <CGAL/Surface_mesh_foliation/Leaf_spread_recorder.h>
#include <CGAL/Surface_mesh_foliation/Leaf_tracer.h>
#include <CGAL/Surface_mesh_foliation/Loop.h>
#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>
#include <CGAL/Surface_mesh_foliation/Poles_and_loops.h>
#include <CGAL/Surface_mesh_foliation/Simplicial_cholesky_solver.h>
#include <CGAL/Surface_mesh_foliation/add_missing_poles.h>
#include <CGAL/Surface_mesh_foliation/automatic_loops.h>
#include <CGAL/Surface_mesh_foliation/components.h>
#include <CGAL/Surface_mesh_foliation/curve_skeleton.h>
#include <CGAL/Surface_mesh_foliation/edge_weights.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/feature_lines.h>
#include <CGAL/Surface_mesh_foliation/foliation_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/integrate_foliation.h>
#include <CGAL/Surface_mesh_foliation/leaves.h>
#include <CGAL/Surface_mesh_foliation/loops.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>
#include <CGAL/Surface_mesh_foliation/openings.h>
#include <CGAL/Surface_mesh_foliation/parts.h>
#include <CGAL/Surface_mesh_foliation/picked_loops.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_embedding.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_matching.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_of_function.h>
#include <CGAL/Surface_mesh_foliation/singularities.h>
#include <CGAL/Surface_mesh_foliation/subdivide_saddle_faces.h>
#include <CGAL/Surface_mesh_foliation/version.h>
#include <CGAL/Surface_mesh_foliation/whitehead_foliation.h>
#include <CGAL/Surface_mesh_foliation/IO/arc_color.h>
#include <CGAL/Surface_mesh_foliation/IO/polygon_soup.h>
#include <CGAL/Surface_mesh_foliation/IO/read_triangle_mesh.h>
#include <CGAL/Surface_mesh_foliation/IO/read_loops.h>
#include <CGAL/Surface_mesh_foliation/IO/write_component_coordinates.h>
#include <CGAL/Surface_mesh_foliation/IO/write_foliation.h>
#include <CGAL/Surface_mesh_foliation/IO/write_loops.h>
#include <CGAL/Surface_mesh_foliation/IO/write_polylines.h>
#include <CGAL/Surface_mesh_foliation/IO/write_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/IO/write_segments.h>
#include <CGAL/Surface_mesh_foliation/IO/write_swc.h>
#include <CGAL/Surface_mesh_foliation/IO/write_vtp.h>

#endif // CGAL_SURFACE_MESH_FOLIATION_H
