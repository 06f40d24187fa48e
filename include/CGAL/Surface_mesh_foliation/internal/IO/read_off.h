// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_READ_OFF_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_READ_OFF_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Triangle_soup.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/Text_cursor.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/mesh_file_records.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>

// A strict reader of ASCII OFF: one line per record, every number checked, nothing left over.

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

struct Off_header
{
  bool has_vertex_attributes; // texture coordinates, colors or normals after the coordinates
  std::size_t number_of_vertices;
  std::size_t number_of_faces;
};

inline bool starts_off_file(std::string_view word)
{
  return word == "OFF" || word == "COFF" || word == "NOFF" || word == "CNOFF" || word == "STOFF" ||
         word == "STCOFF" || word == "STNOFF" || word == "STCNOFF";
}

inline std::size_t read_off_count(Text_cursor& cursor, const char* what)
{
  const std::string_view word = cursor.next_word();
  std::size_t count = 0;
  const std::string subject = std::string("the number of ") + what;
  if (word.empty())
    cursor.fail(subject + " is missing");
  const Parse_status status = parse_number(word, count);
  if (status == Parse_status::NOT_A_NUMBER)
    cursor.fail(subject + ", " + quoted(word) + ", is not a non-negative integer");
  if (status == Parse_status::OUT_OF_RANGE)
    cursor.fail(subject + ", " + quoted(word) + ", is out of range");
  return count;
}

// A record takes at least two bytes: a false claim is rejected before anything is read.
inline void check_off_claim(const Text_cursor& cursor, std::size_t count, const char* what)
{
  const std::size_t remaining_bytes = cursor.remaining_text().size();
  if (count > (remaining_bytes + 1) / 2)
    cursor.fail("unexpected end of file: the header claims " + std::to_string(count) + " " + what +
                ", but only " + std::to_string(remaining_bytes) + " bytes follow");
}

inline Off_header read_off_header(Text_cursor& cursor)
{
  if (!cursor.next_line())
    cursor.fail("the file is empty");
  const std::string_view magic = cursor.next_word();
  if (!starts_off_file(magic))
    cursor.fail("not an OFF file: it starts with " + quoted(magic) + " instead of 'OFF'");
  if (cursor.is_line_finished() && !cursor.next_line())
    cursor.fail("unexpected end of file: the numbers of vertices and faces are missing");

  Off_header header;
  header.has_vertex_attributes = magic != "OFF";
  header.number_of_vertices = read_off_count(cursor, "vertices");
  header.number_of_faces = read_off_count(cursor, "faces");
  if (!cursor.is_line_finished())
    read_off_count(cursor, "edges"); // often wrong in practice, and not needed
  if (!cursor.is_line_finished())
    cursor.fail("more than three numbers in the header: " + quoted(cursor.next_word()));
  check_off_claim(cursor, header.number_of_vertices, "vertices");
  check_off_claim(cursor, header.number_of_faces, "faces");
  return header;
}

inline void next_off_record(Text_cursor& cursor, const Record& record, std::size_t count)
{
  if (!cursor.next_line())
    cursor.fail("unexpected end of file: " + record.name() + " of " + std::to_string(count) +
                " is missing");
}

inline std::array<double, 3> read_off_vertex(Text_cursor& cursor,
                                             const Off_header& header,
                                             std::size_t vertex)
{
  next_off_record(cursor, {"vertex", vertex}, header.number_of_vertices);
  const std::array<double, 3> point = read_point(cursor, vertex);
  if (skip_numbers(cursor, {"vertex", vertex}) > 0 && !header.has_vertex_attributes)
    cursor.fail(vertex_name(vertex) + " has more than 3 coordinates");
  return point;
}

inline std::size_t read_off_corner(Text_cursor& cursor, const Off_header& header, std::size_t face)
{
  const auto index = read_integer<long long>(cursor, {"face", face});
  if (index < 0 || static_cast<unsigned long long>(index) >= header.number_of_vertices)
    cursor.fail(index_range_message(face, std::to_string(index), header.number_of_vertices));
  return static_cast<std::size_t>(index);
}

inline std::array<std::size_t, 3> read_off_face(Text_cursor& cursor,
                                                const Off_header& header,
                                                std::size_t face)
{
  constexpr std::size_t maximal_number_of_color_values = 4;

  next_off_record(cursor, {"face", face}, header.number_of_faces);
  const auto number_of_corners = read_integer<long long>(cursor, {"face", face});
  if (number_of_corners != 3)
    fail_at_corner_count(cursor, face, std::to_string(number_of_corners));
  std::array<std::size_t, 3> triangle;
  for (std::size_t& corner : triangle)
    corner = read_off_corner(cursor, header, face);
  check_corners_differ(cursor, triangle, face);
  if (skip_numbers(cursor, {"face", face}) > maximal_number_of_color_values)
    cursor.fail(face_name(face) + ": more numbers than a triangle and its color take");
  return triangle;
}

inline Triangle_soup read_off(const std::string& file_name, std::string_view text)
{
  // "0 0 0" and "3 0 1 2", each with its end of line
  constexpr std::size_t shortest_vertex_record = 6;
  constexpr std::size_t shortest_face_record = 8;

  Text_cursor cursor(file_name, text, '#');
  const Off_header header = read_off_header(cursor);
  Triangle_soup soup;
  soup.points.reserve((std::min)(header.number_of_vertices, text.size() / shortest_vertex_record));
  soup.triangles.reserve((std::min)(header.number_of_faces, text.size() / shortest_face_record));
  for (std::size_t vertex = 0; vertex < header.number_of_vertices; ++vertex)
    soup.points.push_back(read_off_vertex(cursor, header, vertex));
  for (std::size_t face = 0; face < header.number_of_faces; ++face)
    soup.triangles.push_back(read_off_face(cursor, header, face));
  if (cursor.next_line())
    cursor.fail("extra data after the last face: the header claims only " +
                std::to_string(header.number_of_faces) + " faces");
  return soup;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_READ_OFF_H
