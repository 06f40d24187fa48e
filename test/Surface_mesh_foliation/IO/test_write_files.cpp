// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/decimal_comma.h"
#include "include/example_systems.h"
#include "include/temporary_folder.h"

#include <CGAL/Surface_mesh_foliation/IO/arc_color.h>
#include <CGAL/Surface_mesh_foliation/IO/write_foliation.h>
#include <CGAL/Surface_mesh_foliation/IO/write_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/IO/write_swc.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>

#include <CGAL/Surface_mesh/IO/PLY.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <locale>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace test_write_files {

// What is written can be read again, and says what the foliation says.

namespace {

using smf_test::Example;
using smf_test::Mesh;
using smf_test::Solved_example;
namespace SMF = CGAL::Surface_mesh_foliation;

using Point = Mesh::Point;
using Graph = SMF::Reeb_graph<Point>;

// ===  A reader of ASCII PLY that knows no more than the format

struct Ply_element
{
  std::vector<std::string> properties;   // names; lists are given as "list"
  std::vector<std::vector<double>> rows; // lists: all numbers of the row
};

std::map<std::string, Ply_element> read_ply(const std::string& file_name)
{
  std::istringstream input(smf_test::file_text(file_name));
  input.imbue(std::locale::classic());
  std::map<std::string, Ply_element> result;
  std::vector<std::pair<std::string, std::size_t>> order;
  std::string line;
  std::getline(input, line);
  EXPECT_EQ(line, "ply");
  std::getline(input, line);
  EXPECT_EQ(line, "format ascii 1.0");
  while (std::getline(input, line) && line != "end_header")
  {
    std::istringstream words(line);
    std::string keyword, type, name;
    words >> keyword >> type;
    if (keyword == "element")
    {
      std::size_t number = 0;
      words >> number;
      order.emplace_back(type, number);
    }
    else if (keyword == "property")
    {
      while (words >> name)
        ;
      result[order.back().first].properties.push_back(name);
    }
    else
      EXPECT_EQ(keyword, "comment") << line;
  }
  EXPECT_EQ(line, "end_header");
  for (const auto& [name, number] : order)
    for (std::size_t i = 0; i < number; ++i)
    {
      EXPECT_TRUE(std::getline(input, line)) << "too few rows of " << name;
      std::istringstream words(line);
      words.imbue(std::locale::classic());
      std::vector<double> row;
      for (std::string word; words >> word;)
        row.push_back(std::strtod(word.c_str(), nullptr));
      result[name].rows.push_back(row);
    }
  while (std::getline(input, line))
    EXPECT_EQ(line, "") << "after the last row";
  return result;
}

std::size_t column(const Ply_element& element, const std::string& name)
{
  for (std::size_t i = 0; i < element.properties.size(); ++i)
    if (element.properties[i] == name)
      return i;
  ADD_FAILURE() << "no property " << name;
  return 0;
}

Point point(const std::vector<double>& row)
{
  return Point(row.at(0), row.at(1), row.at(2));
}

// ===  All files of an example

class Files_of_example : public ::testing::TestWithParam<Example>
{
protected:
  Files_of_example()
    : example(GetParam()),
      embedding(SMF::reeb_graph_embedding(example.foliation, SMF::parameters::number_of_samples(4)))
  {
    SMF::reeb_graph(example.foliation, graph, embedding);
  }

  std::string file(const std::string& name) const { return folder.file_name(name); }

