// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_SOUP_SURFACE_CHECKS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_SOUP_SURFACE_CHECKS_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Triangle_soup.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Soup_edges.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/Disjoint_sets.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// Checks of a triangle soup with valid indices and three different corners in every face: is it a
// closed, connected manifold? Each returns the first problem of its kind.

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

inline std::string edge_name(const Soup_edges& edges, std::size_t edge)
{
  const std::size_t side = edges.side(edge, 0);
  return "the edge between the vertices " + std::to_string(edges.source(side)) + " and " +
         std::to_string(edges.target(side));
}

// One of two faces with the same vertices is a copy or the back of the other.
// Copies of a face lie at the same edges. Edges come in lexicographic order, so the first copies
// found are those with the smallest vertices.
inline std::optional<Problem> find_duplicate_face(const Soup_edges& edges)
{
  std::vector<std::pair<std::size_t, std::size_t>> apex_and_face; // of the sides of one edge
  for (std::size_t edge = 0; edge < edges.size(); ++edge)
  {
    apex_and_face.clear();
    for (std::size_t i = 0; i < edges.number_of_sides(edge); ++i)
    {
      const std::size_t side = edges.side(edge, i);
      apex_and_face.emplace_back(edges.target(Soup_edges::next(side)), Soup_edges::face(side));
    }
    std::sort(apex_and_face.begin(), apex_and_face.end());
    const auto copy = std::adjacent_find(
      apex_and_face.begin(), apex_and_face.end(),
      [](const auto& left, const auto& right) { return left.first == right.first; });
    if (copy == apex_and_face.end())
      continue;
    const std::size_t side = edges.side(edge, 0), first = copy->second;
    const std::size_t second = std::next(copy)->second;
    std::array<std::size_t, 3> vertices = {edges.source(side), edges.target(side), copy->first};
    std::sort(vertices.begin(), vertices.end());
    return problem(Problem_kind::NOT_MANIFOLD, "the faces ", first, " and ", second,
                   " have the same three vertices ", vertices[0], ", ", vertices[1], " and ",
                   vertices[2])
      .vertices({vertices[0], vertices[1], vertices[2]})
      .faces({first, second});
  }
  return std::nullopt;
}

inline std::optional<Problem> find_non_manifold_edge(const Soup_edges& edges)
{
  for (std::size_t edge = 0; edge < edges.size(); ++edge)
  {
    if (edges.number_of_sides(edge) <= 2)
      continue;
    std::vector<std::size_t> faces;
    for (std::size_t i = 0; i < edges.number_of_sides(edge); ++i)
      faces.push_back(Soup_edges::face(edges.side(edge, i)));
    const std::size_t side = edges.side(edge, 0);
    return problem(Problem_kind::NOT_MANIFOLD, edge_name(edges, edge), " is not manifold: it has ",
                   faces.size(), " faces, among them ", faces[0], ", ", faces[1], " and ", faces[2])
      .vertices({edges.source(side), edges.target(side)})
      .faces(faces);
  }
  return std::nullopt;
}

