// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_TWO_ROADS_H
#define SMF_TEST_TWO_ROADS_H

#include "edge_value_difference.h"
#include "generators/meshes.h"

#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>
#include <CGAL/Surface_mesh_foliation/integrate_foliation.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/lengths.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/contour.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/isomorphism.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

// Compares a foliation with the one that is made of its edge values alone.

namespace smf_test {

namespace SMF = CGAL::Surface_mesh_foliation;

// ===  Graphs

// A Reeb graph as a simple graph with labels: an arc is a path of two vertices, labeled by the
// height; a node is labeled by its pole and genus.
class Labeled_graph
{
public:
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;

  // `heights` are sorted; the first that is nearly that of an arc is its label
  template <class TriangleMesh>
  Labeled_graph(const SMF::Loop_system<TriangleMesh>& system, const std::vector<double>& heights)
    : m_graph(system.number_of_nodes() + 2 * system.number_of_arcs())
  {
    for (std::size_t node = 0; node < system.number_of_nodes(); ++node)
    {
      std::vector<int> label = {-1 - static_cast<int>(system.genus(node))};
      if (system.pole(node) >= 0)
        label = system.data().flat.poles[static_cast<std::size_t>(system.pole(node))].vertices();
      std::sort(label.begin(), label.end());
      m_labels.push_back(label);
    }
    for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
    {
      const double height = system.height(a) * (1 - 1e-9);
      const auto it = std::lower_bound(heights.begin(), heights.end(), height);
      const std::size_t first = m_labels.size();
      for (int end : {0, 1})
      {
        m_labels.push_back({-1, static_cast<int>(it - heights.begin())});
        add_edge(first + static_cast<std::size_t>(end), system.node(a, end), m_graph);
      }
      add_edge(first, first + 1, m_graph);
    }
  }

  friend bool are_isomorphic(const Labeled_graph& a, const Labeled_graph& b)
  {
    if (num_vertices(a.m_graph) != num_vertices(b.m_graph))
      return false;
    std::map<std::vector<int>, std::size_t> numbers;
    for (const Labeled_graph* graph : {&a, &b})
      for (const std::vector<int>& label : graph->m_labels)
        numbers.emplace(label, numbers.size());
    std::vector<std::size_t> map(num_vertices(a.m_graph));
    return boost::isomorphism(
      a.m_graph, b.m_graph,
      boost::make_iterator_property_map(map.begin(), get(boost::vertex_index, a.m_graph)),
      Invariant{&a.m_labels, &numbers}, Invariant{&b.m_labels, &numbers}, numbers.size(),
      get(boost::vertex_index, a.m_graph), get(boost::vertex_index, b.m_graph));
  }

private:
  struct Invariant
  {
    using argument_type = std::size_t;
    using result_type = std::size_t;
    result_type operator()(argument_type v) const { return numbers->at((*labels)[v]); }
    std::size_t max() const { return numbers->size(); }
    const std::vector<std::vector<int>>* labels;
    const std::map<std::vector<int>, std::size_t>* numbers;
  };

  Graph m_graph;
  std::vector<std::vector<int>> m_labels;
};

// Whether the Reeb graphs are isomorphic, with the same poles at nodes and heights of arcs.
template <class TriangleMesh>
bool have_same_graph(const SMF::Loop_system<TriangleMesh>& a,
                     const SMF::Loop_system<TriangleMesh>& b)
{
  std::vector<double> heights;
  for (const auto* system : {&a, &b})
    for (std::size_t arc = 0; arc < system->number_of_arcs(); ++arc)
      heights.push_back(system->height(arc));
  std::sort(heights.begin(), heights.end());
  return are_isomorphic(Labeled_graph(a, heights), Labeled_graph(b, heights));
}

// ===  Places

// Where the critical leaves of a foliation run, and how large its components are.
class Critical_places
{
public:
  using Point = SMF::internal::Point;
  using Segment = std::array<Point, 2>;

  template <class TriangleMesh>
  explicit Critical_places(const SMF::Measured_foliation<TriangleMesh>& foliation)
    : m_refined(foliation.extraction().refined_mesh), m_area(foliation.system().number_of_arcs())
  {
    const auto& state = foliation.state();
    std::vector<double> steepness(m_refined.points.size(),
                                  (std::numeric_limits<double>::infinity)());
    const auto is_singular = [&](int v) { // the node of a torus without pole can be anywhere
      const int node = m_refined.node[static_cast<std::size_t>(v)];
      return node >= 0 &&
             state.system().nodes[static_cast<std::size_t>(node)].euler_characteristic != 0;
    };
    for (const auto& face : m_refined.faces)
    {
      if (face.arc >= 0)
        m_area[static_cast<std::size_t>(face.arc)] += area(face);
      for (const int v : face.vertices)
        steepness[static_cast<std::size_t>(v)] =
          std::min(steepness[static_cast<std::size_t>(v)], steepness_of_face(state, face.origin));
      for (std::size_t i = 0; i < 3; ++i)
        if (face.is_critical[i] && is_singular(face.vertices[i]))
          m_segments.push_back({point(face.vertices[i]), point(face.vertices[(i + 1) % 3])});
    }
    std::sort(m_area.begin(), m_area.end());
    for (std::size_t v = 0; v < steepness.size(); ++v)
      if (is_singular(static_cast<int>(v)))
      {
        m_points.push_back({m_refined.points[v], steepness[v]});
        m_segments.push_back({m_refined.points[v], m_refined.points[v]});
      }
  }

  // sorted
  const std::vector<double>& areas() const { return m_area; }

