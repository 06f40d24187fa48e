// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_READ_STL_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_READ_STL_H

#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/face_messages.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/Binary_cursor.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/Face_collectors.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/Text_cursor.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/mesh_file_records.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <unordered_map>
#include <utility>

// A strict reader of STL, ASCII and binary. The format repeats the coordinates of a vertex in each
// of its faces: corners at equal positions are the same vertex. Normals say nothing that the
// corners do not say, and are often missing or not even numbers, so they are skipped unseen.

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

struct Hash_of_point
{
  // Equal numbers have equal hashes, also 0 and -0.
  std::size_t operator()(const std::array<double, 3>& point) const
  {
    std::size_t result = 0;
    for (const double coordinate : point)
      result = 1000003 * result + std::hash<double>()(coordinate);
    return result;
  }
};

// numbers vertices in the order in which they are met first
template <class Collector>
class Welded_collector
{
public:
  std::size_t number_of_vertices() const { return m_result.soup.points.size(); }
  std::size_t number_of_faces() const { return m_result.number_of_faces(); }

  std::size_t vertex_at(const std::array<double, 3>& point)
  {
    const auto [found, is_new] = m_vertex_at.emplace(point, number_of_vertices());
    if (is_new)
      m_result.soup.points.push_back(point);
    return found->second;
  }

  // `source` serves only to tell the place in the file
  template <class Source>
  void add_triangle(const Source& source, const std::array<std::size_t, 3>& triangle)
  {
    const std::optional<std::size_t> vertex = repeated_vertex(triangle);
    if (vertex && std::is_same_v<Collector, Triangle_collector>)
      throw Invalid_mesh_exception(problem(Problem_kind::DEGENERATE_FACE, source.place(),
                                           face_name(number_of_faces()),
                                           " is degenerate: two of its corners have the position"
                                           " of ",
                                           vertex_name(*vertex))
                                     .vertices({*vertex})
                                     .faces({number_of_faces()}));
    for (const std::size_t corner : triangle)
      m_result.add_corner(corner);
    m_result.end_face(source);
  }

  typename Collector::Soup take() { return std::move(m_result.soup); }

private:
  Collector m_result;
  std::unordered_map<std::array<double, 3>, std::size_t, Hash_of_point> m_vertex_at;
};

// ===  Binary: 80 bytes of any content, the number of faces, and 50 bytes for each face

constexpr std::size_t stl_comment_size = 80;
constexpr std::size_t stl_header_size = stl_comment_size + sizeof(std::uint32_t);
constexpr std::size_t stl_vector_size = 3 * sizeof(float);
constexpr std::size_t stl_attribute_size = sizeof(std::uint16_t);
constexpr std::size_t stl_face_size = 4 * stl_vector_size + stl_attribute_size;

// as the header claims; `text` has at least the size of a header
inline std::uint32_t number_of_binary_stl_faces(const std::string& file_name, std::string_view text)
{
  Binary_cursor cursor(file_name, text.substr(stl_comment_size), text.size(), Byte_order::LITTLE);
  return cursor.next<std::uint32_t>({"header", 0});
}

inline std::uint64_t size_of_binary_stl(std::uint32_t number_of_faces)
{
  return stl_header_size + stl_face_size * std::uint64_t(number_of_faces);
}

template <class Collector>
typename Collector::Soup read_binary_stl(const std::string& file_name, std::string_view text)
{
  Binary_cursor cursor(file_name, text.substr(stl_header_size), text.size(), Byte_order::LITTLE);
  Welded_collector<Collector> soup;
  while (!cursor.remaining_data().empty())
  {
    const Record record{"face", soup.number_of_faces()};
    cursor.skip(stl_vector_size, record);
    std::array<std::size_t, 3> triangle;
    for (std::size_t& corner : triangle)
      corner = soup.vertex_at(read_float_point(cursor, soup.number_of_vertices()));
    soup.add_triangle(cursor, triangle);
    cursor.skip(stl_attribute_size, record);
  }
  return soup.take();
}

// ===  ASCII

// Some programs write keywords in upper case.
inline bool is_stl_keyword(std::string_view word, std::string_view keyword)
{
  return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(),
                    [](char a, char b) { return a == b || a == b - 'a' + 'A'; });
}

