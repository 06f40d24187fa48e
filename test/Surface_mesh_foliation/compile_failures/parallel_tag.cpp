// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Does not compile: the line marked as refused asks for threads without TBB.

#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace SMF = CGAL::Surface_mesh_foliation;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

void misuse(const SMF::Loop_system<Mesh>& system)
{
  SMF::harmonic_foliation<CGAL::Parallel_if_available_tag>(system);
  SMF::harmonic_foliation<CGAL::Parallel_tag>(system); // refused
}
