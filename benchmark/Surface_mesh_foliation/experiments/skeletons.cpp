// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What is asked of curve skeletons: those of foliations beside those by mean curvature flow, on the
// same shapes. Runs: how often flow is repeated, since its result is another one each time.

#include "Command_line.h"
#include "Medial_axis.h"
#include "Part_graph.h"
#include "Shapes.h"
#include "Variants.h"

#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/curve_skeleton.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_embedding.h>

#include <CGAL/Mean_curvature_flow_skeletonization.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Timer.h>

#include <boost/graph/connected_components.hpp>
#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

using namespace smf_experiments;

using Flow = CGAL::Mean_curvature_flow_skeletonization<Mesh>;
using Skeleton = Flow::Skeleton; // a type for both

Skeleton skeleton_of_foliation(const Mesh& mesh, const SMF::Poles_and_loops<Mesh>& input)
{
  const auto foliation = SMF::harmonic_foliation(SMF::Loop_system<Mesh>(mesh, input));
  Skeleton result;
  SMF::curve_skeleton(foliation, SMF::reeb_graph_embedding(foliation), result);
  return result;
}

Skeleton skeleton_by_flow(const Mesh& mesh)
{
  Skeleton result;
  Flow flow(mesh);
  flow(result);
  return result;
}

// points on the edges, about `step` apart
std::vector<Point> samples(const Skeleton& skeleton, double step)
{
  std::vector<Point> result;
  for (const auto& edge : boost::make_iterator_range(edges(skeleton)))
  {
    const Point &p = skeleton[source(edge, skeleton)].point,
                &q = skeleton[target(edge, skeleton)].point;
    const double length = std::sqrt(CGAL::squared_distance(p, q));
    const int n = static_cast<int>(std::ceil(length / step));
    for (int i = 0; i < n; ++i)
      result.push_back(p + (q - p) * ((i + 0.5) / n));
  }
  return result;
}

// the sum of the angles by which the skeleton turns at its vertices of degree 2, by the length
double turning(const Skeleton& skeleton)
{
  double angle = 0, length = 0;
  for (const auto& edge : boost::make_iterator_range(edges(skeleton)))
    length += std::sqrt(CGAL::squared_distance(skeleton[source(edge, skeleton)].point,
                                               skeleton[target(edge, skeleton)].point));
  for (const auto v : boost::make_iterator_range(vertices(skeleton)))
    if (degree(v, skeleton) == 2)
    {
      std::vector<Kernel::Vector_3> arms;
      for (const auto& edge : boost::make_iterator_range(out_edges(v, skeleton)))
        arms.push_back(skeleton[target(edge, skeleton)].point - skeleton[v].point);
      const double product = std::sqrt(arms[0].squared_length() * arms[1].squared_length());
      if (product > 0)
        angle += std::acos(std::clamp(-(arms[0] * arms[1]) / product, -1., 1.));
    }
  return angle / length;
}

// of values, in any order, the one above a share of them; 0 if there are none
double quantile(std::vector<double> values, double share)
{
  if (values.empty())
    return 0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size()))];
}

// How far points are from the medial axis: in units of its distance from the surface where it is
// nearest, and in a given unit of length.
struct Distances
{
  Distances(const Medial_axis& axis, const std::vector<Point>& points, double unit)
  {
    for (const Point& p : points)
    {
      const auto [center, radius] = axis.nearest_ball(p);
      const double distance = std::sqrt(CGAL::squared_distance(p, center));
      in_radii.push_back(distance / radius);
      in_units.push_back(distance / unit);
    }
  }

  std::vector<double> in_radii, in_units;
};

// Measures skeletons of one surface.
class Judge
{
public:
  explicit Judge(const Shape& shape)
    : m_shape(shape),
      m_unit(diagonal(shape.mesh)),
      m_places(shape.mesh),
      m_side(shape.mesh),
      m_axis(shape.mesh, number_of_samples, 1),
      m_errors(m_axis, centers(Medial_axis(shape.mesh, number_of_samples, 2)), m_unit)
  {}

