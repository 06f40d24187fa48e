// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_FILL_OPENINGS_H
#define CGAL_SURFACE_MESH_FOLIATION_FILL_OPENINGS_H

#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/require_parameter.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/openings.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>
#include <CGAL/Surface_mesh_foliation/openings.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/property_map.h>
#include <CGAL/version.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <iterator>
#include <vector>

/// \file
/// This header is not included by `Surface_mesh_foliation.h`, since \cgal's hole filling takes long
/// to compile.

namespace CGAL {
namespace Surface_mesh_foliation {

/// \ingroup PkgSurfaceMeshFoliationLoops
/// is the largest length of an opening that `fill_openings()` fills by default, divided by the
/// diagonal of the mesh's bounding box.
constexpr double default_relative_hole_length = 0.05;

namespace internal {

// The faces by which CGAL fills an opening: none if it fails.
template <class TriangleMesh, class VertexPointMap>
std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor> filled_by_cgal(
  TriangleMesh& mesh,
  typename boost::graph_traits<TriangleMesh>::halfedge_descriptor border,
  VertexPointMap vertex_point_map)
{
  std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor> result;
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(5, 6, 0)
  Polygon_mesh_processing::triangulate_hole(mesh, border,
                                            CGAL::parameters::vertex_point_map(vertex_point_map)
                                              .face_output_iterator(std::back_inserter(result)));
#else
  Polygon_mesh_processing::triangulate_hole(mesh, border, std::back_inserter(result),
                                            CGAL::parameters::vertex_point_map(vertex_point_map));
#endif
  return result;
}

// a fan around a new vertex in the middle, which is always possible
template <class TriangleMesh, class VertexPointMap>
std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor> filled_by_fan(
  TriangleMesh& mesh,
  typename boost::graph_traits<TriangleMesh>::halfedge_descriptor border,
  VertexPointMap vertex_point_map)
{
  using Mesh_point = typename boost::property_traits<VertexPointMap>::value_type;
  std::vector<Point> points;
  Border corners;
  for (const auto h : CGAL::halfedges_around_face(border, mesh))
  {
    corners.push_back(static_cast<int>(points.size()));
    points.push_back(coordinates(get(vertex_point_map, target(h, mesh))));
  }
  const Point p = center_of_opening(corners, points);
  CGAL::Euler::fill_hole(border, mesh);
  const auto spoke = CGAL::Euler::add_center_vertex(border, mesh);
  put(vertex_point_map, target(spoke, mesh), Mesh_point(p[0], p[1], p[2]));
  std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor> result;
  for (const auto h : CGAL::halfedges_around_target(spoke, mesh))
    result.push_back(face(h, mesh));
  return result;
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationLoops

fills the openings of a mesh whose borders are not longer than a given length, such as the holes of
a scan, by \cgal's hole filling; where that fails, by a fan around a new vertex.
Leaves then run across them. The openings that remain can be made poles by `add_border_poles()`.

New elements come after those of the mesh.

\tparam TriangleMesh a model of `MutableFaceGraph` and `HalfedgeListGraph` for which
  `CGAL::dynamic_halfedge_property_t` maps exist
\param mesh the mesh
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
  below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `mesh`}
    \cgalParamType{a class model of `ReadWritePropertyMap` with
      `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a `Point_3` as value
      type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{max_opening_length}
    \cgalParamDescription{the largest length of the border of an opening that is filled, in units of
      the mesh}
    \cgalParamType{`double`, not negative; infinity fills all openings}
    \cgalParamDefault{`default_relative_hole_length` times the diagonal of the bounding box}
  \cgalParamNEnd
  \cgalParamNBegin{filled_face_map}
    \cgalParamDescription{a property map to which `true` is written for each new face}
    \cgalParamType{a class model of `WritablePropertyMap` with
      `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `bool` as value type}
    \cgalParamDefault{nothing is written}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns the number of openings that were filled

\throws Invalid_parameter_exception if the length is negative or not a number

The time is linear in the number of halfedges, and for a border of \f$k\f$ edges between
\f$O(k \log k)\f$ and \f$O(k^3)\f$, see `CGAL::Polygon_mesh_processing::triangulate_hole()`.
*/
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
std::size_t fill_openings(TriangleMesh& mesh,
                          const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  internal::check_parameters<CGAL::internal_np::vertex_point_t, internal_np::max_opening_length_t,
                             internal_np::filled_face_map_t>(np);
  const auto vertex_point_map = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                                 get_property_map(CGAL::vertex_point, mesh));
  const auto filled_face_map =
    choose_parameter(get_parameter(np, internal_np::filled_face_map),
                     CGAL::Constant_property_map<face_descriptor, bool>());
  const double length = choose_parameter(
    get_parameter(np, internal_np::max_opening_length),
    default_relative_hole_length * internal::diagonal(Polygon_mesh_processing::bbox(
                                     mesh, CGAL::parameters::vertex_point_map(vertex_point_map))));
  internal::require_parameter(length >= 0,
                              internal::text("the largest length of an opening that is "
                                             "filled is ",
                                             length, ", not at least 0"));
  std::vector<Opening<TriangleMesh>> all;
  openings(mesh, std::back_inserter(all), CGAL::parameters::vertex_point_map(vertex_point_map));
  std::size_t result = 0;
  for (const Opening<TriangleMesh>& opening : all)
  {
    if (!(opening.length <= length))
      continue;
    std::vector<face_descriptor> faces =
      internal::filled_by_cgal(mesh, opening.border, vertex_point_map);
    if (faces.empty())
      faces = internal::filled_by_fan(mesh, opening.border, vertex_point_map);
    for (const face_descriptor f : faces)
      put(filled_face_map, f, true);
    ++result;
  }
  return result;
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_FILL_OPENINGS_H
