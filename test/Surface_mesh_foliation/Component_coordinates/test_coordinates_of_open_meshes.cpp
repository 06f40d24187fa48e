// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The components of openings are cylinders that end on their borders.

#include "include/open_meshes.h"
#include "include/temporary_folder.h"
#include "include/uv_mesh.h"
#include "include/vtp_file.h"

#include <CGAL/Surface_mesh_foliation/Component_coordinates.h>
#include <CGAL/Surface_mesh_foliation/IO/write_component_coordinates.h>
#include <CGAL/Surface_mesh_foliation/edge_weights.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace test_coordinates_of_open_meshes {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace soups = smf_test::soups;
using smf_test::Mesh;
using smf_test::Open_case;
using smf_test::Uv_mesh;
using Coordinates = SMF::Component_coordinates<Mesh>;

class Coordinates_of_open_meshes : public ::testing::TestWithParam<Open_case>
{
protected:
  Coordinates_of_open_meshes()
    : mesh(smf_test::to_open_mesh(GetParam().soup)),
      system(mesh, smf_test::openings_and_poles(mesh, GetParam().poles)),
      coordinates(SMF::harmonic_foliation(system))
  {}

  const Mesh mesh;
  const SMF::Loop_system<Mesh> system;
  const Coordinates coordinates;
};

std::string name_of_case(const ::testing::TestParamInfo<Open_case>& info)
{
  std::string name = info.param.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Cases,
                         Coordinates_of_open_meshes,
                         ::testing::ValuesIn(smf_test::open_cases()),
                         name_of_case);

} // namespace

TEST_P(Coordinates_of_open_meshes, charts_cover_their_cylinders_once)
{
  for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
  {
    Mesh chart;
    coordinates.chart(a, chart);
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(chart));
    EXPECT_EQ(smf_test::border_halfedges(chart).size(), 1u);
    const SMF::Component_shape shape = component_shape(coordinates.foliation(), a);
    double area = 0;
    for (const auto f : faces(chart))
    {
      const auto h = halfedge(f, chart);
      const auto corner = [&](auto g) {
        const auto& p = chart.point(target(g, chart));
        return smf_test::Uv{p.x(), p.y()};
      };
      const double area_of_face =
        smf_test::area(corner(h), corner(next(h, chart)), corner(next(next(h, chart), chart)));
      EXPECT_GT(area_of_face, -1e-12);
      area += area_of_face;
    }
    EXPECT_NEAR(area / (shape.height * shape.circumference), 1, 1e-9);
  }
}

TEST_P(Coordinates_of_open_meshes, faces_keep_their_orientation)
{
  const Uv_mesh uv_mesh(coordinates);
  EXPECT_NEAR(PMP::area(uv_mesh.mesh) / PMP::area(mesh), 1, 1e-12);
  bool has_face_without = false;
  for (const auto f : faces(uv_mesh.mesh))
  {
    has_face_without = has_face_without || !uv_mesh.has_coordinates(f);
    if (uv_mesh.has_coordinates(f))
    {
      EXPECT_GT(uv_mesh.area_of(f), -1e-12);
    }
  }
  EXPECT_EQ(has_face_without, GetParam().has_ears);
  // a border is an end of its component
  for (const auto h : halfedges(uv_mesh.mesh))
    if (CGAL::is_border_edge(h, uv_mesh.mesh) && !is_border(h, uv_mesh.mesh))
    {
      const auto f = face(h, uv_mesh.mesh);
      if (!uv_mesh.has_coordinates(f))
        continue;
      const double t = uv_mesh.uv[h][1];
      EXPECT_TRUE(t == 0 || t == system.height(uv_mesh.component[f])) << t;
      EXPECT_EQ(uv_mesh.uv[prev(h, uv_mesh.mesh)][1], t);
      EXPECT_NE(uv_mesh.uv[prev(h, uv_mesh.mesh)][0], uv_mesh.uv[h][0]);
    }
}

