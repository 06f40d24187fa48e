// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_EDGE_VALUE_FOLIATION_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_EDGE_VALUE_FOLIATION_H

#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/lengths.h>
#include <CGAL/Surface_mesh_foliation/internal/Edge_values/Middle_leaves.h>
#include <CGAL/Surface_mesh_foliation/internal/Edge_values/Noise_removal.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

inline Edge_value_surface checked_surface(const Flat_mesh& mesh,
                                          const std::vector<double>& value,
                                          const Edge_value_tolerances& tolerances)
{
  if (const std::optional<Problem> problem = find_bad_edge_values(mesh, value, tolerances))
    throw Invalid_foliation_exception(*problem);
  Edge_value_surface result(mesh, value, tolerances);
  Noise_removal{result};
  return result;
}

// the vertices at the nodes of a foliation, which must lie on the boundary of the disk
inline std::vector<int> vertices_at_nodes(const Edge_value_places& places)
{
  std::vector<int> result;
  for (const Edge_value_places::Place& place : places.places())
    if (place.is_node)
      result.insert(result.end(), place.vertices.begin(), place.vertices.end());
  return result;
}

// Algorithm 2 of the paper: a foliation that is given only by its edge values, from its
// singularities to its components, and then the input of the combinatorial route: poles and loops.
class Edge_value_foliation
{
public:
  Edge_value_foliation(const Flat_mesh& mesh,
                       const std::vector<double>& value,
                       const Edge_value_tolerances& tolerances,
                       std::size_t max_leaf_length)
    : m_surface(checked_surface(mesh, value, tolerances)),
      m_places(m_surface),
      m_poles(poles()),
      m_cut(m_surface.mesh(), vertices_at_nodes(m_places)),
      m_function(m_surface, m_cut),
      m_leaves(m_surface, m_places, m_function, max_leaf_length),
      m_intervals(m_surface, m_leaves),
      m_components(m_surface, m_places, m_leaves, m_intervals),
      m_middle_leaves(m_surface, m_places, m_intervals, m_components)
  {}

  Edge_value_foliation(const Edge_value_foliation&) = delete;
  Edge_value_foliation& operator=(const Edge_value_foliation&) = delete;

  const Edge_value_surface& surface() const { return m_surface; }
  const Edge_value_places& places() const { return m_places; }
  const Disk_cut& cut() const { return m_cut; }
  const Disk_function& function() const { return m_function; }
  const Critical_leaf_tracer& leaves() const { return m_leaves; }
  const Leaf_intervals& intervals() const { return m_intervals; }
  const Edge_value_components& components() const { return m_components; }
  const Middle_leaves& middle_leaves() const { return m_middle_leaves; }

  // the vertices of the pole at an end of a component, in order; empty if there is none
  std::vector<int> pole_at_end(int component, int end) const
  {
    const int place = m_components.components()[component].place[end];
    return m_places.places()[place].is_pole() ? m_poles[place] : std::vector<int>();
  }

private:
  // Poles by place. Throws if a place has a positive index and is neither a vertex nor a path.
  std::vector<std::vector<int>> poles() const
  {
    std::vector<std::vector<int>> result(m_places.places().size());
    for (std::size_t p = 0; p < result.size(); ++p)
    {
      const Edge_value_places::Place& place = m_places.places()[p];
      if (place.index() == 1)
        throw_pole(place, "is a thorn, that is, the end of a line pole which does not run along "
                          "edges, or of a fold");
      if (place.is_pole())
        result[p] = path(place);
    }
    return result;
  }

  std::vector<int> path(const Edge_value_places::Place& place) const
  {
    const auto flat_spokes = [&](int v) {
      std::vector<int> spokes;
      for (int h : m_surface.mesh().ring(v))
        if (m_surface.is_flat(edge_of(h)))
          spokes.push_back(h);
      return spokes;
    };
    int end = -1;
    for (int v : place.vertices)
    {
      const std::size_t degree = flat_spokes(v).size();
      if (degree > 2)
        throw_pole(place, "is in a pole that is not a path of edges");
      if (degree < 2)
        end = v;
    }
    if (end < 0)
      throw_pole(place, "is in a pole that is a face");
    std::vector<int> result = {end};
    for (int previous = -1; result.size() < place.vertices.size();)
      for (int h : flat_spokes(result.back()))
      {
        const int u = m_surface.mesh().target(h);
        if (u == previous)
          continue;
        previous = result.back();
        result.push_back(u);
        break;
      }
    return result;
  }

