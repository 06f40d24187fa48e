// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_GENERATORS_KNOWN_MODULI_H
#define SMF_GENERATORS_KNOWN_MODULI_H

#include "generators/soups.h"

#include <CGAL/Surface_mesh_foliation/loops.h>

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

// Moduli of homotopy classes of loops in closed form, and sections by planes that have these
// classes.

namespace smf_test {

// K(k) for a given k' = sqrt(1 - k^2), by the arithmetic-geometric mean
inline double complete_elliptic_integral(double complementary_modulus)
{
  double a = 1, b = complementary_modulus;
  for (int i = 0; i < 60; ++i)
  {
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  return soups::pi / (2 * a);
}

// K'(k) / K(k)
inline double ratio_of_elliptic_integrals(double k)
{
  return complete_elliptic_integral(k) / complete_elliptic_integral(std::sqrt(1 - k * k));
}

// around a capsule of radius 1 with two poles halfway up each of its ends: after a stereographic
// projection, an annulus between two slits of a cylinder
inline double modulus_of_capsule(double length)
{
  const double t = std::tan(soups::pi / 8);
  return ratio_of_elliptic_integrals(t * t * std::exp(-length)) / 4;
}

// around a dumbbell of spheres of radius 1 with two opposite poles on the largest circle of each of
// them: the same, with another distance between the slits
inline double modulus_of_dumbbell(double radius, double length)
{
  const double t = std::tan(std::asin(radius) / 2);
  return ratio_of_elliptic_integrals(t * t * std::exp(-length / radius)) / 4;
}

// the loops in which a plane, where one coordinate has a given value, meets a mesh
template <class TriangleMesh>
std::vector<CGAL::Surface_mesh_foliation::Loop<TriangleMesh>> section(const TriangleMesh& mesh,
                                                                      int axis,
                                                                      double level)
{
  const auto coordinate = boost::make_function_property_map<
    typename boost::graph_traits<TriangleMesh>::vertex_descriptor>([&mesh, axis](auto v) {
    return static_cast<double>(get(get(CGAL::vertex_point, mesh), v)[axis]);
  });
  std::vector<CGAL::Surface_mesh_foliation::Loop<TriangleMesh>> result;
  CGAL::Surface_mesh_foliation::isoline_loops(mesh, coordinate, level, std::back_inserter(result));
  return result;
}

} // namespace smf_test

#endif // SMF_GENERATORS_KNOWN_MODULI_H
