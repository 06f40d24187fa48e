// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_LOOPS_H
#define CGAL_SURFACE_MESH_FOLIATION_LOOPS_H

#include <CGAL/Surface_mesh_foliation/Loop.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/contour.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/loop_problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

namespace internal {

// the halfedges from each vertex of an edge cycle to the next one
template <class Vertices, class TriangleMesh>
auto walk_of_edge_cycle(const Vertices& cycle, const TriangleMesh& mesh)
{
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  if (cycle.size() < 3)
    throw_loop_problem("an edge cycle needs at least three vertices, not " +
                         std::to_string(cycle.size()),
                       positions_of_vertices(cycle, mesh));
  std::vector<halfedge_descriptor> walk;
  for (std::size_t i = 0; i < cycle.size(); ++i)
  {
    const auto u = cycle[i], v = cycle[(i + 1) % cycle.size()];
    const auto [h, exists] = halfedge(u, v, mesh);
    if (!exists)
    {
      const std::size_t a = position_of_vertex(u, mesh), b = position_of_vertex(v, mesh);
      throw_loop_problem("edge cycle: vertices " + std::to_string(a) + " and " + std::to_string(b) +
                           " have no edge",
                         {a, b});
    }
    walk.push_back(h);
  }
  for (std::size_t i = 0; i < walk.size(); ++i)
    if (walk[i] == opposite(walk[(i + 1) % walk.size()], mesh))
    {
      const std::size_t a = position_of_vertex(target(walk[i], mesh), mesh);
      throw_loop_problem("the edge cycle turns back at " + vertex_name(a), {a});
    }
  return walk;
}

// A walk that is to be pushed off to its left must have faces there.
template <class TriangleMesh>
void check_no_opening_to_left(typename boost::graph_traits<TriangleMesh>::halfedge_descriptor in,
                              typename boost::graph_traits<TriangleMesh>::halfedge_descriptor out,
                              const TriangleMesh& mesh)
{
  bool meets_opening = is_border(in, mesh);
  for (auto spoke = next(in, mesh); spoke != out && !meets_opening;
       spoke = next(opposite(spoke, mesh), mesh))
    meets_opening = is_border(opposite(spoke, mesh), mesh);
  if (!meets_opening)
    return;
  const std::size_t a = position_of_vertex(target(in, mesh), mesh);
  throw_loop_problem("the edge cycle has an opening of the mesh to its left at " + vertex_name(a) +
                       ": reverse it, or lead it away from the border",
                     {a});
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationLoops

returns the loop that runs counterclockwise around all vertices within `rings - 1` edges of `v`,
close to them. With `rings` equal to 1 it hugs the vertex; larger numbers give larger and larger
disks.

\param v the vertex
\param mesh a triangle mesh
\param rings at least 1; the loop must not meet itself, so a large number may be rejected

\throws Invalid_loops_exception if the boundary of the set is not one closed curve

The time is linear in the number of faces.
*/
template <class TriangleMesh>
Loop<TriangleMesh> pole_loop(typename boost::graph_traits<TriangleMesh>::vertex_descriptor v,
                             const TriangleMesh& mesh,
                             unsigned int rings = 1)
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  auto is_inside = get(CGAL::dynamic_vertex_property_t<bool>(), mesh);
  for (vertex_descriptor u : vertices(mesh))
    put(is_inside, u, u == v);
  std::vector<vertex_descriptor> disk = {v};
  for (std::size_t first = 0; rings > 1; --rings)
    for (const std::size_t last = disk.size(); first < last; ++first)
      for (vertex_descriptor u : CGAL::vertices_around_target(disk[first], mesh))
        if (!get(is_inside, u))
        {
          put(is_inside, u, true);
          disk.push_back(u);
        }
  std::vector<Loop<TriangleMesh>> loops;
  internal::contour_loops(
    mesh, [&](vertex_descriptor u) { return get(is_inside, u); },
    [](vertex_descriptor, vertex_descriptor) { return 2. / 3; }, std::back_inserter(loops));
  if (loops.size() != 1)
  {
    const std::size_t position = internal::position_of_vertex(v, mesh);
    internal::throw_loop_problem("the boundary of the rings around " +
                                   internal::vertex_name(position) + " is not one curve but " +
                                   std::to_string(loops.size()),
                                 {position});
  }
  return loops.front();
}

/*!
\ingroup PkgSurfaceMeshFoliationLoops

returns a closed walk along edges, pushed off to its left: a loop that crosses, close to the walk,
the edges that leave it to the left.

\param cycle the vertices of the walk in order, at least three, without the first repeated at the
  end
\param mesh a triangle mesh

\throws Invalid_loops_exception if there are fewer than three vertices, two consecutive vertices
  have no edge, the walk turns back at a vertex, or there is nothing to its left (as inside a
  triangle) or an opening of the mesh

The time is linear in the number of edges around the vertices of the walk. If the walk visits no
vertex twice, the loop is simple.
*/
template <class VertexRange, class TriangleMesh>
Loop<TriangleMesh> loop_from_edge_cycle(const VertexRange& cycle, const TriangleMesh& mesh)
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  const std::vector<vertex_descriptor> corners(std::begin(cycle), std::end(cycle));
  const std::vector<halfedge_descriptor> walk = internal::walk_of_edge_cycle(corners, mesh);
  Loop<TriangleMesh> result;
  for (std::size_t i = 0; i < walk.size(); ++i)
  {
    const halfedge_descriptor in = walk[i], out = walk[(i + 1) % walk.size()];
    internal::check_no_opening_to_left(in, out, mesh);
    // clockwise, as seen from the vertex, over the spokes to the left of the walk, from the
    // incoming edge to the outgoing one
    for (halfedge_descriptor spoke = next(in, mesh); spoke != out;
         spoke = next(opposite(spoke, mesh), mesh))
      result.push_back({spoke, 0.25});
  }
  internal::shorten_loop(mesh, result);
  if (result.empty())
  {
    const std::vector<std::size_t> positions = internal::positions_of_vertices(corners, mesh);
    internal::throw_loop_problem(
      "the edge cycle from " + internal::vertex_name(positions[0]) +
        " on: no edge leaves it to its left except those that lead straight back to it",
      positions);
  }
  return result;
}

