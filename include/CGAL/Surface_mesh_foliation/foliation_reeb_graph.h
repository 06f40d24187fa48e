// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_FOLIATION_REEB_GRAPH_H
#define CGAL_SURFACE_MESH_FOLIATION_FOLIATION_REEB_GRAPH_H

#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>
#include <CGAL/Surface_mesh_foliation/Poles_and_loops.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>

#include <CGAL/boost/graph/named_params_helper.h>

#ifdef SURFACE_MESH_FOLIATION_COMPILED
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Compiled_mesh.h>

#include <vector>
#endif

namespace CGAL {
namespace Surface_mesh_foliation {

namespace internal {

template <class TriangleMesh>
const Poles_and_loops<TriangleMesh>& poles_and_loops(const TriangleMesh&,
                                                     const Poles_and_loops<TriangleMesh>& input)
{
  return input;
}

template <class TriangleMesh, class VertexRange>
Poles_and_loops<TriangleMesh> poles_and_loops(const TriangleMesh&, const VertexRange& poles)
{
  Poles_and_loops<TriangleMesh> result;
  for (const auto v : poles)
    result.add_pole(v);
  return result;
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationRef

computes the Reeb graph of a mesh from its poles, and further loops if desired, in one call
[Algorithm 1 of the paper]: checks the loop system, computes its harmonic foliation, and appends the
embedded Reeb graph to `graph`.

\tparam ConcurrencyTag see `harmonic_foliation()`
\tparam TriangleMesh see `Loop_system`
\tparam PolesOrLoops a range of `boost::graph_traits<TriangleMesh>::%vertex_descriptor`, the poles,
  each
  with height 1; or `Poles_and_loops<TriangleMesh>`
\tparam Graph see `reeb_graph()`
\param mesh the mesh
\param poles the poles, or poles and loops
\param graph the graph to append to
\param np an optional sequence of named parameters: those of `Loop_system`, `harmonic_foliation()`
  and
  `reeb_graph()`

\returns the foliation, from which components and leaves can be extracted

\throws whatever these functions throw; then `graph` is unchanged

\sa `Loop_system`
\sa `harmonic_foliation()`
\sa `reeb_graph()`
*/
template <class ConcurrencyTag = CGAL::Sequential_tag,
          class TriangleMesh,
          class PolesOrLoops,
          class Graph,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Measured_foliation<TriangleMesh> foliation_reeb_graph(
  const TriangleMesh& mesh,
  const PolesOrLoops& poles,
  Graph& graph,
  const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_parameters<CGAL::internal_np::vertex_point_t,
                             internal::Harmonic_foliation_parameters,
                             internal::Reeb_graph_parameters>(np);
  const Loop_system<TriangleMesh> system(mesh, internal::poles_and_loops(mesh, poles),
                                         internal::select<CGAL::internal_np::vertex_point_t>(np));
  const Measured_foliation<TriangleMesh> foliation = harmonic_foliation<ConcurrencyTag>(
    system, internal::select<internal::Harmonic_foliation_parameters>(np));
  reeb_graph(foliation, graph, internal::select<internal::Reeb_graph_parameters>(np));
  return foliation;
}

#ifdef SURFACE_MESH_FOLIATION_COMPILED
// what the compiled library has
extern template Measured_foliation<internal::Compiled_mesh> foliation_reeb_graph<
  CGAL::Sequential_tag>(const internal::Compiled_mesh&,
                        const std::vector<internal::Compiled_mesh::Vertex_index>&,
                        Reeb_graph<internal::Compiled_mesh::Point>&,
                        const CGAL::parameters::Default_named_parameters&);
extern template Measured_foliation<internal::Compiled_mesh> foliation_reeb_graph<
  CGAL::Sequential_tag>(const internal::Compiled_mesh&,
                        const Poles_and_loops<internal::Compiled_mesh>&,
                        Reeb_graph<internal::Compiled_mesh::Point>&,
                        const CGAL::parameters::Default_named_parameters&);
#endif

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_FOLIATION_REEB_GRAPH_H
