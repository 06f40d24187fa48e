// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_FACE_COLLECTORS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_FACE_COLLECTORS_H

#include <CGAL/Surface_mesh_foliation/internal/Common/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Polygon_soup.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Triangle_soup.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/face_messages.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// Where the readers of all formats put what they read: a collector has the soup, and takes faces
// corner by corner. One accepts triangles only, the other one polygons of any kind.
//
// `source` serves only to tell the place in the file.

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

template <class Source>
[[noreturn]] void fail_at_number_of_corners(const Source& source,
                                            std::size_t face,
                                            const std::string& number)
{
  throw Invalid_mesh_exception(
    problem(Problem_kind::NOT_TRIANGLE_MESH, source.place(), corner_count_message(face, number))
      .faces({face}));
}

// Refuses what is not a triangle with three different vertices.
class Triangle_collector
{
public:
  using Soup = Triangle_soup;

  Soup soup;

  const std::vector<std::array<std::size_t, 3>>& faces() const { return soup.triangles; }
  std::size_t number_of_faces() const { return soup.triangles.size(); }
  void reserve_faces(std::size_t number) { soup.triangles.reserve(number); }

  // for formats that give the number of corners before these; `number` is any kind of number
  template <class Source, class Number>
  void begin_face(const Source& source, Number number) const
  {
    if (number != 3)
      fail_at_number_of_corners(source, number_of_faces(),
                                std::to_string(static_cast<long long>(number)));
  }

  void add_corner(std::size_t vertex)
  {
    if (m_number_of_corners < 3)
      m_corners[m_number_of_corners] = vertex;
    ++m_number_of_corners;
  }

  template <class Source>
  void end_face(const Source& source)
  {
    const std::size_t number = std::exchange(m_number_of_corners, 0);
    if (number != 3)
      fail_at_number_of_corners(source, number_of_faces(), std::to_string(number));
    if (const std::optional<std::size_t> vertex = repeated_vertex(m_corners))
      throw Invalid_mesh_exception(problem(Problem_kind::NOT_TRIANGLE_MESH, source.place(),
                                           repeated_vertex_message(number_of_faces(), *vertex))
                                     .vertices({*vertex})
                                     .faces({number_of_faces()}));
    soup.triangles.push_back(m_corners);
  }

private:
  std::array<std::size_t, 3> m_corners = {};
  std::size_t m_number_of_corners = 0;
};

class Polygon_collector
{
public:
  using Soup = Polygon_soup;

  Soup soup;

  const std::vector<std::vector<std::size_t>>& faces() const { return soup.polygons; }
  std::size_t number_of_faces() const { return soup.polygons.size(); }
  void reserve_faces(std::size_t number) { soup.polygons.reserve(number); }

  template <class Source, class Number>
  void begin_face(const Source& source, Number number) const
  {
    if (number < 0)
      throw_file_problem(source.place(), face_name(number_of_faces()),
                         ": the number of its corners is negative");
  }

  void add_corner(std::size_t vertex) { m_corners.push_back(vertex); }

  template <class Source>
  void end_face(const Source&)
  {
    soup.polygons.push_back(std::exchange(m_corners, std::vector<std::size_t>()));
  }

private:
  std::vector<std::size_t> m_corners;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_FACE_COLLECTORS_H
