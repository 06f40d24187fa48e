// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_POLE_SIGNIFICANCE_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_POLE_SIGNIFICANCE_H

#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Class_moduli.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/Poll.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Geodesic_distances.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Pole.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/vertex_areas.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// How much a vertex stands out of a surface with other poles: the modulus of the annuli around it,
// outside a geodesic disk of a small share of the area, minus what it is if the rest of the surface
// is a flat disk around this one. A limb of length l and circumference c has at least about l / c,
// less the logarithm of the ratio of the sizes of surface and limb; a place on the side of a limb
// has about zero, one beside another pole less.
class Pole_significance
{
public:
  // ends: poles that there are already
  Pole_significance(const Flat_mesh& mesh, std::vector<Pole> ends, Poll poll = poll_nobody)
    : m_mesh(mesh),
      m_ends(std::move(ends)),
      m_area(vertex_areas(mesh)),
      m_lengths(edge_lengths(mesh)),
      m_moduli(mesh, m_ends, std::move(poll))
  {}

  // Of a vertex beside the ends and other poles; infinite if a foliation would need it as a pole.
  double operator()(int vertex, const std::vector<int>& others)
  {
    std::vector<Pole> poles = m_ends;
    for (int v : others)
      poles.push_back({v});
    if (m_mesh.genus() == 0 && poles.size() < 2)
      return (std::numeric_limits<double>::infinity)();
    poles.push_back({vertex});
    m_moduli.set_poles(poles);
    double area = 0;
    const std::vector<bool> cap = disk_around(vertex, area);
    const double pi = std::acos(-1.);
    return m_moduli.around_cap(static_cast<int>(poles.size()) - 1, cap) + std::log(area) / (4 * pi);
  }

private:
  static constexpr double area_of_disk = 0.0025; // as a share of the surface

  // the vertices nearest to one, and their share of the area
  std::vector<bool> disk_around(int vertex, double& area) const
  {
    std::vector<bool> result(m_area.size(), false);
    area = 0;
    const Geodesic_distances nearest(m_mesh, m_lengths, {vertex}, [&](int v) {
      if (area >= area_of_disk)
        return false;
      result[v] = true;
      area += m_area[v];
      return true;
    });
    return result;
  }

  const Flat_mesh& m_mesh;
  std::vector<Pole> m_ends;
  std::vector<double> m_area;    // by vertex, as a share of the surface
  std::vector<double> m_lengths; // by edge
  Class_moduli m_moduli;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_POLE_SIGNIFICANCE_H
