// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_SOUP_ELEMENT_CHECKS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_SOUP_ELEMENT_CHECKS_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Triangle_soup.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/are_collinear.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/face_messages.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

// Checks of a triangle soup that look at one vertex or one face at a time. Each returns the first
// problem of its kind.

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

inline std::optional<Problem> find_emptiness(const Triangle_soup& soup)
{
  if (soup.points.empty())
    return problem(Problem_kind::EMPTY_MESH, "the mesh has no vertices");
  if (soup.triangles.empty())
    return problem(Problem_kind::EMPTY_MESH, "the mesh has no faces");
  return std::nullopt;
}

// inside the package, vertices, halfedges and faces have numbers of type int
inline std::optional<Problem> find_excess(std::size_t number_of_faces)
{
  constexpr std::size_t most = static_cast<std::size_t>((std::numeric_limits<int>::max)()) / 3;
  if (number_of_faces <= most)
    return std::nullopt;
  return problem(Problem_kind::TOO_LARGE, "the mesh has ", number_of_faces, " faces; at most ",
                 most, " are possible");
}

inline std::optional<Problem> find_index_out_of_range(const Triangle_soup& soup)
{
  for (std::size_t face = 0; face < soup.triangles.size(); ++face)
    for (const std::size_t corner : soup.triangles[face])
      if (corner >= soup.points.size())
        return problem(Problem_kind::FILE,
                       index_range_message(face, std::to_string(corner), soup.points.size()))
          .faces({face});
  return std::nullopt;
}

inline std::optional<Problem> find_repeated_vertex_in_face(const Triangle_soup& soup)
{
  for (std::size_t face = 0; face < soup.triangles.size(); ++face)
    if (const auto vertex = repeated_vertex(soup.triangles[face]))
      return problem(Problem_kind::NOT_TRIANGLE_MESH, repeated_vertex_message(face, *vertex))
        .vertices({*vertex})
        .faces({face});
  return std::nullopt;
}

inline std::optional<Problem> find_infinite_coordinate(const Triangle_soup& soup)
{
  for (std::size_t vertex = 0; vertex < soup.points.size(); ++vertex)
    for (const double coordinate : soup.points[vertex])
      if (!std::isfinite(coordinate))
        return problem(Problem_kind::NOT_FINITE, vertex_name(vertex),
                       " has a coordinate that is not finite")
          .vertices({vertex});
  return std::nullopt;
}

inline std::optional<Problem> find_isolated_vertex(const Triangle_soup& soup)
{
  std::vector<bool> has_face(soup.points.size(), false);
  for (const std::array<std::size_t, 3>& triangle : soup.triangles)
    for (const std::size_t corner : triangle)
      has_face[corner] = true;
  for (std::size_t vertex = 0; vertex < soup.points.size(); ++vertex)
    if (!has_face[vertex])
      return problem(Problem_kind::ISOLATED_VERTEX, vertex_name(vertex),
                     " is isolated: no face uses it")
        .vertices({vertex});
  return std::nullopt;
}

// Exact, so that slivers pass and only faces without any area are rejected.
inline std::optional<Problem> find_degenerate_face(const Triangle_soup& soup)
{
  for (std::size_t face = 0; face < soup.triangles.size(); ++face)
  {
    const auto [a, b, c] = soup.triangles[face];
    if (are_clearly_not_collinear(soup.points[a], soup.points[b], soup.points[c]))
      continue;
    if (are_collinear(soup.points[a], soup.points[b], soup.points[c]))
      return problem(Problem_kind::DEGENERATE_FACE, face_name(face),
                     " is degenerate: its vertices ", a, ", ", b, " and ", c, " lie on a line")
        .vertices({a, b, c})
        .faces({face});
  }
  return std::nullopt;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_SOUP_ELEMENT_CHECKS_H