TEST_P(Coordinates_of_open_meshes, files_have_no_caps)
{
  const Uv_mesh uv_mesh(coordinates);
  const std::size_t n = num_vertices(uv_mesh.mesh), m = num_faces(uv_mesh.mesh);
  const smf_test::Temporary_folder folder;
  const std::string name = folder.file_name("coordinates");

  SMF::write_component_coordinates_vtp(name, coordinates);
  const smf_test::Vtp_file vtp(name);
  EXPECT_EQ(vtp.polygons.size(), m);
  ASSERT_EQ(vtp.cell_arrays.at("component").size(), m);
  for (std::size_t i = 0; i < m; ++i)
  {
    const Mesh::Face_index f(static_cast<Mesh::size_type>(i));
    auto h = prev(halfedge(f, uv_mesh.mesh), uv_mesh.mesh);
    for (const std::size_t corner : vtp.polygons[i])
    {
      const auto& p = uv_mesh.mesh.point(target(h, uv_mesh.mesh));
      EXPECT_EQ(vtp.points[corner], (std::array<double, 3>{p.x(), p.y(), p.z()}));
      if (uv_mesh.has_coordinates(f))
      {
        EXPECT_EQ(vtp.point_arrays.at("u")[corner], uv_mesh.uv[h][0]);
        EXPECT_EQ(vtp.point_arrays.at("v")[corner], uv_mesh.uv[h][1]);
      }
      h = next(h, uv_mesh.mesh);
    }
    EXPECT_EQ(vtp.cell_arrays.at("component")[i],
              uv_mesh.has_coordinates(f) ? static_cast<double>(uv_mesh.component[f]) : -1);
  }

  // the vertices of the k-th face in the two others
  std::vector<std::set<std::size_t>> expected;
  for (const auto f : faces(uv_mesh.mesh))
  {
    expected.emplace_back();
    for (const auto v : vertices_around_face(halfedge(f, uv_mesh.mesh), uv_mesh.mesh))
      expected.back().insert(v.idx());
  }
  SMF::write_component_coordinates_ply(name, coordinates);
  std::istringstream ply(smf_test::file_text(name));
  std::string line;
  std::size_t vertices_in_header = 0, faces_in_header = 0;
  while (std::getline(ply, line) && line != "end_header")
  {
    if (line.rfind("element vertex ", 0) == 0)
      vertices_in_header = std::stoul(line.substr(15));
    if (line.rfind("element face ", 0) == 0)
      faces_in_header = std::stoul(line.substr(13));
  }
  ASSERT_EQ(vertices_in_header, n);
  ASSERT_EQ(faces_in_header, m);
  for (std::size_t i = 0; i < n; ++i)
    std::getline(ply, line);
  for (std::size_t i = 0; i < m; ++i)
  {
    std::getline(ply, line);
    std::istringstream words(line);
    std::size_t three, a, b, c;
    words >> three >> a >> b >> c;
    EXPECT_EQ(three, 3u);
    EXPECT_EQ((std::set<std::size_t>{a, b, c}), expected[i]);
  }
  EXPECT_FALSE(std::getline(ply, line));

  SMF::write_component_coordinates_obj(name, coordinates);
  std::istringstream obj(smf_test::file_text(name));
  std::size_t number_of_vertices = 0;
  std::multiset<std::set<std::size_t>> in_obj;
  while (std::getline(obj, line))
  {
    number_of_vertices += line.rfind("v ", 0) == 0;
    if (line.rfind("f ", 0) != 0)
      continue;
    std::set<std::size_t> corners;
    std::istringstream words(line.substr(2));
    for (std::string word; words >> word;)
      corners.insert(std::stoul(word) - 1);
    in_obj.insert(corners);
  }
  EXPECT_EQ(number_of_vertices, n);
  EXPECT_EQ(in_obj, std::multiset<std::set<std::size_t>>(expected.begin(), expected.end()));
}

// Without a pole at a vertex the modulus has a limit: that of the annulus.
TEST(Coordinates_of_annuli, are_polar_coordinates)
{
  const std::size_t n = 36, rings = 9;
  const Mesh mesh = smf_test::to_open_mesh(soups::plane_annulus(n, rings));
  const SMF::Loop_system<Mesh> system(mesh, smf_test::openings_and_poles(mesh));
  const auto foliation =
    SMF::harmonic_foliation(system, SMF::parameters::weights(SMF::Cotangent_weights()));
  const double largest =
    std::log(soups::distance(soups::plane_annulus(n, rings).points.back(), {0, 0, 0}));
  const double modulus = component_shape(foliation, 0).modulus();
  EXPECT_NEAR(modulus / (largest / (2 * soups::pi)), 1, 0.01);

  // neighbors on a ring are an n-th of the circumference apart
  const Uv_mesh uv_mesh{Coordinates(foliation)};
  const double step = foliation.flux(0) / static_cast<double>(n);
  for (const auto h : halfedges(uv_mesh.mesh))
  {
    if (is_border(h, uv_mesh.mesh))
      continue;
    const auto a = source(h, uv_mesh.mesh).idx(), b = target(h, uv_mesh.mesh).idx();
    if (a / n == b / n)
    {
      EXPECT_NEAR(std::abs(uv_mesh.uv[h][0] - uv_mesh.uv[prev(h, uv_mesh.mesh)][0]), step, 1e-9);
    }
  }
}

} // namespace test_coordinates_of_open_meshes
