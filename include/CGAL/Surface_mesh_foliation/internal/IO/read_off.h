// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_READ_OFF_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_READ_OFF_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/face_messages.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/Binary_cursor.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/Face_collectors.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/Text_cursor.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/mesh_file_records.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

// A strict reader of OFF. ASCII: one line per record, or numbers that follow one another in lines
// of any length; every number checked, nothing left over. Binary: as Geomview defines it.

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

struct Off_header
{
  std::string_view prefix; // what comes before OFF: ST, C and N announce data of vertices
  bool is_binary = false;
  std::size_t number_of_vertices = 0;
  std::size_t number_of_faces = 0;
};

inline bool is_off_prefix(std::string_view prefix)
{
  return prefix.empty() || prefix == "C" || prefix == "N" || prefix == "CN" || prefix == "ST" ||
         prefix == "STC" || prefix == "STN" || prefix == "STCN";
}

// What a file must begin with: the word, and what is glued to it, the number of vertices.
struct Off_magic
{
  std::string_view prefix;
  std::string_view number; // often empty
};

inline Off_magic read_off_magic(Text_cursor& cursor)
{
  constexpr std::string_view magic = "OFF";
  const std::string_view word = cursor.next_word();
  const std::size_t position = word.find(magic);
  if (position != std::string_view::npos && is_off_prefix(word.substr(0, position)))
  {
    const std::string_view rest = word.substr(position + magic.size());
    if (rest.find_first_not_of("0123456789") == std::string_view::npos)
      return {word.substr(0, position), rest};
  }
  cursor.fail("not an OFF file: it starts with " + quoted(word) + " instead of 'OFF'");
}

inline std::size_t parse_off_count(const Text_cursor& cursor,
                                   std::string_view word,
                                   const char* what)
{
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

inline std::size_t read_off_count(Text_cursor& cursor, const char* what)
{
  return parse_off_count(cursor, cursor.next_word(), what);
}

// A false claim is rejected before anything is read.
template <class Cursor>
void check_off_claim(const Cursor& cursor,
                     std::size_t count,
                     const char* what,
                     std::size_t remaining_bytes,
                     std::size_t bytes_per_record)
{
  if (count > remaining_bytes / bytes_per_record)
    cursor.fail("unexpected end of file: the header claims " + std::to_string(count) + " " + what +
                ", but only " + std::to_string(remaining_bytes) + " bytes follow");
}

inline Off_header read_off_header(Text_cursor& cursor)
{
  if (!cursor.next_line())
    cursor.fail("the file is empty");
  const Off_magic magic = read_off_magic(cursor);
  Off_header header;
  header.prefix = magic.prefix;
  if (magic.number.empty() && cursor.is_line_finished() && !cursor.next_line())
    cursor.fail("unexpected end of file: the numbers of vertices and faces are missing");

  std::string_view word = magic.number.empty() ? cursor.next_word() : magic.number;
  header.is_binary = word == "BINARY";
  if (header.is_binary)
    return header;
  header.number_of_vertices = parse_off_count(cursor, word, "vertices");
  header.number_of_faces = read_off_count(cursor, "faces");
  if (!cursor.is_line_finished())
    read_off_count(cursor, "edges"); // often wrong in practice, and not needed
  if (!cursor.is_line_finished())
    cursor.fail("more than three numbers in the header: " + quoted(cursor.next_word()));
  // A record takes at least two bytes, but the last one need not have an end of line.
  const std::size_t size = cursor.remaining_text().size() + 1;
  check_off_claim(cursor, header.number_of_vertices, "vertices", size, 2);
  check_off_claim(cursor, header.number_of_faces, "faces", size, 2);
  return header;
}

// ===  One line per record

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
  constexpr std::size_t maximal_number_of_vertex_attributes = 3 + 4 + 2;

  next_off_record(cursor, {"vertex", vertex}, header.number_of_vertices);
  const std::array<double, 3> point = read_point(cursor, vertex);
  const std::size_t number_of_others = skip_numbers(cursor, {"vertex", vertex});
  // Many programs do not announce what they write. One number more is none of that: it may be a
  // fourth coordinate.
  if (header.prefix.empty() && number_of_others == 1)
    cursor.fail(vertex_name(vertex) + " has more than 3 coordinates");
  if (header.prefix.empty() && number_of_others > maximal_number_of_vertex_attributes)
    cursor.fail(vertex_name(vertex) + " has more than 3 coordinates, a normal, a color and " +
                "texture coordinates: each vertex must have its own line");
  return point;
}

