// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_LOOP_FINENESS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_LOOP_FINENESS_H

#include <CGAL/Surface_mesh_foliation/internal/Loops/Flat_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/vertex_areas.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// How many times finer a mesh should be near loops that go around thin tubes and handles, so that
// their moduli can be measured; by vertex, at least 1.
class Loop_fineness
{
public:
  // the number of times as many vertices that the finer mesh has at most; more would take too much
  // time where there are many thin handles
  static constexpr double most_growth = 3;

  explicit Loop_fineness(const Flat_mesh& mesh)
    : m_mesh(mesh), m_areas(vertex_areas(mesh)), m_fineness(mesh.number_of_vertices(), 1)
  {}

  // A loop around a ring of k vertices crosses about 2k edges. On tori of revolution that were
  // collapsed to 5,000 vertices, moduli are too large by 0.7% with 16 around, by 2% with 10; where
  // tubes taper, fewer than around the loop are around elsewhere in its annulus.
  static bool is_thin(const Flat_loop& loop)
  {
    return static_cast<double>(loop.crossings.size()) < enough_crossings;
  }

  // What a thin loop needs it gets where its annulus may reach, whose height is its length times
  // its modulus, and less and less up to twice as far; and less where the surface is wider.
  void add(const Flat_loop& loop, double modulus)
  {
    if (!is_thin(loop))
      return;
    std::vector<int> right, left;
    for (const Flat_crossing& crossing : loop.crossings)
    {
      right.push_back(m_mesh.source(crossing.halfedge));
      left.push_back(m_mesh.target(crossing.halfedge));
    }
    const auto crossings = static_cast<double>(loop.crossings.size());
    const double reach = crossings * (0.5 + modulus); // in edges
    add_one_side(right, left, enough_crossings / crossings, reach);
    add_one_side(left, right, enough_crossings / crossings, reach);
  }

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
  static constexpr double enough_crossings = 64;

  // from the ends of the crossed edges on one side, without those on the other one
  void add_one_side(const std::vector<int>& ends,
                    const std::vector<int>& others,
                    double wanted,
                    double reach)
  {
    std::vector<bool> is_reached(m_mesh.number_of_vertices(), false);
    std::vector<int> front;
    const auto visit = [&](int v, std::vector<int>& visited) {
      if (!is_reached[v])
        visited.push_back(v);
      is_reached[v] = true;
    };
    for (const int v : others)
      is_reached[v] = true;
    for (const int v : ends)
      visit(v, front);
    for (int distance = 0; distance <= reach && !front.empty(); ++distance)
    {
      const double here =
        (std::min)(wanted, enough_crossings / (2 * static_cast<double>(front.size())));
      const double faded = (here - 1) * (std::min)(1., 2 * (1 - distance / reach));
      std::vector<int> next;
      for (const int v : front)
      {
        m_fineness[v] = (std::max)(m_fineness[v], 1 + faded);
        for (const int h : m_mesh.ring(v))
          visit(m_mesh.target(h), next);
      }
      front = std::move(next);
    }
  }

  // over the surface, of a power of what the fineness is above 1
  double mean_of_excess(int power) const
  {
    double result = 0;
    for (std::size_t v = 0; v < m_fineness.size(); ++v)
      result += m_areas[v] * std::pow(m_fineness[v] - 1, power);
    return result;
  }

  const Flat_mesh& m_mesh;
  const std::vector<double> m_areas; // as shares
  std::vector<double> m_fineness;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_LOOP_FINENESS_H
