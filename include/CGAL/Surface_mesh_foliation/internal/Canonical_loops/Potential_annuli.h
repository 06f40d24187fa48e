// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_POTENTIAL_ANNULI_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_POTENTIAL_ANNULI_H

#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Spread_source.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Vertex_potentials.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Pole.h>

#include <Eigen/Core>

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

// Bounds for the modulus of the annuli around a place, outside a cap and away from all poles, from
// potentials: of a unit source in the place, and sinks in the poles. They need a factorization for
// each surface, and a pair of triangular solves for each place and each pole.
//
// From below: with equal sinks in the poles, superlevel sets are disks from the source down to the
// first saddle. What lies between them and the cap is one of the annuli.
//
// From above, on the sphere: a sink in one pole only makes a plane of the sphere without that pole,
// with the place at 0 and potential -log|w| / 2 pi. A disk around 0 that avoids another pole at w
// has at most the conformal radius 4 |w|, by Koebe's quarter theorem, and without the disk |z| < r
// it has at most the modulus log(4 |w| / r) / 2 pi.
//
// Where the cap is not round in that plane, bounds are better if the source is spread over it, in a
// pair of triangular solves for each vertex at its border. The sphere without the cap and the pole
// then is the plane without a disk, and Grötzsch's theorem bounds annuli in the same way.
class Potential_annuli
{
public:
  struct Bounds
  {
    double lower, upper;
  };

  // weights: by edge, positive
  Potential_annuli(const Flat_mesh& mesh, std::vector<double> weights)
    : m_mesh(mesh), m_weights(std::move(weights)), m_potentials(mesh, m_weights)
  {}

  Potential_annuli(const Potential_annuli&) = delete;
  Potential_annuli& operator=(const Potential_annuli&) = delete;

  // Around a vertex, outside a connected cap that contains it. (If the cap contains a pole, or is
  // no disk, so that a pole may lie in a hole of it, the lower bound is 0.)
  Bounds operator()(int vertex, const std::vector<bool>& is_in_cap, const std::vector<Pole>& poles)
  {
    return bounds({m_potentials, {vertex}}, is_in_cap, poles);
  }

  // The same, with the source spread over the cap.
  Bounds around_spread_source(const std::vector<bool>& is_in_cap, const std::vector<Pole>& poles)
  {
    return bounds({m_potentials, border_of(is_in_cap)}, is_in_cap, poles);
  }

private:
  Bounds bounds(const Spread_source& source,
                const std::vector<bool>& is_in_cap,
                const std::vector<Pole>& poles)
  {
    constexpr std::size_t enough = 30; // bounds hold with any number of sinks
    std::vector<int> sinks;
    for (const Pole& pole : poles)
      if (sinks.size() < enough)
        sinks.push_back(pole[0]);
    const bool is_good = is_disk(is_in_cap) && !contains_pole(is_in_cap, poles);
    return {is_good ? lower_bound(source, is_in_cap, poles, of_equal_sinks(sinks)) : 0,
            m_mesh.genus() == 0 ? upper_bound(source, is_in_cap, sinks)
                                : (std::numeric_limits<double>::infinity)()};
  }

  // a connected cap, by its Euler characteristic
  bool is_disk(const std::vector<bool>& is_in_cap) const
  {
    int three_times_characteristic = 0;
    for (int v = 0; v < m_mesh.number_of_vertices(); ++v)
    {
      if (!is_in_cap[v])
        continue;
      three_times_characteristic += 3;
      for (const int h : m_mesh.ring(v))
        if (is_in_cap[m_mesh.target(h)])
        {
          three_times_characteristic -= v < m_mesh.target(h) ? 3 : 0;
          three_times_characteristic += is_in_cap[m_mesh.target(m_mesh.next(h))];
        }
    }
    return three_times_characteristic == 3;
  }

  static bool contains_pole(const std::vector<bool>& is_in_cap, const std::vector<Pole>& poles)
  {
    return std::any_of(poles.begin(), poles.end(), [&](const Pole& pole) {
      return std::any_of(pole.begin(), pole.end(), [&](int v) { return is_in_cap[v]; });
    });
  }

  // all over the surface if there is none
  Eigen::VectorXd of_equal_sinks(const std::vector<int>& sinks)
  {
    const Eigen::Index n = m_mesh.number_of_vertices();
    if (sinks.empty())
      return m_potentials(Eigen::VectorXd::Constant(n, 1. / static_cast<double>(n)));
    Eigen::VectorXd result = Eigen::VectorXd::Zero(n);
    for (const int v : sinks)
      result += m_potentials.of_kept_source(v);
    return result / static_cast<double>(sinks.size());
  }

