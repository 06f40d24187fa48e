// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/decimal_comma.h"
#include "include/example_systems.h"
#include "include/temporary_folder.h"

#include <CGAL/Surface_mesh_foliation/IO/read_loops.h>
#include <CGAL/Surface_mesh_foliation/IO/write_loops.h>
#include <CGAL/Surface_mesh_foliation/automatic_loops.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <locale>
#include <string>
#include <vector>

namespace test_read_loops {

namespace {

using smf_test::Mesh;
using smf_test::vertex;
namespace SMF = CGAL::Surface_mesh_foliation;
namespace soups = smf_test::soups;

using Input = SMF::Poles_and_loops<Mesh>;
using Loop = SMF::Loop<Mesh>;

class Read_loops : public ::testing::Test
{
protected:
  std::string write(const std::string& text) const { return folder.write("file.loops", text); }

  Input read(const std::string& text) const
  {
    Input result;
    SMF::read_loops(write(text), mesh, result);
    return result;
  }

  // what is wrong with a file, after FILE:LINE:
  std::string complaint(const std::string& text, std::size_t line) const
  {
    const std::string place = write(text) + ":" + std::to_string(line) + ": ";
    try
    {
      read(text);
    }
    catch (const SMF::Foliation_exception& exception)
    {
      const std::string message = exception.what();
      EXPECT_EQ(message, exception.problem().message);
      EXPECT_EQ(message.find('\n'), std::string::npos);
      EXPECT_EQ(message.substr(0, place.size()), place);
      const bool is_file = dynamic_cast<const SMF::Invalid_file_exception*>(&exception) != nullptr;
      const bool is_loop = dynamic_cast<const SMF::Invalid_loops_exception*>(&exception) != nullptr;
      EXPECT_TRUE(is_file || is_loop);
      return message.substr(std::min(place.size(), message.size()));
    }
    ADD_FAILURE() << "accepted: " << text;
    return "";
  }

