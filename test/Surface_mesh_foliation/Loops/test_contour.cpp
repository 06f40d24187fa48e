// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Between meshes and plain arrays: elements and their numbers, curves around sets of vertices, and
// the collection of what the user wants.

#include <CGAL/Surface_mesh_foliation/Loop.h>
#include <CGAL/Surface_mesh_foliation/Poles_and_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Mesh_index.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/build_triangle_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/contour.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/to_loop.h>

#include "include/flat_systems.h"
#include "generators/soups.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <list>
#include <set>
#include <utility>
#include <vector>

namespace test_contour {

using namespace smf_test;
using namespace CGAL::Surface_mesh_foliation::internal;
namespace SMF = CGAL::Surface_mesh_foliation;
using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;
using Loop = SMF::Loop<Mesh>;

namespace {

Mesh to_mesh(const Triangle_soup& soup)
{
  Mesh mesh;
  build_triangle_mesh(soup, mesh, mesh.points());
  return mesh;
}

Vertex vertex(std::size_t i)
{
  return Vertex(static_cast<Mesh::size_type>(i));
}

Halfedge halfedge_between(const Mesh& mesh, std::size_t u, std::size_t v)
{
  return mesh.halfedge(vertex(u), vertex(v));
}

} // namespace

// ===  Mesh_index.h

TEST(Mesh_index, numbers_as_iterated_whatever_was_removed)
{
  const Triangle_soup soup = soups::octahedron();
  Mesh mesh;
  const Vertex first = mesh.add_vertex(), second = mesh.add_vertex();
  build_triangle_mesh(soup, mesh, mesh.points());
  mesh.remove_vertex(first);
  mesh.remove_vertex(second);
  Mesh_index<Mesh> index(mesh);
  EXPECT_EQ(&index.mesh(), &mesh);
  std::vector<SMF::Problem> problems;
  const Triangle_soup found = index.soup(mesh.points(), problems);
  EXPECT_TRUE(problems.empty());
  EXPECT_EQ(found.points, soup.points);
  EXPECT_EQ(found.triangles, soup.triangles);
  for (int i = 0; i < 6; ++i)
  {
    const Vertex v = vertex(static_cast<std::size_t>(i) + 2);
    EXPECT_EQ(index.vertex(i), v);
    EXPECT_EQ(index.index(v), i);
    EXPECT_EQ(index.find(v), i);
  }
  EXPECT_EQ(index.find(first), -1);
  EXPECT_EQ(index.find(vertex(100)), -1);
  EXPECT_EQ(index.find(Mesh::null_vertex()), -1);
  for (int f = 0; f < 8; ++f)
    EXPECT_EQ(index.face(f).idx(), static_cast<unsigned>(f));
}

TEST(Mesh_index, numbers_halfedges_like_the_flat_mesh)
{
  const Triangle_soup soup = soups::seven_vertex_torus();
  const Mesh mesh = to_mesh(soup);
  const Flat_mesh flat = flat_mesh(soup);
  Mesh_index<Mesh> index(mesh);
  index.number_halfedges(flat);
  for (int i = 0; i < flat.number_of_halfedges(); ++i)
  {
    const Halfedge h = index.halfedge_descriptor_of(i);
    EXPECT_EQ(index.index(h), i);
    EXPECT_EQ(index.index(source(h, mesh)), flat.source(i));
    EXPECT_EQ(index.index(target(h, mesh)), flat.target(i));
    EXPECT_EQ(index.halfedge_descriptor_of(opposite_of(i)), opposite(h, mesh));
    EXPECT_EQ(index.halfedge_descriptor_of(flat.next(i)), next(h, mesh));
    EXPECT_EQ(index.face(flat.face(i)), face(h, mesh));
  }
}

TEST(To_loop, takes_the_halfedges_of_the_mesh)
{
  const Triangle_soup soup = soups::seven_vertex_torus();
  const Mesh mesh = to_mesh(soup);
  const Flat_mesh flat = flat_mesh(soup);
  Mesh_index<Mesh> index(mesh);
  index.number_halfedges(flat);
  const Flat_loop expected = flat_loop(flat, seven_vertex_torus_loop());
  const SMF::Loop<Mesh> found = to_loop(expected, index);
  ASSERT_EQ(found.size(), expected.crossings.size());
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_EQ(index.index(found[i].halfedge), expected.crossings[i].halfedge);
    EXPECT_EQ(found[i].position, expected.crossings[i].position);
  }
}

