// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_IO_ARC_COLOR_H
#define CGAL_SURFACE_MESH_FOLIATION_IO_ARC_COLOR_H

#include <CGAL/IO/Color.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationIO

returns the color of an arc, or of its component, in all files that this package writes with colors,
in constant time. It depends only on the number of the arc. Arcs with neighboring numbers have
clearly different colors, and no two of the first hundred have the same color.
*/
inline CGAL::IO::Color arc_color(std::size_t arc)
{
  // hues in steps of the golden ratio, in HSV
  constexpr double golden_ratio = 0.6180339887498949;
  const double hue = 6 * std::fmod(0.05 + golden_ratio * static_cast<double>(arc), 1.);
  const double saturation = arc % 2 == 0 ? 0.55 : 0.75, value = arc % 3 == 2 ? 0.8 : 0.95;
  const auto channel = [&](double offset) {
    const double k = std::fmod(offset + hue, 6.);
    const double distance = std::fmax(0., std::fmin(std::fmin(k, 4 - k), 1.));
    return static_cast<unsigned char>(std::lround(255 * value * (1 - saturation * distance)));
  };
  return CGAL::IO::Color(channel(5), channel(3), channel(1));
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_IO_ARC_COLOR_H
