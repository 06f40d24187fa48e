// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "generators/meshes.h"

#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/loops.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace test_isoline_loops {

// Loops from isolines of functions and from plane sections.

namespace {

using smf_test::Mesh;
using smf_test::vertex;
namespace SMF = CGAL::Surface_mesh_foliation;
namespace soups = smf_test::soups;

using Loop = SMF::Loop<Mesh>;
using Loops = std::vector<Loop>;
using Plane = std::array<double, 4>;
using Scalar_map = Mesh::Property_map<Mesh::Vertex_index, double>;

double value(const Plane& plane, const Mesh::Point& p)
{
  return plane[0] * p.x() + plane[1] * p.y() + plane[2] * p.z() + plane[3];
}

Mesh::Point place(const SMF::Crossing<Mesh>& crossing, const Mesh& mesh)
{
  const Mesh::Point &p = mesh.point(source(crossing.halfedge, mesh)),
                    &q = mesh.point(target(crossing.halfedge, mesh));
  return p + crossing.position * (q - p);
}

// The halfedges that cross a level upwards, each once, in closed curves.
void expect_isolines(const Loops& loops, const Mesh& mesh, const Scalar_map& function, double level)
{
  std::set<Mesh::Halfedge_index> expected, found;
  for (const auto h : halfedges(mesh))
    if (function[source(h, mesh)] < level && function[target(h, mesh)] >= level)
      expected.insert(h);
  for (const Loop& loop : loops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const auto h = loop[i].halfedge;
      EXPECT_TRUE(found.insert(h).second);
      EXPECT_EQ(face(opposite(h, mesh), mesh), face(loop[(i + 1) % loop.size()].halfedge, mesh));
      EXPECT_GT(loop[i].position, 0);
      EXPECT_LT(loop[i].position, 1);
      const double low = function[source(h, mesh)], high = function[target(h, mesh)];
      EXPECT_NEAR((1 - loop[i].position) * low + loop[i].position * high, level,
                  1e-8 * (high - low)); // the function is linear along the edge
    }
  }
  EXPECT_EQ(found, expected) << "larger values lie to the left";
}

std::vector<Mesh> meshes()
{
  return {smf_test::icosphere(3), smf_test::torus(12, 9, 3, 1), smf_test::genus_surface(3, 2),
          smf_test::handle_surface(4)};
}

TEST(Isoline_loops, of_random_functions)
{
  for (Mesh& mesh : meshes())
  {
    smf_test::Random random(11);
    const Scalar_map function = mesh.add_property_map<Mesh::Vertex_index, double>("v:f").first;
    for (int i = 0; i < 10; ++i)
    {
      for (const auto v : vertices(mesh))
        function[v] = random.between(-1, 1);
      for (const double level : {-0.9, 0., 0.5})
      {
        Loops loops;
        SMF::isoline_loops(mesh, function, level, std::back_inserter(loops));
        expect_isolines(loops, mesh, function, level);
      }
    }
  }
}

TEST(Isoline_loops, vertices_at_the_level_count_as_above)
{
  for (Mesh& mesh : meshes())
  {
    const Scalar_map function = mesh.add_property_map<Mesh::Vertex_index, double>("v:f").first;
    for (const auto v : vertices(mesh))
      function[v] = static_cast<double>(v % 3); // many at the level
    Loops loops;
    SMF::isoline_loops(mesh, function, 1, std::back_inserter(loops));
    expect_isolines(loops, mesh, function, 1);
    SMF::Poles_and_loops<Mesh> input; // all of them in general position
    for (const Loop& loop : loops)
      input.add_loop(loop);
    for (const SMF::Problem& problem : SMF::validate(mesh, input))
      EXPECT_TRUE(problem.kind == SMF::Problem_kind::INESSENTIAL_LOOP ||
                  problem.kind == SMF::Problem_kind::HOMOTOPIC_LOOPS)
        << problem.message;
  }
}

