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
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/require_parameter.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/lengths.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/finish_certified.h>
#include <CGAL/Surface_mesh_foliation/internal/Edge_values/Edge_value_foliation.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/to_loop.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Mesh_index.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/balance.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/checked_flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/edge_weights.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/solver_options.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/user_count.h>
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

// The poles and middle leaves of a foliation, one leaf per component and in the same order.
template <class TriangleMesh>
Poles_and_loops<TriangleMesh> recovered_poles_and_loops(const Edge_value_foliation& foliation,
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
    Loop<TriangleMesh> loop = to_loop(flat, mesh_index);
    const std::vector<int> pole = foliation.pole_at_end(static_cast<int>(a), 0);
    const std::vector<int> other_pole = foliation.pole_at_end(static_cast<int>(a), 1);
    if (pole.empty())
      result.add_loop(std::move(loop), flat.height);
    else if (other_pole.empty())
      result.add_line_pole(vertices(pole), std::move(loop), flat.height);
    else // a sphere, whose two homotopic pole loops form one arc
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
  bool is_same =
    found.components().size() == system.loops.size() && node.size() == system.nodes.size();
  for (int a = 0; is_same && a < system.number_of_arcs(); ++a)
    for (int end : {0, 1})
    {
      int& expected = node[found.components()[a].node[end]];
      if (expected < 0)
        expected = system.node_of_end(a, end);
      is_same = is_same && expected == system.node_of_end(a, end);
    }
  if (!is_same)
    throw Certificate_exception(problem(Problem_kind::CERTIFICATE_FAILURE,
                                        "not certified: the graph of the critical leaves "
                                        "is not the dual graph of the middle leaves"));
}

