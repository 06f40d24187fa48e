// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_WEIGHTS_OF_FLAT_MESH_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_WEIGHTS_OF_FLAT_MESH_H

#include <CGAL/Surface_mesh_foliation/internal/Common/Executor.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The shape of a corner of a triangle, from coordinates divided by the size of the mesh, so that
// nothing overflows or vanishes at any scale.
class Corner_geometry
{
public:
  explicit Corner_geometry(const Flat_mesh& mesh) : m_mesh(mesh)
  {
    m_exponent = std::ilogb(half_size(bounding_box(mesh.points())));
    m_scale = std::scalbn(1., -m_exponent / 2);
    m_other_scale = std::scalbn(1., -m_exponent - -m_exponent / 2);
  }

  // looks at the corner of source(h) in face(h)
  void visit(int h)
  {
    const Eigen::Vector3d a = vector(h), b = vector(opposite_of(m_mesh.prev(h)));
    m_length = norm(a);
    m_other_length = norm(b);
    m_dot = dot(a, b);
    m_cross = norm_of_cross(a, b);
  }

  // the factor that converts lengths to those of the mesh
  double unit() const { return std::scalbn(1., m_exponent); }

  // of halfedge h, divided by unit()
  double length_of(int h) const { return norm(vector(h)); }

  // of half the angle: sin / (1 + cos) or (1 - cos) / sin, whichever does not cancel
  double tangent_of_half() const
  {
    const double product = m_length * m_other_length;
    return m_dot > 0 ? m_cross / (product + m_dot) : (product - m_dot) / m_cross;
  }

  double cotangent() const { return m_dot / m_cross; }

  // of the triangle; the unit is the square of that of lengths
  double area() const { return m_cross / 2; }

private:
  // Where the plain formula loses digits, the one without cancellation is used; and no triangle is
  // degenerate, whatever rounding does to its edges.
  double norm_of_cross(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const
  {
    const double product = m_length * m_other_length;
    const double plain = norm(a.cross(b));
    if (plain > sine_of_slivers * product)
      return plain;
    return (std::max)(
      norm({determinant(a[1], b[2], a[2], b[1]), determinant(a[2], b[0], a[0], b[2]),
            determinant(a[0], b[1], a[1], b[0])}),
      least_sine * product);
  }

  // w x - y z without cancellation, by Kahan's algorithm
  static double determinant(double w, double x, double y, double z)
  {
    const double yz = y * z, error = std::fma(-y, z, yz);
    return std::fma(w, x, -yz) + error;
  }

  Eigen::Vector3d vector(int h) const
  {
    return scaled(m_mesh.target(h)) - scaled(m_mesh.source(h));
  }

  Eigen::Vector3d scaled(int v) const
  {
    return to_vector(m_mesh.point(v)) * m_scale * m_other_scale;
  }

  static constexpr double sine_of_slivers = 1e-4, least_sine = 1e-32;

  const Flat_mesh& m_mesh;
  int m_exponent = 0;
  double m_scale = 1, m_other_scale = 1; // 2^-m_exponent in two factors that are finite
  double m_length = 0, m_other_length = 0, m_dot = 0, m_cross = 0;
};

// by halfedge h: value(corner) of the corner of source(h) in face(h); 0 in caps
template <class Value>
std::vector<double> corner_values(const Flat_mesh& mesh,
                                  const Corner_geometry& geometry,
                                  const Executor& executor,
                                  const Value& value)
{
  std::vector<double> result(mesh.number_of_halfedges());
  executor(mesh.number_of_halfedges(), [&](int, int first, int last) {
    Corner_geometry corner = geometry;
    for (int h = first; h < last; ++h)
    {
      if (mesh.is_cap_face(mesh.face(h)))
        continue;
      corner.visit(h);
      result[h] = value(corner);
    }
  });
  return result;
}

// On faces that are flat up to rounding, the tangents and cotangents that weights are made of grow
// without bound. Vertices tied together by very large weights are as good as at one place in T, and
// differences between them drown in rounding; so from here on, weights grow no more.
constexpr double largest_tangent = 1e5;

// The same holds for edges that are so short beside the others of their faces.
constexpr double shortest_edge = 1e-8;

// by edge: what its length counts as
inline std::vector<double> lengths_for_weights(const Flat_mesh& mesh,
                                               const Corner_geometry& geometry,
                                               const Executor& executor)
{
  std::vector<double> length(mesh.number_of_edges()), result(mesh.number_of_edges());
  for_each_number(executor, mesh.number_of_edges(),
                  [&](int e) { length[e] = geometry.length_of(halfedge_of(e)); });
  for_each_number(executor, mesh.number_of_edges(), [&](int e) {
    const int h = halfedge_of(e), g = opposite_of(h);
    const double longest =
      (std::max)({length[edge_of(mesh.next(h))], length[edge_of(mesh.prev(h))],
                  length[edge_of(mesh.next(g))], length[edge_of(mesh.prev(g))]});
    result[e] = (std::max)(length[e], shortest_edge * longest);
  });
  return result;
}

// by edge; 0 inside caps
inline std::vector<double> mean_value_weights(
  const Flat_mesh& mesh, const Executor& executor = executor_for<CGAL::Sequential_tag>())
{
  const Corner_geometry geometry(mesh);
  const std::vector<double> tangent = corner_values(
    mesh, geometry, executor, [](const Corner_geometry& c) { return c.tangent_of_half(); });
  std::vector<double> result = lengths_for_weights(mesh, geometry, executor);
  for_each_number(executor, mesh.number_of_edges(), [&](int e) {
    const int h = halfedge_of(e), g = opposite_of(halfedge_of(e));
    const double sum = tangent[h] + tangent[mesh.next(g)] + tangent[g] + tangent[mesh.next(h)];
    result[e] = (std::min)(sum, largest_tangent) / result[e] / 2 / geometry.unit();
  });
  return result;
}

// by edge; 0 inside caps
inline std::vector<double> cotangent_weights(
  const Flat_mesh& mesh, const Executor& executor = executor_for<CGAL::Sequential_tag>())
{
  const std::vector<double> cotangent =
    corner_values(mesh, Corner_geometry(mesh), executor,
                  [](const Corner_geometry& corner) { return corner.cotangent(); });
  std::vector<double> result(mesh.number_of_edges());
  for_each_number(executor, mesh.number_of_edges(), [&](int e) {
    result[e] = (std::min)(cotangent[mesh.prev(halfedge_of(e))] +
                             cotangent[mesh.prev(opposite_of(halfedge_of(e)))],
                           largest_tangent) /
                2;
  });
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_WEIGHTS_OF_FLAT_MESH_H