// In the next functions, `cursor` is one of either kind.

template <class Cursor>
std::size_t check_off_corner(const Cursor& cursor,
                             const Off_header& header,
                             std::size_t face,
                             long long index)
{
  if (index < 0 || static_cast<unsigned long long>(index) >= header.number_of_vertices)
    cursor.fail(index_range_message(face, std::to_string(index), header.number_of_vertices));
  return static_cast<std::size_t>(index);
}

inline long long next_off_integer(Text_cursor& cursor, const Record& record)
{
  return read_integer<long long>(cursor, record);
}
inline long long next_off_integer(Binary_cursor& cursor, const Record& record)
{
  return cursor.next<std::int32_t>(record);
}

// the number of corners, and the corners
template <class Collector, class Cursor>
void read_off_corners(Cursor& cursor, const Off_header& header, Collector& result)
{
  const std::size_t face = result.number_of_faces();
  const long long number_of_corners = next_off_integer(cursor, {"face", face});
  result.begin_face(cursor, number_of_corners);
  for (long long i = 0; i < number_of_corners; ++i)
    result.add_corner(
      check_off_corner(cursor, header, face, next_off_integer(cursor, {"face", face})));
  result.end_face(cursor);
}

template <class Collector>
void read_off_face(Text_cursor& cursor, const Off_header& header, Collector& result)
{
  constexpr std::size_t maximal_number_of_color_values = 4;

  const std::size_t face = result.number_of_faces();
  next_off_record(cursor, {"face", face}, header.number_of_faces);
  read_off_corners(cursor, header, result);
  if (skip_numbers(cursor, {"face", face}) > maximal_number_of_color_values)
    cursor.fail(face_name(face) + ": more numbers than its corners and its color take");
}

template <class Collector>
typename Collector::Soup read_lines_of_off(Text_cursor& cursor, const Off_header& header)
{
  // "0 0 0" and "3 0 1 2", each with its end of line
  constexpr std::size_t shortest_vertex_record = 6;
  constexpr std::size_t shortest_face_record = 8;

  const std::size_t size = cursor.remaining_text().size() + 1; // the last line may have no end
  Collector result;
  result.soup.points.reserve((std::min)(header.number_of_vertices, size / shortest_vertex_record));
  result.reserve_faces((std::min)(header.number_of_faces, size / shortest_face_record));
  for (std::size_t vertex = 0; vertex < header.number_of_vertices; ++vertex)
    result.soup.points.push_back(read_off_vertex(cursor, header, vertex));
  for (std::size_t face = 0; face < header.number_of_faces; ++face)
    read_off_face(cursor, header, result);
  if (cursor.next_line())
    cursor.fail("extra data after the last face: the header claims only " +
                std::to_string(header.number_of_faces) + " faces");
  return std::move(result.soup);
}

// ===  Lines of any length

inline std::size_t number_of_remaining_lines(Text_cursor cursor)
{
  std::size_t result = 0;
  while (cursor.next_line())
    ++result;
  return result;
}

inline std::size_t number_of_remaining_words(Text_cursor cursor)
{
  std::size_t result = 0;
  while (cursor.next_line())
    for (; !cursor.is_line_finished(); ++result)
      cursor.next_word();
  return result;
}

// Whether the lines are no records, but the numbers are exactly those of vertices and triangles
// without anything else, so that there is no doubt about which is which.
inline bool is_off_without_records(const Text_cursor& cursor, const Off_header& header)
{
  const std::size_t vertices = header.number_of_vertices, faces = header.number_of_faces;
  return header.prefix.empty() && number_of_remaining_lines(cursor) != vertices + faces &&
         number_of_remaining_words(cursor) == 3 * vertices + 4 * faces;
}

template <class Collector>
typename Collector::Soup read_off_without_records(Text_cursor& cursor, const Off_header& header)
{
  cursor.join_lines();
  cursor.next_line();
  Collector result;
  result.soup.points.reserve(header.number_of_vertices); // The words have been counted.
  result.reserve_faces(header.number_of_faces);
  for (std::size_t vertex = 0; vertex < header.number_of_vertices; ++vertex)
    result.soup.points.push_back(read_point(cursor, vertex));
  for (std::size_t face = 0; face < header.number_of_faces; ++face)
    read_off_corners(cursor, header, result);
  return std::move(result.soup);
}

