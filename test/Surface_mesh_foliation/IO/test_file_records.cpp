// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The records of mesh files, read one by one from texts.

#include "include/big_and_little_endian.h"

#include <CGAL/Surface_mesh_foliation/internal/IO/Binary_cursor.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/Face_collectors.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/Text_cursor.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/mesh_file_records.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/ply_header.h>

#include "include/tetrahedron_files.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace test_file_records {

using namespace CGAL::Surface_mesh_foliation::internal;
namespace SMF = CGAL::Surface_mesh_foliation;
using SMF::Problem_kind;

namespace {

// at the first line of a text
Text_cursor cursor_at(std::string_view text)
{
  Text_cursor result("f", text, '#');
  EXPECT_TRUE(result.next_line());
  return result;
}

// what a function says is wrong, or nothing
template <class Function>
std::string complaint(const Function& function)
{
  try
  {
    function();
  }
  catch (const SMF::Foliation_exception& exception)
  {
    return exception.what();
  }
  return {};
}

} // namespace

// ===  mesh_file_records.h

TEST(Read_integer, takes_one_word_after_the_other)
{
  Text_cursor cursor = cursor_at("7 -8 9223372036854775807");
  const Record record{"face", 3};
  EXPECT_EQ(read_integer<int>(cursor, record), 7);
  EXPECT_EQ(read_integer<int>(cursor, record), -8);
  EXPECT_EQ(read_integer<std::int64_t>(cursor, record), 9223372036854775807);
  EXPECT_TRUE(cursor.is_line_finished());
}

TEST(Read_integer, complains_about_the_record)
{
  const auto complaint_about = [](std::string_view text) {
    return complaint([&] {
      Text_cursor cursor = cursor_at(text);
      cursor.next_word();
      read_integer<int>(cursor, {"face", 3});
    });
  };
  EXPECT_EQ(complaint_about("a 1.5"), "f:1: face 3: '1.5' is not an integer");
  EXPECT_EQ(complaint_about("a 4294967296"), "f:1: face 3: '4294967296' is out of range");
  EXPECT_EQ(complaint_about("a\nb"), "f:1: face 3: the line ends too early");
  EXPECT_EQ(complaint_about("a"), "f:1: unexpected end of file in face 3");
  EXPECT_EQ(complaint_about("a 1"), "");
}

TEST(Read_point, takes_three_finite_numbers)
{
  Text_cursor cursor = cursor_at("1 -2.5 1e-320 4");
  EXPECT_EQ(read_point(cursor, 0), (std::array<double, 3>{1, -2.5, 1e-320}));
  EXPECT_EQ(cursor.next_word(), "4");
  for (const char* text : {"0 inf 0", "0 nan 0", "0 1e999 0"})
  {
    Text_cursor bad = cursor_at(text);
    try
    {
      read_point(bad, 5);
      ADD_FAILURE() << text << " was accepted";
    }
    catch (const SMF::Invalid_mesh_exception& exception)
    {
      EXPECT_EQ(exception.problem().kind, Problem_kind::NOT_FINITE);
      EXPECT_EQ(exception.problem().vertices, std::vector<std::size_t>{5});
    }
  }
  Text_cursor bad = cursor_at("0 x 0");
  EXPECT_THROW(read_point(bad, 5), SMF::Invalid_file_exception);
}

TEST(Skip_numbers, counts_the_rest_of_the_line)
{
  Text_cursor cursor = cursor_at("a 1 2.5 1e999\nb\nc 1 x");
  cursor.next_word();
  EXPECT_EQ(skip_numbers(cursor, {"vertex", 0}), 3u); // what does not fit a double is a number, too
  EXPECT_EQ(skip_numbers(cursor, {"vertex", 0}), 0u);
  ASSERT_TRUE(cursor.next_line());
  cursor.next_word();
  EXPECT_EQ(skip_numbers(cursor, {"vertex", 0}), 0u);
  ASSERT_TRUE(cursor.next_line());
  cursor.next_word();
  EXPECT_EQ(complaint([&] {
              skip_numbers(cursor, {"vertex", 2});
            }),
            "f:3: vertex 2: 'x' is not a number");
}

TEST(Repeated_vertex, is_found_at_all_pairs_of_corners)
{
  EXPECT_FALSE(repeated_vertex({1, 2, 3}));
  EXPECT_EQ(repeated_vertex({1, 1, 3}), 1u);
  EXPECT_EQ(repeated_vertex({1, 2, 1}), 1u);
  EXPECT_EQ(repeated_vertex({1, 2, 2}), 2u);
  EXPECT_EQ(repeated_vertex({0, 0, 0}), 0u);
}

// ===  Face_collectors.h

template <class Collector>
void collect(Collector& collector, const std::vector<std::size_t>& corners)
{
  const Text_cursor cursor = cursor_at("a");
  for (const std::size_t corner : corners)
    collector.add_corner(corner);
  collector.end_face(cursor);
}

