// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes as people have them: of several parts, damaged, with holes, with nothing given.

#include "generators/genus_soups.h"
#include "generators/openings.h"
#include "include/main_program.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace test_main_program_meshes {

namespace {

using smf_test::Arguments;
using smf_test::expect_consistent_json;
using smf_test::Json;
using smf_test::Main_program;
using smf_test::Triangle_soup;
using smf_test::without_seconds;
namespace soups = smf_test::soups;

bool contains(const std::string& text, const std::string& word)
{
  return text.find(word) != std::string::npos;
}

// side by side, the second scaled
Triangle_soup together(Triangle_soup soup, const Triangle_soup& other, double scale)
{
  const std::size_t first = soup.points.size();
  for (const auto& p : other.points)
    soup.points.push_back({scale * p[0] + 50, scale * p[1], scale * p[2]});
  for (const auto& [a, b, c] : other.triangles)
    soup.triangles.push_back({a + first, b + first, c + first});
  return soup;
}

class Main_program_meshes : public Main_program
{
protected:
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

  Mesh read_ply(const std::string& file) const
  {
    Mesh mesh;
    std::ifstream input(file);
    std::string comments;
    EXPECT_TRUE(CGAL::IO::read_PLY(input, mesh, comments)) << file;
    return mesh;
  }
};

// ===  Parts

TEST_F(Main_program_meshes, of_several_parts)
{
  // the second part is larger, and comes first
  const Triangle_soup small = soups::limbed_sphere(3, 3), large = soups::genus_surface(2);
  const std::string mesh = write("parts.off", together(small, large, 10));
  const Json all = json({mesh, "--output", folder.file_name("all")});
  expect_consistent_json(all);
  ASSERT_EQ(all["parts"].size(), 2u);
  EXPECT_EQ(all["parts"][0]["vertices"], large.points.size());
  EXPECT_EQ(all["parts"][0]["genus"], 2);
  EXPECT_EQ(all["parts"][1]["vertices"], small.points.size());
  EXPECT_EQ(all["parts"][1]["faces"], small.triangles.size());
  EXPECT_EQ(all["genus"], 2);
  std::size_t nodes = 0, arcs = 0, loops = 0;
  for (const Json& part : all["parts"])
  {
    nodes += part["nodes"].get<std::size_t>();
    arcs += part["arcs"].get<std::size_t>();
    loops += part["loops"].get<std::size_t>();
  }
  EXPECT_EQ(all["reeb_graph"]["nodes"].size(), nodes);
  EXPECT_EQ(all["reeb_graph"]["arcs"].size(), arcs);
  EXPECT_EQ(all["loops"], loops);
  EXPECT_EQ(all["foliation"]["converged"], true);
  // vertices have the numbers of the file
  for (const Json& node : all["reeb_graph"]["nodes"])
    if (node["part"] == 1 && node["pole"] >= 0)
    {
      EXPECT_LT(all["poles"][node["pole"].get<std::size_t>()][0], small.points.size());
    }
  // a graph, and a folder for each part
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.file_name("all")))
    names.insert(entry.path().filename().string());
  for (const std::string name : {"reeb_graph.graphml", "skeleton.ply", "segments.ply", "part_0",
                                 "part_1", "found_loops.txt"})
    EXPECT_EQ(names.count(name), 1u) << name;
  EXPECT_EQ(num_faces(read_ply(folder.file_name("all/part_1/foliation.ply"))),
            small.triangles.size());
  EXPECT_EQ(num_faces(read_ply(folder.file_name("all/segments.ply"))), all["faces"]);
  // the same as alone
  const Json alone = json({write("large.off", together({}, large, 10))});
  EXPECT_EQ(all["parts"][0]["nodes"], alone["parts"][0]["nodes"]);
  for (std::size_t a = 0; a < alone["reeb_graph"]["arcs"].size(); ++a)
    EXPECT_EQ(all["reeb_graph"]["arcs"][a], alone["reeb_graph"]["arcs"][a]);
}

