// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_BUILD_TRIANGLE_MESH_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_BUILD_TRIANGLE_MESH_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Triangle_soup.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Soup_edges.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

template <class TriangleMesh, class VertexPointMap>
std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> add_vertices(
  const Triangle_soup& soup, TriangleMesh& mesh, VertexPointMap vertex_point_map)
{
  using Mesh_point = typename boost::property_traits<VertexPointMap>::value_type;

  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertices;
  vertices.reserve(soup.points.size());
  for (const auto& [x, y, z] : soup.points)
  {
    vertices.push_back(add_vertex(mesh));
    put(vertex_point_map, vertices.back(), Mesh_point(x, y, z));
  }
  return vertices;
}

// Side 3f+i of the soup becomes halfedge 3f+i of the result. All edges must have two sides, with
// opposite directions.
template <class TriangleMesh>
std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor> add_edges(
  const Triangle_soup& soup, TriangleMesh& mesh)
{
  const Soup_edges edges(soup);
  std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor> halfedges(
    3 * soup.triangles.size());
  for (std::size_t edge = 0; edge < edges.size(); ++edge)
  {
    const auto new_halfedge = halfedge(add_edge(mesh), mesh);
    halfedges[edges.side(edge, 0)] = new_halfedge;
    halfedges[edges.side(edge, 1)] = opposite(new_halfedge, mesh);
  }
  return halfedges;
}

// adds to a mesh a soup that `check_triangle_soup()` has found valid. `Euler::add_face()`
// would do as well, but it looks at all faces around a vertex each time. Returns the faces.
template <class TriangleMesh, class VertexPointMap>
std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor> build_triangle_mesh(
  const Triangle_soup& soup, TriangleMesh& mesh, VertexPointMap vertex_point_map)
{
  using Traits = boost::graph_traits<TriangleMesh>;

  reserve(mesh, static_cast<typename Traits::vertices_size_type>(soup.points.size()),
          static_cast<typename Traits::edges_size_type>(3 * soup.triangles.size() / 2),
          static_cast<typename Traits::faces_size_type>(soup.triangles.size()));
  const auto vertices = add_vertices(soup, mesh, vertex_point_map);
  const auto halfedges = add_edges(soup, mesh);
  std::vector<typename Traits::face_descriptor> faces;
  for (std::size_t face = 0; face < soup.triangles.size(); ++face)
  {
    const auto new_face = add_face(mesh);
    faces.push_back(new_face);
    set_halfedge(new_face, halfedges[3 * face], mesh);
    for (std::size_t side = 3 * face; side < 3 * face + 3; ++side)
    {
      const auto next_halfedge = halfedges[Soup_edges::next(side)];
      const auto target_vertex = vertices[soup.triangles[face][Soup_edges::next(side) % 3]];
      set_next(halfedges[side], next_halfedge, mesh);
      set_face(halfedges[side], new_face, mesh);
      set_target(halfedges[side], target_vertex, mesh);
      set_halfedge(target_vertex, halfedges[side], mesh);
    }
  }
  return faces;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_BUILD_TRIANGLE_MESH_H