TEST(Triangle_collector, refuses_what_is_no_triangle)
{
  SMF::internal::Triangle_collector collector;
  collect(collector, {1, 2, 3});
  EXPECT_EQ(complaint([&] {
              collect(collector, {1, 2, 2});
            }),
            "f:1: face 1 uses vertex 2 more than once");
  EXPECT_EQ(complaint([&] {
              collect(collector, {1, 2, 3, 4});
            }),
            "f:1: face 1 has 4 corners, and only triangles are allowed");
  EXPECT_EQ(complaint([&] { collect(collector, {}); }),
            "f:1: face 1 has 0 corners, and only triangles are allowed");
  EXPECT_EQ(complaint([&] { collector.begin_face(cursor_at("a"), 1e9); }),
            "f:1: face 1 has 1000000000 corners, and only triangles are allowed");
  EXPECT_NO_THROW(collector.begin_face(cursor_at("a"), 3));
  collect(collector, {4, 2, 3});
  EXPECT_EQ(collector.number_of_faces(), 2u);
  EXPECT_EQ(collector.soup.triangles.back(), (std::array<std::size_t, 3>{4, 2, 3}));
}

TEST(Polygon_collector, takes_faces_of_any_kind)
{
  SMF::internal::Polygon_collector collector;
  for (const std::vector<std::size_t>& face :
       {std::vector<std::size_t>{1, 2, 2}, {1, 2, 3, 4}, {}, {5, 6, 7}})
  {
    collector.begin_face(cursor_at("a"), face.size());
    collect(collector, face);
    EXPECT_EQ(collector.faces().back(), face);
  }
  EXPECT_EQ(collector.number_of_faces(), 4u);
  EXPECT_EQ(complaint([&] { collector.begin_face(cursor_at("a"), -1); }),
            "f:1: face 4: the number of its corners is negative");
}

TEST(Index_range_message, knows_meshes_without_vertices)
{
  EXPECT_EQ(index_range_message(1, "4", 4),
            "face 1 uses vertex 4, but there are only the vertices 0 to 3");
  EXPECT_EQ(index_range_message(1, "4", 0), "face 1 uses vertex 4, but there are no vertices");
}

// ===  Text_cursor.h

TEST(Text_cursor_lines, goes_on_after_a_continuation_character)
{
  Text_cursor cursor("f", "a \\\n b\\\n\nc # \\\nd", '#', '\\');
  const auto next = [&] {
    const std::string word(cursor.next_word());
    return word + " in " + cursor.place();
  };
  ASSERT_TRUE(cursor.next_line());
  EXPECT_EQ(next(), "a in f:1: ");
  EXPECT_FALSE(cursor.is_line_finished());
  EXPECT_EQ(next(), "b in f:2: ");
  EXPECT_TRUE(cursor.is_line_finished());
  ASSERT_TRUE(cursor.next_line());
  EXPECT_EQ(next(), "c in f:4: ");
  EXPECT_TRUE(cursor.is_line_finished());
  ASSERT_TRUE(cursor.next_line());
  EXPECT_EQ(next(), "d in f:5: ");
  EXPECT_FALSE(cursor.next_line());
}

TEST(Text_cursor_lines, skips_what_is_left_of_a_continued_line)
{
  Text_cursor cursor("f", "a \\\nb \\\nc\nd", '#', '\\');
  ASSERT_TRUE(cursor.next_line());
  ASSERT_TRUE(cursor.next_line());
  EXPECT_EQ(cursor.next_word(), "d");
}

TEST(Text_cursor_lines, joins_lines)
{
  Text_cursor cursor("f", "a\nb # x\n\n c", '#');
  cursor.join_lines();
  ASSERT_TRUE(cursor.next_line());
  for (const char* word : {"a", "b", "c"})
  {
    EXPECT_FALSE(cursor.is_line_finished());
    EXPECT_EQ(cursor.next_word(), word);
  }
  EXPECT_EQ(cursor.place(), "f:4: ");
  EXPECT_TRUE(cursor.is_line_finished());
}

// ===  Binary_cursor.h

TEST(Binary_cursor, reads_numbers_of_both_byte_orders)
{
  using smf_test::big_endian_bytes;
  using smf_test::little_endian_bytes;

  const std::string little = little_endian_bytes(std::int32_t(-7)) + little_endian_bytes(0.1);
  Binary_cursor cursor("f", little, little.size(), Byte_order::LITTLE);
  EXPECT_EQ(cursor.next<std::int32_t>({"item", 0}), -7);
  EXPECT_EQ(cursor.next<double>({"item", 1}), 0.1);
  EXPECT_TRUE(cursor.remaining_data().empty());

  const std::string big = big_endian_bytes(std::uint16_t(513)) + big_endian_bytes(0.1f);
  EXPECT_EQ(big.substr(0, 2), "\2\1");
  cursor = Binary_cursor("f", big, big.size(), Byte_order::BIG);
  EXPECT_EQ(cursor.next<std::uint16_t>({"item", 0}), 513);
  EXPECT_EQ(cursor.next<float>({"item", 1}), 0.1f);
}

