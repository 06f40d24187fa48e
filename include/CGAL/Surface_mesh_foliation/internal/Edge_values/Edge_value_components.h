// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_EDGE_VALUE_COMPONENTS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_EDGE_VALUE_COMPONENTS_H

#include <CGAL/Surface_mesh_foliation/internal/Common/Disjoint_sets.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Edge_values/Leaf_intervals.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The parts of a surface between the critical leaves [5.2.5], as sets of intervals, with the
// parameter t of every level, and the graph whose nodes are the critical leaves [5.3].
class Edge_value_components
{
public:
  static constexpr int NONE = -1;

  struct Component
  {
    std::vector<int> intervals;
    std::vector<int> places; // inside, hence regular
    double height = 0;
    std::array<int, 2> place = {NONE, NONE}; // a place on the critical leaf at each end
    std::array<int, 2> node = {NONE, NONE};
  };

  // The parameter of a level that crosses an interval, as a function of its way: on the whole edge
  // it is start + slope * way, with the way measured along the forward halfedge.
  struct Parameter
  {
    double start;
    int slope; // 1 or -1; 0: not known
  };

  // Throws if the ends of a component are not at two levels.
  Edge_value_components(const Edge_value_surface& surface,
                        const Edge_value_places& places,
                        const Critical_leaf_tracer& leaves,
                        const Leaf_intervals& intervals)
    : m_surface(surface),
      m_places(places),
      m_leaves(leaves),
      m_intervals(intervals),
      m_parameter(intervals.size(), {0, 0}),
      m_component_of_place(places.places().size(), NONE),
      m_t_of_place(places.places().size(), 0)
  {
    for (int i = 0; i < intervals.size(); ++i)
      if (m_parameter[i].slope == 0)
        add_component(i);
    number_nodes();
  }

  const std::vector<Component>& components() const { return m_components; }
  int number_of_nodes() const { return m_number_of_nodes; }
  const Parameter& parameter(int interval) const { return m_parameter[interval]; }

  // the component of a vertex that is not at a node, and its parameter; NONE at a node
  int component_of_vertex(int v) const { return m_component_of_place[m_places.place_of_vertex(v)]; }
  double t(int v) const { return m_t_of_place[m_places.place_of_vertex(v)]; }

  // the direction of t along a halfedge that crosses an interval
  int slope(const Leaf_intervals::Seen_interval& seen) const
  {
    const int slope = m_parameter[m_intervals.number(seen)].slope;
    return is_forward(seen.halfedge) ? slope : -slope;
  }

private:
  const Flat_mesh& mesh() const { return m_surface.mesh(); }

  // from the start of halfedge h, in place of the forward one, and back
  Parameter seen_along(int h, const Parameter& p) const
  {
    return is_forward(h) ? p : Parameter{p.start + p.slope * m_surface.value(edge_of(h)), -p.slope};
  }

  void add_component(int first)
  {
    m_components.emplace_back();
    m_rings.clear();
    reach(first, {0, 1});
    std::vector<int>& intervals = m_components.back().intervals;
    std::size_t done = 0;
    do
    {
      for (; done < intervals.size(); ++done)
        visit_neighbors(intervals[done]);
      cross_rings();
    } while (done < intervals.size());
    find_ends(m_components.back());
  }

  void reach(int interval, const Parameter& parameter)
  {
    if (m_parameter[interval].slope != 0)
      return;
    m_parameter[interval] = parameter;
    m_components.back().intervals.push_back(interval);
  }

  void visit_neighbors(int interval)
  {
    m_intervals.for_each_partner(interval, [&](const auto& seen, const auto& partner) {
      const Parameter p = seen_along(seen.halfedge, m_parameter[interval]);
      reach(m_intervals.number(partner), seen_along(partner.halfedge, p));
    });
    for (int h : halfedges_of_edge(m_intervals.edge(interval)))
      if (m_intervals.seen_along(h, interval).position == 0 && !m_places.is_node(mesh().source(h)))
        reach_vertex(h, seen_along(h, m_parameter[interval]));
  }

  void reach_vertex(int h, const Parameter& p)
  {
    const int place = m_places.place_of_vertex(mesh().source(h));
    if (m_component_of_place[place] != NONE)
      return;
    m_component_of_place[place] = static_cast<int>(m_components.size()) - 1;
    m_t_of_place[place] = p.start;
    m_components.back().places.push_back(place);
    if (m_places.places()[place].euler_characteristic == 0)
      m_rings.push_back({place, p.slope});
  }