  void print(const std::string& method, const Skeleton& skeleton, double time) const
  {
    std::size_t ends = 0, branchings = 0;
    std::vector<bool> is_reached(m_shape.limbs.size() + 1, false);
    for (const auto v : boost::make_iterator_range(vertices(skeleton)))
    {
      branchings += degree(v, skeleton) > 2 ? 1 : 0;
      if (degree(v, skeleton) != 1)
        continue;
      ++ends;
      is_reached[m_shape.part_of_face[m_places.nearest_face(skeleton[v].point).idx()]] = true;
    }
    std::vector<int> component(num_vertices(skeleton));
    const int components = boost::connected_components(
      skeleton,
      boost::make_iterator_property_map(component.begin(), get(boost::vertex_index, skeleton)));

    std::vector<double> balances;
    const std::vector<Point> points = samples(skeleton, 0.005 * m_unit);
    for (const Point& p : points)
      if (m_side(p) != CGAL::ON_UNBOUNDED_SIDE)
        balances.push_back(m_places.balance(p));
    const Distances distances(m_axis, points, m_unit);
    print_row(m_shape.name, method, num_vertices(skeleton), ends, branchings, components,
              std::count(is_reached.begin(), is_reached.end() - 1, true), m_shape.limbs.size(),
              static_cast<double>(balances.size()) / static_cast<double>(points.size()),
              quantile(balances, 0.5), quantile(balances, 0.1), quantile(distances.in_radii, 0.5),
              quantile(distances.in_radii, 0.9), quantile(distances.in_units, 0.5),
              quantile(distances.in_units, 0.9), quantile(m_errors.in_radii, 0.5),
              quantile(m_errors.in_radii, 0.9), quantile(m_errors.in_units, 0.5),
              quantile(m_errors.in_units, 0.9), turning(skeleton) * m_unit, time);
  }

private:
  static constexpr std::size_t number_of_samples = 400000;

  static std::vector<Point> centers(const Medial_axis& axis)
  {
    std::vector<Point> result;
    for (const Medial_axis::Ball& ball : axis.balls())
      result.push_back(ball.first);
    return result;
  }

  const Shape& m_shape;
  double m_unit;
  Places m_places;
  CGAL::Side_of_triangle_mesh<Mesh, Kernel> m_side;
  Medial_axis m_axis;
  Distances m_errors; // of the axis by other samples, which show how dense it is
};

template <class Make>
void judge(const Judge& all, const std::string& method, Make make)
{
  CGAL::Timer timer;
  timer.start();
  const Skeleton skeleton = make();
  timer.stop();
  all.print(method, skeleton, timer.time());
}

int main(int argc, char* argv[])
{
  return run_experiment(argc, argv, 5, [](const Options& options) {
    print_row("shape", "method", "vertices", "ends", "branchings", "components",
              "limbs with an end", "limbs", "inside", "median balance", "lowest tenth of balance",
              "median distance in radii", "highest tenth in radii", "median distance in diagonals",
              "highest tenth in diagonals", "median error in radii",
              "highest tenth of error in radii", "median error in diagonals",
              "highest tenth of error in diagonals", "turning", "time");
    for_each_shape(options, [&](const Shape& shape) {
      const Mesh& mesh = shape.mesh;
      const Judge all(shape);
      for (std::size_t i = 0; i < options.runs; ++i)
        judge(all, "mean curvature flow", [&] { return skeleton_by_flow(mesh); });
      judge(all, "ours (star)",
            [&] { return skeleton_of_foliation(mesh, with_poles(shape.tips())); });
      judge(all, "ours (canonical loops)",
            [&] { return skeleton_of_foliation(mesh, with_canonical_loops(mesh, shape.tips())); });
      judge(all, "ours (all found)", [&] {
        return skeleton_of_foliation(mesh, with_canonical_loops(mesh, found_poles(mesh)));
      });
    });
  });
}
