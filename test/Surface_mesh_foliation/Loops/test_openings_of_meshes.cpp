// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Openings of meshes: they are found, filled, capped and made poles.

#include "generators/meshes.h"
#include "generators/openings.h"

#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/fill_openings.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/absorb_enclosed_disks.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Border_poles.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/openings.h>
#include <CGAL/Surface_mesh_foliation/openings.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace test_openings_of_meshes {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
using namespace smf_test;

using Polyhedron = CGAL::Polyhedron_3<Kernel>;

// the part of a sphere between two parallel planes
Triangle_soup zone(int level)
{
  const Triangle_soup below = soups::part_below(soups::icosphere(level), 2, 0.7);
  return soups::with_faces(below, [&](const soups::Triangle& t) {
    return std::all_of(t.begin(), t.end(),
                       [&](std::size_t v) { return below.points[v][2] >= -0.4; });
  });
}

template <class TriangleMesh>
std::vector<SMF::Opening<TriangleMesh>> openings_of(const TriangleMesh& mesh)
{
  std::vector<SMF::Opening<TriangleMesh>> result;
  SMF::openings(mesh, std::back_inserter(result));
  return result;
}

template <class TriangleMesh>
void expect_openings_of_zone()
{
  const auto mesh = to_open_mesh<TriangleMesh>(zone(4));
  std::vector<SMF::Opening<TriangleMesh>> all = openings_of(mesh);
  ASSERT_EQ(all.size(), 2u);
  for (const auto& opening : all)
    EXPECT_TRUE(is_border(opening.border, mesh));
  std::sort(all.begin(), all.end(),
            [](const auto& a, const auto& b) { return a.length < b.length; });
  // the circles, and zigzags along them
  const double above = 2 * CGAL_PI * std::sqrt(1 - 0.7 * 0.7);
  const double below = 2 * CGAL_PI * std::sqrt(1 - 0.4 * 0.4);
  EXPECT_GT(all[0].length, 0.9 * above);
  EXPECT_LT(all[0].length, 1.5 * above);
  EXPECT_GT(all[1].length, 0.9 * below);
  EXPECT_LT(all[1].length, 1.5 * below);
}

} // namespace

TEST(Openings_of_meshes, of_a_zone_of_a_sphere)
{
  expect_openings_of_zone<Mesh>();
  expect_openings_of_zone<Polyhedron>();
  EXPECT_TRUE(openings_of(icosphere(2)).empty());
}

TEST(Openings_of_meshes, are_found_in_soups_in_the_direction_of_their_caps)
{
  using namespace SMF::internal;
  // two triangles of a square
  Triangle_soup square;
  square.points = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  const std::vector<Border> openings = find_openings(square);
  ASSERT_EQ(openings.size(), 1u);
  EXPECT_EQ(openings[0], (Border{0, 3, 2, 1}));
  std::vector<Point> points = square.points;
  std::vector<Triangle> triangles = {{0, 1, 2}, {0, 2, 3}};
  add_caps(openings, points, triangles);
  EXPECT_EQ(points.back(), (Point{1, 1, 0}));
  ASSERT_EQ(triangles.size(), 6u);
  EXPECT_EQ(triangles[2], (Triangle{0, 3, 4}));
  const Flat_mesh mesh(points, triangles, 1, 2);
  EXPECT_EQ(mesh.genus(), 0);
  EXPECT_EQ(mesh.number_of_input_vertices(), 4);
  EXPECT_EQ(mesh.number_of_input_faces(), 2);
  int cap_edges = 0, border_edges = 0;
  for (int e = 0; e < mesh.number_of_edges(); ++e)
  {
    cap_edges += mesh.is_cap_edge(e);
    border_edges += mesh.is_border_edge(e);
  }
  EXPECT_EQ(cap_edges, 4);
  EXPECT_EQ(border_edges, 4);
}

TEST(Fill_openings, up_to_a_length)
{
  for (const double length : {0., 5.2, std::numeric_limits<double>::infinity()})
  {
    Mesh mesh = to_open_mesh(zone(4));
    const std::size_t number_of_faces = num_faces(mesh);
    std::size_t expected = 0;
    for (const auto& opening : openings_of(mesh))
      expected += opening.length <= length;
    const auto is_filled = mesh.add_property_map<Mesh::Face_index, bool>("f:is_filled", false);
    EXPECT_EQ(SMF::fill_openings(
                mesh, SMF::parameters::max_opening_length(length).filled_face_map(is_filled.first)),
              expected);
    EXPECT_EQ(openings_of(mesh).size(), 2 - expected);
    std::size_t number_of_filled = 0;
    for (const auto f : faces(mesh))
    {
      number_of_filled += is_filled.first[f];
      EXPECT_EQ(is_filled.first[f], f.idx() >= number_of_faces);
    }
    EXPECT_EQ(num_faces(mesh), number_of_faces + number_of_filled);
    EXPECT_TRUE(CGAL::is_triangle_mesh(mesh));
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  }
}