  smf_test::Temporary_folder folder;
  Solved_example<> example;
  SMF::Reeb_graph_embedding<Point> embedding;
  Graph graph;
};

INSTANTIATE_TEST_SUITE_P(Examples,
                         Files_of_example,
                         ::testing::ValuesIn(smf_test::example_systems()),
                         smf_test::name_of_example);

TEST_P(Files_of_example, components)
{
  SMF::write_components_ply(file("components.ply"), example.foliation);
  Mesh expected, read;
  const auto component = expected.add_property_map<Mesh::Face_index, std::size_t>("f:c").first;
  SMF::surface_components(example.foliation, expected,
                          SMF::parameters::face_component_map(component));
  std::ifstream input(file("components.ply"));
  std::string comments;
  ASSERT_TRUE(CGAL::IO::read_PLY(input, read, comments));
  ASSERT_EQ(num_vertices(read), num_vertices(expected));
  ASSERT_EQ(num_faces(read), num_faces(expected));
  EXPECT_TRUE(CGAL::is_closed(read));
  for (const auto v : vertices(expected))
    EXPECT_EQ(read.point(v), expected.point(v)) << "17 digits give every number back";
  // adding returns the maps that were read
  const auto map = read.add_property_map<Mesh::Face_index, int>("f:component", -1).first;
  const auto colors = read.add_property_map<Mesh::Face_index, CGAL::IO::Color>("f:color").first;
  std::map<int, std::set<int>> colors_of_component;
  for (const auto f : faces(expected))
  {
    const int found = map[f];
    EXPECT_EQ(found, static_cast<int>(component[f]));
    const CGAL::IO::Color color = colors[f];
    EXPECT_EQ(color, SMF::arc_color(component[f]));
    colors_of_component[found].insert((color.red() * 256 + color.green()) * 256 + color.blue());
  }
  std::set<int> all;
  for (const auto& entry : colors_of_component)
  {
    EXPECT_EQ(entry.second.size(), 1u) << "one color per component";
    all.insert(entry.second.begin(), entry.second.end());
  }
  EXPECT_EQ(all.size(), example.system.number_of_arcs()) << "neighbors can be told apart";
}

TEST_P(Files_of_example, foliation)
{
  SMF::write_foliation_ply(file("foliation.ply"), example.foliation);
  auto ply = read_ply(file("foliation.ply"));
  const Ply_element &vertex = ply["vertex"], &face = ply["face"];
  ASSERT_EQ(vertex.rows.size(), num_vertices(*example.mesh));
  ASSERT_EQ(face.rows.size(), num_faces(*example.mesh));
  const std::size_t arc = column(vertex, "arc"), t = column(vertex, "t");
  for (const auto v : vertices(*example.mesh))
  {
    const auto cell = example.foliation.cell(v);
    ASSERT_EQ(vertex.rows[v].size(), vertex.properties.size());
    EXPECT_EQ(point(vertex.rows[v]), example.mesh->point(v));
    EXPECT_EQ(vertex.rows[v][arc], cell.is_arc ? static_cast<double>(cell.index) : -1);
    EXPECT_EQ(vertex.rows[v][t], example.foliation.parameter(v));
  }
  const smf_test::Triangle_soup soup = smf_test::to_soup(*example.mesh);
  for (std::size_t f = 0; f < face.rows.size(); ++f)
  {
    std::set<double> corners(face.rows[f].begin() + 1, face.rows[f].end());
    EXPECT_EQ(corners, std::set<double>(soup.triangles[f].begin(), soup.triangles[f].end()));
  }
}

TEST_P(Files_of_example, skeleton)
{
  SMF::write_skeleton_ply(file("skeleton.ply"), graph);
  auto ply = read_ply(file("skeleton.ply"));
  const Ply_element &vertex = ply["vertex"], &edge = ply["edge"];
  std::vector<Point> points;
  std::vector<std::array<double, 3>> point_properties; // radius, arc, node
  std::vector<std::pair<double, double>> properties;   // of the edges: arc and height
  for (const auto& e : boost::make_iterator_range(edges(graph)))
  {
    points.insert(points.end(), graph[e].polyline.begin(), graph[e].polyline.end());
    for (const double radius : graph[e].radii)
      point_properties.push_back({radius, static_cast<double>(graph[e].loop), -1});
    point_properties[point_properties.size() - graph[e].radii.size()][2] = source(e, graph);
    point_properties.back()[2] = target(e, graph);
    for (std::size_t i = 1; i < graph[e].polyline.size(); ++i)
      properties.emplace_back(graph[e].loop, graph[e].height);
  }
  ASSERT_EQ(vertex.rows.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_EQ(point(vertex.rows[i]), points[i]);
    EXPECT_EQ(vertex.rows[i][column(vertex, "radius")], point_properties.at(i)[0]);
    EXPECT_EQ(vertex.rows[i][column(vertex, "arc")], point_properties[i][1]);
    EXPECT_EQ(vertex.rows[i][column(vertex, "node")], point_properties[i][2]);
  }
  ASSERT_EQ(edge.rows.size(), properties.size());
  const std::size_t arc = column(edge, "arc"), height = column(edge, "height");
  for (std::size_t i = 0; i < edge.rows.size(); ++i)
  {
    EXPECT_EQ(edge.rows[i][arc], properties[i].first);
    EXPECT_EQ(edge.rows[i][height], properties[i].second);
    EXPECT_EQ(edge.rows[i][1], edge.rows[i][0] + 1);
    EXPECT_LT(edge.rows[i][1], static_cast<double>(points.size()));
  }
}

// A tree for each part of the graph: numbers ascend, each point comes after the one before it, and
// the segments are those of the arcs.
TEST_P(Files_of_example, swc)
{
  SMF::write_skeleton_swc(file("skeleton.swc"), graph);
  std::ifstream input(file("skeleton.swc"));
  std::string line;
  ASSERT_TRUE(std::getline(input, line));
  EXPECT_EQ(line[0], '#');
  std::vector<Point> points(1);
  std::size_t number_of_roots = 0, number_of_ends = 0;
  std::multiset<std::pair<Point, Point>> segments, expected;
  int number = 0, type = 0, previous = 0;
  for (double x = 0, y = 0, z = 0, radius = 0;
       input >> number >> type >> x >> y >> z >> radius >> previous;)
  {
    ASSERT_EQ(number, static_cast<int>(points.size()));
    ASSERT_LT(previous, number);
    EXPECT_GE(radius, 0);
    points.emplace_back(x, y, z);
    number_of_roots += previous == -1;
    number_of_ends += type == 6;
    if (previous > 0)
      segments.insert(std::minmax(points[previous], points.back()));
  }
  std::size_t expected_ends = 0;
  for (const auto v : boost::make_iterator_range(vertices(graph)))
    expected_ends += degree(v, graph) == 1;
  for (const auto& e : boost::make_iterator_range(edges(graph)))
    for (std::size_t i = 1; i < graph[e].polyline.size(); ++i)
      expected.insert(std::minmax(graph[e].polyline[i - 1], graph[e].polyline[i]));
  EXPECT_EQ(number_of_roots, 1u);
  EXPECT_EQ(number_of_ends, expected_ends);
  EXPECT_TRUE(segments == expected);
}

// from point to point, and the properties arc and node
using Segment = std::tuple<Point, Point, double, double>;

void add_segments(const std::vector<Point>& polyline,
                  double arc,
                  double node,
                  std::vector<Segment>& segments)
{
  for (std::size_t i = 1; i < polyline.size(); ++i)
    segments.emplace_back(polyline[i - 1], polyline[i], arc, node);
}

TEST_P(Files_of_example, leaves)
{
  SMF::write_leaves_ply(file("leaves.ply"), example.foliation, embedding);
  auto ply = read_ply(file("leaves.ply"));
  const Ply_element &vertex = ply["vertex"], &edge = ply["edge"];
  const std::size_t arc = column(edge, "arc"), node = column(edge, "node");
  std::vector<Segment> found, expected;
  for (const std::vector<double>& row : edge.rows)
  {
    const auto end = [&](int i) {
      return point(vertex.rows.at(static_cast<std::size_t>(row.at(i))));
    };
    found.emplace_back(end(0), end(1), row.at(arc), row.at(node));
  }
  std::vector<SMF::Critical_polyline<Point>> polylines;
  SMF::critical_leaves(example.foliation, std::back_inserter(polylines));
  for (const auto& polyline : polylines)
    add_segments(polyline.points, -1, static_cast<double>(polyline.node), expected);
  for (std::size_t a = 0; a < embedding.levels.size(); ++a)
    for (const double level : embedding.levels[a])
      add_segments(SMF::leaf(example.foliation, a, level), static_cast<double>(a), -1, expected);
  std::sort(found.begin(), found.end());
  std::sort(expected.begin(), expected.end());
  EXPECT_TRUE(found == expected);
}

// ===  Failures

using Writer = std::function<void(const std::string&)>;

std::vector<Writer> all_writers(const Solved_example<>& example, const Graph& graph)
{
  const auto& foliation = example.foliation;
  return {[&](const std::string& file) { SMF::write_components_ply(file, foliation); },
          [&](const std::string& file) { SMF::write_foliation_ply(file, foliation); },
          [&](const std::string& file) {
            SMF::write_leaves_ply(file, foliation, SMF::reeb_graph_embedding(foliation));
          },
          [&](const std::string& file) { SMF::write_skeleton_ply(file, graph); },
          [&](const std::string& file) { SMF::write_reeb_graph_dot(file, graph); },
          [&](const std::string& file) { SMF::write_reeb_graph_graphml(file, graph); }};
}

TEST(Failures, are_reported)
{
  const smf_test::Temporary_folder folder;
  const Solved_example<> example(smf_test::dumbbell_example());
  Graph graph;
  SMF::reeb_graph(example.foliation, graph);
  for (const Writer& write : all_writers(example, graph))
    for (const std::string& name :
         {folder.file_name("missing/file"), folder.file_name("."), std::string("/dev/full")})
    {
      if (name == "/dev/full" && !std::filesystem::exists(name))
        continue;
      try
      {
        write(name);
        ADD_FAILURE() << name << " was written";
      }
      catch (const SMF::Invalid_file_exception& exception)
      {
        EXPECT_EQ(exception.problem().kind, SMF::Problem_kind::FILE);
        EXPECT_EQ(std::string(exception.what()).rfind(name, 0), 0u) << exception.what();
      }
    }
}

TEST(Locale, does_not_matter)
{
  const smf_test::Temporary_folder folder;
  Example with_digits = smf_test::dumbbell_example();
  with_digits.items[0].height = 1234.5;
  const Solved_example<> example(with_digits);
  Graph graph;
  SMF::reeb_graph(example.foliation, graph);
  std::size_t number = 0;
  for (const Writer& write : all_writers(example, graph))
  {
    const std::string name = folder.file_name(std::to_string(number++));
    write(name);
    const std::string expected = smf_test::file_text(name);
    const std::locale before =
      std::locale::global(std::locale(std::locale(), new smf_test::Decimal_comma));
    write(name);
    std::locale::global(before);
    EXPECT_TRUE(smf_test::file_text(name) == expected) << "writer " << number;
  }
}

} // namespace

} // namespace test_write_files
