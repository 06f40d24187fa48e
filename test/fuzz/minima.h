// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_FUZZ_MINIMA_H
#define SMF_FUZZ_MINIMA_H

#include "require.h"
#include "systems_from_bytes.h"

#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

// What can be asked of computed minima of the energy. Meshes made of bytes have edges whose weights
// differ by many powers of ten, so that the rounding of one parameter makes forces as large as all
// others: then vertices are not balanced, and the minimum is not exact, as the statistics say. What
// is asked for is bounded by the forces that are left, and so is strict elsewhere.

namespace smf_fuzz {

using Foliation = SMF::Measured_foliation<Mesh>;

// weights, forces and lengths of a foliation
struct Numbers
{
  explicit Numbers(const Foliation& foliation)
  {
    std::vector<double> weight(num_vertices(foliation.mesh())), force(weight.size());
    const auto is_fixed = [&](std::size_t v) {
      return foliation.state().is_fixed(static_cast<int>(v));
    };
    for (const auto e : edges(foliation.mesh()))
      for (const unsigned int end : {0u, 1u})
      {
        const std::size_t v = foliation.mesh().vertex(e, end);
        if (is_fixed(v) && is_fixed(foliation.mesh().vertex(e, 1 - end)))
          continue;
        weight[v] += weight_of(foliation, e);
        force[v] += weight_of(foliation, e) * foliation.edge_value(e);
      }
    const System& system = foliation.system();
    for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
    {
      sum_of_heights += system.height(a);
      largest_height = std::max(largest_height, system.height(a));
    }
    remaining_force =
      foliation.statistics().optimality * *std::max_element(force.begin(), force.end());
    stiffness = *std::max_element(weight.begin(), weight.end());
    // no image of a vertex is farther from its place than all arcs together are long
    remaining_work = remaining_force * static_cast<double>(weight.size()) * sum_of_heights;
  }

  static double weight_of(const Foliation& foliation, Mesh::Edge_index e)
  {
    // (weights are numbered as the package's own edges are)
    return foliation.state().weight(foliation.system().data().mesh_index.edge_index(e));
  }

  double sum_of_heights = 0, largest_height = 0;
  double remaining_force = 0; // the largest of those that are not balanced
  double remaining_work = 0;  // a bound for what the energy may still fall
  double stiffness = 0;       // the force at a vertex per change of its parameter
};

// The solver has converged, or else no force is left that a change of a parameter by a tiny part of
// its arc would not balance: no more can be said with the digits of a parameter.
inline void require_minimum(const Foliation& foliation)
{
  require(foliation.statistics().is_certified, "no certificate");
  const Numbers numbers(foliation);
  require(foliation.statistics().has_converged ||
            numbers.remaining_force <= 1e-10 * numbers.stiffness * numbers.largest_height,
          "not converged: optimality " + std::to_string(foliation.statistics().optimality) +
            ", force " + std::to_string(numbers.remaining_force) + ", stiffness " +
            std::to_string(numbers.stiffness));
}

// Two minima of the same energy are the same. Since it is convex, weighted squares of differences
// add up to no more than the work that the remaining forces of both can do.
inline void require_same_minimum(const Foliation& a, const Foliation& b, const std::string& what)
{
  const double energy = std::max(a.statistics().energy, b.statistics().energy);
  const double work = Numbers(a).remaining_work + Numbers(b).remaining_work;
  const double fall = std::abs(a.statistics().energy - b.statistics().energy);
  require(fall <= 1e-9 * energy + work, what + ": energies differ by " + std::to_string(fall));
  double squares = 0;
  for (const auto e : edges(a.mesh()))
  {
    const double difference = a.edge_value(e) - b.edge_value(e);
    squares += Numbers::weight_of(a, e) * difference * difference;
  }
  require(squares <= 1e-12 * energy + work,
          what + ": values differ by " + std::to_string(std::sqrt(squares / energy)));
}

} // namespace smf_fuzz

#endif // SMF_FUZZ_MINIMA_H
