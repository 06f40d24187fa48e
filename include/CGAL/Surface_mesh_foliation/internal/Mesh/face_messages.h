// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_FACE_MESSAGES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_FACE_MESSAGES_H

#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// What is wrong with the corners of a face, in the wording shared by file readers and mesh checks.

inline std::string corner_count_message(std::size_t face, const std::string& number_of_corners)
{
  return face_name(face) + " has " + number_of_corners + " corners, and only triangles are allowed";
}

inline std::string index_range_message(std::size_t face,
                                       const std::string& index,
                                       std::size_t number_of_vertices)
{
  const std::string message = face_name(face) + " uses vertex " + index + ", but there ";
  if (number_of_vertices == 0)
    return message + "are no vertices";
  return message + "are only the vertices 0 to " + std::to_string(number_of_vertices - 1);
}

// a vertex that is at two corners of the triangle
inline std::optional<std::size_t> repeated_vertex(const std::array<std::size_t, 3>& triangle)
{
  if (triangle[0] == triangle[1] || triangle[0] == triangle[2])
    return triangle[0];
  if (triangle[1] == triangle[2])
    return triangle[1];
  return std::nullopt;
}

inline std::string repeated_vertex_message(std::size_t face, std::size_t vertex)
{
  return face_name(face) + " uses " + vertex_name(vertex) + " more than once";
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_FACE_MESSAGES_H
