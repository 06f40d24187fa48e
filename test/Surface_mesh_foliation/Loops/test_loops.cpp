// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "generators/meshes.h"
#include "include/problem_of.h"

#include <CGAL/Surface_mesh_foliation/internal/Loops/Loop.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/loop_problem.h>
#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/loops.h>

#include <CGAL/boost/graph/iterator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_loops {

namespace {

using smf_test::Mesh;
using smf_test::problem_of;
using smf_test::vertex;
namespace SMF = CGAL::Surface_mesh_foliation;
namespace soups = smf_test::soups;

using Loop = SMF::Loop<Mesh>;
using Loops = std::vector<Loop>;
using Vertex = Mesh::Vertex_index;
using Vertices = std::set<Vertex>;

struct Named_mesh
{
  std::string name;
  std::size_t genus;
  Mesh mesh;
};

std::vector<Named_mesh> meshes()
{
  std::vector<Named_mesh> result;
  result.push_back({"tetrahedron", 0, smf_test::tetrahedron()});
  result.push_back({"sphere", 0, smf_test::icosphere(3)});
  result.push_back({"limbs", 0, smf_test::limbed_sphere(4, 3)});
  result.push_back({"torus", 1, smf_test::torus(12, 9, 3, 1)});
  result.push_back({"plate", 3, smf_test::genus_surface(3, 2)});
  result.push_back({"handles", 5, smf_test::handle_surface(5)});
  return result;
}

// ===  What every loop must be

void expect_curve(const Loop& loop, const Mesh& mesh)
{
  ASSERT_GE(loop.size(), 3u);
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    EXPECT_GT(loop[i].position, 0);
    EXPECT_LT(loop[i].position, 1);
    const auto next_halfedge = loop[(i + 1) % loop.size()].halfedge;
    EXPECT_EQ(face(opposite(loop[i].halfedge, mesh), mesh), face(next_halfedge, mesh)) << i;
    EXPECT_NE(opposite(loop[i].halfedge, mesh), next_halfedge) << "it turns back at " << i;
  }
}

// Checks that loops together are the boundary of a set of vertices, with the set to their left.
void expect_boundary(const Loops& loops, const Vertices& inside, const Mesh& mesh)
{
  std::set<Mesh::Halfedge_index> expected, found;
  for (const auto h : halfedges(mesh))
    if (inside.count(source(h, mesh)) == 0 && inside.count(target(h, mesh)) == 1)
      expected.insert(h);
  for (const Loop& loop : loops)
  {
    expect_curve(loop, mesh);
    for (const auto& crossing : loop)
      EXPECT_TRUE(found.insert(crossing.halfedge).second) << "an edge is crossed twice";
  }
  EXPECT_EQ(found, expected);
}

template <class Function>
void expect_refusal(const Function& function,
                    const std::string& message,
                    const std::vector<std::size_t>& indices)
{
  const SMF::Problem problem = problem_of(function);
  EXPECT_EQ(problem.kind, SMF::Problem_kind::INVALID_LOOP);
  EXPECT_EQ(problem.message, message);
  EXPECT_EQ(problem.vertices, indices);
}

// ===  Around a vertex

Vertices ball(Vertex v, unsigned int radius, const Mesh& mesh)
{
  Vertices result = {v};
  for (; radius > 0; --radius)
    for (const Vertex u : Vertices(result))
      for (const Vertex w : CGAL::vertices_around_target(u, mesh))
        result.insert(w);
  return result;
}

std::size_t number_of_boundary_curves(const Vertices& inside, const Mesh& mesh)
{
  Loops loops;
  SMF::loops_around_vertices(inside, mesh, std::back_inserter(loops));
  return loops.size();
}

