// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FEATURES_NORMAL_SPREADS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FEATURES_NORMAL_SPREADS_H

#include <CGAL/Surface_mesh_foliation/internal/Common/compiled.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>

#include <vector>

#if CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES
#include <CGAL/Surface_mesh_foliation/internal/Features/decimated_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#endif // CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// How the normals within a ball around each vertex are spread, in the part of the surface there
// that is connected to the vertex.
struct Normal_spread
{
  std::vector<double> mean; // length of the mean normal: 1 where flat, 0 where two sides cancel
  std::vector<double> alignment; // largest mean square along a direction: 1 where all are parallel
};

// What distinguishes blades from the rest, by vertex.
struct Blade_measures
{
  Normal_spread wide;            // in a ball of the width of blades
  std::vector<double> sharpness; // the mean in a ball of a third of that radius: 1 where flat
  double unit = 0;               // the square root of the area
};

CGAL_SURFACE_MESH_FOLIATION_INLINE Blade_measures blade_measures(const Flat_mesh& mesh,
                                                                 const std::vector<Point>& points,
                                                                 double relative_width,
                                                                 int decimation_threshold);

#if CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES
class Normal_spreads
{
public:
  // Precondition: `points` do not overflow when multiplied.
  Normal_spreads(const Flat_mesh& mesh, const std::vector<Point>& points) : m_mesh(mesh)
  {
    for (const Point& p : points)
      m_points.push_back(to_vector(p));
    for (int f = 0; f < mesh.number_of_faces(); ++f)
    {
      const int h = mesh.halfedge_of_face(f);
      const Eigen::Vector3d& a = m_points[mesh.source(h)];
      m_normals.push_back(
        (m_points[mesh.target(h)] - a).cross(m_points[mesh.target(mesh.next(h))] - a));
      m_area += m_normals.back().norm() / 2;
    }
  }

  double area() const { return m_area; }

  Normal_spread within(double radius) const
  {
    Normal_spread result;
    std::vector<int> ball, last_ball(m_points.size(), -1);
    for (int v = 0; v < m_mesh.number_of_vertices(); ++v)
    {
      collect(v, radius, last_ball, ball);
      Eigen::Vector3d sum(0, 0, 0);
      Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
      double area = 0;
      for (int u : ball)
        for (int h : m_mesh.ring(u))
        {
          const Eigen::Vector3d& normal = m_normals[m_mesh.face(h)];
          const double length = normal.norm();
          sum += normal;
          area += length;
          if (length > 0)
            tensor += normal * (normal / length).transpose();
        }
      result.mean.push_back(area > 0 ? sum.norm() / area : 1);
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(tensor, Eigen::EigenvaluesOnly);
      result.alignment.push_back(area > 0 ? solver.eigenvalues()[2] / area : 0);
    }
    return result;
  }

private:
  // the vertices near v that can be reached from it; last_ball: by vertex, the last ball it was in
  void collect(int v, double radius, std::vector<int>& last_ball, std::vector<int>& ball) const
  {
    ball = {v};
    last_ball[v] = v;
    for (std::size_t i = 0; i < ball.size(); ++i)
      for (int h : m_mesh.ring(ball[i]))
      {
        const int u = m_mesh.target(h);
        if (last_ball[u] != v && (m_points[u] - m_points[v]).norm() < radius)
        {
          last_ball[u] = v;
          ball.push_back(u);
        }
      }
  }

  const Flat_mesh& m_mesh;
  std::vector<Eigen::Vector3d> m_points;
  std::vector<Eigen::Vector3d> m_normals; // by face, twice as long as its area
  double m_area = 0;
};

inline Blade_measures blade_measures_directly(const Flat_mesh& mesh,
                                              const std::vector<Point>& points,
                                              double relative_width)
{
  const Normal_spreads spreads(mesh, points);
  Blade_measures result;
  result.unit = std::sqrt(spreads.area());
  result.wide = spreads.within(relative_width * result.unit);
  result.sharpness = spreads.within(relative_width * result.unit / 3).mean;
  return result;
}

// The number of vertices in all balls grows with the square of the number of vertices. So the
// measures of a large mesh are those of the nearest vertices of a decimated copy: on a blade they
// hardly differ from one side to the other.
CGAL_SURFACE_MESH_FOLIATION_INLINE Blade_measures blade_measures(const Flat_mesh& mesh,
                                                                 const std::vector<Point>& points,
                                                                 double relative_width,
                                                                 int decimation_threshold)
{
  constexpr int number_of_vertices_left = 10000;
  if (mesh.number_of_vertices() <= decimation_threshold)
    return blade_measures_directly(mesh, points, relative_width);
  const Flat_mesh coarse =
    decimated_mesh(mesh, (std::min)(number_of_vertices_left, decimation_threshold));
  const Blade_measures measures = blade_measures_directly(coarse, coarse.points(), relative_width);
  const Nearest_points nearest(coarse.points());
  Blade_measures result;
  result.unit = measures.unit;
  for (const Point& p : points)
  {
    const int v = nearest(p);
    result.wide.mean.push_back(measures.wide.mean[v]);
    result.wide.alignment.push_back(measures.wide.alignment[v]);
    result.sharpness.push_back(measures.sharpness[v]);
  }
  return result;
}

#endif // CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FEATURES_NORMAL_SPREADS_H
