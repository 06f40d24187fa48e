// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The optional compiled library: all functions that CGAL_SURFACE_MESH_FOLIATION_INLINE stands
// before (internal/Common/compiled.h), and function templates for Compiled_mesh.

#include <CGAL/Surface_mesh_foliation.h>

#if !defined(SURFACE_MESH_FOLIATION_COMPILED) || !defined(SURFACE_MESH_FOLIATION_LIBRARY)
#error "to be compiled by CMake, with SURFACE_MESH_FOLIATION_BUILD_LIBRARY"
#endif

#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

using Mesh = internal::Compiled_mesh;
using Default = CGAL::parameters::Default_named_parameters;

template void read_triangle_mesh(const std::string&, Mesh&, const Default&);

template Measured_foliation<Mesh> foliation_reeb_graph<CGAL::Sequential_tag>(
  const Mesh&, const std::vector<Mesh::Vertex_index>&, Reeb_graph<Mesh::Point>&, const Default&);

template Measured_foliation<Mesh> foliation_reeb_graph<CGAL::Sequential_tag>(
  const Mesh&, const Poles_and_loops<Mesh>&, Reeb_graph<Mesh::Point>&, const Default&);

} // namespace Surface_mesh_foliation
} // namespace CGAL
