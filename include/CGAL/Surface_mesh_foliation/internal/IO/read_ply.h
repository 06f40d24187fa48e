// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_READ_PLY_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_READ_PLY_H

#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Triangle_soup.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/Text_cursor.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/mesh_file_records.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/parse_number.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/ply_header.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
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
  Ply_binary_source(std::string file_name, std::string_view data, Ply_format format)
    : m_file_name(std::move(file_name)), m_data(data), m_format(format)
  {}

  void begin_item(const Record&) {}

  double next_value(Ply_type type, const Record& record)
  {
    switch (type)
    {
    case Ply_type::INT8:
      return next<std::int8_t>(record);
    case Ply_type::UINT8:
      return next<std::uint8_t>(record);
    case Ply_type::INT16:
      return next<std::int16_t>(record);
    case Ply_type::UINT16:
      return next<std::uint16_t>(record);
    case Ply_type::INT32:
      return next<std::int32_t>(record);
    case Ply_type::UINT32:
      return next<std::uint32_t>(record);
    case Ply_type::FLOAT32:
      return next<float>(record);
    case Ply_type::FLOAT64:
      break;
    }
    return next<double>(record);
  }

  void end_item(const Record&) {}
  bool is_finished() const { return m_data.empty(); }
  std::string place() const { return m_file_name + ": "; }

private:
  static bool is_host_little_endian()
  {
    const std::uint16_t one = 1;
    unsigned char first_byte;
    std::memcpy(&first_byte, &one, 1);
    return first_byte == 1;
  }

  template <class Number>
  double next(const Record& record)
  {
    std::array<char, sizeof(Number)> bytes;
    if (m_data.size() < bytes.size())
      throw_file_problem(place(), "unexpected end of file in " + record.name());
    std::copy_n(m_data.begin(), bytes.size(), bytes.begin());
    m_data.remove_prefix(bytes.size());
    if ((m_format == Ply_format::BINARY_LITTLE_ENDIAN) != is_host_little_endian())
      std::reverse(bytes.begin(), bytes.end());
    Number number;
    std::memcpy(&number, bytes.data(), bytes.size());
    return static_cast<double>(number);
  }

  std::string m_file_name;
  std::string_view m_data; // the part that has not been read yet
  Ply_format m_format;
};

// reads the body of a PLY file from either source
template <class Source>
class Ply_body_reader
{
public:
  Ply_body_reader(Source& source, const Ply_header& header) : m_source(source), m_header(header) {}

  Triangle_soup read()
  {
    m_number_of_vertices = unique_element("vertex").count;
    unique_element("face");
    for (const Ply_element& element : m_header.elements)
      // items without properties take no space in the file, so their number means nothing
      for (std::size_t item = 0; item < element.count && !element.properties.empty(); ++item)
        read_item(element, item);
    if (!m_source.is_finished())
      throw_file_problem(m_source.place(), "extra data after the last element");
    return std::move(m_soup);
  }

private:
  const Ply_element& unique_element(std::string_view name) const
  {
    const Ply_element* result = nullptr;
    for (const Ply_element& element : m_header.elements)
      if (element.name == name)
      {
        if (result != nullptr)
          throw_file_problem(m_source.place(), "two PLY elements " + quoted(name));
        result = &element;
      }
    if (result == nullptr || result->properties.empty())
      throw_file_problem(m_source.place(), "no PLY element " + quoted(name) + " with properties");
    return *result;
  }

  void read_item(const Ply_element& element, std::size_t item)
  {
    const bool is_vertex = element.name == "vertex";
    const bool is_face = element.name == "face";
    const Record record{is_vertex ? "vertex" : is_face ? "face" : "item", item};
    m_source.begin_item(record);
    if (is_vertex)
      read_vertex(element, record);
    else if (is_face)
      read_face(element, record);
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
    m_soup.points.push_back(point);
  }

  double next_coordinate(Ply_type type, const Record& record)
  {
    const double coordinate = m_source.next_value(type, record);
    if (!std::isfinite(coordinate))
      throw Invalid_mesh_exception(problem(Problem_kind::NOT_FINITE, m_source.place(),
                                           record.name(), " has a coordinate that is not finite")
                                     .vertices({record.index}));
    return coordinate;
  }

  void read_face(const Ply_element& element, const Record& record)
  {
    bool has_corners = false;
    for (const Ply_property& property : element.properties)
    {
      const bool is_corners =
        property.length_type && !has_corners && is_integer(property.type) &&
        (property.name == "vertex_indices" || property.name == "vertex_index");
      has_corners = has_corners || is_corners;
      if (is_corners)
        read_corners(property, record);
      else
        skip_property(property, record);
    }
    if (!has_corners)
      throw_file_problem(m_source.place(), "the PLY element 'face' has no list vertex_indices");
  }

  void read_corners(const Ply_property& property, const Record& record)
  {
    const double length = next_length(property, record);
    if (length != 3)
      fail_at_corner_count(m_source, record.index, number_text(length));
    std::array<std::size_t, 3> triangle;
    for (std::size_t& corner : triangle)
    {
      const double index = m_source.next_value(property.type, record);
      if (index < 0 || index >= static_cast<double>(m_number_of_vertices))
        throw_file_problem(m_source.place(), index_range_message(record.index, number_text(index),
                                                                 m_number_of_vertices));
      corner = static_cast<std::size_t>(index);
    }
    check_corners_differ(m_source, triangle, record.index);
    m_soup.triangles.push_back(triangle);
  }

  static std::string number_text(double integer)
  {
    return std::to_string(static_cast<long long>(integer));
  }

  Source& m_source;
  const Ply_header& m_header;
  std::size_t m_number_of_vertices = 0;
  Triangle_soup m_soup;
};

inline Triangle_soup read_ply(const std::string& file_name, std::string_view text)
{
  Text_cursor cursor(file_name, text, Text_cursor::no_comments);
  const Ply_header header = read_ply_header(cursor);
  if (header.format == Ply_format::ASCII)
  {
    Ply_ascii_source source(cursor);
    return Ply_body_reader<Ply_ascii_source>(source, header).read();
  }
  Ply_binary_source source(file_name, cursor.remaining_text(), header.format);
  return Ply_body_reader<Ply_binary_source>(source, header).read();
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_READ_PLY_H
