// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_IO_READ_TRIANGLE_MESH_H
#define CGAL_SURFACE_MESH_FOLIATION_IO_READ_TRIANGLE_MESH_H

#include <CGAL/Surface_mesh_foliation/IO/Triangle_soup.h>
#include <CGAL/Surface_mesh_foliation/IO/polygon_soup.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/build_triangle_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/require_parameter.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <string>
#include <vector>

#ifdef SURFACE_MESH_FOLIATION_COMPILED
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Compiled_mesh.h>
#endif

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Elements that were removed but not yet garbage-collected count as well: they would be reused, in
// an order of their own.
template <class TriangleMesh>
void check_is_new(const TriangleMesh& mesh)
{
  require_parameter(num_vertices(mesh) == 0 && num_halfedges(mesh) == 0 && num_faces(mesh) == 0,
                    "the mesh to be filled is not empty");
}

// `place` is the file name followed by ": ", or empty
template <class TriangleMesh, class NamedParameters>
void check_and_build_triangle_mesh(const Triangle_soup& soup,
                                   TriangleMesh& mesh,
                                   const NamedParameters& np,
                                   const std::string& place)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Vertex_point_map = typename GetVertexPointMap<TriangleMesh, NamedParameters>::type;

  check_parameters<CGAL::internal_np::vertex_point_t, internal_np::allow_openings_t,
                   internal_np::allow_parts_t>(np);
  check_is_new(mesh);
  std::vector<Problem> problems = check_triangle_soup(
    soup, select<internal_np::allow_openings_t, internal_np::allow_parts_t>(np));
  if (!problems.empty())
  {
    Problem& problem = problems.front();
    problem.message.insert(0, place);
    throw Invalid_mesh_exception(problem);
  }
  Vertex_point_map vertex_point_map = choose_parameter(
    get_parameter(np, CGAL::internal_np::vertex_point), get_property_map(vertex_point, mesh));
  build_triangle_mesh(soup, mesh, vertex_point_map);
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationIO

builds a triangle mesh from a triangle soup that is an oriented manifold, closed unless openings are
allowed, and connected unless several parts are allowed.

The i-th vertex of the soup becomes the i-th of `vertices(mesh)`, and the i-th face the i-th of
`faces(mesh)`, in all models of `MutableFaceGraph` whose ranges list new elements in the order of
their creation. These are, among others, `Surface_mesh`, `Polyhedron_3`, and
`Linear_cell_complex_for_bgl_combinatorial_map_helper`.

\tparam TriangleMesh a model of `MutableFaceGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param soup the vertices and faces
\param mesh the mesh to be filled; it is unchanged after an exception
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
  below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `mesh`}
    \cgalParamType{a class model of `WritablePropertyMap` with
      `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a value type that is
      constructible from three `double`, such as `Point_3`}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
    \cgalParamExtra{If this parameter is omitted, an internal property map for
      `CGAL::vertex_point_t` must be available in `TriangleMesh`.}
  \cgalParamNEnd
  \cgalParamNBegin{allow_openings}
    \cgalParamDescription{whether the mesh may have openings, bounded by edges with one face}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{allow_parts}
    \cgalParamDescription{whether the mesh may have several connected components, see
      `mesh_parts()`}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\pre `mesh` has no elements, nor removed ones that still take memory.

\throws Invalid_parameter_exception if `mesh` is not empty
\throws Invalid_mesh_exception with the first of the problems that `check_triangle_soup()` finds

The time is \f$O(n \log n)\f$ and the memory \f$O(n)\f$ for \f$n\f$ vertices and faces.

\sa `read_triangle_mesh()`
*/
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
void triangle_soup_to_triangle_mesh(const Triangle_soup& soup,
                                    TriangleMesh& mesh,
                                    const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_and_build_triangle_mesh(soup, mesh, np, std::string());
}

/*!
\ingroup PkgSurfaceMeshFoliationIO

reads an oriented manifold triangle mesh from a file; it must be closed unless openings are allowed,
and connected unless several parts are allowed.

This is `read_triangle_soup()` followed by `triangle_soup_to_triangle_mesh()`: the i-th vertex of
the file becomes the i-th of `vertices(mesh)`, the i-th face the i-th of `faces(mesh)`, and nothing
is renumbered, repaired or merged.

\tparam TriangleMesh a model of `MutableFaceGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param file_name the name of the file, which ends with `.off`, `.obj` or `.ply`
\param mesh the mesh to be filled; it is unchanged after an exception
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
  below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `mesh`}
    \cgalParamType{a class model of `WritablePropertyMap` with
      `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a value type that is
      constructible from three `double`, such as `Point_3`}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
    \cgalParamExtra{If this parameter is omitted, an internal property map for
      `CGAL::vertex_point_t` must be available in `TriangleMesh`.}
  \cgalParamNEnd
  \cgalParamNBegin{allow_openings}
    \cgalParamDescription{whether the mesh may have openings, bounded by edges with one face}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{allow_parts}
    \cgalParamDescription{whether the mesh may have several connected components, see
      `mesh_parts()`}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\pre `mesh` has no elements, nor removed ones that still take memory.

\throws Invalid_file_exception if the file cannot be read
\throws Invalid_parameter_exception if `mesh` is not empty
\throws Invalid_mesh_exception if the file holds anything but such a mesh with finite coordinates
  and without degenerate faces; see `check_triangle_soup()`

The message of an exception is one line that begins with the file name, with the number of the line
if there is one to blame.

The time is \f$O(n \log n)\f$ and the memory \f$O(n)\f$ for a file of \f$n\f$ vertices and faces.
*/
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
void read_triangle_mesh(const std::string& file_name,
                        TriangleMesh& mesh,
                        const NamedParameters& np = CGAL::parameters::default_values())
{
  const Triangle_soup soup = read_triangle_soup(file_name);
  internal::check_and_build_triangle_mesh(soup, mesh, np, file_name + ": ");
}

#ifdef SURFACE_MESH_FOLIATION_COMPILED
// what the compiled library has
extern template void read_triangle_mesh(const std::string&,
                                        internal::Compiled_mesh&,
                                        const CGAL::parameters::Default_named_parameters&);
#endif

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_IO_READ_TRIANGLE_MESH_H
