// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "generators/genus_soups.h"
#include "include/main_program.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

namespace test_main_program {

namespace {

using smf_test::Arguments;
using smf_test::around_the_tube;
using smf_test::expect_consistent_json;
using smf_test::Json;
using smf_test::Main_program;
using smf_test::Program_run;
using smf_test::torus_of_12_by_8;
using smf_test::without_seconds;
namespace soups = smf_test::soups;

// ===  Results

TEST_F(Main_program, star_of_poles)
{
  const auto soup = soups::limbed_sphere(5, 4);
  Arguments arguments = {write("limbs.off", soup)};
  std::vector<std::vector<std::size_t>> poles;
  for (const std::size_t tip : soups::limb_tips(5, 4))
  {
    arguments.insert(arguments.end(), {"--pole", std::to_string(tip)});
    poles.push_back({tip});
  }
  const Json result = json(arguments);
  expect_consistent_json(result);
  EXPECT_EQ(result["vertices"], soup.points.size());
  EXPECT_EQ(result["faces"], soup.triangles.size());
  EXPECT_EQ(result["genus"], 0);
  EXPECT_EQ(result["poles"], Json(poles));
  EXPECT_EQ(result["loops"], 5);
  EXPECT_EQ(result["foliation"]["solver"], "newton");
  EXPECT_EQ(result["foliation"]["converged"], true);
  EXPECT_LT(result["foliation"]["optimality"], 1e-12);
  EXPECT_EQ(result["reeb_graph"]["degrees"], Json({1, 1, 1, 1, 1, 5}));
  EXPECT_EQ(result["components"]["disks"], 5);
  EXPECT_EQ(result["singularities"]["center_poles"], 5);
  for (std::size_t p = 0; p < 5; ++p) // poles stay where they are
    EXPECT_EQ(result["reeb_graph"]["nodes"][p]["point"], Json(soup.points[poles[p][0]]));
}

TEST_F(Main_program, ids_go_from_poles_to_lines_to_the_file)
{
  const std::string mesh = write("torus.off", torus_of_12_by_8());
  const std::string loops =
    folder.write("loops", "# two of them\n" + around_the_tube + "plane 1 0 0 0.2 72\n");
  // options in another order than the ids
  const Json result = json({"--loops", loops, "--heights", "1,2.5,3,0.25,7", "--pole-line",
                            "27,35,43", "--pole", "90", mesh, "--pole", "20"});
  expect_consistent_json(result);
  EXPECT_EQ(result["genus"], 1);
  EXPECT_EQ(result["loops"], 5);
  EXPECT_EQ(result["poles"], Json({{90}, {20}, {27, 35, 43}}));
  const std::vector<double> heights = {1, 2.5, 3, 0.25, 7};
  for (std::size_t a = 0; a < 5; ++a)
    EXPECT_EQ(result["reeb_graph"]["arcs"][a]["height"], heights[a]);
  EXPECT_EQ(result["singularities"]["center_poles"], 2);
  EXPECT_EQ(result["singularities"]["thorn_poles"], 2);
  EXPECT_EQ(result["reeb_graph"]["cycles"], 1);
}

TEST_F(Main_program, sphere_with_two_poles_and_torus_without)
{
  const Json sphere = json(
    {write("sphere.off", soups::icosphere(2)), "--pole", "0", "--pole", "3", "--height", "1.5"});
  expect_consistent_json(sphere);
  EXPECT_EQ(sphere["loops"], 2);
  EXPECT_EQ(sphere["reeb_graph"]["arcs"].size(), 1u);
  EXPECT_EQ(sphere["reeb_graph"]["arcs"][0]["height"], 3);
  EXPECT_EQ(sphere["components"]["spheres"], 1);
  EXPECT_TRUE(sphere["singularities"]["saddles"].empty());
  const Json plain = json(
    {write("torus.off", torus_of_12_by_8()), "--loops", folder.write("loops", around_the_tube)});
  expect_consistent_json(plain);
  EXPECT_EQ(plain["reeb_graph"]["nodes"][0]["kind"], "regular");
  EXPECT_EQ(plain["reeb_graph"]["degrees"], Json({2}));
  EXPECT_EQ(plain["poles"], Json::array());
}

TEST_F(Main_program, poles_at_positions_are_the_nearest_vertices)
{
  const auto soup = soups::icosphere(2);
  const std::string mesh = write("sphere.off", soup);
  const auto position_near = [&](std::size_t vertex) {
    std::string result;
    for (const double coordinate : soup.points[vertex])
      result += (result.empty() ? "" : ",") + std::to_string(1.01 * coordinate);
    return result;
  };
  const Json result =
    json({mesh, "--pole-at=" + position_near(7), "--pole", "3", "--pole-at", position_near(100)});
  expect_consistent_json(result);
  EXPECT_EQ(result["poles"], Json({{3}, {7}, {100}}));
  // all vertices of an octahedron have the same distance from its center
  const std::string octahedron = write("octahedron.off", soups::octahedron());
  EXPECT_EQ(json({octahedron, "--pole-at", "0,0,0", "--pole", "1"})["poles"], Json({{1}, {0}}));
  EXPECT_EQ(json({octahedron, "--pole-at", "-1,0,0", "--pole-at", "1e-9,+0,.0"})["poles"],
            Json({{1}, {0}}));
  EXPECT_NE(error({octahedron, "--pole", "0", "--pole-at", "9,0,0"}).find("vertex 0 belongs to"),
            std::string::npos);
}

TEST_F(Main_program, genus_in_a_region)
{
  const Json result =
    json({write("plate.off", soups::genus_surface(3, 2)), "--pole", "0", "--pole", "9"});
  expect_consistent_json(result);
  EXPECT_EQ(result["genus"], 3);
  EXPECT_EQ(result["reeb_graph"]["cycles"], 0);
  EXPECT_EQ(result["reeb_graph"]["nodes"][2]["genus"], 3);
}

TEST_F(Main_program, poles_and_loops_that_are_found)
{
  const std::string limbs = write("limbs.off", soups::limbed_sphere(4, 3));
  const Json star = json({limbs});
  expect_consistent_json(star);
  EXPECT_EQ(star["reeb_graph"]["degrees"], Json({1, 1, 1, 1, 4}));
  EXPECT_EQ(star["poles"], json({limbs, "--auto-poles"})["poles"]);
  const Json three = json({limbs, "--auto-poles", "3"});
  EXPECT_EQ(three["poles"].size(), 3u);
  const std::string found = star["poles"][0][0].dump();
  EXPECT_EQ(json({limbs, "--pole", found, "--auto-poles"})["poles"], star["poles"]);

  const std::string plate = write("plate.off", soups::genus_surface(3, 2));
  const Json cycles = json({plate, "--auto-loops"});
  expect_consistent_json(cycles);
  EXPECT_EQ(cycles["poles"].size(), 0u);
  EXPECT_EQ(cycles["reeb_graph"]["cycles"], 3);
  EXPECT_EQ(json({plate, "--auto-loops", "--pole", "5"})["reeb_graph"]["cycles"], 3);
  EXPECT_EQ(json({plate})["reeb_graph"]["cycles"], 3);
  const Json filled = json({plate, "--pole", "5", "--auto-loops", "--min-loop-length", "1e3"});
  EXPECT_EQ(filled["reeb_graph"]["cycles"], 0);
  EXPECT_EQ(filled["reeb_graph"]["nodes"][1]["genus"], 3);
}

// A disk thin enough to be a blade: its rim becomes a line pole, where no other pole is found.
TEST_F(Main_program, lines_that_are_found)
{
  auto soup = soups::limbed_sphere(5, 4);
  const std::string limbs = write("limbs.off", soup);
  EXPECT_EQ(json({limbs, "--pole-lines", "auto", "--auto-poles"})["poles"],
            json({limbs, "--auto-poles"})["poles"]);
  soup = soups::icosphere(4);
  for (auto& p : soup.points)
    p = {p[0] < 0 ? p[0] : 3 * p[0], p[1], p[0] < 0 ? p[2] : p[2] * std::exp(-6 * p[0])};
  const std::string blade = write("blade.off", soup);
  const Json with_lines = json({blade, "--pole-lines", "auto", "--pole", "1"});
  std::size_t lines = 0;
  for (const auto& pole : with_lines["poles"])
    lines += pole.size() > 1 ? 1 : 0;
  EXPECT_EQ(lines, 1u);
  EXPECT_EQ(with_lines["singularities"]["thorn_poles"], 2);
}

TEST_F(Main_program, meshes_of_cgal_with_nothing_else)
{
  const std::string meshes = SMF_DATA_DIR;
  if (meshes.empty())
    GTEST_SKIP() << "needs CGAL's meshes";
  const Json hand = json({meshes + "/hand.off"});
  EXPECT_EQ(hand["reeb_graph"]["degrees"], Json({1, 1, 1, 3})) << "a fist, its thumb and its wrist";
  const Json elephant = json({meshes + "/elephant.off"});
  EXPECT_EQ(elephant["reeb_graph"]["cycles"], 3);
  const std::size_t poles = elephant["poles"].size();
  const Json& degrees = elephant["reeb_graph"]["degrees"];
  EXPECT_GE(poles, 6u) << "legs, trunk and tail at least";
  EXPECT_EQ(static_cast<std::size_t>(std::count(degrees.begin(), degrees.end(), 1)), poles);
}

TEST_F(Main_program, vertex_indices_are_positions_in_the_file)
{
  const auto soup = soups::noisy(soups::icosphere(3), 0.2, 4);
  const auto labels = smf_test::Random(8).permutation(soup.points.size());
  const auto other = soups::relabeled(soup, labels, 9);
  Arguments first = {write("first.off", soup)}, second = {write("second.off", other)};
  for (const std::size_t pole : {5, 77, 300, 640})
  {
    first.insert(first.end(), {"--pole", std::to_string(pole)});
    second.insert(second.end(), {"--pole", std::to_string(labels[pole])});
  }
  const Json one = json(first), two = json(second);
  for (std::size_t a = 0; a < 4; ++a)
  {
    const double flux = one["reeb_graph"]["arcs"][a]["flux"];
    EXPECT_NEAR(two["reeb_graph"]["arcs"][a]["flux"].get<double>(), flux, 1e-9 * flux);
    EXPECT_EQ(two["reeb_graph"]["nodes"][a]["point"], one["reeb_graph"]["nodes"][a]["point"]);
  }
}

TEST_F(Main_program, is_deterministic)
{
  const Arguments arguments = {write("plate.off", soups::genus_surface(2, 3)), "--pole", "17"};
  EXPECT_EQ(without_seconds(json(arguments)), without_seconds(json(arguments)));
}

// ===  Files

TEST_F(Main_program, output_files)
{
  const auto soup = soups::genus_surface(2, 2);
  const std::string output = folder.file_name("a new/folder");
  const Json result =
    json({write("plate.off", soup), "--pole", "0", "--pole", "50", "--output", output});
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(output))
  {
    names.insert(entry.path().filename().string());
    EXPECT_GT(entry.file_size(), 100u) << entry.path();
  }
  EXPECT_EQ(names,
            (std::set<std::string>{"components.ply", "components.vtp", "foliation.ply",
                                   "foliation.vtp", "leaves.ply", "leaves.vtp", "reeb_graph.dot",
                                   "reeb_graph.graphml", "segments.ply", "singularities.vtp",
                                   "skeleton.ply", "skeleton.swc", "skeleton.vtp"}));
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  for (const std::string name : {"foliation.ply", "components.ply", "segments.ply"})
  {
    Mesh mesh;
    std::ifstream input(output + "/" + name);
    std::string comments;
    ASSERT_TRUE(CGAL::IO::read_PLY(input, mesh, comments)) << name;
    ASSERT_GE(num_vertices(mesh), soup.points.size());
    for (std::size_t v = 0; v < soup.points.size(); ++v)
    {
      const auto& p = mesh.point(Mesh::Vertex_index(static_cast<Mesh::size_type>(v)));
      EXPECT_EQ((soups::Point{p.x(), p.y(), p.z()}), soup.points[v]) << "17 digits";
    }
    EXPECT_TRUE(CGAL::is_closed(mesh));
    EXPECT_EQ(num_faces(mesh) == soup.triangles.size(), name != "components.ply");
  }
  EXPECT_EQ(smf_test::file_text(output + "/skeleton.ply").rfind("ply\n", 0), 0u);
  EXPECT_EQ(smf_test::file_text(output + "/reeb_graph.dot").rfind("graph G {", 0), 0u);
  const std::string flux = result["reeb_graph"]["arcs"][0]["flux"].dump();
  EXPECT_NE(smf_test::file_text(output + "/reeb_graph.graphml").find(flux.substr(0, 12)),
            std::string::npos);
}

TEST_F(Main_program, output_that_cannot_be_written)
{
  const std::string mesh = write("sphere.off", soups::icosphere(1));
  const std::string file = folder.write("file", "");
  const Arguments arguments = {mesh, "--pole", "0", "--pole", "1", "--json", "--output"};
  for (const std::string& bad : {file, file + "/folder", std::string("/proc/folder")})
  {
    Arguments with_output = arguments;
    with_output.push_back(bad);
    EXPECT_NE(error(with_output).find(bad), std::string::npos) << "it says where";
  }
}

} // namespace

} // namespace test_main_program