  // The center of a tripod is not a vertex of the input; if it is alone, a corner of its face is
  // named.
  [[noreturn]] void throw_pole(const Edge_value_places::Place& place, const char* what) const
  {
    Indices vertices;
    for (int v : place.vertices)
      if (!m_surface.is_center(v))
        vertices.push_back(index(v));
    if (vertices.empty())
      vertices.push_back(
        index(m_surface.mesh().target(m_surface.mesh().ring(place.vertices[0])[0])));
    throw Invalid_foliation_exception(
      problem(Problem_kind::INVALID_POLE, "vertex ", vertices[0], " ", what).vertices(vertices));
  }

  Edge_value_surface m_surface;
  Edge_value_places m_places;
  std::vector<std::vector<int>> m_poles; // by place
  Disk_cut m_cut;
  Disk_function m_function;
  Critical_leaf_tracer m_leaves;
  Leaf_intervals m_intervals;
  Edge_value_components m_components;
  Middle_leaves m_middle_leaves;
};

// Turns the state whose leaves all lie in the middle leaves of a foliation into this foliation:
// each vertex moves from its node into the arc of its component, in the order in which vertices are
// met starting from the middle leaf. Then a spoke that leads back, inside the component, begins
// with the half-arc that the vertex moves over.
class Vertex_placement
{
public:
  Vertex_placement(const Edge_value_foliation& foliation, Foliation_state& state)
    : m_foliation(foliation),
      m_state(state),
      m_is_queued(foliation.surface().mesh().number_of_vertices(), false)
  {
    const Leaf_intervals& intervals = foliation.intervals();
    for (int i = 0; i < intervals.size(); ++i)
      if (foliation.middle_leaves().is_crossed(i))
        for (int h : halfedges_of_edge(intervals.edge(i)))
          if (intervals.seen_along(h, i).position == 0)
            enqueue(h);
    for (std::size_t i = 0; i < m_queue.size(); ++i)
      place(m_queue[i]);
    for (int v = 0; v < state.mesh().number_of_vertices(); ++v)
      if (!m_is_queued[v] && foliation.components().component_of_vertex(v) >= 0)
        throw_lost(v);
  }

private:
  const Flat_mesh& mesh() const { return m_foliation.surface().mesh(); }
  const Edge_value_components& components() const { return m_foliation.components(); }

  // moves source(h) over the first half-arc that h passes
  void enqueue(int h)
  {
    const int v = mesh().source(h);
    if (m_is_queued[v] || components().component_of_vertex(v) < 0 ||
        m_foliation.surface().input_halfedge(h) == Edge_value_surface::NONE)
      return;
    m_is_queued[v] = true;
    m_queue.push_back(h);
  }

  void place(int h)
  {
    const int v = mesh().source(h), component = components().component_of_vertex(v);
    const int input = m_foliation.surface().input_halfedge(h);
    if (m_state.word_size(edge_of(input)) == 0 || m_state.is_fixed(v) || !m_state.is_at_node(v))
      throw_lost(v);
    const Letter letter = m_state.first_letter(input);
    if (m_state.arc_of_letter(letter) != component)
      throw_lost(v);
    m_state.move_into_arc(v, letter,
                          inner_parameter(components().t(v), m_state.system().height(component)));
    for (int g : mesh().ring(v))
      if (lies_in_component(g, component))
        enqueue(opposite_of(g));
  }

  // whether an entire edge does; flat edges lie in the component of their place
  bool lies_in_component(int h, int component) const
  {
    return components().component_of_vertex(mesh().target(h)) == component &&
           (m_foliation.surface().is_flat(edge_of(h)) ||
            m_foliation.intervals().number_on_edge(edge_of(h)) == 1);
  }

  [[noreturn]] static void throw_lost(int v)
  {
    throw Invalid_foliation_exception(problem(Problem_kind::UNRESOLVED_LEAF, "vertex ", v,
                                              " has no way to the middle leaf of its component")
                                        .vertices({index(v)}));
  }

  const Edge_value_foliation& m_foliation;
  Foliation_state& m_state;
  std::vector<bool> m_is_queued;
  std::vector<int> m_queue; // halfedges, whose sources are the vertices
};

// The edge where a state differs most from the given values, and by how much.
inline std::pair<int, double> largest_difference(const Foliation_state& state,
                                                 const std::vector<double>& value)
{
  std::pair<int, double> result(0, 0);
  for (int e = 0; e < state.mesh().number_of_edges(); ++e)
  {
    const double difference = std::abs(length_of_edge(state, e) - value[e]);
    if (difference > result.second)
      result = {e, difference};
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_EDGE_VALUE_FOLIATION_H
