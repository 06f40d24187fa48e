// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Files with the coordinates of components, read back.

#include "include/each_foliation.h"
#include "include/example_systems.h"
#include "include/temporary_folder.h"
#include "generators/meshes.h"
#include "include/uv_mesh.h"

#include <CGAL/Surface_mesh_foliation/Component_coordinates.h>
#include <CGAL/Surface_mesh_foliation/IO/write_component_coordinates.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace test_write_component_coordinates {

namespace {

using smf_test::Each_foliation;
using smf_test::Mesh;
using smf_test::Solved_example;
using smf_test::Uv;
using smf_test::Uv_mesh;
namespace SMF = CGAL::Surface_mesh_foliation;

using Point = Mesh::Point;
using Coordinates = SMF::Component_coordinates<Mesh>;

class Written_coordinates : public Each_foliation
{};

INSTANTIATE_TEST_SUITE_P(Examples,
                         Written_coordinates,
                         ::testing::ValuesIn(smf_test::all_example_systems()),
                         smf_test::name_of_example);

// the texture coordinates that a corner must have
Uv texture_of(const Uv_mesh& uv_mesh, const Coordinates& coordinates, Mesh::Halfedge_index h)
{
  return coordinates.texture_chart(uv_mesh.component[face(h, uv_mesh.mesh)])(uv_mesh.uv[h]);
}

// what was read of an OBJ file, and whether its faces are those of a mesh
struct Obj
{
  explicit Obj(const Coordinates& with_coordinates) : coordinates(with_coordinates) {}

  // the corners of a face as words
  void expect_face(std::istringstream& words, const Uv_mesh& uv_mesh, Mesh::Face_index f) const
  {
    const bool has_uv = uv_mesh.has_coordinates(f);
    EXPECT_EQ(group, has_uv ? "component_" + std::to_string(uv_mesh.component[f]) : "none");
    auto h = prev(halfedge(f, uv_mesh.mesh), uv_mesh.mesh);
    std::string word;
    for (; words >> word; h = next(h, uv_mesh.mesh))
    {
      const std::size_t slash = word.find('/');
      EXPECT_EQ(points.at(std::stoul(word) - 1), uv_mesh.mesh.point(target(h, uv_mesh.mesh)));
      ASSERT_EQ(slash != std::string::npos, has_uv);
      if (has_uv)
      {
        EXPECT_EQ(uvs.at(std::stoul(word.substr(slash + 1)) - 1),
                  texture_of(uv_mesh, coordinates, h));
      }
    }
  }

  const Coordinates& coordinates;
  std::vector<Point> points;
  std::vector<Uv> uvs;
  std::string group;
};

} // namespace

TEST_P(Written_coordinates, coordinates_in_obj)
{
  const smf_test::Temporary_folder folder;
  const Coordinates coordinates(foliation);
  const Uv_mesh uv_mesh(coordinates);
  SMF::write_component_coordinates_obj(folder.file_name("uv.obj"), coordinates);
  std::istringstream file(smf_test::file_text(folder.file_name("uv.obj")));
  // sorted by component; those without coordinates come last
  std::vector<Mesh::Face_index> sorted(faces(uv_mesh.mesh).begin(), faces(uv_mesh.mesh).end());
  const auto group_of = [&](Mesh::Face_index f) {
    return uv_mesh.has_coordinates(f) ? uv_mesh.component[f] : system.number_of_arcs();
  };
  std::stable_sort(sorted.begin(), sorted.end(), [&](Mesh::Face_index f, Mesh::Face_index g) {
    return group_of(f) < group_of(g);
  });
  Obj obj(coordinates);
  std::vector<std::string> groups;
  std::string line;
  auto f = sorted.begin();
  while (std::getline(file, line))
  {
    std::istringstream words(line);
    std::string keyword;
    words >> keyword;
    double x = 0, y = 0, z = 0;
    if (keyword == "v" && words >> x >> y >> z)
      obj.points.emplace_back(x, y, z);
    else if (keyword == "vt" && words >> x >> y)
      obj.uvs.push_back({x, y});
    else if (keyword == "g")
    {
      words >> obj.group;
      groups.push_back(obj.group);
    }
    else
    {
      ASSERT_EQ(keyword, "f");
      ASSERT_NE(f, sorted.end());
      obj.expect_face(words, uv_mesh, *f++);
    }
  }
  EXPECT_EQ(f, sorted.end());
  const bool has_faces_at_nodes = group_of(sorted.back()) == system.number_of_arcs();
  ASSERT_EQ(groups.size(), system.number_of_arcs() + has_faces_at_nodes) << "one per component";
  for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
    EXPECT_EQ(groups[a], "component_" + std::to_string(a));
  EXPECT_LT(obj.uvs.size(), 3 * num_faces(uv_mesh.mesh)); // shared where there is no seam
}

TEST_P(Written_coordinates, coordinates_in_ply)
{
  const smf_test::Temporary_folder folder;
  const Coordinates coordinates(foliation);
  const Uv_mesh uv_mesh(coordinates);
  SMF::write_component_coordinates_ply(folder.file_name("uv.ply"), coordinates);
  std::istringstream file(smf_test::file_text(folder.file_name("uv.ply")));
  std::string line;
  while (std::getline(file, line) && line != "end_header")
    ;
  std::vector<Point> points;
  for (std::size_t i = 0; i < num_vertices(uv_mesh.mesh); ++i)
  {
    double x = 0, y = 0, z = 0;
    file >> x >> y >> z;
    points.emplace_back(x, y, z);
  }
  for (const auto f : faces(uv_mesh.mesh))
  {
    int number = 0, component = 0;
    std::array<std::size_t, 3> corners = {};
    std::array<Uv, 3> uvs = {};
    file >> number >> corners[0] >> corners[1] >> corners[2];
    EXPECT_EQ(number, 3);
    file >> number;
    EXPECT_EQ(number, 6);
    for (Uv& uv : uvs)
      file >> uv[0] >> uv[1];
    file >> component;
    ASSERT_TRUE(file);
    EXPECT_EQ(component, uv_mesh.has_coordinates(f) ? static_cast<int>(uv_mesh.component[f]) : -1);
    auto h = prev(halfedge(f, uv_mesh.mesh), uv_mesh.mesh);
    for (std::size_t i : {0, 1, 2})
    {
      EXPECT_EQ(points.at(corners[i]), uv_mesh.mesh.point(target(h, uv_mesh.mesh)));
      EXPECT_EQ(uvs[i],
                uv_mesh.has_coordinates(f) ? texture_of(uv_mesh, coordinates, h) : (Uv{0, 0}));
      h = next(h, uv_mesh.mesh);
    }
  }
  int rest = 0;
  EXPECT_FALSE(file >> rest);
}

TEST(Write_component_coordinates, cannot_be_written_where_there_is_no_folder)
{
  const smf_test::Temporary_folder folder;
  const Solved_example<> solved(smf_test::theta_example());
  const Coordinates coordinates(solved.foliation);
  EXPECT_THROW(SMF::write_component_coordinates_ply(folder.file_name("no/such.ply"), coordinates),
               SMF::Invalid_file_exception);
  EXPECT_THROW(SMF::write_component_coordinates_obj(folder.file_name("no/such.obj"), coordinates),
               SMF::Invalid_file_exception);
}

} // namespace test_write_component_coordinates