TEST(Isoline_loops, beyond_all_values_are_none)
{
  Mesh mesh = smf_test::icosphere(2);
  const Scalar_map function = mesh.add_property_map<Mesh::Vertex_index, double>("v:f", 4).first;
  Loops loops;
  for (const double level : {-1., 4., 5.})
    SMF::isoline_loops(mesh, function, level, std::back_inserter(loops));
  EXPECT_TRUE(loops.empty());
}

TEST(Isoline_loops, of_extreme_values)
{
  Mesh mesh = smf_test::icosphere(2);
  const Scalar_map function = mesh.add_property_map<Mesh::Vertex_index, double>("v:f").first;
  for (const double size : {1e-300, 1., 1.7e308})
  {
    for (const auto v : vertices(mesh))
      function[v] = size * mesh.point(v).z();
    Loops loops;
    SMF::isoline_loops(mesh, function, 0.25 * size, std::back_inserter(loops));
    ASSERT_EQ(loops.size(), 1u) << size;
    expect_isolines(loops, mesh, function, 0.25 * size);
  }
}

TEST(Isoline_loops, of_integers)
{
  Mesh mesh = smf_test::icosphere(2);
  const auto function = mesh.add_property_map<Mesh::Vertex_index, int>("v:i", 0).first;
  function[vertex(7)] = 3;
  Loops loops;
  SMF::isoline_loops(mesh, function, 1.5, std::back_inserter(loops));
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_EQ(loops[0].size(), degree(vertex(7), mesh));
  for (const auto& crossing : loops[0])
  {
    EXPECT_EQ(target(crossing.halfedge, mesh), vertex(7));
    EXPECT_NEAR(crossing.position, 0.5, 1e-15);
  }
}

// ===  Plane sections

TEST(Plane_section_loops, lie_in_the_plane_with_the_positive_side_to_the_left)
{
  const std::vector<Plane> planes = {
    {1, 0, 0, -0.1}, {0, 0, -2, 0.3}, {1, 2, 3, -2.5}, {-0.5, 0.25, 1, 0}};
  for (Mesh& mesh : meshes())
    for (const Plane& plane : planes)
    {
      Loops loops;
      SMF::plane_section_loops(mesh, plane, std::back_inserter(loops));
      const Scalar_map function = mesh.add_property_map<Mesh::Vertex_index, double>("v:f").first;
      for (const auto v : vertices(mesh))
        function[v] = value(plane, mesh.point(v));
      expect_isolines(loops, mesh, function, 0);
      for (const Loop& loop : loops)
        for (const auto& crossing : loop)
          EXPECT_NEAR(value(plane, place(crossing, mesh)), 0, 1e-7);
    }
}

TEST(Plane_section_loops, of_a_torus)
{
  const Mesh mesh = smf_test::torus(24, 12, 3, 1);
  const auto count = [&](const Plane& plane) {
    Loops loops;
    SMF::plane_section_loops(mesh, plane, std::back_inserter(loops));
    return loops.size();
  };
  EXPECT_EQ(count({1, 0, 0, -0.1}), 2u); // two circles around the tube
  EXPECT_EQ(count({0, 0, 1, -0.1}), 2u); // two circles around the axis
  EXPECT_EQ(count({1, 0, 0, -3.1}), 1u); // outside of the hole
  EXPECT_EQ(count({1, 0, 0, -10}), 0u);
  EXPECT_EQ(count({0, 0, 0, 1}), 0u);
}

TEST(Plane_section_loops, through_vertices)
{
  const Mesh mesh = smf_test::octahedron(); // four vertices on the plane z = 0 count as positive
  Loops loops;
  SMF::plane_section_loops(mesh, Plane{0, 0, 1, 0}, std::back_inserter(loops));
  ASSERT_EQ(loops.size(), 1u);
  for (const auto& crossing : loops[0])
    EXPECT_EQ(source(crossing.halfedge, mesh), vertex(5)) << "it surrounds the bottom";
}

