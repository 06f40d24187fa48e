// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_GENERATORS_REMESHED_H
#define SMF_GENERATORS_REMESHED_H

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <cmath>
#include <cstddef>

namespace smf_test {

// Another mesh of a surface, with about the given number of vertices, and edges of about the same
// length.
template <class Surface>
Surface remeshed(Surface mesh, std::size_t number_of_vertices)
{
  const double area = CGAL::to_double(CGAL::Polygon_mesh_processing::area(mesh));
  // twice as many triangles as vertices, equilateral ones
  const double length =
    std::sqrt(2 * area / (std::sqrt(3.) * static_cast<double>(number_of_vertices)));
  CGAL::Polygon_mesh_processing::isotropic_remeshing(faces(mesh), length, mesh,
                                                     CGAL::parameters::number_of_iterations(5));
  mesh.collect_garbage();
  return mesh;
}

} // namespace smf_test

#endif // SMF_GENERATORS_REMESHED_H
