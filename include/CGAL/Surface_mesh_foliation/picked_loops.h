// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_PICKED_LOOPS_H
#define CGAL_SURFACE_MESH_FOLIATION_PICKED_LOOPS_H

#include <CGAL/Surface_mesh_foliation/Loop.h>
#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/Poles_and_loops.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/Shortest_walks.h>
#include <CGAL/Surface_mesh_foliation/loops.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

namespace internal {

template <class Vertices, class TriangleMesh>
void check_picks(const Vertices& picks, const TriangleMesh& mesh)
{
  if (picks.size() < 3)
    throw_loop_problem("a loop through picked vertices needs at least three", {});
  const auto range = vertices(mesh); // num_vertices() may count removed ones
  const auto number = static_cast<std::size_t>(std::distance(range.begin(), range.end()));
  for (std::size_t i = 0; i < picks.size(); ++i)
  {
    const std::size_t position = position_of_vertex(picks[i], mesh);
    if (position == number)
      throw_loop_problem("a picked vertex is not one of the mesh", {});
    if (std::find(picks.begin() + i + 1, picks.end(), picks[i]) != picks.end())
      throw_loop_problem(vertex_name(position) + " is picked twice", {position});
  }
}

// of poles and of openings that are poles
template <class TriangleMesh>
auto all_pole_vertices(const Poles_and_loops<TriangleMesh>& input, const TriangleMesh& mesh)
{
  using Traits = boost::graph_traits<TriangleMesh>;
  std::vector<typename Traits::vertex_descriptor> result;
  for (const auto& entry : input.entries())
  {
    result.insert(result.end(), entry.pole.begin(), entry.pole.end());
    if (entry.border == Traits::null_halfedge())
      continue;
    auto h = entry.border;
    do
    {
      result.push_back(target(h, mesh));
      h = next(h, mesh);
    } while (h != entry.border);
  }
  return result;
}

// what `validate()` says about the last loop
template <class TriangleMesh, class NamedParameters>
void check_last_loop(const TriangleMesh& mesh,
                     const Poles_and_loops<TriangleMesh>& input,
                     const NamedParameters& np)
{
  const std::size_t last = input.size() - 1;
  for (const Problem& problem : validate(mesh, input, np))
  {
    if (is_about_mesh(problem.kind))
      throw Invalid_mesh_exception(problem);
    if (std::find(problem.loops.begin(), problem.loops.end(), last) != problem.loops.end())
      throw Invalid_loops_exception(problem);
  }
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationLoops

returns a simple loop through vertices that a user has picked: the shortest path along edges from
each to the next, and from the last to the first, pushed off to its left (`loop_from_edge_cycle()`).

Each path avoids the other picked vertices and all paths before it, so that the loop does not meet
itself; where it has to go around one of them, it is longer than the shortest path along edges.
Which of several paths of the same length is taken is unspecified, but it is always the same one.

\param picks at least three vertices in order, none of them twice. Three on different sides of a
  limb are enough to determine the direction around it.
\param mesh a triangle mesh
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
  below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{as for `Loop_system`}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throws Invalid_loops_exception if there are fewer than three vertices, one does not belong to the
  mesh or is given twice, if a path cannot avoid an earlier one (the message says which crosses
  which, and where), if the paths bound a disk without a vertex inside, or if they pass along an
  opening of the mesh that lies to their left

The time is \f$ O(k n \log n) \f$ for \f$ k \f$ picked vertices and a mesh with \f$ n \f$ vertices.
*/
template <class VertexRange,
          class TriangleMesh,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Loop<TriangleMesh> loop_through_vertices(
  const VertexRange& picks,
  const TriangleMesh& mesh,
  const NamedParameters& np = CGAL::parameters::default_values())
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  internal::check_parameters<CGAL::internal_np::vertex_point_t>(np);
  const std::vector<vertex_descriptor> vertices(std::begin(picks), std::end(picks));
  internal::check_picks(vertices, mesh);
  return loop_from_edge_cycle(internal::closed_walk_through(vertices, {}, mesh, np), mesh);
}

/*!
\ingroup PkgSurfaceMeshFoliationLoops

adds a loop of height 1 through picked vertices (`loop_through_vertices()`) to existing poles and
loops, if it is compatible with them. The loop avoids the vertices of poles, those of the borders of
openings included.

\param picks see `loop_through_vertices()`
\param mesh a mesh that `Loop_system` accepts
\param poles_and_loops poles and loops. Those that are added later are not yet known here, so add
  the poles first.
\param np as for `loop_through_vertices()`

\returns the loop id

\throws Invalid_mesh_exception if `Loop_system` would
\throws Invalid_loops_exception as `loop_through_vertices()` does; if a picked vertex belongs to a
  pole; and if the new loop crosses another one, is inessential, or is homotopic to another one in
  the surface minus its poles. The message says which loops, and where they meet. In all these cases
  `poles_and_loops` is not changed.

The time is that of `loop_through_vertices()` and of `validate()`.
*/
template <class VertexRange,
          class TriangleMesh,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
std::size_t add_loop_through_vertices(
  const VertexRange& picks,
  const TriangleMesh& mesh,
  Poles_and_loops<TriangleMesh>& poles_and_loops,
  const NamedParameters& np = CGAL::parameters::default_values())
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  internal::check_parameters<CGAL::internal_np::vertex_point_t>(np);
  const std::vector<vertex_descriptor> vertices(std::begin(picks), std::end(picks));
  internal::check_picks(vertices, mesh);
  const std::vector<vertex_descriptor> pole_vertices =
    internal::all_pole_vertices(poles_and_loops, mesh);
  for (const vertex_descriptor v : vertices)
    if (std::find(pole_vertices.begin(), pole_vertices.end(), v) != pole_vertices.end())
    {
      const std::size_t position = internal::position_of_vertex(v, mesh);
      internal::throw_loop_problem(
        "picked " + internal::vertex_name(position) + " belongs to a pole", {position});
    }
  Poles_and_loops<TriangleMesh> result = poles_and_loops;
  const std::size_t id = result.add_loop(
    loop_from_edge_cycle(internal::closed_walk_through(vertices, pole_vertices, mesh, np), mesh));
  internal::check_last_loop(mesh, result, np);
  poles_and_loops = std::move(result);
  return id;
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_PICKED_LOOPS_H
