// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Loops are made on meshes with openings, and what needs a closed mesh says so.

#include "include/open_meshes.h"
#include "include/temporary_folder.h"

#include <CGAL/Surface_mesh_foliation/IO/read_loops.h>
#include <CGAL/Surface_mesh_foliation/Leaf_spread_recorder.h>
#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/automatic_loops.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/feature_lines.h>
#include <CGAL/Surface_mesh_foliation/foliation_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/integrate_foliation.h>
#include <CGAL/Surface_mesh_foliation/loops.h>
#include <CGAL/Surface_mesh_foliation/picked_loops.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_of_function.h>
#include <CGAL/Surface_mesh_foliation/whitehead_foliation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

namespace test_loops_on_open_meshes {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
namespace soups = smf_test::soups;
using smf_test::Mesh;
using smf_test::vertex;
using Input = SMF::Poles_and_loops<Mesh>;
using Loops = std::vector<SMF::Loop<Mesh>>;

constexpr std::size_t n = 12; // vertices of a ring

// five rings in the plane
Mesh annulus()
{
  return smf_test::to_open_mesh(soups::plane_annulus(n, 5));
}

bool touches_border(const SMF::Loop<Mesh>& loop, const Mesh& mesh)
{
  return std::any_of(loop.begin(), loop.end(), [&](const auto& crossing) {
    return CGAL::is_border_edge(crossing.halfedge, mesh);
  });
}

} // namespace

TEST(Loops_on_open_meshes, curves_that_end_on_a_border_are_left_out)
{
  const Mesh mesh = annulus();
  Loops loops;
  SMF::plane_section_loops(mesh, {1, 0, 0, 0.01}, std::back_inserter(loops));
  EXPECT_TRUE(loops.empty()); // two segments
  EXPECT_THROW(SMF::plane_section_loop(mesh, {1, 0, 0, 0.01}, vertex(0)),
               SMF::Invalid_loops_exception);

  SMF::loops_around_vertices(smf_test::vertex_range({0, 1, 2, n, n + 1}), mesh,
                             std::back_inserter(loops));
  EXPECT_TRUE(loops.empty());
  SMF::loops_around_vertices(smf_test::vertex_range({2 * n}), mesh, std::back_inserter(loops));
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_EQ(loops[0].size(), 6u);

  // a set with a part at the border and another inside
  loops.clear();
  SMF::loops_around_vertices(smf_test::vertex_range({0, 2 * n}), mesh, std::back_inserter(loops));
  EXPECT_EQ(loops.size(), 1u);

  // a level set of the radius
  loops.clear();
  auto radius = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
  for (const auto v : vertices(mesh))
    put(radius, v, static_cast<double>(v.idx() / n));
  SMF::isoline_loops(mesh, radius, 2.5, std::back_inserter(loops));
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_EQ(loops[0].size(), 2 * n);
  EXPECT_FALSE(touches_border(loops[0], mesh));
  Input input = smf_test::openings_and_poles(mesh);
  input.add_loop(loops[0]);
  EXPECT_FALSE(SMF::validate(mesh, input).empty()); // homotopic to both borders
  input = smf_test::openings_and_poles(mesh, {n, 3 * n});
  input.add_loop(loops[0]); // between the poles
  const SMF::Loop_system<Mesh> system(mesh, input);
  EXPECT_EQ(system.number_of_arcs(), 5u);
  EXPECT_EQ(system.number_of_nodes(), 6u);
}

TEST(Loops_on_open_meshes, loops_around_poles_end_before_a_border)
{
  const Mesh mesh = annulus();
  EXPECT_EQ(SMF::pole_loop(vertex(2 * n), mesh).size(), 6u);
  EXPECT_FALSE(touches_border(SMF::pole_loop(vertex(2 * n), mesh, 2), mesh));
  EXPECT_THROW(SMF::pole_loop(vertex(0), mesh), SMF::Invalid_loops_exception);
  EXPECT_THROW(SMF::pole_loop(vertex(2 * n), mesh, 3), SMF::Invalid_loops_exception);
}

