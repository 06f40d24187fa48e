// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FEATURES_DECIMATED_MESH_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FEATURES_DECIMATED_MESH_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Surface_mesh_copy.h>

#include <CGAL/Kd_tree.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Midpoint_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// tells when enough edges have been collapsed
struct Few_edges
{
  std::size_t number;

  template <class Cost, class Profile>
  bool operator()(const Cost&, const Profile&, std::size_t, std::size_t number_left) const
  {
    return number_left <= number;
  }
};

// A coarser mesh of the same surface, scaled to unit size: the shortest edge is repeatedly
// collapsed to its midpoint.
inline Flat_mesh decimated_mesh(const Flat_mesh& fine, int number_of_vertices)
{
  namespace SMS = CGAL::Surface_mesh_simplification;
  Surface_mesh_copy copy = surface_mesh_copy(fine);
  SMS::edge_collapse(copy, Few_edges{3 * static_cast<std::size_t>(number_of_vertices)},
                     CGAL::parameters::get_cost(SMS::Edge_length_cost<Surface_mesh_copy>())
                       .get_placement(SMS::Midpoint_placement<Surface_mesh_copy>()));
  copy.collect_garbage();
  std::vector<Point> points;
  for (const auto v : vertices(copy))
    points.push_back({copy.point(v).x(), copy.point(v).y(), copy.point(v).z()});
  std::vector<Triangle> triangles;
  for (const auto f : faces(copy))
  {
    const auto h = halfedge(f, copy);
    triangles.push_back({static_cast<int>(source(h, copy)), static_cast<int>(target(h, copy)),
                         static_cast<int>(target(next(h, copy), copy))});
  }
  return Flat_mesh(points, triangles);
}

// Finds the nearest of some points; which of equally near ones is unspecified, but always the same.
class Nearest_points
{
public:
  explicit Nearest_points(const std::vector<Point>& points)
  {
    for (std::size_t i = 0; i < points.size(); ++i)
      m_tree.insert({point(points[i]), static_cast<int>(i)});
    m_tree.build();
  }

  int operator()(const Point& p) const
  {
    const CGAL::Orthogonal_k_neighbor_search<Traits> search(m_tree, point(p), 1);
    return search.begin()->first.second;
  }

private:
  using Kernel = CGAL::Simple_cartesian<double>;
  using Entry = std::pair<Kernel::Point_3, int>;
  using Traits = CGAL::Search_traits_adapter<Entry,
                                             CGAL::First_of_pair_property_map<Entry>,
                                             CGAL::Search_traits_3<Kernel>>;

  static Kernel::Point_3 point(const Point& p) { return {p[0], p[1], p[2]}; }

  CGAL::Kd_tree<Traits> m_tree;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FEATURES_DECIMATED_MESH_H
