// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SCALAR_REEB_GRAPH_SCALAR_REEB_GRAPH_OF_FLAT_MESH_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SCALAR_REEB_GRAPH_SCALAR_REEB_GRAPH_OF_FLAT_MESH_H

#include <CGAL/Surface_mesh_foliation/internal/Common/compiled.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/Flat_scalar_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/Vertex_order.h>

#include <cstddef>
#include <optional>
#include <vector>

#if CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES
#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/Contour_sweep.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/Disjoint_sets.h>
#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/Leaf_pruning.h>
#endif // CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

CGAL_SURFACE_MESH_FOLIATION_INLINE std::size_t number_of_components(
  const Flat_scalar_reeb_graph& graph);

// the Reeb graph of a function, of simple saddles or folded, and pruned up to a persistence if
// there is one
CGAL_SURFACE_MESH_FOLIATION_INLINE Flat_scalar_reeb_graph
scalar_reeb_graph(const Flat_mesh& mesh,
                  const Vertex_order& order,
                  std::optional<double> persistence,
                  bool has_simple_saddles);

#if CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES

// Merges the nodes at each vertex into one. The arcs between them form a path plus one more arc for
// each handle that the surface has near the critical level; they vanish.
inline void fold_saddles(Flat_scalar_reeb_graph& graph)
{
  std::vector<Flat_scalar_reeb_graph::Node> nodes;
  std::vector<int> new_node;
  for (Flat_scalar_reeb_graph::Node node : graph.nodes)
  {
    if (nodes.empty() || nodes.back().vertex != node.vertex)
    {
      node.step = 0;
      nodes.push_back(node);
    }
    else
    {
      nodes.back().multiplicity += node.multiplicity;
      --nodes.back().genus;
    }
    new_node.push_back(static_cast<int>(nodes.size()) - 1);
  }
  std::vector<Flat_scalar_reeb_graph::Arc> arcs;
  std::vector<int> new_arc; // -1: it vanishes
  std::vector<int> arc_below(nodes.size(), -1);
  for (Flat_scalar_reeb_graph::Arc arc : graph.arcs)
  {
    arc.lower = new_node[arc.lower];
    arc.upper = new_node[arc.upper];
    if (arc.lower == arc.upper)
    {
      ++nodes[arc.lower].genus;
      new_arc.push_back(-1);
      continue;
    }
    new_arc.push_back(static_cast<int>(arcs.size()));
    if (arc_below[arc.upper] < 0)
      arc_below[arc.upper] = new_arc.back();
    arcs.push_back(arc);
  }
  // an arc that vanishes has vertices if others were pruned from it
  for (int& arc : graph.arc_of_vertex)
    arc = new_arc[arc] >= 0 ? new_arc[arc] : arc_below[new_node[graph.arcs[arc].lower]];
  graph.nodes.swap(nodes);
  graph.arcs.swap(arcs);
}

inline void count_vertices_of_arcs(Flat_scalar_reeb_graph& graph)
{
  std::vector<bool> is_node(graph.arc_of_vertex.size(), false);
  for (const auto& node : graph.nodes)
    is_node[node.vertex] = true;
  for (std::size_t v = 0; v < is_node.size(); ++v)
    if (!is_node[v])
      ++graph.arcs[graph.arc_of_vertex[v]].number_of_vertices;
}

CGAL_SURFACE_MESH_FOLIATION_INLINE std::size_t number_of_components(
  const Flat_scalar_reeb_graph& graph)
{
  Disjoint_sets sets(graph.nodes.size());
  for (const auto& arc : graph.arcs)
    sets.union_set(static_cast<std::size_t>(arc.lower), static_cast<std::size_t>(arc.upper));
  std::size_t result = 0;
  for (std::size_t i = 0; i < graph.nodes.size(); ++i)
    result += sets.find_set(i) == i;
  return result;
}

CGAL_SURFACE_MESH_FOLIATION_INLINE Flat_scalar_reeb_graph
scalar_reeb_graph(const Flat_mesh& mesh,
                  const Vertex_order& order,
                  std::optional<double> persistence,
                  bool has_simple_saddles)
{
  Flat_scalar_reeb_graph result = Contour_sweep(mesh, order).take_graph();
  if (persistence)
    Leaf_pruning(result, order, *persistence);
  if (!has_simple_saddles)
    fold_saddles(result);
  count_vertices_of_arcs(result);
  return result;
}

#endif // CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SCALAR_REEB_GRAPH_SCALAR_REEB_GRAPH_OF_FLAT_MESH_H
