// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Does not compile: see misuse.cpp.

#include <CGAL/Surface_mesh_foliation/feature_poles.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <iterator>
#include <vector>

namespace SMF = CGAL::Surface_mesh_foliation;
namespace smf_np = CGAL::Surface_mesh_foliation::parameters;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

// message: does not know one of the named parameters
void misuse(const Mesh& mesh)
{
  std::vector<Mesh::Vertex_index> out;
  SMF::detect_feature_poles(mesh, std::back_inserter(out), smf_np::tolerance(1.)); // refused
  SMF::detect_feature_poles(mesh, std::back_inserter(out),
                            smf_np::persistence(2.).verbose(true)); // refused
  SMF::detect_feature_poles(mesh, std::back_inserter(out), smf_np::persistence(2.));
}