// Openings are counted as connected sets of border edges, each with its length.
inline std::optional<Problem> find_border(const Triangle_soup& soup, const Soup_edges& edges)
{
  Disjoint_sets sets(soup.points.size());
  std::vector<std::size_t> border_sides;
  for (std::size_t edge = 0; edge < edges.size(); ++edge)
    if (edges.number_of_sides(edge) == 1)
    {
      border_sides.push_back(edges.side(edge, 0));
      sets.union_set(edges.source(border_sides.back()), edges.target(border_sides.back()));
    }
  if (border_sides.empty())
    return std::nullopt;
  std::map<std::size_t, double> length_of_set;
  for (const std::size_t side : border_sides)
    length_of_set[sets.find_set(edges.source(side))] +=
      distance(soup.points[edges.source(side)], soup.points[edges.target(side)]);
  std::vector<double> lengths;
  lengths.reserve(length_of_set.size());
  for (const auto& [set, length] : length_of_set)
    lengths.push_back(length);
  std::sort(lengths.rbegin(), lengths.rend());

  const std::size_t side = border_sides.front(), number = lengths.size();
  std::string message =
    text("the mesh is not closed: it has ", number, number == 1 ? " opening" : " openings",
         " bounded by ", border_sides.size(), " edges, of length");
  for (std::size_t i = 0; i < number && i < 5; ++i)
    message += text(i == 0 ? " " : ", ", lengths[i]);
  message +=
    text(number > 5 ? ", ..." : "", "; one is at the edge between the vertices ",
         edges.source(side), " and ", edges.target(side), " in face ", Soup_edges::face(side));
  if (border_sides.size() == edges.size() && edges.size() > 3)
    message += "; no two faces share an edge, so that merging vertices at equal positions may help";
  return problem(Problem_kind::NOT_CLOSED, message)
    .vertices({edges.source(side), edges.target(side)})
    .faces({Soup_edges::face(side)});
}

// Corners are numbered like the sides that leave them. Two corners at a vertex are in the same
// umbrella if one can go from one to the other through faces at that vertex, crossing edges.
inline std::optional<Problem> find_non_manifold_vertex(const Triangle_soup& soup,
                                                       const Soup_edges& edges)
{
  Disjoint_sets umbrellas(3 * soup.triangles.size());
  const auto corner_at = [&](std::size_t side, std::size_t vertex) {
    return edges.source(side) == vertex ? side : Soup_edges::next(side);
  };
  for (std::size_t edge = 0; edge < edges.size(); ++edge)
    for (std::size_t i = 1; i < edges.number_of_sides(edge); ++i)
    {
      const std::size_t side = edges.side(edge, 0);
      const std::size_t other = edges.side(edge, i);
      umbrellas.union_set(side, corner_at(other, edges.source(side)));
      umbrellas.union_set(Soup_edges::next(side), corner_at(other, edges.target(side)));
    }

  std::vector<std::size_t> number_of_umbrellas(soup.points.size(), 0);
  for (std::size_t corner = 0; corner < 3 * soup.triangles.size(); ++corner)
    if (umbrellas.find_set(corner) == corner)
      ++number_of_umbrellas[edges.source(corner)];
  for (std::size_t vertex = 0; vertex < soup.points.size(); ++vertex)
    if (number_of_umbrellas[vertex] > 1)
      return problem(Problem_kind::NOT_MANIFOLD, vertex_name(vertex),
                     " is not manifold: its faces form ", number_of_umbrellas[vertex],
                     " separate umbrellas")
        .vertices({vertex});
  return std::nullopt;
}

// Isolated vertices do not count as components.
inline std::optional<Problem> find_second_component(const Triangle_soup& soup)
{
  Disjoint_sets components(soup.points.size());
  std::size_t number_of_components = 0;
  std::vector<bool> has_face(soup.points.size(), false);
  for (const auto& [a, b, c] : soup.triangles)
  {
    components.union_set(a, b);
    components.union_set(a, c);
    has_face[a] = has_face[b] = has_face[c] = true;
  }
  const std::size_t first = soup.triangles.front()[0];
  std::optional<std::size_t> other;
  for (std::size_t vertex = 0; vertex < soup.points.size(); ++vertex)
  {
    if (!has_face[vertex])
      continue;
    number_of_components += components.find_set(vertex) == vertex;
    if (!other && components.find_set(vertex) != components.find_set(first))
      other = vertex;
  }
  if (!other)
    return std::nullopt;
  return problem(Problem_kind::NOT_CONNECTED, "the mesh is not connected: it has ",
                 number_of_components, " components; the vertices ", first, " and ", *other,
                 " are in different ones")
    .vertices({first, *other});
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_SOUP_SURFACE_CHECKS_H
