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

// A problem that is composed in one expression, such as
// `problem(Problem_kind::INVALID_POLE, "vertex ", v, " is no pole").vertices({v})`.
class Problem_builder
{
public:
  Problem_builder(Problem_kind kind, std::string message)
    : m_problem{kind, std::move(message), {}, {}, {}}
  {}

  Problem_builder&& vertices(Indices vertices) &&
  {
    m_problem.vertices = std::move(vertices);
    return std::move(*this);
  }
  Problem_builder&& faces(Indices faces) &&
  {
    m_problem.faces = std::move(faces);
    return std::move(*this);
  }
  Problem_builder&& loops(Indices loops) &&
  {
    m_problem.loops = std::move(loops);
    return std::move(*this);
  }
  operator Problem() && { return std::move(m_problem); }

private:
  Problem m_problem;
};

// the message is composed of its parts
template <class... Part>
Problem_builder problem(Problem_kind kind, const Part&... message)
{
  return Problem_builder(kind, text(message...));
}

template <class... Part>
[[noreturn]] void throw_file_problem(const Part&... message)
{
  throw Invalid_file_exception(problem(Problem_kind::FILE, message...));
}

// whether a problem of this kind is one of the mesh itself, so that nothing on the mesh could be
// checked
inline bool is_about_mesh(Problem_kind kind)
{
  switch (kind)
  {
  case Problem_kind::FILE:
  case Problem_kind::EMPTY_MESH:
  case Problem_kind::TOO_LARGE:
  case Problem_kind::NOT_TRIANGLE_MESH:
  case Problem_kind::NOT_CLOSED:
  case Problem_kind::NOT_MANIFOLD:
  case Problem_kind::NOT_ORIENTABLE:
  case Problem_kind::NOT_CONNECTED:
  case Problem_kind::ISOLATED_VERTEX:
  case Problem_kind::NOT_FINITE:
  case Problem_kind::DEGENERATE_FACE:
    return true;
  default:
    return false;
  }
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
