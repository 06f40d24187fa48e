// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_PLY_HEADER_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_PLY_HEADER_H

#include <CGAL/Surface_mesh_foliation/internal/IO/Text_cursor.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/parse_number.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

enum class Ply_type { INT8, UINT8, INT16, UINT16, INT32, UINT32, FLOAT32, FLOAT64 };

inline bool is_integer(Ply_type type)
{
  return type != Ply_type::FLOAT32 && type != Ply_type::FLOAT64;
}

enum class Ply_format { ASCII, BINARY_LITTLE_ENDIAN, BINARY_BIG_ENDIAN };

// names point into the text of the file
struct Ply_property
{
  std::string_view name;
  Ply_type type;
  std::optional<Ply_type> length_type; // only for lists
};

struct Ply_element
{
  std::string_view name;
  std::size_t count;
  std::vector<Ply_property> properties;
};

struct Ply_header
{
  Ply_format format;
  std::vector<Ply_element> elements;
};

inline Ply_type read_ply_type(Text_cursor& cursor)
{
  using Name_and_type = std::pair<std::string_view, Ply_type>;
  static constexpr std::array<Name_and_type, 16> types = {{{"char", Ply_type::INT8},
                                                           {"int8", Ply_type::INT8},
                                                           {"uchar", Ply_type::UINT8},
                                                           {"uint8", Ply_type::UINT8},
                                                           {"short", Ply_type::INT16},
                                                           {"int16", Ply_type::INT16},
                                                           {"ushort", Ply_type::UINT16},
                                                           {"uint16", Ply_type::UINT16},
                                                           {"int", Ply_type::INT32},
                                                           {"int32", Ply_type::INT32},
                                                           {"uint", Ply_type::UINT32},
                                                           {"uint32", Ply_type::UINT32},
                                                           {"float", Ply_type::FLOAT32},
                                                           {"float32", Ply_type::FLOAT32},
                                                           {"double", Ply_type::FLOAT64},
                                                           {"float64", Ply_type::FLOAT64}}};

  const std::string_view word = cursor.next_word();
  const auto found = std::find_if(types.begin(), types.end(),
                                  [&](const Name_and_type& entry) { return entry.first == word; });
  if (found == types.end())
    cursor.fail(quoted(word) + " is not a PLY type");
  return found->second;
}

inline Ply_format read_ply_format(Text_cursor& cursor)
{
  if (!cursor.next_line() || cursor.next_word() != "format")
    cursor.fail("the PLY format line is missing");
  const std::string_view word = cursor.next_word();
  if (word == "ascii")
    return Ply_format::ASCII;
  if (word == "binary_little_endian")
    return Ply_format::BINARY_LITTLE_ENDIAN;
  if (word == "binary_big_endian")
    return Ply_format::BINARY_BIG_ENDIAN;
  cursor.fail(quoted(word) + " is not a PLY format");
}

inline Ply_element read_ply_element(Text_cursor& cursor)
{
  Ply_element element{cursor.next_word(), 0, {}};
  const std::string_view word = cursor.next_word();
  if (parse_number(word, element.count) != Parse_status::OK)
    cursor.fail("element " + quoted(element.name) + ": " + quoted(word) + " is not a valid count");
  return element;
}

inline Ply_property read_ply_property(Text_cursor& cursor)
{
  Ply_property property;
  Text_cursor after_list = cursor;
  if (after_list.next_word() == "list")
  {
    cursor = after_list;
    property.length_type = read_ply_type(cursor);
    if (!is_integer(*property.length_type))
      cursor.fail("the length of a list is not an integer");
  }
  property.type = read_ply_type(cursor);
  property.name = cursor.next_word();
  return property;
}

inline Ply_header read_ply_header(Text_cursor& cursor)
{
  if (!cursor.next_line() || cursor.next_word() != "ply")
    cursor.fail("not a PLY file: it does not start with 'ply'");
  Ply_header header{read_ply_format(cursor), {}};
  while (cursor.next_line())
  {
    const std::string_view keyword = cursor.next_word();
    if (keyword == "end_header")
      return header;
    if (keyword == "element")
      header.elements.push_back(read_ply_element(cursor));
    else if (keyword == "property" && !header.elements.empty())
      header.elements.back().properties.push_back(read_ply_property(cursor));
    else if (keyword != "comment" && keyword != "obj_info")
      cursor.fail("unexpected PLY statement " + quoted(keyword));
  }
  cursor.fail("unexpected end of file: the PLY header does not end");
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_PLY_HEADER_H
