// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_LOOP_FINENESS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_LOOP_FINENESS_H

#include <CGAL/Surface_mesh_foliation/internal/Loops/Flat_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// How many times finer a mesh should be near loops so that their moduli can be measured; by vertex,
// at least 1. A loop may be drawn anywhere in its annulus, so what counts is not how many edges it
// crosses, but how many vertices are at each distance from it, around the annulus: where the
// surface is thin or narrow, there are few.
class Loop_fineness
{
public:
  // the number of times as many vertices that the finer mesh has at most; more would take too much
  // time where there are many thin handles
  static constexpr double most_growth = 3;

  explicit Loop_fineness(const Flat_mesh& mesh)
    : m_mesh(mesh), m_fineness(mesh.number_of_vertices(), 1)
  {}

  void add(const Flat_loop& loop, double modulus)
  {
    std::vector<int> right, left;
    for (const Flat_crossing& crossing : loop.crossings)
    {
      right.push_back(m_mesh.source(crossing.halfedge));
      left.push_back(m_mesh.target(crossing.halfedge));
    }
    add_one_side(right, left, modulus);
    add_one_side(left, right, modulus);
  }

  // whether few vertices are around a good part of the annulus of a loop that was added
  bool is_needed() const { return m_is_needed; }

  // by vertex; where the mesh would grow too much, the same part of the excess everywhere
  std::vector<double> fineness() const
  {
    // With a part x of it, the number of vertices grows by the factor 1 + 2 excess x + square x^2.
    const double excess = mean_of_excess(1), square = mean_of_excess(2);
    std::vector<double> result = m_fineness;
    if (1 + 2 * excess + square > most_growth)
    {
      const double part =
        (std::sqrt(excess * excess + square * (most_growth - 1)) - excess) / square;
      for (double& f : result)
        f = 1 + part * (f - 1);
    }
    return result;
  }

  // of a mesh that is finer by that much
  double number_of_vertices() const
  {
    return (std::min)(most_growth, 1 + 2 * mean_of_excess(1) + mean_of_excess(2)) *
           m_mesh.number_of_vertices();
  }

private:
  // On tori of revolution that were collapsed to 5,000 vertices, moduli are too large by 0.7% with
  // 16 vertices around, by 2% with 10; between poles, they are too small.
  static constexpr double few_around = 16;
  static constexpr double enough_around = 32;
  static constexpr double thin_share = 0.25; // of a modulus; the error is that share of these
  static constexpr double finest = 5; // lest rings of a few vertices take all that there may be

  // From the ends of the crossed edges on one side, away from those on the other one. A ring of k
  // vertices, an edge high, has the modulus 1 / k, and the annulus ends where these add up to its
  // own modulus, or before. Fineness fades away from there to about twice as far. (Where the
  // surface branches, the parts of a ring count together.)
  void add_one_side(const std::vector<int>& ends, const std::vector<int>& others, double modulus)
  {
    std::vector<bool> is_reached(m_mesh.number_of_vertices(), false);
    std::vector<int> ring;
    const auto visit = [&](int v, std::vector<int>& visited) {
      if (!is_reached[v])
        visited.push_back(v);
      is_reached[v] = true;
    };
    for (const int v : others)
      is_reached[v] = true;
    for (const int v : ends)
      visit(v, ring);
    const double reach = 2 * modulus + 1;
    double way = 0, thin_way = 0;
    while (way < reach && !ring.empty())
    {
      const auto around = static_cast<double>(ring.size());
      const double excess = std::clamp(enough_around / around, 1., finest) - 1;
      if (around < few_around && way <= modulus)
        thin_way += 1 / around;
      const double faded = excess * (std::min)(1., 2 * (1 - way / reach));
      std::vector<int> next;
      for (const int v : ring)
      {
        m_fineness[v] = (std::max)(m_fineness[v], 1 + faded);
        if (!m_mesh.is_cap_vertex(v))
          for (const int h : m_mesh.ring(v))
            visit(m_mesh.target(h), next);
      }
      ring = std::move(next);
      way += 1 / around;
    }
    m_is_needed = m_is_needed || thin_way > thin_share * modulus;
  }

  // over the vertices, of a power of what the fineness is above 1
  double mean_of_excess(int power) const
  {
    double result = 0;
    for (const double f : m_fineness)
      result += std::pow(f - 1, power);
    return result / static_cast<double>(m_fineness.size());
  }

  const Flat_mesh& m_mesh;
  std::vector<double> m_fineness;
  bool m_is_needed = false;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_LOOP_FINENESS_H
