// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_EXPERIMENTS_MEDIAL_AXIS_H
#define SMF_EXPERIMENTS_MEDIAL_AXIS_H

#include "generators/Random.h"
#include "generators/meshes.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace smf_experiments {

// The medial axis of the inside of a closed surface: the centers of the balls that touch it at two
// places or more. It is represented by points, the inner poles of random samples of the surface: of
// each sample the farthest of those vertices of its Voronoi cell that lie inside (Amenta and Bern).
//
// Every convex edge of a mesh has a sheet of the medial axis, of balls that touch the two faces at
// the edge. Such sheets count only if the normals turn by 60 degrees or more: a pole is left out if
// no two of the samples on its ball have normals that differ as much.
class Medial_axis
{
public:
  using Kernel = smf_test::Kernel;
  using Mesh = smf_test::Mesh;
  using Point = Kernel::Point_3;
  using Ball = std::pair<Point, double>; // center and radius

  Medial_axis(const Mesh& mesh, std::size_t number_of_samples, std::uint64_t seed)
  {
    const std::vector<Sample> samples = random_samples(mesh, number_of_samples, seed);
    const Triangulation triangulation(samples.begin(), samples.end());
    const CGAL::Side_of_triangle_mesh<Mesh, Kernel> side(mesh);
    for (const auto v : triangulation.finite_vertex_handles())
      if (const auto ball = ball_of_inner_pole(triangulation, v, side))
        m_balls.push_back(*ball);
    m_tree.insert(m_balls.begin(), m_balls.end());
    m_tree.build();
  }

  const std::vector<Ball>& balls() const { return m_balls; }

  // that with the nearest center
  Ball nearest_ball(const Point& p) const { return Search(m_tree, p, 1).begin()->first; }

private:
  using Vector = Kernel::Vector_3;
  using Sample = std::pair<Point, Vector>; // with the normal
  using Triangulation =
    CGAL::Delaunay_triangulation_3<Kernel,
                                   CGAL::Triangulation_data_structure_3<
                                     CGAL::Triangulation_vertex_base_with_info_3<Vector, Kernel>,
                                     CGAL::Delaunay_triangulation_cell_base_3<Kernel>>>;
  using Cell = Triangulation::Cell_handle;
  using Traits = CGAL::Search_traits_adapter<Ball,
                                             CGAL::First_of_pair_property_map<Ball>,
                                             CGAL::Search_traits_3<Kernel>>;
  using Search = CGAL::Orthogonal_k_neighbor_search<Traits>;

  // one sample for each of equal shares of the area, face by face; CGAL's samplers do not tell
  // which face a point is on
  static std::vector<Sample> random_samples(const Mesh& mesh,
                                            std::size_t number,
                                            std::uint64_t seed)
  {
    namespace PMP = CGAL::Polygon_mesh_processing;
    const double share = PMP::area(mesh) / static_cast<double>(number);
    smf_test::Random random(seed);
    std::vector<Sample> result;
    double area = 0; // of the faces so far
    for (const auto f : faces(mesh))
    {
      area += PMP::face_area(f, mesh);
      if (area < share * static_cast<double>(result.size() + 1))
        continue;
      const Vector normal = PMP::compute_face_normal(f, mesh);
      while (share * static_cast<double>(result.size() + 1) <= area)
        result.emplace_back(random_point(mesh, f, random), normal);
    }
    return result;
  }

  static Point random_point(const Mesh& mesh, Mesh::Face_index f, smf_test::Random& random)
  {
    const auto h = mesh.halfedge(f);
    const Point &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h)),
                &r = mesh.point(mesh.target(mesh.next(h)));
    double s = random.between(0, 1), t = random.between(0, 1);
    if (s + t > 1) // in the other half of the parallelogram
    {
      s = 1 - s;
      t = 1 - t;
    }
    return p + s * (q - p) + t * (r - p);
  }

  template <class Side>
  static std::optional<Ball> ball_of_inner_pole(const Triangulation& triangulation,
                                                Triangulation::Vertex_handle v,
                                                const Side& side)
  {
    std::vector<Cell> cells;
    triangulation.finite_incident_cells(v, std::back_inserter(cells));
    std::vector<std::pair<Ball, Cell>> balls;
    for (const Cell cell : cells)
      if (const auto ball = circumscribed_ball(triangulation, cell))
        balls.emplace_back(*ball, cell);
    std::sort(balls.begin(), balls.end(),
              [](const auto& a, const auto& b) { return a.first.second > b.first.second; });
    const auto pole = std::find_if(balls.begin(), balls.end(), [&](const auto& ball) {
      return side(ball.first.first) == CGAL::ON_BOUNDED_SIDE;
    });
    if (pole == balls.end() || !normals_differ(pole->second))
      return std::nullopt;
    return pole->first;
  }

  // nothing if the cell is so flat that its center would be made of rounding errors
  static std::optional<Ball> circumscribed_ball(const Triangulation& triangulation, Cell cell)
  {
    const auto tetrahedron = triangulation.tetrahedron(cell);
    double size = 0;
    for (int i = 1; i < 4; ++i)
      size = (std::max)(size, CGAL::squared_distance(tetrahedron[0], tetrahedron[i]));
    if (!(tetrahedron.volume() > 1e-9 * size * std::sqrt(size)))
      return std::nullopt;
    const Point center = triangulation.dual(cell);
    return Ball(center, std::sqrt(CGAL::squared_distance(center, tetrahedron[0])));
  }

  // whether the normals at two vertices of a cell differ by at least 60 degrees
  static bool normals_differ(Cell cell)
  {
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < i; ++j)
        if (cell->vertex(i)->info() * cell->vertex(j)->info() <= 0.5)
          return true;
    return false;
  }

  std::vector<Ball> m_balls;
  CGAL::Kd_tree<Traits> m_tree;
};

} // namespace smf_experiments

#endif // SMF_EXPERIMENTS_MEDIAL_AXIS_H
