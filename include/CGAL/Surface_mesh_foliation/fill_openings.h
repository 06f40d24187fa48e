// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_FILL_OPENINGS_H
#define CGAL_SURFACE_MESH_FOLIATION_FILL_OPENINGS_H

#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/require_parameter.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>
#include <CGAL/Surface_mesh_foliation/internal/Repair/triangulate_polygon.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>
#include <CGAL/Surface_mesh_foliation/openings.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
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

// An opening that is being filled: its halfedges, the corners that they lead to, and their points.
template <class TriangleMesh, class VertexPointMap>
struct Opening_polygon
{
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  Opening_polygon(const TriangleMesh& mesh, halfedge_descriptor border, VertexPointMap map)
  {
    for (const auto h : CGAL::halfedges_around_face(border, mesh))
    {
      halfedges.push_back(h);
      points.push_back(coordinates(get(map, target(h, mesh))));
    }
  }

  std::size_t size() const { return points.size(); }
  std::vector<halfedge_descriptor> halfedges;
  std::vector<Point> points;
};

// Splits the only face of `faces` that has both corners.
template <class TriangleMesh>
void split_along(typename boost::graph_traits<TriangleMesh>::vertex_descriptor u,
                 typename boost::graph_traits<TriangleMesh>::vertex_descriptor v,
                 std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor>& faces,
                 TriangleMesh& mesh)
{
  using Traits = boost::graph_traits<TriangleMesh>;
  for (const auto f : faces)
  {
    auto at_u = Traits::null_halfedge(), at_v = Traits::null_halfedge();
    for (const auto h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh))
    {
      if (target(h, mesh) == u)
        at_u = h;
      if (target(h, mesh) == v)
        at_v = h;
    }
    if (at_u == Traits::null_halfedge() || at_v == Traits::null_halfedge())
      continue;
    const auto diagonal = CGAL::Euler::split_face(at_u, at_v, mesh);
    const auto g = face(diagonal, mesh), other = face(opposite(diagonal, mesh), mesh);
    faces.push_back(g == f ? other : g);
    return;
  }
}

// whether an opening is all around a single triangle
template <class TriangleMesh>
bool surrounds_one_face(
  const TriangleMesh& mesh,
  const std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor>& border)
{
  return border.size() == 3 && std::all_of(border.begin(), border.end(), [&](const auto h) {
           return face(opposite(h, mesh), mesh) == face(opposite(border[0], mesh), mesh);
         });
}

// Returns the new faces: those that CGAL's hole filling finds, or, if it fails or needs an edge or
// a face that the mesh has elsewhere, a fan around a new vertex in the middle.
template <class TriangleMesh, class VertexPointMap>
std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor> fill_opening(
  TriangleMesh& mesh,
  typename boost::graph_traits<TriangleMesh>::halfedge_descriptor border,
  VertexPointMap vertex_point_map)
{
  using Mesh_point = typename boost::property_traits<VertexPointMap>::value_type;
  const Opening_polygon<TriangleMesh, VertexPointMap> polygon(mesh, border, vertex_point_map);
  const auto corner = [&](std::size_t i) { return target(polygon.halfedges[i], mesh); };
  const auto triangles = triangulate_polygon(polygon.points);
  const std::vector<Diagonal> diagonals =
    triangles ? diagonals_of_triangulation(*triangles, polygon.size()) : std::vector<Diagonal>();
  const bool is_triangulated =
    triangles && !surrounds_one_face(mesh, polygon.halfedges) &&
    std::none_of(diagonals.begin(), diagonals.end(), [&](const Diagonal& d) {
      return halfedge(corner(d.first), corner(d.second), mesh).second;
    });
  CGAL::Euler::fill_hole(border, mesh);
  std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor> result;
  if (is_triangulated)
  {
    result.push_back(face(border, mesh));
    for (const auto& [first, last] : diagonals)
      split_along(corner(first), corner(last), result, mesh);
    return result;
  }
  const auto spoke = CGAL::Euler::add_center_vertex(border, mesh);
  const Point p = centroid_of_polygon(polygon.points);
  put(vertex_point_map, target(spoke, mesh), Mesh_point(p[0], p[1], p[2]));
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
\f$O(k \log k)\f$ and \f$O(k^3)\f$, see
`CGAL::Polygon_mesh_processing::triangulate_hole_polyline()`.
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
    for (const face_descriptor f : internal::fill_opening(mesh, opening.border, vertex_point_map))
      put(filled_face_map, f, true);
    ++result;
  }
  return result;
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_FILL_OPENINGS_H