TEST(Fill_openings, on_other_types_of_meshes_and_by_default)
{
  // a hole of one face, and a wide one
  Triangle_soup soup = soups::part_below(soups::icosphere(5), 2, 0.5);
  soup.triangles.erase(soup.triangles.begin() + 200);
  auto polyhedron = to_open_mesh<Polyhedron>(soup);
  EXPECT_EQ(SMF::fill_openings(polyhedron), 1u);
  EXPECT_EQ(openings_of(polyhedron).size(), 1u);
  auto mesh = to_open_mesh<CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>>(soup);
  EXPECT_EQ(SMF::fill_openings(mesh, SMF::parameters::max_opening_length(100)), 2u);
  EXPECT_TRUE(CGAL::is_closed(mesh));
}

// A double wheel: its border has chords, so the only triangulation of the opening needs edges that
// the mesh has already.
TEST(Fill_openings, by_a_fan_where_edges_would_be_double)
{
  Triangle_soup soup = soups::tetrahedron();
  soup.triangles.pop_back();
  Mesh cap = to_open_mesh(soup); // three faces around a vertex: the opening is a triangle
  EXPECT_EQ(SMF::fill_openings(cap, SMF::parameters::max_opening_length(100)), 1u);
  EXPECT_EQ(num_faces(cap), 4u);
  soup = soups::tetrahedron();
  soup.triangles.resize(2); // the opening has four edges, and both diagonals are edges or will be
  Mesh two = to_open_mesh(soup);
  EXPECT_EQ(SMF::fill_openings(two, SMF::parameters::max_opening_length(100)), 1u);
  EXPECT_TRUE(CGAL::is_closed(two));
  EXPECT_TRUE(CGAL::is_triangle_mesh(two));
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(two));
  soup.triangles.resize(1); // the back of a triangle is not that triangle again
  Mesh one = to_open_mesh(soups::without_isolated_vertices(soup));
  EXPECT_EQ(SMF::fill_openings(one, SMF::parameters::max_opening_length(100)), 1u);
  EXPECT_EQ(num_faces(one), 4u);
  EXPECT_TRUE(CGAL::is_closed(one));
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(one));
}

TEST(Fill_openings, a_length_out_of_range_is_refused)
{
  Mesh mesh = to_open_mesh(zone(2));
  for (const double length : {-1., std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(SMF::fill_openings(mesh, SMF::parameters::max_opening_length(length)),
                 SMF::Invalid_parameter_exception);
}

TEST(Border_poles, every_opening_must_be_one)
{
  const Mesh mesh = to_open_mesh(zone(3));
  SMF::Poles_and_loops<Mesh> input;
  std::vector<SMF::Problem> problems = SMF::validate(mesh, input);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].kind, SMF::Problem_kind::NOT_CLOSED);
  EXPECT_NE(problems[0].message.find("2 openings"), std::string::npos) << problems[0].message;
  EXPECT_NE(problems[0].message.find("2 of them are no poles"), std::string::npos);
  EXPECT_EQ(SMF::add_border_poles(mesh, input), 2u);
  EXPECT_TRUE(SMF::validate(mesh, input).empty());
  const SMF::Loop_system<Mesh> system(mesh, input);
  EXPECT_TRUE(system.is_border_pole(0));
  for (std::size_t p : {0, 1})
    for (const auto v : system.pole_vertices(p))
      EXPECT_TRUE(CGAL::is_border(v, mesh).has_value());
  input.add_border_pole(openings_of(mesh)[0].border);
  problems = SMF::validate(mesh, input);
  ASSERT_FALSE(problems.empty());
  EXPECT_NE(problems[0].message.find("same opening"), std::string::npos) << problems[0].message;
}

// A disk whose border has a chord that cuts off an inner vertex, and a pole beyond the other side.
TEST(Chords_of_borders, enclosed_disks_lie_at_the_pole)
{
  using namespace SMF::internal;
  // a fan around vertex 0 in the hexagon 1 ... 6 without the opposite side; the chord 1 3 has the
  // fan around 7 beyond it
  Triangle_soup soup;
  soup.points = {{0, 0, 1},  {2, 0, 0},   {1, 2, 0},  {-1, 2, 0},
                 {-2, 0, 0}, {-1, -2, 0}, {1, -2, 0}, {1, 1.5, 0.2}};
  soup.triangles = {{0, 1, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6},
                    {0, 6, 1}, {7, 1, 2}, {7, 2, 3}, {7, 3, 1}};
  const Mesh mesh = to_open_mesh(soup);
  SMF::Poles_and_loops<Mesh> input;
  SMF::add_border_poles(mesh, input);
  input.add_pole(Mesh::Vertex_index(0));
  const SMF::Loop_system<Mesh> system(mesh, input);
  const Flat_loop_system& flat = system.data().flat;
  const Foliation_state state(flat, std::vector<double>(flat.mesh.number_of_edges(), 1));
  EXPECT_TRUE(state.is_fixed(7));
  EXPECT_TRUE(state.is_at_node(7));
  EXPECT_EQ(state.node(7), static_cast<int>(system.node(0, 0)));
  for (int h : flat.mesh.ring(7))
    EXPECT_EQ(state.word_size(edge_of(h)), 0);
  EXPECT_EQ(state.word_size(edge_of(flat.mesh.find_halfedge(1, 3))), 0);
  EXPECT_GT(state.word_size(edge_of(flat.mesh.find_halfedge(0, 1))), 0);
}

} // namespace test_openings_of_meshes