TEST(Pole_loop, surrounds_the_rings)
{
  for (const Named_mesh& named : meshes())
    for (const unsigned int rings : {1, 2, 3, 4, 5})
      for (const std::size_t v : {std::size_t(0), std::size_t(num_vertices(named.mesh) / 2)})
      {
        SCOPED_TRACE(named.name + ", " + std::to_string(rings) + " rings at " + std::to_string(v));
        const Vertices disk = ball(vertex(v), rings - 1, named.mesh);
        if (number_of_boundary_curves(disk, named.mesh) == 1)
        {
          expect_boundary({SMF::pole_loop(vertex(v), named.mesh, rings)}, disk, named.mesh);
        }
        else
        {
          EXPECT_EQ(problem_of([&] { SMF::pole_loop(vertex(v), named.mesh, rings); }).kind,
                    SMF::Problem_kind::INVALID_LOOP);
        }
      }
}

TEST(Pole_loop, has_one_ring_by_default_and_as_many_crossings_as_edges)
{
  const Mesh mesh = smf_test::limbed_sphere(3, 3);
  for (const Vertex v : vertices(mesh))
  {
    const Loop loop = SMF::pole_loop(v, mesh);
    EXPECT_EQ(loop.size(), degree(v, mesh));
    expect_boundary({loop}, {v}, mesh);
  }
}

TEST(Pole_loop, of_more_and_more_rings_are_disjoint)
{
  const Mesh mesh = smf_test::icosphere(4);
  SMF::Poles_and_loops<Mesh> input;
  input.add_pole(vertex(0), SMF::pole_loop(vertex(0), mesh, 1));
  input.add_pole(vertex(1));
  input.add_pole(vertex(2));
  for (const unsigned int rings : {2, 3, 4, 5})
    input.add_loop(SMF::pole_loop(vertex(0), mesh, rings));
  for (const SMF::Problem& problem : SMF::validate(mesh, input))
    EXPECT_EQ(problem.kind, SMF::Problem_kind::HOMOTOPIC_LOOPS) << problem.message;
}

TEST(Pole_loop, that_has_several_boundary_curves_or_none_is_refused)
{
  const Mesh torus = smf_test::torus(30, 5, 3, 1); // four rings reach around the tube, not the axis
  expect_refusal([&] { SMF::pole_loop(vertex(3), torus, 5); },
                 "the boundary of the rings around vertex 3 is not one curve but 2", {3});
  const Mesh sphere = smf_test::icosphere(1);
  expect_refusal([&] { SMF::pole_loop(vertex(7), sphere, 50); },
                 "the boundary of the rings around vertex 7 is not one curve but 0", {7});
}

// ===  Around sets of vertices

TEST(Loops_around_vertices, are_the_boundary_of_the_set)
{
  for (const Named_mesh& named : meshes())
  {
    SCOPED_TRACE(named.name);
    smf_test::Random random(7);
    for (int i = 0; i < 20; ++i) // from single vertices to nearly all
    {
      Vertices inside;
      for (const Vertex v : vertices(named.mesh))
        if (random.between(0, 1) < 0.05 * i + 0.02)
          inside.insert(v);
      Loops loops;
      SMF::loops_around_vertices(inside, named.mesh, std::back_inserter(loops));
      expect_boundary(loops, inside, named.mesh);
    }
  }
}

TEST(Loops_around_vertices, there_are_none_around_nothing_and_around_everything)
{
  const Mesh mesh = smf_test::torus(8, 6, 3, 1);
  EXPECT_EQ(number_of_boundary_curves({}, mesh), 0u);
  EXPECT_EQ(number_of_boundary_curves({vertices(mesh).begin(), vertices(mesh).end()}, mesh), 0u);
}

TEST(Loops_around_vertices, there_is_one_per_boundary_curve)
{
  const Mesh mesh = smf_test::torus(12, 6, 3, 1);
  Vertices row = {vertex(18), vertex(19), vertex(20), vertex(21), vertex(22), vertex(23)};
  EXPECT_EQ(number_of_boundary_curves(row, mesh), 2u);
  row.erase(vertex(20));
  EXPECT_EQ(number_of_boundary_curves(row, mesh), 1u);
  row.insert(vertex(60));
  EXPECT_EQ(number_of_boundary_curves(row, mesh), 2u);
}

TEST(Loops_around_vertices, take_any_range_and_repeated_vertices)
{
  const Mesh mesh = smf_test::icosphere(2);
  const std::vector<Vertex> vector = {vertex(3), vertex(3), vertex(3)};
  Loops loops;
  SMF::loops_around_vertices(vector, mesh, std::back_inserter(loops));
  expect_boundary(loops, {vertex(3)}, mesh);
}

