// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/example_systems.h"
#include "include/temporary_folder.h"

#include <CGAL/Surface_mesh_foliation/IO/arc_color.h>
#include <CGAL/Surface_mesh_foliation/IO/write_foliation.h>
#include <CGAL/Surface_mesh_foliation/IO/write_segments.h>
#include <CGAL/Surface_mesh_foliation/components.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/Kept_soup.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/all_vertices.h>

#include <CGAL/Surface_mesh/IO/PLY.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

namespace test_write_segments {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
namespace soups = smf_test::soups;
using smf_test::Mesh;
using smf_test::Solved_example;

TEST(Kept_soup, has_faces_and_their_vertices_in_order)
{
  const SMF::Triangle_soup soup = soups::icosphere(0);
  const SMF::internal::Kept_soup all(soup, [](int) { return true; });
  EXPECT_EQ(all.soup.points, soup.points);
  EXPECT_EQ(all.soup.triangles, soup.triangles);
  const SMF::internal::Kept_soup some(soup, [](int f) { return f == 3 || f == 7; });
  EXPECT_EQ(some.faces, (std::vector<int>{3, 7}));
  for (std::size_t i = 0; i < 2; ++i)
    for (int k : {0, 1, 2})
      EXPECT_EQ(some.soup.points[some.soup.triangles[i][k]],
                soup.points[soup.triangles[some.faces[i]][k]]);
  EXPECT_TRUE(std::is_sorted(some.vertices.begin(), some.vertices.end()));
  EXPECT_EQ(some.vertices.size(), some.soup.points.size());
  EXPECT_EQ(SMF::internal::Kept_soup::select(std::vector<int>{5, 6, 7, 8}, {1, 3}),
            (std::vector<int>{6, 8}));
}

TEST(All_vertices, are_those_of_the_mesh)
{
  const Mesh mesh = smf_test::to_mesh(soups::icosphere(1));
  EXPECT_EQ(SMF::internal::all_vertices(mesh),
            std::vector<Mesh::Vertex_index>(mesh.vertices_begin(), mesh.vertices_end()));
}

// on surfaces of several genera, with and without faces that are left out
TEST(Write_segments, labels_the_faces_of_the_mesh_itself)
{
  const smf_test::Temporary_folder folder;
  const std::string file = folder.file_name("a.ply");
  for (const auto& soup :
       {soups::limbed_sphere(4, 3), soups::torus(9, 7, 3, 1), soups::genus_surface(2)})
    for (const bool leaves_out : {false, true})
    {
      Mesh mesh = smf_test::to_mesh(soup);
      auto filled = mesh.add_property_map<Mesh::Face_index, bool>("f:filled", false).first;
      if (leaves_out)
        filled[Mesh::Face_index(5)] = true;
      SMF::Poles_and_loops<Mesh> input;
      for (const std::size_t v : {0, 20, 40})
        input.add_pole(smf_test::vertex(v));
      const auto foliation = SMF::harmonic_foliation(SMF::Loop_system<Mesh>(mesh, input));
      Mesh copy = mesh;
      const auto component =
        copy.add_property_map<Mesh::Face_index, std::size_t>("f:component", 0).first;
      SMF::face_segmentation(foliation, component);
      SMF::write_segments_ply(file, mesh, component, SMF::parameters::filled_face_map(filled));
      Mesh found;
      std::ifstream stream(file);
      std::string comments;
      ASSERT_TRUE(CGAL::IO::read_PLY(stream, found, comments));
      EXPECT_EQ(num_vertices(found), num_vertices(mesh));
      ASSERT_EQ(num_faces(found), num_faces(mesh) - leaves_out);
      // property_map() returns a pair in CGAL 5 and an optional in CGAL 6; this one finds it, too
      const auto [label, is_new] = found.add_property_map<Mesh::Face_index, int>("f:component");
      ASSERT_FALSE(is_new);
      auto f = faces(mesh).begin();
      for (const auto g : faces(found))
      {
        if (filled[*f])
          ++f;
        EXPECT_EQ(static_cast<std::size_t>(label[g]), component[*f++]);
      }
    }
}

TEST(Write_segments, refuses_what_is_no_triangle_mesh)
{
  const smf_test::Temporary_folder folder;
  Mesh mesh;
  const auto v = [&](double x, double y) { return mesh.add_vertex(Mesh::Point(x, y, 0)); };
  mesh.add_face(v(0, 0), v(1, 0), v(1, 1), v(0, 1));
  const auto label = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:label", 0).first;
  EXPECT_THROW(SMF::write_segments_ply(folder.file_name("a.ply"), mesh, label),
               SMF::Invalid_mesh_exception);
}

} // namespace

} // namespace test_write_segments