TEST_F(Main_program_meshes, can_be_the_largest_part_only)
{
  const Triangle_soup body = soups::limbed_sphere(4, 3);
  const std::string mesh = write("specks.off", together(together(body, soups::icosphere(0), 0.1),
                                                        soups::torus(6, 5, 3, 1), 0.01));
  EXPECT_EQ(json({mesh})["parts"].size(), 3u);
  EXPECT_EQ(json({mesh, "--parts", "all"})["parts"].size(), 3u);
  EXPECT_EQ(json({mesh, "--parts", "2"})["parts"].size(), 2u);
  const Json largest = json({mesh, "--parts", "largest"});
  expect_consistent_json(largest);
  EXPECT_EQ(largest["parts"][0]["vertices"], body.points.size());
  EXPECT_EQ(largest["reeb_graph"], json({mesh, "--parts", "1"})["reeb_graph"]);
  for (const std::string wrong : {"0", "-1", "some", "1.5", ""})
    EXPECT_TRUE(contains(error({mesh, "--parts", wrong}), "--parts"));
  // a pole on a part that is left out
  const std::string speck = std::to_string(body.points.size());
  EXPECT_TRUE(contains(error({mesh, "--parts", "largest", "--pole", speck}), "on none of the"));
}

TEST_F(Main_program_meshes, of_several_parts_take_what_is_given)
{
  const Triangle_soup body = soups::limbed_sphere(4, 3);
  const auto tips = soups::limb_tips(4, 3);
  const std::string mesh = write("two.off", together(body, body, 0.5));
  Arguments arguments = {mesh};
  for (const std::size_t tip : {tips[0], tips[1], tips[2]})
    for (const std::size_t first : {std::size_t(0), body.points.size()})
      arguments.insert(arguments.end(), {"--pole", std::to_string(tip + first)});
  arguments.insert(arguments.end(), {"--heights", "1,2,3,4,5,6"});
  const Json result = json(arguments);
  expect_consistent_json(result);
  EXPECT_EQ(result["loops"], 6);
  EXPECT_EQ(result["reeb_graph"]["degrees"], Json({1, 1, 1, 1, 1, 1, 3, 3}));
  EXPECT_EQ(result["poles"][0], Json({tips[0]}));
  EXPECT_EQ(result["poles"][3], Json({tips[0] + body.points.size()}));
  for (std::size_t a = 0; a < 6; ++a)
  {
    EXPECT_EQ(result["reeb_graph"]["arcs"][a]["height"], a + 1.);
    EXPECT_EQ(result["reeb_graph"]["arcs"][a]["part"], a / 3);
  }
  // on one part only: poles are found on the other
  const Json one =
    json({mesh, "--pole", std::to_string(tips[0]), "--pole", std::to_string(tips[1])});
  EXPECT_EQ(one["parts"][0]["loops"], 2);
  EXPECT_GE(one["parts"][1]["loops"], 2);
  // what is given must make sense
  EXPECT_TRUE(contains(error({mesh, "--pole", "0"}), "part 0: "));
}

