// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_OPENINGS_H
#define CGAL_SURFACE_MESH_FOLIATION_OPENINGS_H

#include <CGAL/Surface_mesh_foliation/Poles_and_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationLoops

describes an opening of a mesh: a closed curve of border edges.
*/
template <class TriangleMesh>
struct Opening
{
  /// a halfedge of the border, without a face: of all, the one that is iterated first
  typename boost::graph_traits<TriangleMesh>::halfedge_descriptor border;
  std::size_t number_of_edges; ///< of the border
  double length;               ///< of the border
};

/*!
\ingroup PkgSurfaceMeshFoliationLoops

outputs the openings of a mesh, in the order in which `halfedges(mesh)` meets their borders.

\tparam TriangleMesh a model of `HalfedgeListGraph` for which `CGAL::dynamic_halfedge_property_t`
  maps exist
\param mesh the mesh
\param out an output iterator for `Opening<TriangleMesh>`
\param np an optional sequence of named parameters: `vertex_point_map`, by default
  `boost::get(CGAL::vertex_point, mesh)`

\returns the output iterator

The time is linear in the number of halfedges.
*/
template <class TriangleMesh,
          class OpeningOutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
OpeningOutputIterator openings(const TriangleMesh& mesh,
                               OpeningOutputIterator out,
                               const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  internal::check_parameters<CGAL::internal_np::vertex_point_t>(np);
  const auto vertex_point_map = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                                 get_const_property_map(CGAL::vertex_point, mesh));
  const auto point = [&](const auto v) { return internal::coordinates(get(vertex_point_map, v)); };
  auto is_met = get(CGAL::dynamic_halfedge_property_t<bool>(), mesh);
  for (const auto h : halfedges(mesh))
    put(is_met, h, false);
  for (const auto first : halfedges(mesh))
  {
    if (!is_border(first, mesh) || get(is_met, first))
      continue;
    Opening<TriangleMesh> result = {first, 0, 0};
    auto h = first;
    do
    {
      put(is_met, h, true);
      ++result.number_of_edges;
      result.length += internal::distance(point(source(h, mesh)), point(target(h, mesh)));
      h = next(h, mesh);
    } while (h != first);
    *out++ = result;
  }
  return out;
}

/*!
\ingroup PkgSurfaceMeshFoliationLoops

makes all openings of a mesh poles (`Poles_and_loops::add_border_pole()`), in the order of
`openings()`, so that each of them becomes an end of the Reeb graph. Openings that are holes of a
scan rather than ends of the shape are filled before, see `fill_openings()`.

\param mesh the mesh
\param poles_and_loops where the poles are added
\param height the transverse measure of their leaves

\returns the number of openings

The time is linear in the number of halfedges.
*/
template <class TriangleMesh>
std::size_t add_border_poles(const TriangleMesh& mesh,
                             Poles_and_loops<TriangleMesh>& poles_and_loops,
                             double height = 1)
{
  std::vector<Opening<TriangleMesh>> all;
  openings(mesh, std::back_inserter(all));
  for (const Opening<TriangleMesh>& opening : all)
    poles_and_loops.add_border_pole(opening.border, height);
  return all.size();
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_OPENINGS_H
