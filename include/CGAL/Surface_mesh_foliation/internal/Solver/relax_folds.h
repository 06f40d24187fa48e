// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_RELAX_FOLDS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_RELAX_FOLDS_H

#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Singular_places.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Progress.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/relax_vertex.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// where the certificate would find a fold: vertices singular inside an arc, and poles not given
inline std::vector<int> vertices_in_folds(const Foliation_state& state)
{
  std::vector<int> result = vertices_singular_in_arcs(state);
  const Singular_places singular(state);
  for (const Singular_place& place : singular.places())
    if (place.index > 0 && !place.is_face && !state.is_fixed(place.place))
      result.push_back(place.place);
  return result;
}

// Smooths out folds without a linear system: by a few sweeps over all vertices, then over those
// near the remaining folds, in growing neighborhoods, as long as the total work is about that of
// one linear system. Some folds may remain even so. Returns whether vertices may have been moved.
inline bool relax_folds(Foliation_state& state, const Poll& poll)
{
  constexpr int sweeps_of_all = 10, sweeps_near_folds = 20, most_sweeps = 60;
  std::vector<int> folds = vertices_in_folds(state);
  if (folds.empty())
    return false;
  poll();
  std::vector<int> all(state.mesh().number_of_vertices());
  std::iota(all.begin(), all.end(), 0);
  const auto n = static_cast<double>(all.size());
  relax_band(state, all, 0, sweeps_of_all);
  double work = n * sweeps_of_all; // in moves of a vertex
  for (int rings = 4;; rings *= 2)
  {
    poll();
    folds = vertices_in_folds(state);
    const double size_of_band =
      (std::min)(n, 3. * rings * rings * static_cast<double>(folds.size()));
    work += size_of_band * sweeps_near_folds;
    if (folds.empty() || work > n * most_sweeps)
      return true;
    relax_band(state, folds, rings, sweeps_near_folds);
  }
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_RELAX_FOLDS_H
