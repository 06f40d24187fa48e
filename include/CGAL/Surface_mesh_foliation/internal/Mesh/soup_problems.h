// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_SOUP_PROBLEMS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_SOUP_PROBLEMS_H

#include <CGAL/Surface_mesh_foliation/internal/Common/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Soup_edges.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Soup_orientation_check.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Triangle_soup.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/soup_element_checks.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/soup_surface_checks.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// what a mesh may have although it is no closed surface of one part
struct Soup_freedom
{
  bool openings = false;
  bool parts = false;
};

// runs the checks that need valid indices and three different vertices in each face
inline void check_surface(const Triangle_soup& soup,
                          Soup_freedom freedom,
                          std::vector<Problem>& problems)
{
  const auto add = [&problems](std::optional<Problem> problem) {
    const auto has_kind = [&](const Problem& other) { return other.kind == problem->kind; };
    if (problem && std::none_of(problems.begin(), problems.end(), has_kind))
      problems.push_back(std::move(*problem));
  };
  const Soup_edges edges(soup);
  const std::optional<Problem> non_manifold_edge = find_non_manifold_edge(edges);
  add(find_duplicate_face(edges));
  add(non_manifold_edge);
  if (!freedom.openings)
    add(find_border(soup, edges));
  if (!non_manifold_edge)
    add(Soup_orientation_check(edges, soup.triangles.size()).run());
  add(find_non_manifold_vertex(soup, edges));
  if (!freedom.parts)
    add(find_second_component(soup));
  add(find_isolated_vertex(soup));
  if (problems.empty() || problems.front().kind != Problem_kind::NOT_FINITE)
    add(find_degenerate_face(soup));
}

// what keeps a triangle soup from being a connected oriented manifold triangle mesh that is closed,
// but for the freedom it has; see `check_triangle_soup()`
inline std::vector<Problem> soup_problems(const Triangle_soup& soup, Soup_freedom freedom = {})
{
  if (const auto emptiness = find_emptiness(soup))
    return {*emptiness};
  if (const auto excess = find_excess(soup.triangles.size()))
    return {*excess};
  if (const auto index_out_of_range = find_index_out_of_range(soup))
    return {*index_out_of_range};

  std::vector<Problem> problems;
  if (const auto infinite_coordinate = find_infinite_coordinate(soup))
    problems.push_back(*infinite_coordinate);
  if (const auto repeated_vertex = find_repeated_vertex_in_face(soup))
    problems.push_back(*repeated_vertex);
  else
    check_surface(soup, freedom, problems);
  return problems;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_SOUP_PROBLEMS_H
