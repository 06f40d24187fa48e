// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LOOPS_CONTOUR_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LOOPS_CONTOUR_H

#include <CGAL/Surface_mesh_foliation/internal/Loops/Loop.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// a position strictly inside an edge, even if rounding has moved it to an end
inline double inner_position(double position)
{
  constexpr double margin = 1e-9;
  return position > margin ? (position < 1 - margin ? position : 1 - margin) : margin;
}

// Outputs the closed curves that separate the vertices inside a set from those outside, with the
// inside to their left. position(v, u) says where the edge from v (outside) to u (inside) is
// crossed. Curves that run into the border of an opening are left out.
template <class TriangleMesh, class IsInside, class Position, class OutputIterator>
OutputIterator contour_loops(const TriangleMesh& mesh,
                             const IsInside& is_inside,
                             const Position& position,
                             OutputIterator out)
{
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  auto is_crossed = get(CGAL::dynamic_halfedge_property_t<bool>(), mesh);
  for (const auto f : faces(mesh))
    for (halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh))
      put(is_crossed, h, false);
  const auto crosses = [&](halfedge_descriptor h) {
    return !is_inside(source(h, mesh)) && is_inside(target(h, mesh));
  };
  for (const auto f : faces(mesh))
    for (halfedge_descriptor first : CGAL::halfedges_around_face(halfedge(f, mesh), mesh))
    {
      if (!crosses(first) || get(is_crossed, first))
        continue;
      Loop<TriangleMesh> loop;
      halfedge_descriptor h = first;
      bool is_open = false;
      do
      {
        // the rest of an open curve may have been followed before
        is_open = is_border(opposite(h, mesh), mesh) || get(is_crossed, h);
        put(is_crossed, h, true);
        if (is_open)
          break;
        loop.push_back({h, inner_position(position(source(h, mesh), target(h, mesh)))});
        // exactly one of the other two edges of the next face is crossed
        const halfedge_descriptor g = next(opposite(h, mesh), mesh);
        h = crosses(g) ? g : next(g, mesh);
      } while (h != first);
      if (!is_open)
        *out++ = std::move(loop);
    }
  return out;
}

// Removes pairs of consecutive crossings, including the last and the first, that cross an edge back
// and forth.
template <class TriangleMesh>
void shorten_loop(const TriangleMesh& mesh, Loop<TriangleMesh>& loop)
{
  Loop<TriangleMesh> result;
  for (const Crossing<TriangleMesh>& crossing : loop)
    if (!result.empty() && result.back().halfedge == opposite(crossing.halfedge, mesh))
      result.pop_back();
    else
      result.push_back(crossing);
  std::size_t first = 0, last = result.size();
  for (; last - first >= 2 && result[first].halfedge == opposite(result[last - 1].halfedge, mesh);
       ++first)
    --last;
  loop.assign(result.begin() + first, result.begin() + last);
}

template <class TriangleMesh, class VertexPointMap>
double distance_to_loop(const TriangleMesh& mesh,
                        VertexPointMap vertex_point_map,
                        const Loop<TriangleMesh>& loop,
                        const Point& p)
{
  const auto place = [&](const Crossing<TriangleMesh>& crossing) {
    const Point a = coordinates(get(vertex_point_map, source(crossing.halfedge, mesh)));
    const Point b = coordinates(get(vertex_point_map, target(crossing.halfedge, mesh)));
    return between(a, b, crossing.position);
  };
  double result = (std::numeric_limits<double>::infinity)();
  for (std::size_t i = 0; i < loop.size(); ++i)
    result = (std::min)(result,
                        distance_to_segment(p, place(loop[i]), place(loop[(i + 1) % loop.size()])));
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LOOPS_CONTOUR_H