TEST(Mesh_index, reports_the_first_face_that_is_no_triangle)
{
  Mesh mesh;
  std::vector<Vertex> v;
  for (int i = 0; i < 8; ++i)
    v.push_back(mesh.add_vertex(Point_3(i % 2, i / 2 % 2, i / 4)));
  mesh.add_face(v[0], v[2], v[1]);
  for (const auto& [a, b, c, d] : std::vector<std::array<int, 4>>{{4, 5, 7, 6}, {0, 1, 5, 4}})
    mesh.add_face(v[a], v[b], v[c], v[d]);
  std::vector<SMF::Problem> problems;
  const Triangle_soup soup = Mesh_index<Mesh>(mesh).soup(mesh.points(), problems);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].kind, SMF::Problem_kind::NOT_TRIANGLE_MESH);
  EXPECT_EQ(problems[0].faces, std::vector<std::size_t>{1});
  EXPECT_EQ(soup.triangles.size(), 3u);
}

// ===  contour.h and Loop.h

namespace {

std::vector<Loop> loops_around(const Mesh& mesh, const std::set<std::size_t>& inside)
{
  std::vector<Loop> result;
  contour_loops(
    mesh, [&](Vertex v) { return inside.count(v.idx()) > 0; },
    [](Vertex outside, Vertex) { return 0.125 + 0.0625 * static_cast<double>(outside.idx() % 2); },
    std::back_inserter(result));
  return result;
}

// The loops cross all edges between inside and outside once, into the set, from face to face.
void expect_are_contour(const Mesh& mesh,
                        const std::vector<Loop>& loops,
                        const std::set<std::size_t>& inside)
{
  std::multiset<Halfedge> crossed, expected;
  for (const Loop& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const Halfedge h = loop[i].halfedge;
      crossed.insert(h);
      EXPECT_EQ(face(opposite(h, mesh), mesh), face(loop[(i + 1) % loop.size()].halfedge, mesh));
      EXPECT_EQ(loop[i].position, 0.125 + 0.0625 * static_cast<double>(source(h, mesh).idx() % 2));
    }
  for (const Halfedge h : halfedges(mesh))
    if (inside.count(source(h, mesh).idx()) == 0 && inside.count(target(h, mesh).idx()) > 0)
      expected.insert(h);
  EXPECT_EQ(crossed, expected);
}

} // namespace

TEST(Contour_loops, have_the_set_on_their_left)
{
  const Mesh mesh = to_mesh(soups::octahedron());
  for (const auto& [inside, number] :
       std::vector<std::pair<std::set<std::size_t>, std::size_t>>{{{4}, 1},
                                                                  {{4, 5}, 2},
                                                                  {{0, 1, 2, 3}, 2},
                                                                  {{0, 2, 4}, 1},
                                                                  {{}, 0},
                                                                  {{0, 1, 2, 3, 4, 5}, 0}})
  {
    const std::vector<Loop> loops = loops_around(mesh, inside);
    EXPECT_EQ(loops.size(), number);
    expect_are_contour(mesh, loops, inside);
  }
  const Mesh torus = to_mesh(soups::torus(6, 5, 3, 1));
  const std::set<std::size_t> ring = {5, 6, 7, 8, 9, 10, 11, 12, 13, 14};
  EXPECT_EQ(loops_around(torus, ring).size(), 2u);
  expect_are_contour(torus, loops_around(torus, ring), ring);
}

TEST(Inner_position, is_never_an_end)
{
  EXPECT_EQ(inner_position(0.25), 0.25);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (double position : {0., 1., -1., 2., 1e-300, 1 - 1e-16, nan, infinity, -infinity})
  {
    EXPECT_GT(inner_position(position), 0) << position;
    EXPECT_LT(inner_position(position), 1) << position;
  }
  EXPECT_LT(inner_position(0), 0.5);
  EXPECT_GT(inner_position(1), 0.5);
}

TEST(Shorten_loop, removes_ways_to_and_fro)
{
  const Mesh mesh = to_mesh(soups::octahedron());
  const Halfedge a = halfedge_between(mesh, 0, 4), b = halfedge_between(mesh, 2, 4),
                 c = halfedge_between(mesh, 1, 4), d = halfedge_between(mesh, 3, 4);
  const auto o = [&](Halfedge h) { return opposite(h, mesh); };
  const auto shortened = [&](const std::vector<Halfedge>& halfedges) {
    Loop loop;
    for (const Halfedge h : halfedges)
      loop.push_back({h, 0.5});
    shorten_loop(mesh, loop);
    std::vector<Halfedge> result;
    for (const auto& crossing : loop)
      result.push_back(crossing.halfedge);
    return result;
  };
  using Halfedges = std::vector<Halfedge>;
  EXPECT_EQ(shortened({}), Halfedges());
  EXPECT_EQ(shortened({a, b, c, d}), (Halfedges{a, b, c, d}));
  EXPECT_EQ(shortened({a, b, o(b), b, c, d}), (Halfedges{a, b, c, d}));
  EXPECT_EQ(shortened({a, b, c, o(c), o(b), d}), (Halfedges{a, d})); // nested
  EXPECT_EQ(shortened({o(a), b, c, d, a}), (Halfedges{b, c, d}));    // over the end
  EXPECT_EQ(shortened({a, b, c, o(b), o(a)}), Halfedges{c});
  EXPECT_EQ(shortened({a, o(a)}), Halfedges());
  EXPECT_EQ(shortened({a, b, o(b), o(a)}), Halfedges());
  EXPECT_EQ(shortened({a}), Halfedges{a});
  EXPECT_EQ(shortened({a, a}), (Halfedges{a, a}));
}

