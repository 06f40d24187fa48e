// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_TWO_ROADS_H
#define SMF_TEST_TWO_ROADS_H

#include "edge_value_difference.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>
#include <CGAL/Surface_mesh_foliation/integrate_foliation.h>
#include <CGAL/Surface_mesh_foliation/internal/contour.h>

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

// A Reeb graph as a simple graph with labels: an arc is a path of two vertices, labelled by the
// height; a node is labelled by its pole and genus.
class Labelled_graph
{
public:
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;

  // `heights` are sorted; the first that is nearly that of an arc is its label
  template <class TriangleMesh>
  Labelled_graph(const SMF::Loop_system<TriangleMesh>& system, const std::vector<double>& heights)
    : m_graph(system.number_of_nodes() + 2 * system.number_of_arcs())
  {
    for (std::size_t node = 0; node < system.number_of_nodes(); ++node)
    {
      std::vector<int> label = {-1 - static_cast<int>(system.genus(node))};
      if (system.pole(node) >= 0)
        label = system.data().flat.poles[static_cast<std::size_t>(system.pole(node))];
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

  friend bool are_isomorphic(const Labelled_graph& a, const Labelled_graph& b)
  {
    if (num_vertices(a.m_graph) != num_vertices(b.m_graph))
      return false;
    std::map<std::vector<int>, std::size_t> numbers;
    for (const Labelled_graph* graph : {&a, &b})
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
  return are_isomorphic(Labelled_graph(a, heights), Labelled_graph(b, heights));
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
    : m_refined(foliation.certificate().refined_mesh()), m_area(foliation.system().number_of_arcs())
  {
    const auto& state = foliation.state();
    std::vector<double> steepness(m_refined.points.size(),
                                  (std::numeric_limits<double>::infinity)());
    for (const auto& face : m_refined.faces)
    {
      if (face.arc >= 0)
        m_area[static_cast<std::size_t>(face.arc)] += area(face);
      for (const int v : face.vertices)
        steepness[static_cast<std::size_t>(v)] =
          std::min(steepness[static_cast<std::size_t>(v)], steepness_of_face(state, face.origin));
      for (std::size_t i = 0; i < 3; ++i)
        if (face.is_critical[i])
          m_segments.push_back({point(face.vertices[i]), point(face.vertices[(i + 1) % 3])});
    }
    std::sort(m_area.begin(), m_area.end());
    for (std::size_t v = 0; v < steepness.size(); ++v)
      if (m_refined.node[v] >= 0)
      {
        m_points.push_back({m_refined.points[v], steepness[v]});
        m_segments.push_back({m_refined.points[v], m_refined.points[v]});
      }
  }

  // sorted
  const std::vector<double>& areas() const { return m_area; }

  // the smallest of a lower bound of |grad t| in the faces at critical leaves
  double least_steepness() const
  {
    double result = (std::numeric_limits<double>::infinity)();
    for (const auto& [p, steepness] : m_points)
      result = std::min(result, steepness);
    return result;
  }

  // the largest distance from a point where |grad t| is at least `steepness` to the other's leaves
  double distance_to(const Critical_places& other, double least_steepness) const
  {
    double result = 0;
    for (const auto& [p, steepness] : m_points)
    {
      if (steepness < least_steepness)
        continue;
      double distance = (std::numeric_limits<double>::infinity)();
      for (const Segment& segment : other.m_segments)
        if (is_near(p, segment, distance))
          distance =
            std::min(distance, SMF::internal::distance_to_segment(p, segment[0], segment[1]));
      result = std::max(result, distance);
    }
    return result;
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
      result =
        std::max(result, state.length(h / 2) / length(state.mesh().point(state.mesh().source(h)),
                                                      state.mesh().point(state.mesh().target(h))));
    return result;
  }

  // whether the segment's box may be nearer than a distance
  static bool is_near(const Point& p, const Segment& segment, double distance)
  {
    for (std::size_t i = 0; i < 3; ++i)
      if (p[i] < std::min(segment[0][i], segment[1][i]) - distance ||
          p[i] > std::max(segment[0][i], segment[1][i]) + distance)
        return false;
    return true;
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
  EXPECT_LT(a.distance_to(b, bound), 1e-6 * diagonal);
  EXPECT_LT(b.distance_to(a, bound), 1e-6 * diagonal);
  const bool is_steep = std::min(a.least_steepness(), b.least_steepness()) >= bound;
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
