// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_PICTURES_SCENE_H
#define SMF_PICTURES_SCENE_H

#include "Vector.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

// The elements of an ASCII PLY file by name; each has the names of its properties, and its rows of
// numbers. A list is its length followed by its entries, so it must come first in its element.
struct Ply_element
{
  std::vector<std::string> properties;
  std::vector<std::vector<double>> rows;

  std::size_t column(const std::string& property) const
  {
    const auto it = std::find(properties.begin(), properties.end(), property);
    if (it == properties.end())
      throw std::runtime_error("a PLY file has no property " + property);
    return static_cast<std::size_t>(it - properties.begin());
  }
};

inline std::map<std::string, Ply_element> read_ply(const std::string& file_name)
{
  std::ifstream input(file_name);
  std::map<std::string, Ply_element> result;
  std::vector<std::string> order; // of the elements
  for (std::string line; std::getline(input, line) && line != "end_header";)
  {
    std::istringstream words(line);
    std::string keyword, word, last;
    words >> keyword >> word;
    for (last = word; words >> word;)
      last = word;
    if (keyword == "element")
    {
      order.push_back(line.substr(8, line.find_last_of(' ') - 8));
      result[order.back()].rows.resize(std::stoul(last));
    }
    else if (keyword == "property")
      result[order.back()].properties.push_back(last);
  }
  for (const std::string& name : order)
    for (std::vector<double>& row : result[name].rows)
    {
      std::string line;
      std::getline(input, line);
      std::istringstream words(line);
      for (double number; words >> number;)
        row.push_back(number);
    }
  if (!input)
    throw std::runtime_error(file_name + " cannot be read");
  return result;
}

inline std::vector<Vector> points_of(const Ply_element& vertices)
{
  std::vector<Vector> result;
  for (const std::vector<double>& row : vertices.rows)
    result.push_back({row.at(0), row.at(1), row.at(2)});
  return result;
}

// A colored triangle mesh with normals at its vertices.
struct Surface
{
  std::vector<Vector> points, normals;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<Vector> colors; // of the triangles
};

inline void compute_normals(Surface& surface)
{
  surface.normals.assign(surface.points.size(), Vector());
  for (const auto& triangle : surface.triangles)
  {
    const Vector &a = surface.points[triangle[0]], &b = surface.points[triangle[1]],
                 &c = surface.points[triangle[2]];
    for (std::size_t v : triangle)
      surface.normals[v] = surface.normals[v] + cross(b - a, c - a);
  }
  for (Vector& normal : surface.normals)
    normal = unit(normal);
}

inline Surface read_surface(const std::string& file_name)
{
  const auto ply = read_ply(file_name);
  const Ply_element& faces = ply.at("face");
  Surface result;
  result.points = points_of(ply.at("vertex"));
  const std::size_t red = faces.column("red") + 3; // behind the three corners
  for (const std::vector<double>& row : faces.rows)
  {
    result.triangles.push_back({static_cast<std::size_t>(row.at(1)),
                                static_cast<std::size_t>(row.at(2)),
                                static_cast<std::size_t>(row.at(3))});
    result.colors.push_back(1. / 255 * Vector{row.at(red), row.at(red + 1), row.at(red + 2)});
  }
  compute_normals(result);
  return result;
}

// The coordinates of components, in the order of the faces of a surface.
struct Coordinates
{
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<std::array<std::array<double, 2>, 3>> corners; // u and v, by face
  std::vector<int> components;                               // by face; -1: none
  std::map<int, double> circumferences;
};

// Brings texture coordinates back to u and v.
struct Chart
{
  std::array<double, 2> origin, scale;
  std::array<double, 2> uv(double x, double y) const
  {
    return {(x - origin[0]) / scale[0], (y - origin[1]) / scale[1]};
  }
};