/*!
\ingroup PkgSurfaceMeshFoliationLoops

outputs the curves that separate a set of vertices from the others, one loop per boundary curve,
each with the set to its left. They cross the edges close to the set. Curves that end on the border
of an opening are left out.

\param inside the set, as a range of vertices
\param mesh a triangle mesh
\param out an output iterator for `Loop<TriangleMesh>`

\returns the output iterator

The time is linear in the number of faces.
*/
template <class VertexRange, class TriangleMesh, class LoopOutputIterator>
LoopOutputIterator loops_around_vertices(const VertexRange& inside,
                                         const TriangleMesh& mesh,
                                         LoopOutputIterator out)
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  auto is_inside = get(CGAL::dynamic_vertex_property_t<bool>(), mesh);
  for (vertex_descriptor v : vertices(mesh))
    put(is_inside, v, false);
  for (vertex_descriptor v : inside)
    put(is_inside, v, true);
  return internal::contour_loops(
    mesh, [&](vertex_descriptor v) { return get(is_inside, v); },
    [](vertex_descriptor, vertex_descriptor) { return 2. / 3; }, out);
}

/*!
\ingroup PkgSurfaceMeshFoliationLoops

outputs the curves along which the piecewise linear function given by its values at the vertices
takes the value `level`, each with larger values to its left. A vertex with the value `level` counts
as above. Curves that end on the border of an opening are left out.

\tparam VertexScalarMap a model of `ReadablePropertyMap` with
  `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a number type as value
  type
\param mesh a triangle mesh
\param function the values, finite
\param level the level
\param out an output iterator for `Loop<TriangleMesh>`

\returns the output iterator

The time is linear in the number of faces.
*/
template <class TriangleMesh, class VertexScalarMap, class LoopOutputIterator>
LoopOutputIterator isoline_loops(const TriangleMesh& mesh,
                                 VertexScalarMap function,
                                 double level,
                                 LoopOutputIterator out)
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  const auto value = [&](vertex_descriptor v) { return CGAL::to_double(get(function, v)); };
  return internal::contour_loops(
    mesh, [&](vertex_descriptor v) { return value(v) >= level; },
    [&](vertex_descriptor below, vertex_descriptor above) {
      // half of each, so that nothing overflows
      return (level / 2 - value(below) / 2) / (value(above) / 2 - value(below) / 2);
    },
    out);
}

