// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/stl_files.h"
#include "include/temporary_folder.h"

#include <CGAL/Surface_mesh_foliation/IO/polygon_soup.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace test_read_polygon_soup {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
using Faces = std::vector<std::vector<std::size_t>>;

// a house: a quadrangle and a pentagon, and faces that only a soup may have
const Faces house = {{0, 1, 2, 3}, {0, 1, 4, 2, 3}, {1, 4, 2}, {2, 2, 3}, {0, 4}};
const std::string points = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n1 2 0.5\n";

std::string lines(const std::string& begin, bool has_count, std::size_t first_index)
{
  std::string result;
  for (const auto& face : house)
  {
    result += begin + (has_count ? std::to_string(face.size()) : "");
    for (const std::size_t v : face)
      result += ' ' + std::to_string(v + first_index);
    result += '\n';
  }
  return result;
}

TEST(Read_polygon_soup, of_each_format)
{
  const smf_test::Temporary_folder folder;
  std::string obj_points = "v " + points;
  for (std::size_t i = 0; (i = obj_points.find('\n', i)) + 1 < obj_points.size(); i += 3)
    obj_points.insert(i + 1, "v ");
  const std::vector<std::string> files = {
    folder.write("a.off", "OFF\n5 5 0\n" + points + lines("", true, 0)),
    folder.write("a.obj", obj_points + lines("f", false, 1)),
    folder.write("a.ply", "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\n"
                          "property float y\nproperty float z\nelement face 5\n"
                          "property list uchar int vertex_indices\nend_header\n" +
                            points + lines("", true, 0))};
  for (const std::string& file : files)
  {
    const SMF::Polygon_soup soup = SMF::read_polygon_soup(file);
    EXPECT_EQ(soup.points.size(), 5u) << file;
    EXPECT_EQ(soup.points[4], (std::array<double, 3>{1, 2, 0.5})) << file;
    EXPECT_EQ(soup.polygons, house) << file;
    EXPECT_THROW(SMF::read_triangle_soup(file), SMF::Invalid_mesh_exception) << file;
  }
}

TEST(Read_polygon_soup, of_stl_with_a_face_without_area)
{
  const smf_test::Temporary_folder folder;
  auto corners = smf_test::tetrahedron_stl_corners();
  corners.push_back({corners[0][0], corners[0][0], corners[0][1]});
  for (const std::string& text : {smf_test::ascii_stl(corners), smf_test::binary_stl(corners, "")})
  {
    const std::string file = folder.write("a.stl", text);
    const SMF::Polygon_soup soup = SMF::read_polygon_soup(file);
    EXPECT_EQ(soup.points.size(), 4u);
    ASSERT_EQ(soup.polygons.size(), 5u);
    EXPECT_EQ(soup.polygons[4], (std::vector<std::size_t>{0, 0, 1}));
    EXPECT_THROW(SMF::read_triangle_soup(file), SMF::Invalid_mesh_exception);
  }
}

TEST(Read_polygon_soup, from_a_stream)
{
  std::istringstream stream("OFF\n5 5 0\n" + points + lines("", true, 0));
  EXPECT_EQ(SMF::read_polygon_soup(stream, "off").polygons, house);
  EXPECT_THROW(SMF::read_polygon_soup(stream, "step"), SMF::Invalid_parameter_exception);
}

TEST(Polygon_soup_to_triangle_soup, refuses_what_is_no_triangle)
{
  SMF::Polygon_soup soup;
  soup.points.resize(4);
  soup.polygons = {{0, 1, 2}, {3, 2, 1}};
  EXPECT_EQ(SMF::polygon_soup_to_triangle_soup(soup).triangles[1],
            (std::array<std::size_t, 3>{3, 2, 1}));
  for (const std::vector<std::size_t>& face : Faces{{0, 1}, {0, 1, 2, 3}, {0, 1, 0}})
  {
    soup.polygons[1] = face;
    try
    {
      SMF::polygon_soup_to_triangle_soup(soup);
      ADD_FAILURE() << "not refused";
    }
    catch (const SMF::Invalid_mesh_exception& exception)
    {
      EXPECT_EQ(exception.problem().kind, SMF::Problem_kind::NOT_TRIANGLE_MESH);
      EXPECT_EQ(exception.problem().faces, std::vector<std::size_t>{1});
    }
  }
}

TEST(Read_polygon_soup, refuses_what_is_no_polygon)
{
  const smf_test::Temporary_folder folder;
  for (const std::string face : {"-1 0", "3 0 1", "3 0 1 5", "3 0 1 -1", "3 0 1 x", "1e9 0 1 2"})
    EXPECT_THROW(
      SMF::read_polygon_soup(folder.write("a.off", "OFF\n5 1 0\n" + points + face + "\n")),
      SMF::Invalid_file_exception)
      << face;
  EXPECT_THROW(SMF::read_polygon_soup(folder.write("a.obj", "v 0 0 0\nf 1 1 2\n")),
               SMF::Invalid_file_exception);
}

} // namespace

} // namespace test_read_polygon_soup
