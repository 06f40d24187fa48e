// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_READ_PLY_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_READ_PLY_H

#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/face_messages.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/Binary_cursor.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/Face_collectors.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/Text_cursor.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/mesh_file_records.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/parse_number.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/ply_header.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// A strict reader of PLY, ASCII and binary. Every value of a PLY file fits a double exactly.

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// the values of an ASCII file: one line per item
class Ply_ascii_source
{
public:
  explicit Ply_ascii_source(Text_cursor& cursor) : m_cursor(cursor) {}

  void begin_item(const Record& record)
  {
    if (!m_cursor.next_line())
      m_cursor.fail("unexpected end of file: " + record.name() + " is missing");
  }

  double next_value(Ply_type type, const Record& record)
  {
    if (is_integer(type))
      return static_cast<double>(read_integer<std::int64_t>(m_cursor, record));
    const std::string_view word = m_cursor.next_word();
    double value = 0;
    if (word.empty())
      fail_at_line_end(m_cursor, record);
    if (parse_number(word, value) != Parse_status::OK)
      m_cursor.fail(record.name() + ": " + quoted(word) + " is not a number that fits a double");
    return value;
  }

  void end_item(const Record& record)
  {
    if (!m_cursor.is_line_finished())
      m_cursor.fail(record.name() + ": more values than the header says");
  }

  bool is_finished() { return !m_cursor.next_line(); }
  std::string place() const { return m_cursor.place(); }

private:
  Text_cursor& m_cursor;
};

// the values of a binary file: bytes that follow one another
class Ply_binary_source
{
public:
  explicit Ply_binary_source(const Binary_cursor& cursor) : m_cursor(cursor) {}

  void begin_item(const Record&) {}

  double next_value(Ply_type type, const Record& record)
  {
    switch (type)
    {
    case Ply_type::INT8:
      return m_cursor.next<std::int8_t>(record);
    case Ply_type::UINT8:
      return m_cursor.next<std::uint8_t>(record);
    case Ply_type::INT16:
      return m_cursor.next<std::int16_t>(record);
    case Ply_type::UINT16:
      return m_cursor.next<std::uint16_t>(record);
    case Ply_type::INT32:
      return m_cursor.next<std::int32_t>(record);
    case Ply_type::UINT32:
      return m_cursor.next<std::uint32_t>(record);
    case Ply_type::FLOAT32:
      return static_cast<double>(m_cursor.next<float>(record));
    case Ply_type::FLOAT64:
      break;
    }
    return m_cursor.next<double>(record);
  }

  void end_item(const Record&) {}
  bool is_finished() const { return m_cursor.remaining_data().empty(); }
  std::string place() const { return m_cursor.place(); }

private:
  Binary_cursor m_cursor;
};

// reads the body of a PLY file from either source
template <class Collector, class Source>
class Ply_body_reader
{
public:
  Ply_body_reader(Source& source, const Ply_header& header) : m_source(source), m_header(header) {}

  typename Collector::Soup read()
  {
    m_number_of_vertices = required_element("vertex").count;
    const Ply_element* const faces = unique_element("face");
    m_strips = faces == nullptr || faces->count == 0 ? unique_element("tristrips") : nullptr;
    required_element(m_strips == nullptr ? "face" : "tristrips");
    for (const Ply_element& element : m_header.elements)
      // items without properties take no space in the file, so their number means nothing
      for (std::size_t item = 0; item < element.count && !element.properties.empty(); ++item)
        read_item(element, item);
    if (!m_source.is_finished())
      throw_file_problem(m_source.place(), "extra data after the last element");
    return std::move(m_result.soup);
  }

private:
  // null if there is none
  const Ply_element* unique_element(std::string_view name) const
  {
    const Ply_element* result = nullptr;
    for (const Ply_element& element : m_header.elements)
      if (element.name == name)
      {
        if (result != nullptr)
          throw_file_problem(m_source.place(), "two PLY elements " + quoted(name));
        result = &element;
      }
    return result;
  }

  const Ply_element& required_element(std::string_view name) const
  {
    const Ply_element* const result = unique_element(name);
    if (result == nullptr || result->properties.empty())
      throw_file_problem(m_source.place(), "no PLY element " + quoted(name) + " with properties");
    return *result;
  }

  void read_item(const Ply_element& element, std::size_t item)
  {
    const bool is_vertex = element.name == "vertex";
    const bool is_face = element.name == "face";
    const bool is_strips = &element == m_strips;
    const Record record{is_vertex   ? "vertex"
                        : is_face   ? "face"
                        : is_strips ? "item of tristrips"
                                    : "item",
                        item};
    m_source.begin_item(record);
    if (is_vertex)
      read_vertex(element, record);
    else if (is_face || is_strips)
      read_faces(element, record);
    else
      for (const Ply_property& property : element.properties)
        skip_property(property, record);
    m_source.end_item(record);
  }

  void skip_property(const Ply_property& property, const Record& record)
  {
    const double length = property.length_type ? next_length(property, record) : 1;
    for (double i = 0; i < length; ++i)
      m_source.next_value(property.type, record);
  }

