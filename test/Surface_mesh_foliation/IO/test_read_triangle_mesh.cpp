// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/temporary_folder.h"
#include "generators/meshes.h"
#include "include/test_models.h"
#include "include/tetrahedron_files.h"

#include <CGAL/Surface_mesh_foliation/IO/read_triangle_mesh.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace test_read_triangle_mesh {

// All formats with all that they may hold, read into all sorts of meshes in the order of the file.

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
using SMF::Triangle_soup;
using smf_test::Mesh;
using smf_test::ply_header;
using smf_test::replaced;
using smf_test::Sample;
using smf_test::sample_name;
using smf_test::tetrahedron_obj;
using smf_test::tetrahedron_off;
using smf_test::tetrahedron_ply;
using smf_test::tetrahedron_vertices;

// ===  Good files

class Good_file : public ::testing::TestWithParam<Sample>
{};

TEST_P(Good_file, is_read)
{
  const smf_test::Temporary_folder folder;
  const std::string file_name =
    folder.write(std::string("mesh") + GetParam().extension, GetParam().text);
  Mesh mesh;
  ASSERT_NO_THROW(SMF::read_triangle_mesh(file_name, mesh));
  EXPECT_EQ(num_vertices(mesh), 4u);
  EXPECT_EQ(num_faces(mesh), 4u);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  EXPECT_EQ(mesh.point(Mesh::Vertex_index(3)), Mesh::Point(0, 0, 1));
}

std::string with_line_ends(const std::string& text, const std::string& line_end)
{
  std::string result;
  for (const char c : text)
    result += c == '\n' ? line_end : std::string(1, c);
  return result;
}

std::vector<Sample> good_files()
{
  return {
    {"plain_off", ".off", tetrahedron_off},
    {"upper_case_extension", ".OFF", tetrahedron_off},
    {"carriage_returns", ".off", with_line_ends(tetrahedron_off, "\r\n")},
    {"no_final_line_end", ".off", tetrahedron_off.substr(0, tetrahedron_off.size() - 1)},
    {"counts_on_first_line", ".off", replaced(tetrahedron_off, "OFF\n", "OFF ")},
    {"no_edge_count", ".off", replaced(tetrahedron_off, "4 4 0\n", "4 4\n")},
    {"comments", ".off",
     "# a\n\nOFF# b\n" + replaced(tetrahedron_off, "OFF\n", "#c\n") + "\n  # end"},
    {"blanks_and_tabs", ".off", replaced(tetrahedron_off, "3 0 1 3", "  3\t0 1  3 \t")},
    {"face_colors", ".off", replaced(tetrahedron_off, "3 0 1 3", "3 0 1 3 0.5 .25 1 1e0")},
    {"vertex_colors", ".off", "C" + replaced(tetrahedron_off, "1 0 0\n", "1 0 0 255 0 0 255\n")},
    {"number_formats", ".off", replaced(tetrahedron_off, "1 0 0\n", "+1.0E+00 -0 .0\n")},
    {"subnormal_coordinate", ".off", replaced(tetrahedron_off, "1 0 0\n", "1 4.9e-324 0\n")},
    {"plain_obj", ".obj", tetrahedron_obj},
    {"obj_with_attributes", ".obj",
     "# x\nmtllib a.mtl\no part\nvt 0 0\nvn 0 0 1\ng a\nusemtl m\ns off\n" +
       replaced(tetrahedron_obj, "f 1 2 4", "f 1/1/1 2//1 4/1")},
    {"obj_with_negative_indices", ".obj", replaced(tetrahedron_obj, "f 1 2 4", "f -4 -3 -1")},
    {"obj_with_faces_first", ".obj", "f 1 3 2\n" + replaced(tetrahedron_obj, "f 1 3 2\n", "")},
    {"obj_with_colors", ".obj", replaced(tetrahedron_obj, "v 1 0 0", "v 1 0 0 0.5 0.5 0.5")},
    {"plain_ply", ".ply", tetrahedron_ply},
    {"ply_with_carriage_returns", ".ply", with_line_ends(tetrahedron_ply, "\r\n")},
    {"ply_with_comments", ".ply",
     replaced(tetrahedron_ply, "element vertex", "comment # a b\nobj_info c\nelement vertex")},
    {"ply_with_other_properties", ".ply",
     replaced(replaced(tetrahedron_ply, "property float y", "property uchar red\nproperty float y"),
              tetrahedron_vertices, "0 7 0 0\n1 7 0 0\n0 7 1 0\n0 7 0 1\n")},
    {"ply_with_other_elements", ".ply",
     replaced(tetrahedron_ply, "end_header\n",
              "element edge 1\nproperty list uchar int a\nproperty float b\nend_header\n") +
       "2 5 6 0.5\n"},
    {"ply_with_other_names_of_types", ".ply",
     replaced(
       replaced(tetrahedron_ply, "list uchar int vertex_indices", "list uint8 uint32 vertex_index"),
       "float x", "float64 x")},
  };
}