// ===  Binary: integers and floats of 32 bits, the most significant byte first

inline std::size_t read_binary_off_count(Binary_cursor& cursor, const char* what)
{
  const auto count = cursor.next<std::int32_t>({"header", 0});
  if (count < 0)
    cursor.fail(std::string("the number of ") + what + ", " + std::to_string(count) +
                ", is negative");
  return static_cast<std::size_t>(count);
}

// the size of what follows the coordinates of a vertex. A color has four numbers in Geomview, and
// three in CGAL; then the first face, which begins with its number of corners, tells.
inline std::size_t size_of_off_attributes(const Binary_cursor& cursor, const Off_header& header)
{
  constexpr std::size_t number_size = sizeof(float);

  const auto has = [&](std::string_view letters) {
    return header.prefix.find(letters) != std::string_view::npos;
  };
  const std::size_t size = number_size * ((has("N") ? 3 : 0) + (has("ST") ? 2 : 0));
  if (!has("C"))
    return size;
  const auto first_face_is_triangle = [&](std::size_t number_of_colors) {
    const std::size_t vertex_size = 3 * number_size + size + number_of_colors * number_size;
    Binary_cursor copy = cursor;
    const std::size_t vertices_size = header.number_of_vertices * vertex_size;
    if (copy.remaining_data().size() < vertices_size + sizeof(std::int32_t))
      return false;
    copy.skip(vertices_size, {"vertex", 0});
    return copy.next<std::int32_t>({"face", 0}) == 3;
  };
  const bool has_short_colors = first_face_is_triangle(3) && !first_face_is_triangle(4);
  return size + number_size * (has_short_colors ? 3 : 4);
}

inline void skip_binary_off_color(Binary_cursor& cursor, std::size_t face)
{
  const auto number_of_values = cursor.next<std::int32_t>({"face", face});
  if (number_of_values < 0 || number_of_values > 4)
    cursor.fail(face_name(face) + ": a color of " + std::to_string(number_of_values) + " numbers");
  cursor.skip(sizeof(float) * static_cast<std::size_t>(number_of_values), {"face", face});
}

template <class Collector>
typename Collector::Soup read_binary_off(Binary_cursor cursor, Off_header header)
{
  constexpr std::size_t shortest_vertex_record = 3 * sizeof(float);
  constexpr std::size_t shortest_face_record = 5 * sizeof(std::int32_t);

  header.number_of_vertices = read_binary_off_count(cursor, "vertices");
  header.number_of_faces = read_binary_off_count(cursor, "faces");
  read_binary_off_count(cursor, "edges"); // not needed
  const std::size_t remaining_bytes = cursor.remaining_data().size();
  check_off_claim(cursor, header.number_of_vertices, "vertices", remaining_bytes,
                  shortest_vertex_record);
  Collector result;
  result.soup.points.reserve(header.number_of_vertices);
  result.reserve_faces((std::min)(header.number_of_faces, remaining_bytes / shortest_face_record));
  const std::size_t size_of_attributes = size_of_off_attributes(cursor, header);
  for (std::size_t vertex = 0; vertex < header.number_of_vertices; ++vertex)
  {
    result.soup.points.push_back(read_float_point(cursor, vertex));
    cursor.skip(size_of_attributes, {"vertex", vertex});
  }
  for (std::size_t face = 0; face < header.number_of_faces; ++face)
  {
    read_off_corners(cursor, header, result);
    skip_binary_off_color(cursor, face);
  }
  // CGAL ends the file with an end of line.
  if (cursor.remaining_data().find_first_not_of(" \t\r\n") != std::string_view::npos)
    cursor.fail("extra data after the last face: the header claims only " +
                std::to_string(header.number_of_faces) + " faces");
  return std::move(result.soup);
}

// ===  All of them

template <class Collector = Triangle_collector>
typename Collector::Soup read_off(const std::string& file_name, std::string_view text)
{
  Text_cursor cursor(file_name, text, '#');
  const Off_header header = read_off_header(cursor);
  if (header.is_binary)
    return read_binary_off<Collector>(
      Binary_cursor(file_name, cursor.remaining_text(), text.size(), Byte_order::BIG), header);
  if (is_off_without_records(cursor, header))
    return read_off_without_records<Collector>(cursor, header);
  return read_lines_of_off<Collector>(cursor, header);
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_READ_OFF_H