TEST_F(Main_program_meshes, parts_without_graph_are_told)
{
  const Triangle_soup triangle = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const std::string mesh = write("fin.off", together(soups::icosphere(1), triangle, 0.1));
  EXPECT_EQ(json({mesh})["reeb_graph"]["arcs"].size(), 2u) << "its hole is filled, so it is closed";
  const auto result = run({mesh, "--borders", "ends", "--json"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(contains(result.errors, "warning: part 1: ")) << result.errors;
  const Json parsed = Json::parse(result.output);
  expect_consistent_json(parsed);
  ASSERT_EQ(parsed["parts"].size(), 2u);
  EXPECT_FALSE(parsed["parts"][0].contains("error"));
  EXPECT_TRUE(parsed["parts"][1].contains("error"));
}

// ===  Repair

TEST_F(Main_program_meshes, are_repaired_on_request)
{
  // a torus of which every third face is turned over, with an unused vertex in front
  Triangle_soup soup = soups::torus(9, 7, 3, 1);
  const Json expected = json({write("torus.off", soup), "--pole", "10", "--pole", "40"});
  soup.points.insert(soup.points.begin(), {9, 9, 9});
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
  {
    for (std::size_t& v : soup.triangles[f])
      ++v;
    if (f % 3 == 0)
      std::swap(soup.triangles[f][0], soup.triangles[f][1]);
  }
  const std::string mesh = write("damaged.off", soup);
  const std::string message = error({mesh, "--pole", "11", "--pole", "41"});
  EXPECT_TRUE(contains(message, "--repair")) << message;
  EXPECT_TRUE(contains(message, "42 faces were turned over")) << message;
  EXPECT_TRUE(contains(message, "1 vertex was removed")) << message;
  const std::string output = folder.file_name("output");
  const Json result = json({mesh, "--repair", "--pole", "11", "--pole", "41", "--output", output});
  expect_consistent_json(result);
  EXPECT_EQ(result["repair"]["reversed_faces"], 42);
  EXPECT_EQ(result["repair"]["unused_vertices"], 1);
  EXPECT_EQ(result["poles"], Json({{11}, {41}})) << "by the numbers of the file";
  EXPECT_EQ(result["reeb_graph"]["degrees"], expected["reeb_graph"]["degrees"]);
  EXPECT_NEAR(result["foliation"]["energy"].get<double>(),
              expected["foliation"]["energy"].get<double>(), 1e-9);
  EXPECT_EQ(smf_test::file_text(output + "/repaired_vertices.txt").rfind("-1\n0\n1\n2\n", 0), 0u);
  EXPECT_EQ(smf_test::file_text(output + "/repaired_faces.txt").rfind("0\n1\n2\n", 0), 0u);
  EXPECT_TRUE(contains(error({mesh, "--repair", "--pole", "0", "--pole", "11"}),
                       "vertex 0 is no vertex of the repaired mesh"));
  // loops by the numbers of the file
  const std::string loops = folder.write("loops", "cycle 1 2 3 4 5 6 7\n");
  EXPECT_EQ(json({mesh, "--repair", "--loops", loops})["loops"], 1);
  EXPECT_TRUE(
    contains(error({mesh, "--repair", "--loops", folder.write("wrong", "cycle 0 2 3 4 5 6 7\n")}),
             "vertex 0 is no vertex"));
}

TEST_F(Main_program_meshes, that_need_no_repair_stay_the_same)
{
  for (const Triangle_soup& soup :
       {soups::limbed_sphere(4, 3), soups::torus(9, 7, 3, 1), soups::genus_surface(2)})
  {
    const std::string mesh = write("mesh.off", soup);
    Json plain = without_seconds(json({mesh})),
         repaired = without_seconds(json({mesh, "--repair"}));
    EXPECT_TRUE(plain["repair"].is_null());
    EXPECT_TRUE(repaired["repair"].is_object());
    plain.erase("repair");
    repaired.erase("repair");
    EXPECT_EQ(plain, repaired);
  }
}

TEST_F(Main_program_meshes, of_loose_triangles_are_told_to_be_repaired)
{
  const Triangle_soup soup = soups::icosphere(1);
  Triangle_soup loose;
  for (const auto& triangle : soup.triangles)
  {
    const std::size_t n = loose.points.size();
    for (const std::size_t v : triangle)
      loose.points.push_back(soup.points[v]);
    loose.triangles.push_back({n, n + 1, n + 2});
  }
  const std::string mesh = write("loose.off", loose);
  EXPECT_TRUE(contains(error({mesh}), "no two share an edge; use --repair"));
  const Json result = json({mesh, "--repair"});
  expect_consistent_json(result);
  EXPECT_EQ(result["vertices"], soup.points.size());
  EXPECT_EQ(result["repair"]["merged_vertices"], loose.points.size() - soup.points.size());
}

TEST_F(Main_program_meshes, of_polygons_are_cut)
{
  const std::string box = folder.write(
    "box.off", "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 4\n1 0 4\n1 1 4\n0 1 4\n4 0 3 2 1\n"
               "4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
  const std::string message = error({box});
  EXPECT_TRUE(contains(message, ":11: ")) << message;
  EXPECT_TRUE(contains(message, "6 faces were cut into triangles")) << message;
  const Json result = json({box, "--repair"});
  expect_consistent_json(result);
  EXPECT_EQ(result["faces"], 12);
}

// ===  Filled openings

TEST_F(Main_program_meshes, are_written_without_what_fills_their_holes)
{
  for (const Triangle_soup& closed : {soups::limbed_sphere(4, 3), soups::torus(12, 9, 3, 1)})
  {
    std::size_t number = 0;
    const Triangle_soup soup = soups::with_faces(closed, [&](const soups::Triangle&) {
      ++number;
      return number != 20 && number != 70;
    });
    const std::string output = folder.file_name("output");
    const Json result = json({write("holes.off", soup), "--borders", "fill", "--output", output});
    EXPECT_EQ(result["openings"]["filled"], 2);
    EXPECT_EQ(result["faces"], soup.triangles.size());
    for (const std::string name : {"foliation.ply", "segments.ply"})
    {
      const Mesh mesh = read_ply(output + "/" + name);
      EXPECT_EQ(num_vertices(mesh), soup.points.size());
      EXPECT_EQ(num_faces(mesh), soup.triangles.size());
    }
    const Mesh cut = read_ply(output + "/components.ply");
    EXPECT_FALSE(CGAL::is_closed(cut));
    std::size_t borders = 0;
    for (const auto h : halfedges(cut))
      borders += is_border(h, cut);
    EXPECT_GE(borders, 6u);
    EXPECT_TRUE(std::all_of(vertices(cut).begin(), vertices(cut).end(),
                            [&](const auto v) { return !cut.is_isolated(v); }));
  }
}

// ===  The shared files

class Shared_cases : public Main_program_meshes
{
protected:
  void SetUp() override
  {
    if (std::string(SMF_SHARED_DIR).empty())
      GTEST_SKIP() << "there is no folder with shared meshes";
  }

  // what comes out with --repair: a graph, or one line that says why not
  Json repaired(const std::string& file) const
  {
    const auto result = run({file, "--repair", "--json"});
    if (result.exit_code == 0)
    {
      const Json json = Json::parse(result.output, nullptr, false);
      EXPECT_TRUE(json.is_object()) << result.output;
      expect_consistent_json(json);
      EXPECT_EQ(json["foliation"]["converged"], true);
      return json;
    }
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
    return Json();
  }
};

// numbers of parts, by the beginning of the name; 1 for all others
const std::map<std::string, std::size_t> parts_of_cases = {
  {"07", 11}, {"11", 2}, {"12", 6}, {"24", 3}};

TEST_F(Shared_cases, all_have_graphs_when_they_are_repaired)
{
  std::size_t number = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(SMF_SHARED_DIR) + "/cases"))
  {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() == ".md")
      continue;
    SCOPED_TRACE(name);
    ++number;
    const Json json = repaired(entry.path().string());
    ASSERT_TRUE(json.is_object());
    const auto parts = parts_of_cases.find(name.substr(0, 2));
    EXPECT_EQ(json["parts"].size(), parts == parts_of_cases.end() ? 1 : parts->second);
    for (const Json& part : json["parts"])
      EXPECT_FALSE(part.contains("error"));
  }
  EXPECT_GE(number, 27u);
}

TEST_F(Shared_cases, bad_meshes_have_graphs_or_reasons_when_they_are_repaired)
{
  std::size_t number = 0, number_of_graphs = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(SMF_SHARED_DIR) + "/bad_meshes"))
    if (entry.path().extension() == ".off")
    {
      SCOPED_TRACE(entry.path().filename().string());
      ++number;
      number_of_graphs += repaired(entry.path().string()).is_object();
    }
  EXPECT_GT(number, 50u);
  EXPECT_GT(number_of_graphs, 35u);
}

} // namespace

} // namespace test_main_program_meshes
