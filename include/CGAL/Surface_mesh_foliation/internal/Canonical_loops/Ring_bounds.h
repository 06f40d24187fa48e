// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_RING_BOUNDS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_RING_BOUNDS_H

#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Vertex_potentials.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/Flat_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Pole.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The modulus of the plane without the segment from -1 to 0 and the ray from `distance` to the
// right, Teichmueller's ring: a quotient of complete elliptic integrals, which are inverse
// arithmetic-geometric means.
inline double modulus_of_teichmueller_ring(double distance)
{
  const auto mean = [](double x, double y) {
    constexpr int enough = 40; // digits double each time, once the two are of one size
    for (int i = 0; i < enough && x != y; ++i)
    {
      const double sum = x + y;
      y = std::sqrt(x * y);
      x = sum / 2;
    }
    return x;
  };
  const double k = 1 / std::sqrt(1 + distance);
  return mean(1, k * std::sqrt(distance)) / (2 * mean(1, k));
}

// Which poles are on one side of a loop on a sphere, and which are on the other: those from whose
// first vertex paths to a given one cross the loop an even and an odd number of times.
inline std::array<std::vector<int>, 2> poles_beside(const Flat_mesh& mesh,
                                                    const std::vector<Pole>& poles,
                                                    const Flat_loop& loop)
{
  std::vector<bool> is_crossed(mesh.number_of_edges(), false);
  for (const Flat_crossing& crossing : loop.crossings)
    is_crossed[edge_of(crossing.halfedge)] = !is_crossed[edge_of(crossing.halfedge)];
  std::vector<signed char> side(mesh.number_of_vertices(), -1);
  std::vector<int> stack = {0};
  side[0] = 0;
  while (!stack.empty())
  {
    const int v = stack.back();
    stack.pop_back();
    for (const int h : mesh.ring(v))
      if (side[mesh.target(h)] < 0)
      {
        side[mesh.target(h)] = is_crossed[edge_of(h)] ? 1 - side[v] : side[v];
        stack.push_back(mesh.target(h));
      }
  }
  std::array<std::vector<int>, 2> result;
  for (const Pole& pole : poles)
    result[side[pole[0]]].push_back(pole[0]);
  return result;
}

// Upper bounds for the moduli of annuli that separate some places of a sphere from others: by
// Teichmueller's theorem, an annulus in the plane that separates 0 and z from w and infinity has at
// most the modulus of his ring with |w / z|. This is a ratio of four distances, the same in all
// conformal maps of the sphere to the plane. The potentials of unit sources tell it: where p is the
// source, log |p - q| / 2 pi is the negative potential of q but for terms that belong to p or to q.
class Ring_bounds
{
public:
  // weights: by edge, positive
  Ring_bounds(const Flat_mesh& mesh, const std::vector<double>& weights)
    : m_potentials(mesh, weights)
  {}

  // sides: vertices on one side, and on the other
  double operator()(const std::array<std::vector<int>, 2>& sides)
  {
    double least = (std::numeric_limits<double>::infinity)(); // the logarithm of the ratio / 2 pi
    const std::size_t m = (std::min)(sides[0].size(), enough);
    const std::size_t n = (std::min)(sides[1].size(), enough);
    for (std::size_t p = 0; p < m; ++p)
      for (std::size_t q = 0; q < m; ++q)
        for (std::size_t r = 0; r < n && p != q; ++r)
          for (std::size_t s = 0; s < r; ++s)
            least =
              (std::min)(least, cross_ratio(sides[0][p], sides[0][q], sides[1][r], sides[1][s]));
    return std::isinf(least) ? least
                             : modulus_of_teichmueller_ring(std::exp(2 * std::acos(-1.) * least));
  }

private:
  static constexpr std::size_t enough = 12; // of them, on each side; bounds hold with any number

  // for p = 0, q = z, r = w, s = infinity
  double cross_ratio(int p, int q, int r, int s)
  {
    return between(p, q) + between(r, s) - between(p, r) - between(q, s);
  }

  double between(int p, int q) { return m_potentials.of_kept_source(p)[q]; }

  Vertex_potentials m_potentials;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_RING_BOUNDS_H
