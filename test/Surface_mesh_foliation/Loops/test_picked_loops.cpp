// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "generators/meshes.h"
#include "include/problem_of.h"
#include "include/test_models.h"
#include "generators/Random.h"

#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/Poles_and_loops.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/Shortest_walks.h>
#include <CGAL/Surface_mesh_foliation/loops.h>
#include <CGAL/Surface_mesh_foliation/picked_loops.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>
#include <string>
#include <vector>

namespace test_picked_loops {

// Loops through picked vertices: that they are simple, where they run, and what is refused.

namespace {

using smf_test::Mesh;
using smf_test::problem_of;
using smf_test::vertex;
using smf_test::vertex_range;
namespace SMF = CGAL::Surface_mesh_foliation;
namespace soups = smf_test::soups;

using Input = SMF::Poles_and_loops<Mesh>;
using Loop = SMF::Loop<Mesh>;

// the first vertex of a ring around the tube of the torus, and of one along it
constexpr std::size_t rings = 15, ring_size = 12;

Mesh torus()
{
  return smf_test::torus(rings, ring_size, 3, 1);
}

std::vector<Mesh::Vertex_index> around_tube(std::size_t ring)
{
  return vertex_range(
    {ring * ring_size, ring * ring_size + ring_size / 3, ring * ring_size + 2 * ring_size / 3});
}

std::vector<Mesh::Vertex_index> along_tube(std::size_t i)
{
  return vertex_range({i, rings / 3 * ring_size + i, 2 * rings / 3 * ring_size + i});
}

TEST(Picked_loops, run_around_a_tube)
{
  const Mesh mesh = torus();
  for (const auto& picks : {around_tube(0), around_tube(7), along_tube(0), along_tube(5)})
  {
    Input input;
    EXPECT_EQ(SMF::add_loop_through_vertices(picks, mesh, input), 0u);
    ASSERT_EQ(input.size(), 1u);
    const SMF::Loop_system<Mesh> system(mesh, input); // so it is simple and essential
    EXPECT_EQ(system.number_of_arcs(), 1u);
    // it keeps close to the walk
    std::set<Mesh::Vertex_index> near;
    for (const auto& crossing : input.entries()[0].loop)
    {
      near.insert(source(crossing.halfedge, mesh));
      near.insert(target(crossing.halfedge, mesh));
    }
    for (const auto v : picks)
      EXPECT_EQ(near.count(v), 1u) << v;
  }
}

TEST(Picked_loops, are_as_short_as_the_ring_that_they_run_along)
{
  const Mesh mesh = torus();
  const Loop loop = SMF::loop_through_vertices(around_tube(3), mesh);
  std::vector<std::size_t> ring;
  for (std::size_t j = 0; j < ring_size; ++j)
    ring.push_back(3 * ring_size + j);
  const Loop expected = SMF::loop_from_edge_cycle(vertex_range(ring), mesh);
  ASSERT_EQ(loop.size(), expected.size());
  std::set<Mesh::Halfedge_index> crossed, expected_crossed;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    crossed.insert(loop[i].halfedge);
    expected_crossed.insert(expected[i].halfedge);
  }
  EXPECT_EQ(crossed, expected_crossed);
}

TEST(Picked_loops, say_what_crosses_what)
{
  const Mesh mesh = torus();
  Input input;
  SMF::add_loop_through_vertices(around_tube(4), mesh, input);
  const SMF::Problem problem =
    problem_of([&] { SMF::add_loop_through_vertices(along_tube(2), mesh, input); });
  EXPECT_EQ(problem.kind, SMF::Problem_kind::INTERSECTING_LOOPS);
  EXPECT_EQ(problem.loops, (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(problem.message.rfind("loops 0 and 1 meet at edge ", 0), 0u) << problem.message;
  EXPECT_EQ(input.size(), 1u) << "it must not be changed";
}

TEST(Picked_loops, say_which_loop_they_are_homotopic_to)
{
  const Mesh mesh = torus();
  Input input;
  SMF::add_loop_through_vertices(around_tube(4), mesh, input);
  const SMF::Problem problem =
    problem_of([&] { SMF::add_loop_through_vertices(around_tube(9), mesh, input); });
  EXPECT_EQ(problem.kind, SMF::Problem_kind::HOMOTOPIC_LOOPS);
  EXPECT_EQ(problem.loops, (std::vector<std::size_t>{0, 1}));
  // with a pole between them, and one on the other side, they are not
  Input with_poles;
  with_poles.add_pole(vertex(6 * ring_size + 3));
  with_poles.add_pole(vertex(0));
  EXPECT_EQ(SMF::add_loop_through_vertices(around_tube(4), mesh, with_poles), 2u);
  EXPECT_EQ(SMF::add_loop_through_vertices(around_tube(9), mesh, with_poles), 3u);
  EXPECT_EQ(SMF::Loop_system<Mesh>(mesh, with_poles).number_of_arcs(), 4u);
}

TEST(Picked_loops, that_bound_a_disk_are_inessential)
{
  const Mesh mesh = smf_test::icosphere(3);
  const auto nearest = [&](double x, double y, double z) {
    Mesh::Vertex_index best(0);
    for (const auto v : vertices(mesh))
      if (CGAL::squared_distance(mesh.point(v), Mesh::Point(x, y, z)) <
          CGAL::squared_distance(mesh.point(best), Mesh::Point(x, y, z)))
        best = v;
    return best;
  };
  const std::vector<Mesh::Vertex_index> picks = {nearest(1, 0, 0.3), nearest(-0.5, 0.9, 0.3),
                                                 nearest(-0.5, -0.9, 0.3)};
  Input input;
  input.add_pole(nearest(0, 0, -1));
  input.add_pole(nearest(0.3, 0, -1));
  SMF::Problem problem = problem_of([&] { SMF::add_loop_through_vertices(picks, mesh, input); });
  EXPECT_EQ(problem.kind, SMF::Problem_kind::INESSENTIAL_LOOP) << problem.message;
  EXPECT_EQ(problem.loops, (std::vector<std::size_t>{2}));
  // one pole in the disk: homotopic to its pole loop; two: it is accepted
  input.add_pole(nearest(0, 0, 1));
  problem = problem_of([&] { SMF::add_loop_through_vertices(picks, mesh, input); });
  EXPECT_EQ(problem.kind, SMF::Problem_kind::HOMOTOPIC_LOOPS) << problem.message;
  input.add_pole(nearest(0.3, 0, 1));
  EXPECT_EQ(SMF::add_loop_through_vertices(picks, mesh, input), 4u);
}

TEST(Picked_loops, that_must_cross_themselves_are_refused)
{
  const Mesh mesh = smf_test::octahedron();
  const auto at = [&](double x, double y, double z) {
    for (const auto v : vertices(mesh))
      if (CGAL::squared_distance(mesh.point(v), Mesh::Point(x, y, z)) < 1e-6)
        return v;
    throw std::logic_error("no such corner");
  };
  const Mesh::Vertex_index east = at(1, 0, 0), west = at(-1, 0, 0), north = at(0, 1, 0),
                           south = at(0, -1, 0), top = at(0, 0, 1), bottom = at(0, 0, -1);
  const std::vector<Mesh::Vertex_index> picks = {east, west, north, south};
  // one way goes over the top, so the other must go below the bottom
  Input input;
  input.add_pole(bottom);
  const SMF::Problem problem =
    problem_of([&] { SMF::add_loop_through_vertices(picks, mesh, input); });
  const auto name = [](Mesh::Vertex_index v) { return "vertex " + std::to_string(v.idx()); };
  EXPECT_EQ(problem.kind, SMF::Problem_kind::INVALID_LOOP);
  EXPECT_EQ(problem.message, "the path from " + name(north) + " to " + name(south) +
                               " cannot avoid the path from " + name(east) + " to " + name(west) +
                               ": they cross at " + name(top));
  EXPECT_EQ(problem.vertices, (std::vector<std::size_t>{top.idx()}));
  input.add_pole(top);
  EXPECT_EQ(problem_of([&] { SMF::add_loop_through_vertices(picks, mesh, input); }).message,
            "the path from " + name(east) + " to " + name(west) +
              " is blocked by poles and other picked vertices");
}

TEST(Picked_loops, refuse_bad_picks)
{
  const Mesh mesh = torus();
  const auto message = [&](const std::vector<std::size_t>& picks) {
    return problem_of([&] { SMF::loop_through_vertices(vertex_range(picks), mesh); }).message;
  };
  EXPECT_EQ(message({}), "a loop through picked vertices needs at least three");
  EXPECT_EQ(message({1, 2}), "a loop through picked vertices needs at least three");
  EXPECT_EQ(message({1, 2, 3, 1}), "vertex 1 is picked twice");
  EXPECT_EQ(message({1, 2, 1000}), "a picked vertex is not one of the mesh");
  Input input;
  input.add_pole(vertex(2));
  const SMF::Problem problem = problem_of([&] {
    SMF::add_loop_through_vertices(vertex_range({1, 2, 3}), mesh, input);
  });
  EXPECT_EQ(problem.message, "picked vertex 2 belongs to a pole");
  EXPECT_EQ(problem.vertices, (std::vector<std::size_t>{2}));
}

TEST(Picked_loops, refuse_a_vertex_that_was_removed)
{
  Mesh mesh = torus();
  const Mesh::Vertex_index removed = mesh.add_vertex(Mesh::Point(5, 5, 5));
  std::vector<Mesh::Vertex_index> picks = around_tube(0);
  picks.push_back(removed);
  mesh.remove_vertex(removed);
  ASSERT_TRUE(mesh.has_garbage());
  EXPECT_EQ(problem_of([&] { SMF::loop_through_vertices(picks, mesh); }).message,
            "a picked vertex is not one of the mesh");
  EXPECT_FALSE(SMF::loop_through_vertices(around_tube(0), mesh).empty());
}

// Whatever is picked, a loop that is returned never meets itself.
TEST(Picked_loops, are_simple)
{
  smf_test::Random random(7);
  for (const Mesh& mesh :
       {smf_test::icosphere(2), torus(), smf_test::genus_surface(2), smf_test::handle_surface(5)})
    for (int i = 0; i < 40; ++i)
    {
      const auto labels = random.permutation(num_vertices(mesh));
      const std::vector<std::size_t> picks(labels.begin(), labels.begin() + 3 + i % 4);
      SCOPED_TRACE(::testing::PrintToString(picks));
      Input input;
      try
      {
        input.add_loop(SMF::loop_through_vertices(vertex_range(picks), mesh));
      }
      catch (const SMF::Invalid_loops_exception& exception)
      {
        const std::string message = exception.what();
        EXPECT_TRUE(message.find("cannot avoid the path from") != std::string::npos ||
                    message.find("no edge leaves it to its left") != std::string::npos)
          << message;
        continue;
      }
      for (const SMF::Problem& problem : SMF::validate(mesh, input))
        EXPECT_EQ(problem.kind, SMF::Problem_kind::INESSENTIAL_LOOP) << problem.message;
    }
}

// A walk knows one part of a mesh only.
TEST(Picked_loops, are_refused_on_a_mesh_of_two_parts)
{
  Mesh mesh = smf_test::to_mesh(soups::torus(rings, ring_size, 3, 1));
  mesh += smf_test::to_mesh(soups::octahedron());
  Input input;
  EXPECT_THROW(SMF::add_loop_through_vertices(around_tube(5), mesh, input),
               SMF::Invalid_mesh_exception);
  EXPECT_EQ(input.size(), 0u);
}

template <class TriangleMesh>
std::vector<std::size_t> summary(const smf_test::Triangle_soup& soup)
{
  const TriangleMesh mesh = smf_test::to_mesh<TriangleMesh>(soup);
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> all;
  for (const auto v : vertices(mesh))
    all.push_back(v);
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> picks;
  for (const auto v : around_tube(5))
    picks.push_back(all[v.idx()]);
  SMF::Poles_and_loops<TriangleMesh> input;
  input.add_pole(all[0]);
  SMF::add_loop_through_vertices(picks, mesh, input);
  std::vector<std::size_t> result;
  for (const auto& crossing : input.entries()[1].loop)
    for (const auto v : {source(crossing.halfedge, mesh), target(crossing.halfedge, mesh)})
      result.push_back(SMF::internal::position_of_vertex(v, mesh));
  return result;
}

TEST(Picked_loops, are_the_same_on_all_models)
{
  const smf_test::Triangle_soup soup = soups::torus(rings, ring_size, 3, 1);
  using Kernel = CGAL::Simple_cartesian<double>;
  const std::vector<std::size_t> expected = summary<Mesh>(soup);
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(summary<smf_test::Polyhedron_model<Kernel>>(soup), expected);
  EXPECT_EQ(summary<smf_test::Linear_cell_complex_model<Kernel>>(soup), expected);
}

} // namespace

} // namespace test_picked_loops
