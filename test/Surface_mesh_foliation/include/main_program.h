// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_MAIN_PROGRAM_H
#define SMF_TEST_MAIN_PROGRAM_H

#include "temporary_folder.h"
#include "generators/soups.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <sys/wait.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

// Runs the main program as its users do. SMF_MAIN_PROGRAM is its path.

namespace smf_test {

using Json = nlohmann::ordered_json;
using Arguments = std::vector<std::string>;

inline std::string quoted(const std::string& argument)
{
  std::string result = "'";
  for (const char c : argument)
    result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

inline std::string off_text(const Triangle_soup& soup)
{
  std::ostringstream text;
  text.precision(17);
  text << "OFF\n" << soup.points.size() << ' ' << soup.triangles.size() << " 0\n";
  for (const auto& p : soup.points)
    text << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for (const auto& [a, b, c] : soup.triangles)
    text << "3 " << a << ' ' << b << ' ' << c << '\n';
  return text.str();
}

struct Program_run
{
  int exit_code;
  std::string output, errors;
};

class Main_program : public ::testing::Test
{
protected:
  // `before` is put in front of the command, for the shell
  Program_run run(const Arguments& arguments, const std::string& before = "") const
  {
    const std::string output = folder.file_name("stdout"), errors = folder.file_name("stderr");
    std::string command = before + quoted(SMF_MAIN_PROGRAM);
    for (const std::string& argument : arguments)
      command += " " + quoted(argument);
    command += " >" + quoted(output) + " 2>" + quoted(errors);
    if (before.find('|') == std::string::npos)
      command += " </dev/null";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, file_text(output), file_text(errors)};
  }

  // the JSON of a run that must succeed
  Json json(Arguments arguments) const
  {
    arguments.push_back("--json");
    const Program_run result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_EQ(result.errors, "");
    Json parsed = Json::parse(result.output, nullptr, false); // nothing else may be there
    EXPECT_TRUE(parsed.is_object()) << result.output;
    return parsed;
  }

  // the message of a run that must fail: one line, with nothing on the standard output
  std::string error(const Arguments& arguments, const std::string& before = "") const
  {
    const Program_run result = run(arguments, before);
    EXPECT_EQ(result.exit_code, 1) << ::testing::PrintToString(arguments);
    EXPECT_EQ(result.output, "") << ::testing::PrintToString(arguments);
    EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
    EXPECT_TRUE(!result.errors.empty() && result.errors.back() == '\n') << result.errors;
    EXPECT_GT(result.errors.size(), 10u) << "it says what is wrong";
    return result.errors;
  }

  std::string write(const std::string& name, const Triangle_soup& soup) const
  {
    return folder.write(name, off_text(soup));
  }

  Temporary_folder folder;
};

// ===  What the JSON must be like, whatever the mesh

inline std::vector<std::string> keys(const Json& object)
{
  std::vector<std::string> result;
  for (const auto& entry : object.items())
    result.push_back(entry.key());
  return result;
}

inline void expect_keys(const Json& json)
{
  using Keys = std::vector<std::string>;
  EXPECT_EQ(keys(json),
            (Keys{"vertices", "faces", "repair", "openings", "parts", "genus", "poles",
                  "pole_significances", "detector", "loops", "found_loops", "foliation",
                  "singularities", "reeb_graph", "symmetries", "components", "seconds"}));
  EXPECT_EQ(keys(json["openings"]), (Keys{"ends", "filled"}));
  EXPECT_EQ(keys(json["foliation"]),
            (Keys{"solver", "energy", "optimality", "iterations", "converged", "certified"}));
  EXPECT_EQ(keys(json["singularities"]), (Keys{"center_poles", "thorn_poles", "saddles"}));
  EXPECT_EQ(keys(json["reeb_graph"]), (Keys{"nodes", "arcs", "cycles", "degrees"}));
  for (const Json& node : json["reeb_graph"]["nodes"])
    EXPECT_EQ(keys(node), (Keys{"id", "part", "kind", "pole", "genus", "degree", "point"}));
  for (const Json& arc : json["reeb_graph"]["arcs"])
    EXPECT_EQ(keys(arc), (Keys{"id", "part", "nodes", "loop", "height", "flux", "length", "area"}));
  EXPECT_EQ(keys(json["components"]), (Keys{"disks", "cylinders", "spheres"}));
  EXPECT_EQ(keys(json["seconds"]),
            (Keys{"read", "loops", "foliation", "extraction", "embedding", "total"}));
}

// of the mesh that have a graph
inline std::size_t number_of_parts(const Json& json)
{
  std::size_t result = 0;
  for (const Json& part : json["parts"])
    result += !part.contains("error");
  return result;
}

inline void expect_consistent_graph(const Json& json)
{
  std::size_t previous_loop = 0;
  const Json &nodes = json["reeb_graph"]["nodes"], &arcs = json["reeb_graph"]["arcs"];
  std::vector<std::size_t> degree(nodes.size(), 0);
  for (std::size_t a = 0; a < arcs.size(); ++a)
  {
    EXPECT_EQ(arcs[a]["id"], arcs[a]["loop"]);
    const std::size_t loop = arcs[a]["loop"];
    EXPECT_TRUE(json["parts"].size() == 1 ? loop == a : a == 0 || loop > previous_loop);
    previous_loop = loop;
    for (const Json& node : arcs[a]["nodes"])
      EXPECT_EQ(nodes.at(node.get<std::size_t>())["part"], arcs[a]["part"]);
    EXPECT_GT(arcs[a]["height"], 0);
    EXPECT_GT(arcs[a]["flux"], 0);
    EXPECT_GT(arcs[a]["length"], 0);
    ASSERT_EQ(arcs[a]["nodes"].size(), 2u);
    for (const Json& node : arcs[a]["nodes"])
      ++degree.at(node.get<std::size_t>()); // a self-arc counts twice
  }
  std::size_t genus_of_regions = 0;
  for (std::size_t r = 0; r < nodes.size(); ++r)
  {
    EXPECT_EQ(nodes[r]["id"], r);
    EXPECT_EQ(nodes[r]["degree"], degree[r]);
    EXPECT_EQ(nodes[r]["point"].size(), 3u);
    EXPECT_EQ(nodes[r]["kind"] == "pole" || nodes[r]["kind"] == "boundary", nodes[r]["pole"] >= 0);
    genus_of_regions += nodes[r]["genus"].get<std::size_t>();
  }
  std::sort(degree.begin(), degree.end());
  EXPECT_EQ(json["reeb_graph"]["degrees"], Json(degree));
  const std::size_t cycles = json["reeb_graph"]["cycles"];
  EXPECT_EQ(cycles, arcs.size() + number_of_parts(json) - nodes.size());
  EXPECT_EQ(cycles + genus_of_regions, json["genus"]);
}

inline void expect_consistent_json(const Json& json)
{
  expect_keys(json);
  expect_consistent_graph(json);
  const int parts = static_cast<int>(number_of_parts(json));
  const int euler_characteristic = 2 * parts - 2 * json["genus"].get<int>();
  const int ends = json["openings"]["ends"].get<int>();
  if (ends == 0 && json["openings"]["filled"] == 0)
  {
    int vertices = 0, faces = 0;
    for (const Json& part : json["parts"])
      if (!part.contains("error"))
      {
        vertices += part["vertices"].get<int>();
        faces += part["faces"].get<int>();
      }
    EXPECT_EQ(vertices - faces / 2, euler_characteristic);
  }
  int index = 2 * json["singularities"]["center_poles"].get<int>() +
              json["singularities"]["thorn_poles"].get<int>();
  for (const auto& [order, count] : json["singularities"]["saddles"].items())
    index -= std::stoi(order) * count.get<int>();
  int ends_of_graphs = 0;
  for (const Json& part : json["parts"])
    ends_of_graphs += part.contains("error") ? 0 : part["ends"].get<int>();
  EXPECT_EQ(index, 2 * (euler_characteristic - ends_of_graphs));
  const Json& components = json["components"];
  EXPECT_EQ(components["disks"].get<std::size_t>() + components["cylinders"].get<std::size_t>() +
              components["spheres"].get<std::size_t>(),
            json["reeb_graph"]["arcs"].size());
  EXPECT_EQ(components["disks"].get<std::size_t>() + 2 * components["spheres"].get<std::size_t>(),
            json["poles"].size() - static_cast<std::size_t>(ends));
  EXPECT_EQ(json["foliation"]["certified"], true);
  EXPECT_GT(json["foliation"]["energy"], 0);
  double sum = 0;
  for (const auto& [stage, seconds] : json["seconds"].items())
    sum += stage == "total" ? 0 : seconds.get<double>();
  EXPECT_NEAR(json["seconds"]["total"].get<double>(), sum, 0.1 + 0.1 * sum);
}

// a torus 12 x 8, whose vertex 8 i + j is the j-th around the tube
inline Triangle_soup torus_of_12_by_8()
{
  return soups::torus(12, 8, 3, 1);
}
inline const std::string around_the_tube = "cycle 0 1 2 3 4 5 6 7\n";

inline Json without_seconds(Json json)
{
  json.erase("seconds");
  return json;
}

} // namespace smf_test

#endif // SMF_TEST_MAIN_PROGRAM_H
