// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_REPAIR_FACE_TRIANGULATION_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_REPAIR_FACE_TRIANGULATION_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>
#include <CGAL/Surface_mesh_foliation/internal/Repair/triangulate_polygon.h>
#include <CGAL/Surface_mesh_foliation/internal/Repair/Traced_soup.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Cuts the faces of a soup into triangles, in their order.
class Face_triangulation
{
public:
  explicit Face_triangulation(Traced_soup& soup) : m_soup(soup)
  {
    for (const Traced_soup::Edge& edge : soup.edges_of_faces())
      m_edges.insert(m_edges.end(), edge); // sorted, so in constant time
  }

  // returns the number of faces that were cut
  std::size_t run()
  {
    std::size_t result = 0;
    for (std::size_t f = 0; f < m_soup.faces.size(); ++f)
    {
      result += m_soup.faces[f].size() > 3;
      cut(f);
    }
    m_soup.set_faces(std::move(m_faces), m_origins);
    return result;
  }

private:
  // by diagonals; if these would be edges elsewhere, or cannot be found, by a fan around a new
  // vertex
  void cut(std::size_t f)
  {
    const Traced_soup::Face face = m_soup.faces[f];
    if (face.size() == 3)
      return add(face, f);
    std::vector<Point> points;
    points.reserve(face.size());
    for (const std::size_t v : face)
      points.push_back(m_soup.points[v]);
    const auto triangles = triangulate_polygon(points);
    const auto diagonals = triangles ? diagonals_of(*triangles, face) : std::nullopt;
    if (!diagonals)
      return add_fan(face, points, f);
    m_edges.insert(diagonals->begin(), diagonals->end());
    for (const Corner_triangle& corners : *triangles)
      add({face[corners[0]], face[corners[1]], face[corners[2]]}, f);
  }

  // nothing if one of them is an edge already
  std::optional<std::set<Traced_soup::Edge>> diagonals_of(
    const std::vector<Corner_triangle>& triangles, const Traced_soup::Face& face) const
  {
    std::set<Traced_soup::Edge> result;
    for (const auto& [i, j] : diagonals_of_triangulation(triangles, face.size()))
    {
      const Traced_soup::Edge edge((std::min)(face[i], face[j]), (std::max)(face[i], face[j]));
      if (m_edges.count(edge) > 0)
        return std::nullopt;
      result.insert(edge);
    }
    return result;
  }

  void add_fan(const Traced_soup::Face& face, const std::vector<Point>& points, std::size_t f)
  {
    const std::size_t center = m_soup.add_new_vertex(centroid_of_polygon(points));
    for (std::size_t i = 0; i < face.size(); ++i)
      add({face[i], face[(i + 1) % face.size()], center}, f);
  }

  void add(Traced_soup::Face triangle, std::size_t origin)
  {
    m_faces.push_back(std::move(triangle));
    m_origins.push_back(origin);
  }

  Traced_soup& m_soup;
  std::set<Traced_soup::Edge> m_edges;
  std::vector<Traced_soup::Face> m_faces;
  std::vector<std::size_t> m_origins;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_REPAIR_FACE_TRIANGULATION_H
