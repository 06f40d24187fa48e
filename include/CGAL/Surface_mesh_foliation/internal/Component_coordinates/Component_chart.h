// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMPONENT_COORDINATES_COMPONENT_CHART_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMPONENT_COORDINATES_COMPONENT_CHART_H

#include <CGAL/Surface_mesh_foliation/internal/Component_coordinates/Component_layout.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// A component cut open along its seam and laid out in the plane, as a soup of triangles that are
// oriented counterclockwise. A pole is a side of the chart: its faces become quadrilaterals.
class Component_chart
{
public:
  struct Vertex
  {
    std::array<double, 2> uv;
    int vertex; // of the refined mesh
  };

  Component_chart(const Component_layout& layout, int arc) : m_layout(layout)
  {
    const Flat_mesh& mesh = layout.nodes().mesh();
    for (int f = 0; f < mesh.number_of_faces(); ++f)
      if (layout.nodes().refined().faces[f].arc == arc)
        add_face(mesh.halfedges(f));
    number_vertices();
  }

  const std::vector<Vertex>& vertices() const { return m_vertices; }
  const std::vector<Triangle>& triangles() const { return m_triangles; }

private:
  // One end of a side: its place (Component_seams) and its vertex.
  struct Place
  {
    int key;
    Vertex vertex;
  };

  void add_face(const std::array<int, 3>& halfedges)
  {
    const Corner_nodes& nodes = m_layout.nodes();
    const Component_seams& seams = m_layout.seams();
    std::vector<int> polygon;
    const auto add = [&](int node, bool is_left, double u, int h) {
      polygon.push_back(Component_seams::place(node, is_left));
      m_places.push_back({polygon.back(), {{u, nodes.parameter(h)}, nodes.mesh().source(h)}});
    };
    for (int h : halfedges)
    {
      const int g = nodes.mesh().prev(h);
      if (nodes.is_pole(nodes.mesh().source(h)))
        add(nodes.node_of_target(g), seams.is_target_left(g), m_layout.around_of_target(g), h);
      add(nodes.node_of_source(h), seams.is_source_left(h), m_layout.around_of_source(h), h);
    }
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
      m_triangles.push_back({polygon[0], polygon[i], polygon[i + 1]});
  }

  // from keys to positions, in the order of keys
  void number_vertices()
  {
    std::sort(m_places.begin(), m_places.end(),
              [](const Place& a, const Place& b) { return a.key < b.key; });
    std::vector<int> keys;
    for (const Place& place : m_places)
      if (keys.empty() || keys.back() != place.key)
      {
        keys.push_back(place.key);
        m_vertices.push_back(place.vertex);
      }
    for (Triangle& triangle : m_triangles)
      for (int& corner : triangle)
        corner =
          static_cast<int>(std::lower_bound(keys.begin(), keys.end(), corner) - keys.begin());
    m_places = {};
  }

  const Component_layout& m_layout;
  std::vector<Place> m_places;
  std::vector<Vertex> m_vertices;
  std::vector<Triangle> m_triangles;
};

} // namespace internal

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMPONENT_COORDINATES_COMPONENT_CHART_H
