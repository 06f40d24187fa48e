// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "walks.h"

#include <CGAL/Surface_mesh_foliation/exceptions.h>

#include <CGAL/boost/graph/properties_Surface_mesh.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <string>
#include <vector>

namespace smf_engine {

namespace {

// Removes what a walk goes forth and back at once, also across its end.
void remove_spurs_at_end(std::deque<Index>& walk)
{
  const auto has_spur = [&] {
    const std::size_t n = walk.size();
    return n > 1 && (walk[n - 1] == walk[0] || (n > 2 && walk[n - 2] == walk[0]));
  };
  while (has_spur())
    walk.pop_back();
  while (walk.size() > 2 && walk.back() == walk[1])
  {
    walk.pop_front();
    while (has_spur())
      walk.pop_back();
  }
}

struct Arrival
{};

struct Stop_at : boost::default_dijkstra_visitor
{
  explicit Stop_at(Vertex v) : target(v) {}
  void examine_vertex(Vertex v, const Mesh&) const
  {
    if (v == target)
      throw Arrival();
  }
  Vertex target;
};

// the shortest path, both ends included
Indices shortest_path(Vertex from, Vertex to, const Mesh& mesh)
{
  const auto length = [&mesh](Edge e) {
    return std::sqrt(
      CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  };
  std::vector<Vertex> previous(mesh.vertices_begin(), mesh.vertices_end());
  Doubles distance(mesh.number_of_vertices(), std::numeric_limits<double>::infinity());
  const auto index = get(boost::vertex_index, mesh);
  try
  {
    boost::dijkstra_shortest_paths(
      mesh, from,
      boost::predecessor_map(boost::make_iterator_property_map(previous.begin(), index))
        .distance_map(boost::make_iterator_property_map(distance.begin(), index))
        .vertex_index_map(index)
        .weight_map(boost::make_function_property_map<Edge, double>(length))
        .visitor(Stop_at(to)));
  }
  catch (const Arrival&)
  {}
  Indices result = {to};
  while (previous[result.back()] != Vertex(result.back()))
    result.push_back(previous[result.back()]);
  std::reverse(result.begin(), result.end());
  return result;
}

} // namespace

Vertex vertex_of(std::size_t number, const Mesh& mesh)
{
  if (number < mesh.number_of_vertices())
    return Vertex(static_cast<Mesh::size_type>(number));
  throw SMF::Invalid_parameter_exception(
    {SMF::Problem_kind::INVALID_PARAMETER,
     "there is no vertex " + std::to_string(number) + "; the mesh has " +
       std::to_string(mesh.number_of_vertices()) + ", numbered from 0",
     {},
     {},
     {}});
}

Indices walk_to_right_of(const Loop& loop, const Mesh& mesh)
{
  std::deque<Index> walk;
  for (const auto& crossing : loop)
  {
    const Index v = mesh.source(crossing.halfedge);
    const std::size_t n = walk.size();
    if (n > 1 && walk[n - 2] == v)
      walk.pop_back();
    else if (n == 0 || walk[n - 1] != v)
      walk.push_back(v);
  }
  remove_spurs_at_end(walk);
  return {walk.begin(), walk.end()};
}

State_loop found_loop(const Loop& loop, const Mesh& mesh)
{
  State_loop result;
  result.vertices = walk_to_right_of(loop, mesh);
  result.is_found = true;
  for (const auto& crossing : loop)
    result.crossings.push_back(
      {mesh.source(crossing.halfedge), mesh.target(crossing.halfedge), crossing.position});
  return result;
}

Loop loop_of(const std::vector<State_crossing>& crossings, const Mesh& mesh)
{
  Loop result;
  for (const State_crossing& crossing : crossings)
  {
    const Vertex source = vertex_of(crossing.source, mesh),
                 target = vertex_of(crossing.target, mesh);
    const Halfedge h = mesh.halfedge(source, target);
    if (h == Mesh::null_halfedge())
      throw SMF::Invalid_loops_exception(
        {SMF::Problem_kind::INVALID_LOOP,
         "no edge joins the vertices " + std::to_string(crossing.source) + " and " +
           std::to_string(crossing.target) + ", between which a loop is to pass",
         {crossing.source, crossing.target},
         {},
         {}});
    result.push_back({h, crossing.position});
  }
  return result;
}

Indices path_through(const Indices& picks, const Mesh& mesh)
{
  Indices result;
  for (std::size_t i = 0; i < picks.size(); ++i)
  {
    const Vertex v = vertex_of(picks[i], mesh);
    if (i == 0)
      result.push_back(v);
    else
    {
      const Indices path = shortest_path(Vertex(result.back()), v, mesh);
      result.insert(result.end(), path.begin() + 1, path.end());
    }
  }
  return result;
}

} // namespace smf_engine
