// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Lines and words of a text, and whole files.

#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/Text_cursor.h>

#include "include/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace test_text_cursor {

using namespace CGAL::Surface_mesh_foliation::internal;
namespace SMF = CGAL::Surface_mesh_foliation;
using SMF::Problem_kind;

namespace {

// all words of the text, line by line, each line with its place
std::vector<std::vector<std::string>> lines_of(std::string_view text, char comment_character = '#')
{
  Text_cursor cursor("f", text, comment_character);
  std::vector<std::vector<std::string>> result;
  while (cursor.next_line())
  {
    result.push_back({cursor.place()});
    EXPECT_FALSE(cursor.is_line_finished());
    while (!cursor.is_line_finished())
      result.back().emplace_back(cursor.next_word());
    EXPECT_TRUE(cursor.next_word().empty());
  }
  EXPECT_TRUE(cursor.is_line_finished());
  EXPECT_FALSE(cursor.next_line());
  return result;
}

using Lines = std::vector<std::vector<std::string>>;

} // namespace

TEST(Text_cursor, goes_over_lines_with_words)
{
  EXPECT_EQ(lines_of(""), Lines());
  EXPECT_EQ(lines_of("\n \n\t\r\n"), Lines());
  EXPECT_EQ(lines_of("a"), (Lines{{"f:1: ", "a"}}));
  EXPECT_EQ(lines_of("a b\n\nc\n"), (Lines{{"f:1: ", "a", "b"}, {"f:3: ", "c"}}));
  EXPECT_EQ(lines_of("\r\n  a\t\vb\f \r\nc"), (Lines{{"f:2: ", "a", "b"}, {"f:3: ", "c"}}));
}

TEST(Text_cursor, leaves_out_comments)
{
  EXPECT_EQ(lines_of("#a\nb#c d\n e # f\n#"), (Lines{{"f:2: ", "b"}, {"f:3: ", "e"}}));
  EXPECT_EQ(lines_of("#a\nb;c", ';'), (Lines{{"f:1: ", "#a"}, {"f:2: ", "b"}}));
  EXPECT_EQ(lines_of("#a\nb#", Text_cursor::no_comments),
            (Lines{{"f:1: ", "#a"}, {"f:2: ", "b#"}}));
}

TEST(Text_cursor, knows_what_remains_and_where_it_is)
{
  Text_cursor cursor("folder/f", "a b\nc\nd", '#');
  EXPECT_EQ(cursor.place(), "folder/f:1: ");
  EXPECT_EQ(cursor.remaining_text(), "a b\nc\nd");
  ASSERT_TRUE(cursor.next_line());
  EXPECT_EQ(cursor.next_word(), "a");
  EXPECT_EQ(cursor.remaining_text(), "c\nd"); // not the rest of the line
  ASSERT_TRUE(cursor.next_line());            // words may be left out
  EXPECT_EQ(cursor.place(), "folder/f:2: ");
  Text_cursor copy = cursor;
  EXPECT_EQ(copy.next_word(), "c");
  EXPECT_EQ(cursor.next_word(), "c");
  ASSERT_TRUE(cursor.next_line());
  EXPECT_EQ(cursor.remaining_text(), "");
  EXPECT_FALSE(cursor.next_line());
  EXPECT_EQ(cursor.place(), "folder/f:3: ");
}

TEST(Text_cursor, failures_name_the_place)
{
  Text_cursor cursor("f", "\na", '#');
  ASSERT_TRUE(cursor.next_line());
  try
  {
    cursor.fail("what");
  }
  catch (const SMF::Invalid_file_exception& exception)
  {
    EXPECT_STREQ(exception.what(), "f:2: what");
    EXPECT_EQ(exception.problem().kind, Problem_kind::FILE);
  }
  try
  {
    throw SMF::Invalid_mesh_exception(
      problem(Problem_kind::NOT_FINITE, cursor.place(), "what").vertices({7}).faces({8, 9}));
  }
  catch (const SMF::Invalid_mesh_exception& exception)
  {
    EXPECT_STREQ(exception.what(), "f:2: what");
    EXPECT_EQ(exception.problem().kind, Problem_kind::NOT_FINITE);
    EXPECT_EQ(exception.problem().vertices, std::vector<std::size_t>{7});
    EXPECT_EQ(exception.problem().faces, (std::vector<std::size_t>{8, 9}));
  }
  EXPECT_THROW(cursor.fail("what"), SMF::Invalid_file_exception);
}

TEST(Read_whole_file, reads_every_byte_whatever_the_size)
{
  const smf_test::Temporary_folder folder;
  for (const std::size_t size : {0, 1, 65535, 65536, 65537, 200000})
  {
    std::string text;
    for (std::size_t i = 0; i < size; ++i)
      text += static_cast<char>(i * i % 256);
    EXPECT_TRUE(read_whole_file(folder.write("f", text)) == text) << size;
  }
  EXPECT_THROW(read_whole_file(folder.file_name("missing")), SMF::Invalid_file_exception);
  std::filesystem::create_directory(folder.file_name("folder"));
  EXPECT_THROW(read_whole_file(folder.file_name("folder")), SMF::Invalid_file_exception);
}

} // namespace test_text_cursor