  double next_length(const Ply_property& property, const Record& record)
  {
    const double length = m_source.next_value(*property.length_type, record);
    if (length < 0)
      throw_file_problem(m_source.place(), record.name() + ": a list of negative length");
    return length;
  }

  void read_vertex(const Ply_element& element, const Record& record)
  {
    std::array<double, 3> point = {};
    std::array<bool, 3> is_given = {};
    for (const Ply_property& property : element.properties)
    {
      const std::size_t axis = std::string_view("xyz").find(property.name);
      if (property.length_type || property.name.size() != 1 || axis == std::string_view::npos)
        skip_property(property, record);
      else
      {
        point[axis] = next_coordinate(property.type, record);
        is_given[axis] = true;
      }
    }
    if (std::count(is_given.begin(), is_given.end(), true) != 3)
      throw_file_problem(m_source.place(), "the PLY element 'vertex' has no x, y or z");
    m_result.soup.points.push_back(point);
  }

  double next_coordinate(Ply_type type, const Record& record)
  {
    const double coordinate = m_source.next_value(type, record);
    check_coordinate_is_finite(m_source, coordinate, record.index);
    return coordinate;
  }

  // the face, or the triangles of strips
  void read_faces(const Ply_element& element, const Record& record)
  {
    bool has_corners = false;
    for (const Ply_property& property : element.properties)
    {
      const bool is_corners =
        property.length_type && !has_corners && is_integer(property.type) &&
        (property.name == "vertex_indices" || property.name == "vertex_index");
      has_corners = has_corners || is_corners;
      if (!is_corners)
        skip_property(property, record);
      else if (&element == m_strips)
        read_strips(property, record);
      else
        read_corners(property, record);
    }
    if (!has_corners)
      throw_file_problem(m_source.place(),
                         "the PLY element " + quoted(element.name) + " has no list vertex_indices");
  }

  void read_corners(const Ply_property& property, const Record& record)
  {
    const double length = next_length(property, record);
    m_result.begin_face(m_source, length);
    for (double i = 0; i < length; ++i)
      m_result.add_corner(vertex_of_face(m_source.next_value(property.type, record), record.index));
    m_result.end_face(m_source);
  }

  // Each vertex of a strip but the first two makes a triangle with the two before it, and every
  // second triangle is turned over. -1 ends a strip. Triangles with two equal vertices are no
  // faces: they are there to change the direction of a strip, or to join two strips.
  void read_strips(const Ply_property& property, const Record& record)
  {
    std::array<std::size_t, 2> previous = {};
    std::size_t size_of_strip = 0;
    const auto end_strip = [&] {
      if (size_of_strip == 1 || size_of_strip == 2)
        throw_file_problem(m_source.place(), record.name() + ": a strip of less than 3 vertices");
      size_of_strip = 0;
    };
    const double length = next_length(property, record);
    for (double i = 0; i < length; ++i)
    {
      const double index = m_source.next_value(property.type, record);
      if (index == -1)
      {
        end_strip();
        continue;
      }
      const std::size_t vertex = vertex_of_face(index, m_result.number_of_faces());
      const std::array<std::size_t, 3> triangle =
        size_of_strip % 2 == 0 ? std::array<std::size_t, 3>{previous[0], previous[1], vertex}
                               : std::array<std::size_t, 3>{previous[1], previous[0], vertex};
      if (size_of_strip >= 2 && !repeated_vertex(triangle))
        add_triangle(triangle);
      previous = {previous[1], vertex};
      ++size_of_strip;
    }
    end_strip();
  }

  void add_triangle(const std::array<std::size_t, 3>& triangle)
  {
    for (const std::size_t vertex : triangle)
      m_result.add_corner(vertex);
    m_result.end_face(m_source);
  }

  std::size_t vertex_of_face(double index, std::size_t face) const
  {
    if (index < 0 || index >= static_cast<double>(m_number_of_vertices))
      throw_file_problem(m_source.place(),
                         index_range_message(face, number_text(index), m_number_of_vertices));
    return static_cast<std::size_t>(index);
  }

  static std::string number_text(double integer)
  {
    return std::to_string(static_cast<long long>(integer));
  }

  Source& m_source;
  const Ply_header& m_header;
  std::size_t m_number_of_vertices = 0;
  const Ply_element* m_strips = nullptr; // if they are there instead of faces
  Collector m_result;
};

template <class Collector = Triangle_collector>
typename Collector::Soup read_ply(const std::string& file_name, std::string_view text)
{
  Text_cursor cursor(file_name, text, Text_cursor::no_comments);
  const Ply_header header = read_ply_header(cursor);
  if (header.format == Ply_format::ASCII)
  {
    Ply_ascii_source source(cursor);
    return Ply_body_reader<Collector, Ply_ascii_source>(source, header).read();
  }
  const Byte_order byte_order =
    header.format == Ply_format::BINARY_LITTLE_ENDIAN ? Byte_order::LITTLE : Byte_order::BIG;
  Ply_binary_source source(
    Binary_cursor(file_name, cursor.remaining_text(), text.size(), byte_order));
  return Ply_body_reader<Collector, Ply_binary_source>(source, header).read();
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_READ_PLY_H