  // whether |grad t| is at least `bound` in the faces at critical leaves, and there are some
  bool is_steep(double bound) const
  {
    return !m_points.empty() && std::all_of(m_points.begin(), m_points.end(),
                                            [&](const auto& p) { return p.second >= bound; });
  }

  // the number of points where |grad t| is at least `steepness` and the other's leaves are farther
  // than `distance`
  std::size_t number_of_points_away_from(const Critical_places& other,
                                         double distance,
                                         double least_steepness) const
  {
    using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;
    std::vector<Box> points, segments;
    for (std::size_t i = 0; i < m_points.size(); ++i)
      if (m_points[i].second >= least_steepness)
        points.emplace_back(box(m_points[i].first, m_points[i].first, distance), i);
    for (std::size_t i = 0; i < other.m_segments.size(); ++i)
      segments.emplace_back(box(other.m_segments[i][0], other.m_segments[i][1], 0), i);
    std::vector<bool> is_near(m_points.size(), false);
    CGAL::box_intersection_d(points.begin(), points.end(), segments.begin(), segments.end(),
                             [&](const Box& a, const Box& b) {
                               const Segment& segment = other.m_segments[b.info()];
                               is_near[a.info()] =
                                 is_near[a.info()] ||
                                 SMF::internal::distance_to_segment(
                                   m_points[a.info()].first, segment[0], segment[1]) <= distance;
                             });
    return points.size() -
           static_cast<std::size_t>(std::count(is_near.begin(), is_near.end(), true));
  }

private:
  using Face = SMF::internal::Refined_mesh::Face;

  const Point& point(int v) const { return m_refined.points[static_cast<std::size_t>(v)]; }

  static double length(const Point& p, const Point& q)
  {
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  }

  double area(const Face& face) const
  {
    const Point &p = point(face.vertices[0]), &q = point(face.vertices[1]),
                &r = point(face.vertices[2]);
    const Point normal = soups::cross(soups::sum(q, p, -1), soups::sum(r, p, -1));
    return std::sqrt(soups::dot(normal, normal)) / 2;
  }

  static double steepness_of_face(const SMF::internal::Foliation_state& state, int f)
  {
    double result = 0;
    for (const int h : state.mesh().halfedges(f))
      result = std::max(result, length_of_edge(state, SMF::internal::edge_of(h)) /
                                  length(state.mesh().point(state.mesh().source(h)),
                                         state.mesh().point(state.mesh().target(h))));
    return result;
  }

  static CGAL::Bbox_3 box(const Point& p, const Point& q, double margin)
  {
    Point least, greatest;
    for (std::size_t i = 0; i < 3; ++i)
    {
      least[i] = std::min(p[i], q[i]) - margin;
      greatest[i] = std::max(p[i], q[i]) + margin;
    }
    return CGAL::Bbox_3(least[0], least[1], least[2], greatest[0], greatest[1], greatest[2]);
  }

  const SMF::internal::Refined_mesh& m_refined;
  std::vector<double> m_area;
  std::vector<std::pair<Point, double>> m_points;
  std::vector<Segment> m_segments;
};

inline double diagonal_of_box(const std::vector<SMF::internal::Point>& points)
{
  SMF::internal::Point least = points[0], greatest = points[0];
  for (const auto& p : points)
    for (std::size_t i = 0; i < 3; ++i)
    {
      least[i] = std::min(least[i], p[i]);
      greatest[i] = std::max(greatest[i], p[i]);
    }
  return std::hypot(greatest[0] - least[0], greatest[1] - least[1], greatest[2] - least[2]);
}

// ===  What must hold

// The foliation made of the edge values of `foliation` has the same graph; where |grad t| along the
// critical leaves is at least a thousandth of the largest height per diagonal of the bounding box,
// they lie at the same places up to 1e-6 of the diagonal, and if it is that everywhere, the areas
// of the components agree up to 1e-6 of the whole. Returns whether it is.
template <class TriangleMesh>
bool expect_both_roads_agree(const SMF::Measured_foliation<TriangleMesh>& foliation)
{
  auto values =
    get(CGAL::dynamic_edge_property_t<double>(), const_cast<TriangleMesh&>(foliation.mesh()));
  SMF::edge_values(foliation, values);
  const auto other = SMF::integrate_foliation(foliation.mesh(), values);
  EXPECT_TRUE(have_same_graph(foliation.system(), other.system()));
  EXPECT_TRUE(other.statistics().is_certified);
  EXPECT_LT(difference(foliation, other), 1e-10);

  double greatest_height = 0;
  for (std::size_t a = 0; a < foliation.system().number_of_arcs(); ++a)
    greatest_height = std::max(greatest_height, foliation.system().height(a));
  const double diagonal = diagonal_of_box(foliation.state().mesh().points());
  const double bound = 1e-3 * greatest_height / diagonal;
  const Critical_places a(foliation), b(other);
  EXPECT_EQ(a.number_of_points_away_from(b, 1e-6 * diagonal, bound), 0u);
  EXPECT_EQ(b.number_of_points_away_from(a, 1e-6 * diagonal, bound), 0u);
  const bool is_steep = a.is_steep(bound) && b.is_steep(bound);
  if (is_steep && a.areas().size() == b.areas().size())
  {
    double sum = 0;
    for (const double area : a.areas())
      sum += area;
    for (std::size_t i = 0; i < a.areas().size(); ++i)
      EXPECT_NEAR(a.areas()[i], b.areas()[i], 1e-6 * sum);
  }
  return is_steep;
}

} // namespace smf_test

#endif // SMF_TEST_TWO_ROADS_H
