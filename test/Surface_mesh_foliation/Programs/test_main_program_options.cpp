// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the options of the main program do.

#include "generators/genus_soups.h"
#include "generators/openings.h"
#include "generators/revolution.h"
#include "include/main_program.h"

#include <CGAL/Surface_mesh_foliation/version.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace test_main_program_options {

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

class Main_program_options : public Main_program
{};

TEST_F(Main_program_options, weights)
{
  const std::string mesh = write("sphere.off", soups::icosphere(3));
  const Arguments poles = {mesh, "--pole", "0", "--pole", "1", "--pole", "2"};
  const auto with = [&](const std::string& weights) {
    Arguments arguments = poles;
    arguments.insert(arguments.end(), {"--weights", weights});
    return arguments;
  };
  EXPECT_EQ(without_seconds(json(with("mean-value"))), without_seconds(json(poles)));
  const Json cotangent = json(with("cotangent"));
  EXPECT_EQ(cotangent["foliation"]["converged"], true);
  EXPECT_NE(cotangent["foliation"]["energy"], json(poles)["foliation"]["energy"]);
  error(with("uniform"));
  error(with(""));
  const std::string rough = write("rough.off", soups::noisy(soups::genus_surface(1, 3), 0.3, 2));
  EXPECT_NE(error({rough, "--pole", "0", "--weights", "cotangent"}).find("weight"),
            std::string::npos);
}

TEST_F(Main_program_options, tolerance_and_iterations)
{
  const auto soup = soups::limbed_sphere(6, 4);
  Arguments poles = {write("limbs.off", soup)};
  for (const std::size_t tip : soups::limb_tips(6, 4))
    poles.insert(poles.end(), {"--pole", std::to_string(tip)});
  const auto with = [&](const std::string& option, const std::string& value) {
    Arguments arguments = poles;
    arguments.insert(arguments.end(), {option, value});
    return arguments;
  };
  const int all = json(poles)["foliation"]["iterations"];
  ASSERT_GT(all, 1);
  for (const int n : {0, 1, all - 1, all})
  {
    const Json result = json(with("--max-iterations", std::to_string(n)));
    expect_consistent_json(result);
    EXPECT_GE(result["foliation"]["iterations"], n); // more if there were folds
    EXPECT_EQ(result["foliation"]["converged"], result["foliation"]["iterations"] == all);
  }
  const Json coarse = json(with("--tolerance", "0.5"));
  EXPECT_EQ(coarse["foliation"]["converged"], true);
  EXPECT_LT(coarse["foliation"]["iterations"], all);
  for (const char* bad : {"0", "-1", "x", "nan", ""})
    error(with("--tolerance", bad));
  for (const char* bad : {"-1", "1.5", "x", "99999999999999999999", ""})
    error(with("--max-iterations", bad));
}

TEST_F(Main_program_options, both_solvers_find_the_same_foliation)
{
  const std::string mesh = write("torus.off", torus_of_12_by_8());
  const Arguments arguments = {mesh, "--pole", "50", "--pole", "11"};
  const Json newton = json(arguments);
  for (const char* relaxation : {"1", "1.8"})
  {
    Arguments others = arguments;
    others.insert(others.end(), {"--solver", "whitehead", "--relaxation", relaxation});
    const Json whitehead = json(others);
    expect_consistent_json(whitehead);
    EXPECT_EQ(whitehead["foliation"]["solver"], "whitehead");
    EXPECT_EQ(whitehead["foliation"]["converged"], true);
    const double energy = newton["foliation"]["energy"];
    EXPECT_NEAR(whitehead["foliation"]["energy"].get<double>() / energy, 1, 1e-9);
    EXPECT_EQ(whitehead["reeb_graph"]["degrees"], newton["reeb_graph"]["degrees"]);
  }
  for (const char* bad : {"0", "2", "-1", "x"})
  {
    Arguments others = arguments;
    others.insert(others.end(), {"--solver", "whitehead", "--relaxation", bad});
    error(others);
  }
}