// The charts by component, from the comments of the file, which also tell the circumferences.
inline std::map<int, Chart> read_charts(const std::string& file_name,
                                        std::map<int, double>& circumferences)
{
  std::map<int, Chart> result;
  std::ifstream input(file_name);
  for (std::string line; std::getline(input, line) && line != "end_header";)
  {
    std::istringstream words(line);
    std::string comment, component, height, circumference, origin, scale;
    int a;
    double k, c;
    Chart chart;
    if (words >> comment >> component >> a >> height >> k >> circumference >> c >> origin >>
        chart.origin[0] >> chart.origin[1] >> scale >> chart.scale[0] >> chart.scale[1])
    {
      circumferences[a] = c;
      result[a] = chart;
    }
  }
  return result;
}

inline Coordinates read_coordinates(const std::string& file_name)
{
  Coordinates result;
  const std::map<int, Chart> charts = read_charts(file_name, result.circumferences);
  const auto ply = read_ply(file_name);
  for (const std::vector<double>& row : ply.at("face").rows) // 3 a b c 6 x y x y x y component
  {
    result.triangles.push_back({static_cast<std::size_t>(row.at(1)),
                                static_cast<std::size_t>(row.at(2)),
                                static_cast<std::size_t>(row.at(3))});
    const int component = static_cast<int>(row.at(11));
    result.components.push_back(component);
    result.corners.emplace_back();
    for (int i = 0; i < 3 && component >= 0; ++i)
      result.corners.back()[i] = charts.at(component).uv(row.at(5 + 2 * i), row.at(6 + 2 * i));
  }
  return result;
}

// Segments, each with a number (or 0), and points without segment.
struct Polylines
{
  std::vector<Vector> points;
  std::vector<std::array<std::size_t, 2>> segments;
  std::vector<int> arcs, nodes; // of the segments
  std::vector<std::size_t> isolated;
};

inline Polylines read_polylines(const std::string& file_name)
{
  const auto ply = read_ply(file_name);
  const Ply_element& edges = ply.at("edge");
  Polylines result;
  result.points = points_of(ply.at("vertex"));
  std::vector<bool> is_isolated(result.points.size(), true);
  const auto number = [&](const std::vector<double>& row, const char* name) {
    const auto& names = edges.properties;
    return std::find(names.begin(), names.end(), name) == names.end()
             ? 0
             : static_cast<int>(row.at(edges.column(name)));
  };
  for (const std::vector<double>& row : edges.rows)
  {
    result.segments.push_back(
      {static_cast<std::size_t>(row.at(0)), static_cast<std::size_t>(row.at(1))});
    result.arcs.push_back(number(row, "arc"));
    result.nodes.push_back(number(row, "node"));
    for (std::size_t v : result.segments.back())
      is_isolated.at(v) = false;
  }
  for (std::size_t v = 0; v < is_isolated.size(); ++v)
    if (is_isolated[v])
      result.isolated.push_back(v);
  return result;
}

// A node of a Reeb graph.
struct Node
{
  bool is_pole = false;
  Vector point;
};

// The nodes of a file reeb_graph.graphml that the package wrote: one attribute per line.
inline std::vector<Node> read_nodes(const std::string& file_name)
{
  std::ifstream input(file_name);
  if (!input)
    throw std::runtime_error(file_name + " cannot be read");
  std::vector<Node> result;
  for (std::string line; std::getline(input, line);)
  {
    const auto value_of = [&](const std::string& key) {
      const std::string begin = "<data key=\"" + key + "\">";
      const std::size_t at = line.find(begin);
      return at == std::string::npos
               ? std::string()
               : line.substr(at + begin.size(), line.find("</data>") - at - begin.size());
    };
    if (line.find("<node ") != std::string::npos)
      result.push_back({});
    if (value_of("node_kind") == "pole")
      result.back().is_pole = true;
    if (!value_of("node_x").empty())
      result.back().point.x = std::stod(value_of("node_x"));
    if (!value_of("node_y").empty())
      result.back().point.y = std::stod(value_of("node_y"));
    if (!value_of("node_z").empty())
      result.back().point.z = std::stod(value_of("node_z"));
  }
  return result;
}

#endif // SMF_PICTURES_SCENE_H
