// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_MESH_INDEX_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_MESH_INDEX_H

#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Triangle_soup.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Numbers the elements of a FaceGraph, and maps descriptors to numbers and back. Vertices and faces
// are numbered as they are iterated; descriptors are not assumed to be integers.
template <class TriangleMesh>
class Mesh_index
{
  using Traits = boost::graph_traits<TriangleMesh>;

public:
  using vertex_descriptor = typename Traits::vertex_descriptor;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;
  using edge_descriptor = typename Traits::edge_descriptor;
  using face_descriptor = typename Traits::face_descriptor;

  explicit Mesh_index(const TriangleMesh& mesh)
    : m_mesh(&mesh),
      m_vertex_index(get(CGAL::dynamic_vertex_property_t<int>(), mesh)),
      m_halfedge_index(get(CGAL::dynamic_halfedge_property_t<int>(), mesh))
  {
    for (vertex_descriptor v : vertices(mesh))
    {
      put(m_vertex_index, v, static_cast<int>(m_vertices.size()));
      m_vertices.push_back(v);
    }
    for (face_descriptor f : faces(mesh))
      m_faces.push_back(f);
  }

  const TriangleMesh& mesh() const { return *m_mesh; }
  std::size_t number_of_vertices() const { return m_vertices.size(); }
  std::size_t number_of_faces() const { return m_faces.size(); }

  // The mesh as a soup; for a face that is not a triangle, only the first three corners are given,
  // and the first such face is reported.
  template <class VertexPointMap>
  Triangle_soup soup(VertexPointMap vertex_point_map, std::vector<Problem>& problems) const
  {
    Triangle_soup result;
    result.points.reserve(m_vertices.size());
    result.triangles.reserve(m_faces.size());
    for (vertex_descriptor v : m_vertices)
    {
      const auto& p = get(vertex_point_map, v);
      result.points.push_back(
        {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
    }
    for (std::size_t f = 0; f < m_faces.size(); ++f)
    {
      const halfedge_descriptor h = halfedge(m_faces[f], *m_mesh);
      if (problems.empty() && h != next(next(next(h, *m_mesh), *m_mesh), *m_mesh))
        problems.push_back(
          problem(Problem_kind::NOT_TRIANGLE_MESH, "face ", f, " is not a triangle").faces({f}));
      result.triangles.push_back(
        {corner(h), corner(next(h, *m_mesh)), corner(next(next(h, *m_mesh), *m_mesh))});
    }
    return result;
  }

  // Numbers the halfedges like the flat mesh of the same triangles. The halfedges inside caps have
  // no descriptor.
  void number_halfedges(const Flat_mesh& flat)
  {
    m_halfedges.assign(flat.number_of_halfedges(), Traits::null_halfedge());
    for (int f = 0; f < flat.number_of_input_faces(); ++f)
    {
      halfedge_descriptor h = halfedge(m_faces[f], *m_mesh);
      for (int i : flat.halfedges(f))
      {
        set_halfedge(i, h);
        if (flat.is_border_edge(edge_of(i)))
          set_halfedge(opposite_of(i), opposite(h, *m_mesh));
        h = next(h, *m_mesh);
      }
    }
  }

  // The index of a descriptor, or -1 if it belongs to no vertex. Property maps must not be queried
  // with such a descriptor, so the vertices are searched.
  int find(vertex_descriptor v) const
  {
    const auto it = std::find(m_vertices.begin(), m_vertices.end(), v);
    return it == m_vertices.end() ? -1 : static_cast<int>(it - m_vertices.begin());
  }

  bool has_vertex(int i) const { return i < static_cast<int>(m_vertices.size()); }
  bool has_edge(int e) const { return m_halfedges[halfedge_of(e)] != Traits::null_halfedge(); }

  int index(vertex_descriptor v) const { return get(m_vertex_index, v); }
  int index(halfedge_descriptor h) const { return get(m_halfedge_index, h); }
  int edge_index(edge_descriptor e) const { return edge_of(index(halfedge(e, *m_mesh))); }
  vertex_descriptor vertex(int i) const { return m_vertices[i]; }
  halfedge_descriptor halfedge_descriptor_of(int i) const { return m_halfedges[i]; }
  edge_descriptor edge_descriptor_of(int i) const
  {
    return edge(m_halfedges[halfedge_of(i)], *m_mesh);
  }
  face_descriptor face(int i) const { return m_faces[i]; }

private:
  void set_halfedge(int i, halfedge_descriptor h)
  {
    m_halfedges[i] = h;
    put(m_halfedge_index, h, i);
  }

  std::size_t corner(halfedge_descriptor h) const
  {
    return static_cast<std::size_t>(index(source(h, *m_mesh)));
  }

  const TriangleMesh* m_mesh;
  typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<int>>::const_type
    m_vertex_index;
  typename boost::property_map<TriangleMesh, CGAL::dynamic_halfedge_property_t<int>>::const_type
    m_halfedge_index;
  std::vector<vertex_descriptor> m_vertices;
  std::vector<halfedge_descriptor> m_halfedges; // by halfedge of the flat mesh
  std::vector<face_descriptor> m_faces;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_MESH_INDEX_H
