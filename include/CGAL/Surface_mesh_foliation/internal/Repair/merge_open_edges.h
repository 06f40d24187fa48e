// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_REPAIR_MERGE_OPEN_EDGES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_REPAIR_MERGE_OPEN_EDGES_H

#include <CGAL/Surface_mesh_foliation/internal/Common/Disjoint_sets.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>
#include <CGAL/Surface_mesh_foliation/internal/Repair/Traced_soup.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// An edge with one face, its ends in the order of their positions.
struct Open_edge
{
  Point first, second; // positions
  std::size_t first_vertex, second_vertex;

  bool lies_at(const Open_edge& other) const
  {
    return first == other.first && second == other.second;
  }
};

// sorted by positions
inline std::vector<Open_edge> open_edges(const Traced_soup& soup,
                                         const std::vector<Traced_soup::Edge>& edges)
{
  std::vector<Open_edge> result;
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end)
  {
    while (end < edges.size() && edges[end] == edges[i])
      ++end;
    if (end > i + 1)
      continue;
    auto [u, v] = edges[i];
    if (soup.points[v] < soup.points[u])
      std::swap(u, v);
    result.push_back({soup.points[u], soup.points[v], u, v});
  }
  std::stable_sort(result.begin(), result.end(), [](const Open_edge& a, const Open_edge& b) {
    return std::tie(a.first, a.second) < std::tie(b.first, b.second);
  });
  return result;
}

// Merges edges with one face that lie at the same place, and the ends of edges of length zero, the
// later vertices into the first. Other vertices stay apart: surfaces may touch. Returns the number
// of vertices that were merged into others.
inline std::size_t merge_open_edges(Traced_soup& soup)
{
  const std::vector<Traced_soup::Edge> edges = soup.edges_of_faces();
  const std::vector<Open_edge> open = open_edges(soup, edges);
  Disjoint_sets sets(soup.points.size());
  for (std::size_t i = 1; i < open.size(); ++i)
    if (open[i].lies_at(open[i - 1]))
    {
      sets.union_set(open[i].first_vertex, open[i - 1].first_vertex);
      sets.union_set(open[i].second_vertex, open[i - 1].second_vertex);
    }
  for (const auto& [u, v] : edges)
    if (soup.points[u] == soup.points[v])
      sets.union_set(u, v);

  std::vector<std::size_t> first_of_set(soup.points.size(), no_element), target;
  std::size_t result = 0;
  for (std::size_t v = 0; v < soup.points.size(); ++v)
  {
    std::size_t& first = first_of_set[sets.find_set(v)];
    if (first == no_element)
      first = v;
    else
      ++result;
    target.push_back(first);
  }
  for (Traced_soup::Face& face : soup.faces)
    for (std::size_t& v : face)
      v = target[v];
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_REPAIR_MERGE_OPEN_EDGES_H
