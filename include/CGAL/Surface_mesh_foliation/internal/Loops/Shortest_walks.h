// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LOOPS_SHORTEST_WALKS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LOOPS_SHORTEST_WALKS_H

#include <CGAL/Surface_mesh_foliation/internal/Loops/loop_problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/filtered_graph.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Shortest paths along edges from vertex to vertex, each of which avoids certain vertices.
template <class TriangleMesh, class VertexPointMap>
class Shortest_walks
{
  using Traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Traits::vertex_descriptor;
  using edge_descriptor = typename Traits::edge_descriptor;

public:
  Shortest_walks(const TriangleMesh& mesh, VertexPointMap vertex_point_map)
    : m_mesh(mesh),
      m_vertex_point_map(vertex_point_map),
      m_owner(get(CGAL::dynamic_vertex_property_t<int>(), mesh)),
      m_previous(get(CGAL::dynamic_vertex_property_t<vertex_descriptor>(), mesh)),
      m_distance(get(CGAL::dynamic_vertex_property_t<double>(), mesh))
  {
    for (const vertex_descriptor v : vertices(mesh))
      put(m_owner, v, FREE);
  }

  static constexpr int FREE = -2, BLOCKED = -1; // or the number of the path that a vertex lies on

  int owner(vertex_descriptor v) const { return get(m_owner, v); }
  void set_owner(vertex_descriptor v, int owner) { put(m_owner, v, owner); }

  // The shortest path, both ends included, through vertices that are free or, if `crosses_ways`,
  // merely not blocked; empty if there is none.
  std::vector<vertex_descriptor> way(vertex_descriptor from,
                                     vertex_descriptor to,
                                     bool crosses_ways) const
  {
    const std::function<bool(vertex_descriptor)> may_visit = [&](vertex_descriptor v) {
      return v == from || v == to || owner(v) == FREE || (crosses_ways && owner(v) != BLOCKED);
    };
    const boost::filtered_graph<TriangleMesh, boost::keep_all,
                                std::function<bool(vertex_descriptor)>>
      graph(m_mesh, boost::keep_all(), may_visit);
    const auto length = [&](edge_descriptor e) { return this->length(e); };
    for (const vertex_descriptor v : vertices(m_mesh))
      put(m_previous, v, v);
    try
    {
      boost::dijkstra_shortest_paths(
        graph, from,
        boost::predecessor_map(m_previous)
          .distance_map(m_distance)
          .vertex_index_map(CGAL::get_initialized_vertex_index_map(m_mesh))
          .weight_map(boost::make_function_property_map<edge_descriptor, double>(length))
          .visitor(Stop_at{to}));
    }
    catch (const Arrival&)
    {}
    std::vector<vertex_descriptor> result = {to};
    while (get(m_previous, result.back()) != result.back())
      result.push_back(get(m_previous, result.back()));
    std::reverse(result.begin(), result.end());
    return result.front() == from ? result : std::vector<vertex_descriptor>();
  }

private:
  struct Arrival
  {};

  struct Stop_at : boost::default_dijkstra_visitor
  {
    explicit Stop_at(vertex_descriptor v) : target(v) {}
    template <class Graph>
    void examine_vertex(vertex_descriptor v, const Graph&) const
    {
      if (v == target)
        throw Arrival();
    }
    vertex_descriptor target;
  };

  double length(edge_descriptor e) const
  {
    const Point p = coordinates(get(m_vertex_point_map, source(e, m_mesh)));
    const Point q = coordinates(get(m_vertex_point_map, target(e, m_mesh)));
    return distance(p, q);
  }

  template <class T>
  using Vertex_map =
    typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<T>>::const_type;

  const TriangleMesh& m_mesh;
  VertexPointMap m_vertex_point_map;
  Vertex_map<int> m_owner;
  Vertex_map<vertex_descriptor> m_previous; // itself if it has none
  Vertex_map<double> m_distance;
};

// says which path the one between two picked vertices cannot avoid, and where
template <class Walks, class Vertices, class TriangleMesh>
[[noreturn]] void throw_blocked_path(const Walks& walks,
                                     const Vertices& picks,
                                     std::size_t i,
                                     const TriangleMesh& mesh)
{
  const auto position = [&](std::size_t pick) {
    return position_of_vertex(picks[pick % picks.size()], mesh);
  };
  const auto name = [&](std::size_t pick) {
    return "the path from " + vertex_name(position(pick)) + " to " +
           vertex_name(position(pick + 1));
  };
  for (const auto v : walks.way(picks[i], picks[(i + 1) % picks.size()], true))
    if (walks.owner(v) >= 0)
    {
      const std::size_t j = static_cast<std::size_t>(walks.owner(v));
      const std::size_t place = position_of_vertex(v, mesh);
      throw_loop_problem(
        name(i) + " cannot avoid " + name(j) + ": they cross at " + vertex_name(place), {place});
    }
  throw_loop_problem(name(i) + " is blocked by poles and other picked vertices",
                     {position(i), position(i + 1)});
}

// A closed walk along edges through all picks that visits no vertex twice, and none of the vertices
// to be avoided.
template <class Vertex, class TriangleMesh, class NamedParameters>
std::vector<Vertex> closed_walk_through(const std::vector<Vertex>& picks,
                                        const std::vector<Vertex>& avoided,
                                        const TriangleMesh& mesh,
                                        const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto vertex_point_map = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                                 get_const_property_map(CGAL::vertex_point, mesh));
  Shortest_walks walks(mesh, vertex_point_map);
  for (const Vertex v : avoided)
    walks.set_owner(v, walks.BLOCKED);
  for (const Vertex v : picks)
    walks.set_owner(v, walks.BLOCKED);
  std::vector<Vertex> result;
  for (std::size_t i = 0; i < picks.size(); ++i)
  {
    const std::vector<Vertex> way = walks.way(picks[i], picks[(i + 1) % picks.size()], false);
    if (way.empty())
      throw_blocked_path(walks, picks, i, mesh);
    result.insert(result.end(), way.begin(), way.end() - 1);
    for (std::size_t j = 1; j + 1 < way.size(); ++j)
      walks.set_owner(way[j], static_cast<int>(i));
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LOOPS_SHORTEST_WALKS_H
