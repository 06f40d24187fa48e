// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_AUTOMATIC_LOOPS_FILL_SHORT_HANDLES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_AUTOMATIC_LOOPS_FILL_SHORT_HANDLES_H

#include <CGAL/Surface_mesh_foliation/internal/Automatic_loops/Loop_families.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// the pieces beside some families, in order
inline std::vector<int> pieces_with_families(const Loop_families& families,
                                             const std::vector<int>& some)
{
  std::vector<int> result;
  for (int f : some)
    for (int piece : families.family(f).pieces)
      result.push_back(piece);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

// The other families of the shortest cycle through family f, by the lengths of loops; none if f is
// not on a cycle. `alive` lists the families that still exist.
inline std::optional<std::vector<int>> rest_of_shortest_cycle(const Loop_families& families,
                                                              const std::vector<int>& alive,
                                                              int f,
                                                              const std::vector<double>& lengths)
{
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS,
                                      boost::no_property, std::pair<int, double>>;
  using Edge = Graph::edge_descriptor;
  struct Recorder : boost::dijkstra_visitor<>
  {
    explicit Recorder(std::vector<std::optional<Edge>>& e) : edges(&e) {}
    void edge_relaxed(const Edge& e, const Graph& graph) { (*edges)[target(e, graph)] = e; }
    std::vector<std::optional<Edge>>* edges;
  };

  const auto& ends = families.family(f).pieces;
  if (ends[0] == ends[1])
    return std::vector<int>();
  const std::vector<int> pieces = pieces_with_families(families, alive);
  const auto number = [&](int piece) {
    return static_cast<std::size_t>(std::lower_bound(pieces.begin(), pieces.end(), piece) -
                                    pieces.begin());
  };
  Graph graph(pieces.size());
  for (int g : alive)
    if (g != f)
      add_edge(number(families.family(g).pieces[0]), number(families.family(g).pieces[1]),
               std::make_pair(g, lengths[g]), graph);
  const std::size_t u = number(ends[0]), v = number(ends[1]);
  std::vector<std::optional<Edge>> edge_to(num_vertices(graph));
  boost::dijkstra_shortest_paths(
    graph, u,
    boost::weight_map(get(&std::pair<int, double>::second, graph)).visitor(Recorder(edge_to)));
  std::vector<int> result;
  for (std::size_t r = v; r != u;)
  {
    if (!edge_to[r])
      return std::nullopt;
    result.push_back(graph[*edge_to[r]].first);
    r = source(*edge_to[r], graph); // the end from which the edge was relaxed
  }
  return result;
}

// Fills the handles that have a loop shorter than a bound, the shortest first. A handle is a cycle
// of families, and all of them are dropped: the surface that is cut along the shortest one and
// closed with two disks does not have the cycle.
inline void fill_short_handles(Loop_families& families,
                               const std::vector<double>& lengths,
                               double bound,
                               bool uses_poles_as_punctures)
{
  std::vector<bool> is_on_no_cycle(lengths.size(), false); // once true, it stays true
  std::vector<int> alive(lengths.size());
  std::iota(alive.begin(), alive.end(), 0);
  while (true)
  {
    const auto is_dead = [&](int f) { return !families.family(f).is_alive; };
    alive.erase(std::remove_if(alive.begin(), alive.end(), is_dead), alive.end());
    int shortest = -1;
    for (int f : alive)
      if (!is_on_no_cycle[f] && lengths[f] < bound &&
          (shortest < 0 || lengths[f] < lengths[shortest]))
        shortest = f;
    if (shortest < 0)
      return;
    const auto rest = rest_of_shortest_cycle(families, alive, shortest, lengths);
    if (!rest)
    {
      is_on_no_cycle[shortest] = true;
      continue;
    }
    families.drop(shortest);
    for (int f : *rest)
      families.drop(f);
    families.reduce(uses_poles_as_punctures);
  }
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_AUTOMATIC_LOOPS_FILL_SHORT_HANDLES_H