TEST(Loops_on_open_meshes, picked_loops_avoid_openings_that_are_poles)
{
  const Mesh mesh =
    smf_test::to_open_mesh(soups::without_stars(soups::torus(14, 9, 3, 1), {3, 70}));
  Input input = smf_test::openings_and_poles(mesh);
  const auto border = source(smf_test::border_halfedges(mesh)[0], mesh);
  const auto inner = std::find_if(vertices(mesh).begin(), vertices(mesh).end(),
                                  [&](auto v) { return !CGAL::is_border(v, mesh); });
  EXPECT_THROW(SMF::add_loop_through_vertices(
                 std::vector<Mesh::Vertex_index>{border, *inner, vertex(40)}, mesh, input),
               SMF::Invalid_loops_exception);
  EXPECT_EQ(input.size(), 2u);

  // around the tube, away from both openings
  std::vector<Mesh::Vertex_index> picks;
  for (const double angle : {0., 2.1, 4.2})
  {
    const soups::Point p = {0, 3 + std::cos(angle), std::sin(angle)};
    const auto is_nearer = [&](Mesh::Vertex_index u, Mesh::Vertex_index v) {
      const Mesh::Point q(p[0], p[1], p[2]);
      return CGAL::squared_distance(q, mesh.point(u)) < CGAL::squared_distance(q, mesh.point(v));
    };
    std::vector<Mesh::Vertex_index> free;
    for (const auto v : vertices(mesh))
      if (!CGAL::is_border(v, mesh))
        free.push_back(v);
    picks.push_back(*std::min_element(free.begin(), free.end(), is_nearer));
  }
  EXPECT_EQ(SMF::add_loop_through_vertices(picks, mesh, input), 2u);
  for (const auto& crossing : input.entries()[2].loop)
    EXPECT_FALSE(CGAL::is_border(source(crossing.halfedge, mesh), mesh));
  const SMF::Loop_system<Mesh> system(mesh, input);
  EXPECT_EQ(system.number_of_arcs(), 3u);
}

TEST(Loops_on_open_meshes, files_of_loops)
{
  const Mesh mesh = annulus();
  const smf_test::Temporary_folder folder;
  std::string cycle = "cycle", outward = "cycle";
  for (std::size_t j = 0; j < n; ++j)
  {
    cycle += ' ' + std::to_string(2 * n + j);
    outward += ' ' + std::to_string(j);
  }
  Input input = smf_test::openings_and_poles(mesh);
  SMF::read_loops(folder.write("loops.txt", cycle + "\nseparate 24\n"), mesh, input);
  EXPECT_EQ(input.size(), 4u);
  try
  {
    SMF::read_loops(folder.write("wrong.txt", outward), mesh, input);
    ADD_FAILURE();
  }
  catch (const SMF::Invalid_loops_exception& exception)
  {
    EXPECT_NE(std::string(exception.what()).find("opening of the mesh to its left"),
              std::string::npos);
  }
}

TEST(Loops_on_open_meshes, leaves_spread_from_openings)
{
  const Mesh mesh = annulus();
  const SMF::Loop_system<Mesh> system(mesh, smf_test::openings_and_poles(mesh));
  auto value = get(CGAL::dynamic_edge_property_t<double>(), mesh);
  auto time = get(CGAL::dynamic_vertex_property_t<int>(), mesh);
  SMF::Leaf_spread_recorder recorder(system, value, time);
  SMF::whitehead_foliation(
    system,
    SMF::parameters::spread_by_rings(true).edge_value_map(value).visitor(std::ref(recorder)));
  for (const auto v : vertices(mesh))
  {
    EXPECT_EQ(get(time, v) == 0, CGAL::is_border(v, mesh).has_value());
    EXPECT_LE(get(time, v), 3);
  }
}

TEST(Loops_on_open_meshes, the_graph_in_one_call)
{
  const Mesh mesh = annulus();
  SMF::Reeb_graph<Mesh::Point> graph;
  SMF::foliation_reeb_graph(mesh, smf_test::openings_and_poles(mesh, {2 * n}), graph);
  EXPECT_EQ(num_vertices(graph), 4u);
  EXPECT_EQ(num_edges(graph), 3u);
}

TEST(Loops_on_open_meshes, what_needs_a_closed_mesh_refuses_them)
{
  const Mesh mesh = annulus();
  const auto expect_refusal = [](const std::function<void()>& function) {
    try
    {
      function();
      ADD_FAILURE();
    }
    catch (const SMF::Invalid_mesh_exception& exception)
    {
      EXPECT_EQ(exception.problem().kind, SMF::Problem_kind::NOT_CLOSED);
      EXPECT_NE(std::string(exception.what()).find("2 openings"), std::string::npos)
        << exception.what();
    }
  };
  Input without_openings;
  expect_refusal([&] { SMF::propose_loops(mesh, without_openings); });
  Input input = smf_test::openings_and_poles(mesh);
  EXPECT_EQ(SMF::propose_loops(mesh, input), 0u);
  expect_refusal([&] {
    std::vector<std::vector<Mesh::Vertex_index>> lines;
    SMF::detect_feature_lines(mesh, std::back_inserter(lines));
  });
  auto value = get(CGAL::dynamic_edge_property_t<double>(), mesh);
  for (const auto e : edges(mesh))
    put(value, e, 1);
  expect_refusal([&] { SMF::integrate_foliation(mesh, value); });
  auto height = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
  for (const auto v : vertices(mesh))
    put(height, v, mesh.point(v).x());
  expect_refusal([&] {
    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, SMF::Scalar_reeb_node<Mesh>,
                          SMF::Scalar_reeb_arc>
      graph;
    SMF::reeb_graph_of_function(mesh, height, graph);
  });
}

} // namespace test_loops_on_open_meshes
