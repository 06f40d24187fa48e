// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_EDGE_WEIGHTS_H
#define CGAL_SURFACE_MESH_FOLIATION_EDGE_WEIGHTS_H

#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/Named_parameters.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/weights_of_flat_mesh.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationFoliation

selects mean value weights [Section 5.1 of the paper, \cgalCite{f-mvc-03}]: always positive, so
that, whatever the triangulation, the harmonic foliation exists and has poles only where requested.
Mean value coordinates are not symmetric; the energy uses the mean of both directions,
\f$ \alpha_{ij} = \frac12 \sum (\tan\frac{\psi}{2} + \tan\frac{\psi'}{2}) / |e_{ij}| \f$, where the
sum is over both ends and \f$ \psi, \psi' \f$ are the angles beside the edge there.

On a face that is flat up to rounding, tangents grow without bound; so their sum counts as at most
100,000, and the length of an edge as at least 1e-8 of the longest edge of its faces. Then such
faces, as long as they are not exactly degenerate, do no harm.
*/
struct Mean_value_weights
{};

/*!
\ingroup PkgSurfaceMeshFoliationFoliation

selects cotangent weights \f$ \alpha_{ij} = \frac12 (\cot\theta + \cot\theta') \f$
\cgalCite{mdsb-ddgo-02}, with the angles opposite the edge. They are positive exactly where the mesh
is Delaunay; elsewhere they are rejected unless the named parameter `allow_any_weights` says
otherwise, and then nothing is guaranteed. The sum of the cotangents counts as at most 100,000.
*/
struct Cotangent_weights
{};

namespace internal {

template <class TriangleMesh>
std::vector<double> weights_of(const Loop_system<TriangleMesh>& system,
                               Mean_value_weights,
                               const Executor& executor)
{
  return mean_value_weights(system.data().flat.mesh, executor);
}

template <class TriangleMesh>
std::vector<double> weights_of(const Loop_system<TriangleMesh>& system,
                               Cotangent_weights,
                               const Executor& executor)
{
  return cotangent_weights(system.data().flat.mesh, executor);
}

template <class TriangleMesh, class EdgeWeightMap>
std::vector<double> weights_of(const Loop_system<TriangleMesh>& system,
                               EdgeWeightMap map,
                               const Executor&) // a map may not be thread-safe
{
  const auto& mesh_index = system.data().mesh_index;
  const int n = system.data().flat.mesh.number_of_edges();
  std::vector<double> result(n, 0);
  for (int e = 0; e < n; ++e)
    if (mesh_index.has_edge(e))
      result[e] = CGAL::to_double(get(map, mesh_index.edge_descriptor_of(e)));
  return result;
}

inline void check_weights(const Flat_mesh& mesh, const std::vector<double>& weights, bool allow_any)
{
  for (std::size_t e = 0; e < weights.size(); ++e)
  {
    const int h = halfedge_of(static_cast<int>(e));
    const bool is_unused = // no leaf crosses it
      mesh.is_cap_edge(edge_of(h)) || mesh.is_border_edge(edge_of(h));
    if (std::isfinite(weights[e]) && (allow_any || is_unused || weights[e] > 0))
      continue;
    const char* const help =
      std::isfinite(weights[e])
        ? "; the named parameter allow_any_weights accepts it (cotangent weights are positive on "
          "an intrinsically Delaunay mesh, mean value weights on every one)"
        : "";
    throw Invalid_parameter_exception(problem(Problem_kind::INVALID_WEIGHT,
                                              "the weight of the edge between the vertices ",
                                              mesh.source(h), " and ", mesh.target(h), " is ",
                                              weights[e], ", not positive and finite", help)
                                        .vertices({index(mesh.source(h)), index(mesh.target(h))}));
  }
}

using Weight_parameters = Parameter_list<internal_np::weights_t, internal_np::allow_any_weights_t>;

// the values of `Weight_parameters`, checked
template <class TriangleMesh, class NamedParameters>
std::vector<double> checked_weights(const Loop_system<TriangleMesh>& system,
                                    const NamedParameters& np,
                                    const Executor& executor = executor_for<CGAL::Sequential_tag>())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  std::vector<double> result = weights_of(
    system, choose_parameter(get_parameter(np, internal_np::weights), Mean_value_weights()),
    executor);
  check_weights(system.data().flat.mesh, result,
                choose_parameter(get_parameter(np, internal_np::allow_any_weights), false));
  return result;
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationFoliation

writes edge weights to a property map, in linear time.

\tparam Weights `Mean_value_weights` or `Cotangent_weights`
\tparam EdgeWeightMap a model of `WritablePropertyMap` with
  `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and a type constructible from
  `double` as value type
\param system a loop system, whose mesh is used
\param weights which weights
\param map the map to write to
*/
template <class TriangleMesh, class Weights, class EdgeWeightMap>
void edge_weights(const Loop_system<TriangleMesh>& system, Weights weights, EdgeWeightMap map)
{
  const std::vector<double> result =
    internal::weights_of(system, weights, internal::executor_for<CGAL::Sequential_tag>());
  const auto& mesh_index = system.data().mesh_index;
  for (int e = 0; e < system.data().flat.mesh.number_of_edges(); ++e)
    if (mesh_index.has_edge(e))
      put(map, mesh_index.edge_descriptor_of(e), result[e]);
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_EDGE_WEIGHTS_H
