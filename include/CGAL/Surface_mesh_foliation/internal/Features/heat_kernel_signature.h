// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FEATURES_HEAT_KERNEL_SIGNATURE_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FEATURES_HEAT_KERNEL_SIGNATURE_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Features/Laplacian_spectrum.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// By vertex, how much of a unit of heat is still there after some time, per area. The time is given
// as a multiple of 1 / lambda_1, the decay time of the slowest mode. If too few eigenfunctions are
// known for it, it is increased until the first unknown one counts for less than a hundredth of the
// constant one.
inline std::vector<double> heat_kernel_signature(const Flat_mesh& mesh,
                                                 double relative_time,
                                                 int number_of_eigenpairs)
{
  constexpr double negligible = 0.01, least_value = 1e-12; // anything below is rounding
  const int number = (std::min)(number_of_eigenpairs, mesh.number_of_vertices() - 1);
  const Spectrum spectrum = laplacian_spectrum(mesh, number);
  const double time = (std::max)(relative_time / (std::max)(spectrum.values[1], least_value),
                                 -std::log(negligible) / spectrum.values[number - 1]);
  std::vector<double> result(mesh.number_of_vertices());
  const Eigen::VectorXd factors = (-time * spectrum.values).array().exp();
  Eigen::Map<Eigen::VectorXd>(result.data(), mesh.number_of_vertices()) =
    spectrum.functions.cwiseAbs2() * factors;
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FEATURES_HEAT_KERNEL_SIGNATURE_H