INSTANTIATE_TEST_SUITE_P(All, Good_file, ::testing::ValuesIn(good_files()), sample_name);

// ===  Order of vertices and faces

template <class TriangleMesh>
class Read_into_model : public ::testing::Test
{};

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Cartesian = CGAL::Simple_cartesian<double>;
using Models = ::testing::Types<smf_test::Surface_mesh_model<Epick>,
                                smf_test::Surface_mesh_model<Cartesian>,
                                smf_test::Surface_mesh_model<Epeck>,
                                smf_test::Polyhedron_model<Epick>,
                                smf_test::Polyhedron_model<Cartesian>,
                                smf_test::Linear_cell_complex_model<Epick>>;
TYPED_TEST_SUITE(Read_into_model, Models);

std::vector<Epick::Point_3> points_of(const Triangle_soup& soup)
{
  std::vector<Epick::Point_3> points;
  for (const auto& [x, y, z] : soup.points)
    points.emplace_back(x, y, z);
  return points;
}

Triangle_soup shuffled_soup()
{
  const Triangle_soup soup = smf_test::soups::genus_surface(5, 6);
  return smf_test::soups::relabeled(soup, smf_test::new_labels(soup.points.size(), 3), 4);
}

TYPED_TEST(Read_into_model, keeps_the_order_of_the_file)
{
  const smf_test::Temporary_folder folder;
  const std::string file_name = folder.file_name("mesh.off");
  const Triangle_soup soup = shuffled_soup();
  CGAL::IO::write_OFF(file_name, points_of(soup), soup.triangles,
                      CGAL::parameters::stream_precision(17));
  TypeParam mesh;
  SMF::read_triangle_mesh(file_name, mesh);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  EXPECT_TRUE(CGAL::is_closed(mesh));
  const Triangle_soup back = smf_test::to_soup(mesh);
  EXPECT_EQ(back.points, soup.points);
  EXPECT_EQ(back.triangles, soup.triangles);
}

TYPED_TEST(Read_into_model, is_linear_in_the_degree_of_a_vertex)
{
  const std::size_t n = 30000;
  Triangle_soup soup{{{0, 0, 1}, {0, 0, -1}}, {}};
  for (std::size_t i = 0; i < n; ++i)
  {
    const double angle = 2 * smf_test::soups::pi * static_cast<double>(i) / static_cast<double>(n);
    soup.points.push_back({std::cos(angle), std::sin(angle), 0});
    soup.triangles.push_back({0, 2 + i, 2 + (i + 1) % n});
    soup.triangles.push_back({1, 2 + (i + 1) % n, 2 + i});
  }
  TypeParam mesh;
  SMF::triangle_soup_to_triangle_mesh(soup, mesh);
  EXPECT_EQ(smf_test::to_soup(mesh).triangles, soup.triangles);
}