TEST_F(Main_program_options, one_iteration_is_enough_for_a_result)
{
  const std::string mesh = write("torus.off", torus_of_12_by_8());
  const std::string loops = folder.write("loops", around_the_tube);
  for (const Arguments& system : {Arguments{"--loops", loops}, Arguments{"--pole", "50"},
                                  Arguments{"--loops", loops, "--pole", "50", "--pole", "11"}})
  {
    Arguments arguments = system;
    arguments.insert(arguments.end(), {mesh, "--max-iterations", "1"});
    const Json result = json(arguments);
    expect_consistent_json(result);
    EXPECT_EQ(result["foliation"]["converged"], result["foliation"]["optimality"] < 1e-12);
    EXPECT_LE(result["foliation"]["iterations"], 3);
  }
}

TEST_F(Main_program_options, heights)
{
  const std::string mesh = write("sphere.off", soups::icosphere(2));
  const Arguments poles = {mesh, "--pole", "0", "--pole", "1", "--pole", "2"};
  const auto with = [&](const Arguments& more) {
    Arguments arguments = poles;
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  };
  const Json two = json(with({"--height", "2"})), one = json(with({"--heights", "1,1,1"}));
  for (std::size_t a = 0; a < 3; ++a)
    EXPECT_EQ(two["reeb_graph"]["arcs"][a]["height"], 2);
  const double energy = one["foliation"]["energy"];
  EXPECT_NEAR(two["foliation"]["energy"].get<double>(), 4 * energy, 1e-9 * energy);
  EXPECT_NE(error(with({"--heights", "1,2"})).find("3"), std::string::npos) << "for 3 loops";
  error(with({"--heights", "1,2,3,4"}));
  error(with({"--heights", "1,0,3"}));
  error(with({"--heights", "1,nan,3"}));
  error(with({"--heights", "1,x,3"}));
  error(with({"--heights", "1,1,1", "--height", "1"}));
  error(with({"--height", "0"}));
  error(with({"--height", "-3"}));
  error(with({"--height", "inf"}));
}

