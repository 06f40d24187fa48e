// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_MIDDLE_LEAVES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_MIDDLE_LEAVES_H

#include <CGAL/Surface_mesh_foliation/internal/Edge_values/Edge_value_components.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/Flat_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/contour.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// A leaf near the middle of each component, as a loop on the input mesh with end 0 on its left, and
// the intervals that it crosses. Among the levels near the middle, the one farthest from any vertex
// is taken.
class Middle_leaves
{
public:
  Middle_leaves(const Edge_value_surface& surface,
                const Edge_value_places& places,
                const Leaf_intervals& intervals,
                const Edge_value_components& components)
    : m_surface(surface),
      m_places(places),
      m_intervals(intervals),
      m_components(components),
      m_is_crossed(intervals.size(), false)
  {
    for (const Edge_value_components::Component& component : components.components())
      add_loop(component);
  }

  const std::vector<Flat_loop>& loops() const { return m_loops; }
  bool is_crossed(int interval) const { return m_is_crossed[interval]; }

private:
  using Component = Edge_value_components::Component;
  using Seen_interval = Leaf_intervals::Seen_interval;

  const Flat_mesh& mesh() const { return m_surface.mesh(); }

  double level_near_middle(const Component& component) const
  {
    const double first = 0.4 * component.height, last = 0.6 * component.height;
    std::vector<double> levels = {first, last};
    for (int place : component.places)
    {
      const double t = m_components.t(m_places.places()[place].vertices[0]);
      if (t > first && t < last)
        levels.push_back(t);
    }
    std::sort(levels.begin(), levels.end());
    double result = 0, widest = 0;
    for (std::size_t i = 1; i < levels.size(); ++i)
      if (levels[i] - levels[i - 1] > widest)
      {
        widest = levels[i] - levels[i - 1];
        result = levels[i - 1] + widest / 2;
      }
    return result;
  }

  // whether an interval begins and ends on different sides of a level
  bool crosses(const Component& component, int interval, double level) const
  {
    return is_below(component, interval, 0, level) != is_below(component, interval, 1, level);
  }

  bool is_below(const Component& component, int interval, int end, double level) const
  {
    const int e = m_intervals.edge(interval);
    const int v = end == 0 ? mesh().source(halfedge_of(e)) : mesh().target(halfedge_of(e));
    if (m_intervals.leaf_at_end(interval, end) == Leaf_intervals::NONE && !m_places.is_node(v))
      return m_components.t(v) < level;
    const Edge_value_components::Parameter& p = m_components.parameter(interval);
    return p.start + p.slope * m_intervals.ways(interval)[end] < component.height / 2;
  }

  void add_loop(const Component& component)
  {
    const double level = level_near_middle(component);
    const auto first =
      std::find_if(component.intervals.begin(), component.intervals.end(),
                   [&](int interval) { return crosses(component, interval, level); });
    CGAL_assertion(first != component.intervals.end());
    const int e = m_intervals.edge(*first);
    // t decreases from face(h) toward the target of h, which lies to the left
    const int h =
      m_components.parameter(*first).slope < 0 ? halfedge_of(e) : opposite_of(halfedge_of(e));
    const auto is_beyond = [&](const Seen_interval& seen) {
      return (m_components.slope(seen) > 0) ==
             (m_components.t(mesh().target(seen.halfedge)) < level);
    };
    m_loops.emplace_back();
    m_loops.back().height = component.height;
    Seen_interval seen = m_intervals.seen_along(opposite_of(h), *first);
    do
    {
      add_crossing(seen, level);
      seen = m_intervals.next(seen, is_beyond);
    } while (m_intervals.number(seen) != *first);
  }

  // `seen` is along the halfedge of the face that the leaf enters
  void add_crossing(const Seen_interval& seen, double level)
  {
    const int interval = m_intervals.number(seen), h = opposite_of(seen.halfedge);
    m_is_crossed[interval] = true;
    const int input = m_surface.input_halfedge(h);
    if (input == Edge_value_surface::NONE)
      return;
    const Edge_value_components::Parameter& p = m_components.parameter(interval);
    const auto [from, to] = m_intervals.ways(interval);
    const double way = std::clamp((level - p.start) * p.slope, from, to);
    const double share = way / m_surface.value(edge_of(h));
    m_loops.back().crossings.push_back({input, inner_position(is_forward(h) ? share : 1 - share)});
  }

  const Edge_value_surface& m_surface;
  const Edge_value_places& m_places;
  const Leaf_intervals& m_intervals;
  const Edge_value_components& m_components;
  std::vector<bool> m_is_crossed; // by interval
  std::vector<Flat_loop> m_loops; // by component
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_MIDDLE_LEAVES_H