TEST(Read_triangle_mesh, all_formats_give_the_same_soup)
{
  const smf_test::Temporary_folder folder;
  const Triangle_soup soup = shuffled_soup();
  const std::vector<Epick::Point_3> points = points_of(soup);
  const auto digits = CGAL::parameters::stream_precision(17);
  CGAL::IO::write_OBJ(folder.file_name("a.obj"), points, soup.triangles, digits);
  CGAL::IO::write_PLY(folder.file_name("b.ply"), points, soup.triangles,
                      digits.use_binary_mode(false));
  CGAL::IO::write_PLY(folder.file_name("c.ply"), points, soup.triangles,
                      CGAL::parameters::use_binary_mode(true));
  for (const char* name : {"a.obj", "b.ply", "c.ply"})
  {
    const Triangle_soup back = SMF::read_triangle_soup(folder.file_name(name));
    EXPECT_EQ(back.points, soup.points) << name;
    EXPECT_EQ(back.triangles, soup.triangles) << name;
  }
}

TEST(Read_triangle_mesh, a_big_endian_file_is_read)
{
  const smf_test::Temporary_folder folder;
  std::string text = replaced(replaced(ply_header, "ascii", "binary_big_endian"), "float x",
                              "short x\nproperty uint a\nproperty list ushort char b");
  text = replaced(replaced(text, "float y", "short y"), "float z", "char z");
  for (const char* vertex : {"\0\0\0", "\0\1\0", "\1\0\0", "\0\0\1"})
  {
    text += std::string("\0", 1) + vertex[1];               // x
    text += std::string("\xff\xff\xff\xff\0\2\x80\x7f", 8); // a, and b of length 2
    text += std::string("\0", 1) + vertex[0] + vertex[2];   // y, z
  }
  for (const char* face : {"\0\2\1", "\0\1\3", "\1\2\3", "\0\3\2"})
  {
    text += '\3';
    for (int i = 0; i < 3; ++i)
      text += std::string("\0\0\0", 3) + face[i];
  }
  const Triangle_soup soup = SMF::read_triangle_soup(folder.write("a.ply", text));
  const Triangle_soup expected = SMF::read_triangle_soup(folder.write("b.off", tetrahedron_off));
  EXPECT_EQ(soup.points, expected.points);
  EXPECT_EQ(soup.triangles, expected.triangles);
}

// ===  What is required of the mesh

TEST(Read_triangle_mesh, points_go_only_to_the_given_map)
{
  using Mesh_without_points = CGAL::Surface_mesh<bool>;
  using Vertex = Mesh_without_points::Vertex_index;

  const smf_test::Temporary_folder folder;
  const std::string file_name = folder.write("a.off", tetrahedron_off);
  Mesh_without_points mesh;
  auto points = mesh.add_property_map<Vertex, Epeck::Point_3>("v:other").first;
  SMF::read_triangle_mesh(file_name, mesh, CGAL::parameters::vertex_point_map(points));
  EXPECT_EQ(points[Vertex(1)], Epeck::Point_3(1, 0, 0));
  EXPECT_EQ(points[Vertex(3)], Epeck::Point_3(0, 0, 1));
}

TEST(Read_triangle_mesh, a_mesh_that_is_not_empty_is_refused)
{
  const smf_test::Temporary_folder folder;
  const std::string file_name = folder.write("a.off", tetrahedron_off);
  Mesh mesh = smf_test::octahedron();
  EXPECT_THROW(SMF::read_triangle_mesh(file_name, mesh), SMF::Invalid_parameter_exception);
  EXPECT_EQ(num_vertices(mesh), 6u);

  Mesh mesh_with_removed_vertex;
  mesh_with_removed_vertex.remove_vertex(mesh_with_removed_vertex.add_vertex());
  EXPECT_THROW(SMF::read_triangle_mesh(file_name, mesh_with_removed_vertex),
               SMF::Invalid_parameter_exception);
}

} // namespace

} // namespace test_read_triangle_mesh