TEST(Distance_to_segment, at_all_scales)
{
  for (double s : {1., 1e-200, 1e200})
  {
    const Point a = {0, 0, 0}, b = {2 * s, 0, 0};
    EXPECT_DOUBLE_EQ(distance_to_segment({s, 3 * s, 4 * s}, a, b), 5 * s);
    EXPECT_DOUBLE_EQ(distance_to_segment({-3 * s, 4 * s, 0}, a, b), 5 * s); // beyond an end
    EXPECT_DOUBLE_EQ(distance_to_segment({5 * s, 0, 4 * s}, a, b), 5 * s);
    EXPECT_DOUBLE_EQ(distance_to_segment({3 * s, 4 * s, 0}, a, a), 5 * s); // a point
    EXPECT_EQ(distance_to_segment(b, a, b), 0);
    EXPECT_EQ(distance_to_segment(a, a, a), 0);
  }
}

TEST(Distance_to_loop, is_that_to_the_closest_segment)
{
  const Mesh mesh = to_mesh(soups::octahedron());
  Loop loop; // the square of all edges to vertex 4 at their middles
  for (std::size_t v : {0, 2, 1, 3})
    loop.push_back({halfedge_between(mesh, v, 4), 0.5});
  const auto distance = [&](const Point& p) {
    return distance_to_loop(mesh, mesh.points(), loop, p);
  };
  EXPECT_DOUBLE_EQ(distance({0, 0, 0.5}), std::sqrt(0.125));
  EXPECT_DOUBLE_EQ(distance({0, -2, 0.5}), 1.5);
  EXPECT_NEAR(distance({0.25, -0.25, 0.5}), 0, 1e-16); // the segment that closes the loop
  EXPECT_EQ(distance_to_loop(mesh, mesh.points(), Loop(), {0, 0, 0}),
            std::numeric_limits<double>::infinity());
}

// ===  Poles_and_loops.h

TEST(Poles_and_loops, are_numbered_together)
{
  const Mesh mesh = to_mesh(soups::octahedron());
  const Loop loop = loops_around(mesh, {4}).front();
  SMF::Poles_and_loops<Mesh> input;
  EXPECT_EQ(input.size(), 0u);
  const std::list<Vertex> line = {vertex(0), vertex(5)};
  EXPECT_EQ(input.add_pole(vertex(1)), 0u);
  EXPECT_EQ(input.add_loop(loop, 2.5), 1u);
  EXPECT_EQ(input.add_line_pole(line), 2u);
  EXPECT_EQ(input.add_pole(vertex(4), loop), 3u);
  EXPECT_EQ(input.add_line_pole(std::vector<Vertex>(line.begin(), line.end()), loop, -1), 4u);
  ASSERT_EQ(input.size(), 5u);
  const auto& entries = input.entries();
  EXPECT_EQ(entries[0].pole, std::vector<Vertex>{vertex(1)});
  EXPECT_TRUE(entries[0].loop.empty());
  EXPECT_EQ(entries[0].height, 1);
  EXPECT_TRUE(entries[1].pole.empty());
  ASSERT_EQ(entries[1].loop.size(), 4u);
  EXPECT_EQ(entries[1].loop[2].halfedge, loop[2].halfedge);
  EXPECT_EQ(entries[1].height, 2.5);
  EXPECT_EQ(entries[2].pole, (std::vector<Vertex>{vertex(0), vertex(5)}));
  EXPECT_TRUE(entries[2].loop.empty());
  EXPECT_EQ(entries[3].loop.size(), 4u);
  EXPECT_EQ(entries[4].pole.size(), 2u);
  EXPECT_EQ(entries[4].height, -1); // nothing is checked here
  input.set_height(1, 7);
  EXPECT_EQ(input.entries()[1].height, 7);
  EXPECT_EQ(input.entries()[0].height, 1);
}

} // namespace test_contour
