// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_LENGTHS_ALONG_SURFACE_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_LENGTHS_ALONG_SURFACE_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Geodesic_distances.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Mesh_clusters.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Surface_mesh_copy.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/halfedges.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The curve in which a plane through two vertices of a mesh cuts its surface, from one to the
// other. If the plane holds the normal of a smooth surface, this is nearly the shortest way: at
// distance d, the two differ in length by a share of order d^4.
class Surface_section
{
public:
  // points: of unit size, by vertex
  // up: a vector in the plane, out of the surface
  // Precondition: the vertices have two places.
  Surface_section(const Flat_mesh& mesh,
                  const std::vector<Point>& points,
                  int from,
                  int to,
                  const Eigen::Vector3d& up)
    : m_mesh(mesh),
      m_points(points),
      m_from(from),
      m_to(to),
      m_chord(distance(points[from], points[to])),
      m_to_left(up.cross(difference(points[to], points[from])))
  {}

  // In units of the distance between the vertices. Nothing if the curve leads elsewhere, or across
  // a cap, or is longer than half a circle: then it is not nearly the shortest way.
  std::optional<double> length() const
  {
    if (m_mesh.find_halfedge(m_from, m_to) >= 0)
      return 1;
    const double longest = std::acos(0.) * m_chord;
    const int first = first_crossed();
    double sum = 0;
    Point last = m_points[m_from];
    for (int h = first; h >= 0;)
    {
      const int g = opposite_of(h), apex = m_mesh.target(m_mesh.next(g));
      const Point crossing = crossing_of(h);
      sum += distance(last, crossing);
      last = crossing;
      if (m_mesh.is_cap_face(m_mesh.face(g)) || !(sum <= longest))
        break;
      if (apex == m_to)
      {
        sum += distance(last, m_points[m_to]);
        return sum <= longest ? std::optional<double>(sum / m_chord) : std::nullopt;
      }
      h = is_on_left(apex) ? m_mesh.next(g) : m_mesh.prev(g);
      if (h == first)
        break;
    }
    return std::nullopt;
  }

private:
  // in some unit
  double distance_to_left(int v) const
  {
    return dot(m_to_left, difference(m_points[v], m_points[m_from]));
  }

  // The plane itself counts as left, so that each face has two edges that are crossed, or none.
  bool is_on_left(int v) const { return distance_to_left(v) >= 0; }

  // The halfedge across which the curve leaves the faces around its first vertex, from right to
  // left. -1 if there is none or more than one, or that is in a cap.
  int first_crossed() const
  {
    int result = -1;
    for (int h : m_mesh.ring(m_from))
    {
      const int side = m_mesh.next(h);
      if (is_on_left(m_mesh.source(side)) || !is_on_left(m_mesh.target(side)))
        continue;
      if (result >= 0 || m_mesh.is_cap_face(m_mesh.face(h)))
        return -1;
      result = side;
    }
    return result;
  }

  Point crossing_of(int h) const
  {
    const int right = m_mesh.source(h), left = m_mesh.target(h);
    const double to_right = -distance_to_left(right);
    return between(m_points[right], m_points[left], to_right / (to_right + distance_to_left(left)));
  }

  const Flat_mesh& m_mesh;
  const std::vector<Point>& m_points;
  const int m_from, m_to;
  const double m_chord;
  const Eigen::Vector3d m_to_left; // a normal of the plane
};

// By edge of a coarser mesh, its length along the surface of the fine one, in the unit of
// edge_lengths(): chords cut through thin tubes, and through sheets from one side to the other. At
// the rim of a sheet the normals of the two sides give no plane; then it is the shortest way. The
// lengths of the three sides of a face make a triangle if the chords do.
class Lengths_along_surface
{
public:
  Lengths_along_surface(const Flat_mesh& fine, const Mesh_clusters& clusters)
    : m_mesh(clusters.mesh()), m_chords(edge_lengths(m_mesh)), m_lengths(m_chords)
  {
    if (m_mesh.number_of_vertices() == fine.number_of_vertices())
      return;
    const std::vector<Point> points = points_of_unit_size(fine);
    const std::vector<double> fine_lengths = edge_lengths(fine);
    std::vector<Eigen::Vector3d> normals(m_mesh.number_of_vertices());
    for (int c = 0; c < m_mesh.number_of_vertices(); ++c)
      normals[c] = normal(fine, points, clusters.representative(c));
    for (int e = 0; e < m_mesh.number_of_edges(); ++e)
    {
      if (m_mesh.is_cap_edge(e) || !(m_chords[e] > 0))
        continue;
      const int source = m_mesh.source(halfedge_of(e)), target = m_mesh.target(halfedge_of(e));
      const int from = clusters.representative(source), to = clusters.representative(target);
      const std::optional<double> section =
        Surface_section(fine, points, from, to, normals[source] + normals[target]).length();
      m_lengths[e] *= section ? *section : shortest_way(fine, points, fine_lengths, from, to);
    }
    while (restore_chords())
    {}
  }

  const std::vector<double>& lengths() const { return m_lengths; }

private:
  // The mean of those of the faces around a vertex, by area, as a unit vector if it is not 0.
  // (Those of the coarser mesh would not do: some of its faces are folded.)
  static Eigen::Vector3d normal(const Flat_mesh& fine, const std::vector<Point>& points, int v)
  {
    Eigen::Vector3d sum(0, 0, 0);
    for (int h : fine.ring(v))
      if (!fine.is_cap_face(fine.face(h)))
        sum += difference(points[fine.target(h)], points[v])
                 .cross(difference(points[fine.target(fine.next(h))], points[v]));
    const double length = norm(sum);
    return length > 0 ? Eigen::Vector3d(sum / length) : sum;
  }

  // in units of the distance between the vertices
  static double shortest_way(const Flat_mesh& fine,
                             const std::vector<Point>& points,
                             const std::vector<double>& lengths,
                             int from,
                             int to)
  {
    const Geodesic_distances distances(fine, lengths, {from}, [to](int v) { return v != to; });
    return (std::max)(1., distances.distances()[to] / distance(points[from], points[to]));
  }

  // Where the sides of a face make no triangle, they become chords. Whether there was such a face.
  bool restore_chords()
  {
    bool result = false;
    for (int f = 0; f < m_mesh.number_of_faces(); ++f)
    {
      if (is_triangle(f))
        continue;
      for (int h : m_mesh.halfedges(f))
      {
        double& length = m_lengths[edge_of(h)];
        result = result || length > m_chords[edge_of(h)];
        length = m_chords[edge_of(h)];
      }
    }
    return result;
  }

  bool is_triangle(int f) const
  {
    double sum = 0, longest = 0;
    for (int h : m_mesh.halfedges(f))
    {
      sum += m_lengths[edge_of(h)];
      longest = (std::max)(longest, m_lengths[edge_of(h)]);
    }
    return sum > 2 * longest;
  }

  const Flat_mesh& m_mesh;
  const std::vector<double> m_chords;
  std::vector<double> m_lengths;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_LENGTHS_ALONG_SURFACE_H
