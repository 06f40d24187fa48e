// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMPONENT_COORDINATES_DIRICHLET_ENERGIES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMPONENT_COORDINATES_DIRICHLET_ENERGIES_H

#include <CGAL/Surface_mesh_foliation/internal/Component_coordinates/Corner_nodes.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/weights_of_flat_mesh.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

inline double finite_or_zero(double x)
{
  return std::isfinite(x) ? x : 0;
}

// By arc, the integral of the squared gradient of t over its component, which does not change when
// the mesh is scaled. Degenerate faces do not count.
inline std::vector<double> dirichlet_energies(const Corner_nodes& nodes, std::size_t number_of_arcs)
{
  const Flat_mesh& mesh = nodes.mesh();
  Corner_geometry corner(mesh);
  std::vector<double> result(number_of_arcs, 0);
  for (int h = 0; h < mesh.number_of_halfedges(); ++h)
    if (const int arc = nodes.arc(h); arc != Corner_nodes::NONE)
    {
      corner.visit(h);
      const double difference = nodes.parameter(mesh.prev(h)) - nodes.parameter_of_target(h);
      result[arc] += finite_or_zero(corner.cotangent() * difference * difference / 2);
    }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMPONENT_COORDINATES_DIRICHLET_ENERGIES_H
