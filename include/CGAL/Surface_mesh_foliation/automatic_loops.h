// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_AUTOMATIC_LOOPS_H
#define CGAL_SURFACE_MESH_FOLIATION_AUTOMATIC_LOOPS_H

#include <CGAL/Surface_mesh_foliation/internal/Common/compiled.h>
#include <CGAL/Surface_mesh_foliation/Loop.h>
#include <CGAL/Surface_mesh_foliation/Poles_and_loops.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/loop_checks.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/to_loop.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Mesh_index.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Border_poles.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/checked_flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/require_parameter.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#if CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES
#include <CGAL/Surface_mesh_foliation/internal/Automatic_loops/Proposed_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Automatic_loops/Sweep.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Geodesic_distances.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/vertex_farthest_from_centroid.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>
#endif // CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES

namespace CGAL {
namespace Surface_mesh_foliation {

namespace internal {

template <class TriangleMesh>
std::vector<Pole> poles_to_sweep_from(const Poles_and_loops<TriangleMesh>& input,
                                      const Mesh_index<TriangleMesh>& index,
                                      const Capped_mesh& capped)
{
  std::vector<Pole> result;
  Problems problems;
  Border_poles<TriangleMesh> border_poles(index, capped);
  for (std::size_t a = 0; a < input.size(); ++a)
  {
    const auto& entry = input.entries()[a];
    if (!entry.is_pole_loop() || !entry.loop.empty())
      throw Invalid_loops_exception(
        problem(Problem_kind::INVALID_LOOP, "loop ", a,
                " is given: loops are proposed only for poles with the loops that hug them")
          .loops({a}));
    Pole pole;
    if (entry.pole.empty())
      pole = border_poles(entry.border, static_cast<int>(a), problems);
    for (const auto v : entry.pole)
      pole.push_back(index.find(v));
    result.push_back(std::move(pole));
  }
  border_poles.check_all(problems);
  if (problems.empty())
    check_poles(capped.mesh, result, problems);
  if (problems.empty())
    return result;
  if (is_about_mesh(problems[0].kind))
    throw Invalid_mesh_exception(problems[0]);
  throw Invalid_loops_exception(problems[0]);
}

CGAL_SURFACE_MESH_FOLIATION_INLINE std::vector<double> geodesic_sweep(
  const Flat_mesh& mesh, const std::vector<Pole>& poles);

#if CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES
CGAL_SURFACE_MESH_FOLIATION_INLINE std::vector<double> geodesic_sweep(
  const Flat_mesh& mesh, const std::vector<Pole>& poles)
{
  std::vector<int> sources;
  for (const Pole& pole : poles)
    sources.insert(sources.end(), pole.begin(), pole.end());
  if (sources.empty())
    sources = {vertex_farthest_from_centroid(mesh)};
  return Geodesic_distances(mesh, sources).distances();
}
#endif // CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES

// caps are made constant later, like all poles
template <class TriangleMesh, class VertexScalarMap>
std::vector<double> values_of_function(const Mesh_index<TriangleMesh>& index,
                                       const Capped_mesh& capped,
                                       VertexScalarMap function)
{
  std::vector<double> result;
  for (int v = 0; index.has_vertex(v); ++v)
  {
    result.push_back(CGAL::to_double(get(function, index.vertex(v))));
    if (!std::isfinite(result.back()))
    {
      const std::size_t position = static_cast<std::size_t>(v);
      throw Invalid_parameter_exception(
        problem(Problem_kind::NOT_FINITE, "the value at ", vertex_name(position), " is not finite")
          .vertices({position}));
    }
  }
  for (const Border& opening : capped.openings)
    result.push_back(result[opening[0]]);
  return result;
}

struct Proposal_options
{
  bool uses_poles_as_punctures = false;
  double min_loop_length = 0;
  double min_relative_loop_length = 0;
};

template <class NamedParameters>
Proposal_options proposal_options(const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  Proposal_options o;
  o.uses_poles_as_punctures =
    choose_parameter(get_parameter(np, internal_np::use_poles_as_punctures), false);
  o.min_loop_length = choose_parameter(get_parameter(np, internal_np::min_loop_length), 0.);
  o.min_relative_loop_length =
    choose_parameter(get_parameter(np, internal_np::min_relative_loop_length), 0.);
  for (double length : {o.min_loop_length, o.min_relative_loop_length})
    require_parameter(length >= 0, "the least length of a loop is ", length, ", not at least 0");
  return o;
}

CGAL_SURFACE_MESH_FOLIATION_INLINE std::vector<Flat_loop> proposed_loops(
  const Flat_mesh& mesh,
  const std::vector<Pole>& poles,
  std::vector<double> values,
  const Proposal_options& options);

#if CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES
CGAL_SURFACE_MESH_FOLIATION_INLINE std::vector<Flat_loop> proposed_loops(
  const Flat_mesh& mesh,
  const std::vector<Pole>& poles,
  std::vector<double> values,
  const Proposal_options& options)
{
  const Sweep sweep(std::move(values), poles);
  Proposed_loops proposed(mesh, poles, sweep);
  proposed.reduce(options.uses_poles_as_punctures);
  const double bound =
    (std::max)(options.min_loop_length,
               options.min_relative_loop_length > 0
                 ? options.min_relative_loop_length * diagonal(bounding_box(mesh.points()))
                 : 0);
  if (bound > 0)
    proposed.fill_handles_shorter_than(bound, options.uses_poles_as_punctures);
  return proposed.loops();
}
#endif // CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationFeatures

adds to a collection of poles the loops that a foliation of the surface needs to show its handles
[Section 4.2 of the paper]. With them, `Loop_system` accepts the collection, its dual graph has
exactly \f$ g \f$ independent cycles on a surface of genus \f$ g \f$, and all of its nodes have
genus 0, unless small handles are left out. (On a sphere, two poles are needed.)

A function sweeps over the surface: by default the geodesic distance from the nearest pole, or, if
there is no pole, from the vertex farthest from the centroid of the surface. Its level sets split
and join at its saddles, which are the critical moves of the paper; here they do not depend on the
order in which leaves spread. There is one candidate for each arc of its Reeb graph (see
`reeb_graph_of_function()`): a level set halfway between the ends of the arc. Saddles of higher
multiplicity are unfolded, so that the candidates cut the surface into planar pieces.

Candidates that are superfluous [Section 4.2.2] are dropped:
- the loops that are contractible in the surface, as if it had no poles; so on a sphere none
  remains, and the graph is a star. With `use_poles_as_punctures(true)`, only those that bound a
  disk with at most one pole; then there are also loops between groups of poles.
- of loops that are homotopic in the surface minus its poles, all but the one of the arc with the
  largest difference of values.

Both are decided by Euler characteristics, without tracing a loop.

Nothing depends on the order of vertices and faces, except where values are equal, as on a symmetric
mesh: of two vertices with the same value, the one that comes first in `vertices(mesh)` counts as
lower. The distances are computed by Dijkstra's algorithm with steps across triangles
\cgalCite{ks-cgpm-98}; unlike those of the heat method, they do not change with the order, not even
  by rounding.

\tparam TriangleMesh see `Loop_system`
\param mesh a mesh that `Loop_system` accepts
\param poles_and_loops poles without loops of their own, to which loops of height 1 are added; it
  may be empty
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
  below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{as for `Loop_system`}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_scalar_map}
    \cgalParamDescription{the function that sweeps over the surface, finite. Along a line pole it
      is taken to be constant, with the least of the values there.}
    \cgalParamType{a class model of `ReadablePropertyMap` with
      `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a number type as value
      type}
    \cgalParamDefault{the distance from the nearest pole}
  \cgalParamNEnd
  \cgalParamNBegin{use_poles_as_punctures}
    \cgalParamDescription{whether a loop is contractible only if it bounds a disk with at most one
      pole}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{min_loop_length}
    \cgalParamDescription{the least length of a loop around a handle. The handle of a shorter loop
      is not shown: all loops of the shortest cycle through its arc are dropped, and then those that
      are contractible or homotopic once the handle is considered filled. Its genus then belongs to
      a node: see `Loop_system::genus()`.}
    \cgalParamType{`double`, at least 0, in the unit of the coordinates}
    \cgalParamDefault{0}
  \cgalParamNEnd
  \cgalParamNBegin{min_relative_loop_length}
    \cgalParamDescription{the same as a multiple of the diagonal of the bounding box of the mesh.
      The larger bound counts.}
    \cgalParamType{`double`, at least 0}
    \cgalParamDefault{0}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns the number of loops that were added

\throws Invalid_mesh_exception if `Loop_system` would
\throws Invalid_loops_exception if a pole is invalid, or there is a loop other than one that hugs
  its pole
\throws Invalid_parameter_exception if a value of the function is not finite or a length is negative

The time is \f$ O(n \log n) \f$ for a mesh with \f$ n \f$ vertices, and linear for each loop that is
added or, with a least length, measured.

\sa `detect_feature_poles()`
*/
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
std::size_t propose_loops(const TriangleMesh& mesh,
                          Poles_and_loops<TriangleMesh>& poles_and_loops,
                          const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_parameters<CGAL::internal_np::vertex_point_t, internal_np::vertex_scalar_map_t,
                             internal_np::use_poles_as_punctures_t, internal_np::min_loop_length_t,
                             internal_np::min_relative_loop_length_t>(np);
  using Tag = internal_np::vertex_scalar_map_t;
  const internal::Proposal_options options = internal::proposal_options(np);
  const internal::Checked_mesh<TriangleMesh> checked(mesh, np);
  const internal::Mesh_index<TriangleMesh>& index = checked.index;
  const internal::Flat_mesh& flat = checked.flat;
  const std::vector<internal::Pole> poles =
    internal::poles_to_sweep_from(poles_and_loops, index, checked.capped);
  std::vector<double> values;
  if constexpr (CGAL::parameters::is_default_parameter<NamedParameters, Tag>::value)
    values = internal::geodesic_sweep(flat, poles);
  else
    values = internal::values_of_function(index, checked.capped,
                                          CGAL::parameters::get_parameter(np, Tag()));
  const std::vector<internal::Flat_loop> loops =
    internal::proposed_loops(flat, poles, std::move(values), options);
  for (const internal::Flat_loop& flat_loop : loops)
    poles_and_loops.add_loop(internal::to_loop(flat_loop, index));
  return loops.size();
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_AUTOMATIC_LOOPS_H