TEST(Binary_cursor, names_the_byte_in_the_file)
{
  const std::string data = "abcd";
  Binary_cursor cursor("f", data, 10, Byte_order::BIG);
  cursor.skip(2, {"face", 5});
  EXPECT_EQ(complaint([&] {
              cursor.next<float>({"face", 5});
            }),
            "f: byte 8: unexpected end of file in face 5");
  EXPECT_EQ(complaint([&] {
              cursor.skip(3, {"face", 5});
            }),
            "f: byte 8: unexpected end of file in face 5");
  EXPECT_EQ(cursor.remaining_data(), "cd");
}

// ===  ply_header.h

namespace {

const std::size_t largest_count = (std::numeric_limits<std::size_t>::max)();
const std::string simple_header = "ply\nformat binary_big_endian 1.0\ncomment property\n"
                                  "element vertex 12\nproperty double x\nobj_info element\n"
                                  "property uchar red\nelement face 0\n"
                                  "property list uint8 int list\nproperty float32 b\n"
                                  "element list " +
                                  std::to_string(largest_count) + "\nend_header\nrest";

std::string complaint_about_header(const std::string& text)
{
  return complaint([&] {
    Text_cursor cursor("f", text, Text_cursor::no_comments);
    read_ply_header(cursor);
  });
}

} // namespace

TEST(Ply_header, is_read)
{
  Text_cursor cursor("f", simple_header, Text_cursor::no_comments);
  const Ply_header header = read_ply_header(cursor);
  EXPECT_EQ(cursor.remaining_text(), "rest");
  EXPECT_EQ(header.format, Ply_format::BINARY_BIG_ENDIAN);
  ASSERT_EQ(header.elements.size(), 3u);
  const Ply_element &vertex = header.elements[0], &face = header.elements[1];
  EXPECT_EQ(vertex.name, "vertex");
  EXPECT_EQ(vertex.count, 12u);
  ASSERT_EQ(vertex.properties.size(), 2u);
  EXPECT_EQ(vertex.properties[0].name, "x");
  EXPECT_EQ(vertex.properties[0].type, Ply_type::FLOAT64);
  EXPECT_FALSE(vertex.properties[0].length_type);
  EXPECT_EQ(vertex.properties[1].type, Ply_type::UINT8);
  EXPECT_EQ(face.count, 0u);
  ASSERT_EQ(face.properties.size(), 2u);
  EXPECT_EQ(face.properties[0].name, "list");
  EXPECT_EQ(face.properties[0].length_type, Ply_type::UINT8);
  EXPECT_EQ(face.properties[0].type, Ply_type::INT32);
  EXPECT_EQ(face.properties[1].type, Ply_type::FLOAT32);
  EXPECT_EQ(header.elements[2].count, largest_count);
  EXPECT_TRUE(header.elements[2].properties.empty());
}

TEST(Ply_header, all_types_have_two_names)
{
  const std::vector<std::array<const char*, 2>> names = {
    {"char", "int8"}, {"uchar", "uint8"}, {"short", "int16"},   {"ushort", "uint16"},
    {"int", "int32"}, {"uint", "uint32"}, {"float", "float32"}, {"double", "float64"}};
  for (std::size_t i = 0; i < names.size(); ++i)
    for (const char* name : names[i])
    {
      Text_cursor cursor = cursor_at(name);
      EXPECT_EQ(read_ply_type(cursor), static_cast<Ply_type>(i)) << name;
    }
  EXPECT_TRUE(is_integer(Ply_type::UINT32));
  EXPECT_FALSE(is_integer(Ply_type::FLOAT32));
}

TEST(Ply_header, is_refused_for_each_defect)
{
  EXPECT_EQ(complaint_about_header(simple_header), "");
  EXPECT_EQ(complaint_about_header(""), "f:1: not a PLY file: it does not start with 'ply'");
  EXPECT_EQ(complaint_about_header("ply\nend_header"), "f:2: the PLY format line is missing");
  const auto complaint_after = [](const std::string& old_part, const std::string& new_part) {
    return complaint_about_header(smf_test::replaced(simple_header, old_part, new_part));
  };
  EXPECT_EQ(complaint_after("binary_big_endian", "binary"), "f:2: 'binary' is not a PLY format");
  EXPECT_EQ(complaint_after("vertex 12", "vertex -1"),
            "f:4: element 'vertex': '-1' is not a valid count");
  EXPECT_EQ(complaint_after("double x", "complex x"), "f:5: 'complex' is not a PLY type");
  EXPECT_EQ(complaint_after("list uint8", "list float"),
            "f:9: the length of a list is not an integer");
  EXPECT_EQ(complaint_after("comment property", "property int x"),
            "f:3: unexpected PLY statement 'property'");
  EXPECT_EQ(complaint_after("end_header", "end"), "f:12: unexpected PLY statement 'end'");
  EXPECT_EQ(complaint_after("end_header\nrest", "comment"),
            "f:12: unexpected end of file: the PLY header does not end");
}

} // namespace test_file_records