// ===  From edge cycles

// the vertices of a shortest cycle that a breadth-first search from `root` finds across a random
// edge
std::vector<Vertex> random_cycle(const Mesh& mesh, smf_test::Random& random)
{
  std::map<Vertex, Vertex> parent;
  const Vertex root = vertex(random.index(num_vertices(mesh)));
  parent[root] = root;
  std::vector<Vertex> reached = {root};
  for (std::size_t i = 0; i < reached.size(); ++i)
    for (const Vertex v : CGAL::vertices_around_target(reached[i], mesh))
      if (parent.emplace(v, reached[i]).second)
        reached.push_back(v);
  for (;;)
  {
    const auto h =
      Mesh::Halfedge_index(static_cast<Mesh::size_type>(random.index(num_halfedges(mesh))));
    std::vector<Vertex> one = {source(h, mesh)}, other = {target(h, mesh)};
    for (auto* path : {&one, &other})
      while (path->back() != root)
        path->push_back(parent[path->back()]);
    while (one.size() > 1 && other.size() > 1 && one[one.size() - 2] == other[other.size() - 2])
    {
      one.pop_back();
      other.pop_back();
    }
    one.insert(one.end(), other.rbegin() + 1, other.rend());
    if (one.size() > 3)
      return one;
  }
}

// The loop of a cycle; empty if it is refused, as the cycle has nothing but triangles to its left.
Loop loop_if_possible(const std::vector<Vertex>& cycle, const Mesh& mesh)
{
  try
  {
    const Loop loop = SMF::loop_from_edge_cycle(cycle, mesh);
    EXPECT_FALSE(loop.empty());
    return loop;
  }
  catch (const SMF::Invalid_loops_exception& exception)
  {
    EXPECT_NE(std::string(exception.what()).find("left"), std::string::npos) << exception.what();
  }
  return {};
}

TEST(Loop_from_edge_cycle, crosses_the_edges_to_its_left)
{
  for (const Named_mesh& named : meshes())
  {
    if (named.name == "tetrahedron")
      continue;
    SCOPED_TRACE(named.name);
    const Mesh& mesh = named.mesh;
    smf_test::Random random(3);
    for (int i = 0; i < 20; ++i)
    {
      std::vector<Vertex> cycle = random_cycle(mesh, random);
      const Loop left = loop_if_possible(cycle, mesh);
      const std::set<Vertex> on_cycle(cycle.begin(), cycle.end());
      std::reverse(cycle.begin(), cycle.end());
      const Loop right = loop_if_possible(cycle, mesh);
      std::set<Mesh::Halfedge_index> crossed;
      for (const Loop* loop : {&left, &right})
      {
        if (!loop->empty())
          expect_curve(*loop, mesh);
        for (const auto& crossing : *loop)
        {
          EXPECT_EQ(on_cycle.count(source(crossing.halfedge, mesh)), 1u) << "right of the loop";
          EXPECT_TRUE(crossed.insert(crossing.halfedge).second);
        }
      }
      for (const auto h : halfedges(mesh)) // each edge at the cycle leaves it to the left or right
        if (on_cycle.count(source(h, mesh)) == 1 && on_cycle.count(target(h, mesh)) == 0)
        {
          EXPECT_EQ(crossed.count(h), 1u) << h;
        }
    }
  }
}

TEST(Loop_from_edge_cycle, is_simple)
{
  const Mesh mesh = smf_test::genus_surface(4, 3);
  smf_test::Random random(5);
  for (int i = 0; i < 50; ++i)
  {
    const Loop loop = loop_if_possible(random_cycle(mesh, random), mesh);
    if (loop.empty())
      continue;
    SMF::Poles_and_loops<Mesh> input;
    input.add_loop(loop);
    for (const SMF::Problem& problem : SMF::validate(mesh, input))
      EXPECT_EQ(problem.kind, SMF::Problem_kind::INESSENTIAL_LOOP) << problem.message;
  }
}