template <class Collector>
class Ascii_stl_reader
{
public:
  Ascii_stl_reader(const std::string& file_name, std::string_view text)
    : m_cursor(file_name, text, Text_cursor::no_comments)
  {}

  // One solid after the other; all of them are one mesh.
  typename Collector::Soup read()
  {
    while (m_cursor.next_line())
    {
      expect_words({"solid"}); // its name follows
      read_solid();
    }
    return m_soup.take();
  }

private:
  void read_solid()
  {
    while (true)
    {
      if (!m_cursor.next_line())
        m_cursor.fail("unexpected end of file: 'endsolid' is missing");
      const std::string_view word = m_cursor.next_word();
      if (is_stl_keyword(word, "endsolid"))
        return; // its name follows
      if (!is_stl_keyword(word, "facet"))
        m_cursor.fail(quoted(word) + " instead of 'facet' or 'endsolid'");
      read_facet();
    }
  }

  void read_facet()
  {
    // the rest of the line is the normal
    expect_line({"outer", "loop"});
    std::array<std::size_t, 3> triangle = {};
    for (std::size_t number_of_corners = 0;; ++number_of_corners)
    {
      next_line();
      const std::string_view word = m_cursor.next_word();
      const bool is_loop_finished = is_stl_keyword(word, "endloop");
      if (is_loop_finished ? number_of_corners != 3 : number_of_corners == 3)
        fail_at_number_of_corners(m_cursor, m_soup.number_of_faces(),
                                  is_loop_finished ? std::to_string(number_of_corners)
                                                   : "more than 3");
      if (is_loop_finished)
        break;
      if (!is_stl_keyword(word, "vertex"))
        m_cursor.fail(quoted(word) + " instead of 'vertex' or 'endloop' in " + record().name());
      triangle[number_of_corners] =
        m_soup.vertex_at(read_point(m_cursor, m_soup.number_of_vertices()));
      expect_line_end();
    }
    m_soup.add_triangle(m_cursor, triangle);
    expect_line_end();
    expect_line({"endfacet"});
  }

  Record record() const { return {"face", m_soup.number_of_faces()}; }

  void next_line()
  {
    if (!m_cursor.next_line())
      m_cursor.fail("unexpected end of file in " + record().name());
  }

  void expect_words(std::initializer_list<std::string_view> words)
  {
    for (const std::string_view expected : words)
    {
      const std::string_view word = m_cursor.next_word();
      if (!is_stl_keyword(word, expected))
        m_cursor.fail(quoted(word) + " instead of " + quoted(expected));
    }
  }

  void expect_line(std::initializer_list<std::string_view> words)
  {
    next_line();
    expect_words(words);
    expect_line_end();
  }

  void expect_line_end()
  {
    if (!m_cursor.is_line_finished())
      m_cursor.fail("more than expected on the line: " + quoted(m_cursor.next_word()));
  }

  Text_cursor m_cursor;
  Welded_collector<Collector> m_soup;
};

// ===  Which of the two

// whether a text that is no complete binary file is meant to be an ASCII file. Binary files may
// begin with "solid", too, but then have a NUL character in the header: the number of faces ends
// with one.
inline bool is_ascii_stl(const std::string& file_name, std::string_view text)
{
  Text_cursor cursor(file_name, text, Text_cursor::no_comments);
  return cursor.next_line() && is_stl_keyword(cursor.next_word(), "solid") &&
         text.substr(0, stl_header_size).find('\0') == std::string_view::npos;
}

template <class Collector = Triangle_collector>
typename Collector::Soup read_stl(const std::string& file_name, std::string_view text)
{
  const bool has_header = text.size() >= stl_header_size;
  const std::uint32_t claim = has_header ? number_of_binary_stl_faces(file_name, text) : 0;
  if (has_header && size_of_binary_stl(claim) == text.size())
    return read_binary_stl<Collector>(file_name, text);
  if (is_ascii_stl(file_name, text))
    return Ascii_stl_reader<Collector>(file_name, text).read();
  if (!has_header)
    throw_file_problem(file_name, ": not an STL file: it does not begin with 'solid', and is "
                                  "too short for a binary file");
  throw_file_problem(file_name, ": not an STL file, or damaged: a binary file of " +
                                  std::to_string(claim) + " faces, as the header claims, has " +
                                  std::to_string(size_of_binary_stl(claim)) +
                                  " bytes, but this one has " + std::to_string(text.size()));
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_READ_STL_H
