// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_EXTRACTION_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_EXTRACTION_H

#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Singular_places.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/lengths.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/Leaf_graph.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/Level_tracer.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/Refined_mesh.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// What is extracted from a foliation: a value that `certify()` checks and that later stages read.
// Letters, words and frames: see the glossary in ARCHITECTURE.md.
struct Extraction
{
  explicit Extraction(const Foliation_state& state);

  std::vector<Singular_place> singular_places;
  Refined_mesh refined_mesh;
  Leaf_graph leaf_graph; // of `refined_mesh`
  // By arc: the crossings of its leaves at half its height, ordered by edge. One of these leaves is
  // homotopic to the loop. (Where the foliation is flat up to rounding, there may also be
  // null-homotopic ones.)
  std::vector<std::vector<Leaf_crossing>> middle_leaves;
  std::vector<double> flux; // by arc: sum of weight times length over these edges
};

// the level of the middle leaf of each arc
inline std::vector<double> middle_levels(const Flat_loop_system& system)
{
  std::vector<double> result;
  for (int a = 0; a < system.number_of_arcs(); ++a)
    result.push_back(system.height(a) / 2);
  return result;
}

inline std::vector<std::vector<Leaf_crossing>> middle_leaves(const Foliation_state& state)
{
  const std::vector<double> levels = middle_levels(state.system());
  const Level_tracer tracer(state);
  using Arc_crossing = std::pair<int, Leaf_crossing>;
  const std::vector<Arc_crossing> all = collected_numbers<Arc_crossing>(
    state.executor(), state.mesh().number_of_edges(), [&](int e, std::vector<Arc_crossing>& list) {
      tracer.for_each_crossing(e, levels, [&](int arc, int cell) {
        list.push_back({arc, {halfedge_of(e), cell}});
      });
    });
  std::vector<std::vector<Leaf_crossing>> result(levels.size());
  for (const auto& [arc, crossing] : all)
    result[arc].push_back(crossing);
  return result;
}

inline std::vector<double> flux_of_leaves(const Foliation_state& state,
                                          const std::vector<std::vector<Leaf_crossing>>& leaves)
{
  std::vector<double> result(leaves.size(), 0);
  for (std::size_t a = 0; a < leaves.size(); ++a)
    for (const Leaf_crossing& crossing : leaves[a])
    {
      const int e = edge_of(crossing.halfedge);
      result[a] += state.weight(e) * length_of_edge(state, e);
    }
  return result;
}

inline Extraction::Extraction(const Foliation_state& state)
  : singular_places(Singular_places(state).places()),
    refined_mesh(Refinement(state).result()),
    leaf_graph(refined_mesh),
    middle_leaves(internal::middle_leaves(state)),
    flux(flux_of_leaves(state, middle_leaves))
{}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_EXTRACTION_H
