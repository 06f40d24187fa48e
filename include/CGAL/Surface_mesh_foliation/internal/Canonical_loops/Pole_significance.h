// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_POLE_SIGNIFICANCE_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_POLE_SIGNIFICANCE_H

#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Class_moduli.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Potential_annuli.h>
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
#include <optional>
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
  // Lengths are those of chords: the bound on significances was chosen with them.
  // ends: poles that there are already
  Pole_significance(const Flat_mesh& mesh, std::vector<Pole> ends, Poll poll = poll_nobody)
    : m_mesh(mesh),
      m_ends(std::move(ends)),
      m_area(vertex_areas(mesh)),
      m_lengths(edge_lengths(mesh)),
      m_moduli(mesh, m_lengths, m_ends, std::move(poll))
  {}

  // Of a vertex beside the ends and other poles; infinite if a foliation would need it as a pole.
  double operator()(int vertex, const std::vector<int>& others)
  {
    const std::vector<Pole> poles = poles_with(others);
    return is_needed_beside(poles) ? (std::numeric_limits<double>::infinity)()
                                   : beside(poles, vertex, cap_around(vertex), Class_moduli::fine);
  }

  // Whether it is at least so large. Bounds decide most cases, in a small part of the time.
  bool is_at_least(double least, int vertex, const std::vector<int>& others)
  {
    const std::vector<Pole> poles = poles_with(others);
    if (is_needed_beside(poles))
      return true;
    if (!m_annuli)
      m_annuli.emplace(m_moduli.mesh(), m_moduli.weights());
    const Cap cap = cap_around(vertex);
    const double flat = modulus_of_flat_disk(cap);
    for (const bool is_spread : {false, true})
    {
      const auto [lower, upper] = is_spread ? m_annuli->around_spread_source(cap.contains, poles)
                                            : (*m_annuli)(vertex, cap.contains, poles);
      if (lower - flat >= least)
        return true;
      if (upper - flat < least)
        return false;
    }
    return beside(poles, vertex, cap, Class_moduli::coarse) >= least;
  }

private:
  static constexpr double area_of_cap = 0.0025; // as a share of the surface

  struct Cap
  {
    std::vector<bool> contains; // by vertex of the mesh of the moduli
    double area = 0;            // as a share of the surface
  };

  // the vertices nearest to one
  Cap cap_around(int vertex) const
  {
    Cap result;
    result.contains.assign(m_area.size(), false);
    const Geodesic_distances nearest(m_mesh, m_lengths, {vertex}, [&](int v) {
      if (result.area >= area_of_cap)
        return false;
      result.contains[v] = true;
      result.area += m_area[v];
      return true;
    });
    result.contains = m_moduli.on_mesh(std::move(result.contains));
    return result;
  }

  // that is as large as the surface, around a disk as large as the cap
  static double modulus_of_flat_disk(const Cap& cap)
  {
    return -std::log(cap.area) / (4 * std::acos(-1.));
  }

  std::vector<Pole> poles_with(const std::vector<int>& others) const
  {
    std::vector<Pole> result = m_ends;
    for (int v : others)
      result.push_back({v});
    return result;
  }

  bool is_needed_beside(const std::vector<Pole>& poles) const
  {
    return m_mesh.genus() == 0 && poles.size() < 2;
  }

  double beside(std::vector<Pole> poles, int vertex, const Cap& cap, double tolerance)
  {
    poles.push_back({vertex});
    m_moduli.set_poles(poles);
    const int pole = static_cast<int>(poles.size()) - 1;
    return m_moduli.around_cap(pole, cap.contains, tolerance) - modulus_of_flat_disk(cap);
  }

  const Flat_mesh& m_mesh;
  std::vector<Pole> m_ends;
  std::vector<double> m_area;    // by vertex, as a share of the surface
  std::vector<double> m_lengths; // by edge
  Class_moduli m_moduli;
  std::optional<Potential_annuli> m_annuli;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_POLE_SIGNIFICANCE_H