  // No face leads across a closed leaf of flat edges. Beyond it, the component continues in t.
  void cross_rings()
  {
    for (const auto& [place, slope] : std::exchange(m_rings, {}))
      for (int v : m_places.places()[place].vertices)
        for (int h : mesh().ring(v))
          if (!m_surface.is_flat(edge_of(h)))
            reach(m_intervals.number({h, 0}), seen_along(h, {m_t_of_place[place], -slope}));
  }

  // the place on the critical leaf at an end of an interval; NONE if the component continues there
  int place_at_end(int interval, int end) const
  {
    const int leaf = m_intervals.leaf_at_end(interval, end), e = m_intervals.edge(interval);
    if (leaf != Leaf_intervals::NONE)
      return m_leaves.ends()[leaf].first;
    const int v = end == 0 ? mesh().source(halfedge_of(e)) : mesh().target(halfedge_of(e));
    return m_places.is_node(v) ? m_places.place_of_vertex(v) : NONE;
  }

  // Calls visit(place, t, interval) for each end of an interval at a critical leaf.
  template <class Visit>
  void for_each_end(const Component& component, const Visit& visit) const
  {
    for (int i : component.intervals)
      for (int end : {0, 1})
      {
        const int place = place_at_end(i, end);
        if (place != NONE)
          visit(place, m_parameter[i].start + m_parameter[i].slope * m_intervals.ways(i)[end], i);
      }
  }

  // Finds both ends and measures t from one of them: from a pole if there is one.
  void find_ends(Component& component)
  {
    double least = (std::numeric_limits<double>::max)(), greatest = -least;
    for_each_end(component, [&](int, double t, int) {
      least = (std::min)(least, t);
      greatest = (std::max)(greatest, t);
    });
    const double middle = least / 2 + greatest / 2;
    std::array<double, 2> sum = {0, 0}, number = {0, 0};
    for_each_end(component, [&](int place, double t, int) {
      const int end = t < middle ? 0 : 1;
      sum[end] += t - middle;
      ++number[end];
      component.place[end] = place;
    });
    std::array<double, 2> level;
    for (int end : {0, 1})
      level[end] = middle + sum[end] / number[end];
    component.height = level[1] - level[0];
    for_each_end(component, [&](int, double t, int interval) {
      const double spread = (std::min)(std::abs(t - level[0]), std::abs(t - level[1]));
      if (!(spread <= 10 * m_surface.tolerances().snap()))
        throw_uneven(interval);
    });
    if (!(component.height > m_surface.tolerances().snap()))
      throw_uneven(component.intervals[0]);
    const bool is_turned = !is_pole(component.place[0]) && is_pole(component.place[1]);
    normalize(component, level, is_turned);
  }

  bool is_pole(int place) const { return m_places.places()[place].is_pole(); }

  void normalize(Component& component, const std::array<double, 2>& level, bool is_turned)
  {
    const int sign = is_turned ? -1 : 1;
    const double origin = level[is_turned ? 1 : 0];
    if (is_turned)
      std::swap(component.place[0], component.place[1]);
    for (int i : component.intervals)
      m_parameter[i] = {sign * (m_parameter[i].start - origin), sign * m_parameter[i].slope};
    for (int place : component.places)
      m_t_of_place[place] = sign * (m_t_of_place[place] - origin);
  }

  [[noreturn]] void throw_uneven(int interval) const
  {
    const int f = m_surface.origin_of_face(mesh().face(halfedge_of(m_intervals.edge(interval))));
    throw Invalid_foliation_exception(
      problem(Problem_kind::UNRESOLVED_LEAF, "the component in face ", f,
              " does not end at two levels that can be told apart at this tolerance")
        .faces({index(f)}));
  }

  // critical leaves join places to nodes
  void number_nodes()
  {
    Disjoint_sets sets(m_places.places().size());
    for (const auto& [a, b] : m_leaves.ends())
      sets.union_set(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
    std::vector<int> number(m_places.places().size(), NONE);
    for (Component& component : m_components)
      for (int end : {0, 1})
      {
        int& node = number[sets.find_set(static_cast<std::size_t>(component.place[end]))];
        if (node == NONE)
          node = m_number_of_nodes++;
        component.node[end] = node;
      }
  }

  const Edge_value_surface& m_surface;
  const Edge_value_places& m_places;
  const Critical_leaf_tracer& m_leaves;
  const Leaf_intervals& m_intervals;
  std::vector<Parameter> m_parameter; // by interval
  std::vector<int> m_component_of_place;
  std::vector<double> m_t_of_place;
  std::vector<Component> m_components;
  int m_number_of_nodes = 0;
  std::vector<std::pair<int, int>> m_rings; // met by the component being built, with slopes
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_EDGE_VALUE_COMPONENTS_H