  // With half of the sinks at the first saddle, the next one may be lower.
  double lower_bound(const Spread_source& source,
                     const std::vector<bool>& is_in_cap,
                     const std::vector<Pole>& poles,
                     const Eigen::VectorXd& of_sinks) const
  {
    Eigen::VectorXd u = source.minus(of_sinks);
    const int saddle = first_saddle(u, is_in_cap, poles);
    const double result = modulus_above(u, u[saddle], is_in_cap);
    u = source.minus((of_sinks + m_potentials.of_source(saddle)) / 2);
    return (std::max)(result, modulus_above(u, u[first_saddle(u, is_in_cap, poles)], is_in_cap));
  }

  // of what lies between a level and the cap
  double modulus_above(const Eigen::VectorXd& u,
                       double bottom,
                       const std::vector<bool>& is_in_cap) const
  {
    double top = (std::numeric_limits<double>::infinity)();
    for (int v = 0; v < m_mesh.number_of_vertices(); ++v)
      if (is_in_cap[v])
        top = (std::min)(top, u[v]);
    const double height = top - bottom;
    return height > 0 ? height * height / energy_between(u, bottom, top) : 0;
  }

  double upper_bound(const Spread_source& source,
                     const std::vector<bool>& is_in_cap,
                     const std::vector<int>& sinks)
  {
    double result = (std::numeric_limits<double>::infinity)();
    if (sinks.size() < 2)
      return result;
    const std::vector<int> border = border_of(is_in_cap);
    for (const int sink : sinks)
    {
      const Eigen::VectorXd u = source.minus(m_potentials.of_kept_source(sink));
      const auto highest = [&](const std::vector<int>& vertices) {
        double height = -(std::numeric_limits<double>::infinity)();
        for (const int v : vertices)
          if (v != sink)
            height = (std::max)(height, u[v]);
        return height;
      };
      result = (std::min)(result, highest(border) - highest(sinks));
    }
    return result + std::log(4.) / (2 * std::acos(-1.));
  }

  // the vertices of a cap with neighbors outside
  std::vector<int> border_of(const std::vector<bool>& is_in_cap) const
  {
    std::vector<int> result;
    for (int v = 0; v < m_mesh.number_of_vertices(); ++v)
      if (is_in_cap[v])
        for (const int h : m_mesh.ring(v))
          if (!is_in_cap[m_mesh.target(h)])
          {
            result.push_back(v);
            break;
          }
    return result;
  }

  // The vertex outside the cap, from the highest potential on, with which those so far are no disk
  // without a pole: if its neighbors among them are not one row of neighbors, or it is in a pole.
  int first_saddle(const Eigen::VectorXd& u,
                   const std::vector<bool>& is_in_cap,
                   const std::vector<Pole>& poles) const
  {
    std::vector<bool> is_in_pole(m_mesh.number_of_vertices(), false);
    for (const Pole& pole : poles)
      for (const int v : pole)
        is_in_pole[v] = true;
    std::vector<int> order(m_mesh.number_of_vertices());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int v, int w) { return u[v] > u[w]; });
    std::vector<bool> is_above = is_in_cap;
    for (const int v : order)
    {
      if (is_in_cap[v])
        continue;
      if (is_in_pole[v] || number_of_changes_around(v, is_above) != 2)
        return v;
      is_above[v] = true;
    }
    return order.back();
  }

  int number_of_changes_around(int v, const std::vector<bool>& is_above) const
  {
    int result = 0;
    for (const int h : m_mesh.ring(v))
      result += is_above[m_mesh.target(h)] != is_above[m_mesh.target(m_mesh.next(h))];
    return result;
  }

  double energy_between(const Eigen::VectorXd& u, double bottom, double top) const
  {
    double result = 0;
    for (int e = 0; e < m_mesh.number_of_edges(); ++e)
    {
      const int h = halfedge_of(e);
      const double difference =
        std::clamp(u[m_mesh.source(h)], bottom, top) - std::clamp(u[m_mesh.target(h)], bottom, top);
      result += m_weights[e] * difference * difference;
    }
    return result;
  }

  const Flat_mesh& m_mesh;
  const std::vector<double> m_weights; // by edge
  Vertex_potentials m_potentials;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_POTENTIAL_ANNULI_H