double distance_to_loop(const Loop& loop, const Mesh& mesh, const Mesh::Point& p)
{
  double result = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const smf_test::Kernel::Segment_3 segment(place(loop[i], mesh),
                                              place(loop[(i + 1) % loop.size()], mesh));
    result = (std::min)(result, std::sqrt(CGAL::squared_distance(p, segment)));
  }
  return result;
}

TEST(Plane_section_loop, is_the_nearest_one)
{
  const Plane plane = {0, 1, 0.1, -3.3};
  const Mesh mesh = smf_test::genus_surface(4, 2); // cut by it in several curves
  Loops loops;
  SMF::plane_section_loops(mesh, plane, std::back_inserter(loops));
  ASSERT_GT(loops.size(), 1u);
  std::set<std::size_t> chosen;
  for (const auto v : vertices(mesh))
  {
    const Loop loop = SMF::plane_section_loop(mesh, plane, v);
    const double found = distance_to_loop(loop, mesh, mesh.point(v));
    for (std::size_t i = 0; i < loops.size(); ++i)
    {
      const double other = distance_to_loop(loops[i], mesh, mesh.point(v));
      EXPECT_LE(found, other * (1 + 1e-9));
      if (loops[i][0].halfedge == loop[0].halfedge)
        chosen.insert(i);
    }
  }
  EXPECT_EQ(chosen.size(), loops.size()) << "every curve is the nearest to some vertex";
}

TEST(Plane_section_loop, of_equally_near_ones_is_the_first)
{
  const Mesh mesh = smf_test::torus(24, 12, 3, 1);
  Loops loops;
  SMF::plane_section_loops(mesh, Plane{1, 0, 0, -0.1}, std::back_inserter(loops));
  ASSERT_EQ(loops.size(), 2u); // one in front of the axis and one behind it
  Mesh middle = mesh;
  middle.point(vertex(0)) = Mesh::Point(4, 0, 0); // on the plane y = 0, the mirror
  const double first = distance_to_loop(loops[0], middle, middle.point(vertex(0)));
  const double second = distance_to_loop(loops[1], middle, middle.point(vertex(0)));
  const Loop loop = SMF::plane_section_loop(middle, {1, 0, 0, -0.1}, vertex(0));
  EXPECT_EQ(loop[0].halfedge, (second < first ? loops[1] : loops[0])[0].halfedge);
  EXPECT_NEAR(first, second, 1e-9);
}

TEST(Plane_section_loop, works_at_all_scales)
{
  for (const double scale : {1e-200, 1e-160, 1., 1e160, 1e200})
  {
    smf_test::Triangle_soup soup = soups::torus(24, 12, 3, 1);
    for (auto& p : soup.points)
      p = soups::scaled(p, scale);
    const Mesh mesh = smf_test::to_mesh(soup);
    const auto side_of_loop = [&](std::size_t v) {
      const Loop loop = SMF::plane_section_loop(mesh, {1, 0, 0, -0.1 * scale}, vertex(v));
      return mesh.point(target(loop[0].halfedge, mesh)).y() > 0;
    };
    EXPECT_TRUE(side_of_loop(6 * 12)) << scale; // a quarter around the axis
    EXPECT_FALSE(side_of_loop(18 * 12)) << scale;
  }
}

TEST(Plane_section_loop, that_misses_the_mesh_is_refused)
{
  const Mesh mesh = smf_test::icosphere(2);
  for (const Plane& plane : {Plane{0, 0, 1, -1.5}, Plane{0, 0, 0, 0}, Plane{0, 0, 0, -1}})
    try
    {
      SMF::plane_section_loop(mesh, plane, vertex(0));
      ADD_FAILURE() << "it is accepted";
    }
    catch (const SMF::Invalid_loops_exception& exception)
    {
      EXPECT_EQ(exception.problem().kind, SMF::Problem_kind::INVALID_LOOP);
      EXPECT_NE(std::string(exception.what()).find("plane"), std::string::npos);
    }
}

} // namespace

} // namespace test_isoline_loops
