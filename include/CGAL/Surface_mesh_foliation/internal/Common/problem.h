// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_PROBLEM_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_PROBLEM_H

#include <CGAL/Surface_mesh_foliation/internal/Common/exceptions.h>

#include <cstddef>
#include <locale>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

using Problems = std::vector<Problem>;
using Indices = std::vector<std::size_t>;

template <class... Part>
std::string text(const Part&... parts)
{
  std::ostringstream out;
  out.imbue(std::locale::classic());
  (out << ... << parts);
  return out.str();
}

inline std::size_t index(int i)
{
  return static_cast<std::size_t>(i);
}

// a problem of vertices and faces
inline Problem mesh_problem(Problem_kind kind,
                            std::string message,
                            std::vector<std::size_t> vertices,
                            std::vector<std::size_t> faces)
{
  return Problem{kind, std::move(message), std::move(vertices), std::move(faces), {}};
}

inline Problem file_problem(std::string message)
{
  return mesh_problem(Problem_kind::FILE, std::move(message), {}, {});
}

// `place` is the file and line with ": " behind it, or empty
[[noreturn]] inline void throw_file_problem(const std::string& place, const std::string& what)
{
  throw Invalid_file_exception(file_problem(place + what));
}

[[noreturn]] inline void throw_mesh_problem(const std::string& place,
                                            Problem_kind kind,
                                            const std::string& what,
                                            std::vector<std::size_t> vertices,
                                            std::vector<std::size_t> faces)
{
  throw Invalid_mesh_exception(
    mesh_problem(kind, place + what, std::move(vertices), std::move(faces)));
}

inline std::string vertex_name(std::size_t vertex)
{
  return "vertex " + std::to_string(vertex);
}
inline std::string face_name(std::size_t face)
{
  return "face " + std::to_string(face);
}

// a piece of a file for use in a message: in quotes, short, and printable whatever the file holds
inline std::string quoted(std::string_view text)
{
  constexpr std::size_t maximal_length = 24;
  std::string result = "'";
  for (const char c : text.substr(0, maximal_length))
    result += (c >= ' ' && c <= '~') ? c : '?';
  return result + (text.size() > maximal_length ? "...'" : "'");
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_PROBLEM_H
