// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_VTP_FILE_H
#define SMF_TEST_VTP_FILE_H

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace smf_test {

// What a .vtp file says, read by someone who knows no more than the format.
struct Vtp_file
{
  using Numbers = std::vector<double>;
  using Cells = std::vector<std::vector<std::size_t>>; // the points of each

  std::vector<std::array<double, 3>> points;
  Cells vertices, lines, polygons;
  std::map<std::string, Numbers> point_arrays, cell_arrays;
  std::map<std::string, std::string> types; // of the arrays

  explicit Vtp_file(const std::string& file_name)
  {
    boost::property_tree::ptree tree;
    boost::property_tree::read_xml(file_name, tree);
    const Tree& file = tree.get_child("VTKFile");
    EXPECT_EQ(file.get<std::string>("<xmlattr>.type"), "PolyData");
    EXPECT_EQ(file.get<std::string>("<xmlattr>.byte_order"), "LittleEndian");
    EXPECT_EQ(file.get_child("PolyData").count("Piece"), 1u);
    const Tree& piece = file.get_child("PolyData.Piece");
    const Numbers coordinates = numbers(piece.get_child("Points.DataArray"));
    EXPECT_EQ(piece.get<int>("Points.DataArray.<xmlattr>.NumberOfComponents"), 3);
    EXPECT_EQ(coordinates.size() % 3, 0u);
    for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3)
      points.push_back({coordinates[i], coordinates[i + 1], coordinates[i + 2]});
    vertices = cells(piece.get_child("Verts"));
    lines = cells(piece.get_child("Lines"));
    polygons = cells(piece.get_child("Polys"));
    const auto count = [&](const char* what) {
      return piece.get<std::size_t>(std::string("<xmlattr>.NumberOf") + what);
    };
    EXPECT_EQ(points.size(), count("Points"));
    EXPECT_EQ(vertices.size(), count("Verts"));
    EXPECT_EQ(lines.size(), count("Lines"));
    EXPECT_EQ(polygons.size(), count("Polys"));
    EXPECT_EQ(count("Strips"), 0u);
    read_arrays(piece.get_child("PointData"), points.size(), point_arrays);
    read_arrays(piece.get_child("CellData"), vertices.size() + lines.size() + polygons.size(),
                cell_arrays);
  }

private:
  using Tree = boost::property_tree::ptree;

  static Numbers numbers(const Tree& array)
  {
    EXPECT_EQ(array.get<std::string>("<xmlattr>.format"), "ascii");
    Numbers result;
    std::istringstream words(array.data());
    for (std::string word; words >> word;)
    {
      char* end = nullptr;
      result.push_back(std::strtod(word.c_str(), &end));
      EXPECT_EQ(*end, '\0') << word;
    }
    return result;
  }

  Cells cells(const Tree& tree) const
  {
    Numbers connectivity, offsets;
    for (const auto& [tag, array] : tree)
      (array.get<std::string>("<xmlattr>.Name") == "offsets" ? offsets : connectivity) =
        numbers(array);
    Cells result;
    std::size_t begin = 0;
    for (const double offset : offsets)
    {
      result.emplace_back();
      for (; begin < static_cast<std::size_t>(offset); ++begin)
      {
        result.back().push_back(static_cast<std::size_t>(connectivity.at(begin)));
        EXPECT_LT(result.back().back(), points.size());
      }
    }
    EXPECT_EQ(begin, connectivity.size());
    return result;
  }

  void read_arrays(const Tree& tree, std::size_t size, std::map<std::string, Numbers>& arrays)
  {
    for (const auto& [tag, array] : tree)
    {
      const auto name = array.get<std::string>("<xmlattr>.Name");
      arrays[name] = numbers(array);
      EXPECT_EQ(arrays[name].size(), size) << name;
      types[name] = array.get<std::string>("<xmlattr>.type");
    }
  }
};

} // namespace smf_test

#endif // SMF_TEST_VTP_FILE_H
