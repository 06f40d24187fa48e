// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_REEB_GRAPH_SYMMETRIES_H
#define CGAL_SURFACE_MESH_FOLIATION_REEB_GRAPH_SYMMETRIES_H

#include <CGAL/Surface_mesh_foliation/internal/Common/Disjoint_sets.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/check_parameters.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/require_parameter.h>
#include <CGAL/Surface_mesh_foliation/internal/Matching/Graph_symmetries.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_matching.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationMatching

contains the symmetries of a Reeb graph; see `reeb_graph_symmetries()`.

\tparam Graph the type of the graph
*/
template <class Graph>
struct Reeb_graph_symmetries
{
  using Node = typename boost::graph_traits<Graph>::vertex_descriptor;
  using Arc = typename boost::graph_traits<Graph>::edge_descriptor;

  /// is one symmetry.
  struct Symmetry
  {
    std::vector<Node> nodes; ///< the images of the nodes, in the order of `vertices(graph)`
    std::vector<Arc> arcs;   ///< the images of the arcs, in the order of `edges(graph)`
  };

  /// symmetries from which all others can be composed; none if the graph is not symmetric
  std::vector<Symmetry> generators;
  /// for each node, in the order of `vertices(graph)`, the position there of the first one that a
  /// symmetry exchanges it with, or its own
  std::vector<std::size_t> node_classes;
  /// the same for arcs, in the order of `edges(graph)`
  std::vector<std::size_t> arc_classes;
  /// whether there may be more symmetries: the graph has more than 2,000 nodes and arcs, and none
  /// was looked for, or a search was given up, which only graphs with many parallel cycles need
  /// fear
  bool is_incomplete = false;
};

/*!
\ingroup PkgSurfaceMeshFoliationMatching

finds the symmetries of a shape from its Reeb graph [Section 6.2 of the paper]: the ways to exchange
nodes and arcs that keep which of them meet, the kinds of nodes, and, up to a tolerance, the lengths
of embedded arcs, the areas of components and the fluxes of arcs. If all loops have the same height,
equal fluxes are equal moduli of components.

Of a body, for example, the two arms are exchanged, and independently the two legs, since a graph
does not know that left is left; of a jug with three handles, the handles in a cycle. These are
intrinsic symmetries: they do not change when the shape bends.

\tparam Graph see `reeb_graphs_are_isomorphic()`
\param graph the graph, usually with \ref SMFCanonical "canonical loops"
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
  below

\cgalNamedParamsBegin
  \cgalParamNBegin{tolerance}
    \cgalParamDescription{the largest difference of two lengths, areas or fluxes that count as
      equal, as a share of the larger one. Symmetries are composed
      of others, so of more than two arcs in a class, two may differ by more.}
    \cgalParamType{`double`, from 0 to 1}
    \cgalParamDefault{0.2}
  \cgalParamNEnd
  \cgalParamNBegin{node_map, arc_map}
    \cgalParamDescription{as for `match_reeb_graphs()`}
    \cgalParamDefault{the bundled properties}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns generators of the group of symmetries, and which nodes and arcs they exchange

\throws Invalid_parameter_exception if the tolerance is out of its range, or a length, area or flux
  is negative or not finite

The search tries images one after another, in the order of the graph, and is given up after a
million steps for one symmetry. Trees take \f$ O(n^3) \f$ time for \f$ n \f$ nodes.
*/
template <class Graph, class NamedParameters = CGAL::parameters::Default_named_parameters>
Reeb_graph_symmetries<Graph> reeb_graph_symmetries(
  const Graph& graph, const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  internal::check_parameters<internal::Graph_map_parameters, internal_np::tolerance_t>(np);
  const double tolerance = choose_parameter(get_parameter(np, internal_np::tolerance), 0.2);
  internal::require_parameter(tolerance >= 0 && tolerance <= 1,
                              "the tolerance of symmetries does not lie between 0 and 1");
  internal::Numbered_graph<Graph> numbered(graph, np, false);
  numbered.add_shares(graph, np);
  const internal::Graph_symmetries symmetries(numbered.labeled, tolerance);
  const std::size_t n = numbered.nodes.size(), size = n + numbered.arcs.size();
  Reeb_graph_symmetries<Graph> result;
  result.is_incomplete = symmetries.is_incomplete();
  internal::Disjoint_sets orbits(size);
  for (const internal::Graph_symmetries::Permutation& permutation : symmetries.generators())
  {
    typename Reeb_graph_symmetries<Graph>::Symmetry symmetry;
    for (std::size_t x = 0; x < size; ++x)
    {
      const auto image = static_cast<std::size_t>(permutation[x]);
      orbits.union_set(x, image);
      if (x < n)
        symmetry.nodes.push_back(numbered.nodes[image]);
      else
        symmetry.arcs.push_back(numbered.arcs[image - n]);
    }
    result.generators.push_back(std::move(symmetry));
  }
  std::vector<std::size_t> first(size, size); // by set
  for (std::size_t x = 0; x < size; ++x)
  {
    std::size_t& least = first[orbits.find_set(x)];
    least = (std::min)(least, x);
    if (x < n)
      result.node_classes.push_back(least);
    else
      result.arc_classes.push_back(least - n);
  }
  return result;
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_REEB_GRAPH_SYMMETRIES_H