// Throws if the resulting foliation does not have the given values.
inline void check_same_values(const Foliation_state& state,
                              const std::vector<double>& value,
                              const Edge_value_tolerances& tolerances)
{
  const auto [e, difference] = largest_difference(state, value);
  if (difference <= 10 * tolerances.snap())
    return;
  const int u = state.mesh().source(halfedge_of(e)), v = state.mesh().target(halfedge_of(e));
  throw Certificate_exception(problem(Problem_kind::CERTIFICATE_FAILURE,
                                      "not certified: the value of edge ", u, " ", v, " is ",
                                      length_of_edge(state, e), " instead of ", value[e])
                                .vertices({index(u), index(v)}));
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
  result.tolerance = choose_parameter(get_parameter(np, internal_np::tolerance), result.tolerance);
  const int length = user_count(
    choose_parameter(get_parameter(np, internal_np::max_leaf_length), 1e4 + 10. * number_of_edges));
  require_parameter(
    result.tolerance > 0 && result.tolerance < 0.1 && length >= 0,
    "the tolerance must lie between 0 and 0.1 and the length of leaves must not be negative");
  result.max_leaf_length = static_cast<std::size_t>(length);
  return result;
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationFoliation

builds a measured foliation from values on edges, and from nothing else [Algorithm 2, Sections 5.2.1
to 5.2.5 of the paper]: from values that the user made, that were read from a file, or that a solver
computed. The value of an edge is the transverse measure of the leaves that cross it.

This is the paper's route to the Reeb graph, and it is independent of the one that `Loop_system` and
`harmonic_foliation()` take:
- triangles and vertices with an index other than 0 are found; triangles with a saddle inside are
  subdivided;
- the mesh is cut into a disk with all singularities on its boundary, along shortest paths and, if
  the genus is positive, along the greedy homotopy basis of Erickson and Whittlesey;
- the values are oriented and integrated on the disk, and each cut edge gets its transition
  function, Eq. (2) or (3);
- the critical leaves are traced through the triangles and across the cut until they reach a
  singularity; they cut the edges into intervals, and the intervals form the components, each
  between two levels whose distance is its height;
- a leaf near the middle of each component and the poles form a loop system. Each vertex moves to
  the level where it lies, which gives the foliation its combinatorial form; then it is certified
  like any other.

So the result is a `Measured_foliation` like that of `harmonic_foliation()`, and all later stages
accept it. It need not be harmonic: `statistics().optimality` tells how close it is. Arcs are
numbered in the order in which their components are met along the edges; an arc with one pole has it
at end 0. On a torus without singularities, the leaf through one of the vertices becomes the node.

Here, closed corners of triangles, edges that no leaf crosses, and leaves that meet a singularity
can be recognized only numerically. Let \f$ \tau \f$ be the `tolerance`, and \f$ W \f$ the largest
value of the mesh.
- A corner with the values \f$ a \f$ and \f$ b \f$ at it and \f$ c \f$ opposite is closed if
  \f$ (a + b - c)/2 \f$ is at most \f$ \tau \f$ times the largest of the three.
- Values of at most \f$ \tau W / 10 \f$ may be noise. As few of them as possible are treated as 0 so
  that no pole that is mere noise remains. Values of at most \f$ \tau W / 1000 \f$ are treated as 0
  next to a face with a value larger than \f$ \tau W \f$.
- A leaf that comes within \f$ \tau W \f$ of a singularity ends there. So heights must be larger
  than that.

Values need not be exact: the triangle inequality may be violated by up to \f$ \tau \f$ times the
largest of the three values, and the values of the result may differ from the given ones by up to
\f$ 10 \tau W \f$.

\tparam TriangleMesh see `Loop_system`
\tparam EdgeValueMap a model of `ReadablePropertyMap` with
  `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and a type convertible to
  `double` as value type
\param mesh the mesh; see `Loop_system` for what is required of it. It must outlive the result.
\param edge_value_map the foliation values, finite and not negative
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
  below

\cgalNamedParamsBegin
  \cgalParamNBegin{tolerance}
    \cgalParamDescription{the relative accuracy \f$ \tau \f$ of the values, see above}
    \cgalParamType{`double`, between 0 and 0.1}
    \cgalParamDefault{`1e-9`}
  \cgalParamNEnd
  \cgalParamNBegin{max_leaf_length}
    \cgalParamDescription{the largest number of edges that a critical leaf may cross from one
      singularity to the next; on a torus without singularities, the largest number that the leaf
      through a vertex may cross until it closes}
    \cgalParamType{a number type, not negative}
    \cgalParamDefault{10000 plus 10 times the number of edges}
  \cgalParamNEnd
  \cgalParamNBegin{weights}
    \cgalParamDescription{the weights of the edges, as for `harmonic_foliation()`; they are used
      only for `statistics()` and `Measured_foliation::flux()`}
    \cgalParamType{see `harmonic_foliation()`}
    \cgalParamDefault{`Mean_value_weights()`}
  \cgalParamNEnd
  \cgalParamNBegin{allow_any_weights}
    \cgalParamDescription{whether weights that are not positive are accepted}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `mesh`}
    \cgalParamType{a class model of `ReadablePropertyMap` with
      `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a point type with
      `x()`, `y()` and `z()` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns the foliation

\throws Invalid_mesh_exception as `Loop_system`
\throws Invalid_parameter_exception if a weight is not finite and positive, or a parameter out of
  range
\throws Invalid_foliation_exception naming a vertex or face, if a value is negative or not finite,
  or all are zero, or a triangle inequality is violated (`INVALID_EDGE_VALUE`); if a place with
  positive index is neither a vertex nor a path of edges with value 0 (`INVALID_POLE`): the thorns
  of a foliation must be the ends of such paths; if a leaf does not close within the bound on its
  length (`OPEN_LEAF`); or if different leaves are within the tolerance of each other
  (`UNRESOLVED_LEAF`)
\throws Invalid_loops_exception if the poles and middle leaves do not form a loop system
\throws Certificate_exception if the certificate does not hold, or the result does not have the
  values given

The time is \f$ O(n \log n + l) \f$ for \f$ n \f$ faces and \f$ l \f$ crossings of edges with
critical and middle leaves, which are sorted along each edge.

\sa `edge_values()`, which writes the values of a foliation
*/
template <class TriangleMesh,
          class EdgeValueMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Measured_foliation<TriangleMesh> integrate_foliation(
  const TriangleMesh& mesh,
  const EdgeValueMap& edge_value_map,
  const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_parameters<CGAL::internal_np::vertex_point_t, internal::Weight_parameters,
                             internal_np::tolerance_t, internal_np::max_leaf_length_t>(np);
  const internal::Checked_mesh<TriangleMesh> checked(mesh, np);
  checked.require_no_opening();
  const internal::Mesh_index<TriangleMesh>& mesh_index = checked.index;
  const internal::Flat_mesh& flat = checked.flat;
  std::vector<double> value(flat.number_of_edges());
  for (int e = 0; e < flat.number_of_edges(); ++e)
    value[e] = static_cast<double>(get(edge_value_map, mesh_index.edge_descriptor_of(e)));

  const internal::Integration_options options =
    internal::integration_options(np, flat.number_of_edges());
  const internal::Edge_value_tolerances tolerances(options.tolerance, value);
  const internal::Edge_value_foliation foliation(flat, value, tolerances, options.max_leaf_length);

  const Loop_system<TriangleMesh> system(mesh,
                                         internal::recovered_poles_and_loops(foliation, mesh_index),
                                         internal::select<CGAL::internal_np::vertex_point_t>(np));
  internal::check_same_graph(foliation.components(), system.data().flat);
  auto data = std::make_shared<internal::Foliation_data<TriangleMesh>>(
    system, internal::checked_weights(system, np));
  const internal::Vertex_placement placement(foliation, data->state);
  internal::check_same_values(data->state, value, tolerances);
  data->statistics = internal::balance(data->state);
  data->statistics.has_converged =
    data->statistics.resolved_optimality < internal::Solver_options().tolerance;
  internal::finish_certified(*data);
  return Measured_foliation<TriangleMesh>(std::move(data));
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTEGRATE_FOLIATION_H
