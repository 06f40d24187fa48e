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

template <class TriangleMesh>
struct New_edges
{
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  // a halfedge without face, and the numbers of its vertices
  struct Border
  {
    halfedge_descriptor halfedge;
    std::size_t source, target;
  };
  std::vector<halfedge_descriptor> of_side; // of the soup
  std::vector<Border> borders;
};

// All edges must have one side, or two with opposite directions.
template <class TriangleMesh>
New_edges<TriangleMesh> add_edges(const Triangle_soup& soup, TriangleMesh& mesh)
{
  const Soup_edges edges(soup);
  New_edges<TriangleMesh> result;
  result.of_side.resize(3 * soup.triangles.size());
  for (std::size_t edge = 0; edge < edges.size(); ++edge)
  {
    const auto new_halfedge = halfedge(add_edge(mesh), mesh);
    const std::size_t side = edges.side(edge, 0);
    result.of_side[side] = new_halfedge;
    if (edges.number_of_sides(edge) == 2)
      result.of_side[edges.side(edge, 1)] = opposite(new_halfedge, mesh);
    else
      result.borders.push_back(
        {opposite(new_halfedge, mesh), edges.target(side), edges.source(side)});
  }
  return result;
}

// Joins the halfedges without faces to cycles, which pass each vertex at most once.
template <class TriangleMesh>
void link_borders(
  const New_edges<TriangleMesh>& edges,
  const std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>& vertices,
  TriangleMesh& mesh)
{
  using Traits = boost::graph_traits<TriangleMesh>;
  std::vector<typename Traits::halfedge_descriptor> leaving(
    edges.borders.empty() ? 0 : vertices.size());
  for (const auto& border : edges.borders)
    leaving[border.source] = border.halfedge;
  for (const auto& border : edges.borders)
  {
    set_face(border.halfedge, Traits::null_face(), mesh);
    set_target(border.halfedge, vertices[border.target], mesh);
    set_next(border.halfedge, leaving[border.target], mesh);
    set_halfedge(vertices[border.target], border.halfedge, mesh); // which tells that it is a border
  }
}

// adds to a mesh a soup that `check_triangle_soup()` has found valid, openings allowed.
// `Euler::add_face()` would do as well, but it looks at all faces around a vertex each time.
// Returns the faces.
template <class TriangleMesh, class VertexPointMap>
std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor> build_triangle_mesh(
  const Triangle_soup& soup, TriangleMesh& mesh, VertexPointMap vertex_point_map)
{
  using Traits = boost::graph_traits<TriangleMesh>;

  reserve(mesh, static_cast<typename Traits::vertices_size_type>(soup.points.size()),
          static_cast<typename Traits::edges_size_type>(3 * soup.triangles.size() / 2),
          static_cast<typename Traits::faces_size_type>(soup.triangles.size()));
  const auto vertices = add_vertices(soup, mesh, vertex_point_map);
  const New_edges<TriangleMesh> edges = add_edges(soup, mesh);
  const auto& halfedges = edges.of_side;
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
  link_borders(edges, vertices, mesh);
  return faces;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_BUILD_TRIANGLE_MESH_H
