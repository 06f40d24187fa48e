// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_READ_OBJ_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_READ_OBJ_H

#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/Face_collectors.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/Text_cursor.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/mesh_file_records.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/parse_number.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

// A strict reader of the part of Wavefront OBJ that describes polygon meshes; the rest of the
// standard is skipped.

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The statements of the standard that say nothing about the vertices and faces of a polygon mesh.
// `call`, which includes another file, and `csh`, which runs a program, are not among them.
inline bool is_ignored_obj_keyword(std::string_view keyword)
{
  static constexpr std::array<std::string_view, 40> ignored = {
    // data of vertices
    "vt", "vn", "vp",
    // points, lines, groups
    "p", "l", "g", "s", "mg", "o",
    // free-form curves and surfaces
    "cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim", "hole", "scrv", "sp",
    "end", "con", "bsp", "bzp", "cdc", "cdp", "res",
    // how things are drawn
    "bevel", "c_interp", "d_interp", "lod", "maplib", "usemap", "mtllib", "usemtl", "shadow_obj",
    "trace_obj", "ctech", "stech"};
  return std::find(ignored.begin(), ignored.end(), keyword) != ignored.end();
}

// "7", "7/1", "7//3" or "7/1/3": only the vertex matters. Indices start at 1, negative ones count
// back from the last vertex so far, and a face may come before its vertices.
inline std::size_t read_obj_corner(Text_cursor& cursor,
                                   std::size_t number_of_points,
                                   std::size_t face)
{
  const std::string_view word = cursor.next_word();
  long long index = 0;
  const Parse_status status = parse_number(word.substr(0, word.find('/')), index);
  if (status == Parse_status::NOT_A_NUMBER)
    cursor.fail(face_name(face) + ": " + quoted(word) + " is not an index");
  const bool is_too_large = // where std::size_t has 32 bits
    index > 0 && static_cast<long long>(static_cast<std::size_t>(index)) != index;
  if (status == Parse_status::OUT_OF_RANGE || index == 0 || is_too_large ||
      index < -static_cast<long long>(number_of_points))
    cursor.fail(face_name(face) + ": the index " + quoted(word) + " is out of range");
  return index > 0 ? static_cast<std::size_t>(index - 1)
                   : number_of_points - static_cast<std::size_t>(-index);
}

template <class Collector>
void read_obj_face(Text_cursor& cursor, Collector& result)
{
  while (!cursor.is_line_finished())
    result.add_corner(read_obj_corner(cursor, result.soup.points.size(), result.number_of_faces()));
  result.end_face(cursor);
}

template <class Faces>
void check_obj_indices(const std::string& file_name,
                       const Faces& faces,
                       std::size_t number_of_points)
{
  for (std::size_t face = 0; face < faces.size(); ++face)
    for (const std::size_t corner : faces[face])
      if (corner >= number_of_points)
        throw_file_problem(file_name + ": ",
                           index_range_message(face, std::to_string(corner), number_of_points));
}

template <class Collector = Triangle_collector>
typename Collector::Soup read_obj(const std::string& file_name, std::string_view text)
{
  Text_cursor cursor(file_name, text, '#', '\\');
  Collector result;
  while (cursor.next_line())
  {
    const std::string_view keyword = cursor.next_word();
    if (keyword == "v")
    {
      const std::size_t vertex = result.soup.points.size();
      result.soup.points.push_back(read_point(cursor, vertex));
      skip_numbers(cursor, {"vertex", vertex}); // a weight or a color
    }
    else if (keyword == "f")
      read_obj_face(cursor, result);
    else if (!is_ignored_obj_keyword(keyword))
      cursor.fail("unknown OBJ statement " + quoted(keyword));
  }
  check_obj_indices(file_name, result.faces(), result.soup.points.size());
  return std::move(result.soup);
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_READ_OBJ_H