namespace internal {

template <class TriangleMesh, class VertexPointMap>
auto signed_distance_map(const TriangleMesh& mesh,
                         const std::array<double, 4>& plane,
                         VertexPointMap vertex_point_map)
{
  auto result = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
  for (const auto v : vertices(mesh))
  {
    const auto& p = get(vertex_point_map, v);
    put(result, v,
        plane[0] * CGAL::to_double(p.x()) + plane[1] * CGAL::to_double(p.y()) +
          plane[2] * CGAL::to_double(p.z()) + plane[3]);
  }
  return result;
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationLoops

outputs the curves of the plane section `ax + by + cz + d = 0`, each with the positive side to its
left. A vertex on the plane counts as positive. Curves that end on the border of an opening are left
out.

\param mesh a triangle mesh
\param plane the numbers `a`, `b`, `c`, `d`
\param out an output iterator for `Loop<TriangleMesh>`
\param np an optional sequence of named parameters: `vertex_point_map`, by default
  `boost::get(CGAL::vertex_point, mesh)`

\returns the output iterator

The time is linear in the number of faces.
*/
template <class TriangleMesh,
          class LoopOutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
LoopOutputIterator plane_section_loops(
  const TriangleMesh& mesh,
  const std::array<double, 4>& plane,
  LoopOutputIterator out,
  const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  internal::check_parameters<CGAL::internal_np::vertex_point_t>(np);
  const auto vertex_point_map = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                                 get_const_property_map(CGAL::vertex_point, mesh));
  return isoline_loops(mesh, internal::signed_distance_map(mesh, plane, vertex_point_map), 0., out);
}

/*!
\ingroup PkgSurfaceMeshFoliationLoops

returns the curve of a plane section that comes nearest to a vertex, by Euclidean distance; of
equally near ones, the first that `plane_section_loops()` outputs.

\param mesh a triangle mesh
\param plane the numbers `a`, `b`, `c`, `d`
\param v the vertex
\param np an optional sequence of named parameters: `vertex_point_map`, by default
  `boost::get(CGAL::vertex_point, mesh)`

\throws Invalid_loops_exception if the plane does not meet the mesh in a closed curve
*/
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
Loop<TriangleMesh> plane_section_loop(
  const TriangleMesh& mesh,
  const std::array<double, 4>& plane,
  typename boost::graph_traits<TriangleMesh>::vertex_descriptor v,
  const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto vertex_point_map = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                                 get_const_property_map(CGAL::vertex_point, mesh));
  std::vector<Loop<TriangleMesh>> loops;
  plane_section_loops(mesh, plane, std::back_inserter(loops), np);
  if (loops.empty())
  {
    const std::size_t position = internal::position_of_vertex(v, mesh);
    internal::throw_loop_problem(
      "the plane near " + internal::vertex_name(position) + " does not meet the mesh", {position});
  }
  const internal::Point p = internal::coordinates(get(vertex_point_map, v));
  const auto distance = [&](const Loop<TriangleMesh>& loop) {
    return internal::distance_to_loop(mesh, vertex_point_map, loop, p);
  };
  std::vector<double> distances(loops.size());
  std::transform(loops.begin(), loops.end(), distances.begin(), distance);
  return loops[std::min_element(distances.begin(), distances.end()) - distances.begin()];
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_LOOPS_H
