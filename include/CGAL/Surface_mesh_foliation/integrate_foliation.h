// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTEGRATE_FOLIATION_H
#define CGAL_SURFACE_MESH_FOLIATION_INTEGRATE_FOLIATION_H

#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>
#include <CGAL/Surface_mesh_foliation/Poles_and_loops.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Certificate.h>
#include <CGAL/Surface_mesh_foliation/internal/Edge_value_foliation.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh_index.h>
#include <CGAL/Surface_mesh_foliation/internal/balance.h>
#include <CGAL/Surface_mesh_foliation/internal/checked_flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/solver_parameters.h>
#include <CGAL/Surface_mesh_foliation/internal/user_count.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

namespace internal {

// The poles and middle leaves of a foliation, one per component and in their order.
template <class TriangleMesh>
Poles_and_loops<TriangleMesh> poles_and_loops(const Edge_value_foliation& foliation,
                                              const Mesh_index<TriangleMesh>& mesh_index)
{
  Poles_and_loops<TriangleMesh> result;
  const auto vertices = [&](const std::vector<int>& pole) {
    std::vector<typename Mesh_index<TriangleMesh>::vertex_descriptor> list;
    for (int v : pole)
      list.push_back(mesh_index.vertex(v));
    return list;
  };
  for (std::size_t a = 0; a < foliation.components().components().size(); ++a)
  {
    const Flat_loop& flat = foliation.middle_leaves().loops()[a];
    Loop<TriangleMesh> loop;
    for (const Flat_crossing& crossing : flat.crossings)
      loop.push_back({mesh_index.halfedge_descriptor_of(crossing.halfedge), crossing.position});
    const std::vector<int> pole = foliation.pole_at_end(static_cast<int>(a), 0);
    const std::vector<int> other_pole = foliation.pole_at_end(static_cast<int>(a), 1);
    if (pole.empty())
      result.add_loop(std::move(loop), flat.height);
    else if (other_pole.empty())
      result.add_line_pole(vertices(pole), std::move(loop), flat.height);
    else // a sphere, whose two homotopic pole loops are one arc
    {
      result.add_line_pole(vertices(pole), std::move(loop), flat.height / 2);
      result.add_line_pole(vertices(other_pole), flat.height / 2);
    }
  }
  return result;
}

// Throws if the ends of the components are not those of the arcs, up to the names of nodes.
inline void check_same_graph(const Edge_value_components& found, const Flat_loop_system& system)
{
  std::vector<int> node(found.number_of_nodes(), -1);
  bool is_same = found.components().size() == system.loops.size() &&
                 node.size() == system.nodes.size();
  for (std::size_t a = 0; is_same && a < system.loops.size(); ++a)
    for (int end : {0, 1})
    {
      int& expected = node[found.components()[a].node[end]];
      if (expected < 0)
        expected = system.node_of_end[2 * a + end];
      is_same = is_same && expected == system.node_of_end[2 * a + end];
    }
  if (!is_same)
    throw Certificate_exception(
      {Problem_kind::CERTIFICATE_FAILURE,
       "not certified: the graph of the critical leaves is not the dual graph of the middle leaves",
       {},
       {},
       {}});
}

// Throws if the foliation that was made does not have the values that were given.
inline void check_same_values(const Foliation_state& state,
                              const std::vector<double>& value,
                              const Edge_value_tolerances& tolerances)
{
  const auto [e, difference] = largest_difference(state, value);
  if (difference <= 10 * tolerances.snap())
    return;
  const int u = state.mesh().source(2 * e), v = state.mesh().target(2 * e);
  throw Certificate_exception(
    {Problem_kind::CERTIFICATE_FAILURE,
     text("not certified: the value of edge ", u, " ", v, " is ", state.length(e), " instead of ",
          value[e]),
     {index(u), index(v)},
     {},
     {}});
}

// how near a foliation is to the harmonic one
inline Foliation_statistics statistics_of(const Foliation_state& state)
{
  const Balance now = balance(state);
  Foliation_statistics result;
  result.energy = now.energy;
  result.optimality = now.optimality;
  result.has_converged = now.resolved_optimality < Solver_options().tolerance;
  return result;
}

struct Integration_options
{
  double tolerance = 1e-9;
  std::size_t max_leaf_length = 0;
};

// the named parameters `tolerance` and `max_leaf_length`
template <class NamedParameters>
Integration_options integration_options(const NamedParameters& np, int number_of_edges)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  Integration_options result;
  result.tolerance =
    choose_parameter(get_parameter(np, internal_np::tolerance), result.tolerance);
  const int length = user_count(
    choose_parameter(get_parameter(np, internal_np::max_leaf_length), 10000 + 10 * number_of_edges));
  if (!(result.tolerance > 0 && result.tolerance < 0.1) || length < 0)
    throw Invalid_parameter_exception(
      {Problem_kind::INVALID_PARAMETER,
       "the tolerance must lie between 0 and 0.1 and the length of leaves must not be negative",
       {},
       {},
       {}});
  result.max_leaf_length = static_cast<std::size_t>(length);
  return result;
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationFoliation

DOC
*/
template <class TriangleMesh,
          class EdgeValueMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Measured_foliation<TriangleMesh> integrate_foliation(
  const TriangleMesh& mesh,
  const EdgeValueMap& edge_value_map,
  const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_parameters<internal_np::tolerance_t, internal_np::max_leaf_length_t,
                             internal_np::weights_t, internal_np::allow_any_weights_t,
                             CGAL::internal_np::vertex_point_t>(np);
  internal::Mesh_index<TriangleMesh> mesh_index(mesh);
  internal::Flat_mesh flat;
  const std::vector<Problem> problems = internal::build_flat_mesh(np, mesh_index, flat);
  if (!problems.empty())
    throw Invalid_mesh_exception(problems[0]);
  std::vector<double> value(flat.number_of_edges());
  for (int e = 0; e < flat.number_of_edges(); ++e)
    value[e] = static_cast<double>(
      get(edge_value_map, edge(mesh_index.halfedge_descriptor_of(2 * e), mesh)));

  const internal::Integration_options options =
    internal::integration_options(np, flat.number_of_edges());
  const internal::Edge_value_tolerances tolerances(options.tolerance, value);
  const internal::Edge_value_foliation foliation(flat, value, tolerances, options.max_leaf_length);

  const Loop_system<TriangleMesh> system(
    mesh, internal::poles_and_loops(foliation, mesh_index),
    internal::select<CGAL::internal_np::vertex_point_t>(np));
  internal::check_same_graph(foliation.components(), system.data().flat);
  auto data = std::make_shared<internal::Foliation_data<TriangleMesh>>(
    system, internal::checked_weights(system, np));
  internal::Vertex_placement(foliation, data->state);
  internal::check_same_values(data->state, value, tolerances);
  data->statistics = internal::statistics_of(data->state);
  data->certificate.emplace(data->state);
  if (!data->certificate->problems().empty())
    throw Certificate_exception(data->certificate->problems().front());
  data->statistics.is_certified = true;
  return Measured_foliation<TriangleMesh>(std::move(data));
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTEGRATE_FOLIATION_H