  smf_test::Temporary_folder folder;
  Mesh mesh = smf_test::torus(12, 8, 3, 1);
};

void expect_equal(const Loop& found, const Loop& expected)
{
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_EQ(found[i].halfedge, expected[i].halfedge);
    EXPECT_EQ(found[i].position, expected[i].position);
  }
}

// on surfaces of genus 1 to 3
TEST_F(Read_loops, that_were_written)
{
  for (const auto& soup :
       {soups::torus(12, 8, 3, 1), soups::genus_surface(2), soups::handle_surface(3)})
  {
    mesh = smf_test::to_mesh(soup);
    Input proposed;
    SMF::propose_loops(mesh, proposed);
    ASSERT_GT(proposed.size(), 0u);
    std::vector<Loop> loops;
    for (const auto& entry : proposed.entries())
      loops.push_back(entry.loop);
    // with the numbers of vertices, and with others
    std::vector<Mesh::Vertex_index> reversed(mesh.vertices_begin(), mesh.vertices_end());
    std::reverse(reversed.begin(), reversed.end());
    reversed.insert(reversed.begin() + 2, Mesh::null_vertex());
    const auto numbers = SMF::parameters::numbered_vertices(reversed);
    Input found, found_by_numbers;
    SMF::write_loops(folder.file_name("found"), mesh, loops);
    SMF::write_loops(folder.file_name("numbered"), mesh, loops, numbers);
    SMF::read_loops(folder.file_name("found"), mesh, found);
    SMF::read_loops(folder.file_name("numbered"), mesh, found_by_numbers, numbers);
    EXPECT_NE(smf_test::file_text(folder.file_name("found")),
              smf_test::file_text(folder.file_name("numbered")));
    for (const Input* input : {&found, &found_by_numbers})
    {
      ASSERT_EQ(input->size(), loops.size());
      for (std::size_t a = 0; a < loops.size(); ++a)
        expect_equal(input->entries()[a].loop, loops[a]);
    }
    EXPECT_THROW(
      SMF::write_loops(folder.file_name("none"), mesh, loops,
                       SMF::parameters::numbered_vertices(std::vector<Mesh::Vertex_index>())),
      SMF::Invalid_file_exception);
    try
    {
      SMF::read_loops(write("separate 2"), mesh, found, numbers);
      ADD_FAILURE();
    }
    catch (const SMF::Invalid_file_exception& exception)
    {
      EXPECT_NE(std::string(exception.what()).find("vertex 2 is no vertex"), std::string::npos);
    }
  }
}

TEST_F(Read_loops, of_crossings_that_are_wrong)
{
  EXPECT_NE(complaint("crossing 0 1\n", 1).find("two vertices and a number"), std::string::npos);
  EXPECT_NE(complaint("crossing 0 1 x\n", 1).find("two vertices and a number"), std::string::npos);
  EXPECT_NE(complaint("crossing 0 50 0.5\n", 1).find("no edge"), std::string::npos);
  EXPECT_NE(complaint("crossing 0 1000 0.5\n", 1).find("no vertex 1000"), std::string::npos);
}

TEST_F(Read_loops, of_each_kind)
{
  const Input input = read("cycle 0 1 2 3 4 5 6 7\n"
                           "separate 16 17 18 19 20 21 22 23\n"
                           "plane 0 1 0 -0.5 30\n"
                           "through 40 43 46\n");
  ASSERT_EQ(input.size(), 5u); // the second line makes two loops
  std::vector<Mesh::Vertex_index> cycle, row;
  for (std::size_t i = 0; i < 8; ++i)
  {
    cycle.push_back(vertex(i));
    row.push_back(vertex(16 + i));
  }
  std::vector<Loop> around;
  SMF::loops_around_vertices(row, mesh, std::back_inserter(around));
  ASSERT_EQ(around.size(), 2u);
  expect_equal(input.entries()[0].loop, SMF::loop_from_edge_cycle(cycle, mesh));
  expect_equal(input.entries()[1].loop, around[0]);
  expect_equal(input.entries()[2].loop, around[1]);
  expect_equal(input.entries()[3].loop, SMF::plane_section_loop(mesh, {0, 1, 0, -0.5}, vertex(30)));
  expect_equal(input.entries()[4].loop,
               SMF::loop_through_vertices(smf_test::vertex_range({40, 43, 46}), mesh));
  for (const auto& entry : input.entries())
  {
    EXPECT_EQ(entry.height, 1);
    EXPECT_TRUE(entry.pole.empty());
  }
}

TEST_F(Read_loops, comments_blank_lines_and_line_ends)
{
  const std::string cycle = "cycle 0 1 2 3 4 5 6 7";
  const Loop expected = read(cycle + "\n").entries().at(0).loop;
  for (const std::string& text : std::vector<std::string>{
         cycle, cycle + "\r\n", "\n\n  \t\n" + cycle + "\n\n",
         "# cycle 5 6 7\n" + cycle + "# 8 9\n", "\r\n#\r\n" + cycle + " # the tube\r\n\r\n",
         "\t cycle\t0 1  2 3 4 5\t6 7   \t\r\n#", cycle + "#"})
  {
    const Input input = read(text);
    ASSERT_EQ(input.size(), 1u) << text;
    expect_equal(input.entries()[0].loop, expected);
  }
  for (const char* nothing : {"", "\n", "\r\n", "#", "# comment only", "   \n\t\n"})
    EXPECT_EQ(read(nothing).size(), 0u);
}

TEST_F(Read_loops, appends)
{
  Input input;
  input.add_pole(vertex(90), 3);
  SMF::read_loops(write("cycle 0 1 2 3 4 5 6 7\n"), mesh, input);
  SMF::read_loops(write("separate 44\n"), mesh, input);
  ASSERT_EQ(input.size(), 3u);
  EXPECT_EQ(input.entries()[0].height, 3);
  EXPECT_EQ(input.entries()[2].loop.size(), 6u);
}

TEST_F(Read_loops, numbers_of_all_sorts)
{
  const Loop expected = read("plane 0 1 0 -0.5 30\n").entries().at(0).loop;
  for (const char* text : {"plane 0 1e0 0 -5e-1 30\n", "plane 0.0 1.0 -0 -.5 30\n",
                           "plane 0 2 0 -1 30\n", "plane +0 +1 0 -0.50000 30"})
  {
    const Input input = read(text);
    ASSERT_EQ(input.size(), 1u) << text;
    ASSERT_EQ(input.entries()[0].loop.size(), expected.size());
    EXPECT_EQ(input.entries()[0].loop[0].halfedge, expected[0].halfedge);
  }
}

TEST_F(Read_loops, the_locale_does_not_matter)
{
  const Loop expected = read("plane 0 1 0 -0.5 30\n").entries().at(0).loop;
  const std::locale before =
    std::locale::global(std::locale(std::locale(), new smf_test::Decimal_comma));
  expect_equal(read("plane 0 1 0 -0.5 30\n").entries().at(0).loop, expected);
  const std::string message = complaint("separate 1234567\n", 1);
  std::locale::global(before);
  EXPECT_NE(message.find("1234567"), std::string::npos) << message;
}

// ===  Errors

TEST_F(Read_loops, unknown_kinds)
{
  EXPECT_NE(complaint("circle 1 2 3\n", 1).find("circle"), std::string::npos);
  EXPECT_NE(complaint("# ok\n\nCycle 1 2 3\n", 3).find("Cycle"), std::string::npos);
  complaint("0 1 2 3\n", 1);
  complaint("cycle,0,1,2\n", 1);
  complaint("cycle 0 1 2 3 4 5 6 7\nseparate 1\nplane 0 1 0 -0.5 30\n\xff\xfe binary\n", 4);
}

TEST_F(Read_loops, bad_vertices)
{
  EXPECT_NE(complaint("separate 96\n", 1).find("96"), std::string::npos); // there are 0, ..., 95
  EXPECT_EQ(read("separate 95\n").size(), 1u);
  EXPECT_NE(complaint("separate -1\n", 1).find("-1"), std::string::npos);
  EXPECT_NE(complaint("separate 1.5\n", 1).find("1.5"), std::string::npos);
  EXPECT_NE(complaint("separate 3x\n", 1).find("3x"), std::string::npos);
  complaint("separate 0x10\n", 1);
  complaint("separate 1e1\n", 1);
  complaint("separate 18446744073709551617\n", 1); // 1 after a wrap-around
  complaint("separate 4294967297\n", 1);
  complaint("separate 1,2,3\n", 1);
  complaint("separate nan\n", 1);
  complaint("\nseparate\n", 2);
  complaint("cycle # 1 2 3\n", 1);
}

TEST_F(Read_loops, bad_loops)
{
  EXPECT_NE(complaint("cycle 0 1 50\n", 1).find("edge"), std::string::npos);
  complaint("\ncycle 0 1\n", 2);
  complaint("cycle 0 1 0 1\n", 1);
  std::string all = "separate";
  for (int i = 0; i < 96; ++i)
    all += " " + std::to_string(i);
  EXPECT_NE(complaint("#\n" + all + "\n", 2).find("boundary"), std::string::npos);
  EXPECT_NE(complaint("plane 0 0 1 -99 0\n", 1).find("plane"), std::string::npos);
  complaint("plane 0 0 0 0 0\n", 1);
}

TEST_F(Read_loops, bad_planes)
{
  for (const char* line : {"plane", "plane 0", "plane 0 1 0 -0.5", "plane 0 1 0 -0.5 30 31",
                           "plane 0 1 0 x 30", "plane 0 nan 0 -0.5 30", "plane 0 inf 0 -0.5 30",
                           "plane 0 1e999 0 -0.5 30", "plane 0 1 0 -0.5 96", "plane 0 1 0 -0.5 -1",
                           "plane 0 1 0 0,5 30", "plane 0 1 0 -0.5 1.5", "plane 0 1 0x1p3 -0.5 3"})
    EXPECT_FALSE(complaint(std::string("# first line\n") + line + "\n", 2).empty()) << line;
}

TEST_F(Read_loops, files_that_cannot_be_opened)
{
  std::vector<std::string> names = {folder.file_name("missing")};
#ifndef __EMSCRIPTEN__ // where a folder opens as an empty file
  names.push_back(folder.file_name(""));
#endif
  for (const std::string& name : names)
    try
    {
      Input input;
      SMF::read_loops(name, mesh, input);
      ADD_FAILURE() << name << " is accepted";
    }
    catch (const SMF::Invalid_file_exception& exception)
    {
      EXPECT_EQ(exception.problem().kind, SMF::Problem_kind::FILE);
      EXPECT_EQ(std::string(exception.what()).rfind(name, 0), 0u) << exception.what();
    }
}

TEST_F(Read_loops, loops_of_the_lines_before_an_error_stay)
{
  Input input, expected;
  SMF::read_loops(write("separate 1\nseparate 2\n"), mesh, expected);
  const std::string file = write("separate 1\nseparate 2\nseparate 200\nseparate 3\n");
  EXPECT_THROW(SMF::read_loops(file, mesh, input), SMF::Invalid_file_exception);
  ASSERT_EQ(input.size(), 2u);
  for (const std::size_t i : {0, 1})
    EXPECT_EQ(input.entries()[i].loop.front().halfedge,
              expected.entries()[i].loop.front().halfedge);
}

} // namespace

} // namespace test_read_loops