TEST_F(Main_program_options, output_for_people_and_for_nobody)
{
  const Arguments arguments = {
    write("sphere.off", soups::icosphere(2)), "--pole", "0", "--pole", "1", "--pole", "2"};
  const Program_run table = run(arguments);
  EXPECT_EQ(table.exit_code, 0);
  EXPECT_EQ(table.errors, "");
  EXPECT_NE(table.output.find("162"), std::string::npos);
  EXPECT_FALSE(Json::accept(table.output));
  Arguments quiet = arguments;
  quiet.push_back("--quiet");
  const Program_run silence = run(quiet);
  EXPECT_EQ(silence.exit_code, 0);
  EXPECT_EQ(silence.output + silence.errors, "");
  expect_consistent_json(json(quiet));
  const Program_run help = run({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  for (const std::string option :
       {"--help",      "--pole",           "--pole-at",    "--pole-line",  "--borders",
        "--loops",     "--auto-poles",     "--pole-lines", "--auto-loops", "--min-loop-length",
        "--height",    "--heights",        "--weights",    "--solver",     "--relaxation",
        "--tolerance", "--max-iterations", "--output",     "--json",       "--quiet",
        "--detail",    "--star",           "--symmetry",   "--version"})
    EXPECT_NE(help.output.find(option + ' '), std::string::npos) << option;
  const Program_run version = run({"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_EQ(version.output, "Surface_mesh_foliation " CGAL_SURFACE_MESH_FOLIATION_VERSION "\n");
}

// A tube with two limbs at each end.
TEST_F(Main_program_options, canonical_loops_of_any_detail)
{
  const auto [soup, ends] = soups::capsule(5, 36);
  const std::string mesh = write("capsule.off", soup);
  Arguments poles = {mesh};
  for (const std::size_t v : ends)
    poles.insert(poles.end(), {"--pole", std::to_string(v)});
  const auto with = [&](const Arguments& more) {
    Arguments arguments = poles;
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Json result = json(arguments);
    expect_consistent_json(result);
    return result;
  };
  const std::vector<std::size_t> star = {1, 1, 1, 1, 4}, tree = {1, 1, 1, 1, 3, 3};
  EXPECT_EQ(with({})["reeb_graph"]["degrees"], star); // poles are given, so nothing is found
  const Json result = with({"--detail", "0.6"});
  EXPECT_EQ(result["reeb_graph"]["degrees"], tree);
  ASSERT_EQ(result["found_loops"].size(), 1u);
  const Json& loop = result["found_loops"][0];
  EXPECT_EQ(loop["loop"], 4);
  EXPECT_GT(loop["modulus"], 0.8);
  EXPECT_EQ(loop["near_bound"], false);
  EXPECT_EQ(loop["separating"], true);
  EXPECT_EQ(loop["completing"], false);
  EXPECT_GT(loop["margin"], 1.3);
  EXPECT_EQ(with({"--detail", "5"})["reeb_graph"]["degrees"], star);
  EXPECT_NE(
    run({mesh, "--pole", std::to_string(ends[0]), "--pole", std::to_string(ends[1]), "--pole",
         std::to_string(ends[2]), "--pole", std::to_string(ends[3]), "--detail", "0.5"})
      .output.find("modulus"),
    std::string::npos);
  error({mesh, "--detail", "-1"});
  error({mesh, "--detail", "1", "--star"});
  error({mesh, "--detail", "1", "--auto-loops"});
  error({mesh, "--detail", "1", "--min-loop-length", "1"});
}

TEST_F(Main_program_options, star_or_canonical_graph_of_a_bare_mesh)
{
  // two bodies with three limbs each, far apart on a bar
  auto soup = soups::icosphere(4);
  for (auto& p : soup.points)
  {
    double height = 0;
    for (const double angle : {0., 2.1, 4.2})
    {
      const double x = std::abs(p[0]) - 0.7, y = p[1] - 0.7 * std::cos(angle),
                   z = p[2] - 0.7 * std::sin(angle);
      height += 2.5 * std::exp(-(x * x + y * y + z * z) / 0.03);
    }
    for (double& coordinate : p)
      coordinate *= 1 + height;
    p[0] += p[0] > 0 ? 6 * std::min(1., p[0] / 0.4) : -6 * std::min(1., -p[0] / 0.4);
  }
  const std::string mesh = write("two.off", soup);
  const Json canonical = json({mesh}), star = json({mesh, "--star"});
  expect_consistent_json(canonical);
  EXPECT_EQ(canonical["detector"], "average geodesic distance");
  EXPECT_EQ(canonical["poles"], star["poles"]);
  ASSERT_EQ(canonical["pole_significances"].size(), canonical["poles"].size());
  EXPECT_EQ(canonical["poles"].size(), 6u);
  EXPECT_TRUE(canonical["pole_significances"][0].is_null()); // needed in any case
  EXPECT_GT(canonical["pole_significances"][5], 0.18);
  EXPECT_EQ(star["reeb_graph"]["degrees"], (std::vector<std::size_t>{1, 1, 1, 1, 1, 1, 6}));
  EXPECT_EQ(canonical["reeb_graph"]["degrees"], (std::vector<std::size_t>{1, 1, 1, 1, 1, 1, 4, 4}));
}

TEST_F(Main_program_options, openings_are_ends_or_filled)
{
  const std::string mesh =
    write("bowl.off", soups::part_below(soups::icosphere(3), 2, 0.3)); // with one opening
  const auto openings = [&](const Arguments& more) {
    Arguments arguments = {mesh};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Json result = json(arguments);
    expect_consistent_json(result);
    return result;
  };
  for (const Arguments& arguments : {Arguments(), {"--borders", "ends"}, {"--borders", "1"}})
  {
    const Json result = openings(arguments);
    EXPECT_EQ(result["openings"]["ends"], 1);
    EXPECT_EQ(result["openings"]["filled"], 0);
    EXPECT_EQ(result["reeb_graph"]["nodes"][0]["kind"], "boundary");
  }
  for (const std::string length : {"fill", "100"})
  {
    const Json result = openings({"--borders", length});
    EXPECT_EQ(result["openings"]["ends"], 0);
    EXPECT_EQ(result["openings"]["filled"], 1);
    for (const Json& node : result["reeb_graph"]["nodes"])
      EXPECT_NE(node["kind"], "boundary");
  }
}

} // namespace

} // namespace test_main_program_options
