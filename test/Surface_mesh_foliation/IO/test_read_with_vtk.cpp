// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "generators/genus_soups.h"
#include "generators/meshes.h"
#include "include/temporary_folder.h"

#include <CGAL/Surface_mesh_foliation/IO/read_with_vtk.h>
#include <CGAL/Surface_mesh_foliation/IO/write_vtp.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace test_read_with_vtk {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
namespace soups = smf_test::soups;
using Faces = std::vector<std::vector<std::size_t>>;

std::string data_array(const std::string& attributes, const std::string& values)
{
  return "<DataArray " + attributes + " format=\"ascii\">" + values + "</DataArray>\n";
}

// a grid of 8 points with cells of the given types
std::string vtu(const Faces& cells, const std::vector<int>& types)
{
  std::string connectivity, offsets, type_text;
  std::size_t offset = 0;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    for (const std::size_t v : cells[i])
      connectivity += std::to_string(v) + ' ';
    offset += cells[i].size();
    offsets += std::to_string(offset) + ' ';
    type_text += std::to_string(types[i]) + ' ';
  }
  return "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
         "<UnstructuredGrid>\n<Piece NumberOfPoints=\"8\" NumberOfCells=\"" +
         std::to_string(cells.size()) + "\">\n<Points>" +
         data_array("type=\"Float64\" NumberOfComponents=\"3\"",
                    "0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1") +
         "</Points>\n<Cells>" + data_array("type=\"Int32\" Name=\"connectivity\"", connectivity) +
         data_array("type=\"Int32\" Name=\"offsets\"", offsets) +
         data_array("type=\"UInt8\" Name=\"types\"", type_text) +
         "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

constexpr int vertex = 1, line = 3, triangle = 5, strip = 6, polygon = 7, pixel = 8, quad = 9,
              tetrahedron = 10;

TEST(Read_with_vtk, what_we_write)
{
  const smf_test::Temporary_folder folder;
  const std::string file = folder.file_name("a.vtp");
  for (const auto& soup :
       {soups::limbed_sphere(3, 3), soups::torus(8, 6, 3, 1), soups::genus_surface(2)})
  {
    const auto mesh = smf_test::to_mesh(soup);
    SMF::Poles_and_loops<smf_test::Mesh> input;
    input.add_pole(smf_test::vertex(0));
    input.add_pole(smf_test::vertex(20));
    SMF::write_foliation_vtp(
      file, SMF::harmonic_foliation(SMF::Loop_system<smf_test::Mesh>(mesh, input)));
    const SMF::Polygon_soup found = SMF::read_polygon_soup_with_vtk(file);
    EXPECT_EQ(found.points, soup.points);
    EXPECT_EQ(SMF::polygon_soup_to_triangle_soup(found).triangles,
              smf_test::to_soup(mesh).triangles);
  }
}

TEST(Read_with_vtk, cells_of_all_kinds)
{
  const smf_test::Temporary_folder folder;
  const SMF::Polygon_soup soup = SMF::read_polygon_soup_with_vtk(folder.write(
    "a.vtu",
    vtu({{0}, {0, 1}, {0, 1, 2}, {0, 1, 2, 3, 4}, {0, 1, 2, 3, 7}, {0, 1, 3, 2}, {4, 5, 6, 7}},
        {vertex, line, triangle, strip, polygon, pixel, quad})));
  EXPECT_EQ(soup.points.size(), 8u);
  EXPECT_EQ(soup.points[6], (std::array<double, 3>{1, 1, 1}));
  EXPECT_EQ(
    soup.polygons,
    (Faces{
      {0, 1, 2}, {0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {0, 1, 2, 3, 7}, {0, 1, 2, 3}, {4, 5, 6, 7}}));
  EXPECT_THROW(SMF::polygon_soup_to_triangle_soup(soup), SMF::Invalid_mesh_exception);
}

TEST(Read_with_vtk, refuses_what_it_cannot_read)
{
  const smf_test::Temporary_folder folder;
  const std::string good = vtu({{0, 1, 2}}, {triangle});
  ASSERT_NO_THROW(SMF::read_polygon_soup_with_vtk(folder.write("good.vtu", good)));
  for (const std::string& file : {folder.file_name("none.vtp"), folder.write("text.vtp", "hello"),
                                  folder.write("short.vtu", good.substr(0, good.size() / 2)),
                                  folder.write("volume.vtu", vtu({{0, 1, 2, 4}}, {tetrahedron}))})
    EXPECT_THROW(SMF::read_polygon_soup_with_vtk(file), SMF::Invalid_file_exception) << file;
}

} // namespace

} // namespace test_read_with_vtk
