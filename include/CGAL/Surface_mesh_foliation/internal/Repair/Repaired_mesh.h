// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_REPAIR_REPAIRED_MESH_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_REPAIR_REPAIRED_MESH_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Triangle_soup.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/build_triangle_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Repair/Traced_soup.h>
#include <CGAL/Surface_mesh_foliation/internal/Repair/triangulate_polygon.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// An oriented manifold of triangles, perhaps with borders, whose vertices and faces know what they
// come from. CGAL repairs what needs a mesh.
class Repaired_mesh
{
  using Mesh = CGAL::Surface_mesh<Exact_predicate_point>;

public:
  explicit Repaired_mesh(const Traced_soup& soup)
  {
    Triangle_soup triangles;
    triangles.points = soup.points;
    for (const Traced_soup::Face& face : soup.faces)
      triangles.triangles.push_back({face[0], face[1], face[2]});
    const auto new_faces = build_triangle_mesh(triangles, m_mesh, m_mesh.points());
    m_vertex_origin =
      m_mesh.add_property_map<Mesh::Vertex_index, std::size_t>("v:origin", no_element).first;
    m_face_origin =
      m_mesh.add_property_map<Mesh::Face_index, std::size_t>("f:origin", no_element).first;
    std::size_t i = 0; // a new mesh has its vertices in the order of their creation
    for (const auto v : m_mesh.vertices())
      m_vertex_origin[v] = soup.vertex_origins[i++];
    for (std::size_t f = 0; f < new_faces.size(); ++f)
      m_face_origin[new_faces[f]] = soup.face_origins[f];
    for (const auto v : m_mesh.vertices())
      if (m_mesh.is_isolated(v))
        m_mesh.remove_vertex(v);
  }

  // Joins borders at equal positions that belong to the same part; returns the number of edges.
  std::size_t stitch()
  {
    return Polygon_mesh_processing::stitch_borders(
      m_mesh, CGAL::parameters::apply_per_connected_component(true));
  }

  // returns the number of faces that had no area
  std::size_t remove_degenerate_faces()
  {
    std::size_t result = 0;
    for (const auto f : m_mesh.faces())
      result += is_degenerate(f);
    if (result > 0)
      Polygon_mesh_processing::remove_degenerate_faces(m_mesh);
    return result;
  }

  // A vertex may have several umbrellas once faces at a border are gone. Returns the number of
  // copies made of such vertices.
  std::size_t separate_umbrellas()
  {
    std::vector<std::vector<Mesh::Vertex_index>> copies; // each behind the vertex it was made of
    const std::size_t result = Polygon_mesh_processing::duplicate_non_manifold_vertices(
      m_mesh, CGAL::parameters::output_iterator(std::back_inserter(copies)));
    for (const std::vector<Mesh::Vertex_index>& vertices : copies)
      for (const Mesh::Vertex_index v : vertices)
        m_vertex_origin[v] = m_vertex_origin[vertices[0]];
    return result;
  }

  // Of two faces that are joined along all three edges, as borders may be, the later one goes.
  // Returns the number of faces that were removed.
  std::size_t remove_backs_of_faces()
  {
    std::vector<Mesh::Face_index> backs;
    for (const auto f : m_mesh.faces())
    {
      const auto back = face_behind(f);
      if (back != Mesh::null_face() &&
          std::make_pair(m_face_origin[f], f) < std::make_pair(m_face_origin[back], back))
        backs.push_back(back);
    }
    for (const auto f : backs)
      CGAL::Euler::remove_face(m_mesh.halfedge(f), m_mesh);
    return backs.size();
  }

  // Vertices and faces in the order of what they come from; new ones come last.
  void output(Triangle_soup& soup,
              std::vector<std::size_t>& vertex_origins,
              std::vector<std::size_t>& face_origins) const
  {
    const auto vertices = sorted(m_mesh.vertices(), m_vertex_origin);
    std::vector<std::size_t> number_of_vertex(m_mesh.number_of_vertices() +
                                              m_mesh.number_of_removed_vertices());
    for (const auto v : vertices)
    {
      const auto& p = m_mesh.point(v);
      number_of_vertex[v] = soup.points.size();
      soup.points.push_back({p.x(), p.y(), p.z()});
      vertex_origins.push_back(m_vertex_origin[v]);
    }
    for (const auto f : sorted(m_mesh.faces(), m_face_origin))
    {
      const auto h = m_mesh.halfedge(f);
      soup.triangles.push_back({number_of_vertex[m_mesh.source(h)],
                                number_of_vertex[m_mesh.target(h)],
                                number_of_vertex[m_mesh.target(m_mesh.next(h))]});
      face_origins.push_back(m_face_origin[f]);
    }
  }

private:
  template <class Range, class Map>
  static std::vector<typename Map::key_type> sorted(const Range& range, const Map& key)
  {
    std::vector<typename Map::key_type> result(range.begin(), range.end());
    std::stable_sort(result.begin(), result.end(),
                     [&](const auto& a, const auto& b) { return key[a] < key[b]; });
    return result;
  }

  // the face that has all three edges of f, too; null if there is none
  Mesh::Face_index face_behind(Mesh::Face_index f) const
  {
    const auto h = m_mesh.halfedge(f);
    const auto result = m_mesh.face(m_mesh.opposite(h));
    for (const auto side : {m_mesh.next(h), m_mesh.prev(h)})
      if (m_mesh.face(m_mesh.opposite(side)) != result)
        return Mesh::null_face();
    return result;
  }

  bool is_degenerate(Mesh::Face_index f) const
  {
    const auto h = m_mesh.halfedge(f);
    return CGAL::collinear(m_mesh.point(m_mesh.source(h)), m_mesh.point(m_mesh.target(h)),
                           m_mesh.point(m_mesh.target(m_mesh.next(h))));
  }

  Mesh m_mesh;
  Mesh::Property_map<Mesh::Vertex_index, std::size_t> m_vertex_origin;
  Mesh::Property_map<Mesh::Face_index, std::size_t> m_face_origin;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_REPAIR_REPAIRED_MESH_H
