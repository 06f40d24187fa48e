// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_EDGE_VALUE_SURFACE_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_EDGE_VALUE_SURFACE_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>
#include <CGAL/Surface_mesh_foliation/internal/Edge_values/check_edge_values.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// A mesh with foliation values on its edges, in which all singularities are vertices or clusters of
// vertices [5.2.1]: a tripod triangle is cut into three at its center, whose distance from each
// corner is the amount by which that corner is open. So there are three kinds of faces:
//  - regular: one corner is closed, and its vertex lies between the leaves of the other two;
//  - fan: one side is flat (its value is zero), and the leaves run around the opposite corner;
//  - flat: all sides are.
// Which corners are closed is decided here once and for all, and numbers are never consulted again.
// All faces are regular at first; flatten() changes that.
class Edge_value_surface
{
public:
  static constexpr int NONE = -1;

  // Precondition: find_bad_edge_values() finds nothing.
  Edge_value_surface(const Flat_mesh& mesh,
                     const std::vector<double>& value,
                     const Edge_value_tolerances& tolerances)
    : m_tolerances(tolerances), m_number_of_input_vertices(mesh.number_of_vertices())
  {
    std::vector<Point> points = mesh.points();
    std::vector<Triangle> triangles;
    for (int f = 0; f < mesh.number_of_faces(); ++f)
      subdivide(mesh, value, f, points, triangles);
    m_mesh = Flat_mesh(std::move(points), triangles);
    carry_values(mesh, value);
    find_closed_corners();
  }

  const Edge_value_tolerances& tolerances() const { return m_tolerances; }
  const Flat_mesh& mesh() const { return m_mesh; }
  double value(int e) const { return m_is_flat[e] ? 0 : m_value[e]; }
  bool is_flat(int e) const { return m_is_flat[e]; }

  // the halfedge of a face that leaves its closed corner; NONE if the face is not regular
  int closed_corner(int f) const { return m_closed_corner[f]; }

  // Makes an edge flat; the faces beside it are no longer regular. The set of flat sides must be
  // closed in the sense of Noise_removal.
  void flatten(int e)
  {
    m_is_flat[e] = true;
    for (int h : halfedges_of_edge(e))
      m_closed_corner[m_mesh.face(h)] = NONE;
  }

  bool is_face_flat(int f) const
  {
    const std::array<int, 3> sides = m_mesh.halfedges(f);
    return m_is_flat[edge_of(sides[0])] && m_is_flat[edge_of(sides[1])];
  }

  // the halfedge of the input that h comes from; NONE if it leads to or from the center of a tripod
  int input_halfedge(int h) const
  {
    const int first = m_input_halfedge[edge_of(h)];
    return first == NONE || is_forward(h) ? first : opposite_of(first);
  }
  // Vertices of the input come first, then the centers of tripods.
  bool is_center(int v) const { return v >= m_number_of_input_vertices; }
  int origin_of_face(int f) const { return m_origin_of_face[f]; }

private:
  static std::array<double, 3> corners(const Flat_mesh& mesh,
                                       const std::vector<double>& value,
                                       int f)
  {
    const std::array<int, 3> h = mesh.halfedges(f);
    std::array<double, 3> result;
    for (int i : {0, 1, 2})
      result[i] =
        (value[edge_of(h[i])] + value[edge_of(h[(i + 2) % 3])] - value[edge_of(h[(i + 1) % 3])]) /
        2;
    return result;
  }

  void subdivide(const Flat_mesh& mesh,
                 const std::vector<double>& value,
                 int f,
                 std::vector<Point>& points,
                 std::vector<Triangle>& triangles)
  {
    const std::array<int, 3> h = mesh.halfedges(f);
    const Triangle t = {mesh.source(h[0]), mesh.source(h[1]), mesh.source(h[2])};
    const std::array<double, 3> c = corners(mesh, value, f);
    const double largest =
      (std::max)({value[edge_of(h[0])], value[edge_of(h[1])], value[edge_of(h[2])]});
    const bool is_tripod = *std::min_element(c.begin(), c.end()) > m_tolerances.relative * largest;
    if (!is_tripod)
    {
      triangles.push_back(t);
      m_origin_of_face.push_back(f);
      return;
    }
    const int center = static_cast<int>(points.size());
    points.push_back(centroid(mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2])));
    m_legs.push_back(c);
    for (int i : {0, 1, 2})
    {
      triangles.push_back({t[i], t[(i + 1) % 3], center});
      m_origin_of_face.push_back(f);
    }
  }

  void carry_values(const Flat_mesh& mesh, const std::vector<double>& value)
  {
    m_value.assign(m_mesh.number_of_edges(), 0);
    m_is_flat.assign(m_mesh.number_of_edges(), false);
    m_input_halfedge.assign(m_mesh.number_of_edges(), NONE);
    for (int e = 0; e < mesh.number_of_edges(); ++e)
    {
      const int h = m_mesh.find_halfedge(mesh.source(halfedge_of(e)), mesh.target(halfedge_of(e)));
      m_value[edge_of(h)] = value[e];
      m_input_halfedge[edge_of(h)] = is_forward(h) ? halfedge_of(e) : opposite_of(halfedge_of(e));
    }
    for (std::size_t i = 0; i < m_legs.size(); ++i)
    {
      const int center = m_number_of_input_vertices + static_cast<int>(i);
      const int origin = m_origin_of_face[m_mesh.face(m_mesh.ring(center)[0])];
      for (int h : m_mesh.ring(center))
        for (int k : {0, 1, 2})
          if (mesh.source(mesh.halfedges(origin)[k]) == m_mesh.target(h))
            m_value[edge_of(h)] = m_legs[i][k];
    }
  }

  // for each triangle, the corner that is open least
  void find_closed_corners()
  {
    m_closed_corner.resize(m_mesh.number_of_faces());
    for (int f = 0; f < m_mesh.number_of_faces(); ++f)
    {
      const std::array<int, 3> h = m_mesh.halfedges(f);
      const std::array<double, 3> c = corners(m_mesh, m_value, f);
      int closed = static_cast<int>(std::min_element(c.begin(), c.end()) - c.begin());
      for (int i : {0, 1, 2})
        if (is_center(m_mesh.source(h[i])))
          closed = i;
      m_closed_corner[f] = h[closed];
    }
  }

  Edge_value_tolerances m_tolerances;
  int m_number_of_input_vertices;
  Flat_mesh m_mesh;
  std::vector<double> m_value;               // by edge
  std::vector<bool> m_is_flat;               // by edge
  std::vector<int> m_input_halfedge;         // by edge, of its forward halfedge
  std::vector<int> m_closed_corner;          // by face
  std::vector<int> m_origin_of_face;         // by face
  std::vector<std::array<double, 3>> m_legs; // by center, in the order of its input face
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_EDGE_VALUE_SURFACE_H
