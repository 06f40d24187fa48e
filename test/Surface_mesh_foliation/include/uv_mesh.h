// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_UV_MESH_H
#define SMF_TEST_UV_MESH_H

#include "generators/meshes.h"

#include <CGAL/Surface_mesh_foliation/Component_coordinates.h>
#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>

#include <CGAL/boost/graph/properties.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

// The cut mesh with the coordinates of components at its corners.

namespace smf_test {

using Uv = std::array<double, 2>;

inline double area(const Uv& p, const Uv& q, const Uv& r)
{
  return ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])) / 2;
}

// the total area of a chart, and the smallest area of a face
template <class Chart>
std::array<double, 2> areas(const Chart& chart)
{
  const auto points = get(CGAL::vertex_point, chart);
  std::array<double, 2> result = {0, 1e300};
  for (const auto f : faces(chart))
  {
    const auto h = halfedge(f, chart);
    const auto uv = [&](auto v) {
      EXPECT_EQ(get(points, v).z(), 0);
      return Uv{get(points, v).x(), get(points, v).y()};
    };
    const double x =
      area(uv(source(h, chart)), uv(target(h, chart)), uv(target(next(h, chart), chart)));
    result[0] += x;
    result[1] = std::min(result[1], x);
  }
  return result;
}

// the area of a component on its cylinder
inline double size_of(const CGAL::Surface_mesh_foliation::Measured_foliation<Mesh>& foliation,
                      std::size_t arc)
{
  return foliation.system().height(arc) * foliation.flux(arc);
}

// the cut mesh with everything on it
struct Uv_mesh
{
  explicit Uv_mesh(const CGAL::Surface_mesh_foliation::Component_coordinates<Mesh>& coordinates)
    : uv(mesh.add_property_map<Mesh::Halfedge_index, Uv>("h:uv").first),
      component(mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component").first),
      is_critical(mesh.add_property_map<Mesh::Edge_index, bool>("e:critical", false).first)
  {
    coordinates.uv_mesh(mesh, uv,
                        CGAL::Surface_mesh_foliation::parameters::face_component_map(component)
                          .edge_is_constrained_map(is_critical));
  }

  bool has_coordinates(Mesh::Face_index f) const { return !std::isnan(uv[halfedge(f, mesh)][0]); }

  double area_of(Mesh::Face_index f) const
  {
    const auto h = halfedge(f, mesh);
    return area(uv[h], uv[next(h, mesh)], uv[next(next(h, mesh), mesh)]);
  }

  Mesh mesh;
  Mesh::Property_map<Mesh::Halfedge_index, Uv> uv;
  Mesh::Property_map<Mesh::Face_index, std::size_t> component;
  Mesh::Property_map<Mesh::Edge_index, bool> is_critical;
};

} // namespace smf_test

#endif // SMF_TEST_UV_MESH_H
