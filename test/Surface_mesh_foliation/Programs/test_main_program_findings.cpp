// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the program finds by itself, and how it tells it: loops, poles, samples, symmetries.

#include "generators/genus_soups.h"
#include "generators/revolution.h"
#include "include/main_program.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

namespace test_main_program_findings {

namespace {

using smf_test::Arguments;
using smf_test::expect_consistent_json;
using smf_test::Json;
using smf_test::Triangle_soup;
namespace soups = smf_test::soups;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

bool contains(const std::string& text, const std::string& word)
{
  return text.find(word) != std::string::npos;
}

class Main_program_findings : public smf_test::Main_program
{};

TEST_F(Main_program_findings, loops_can_be_read_again)
{
  for (const Triangle_soup& soup :
       {soups::torus(9, 7, 3, 1), soups::genus_surface(2), soups::handle_surface(3)})
  {
    const std::string mesh = write("mesh.off", soup), output = folder.file_name("output");
    const Json found = json({mesh, "--pole", "0", "--auto-loops", "--output", output});
    expect_consistent_json(found);
    ASSERT_GT(found["found_loops"].size(), 0u);
    for (const Json& loop : found["found_loops"])
    {
      EXPECT_GE(loop["loop"], 1);
      EXPECT_GT(loop["length"], 0);
      EXPECT_EQ(loop["point"].size(), 3u);
    }
    const Json again = json({mesh, "--pole", "0", "--loops", output + "/found_loops.txt"});
    EXPECT_EQ(again["reeb_graph"], found["reeb_graph"]);
    EXPECT_EQ(again["foliation"], found["foliation"]);
    EXPECT_TRUE(again["found_loops"].empty());
  }
}

TEST_F(Main_program_findings, poles_and_their_detector_are_in_the_table)
{
  const Triangle_soup soup = soups::limbed_sphere(4, 4);
  const std::string mesh = write("mesh.off", soup);
  const Json found = json({mesh});
  const auto table = run({mesh});
  EXPECT_EQ(table.exit_code, 0);
  EXPECT_TRUE(found["detector"].is_string());
  EXPECT_TRUE(contains(table.output, found["detector"].get<std::string>())) << table.output;
  for (const Json& pole : found["poles"])
    EXPECT_TRUE(contains(table.output, " " + pole[0].dump())) << table.output;
  const Json given = json({mesh, "--pole", "0", "--pole", "1"});
  EXPECT_TRUE(given["detector"].is_null());
  EXPECT_TRUE(contains(run({mesh, "--pole", "0", "--pole", "1"}).output, "poles: 0 1\n"));
}

TEST_F(Main_program_findings, samples_are_as_many_as_wanted)
{
  const std::string mesh = write("mesh.off", soups::limbed_sphere(3, 4));
  const auto number_of_points = [&](const Arguments& options) {
    const std::string output = folder.file_name("output");
    Arguments arguments = {mesh, "--output", output};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Json result = json(arguments);
    std::ifstream input(output + "/skeleton.swc");
    return std::count(std::istreambuf_iterator<char>(input), std::istreambuf_iterator<char>(),
                      '\n') -
           1 - static_cast<std::ptrdiff_t>(result["reeb_graph"]["nodes"].size());
  };
  EXPECT_EQ(number_of_points({"--samples", "0"}), 0);
  EXPECT_EQ(number_of_points({"--samples", "7"}) % 7, 0);
  EXPECT_GE(number_of_points({"--samples", "auto"}), number_of_points({"--samples", "20"}));
  EXPECT_EQ(number_of_points({"--samples", "auto"}), number_of_points({}));
  for (const std::string wrong : {"-1", "many", "1.5"})
    EXPECT_TRUE(contains(error({mesh, "--samples", wrong}), "--samples"));
}

// The four limbs of a tube are exchanged; the tube between them is not.
TEST_F(Main_program_findings, symmetric_arcs_have_one_number_in_the_segments)
{
  const auto [soup, ends] = soups::capsule(5, 36);
  Arguments arguments = {write("symmetric.off", soup), "--detail", "0.6", "--output",
                         folder.file_name("symmetric")};
  for (const std::size_t v : ends)
    arguments.insert(arguments.end(), {"--pole", std::to_string(v)});
  const auto components = [&](const Arguments& more) {
    Arguments all = arguments;
    all.insert(all.end(), more.begin(), more.end());
    const Json result = json(all);
    EXPECT_EQ(result["symmetries"], Json::array({Json::array({0, 1, 2, 3})}));
    Mesh mesh;
    std::ifstream input(folder.file_name("symmetric/segments.ply"));
    std::string comments;
    EXPECT_TRUE(CGAL::IO::read_PLY(input, mesh, comments));
    const auto component = mesh.property_map<Mesh::Face_index, int>("f:component");
    EXPECT_TRUE(component.second);
    std::set<int> numbers;
    for (const auto f : faces(mesh))
      numbers.insert(component.first[f]);
    return numbers;
  };
  EXPECT_EQ(components({}), (std::set<int>{0, 1, 2, 3, 4}));
  EXPECT_EQ(components({"--symmetry"}), (std::set<int>{0, 4}));
}

} // namespace

} // namespace test_main_program_findings