TEST(Loop_from_edge_cycle, lies_to_the_left)
{
  const std::size_t m = 10, n = 6;
  const Mesh mesh = smf_test::torus(m, n, 3, 1);
  std::vector<Vertex> row; // around the tube: rows 2 and 4 are on its sides
  for (std::size_t j = 0; j < n; ++j)
    row.push_back(vertex(3 * n + j));
  std::set<std::size_t> rows;
  for (const auto& crossing : SMF::loop_from_edge_cycle(row, mesh))
    rows.insert(target(crossing.halfedge, mesh) / n);
  ASSERT_EQ(rows.size(), 1u);
  // left of the first edge is the third vertex of its face
  const auto h = halfedge(row[0], row[1], mesh).first;
  const std::size_t expected = target(next(h, mesh), mesh) / n == 3
                                 ? source(prev(h, mesh), mesh) / n
                                 : target(next(h, mesh), mesh) / n;
  EXPECT_EQ(*rows.begin(), expected);
}

TEST(Loop_from_edge_cycle, of_a_triangle)
{
  const Mesh mesh = smf_test::icosphere(2);
  const auto h = halfedge(Mesh::Face_index(50), mesh);
  const std::vector<Vertex> outside = {target(next(h, mesh), mesh), target(h, mesh),
                                       source(h, mesh)};
  const Loop loop = SMF::loop_from_edge_cycle(outside, mesh);
  const std::vector<Vertex> inside(outside.rbegin(), outside.rend());
  const std::size_t first = inside[0];
  expect_refusal([&] { SMF::loop_from_edge_cycle(inside, mesh); },
                 "the edge cycle from vertex " + std::to_string(first) +
                   " on: no edge leaves it to its left except those that lead straight back to it",
                 {first, inside[1], inside[2]});
  const Vertices triangle(outside.begin(), outside.end());
  Loop backwards; // the set to the left
  for (auto crossing = loop.rbegin(); crossing != loop.rend(); ++crossing)
    backwards.push_back({opposite(crossing->halfedge, mesh), 1 - crossing->position});
  expect_boundary({backwards}, triangle, mesh);
}

TEST(Loop_from_edge_cycle, that_is_no_cycle_is_refused)
{
  const Mesh mesh = smf_test::torus(8, 6, 3, 1); // 6i+j has neighbors 6i+j+1, 6i+6+j, 6i+6+j+1
  const auto refused = [&](const std::vector<std::size_t>& indices, const std::string& message,
                           const std::vector<std::size_t>& concerned) {
    std::vector<Vertex> cycle;
    for (const std::size_t i : indices)
      cycle.push_back(vertex(i));
    expect_refusal([&] { SMF::loop_from_edge_cycle(cycle, mesh); }, message, concerned);
  };
  refused({0, 1, 14}, "edge cycle: vertices 1 and 14 have no edge", {1, 14});
  refused({0, 6, 12, 18}, "edge cycle: vertices 18 and 0 have no edge", {18, 0});
  refused({0, 0, 1}, "edge cycle: vertices 0 and 0 have no edge", {0, 0});
  refused({0, 1, 2, 1}, "the edge cycle turns back at vertex 2", {2});
  refused({1, 0, 5, 0}, "the edge cycle turns back at vertex 5", {5});
  refused({5, 0, 1, 0}, "the edge cycle turns back at vertex 1", {1});
  refused({0, 1, 2, 3, 4, 5, 0, 1, 0}, "edge cycle: vertices 0 and 0 have no edge", {0, 0});
  refused({}, "an edge cycle needs at least three vertices, not 0", {});
  refused({3}, "an edge cycle needs at least three vertices, not 1", {3});
  refused({3, 4}, "an edge cycle needs at least three vertices, not 2", {3, 4});
}

// ===  Plane sections

TEST(Missing_plane_section, that_does_not_exist_is_refused)
{
  const Mesh mesh = smf_test::icosphere(1);
  expect_refusal(
    [&] {
      SMF::plane_section_loop(mesh, {0, 0, 1, -9}, vertex(4));
    },
    "the plane near vertex 4 does not meet the mesh", {4});
}

} // namespace

} // namespace test_loops
