// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Openings beside ears, chords and each other, and foliations that are known exactly.

#include "include/open_meshes.h"
#include "include/polylines.h"
#include "include/solved_open_meshes.h"

#include <CGAL/Surface_mesh_foliation/components.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/loops.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_matching.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

namespace test_shapes_with_openings {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace soups = smf_test::soups;
using smf_test::Mesh;
using smf_test::Open_case;
using Point = Mesh::Point;
using Input = SMF::Poles_and_loops<Mesh>;
using Graph = SMF::Reeb_graph<Point>;
using Foliation = SMF::Measured_foliation<Mesh>;
using smf_test::all_cases;
using Solved = smf_test::Solved_open_mesh;

} // namespace

TEST(Openings_and_poles, faces_in_ears_lie_at_the_border)
{
  for (const Open_case& open : all_cases())
  {
    const Solved solved(open);
    bool has_face_at_border = false;
    for (const auto f : faces(*solved.mesh))
    {
      double sum = 0;
      for (const auto h : halfedges_around_face(halfedge(f, *solved.mesh), *solved.mesh))
        sum += solved.foliation.edge_value(edge(h, *solved.mesh));
      has_face_at_border = has_face_at_border || sum == 0;
    }
    EXPECT_EQ(has_face_at_border, open.has_ears) << open.name;
  }
}

// Ears change nothing: the foliation on the rest is that of the mesh without them, but for the
// weights of the chord.
TEST(Openings_and_poles, ears_have_no_influence)
{
  const auto& cases = all_cases();
  const auto find = [&](const std::string& name) {
    return Solved(*std::find_if(cases.begin(), cases.end(),
                                [&](const Open_case& open) { return open.name == name; }));
  };
  const Solved one = find("ear"), other = find("thin strip");
  for (std::size_t v = 0; v < 28; ++v)
    EXPECT_NEAR(one.foliation.parameter(smf_test::vertex(v)),
                other.foliation.parameter(smf_test::vertex(v)), 1e-12);
  EXPECT_NEAR(one.foliation.flux(0) / other.foliation.flux(0), 1, 1e-12);
}

TEST(Openings_and_poles, a_flat_annulus_has_the_logarithm)
{
  const std::size_t n = 24, rings = 9;
  const Mesh mesh = smf_test::to_open_mesh(soups::plane_annulus(n, rings));
  const SMF::Loop_system<Mesh> system(mesh, smf_test::openings_and_poles(mesh));
  ASSERT_EQ(system.number_of_arcs(), 1u);
  EXPECT_EQ(system.height(0), 2); // the loops of both are homotopic
  const Foliation foliation =
    SMF::harmonic_foliation(system, SMF::parameters::weights(SMF::Cotangent_weights()));
  const double largest =
    std::log(smf_test::distance(mesh.point(smf_test::vertex(n * rings - 1)), CGAL::ORIGIN));
  const bool begins_inside =
    system.pole_vertices(static_cast<std::size_t>(system.pole(system.node(0, 0))))[0] ==
    smf_test::vertex(0);
  for (const auto v : vertices(mesh))
  {
    if (CGAL::is_border(v, mesh))
      continue;
    ASSERT_TRUE(foliation.cell(v).is_arc);
    const double share =
      std::log(std::sqrt(CGAL::squared_distance(mesh.point(v), Point(0, 0, 0)))) / largest;
    // the triangulation is similar to itself, so this is exact
    EXPECT_NEAR(foliation.parameter(v) / 2, begins_inside ? share : 1 - share, 1e-12);
  }
  const double modulus = foliation.flux(0) / system.height(0);
  EXPECT_NEAR(modulus / (2 * soups::pi / largest), 1, 0.02);
}

// With rings at equal distances the error is that of linear finite elements, of second order.
TEST(Openings_and_poles, the_logarithm_is_approached_at_second_order)
{
  std::vector<double> errors;
  for (const std::size_t rings : {5, 9, 17})
  {
    std::vector<std::array<double, 2>> radii;
    for (std::size_t i = 0; i < rings; ++i)
      radii.push_back({1 + 2 * static_cast<double>(i) / static_cast<double>(rings - 1), 0});
    const Mesh mesh = smf_test::to_open_mesh(soups::tube(6 * (rings - 1), radii));
    const SMF::Loop_system<Mesh> system(mesh, smf_test::openings_and_poles(mesh));
    const Foliation foliation = SMF::harmonic_foliation(
      system, SMF::parameters::weights(SMF::Cotangent_weights()).allow_any_weights(true));
    const bool begins_inside =
      system.pole_vertices(static_cast<std::size_t>(system.pole(system.node(0, 0))))[0] ==
      smf_test::vertex(0);
    errors.push_back(0);
    for (const auto v : vertices(mesh))
      if (foliation.cell(v).is_arc)
      {
        const double share =
          std::log(std::sqrt(CGAL::squared_distance(mesh.point(v), Point(0, 0, 0)))) / std::log(3.);
        errors.back() = std::max(errors.back(), std::abs(foliation.parameter(v) / 2 -
                                                         (begins_inside ? share : 1 - share)));
      }
  }
  EXPECT_LT(errors[0], 0.01);
  EXPECT_LT(errors[1], errors[0] / 3);
  EXPECT_LT(errors[2], errors[1] / 3);
}

TEST(Openings_and_poles, a_cylinder_has_its_height)
{
  const std::size_t n = 10, rings = 7;
  std::vector<std::array<double, 2>> levels;
  for (std::size_t i = 0; i < rings; ++i)
    levels.push_back({1, 0.5 * static_cast<double>(i)});
  const Mesh mesh = smf_test::to_open_mesh(soups::tube(n, levels));
  const SMF::Loop_system<Mesh> system(mesh, smf_test::openings_and_poles(mesh));
  const Foliation foliation = SMF::harmonic_foliation(system);
  const bool begins_below =
    system.pole_vertices(static_cast<std::size_t>(system.pole(system.node(0, 0))))[0] ==
    smf_test::vertex(0);
  for (const auto v : vertices(mesh))
    if (!CGAL::is_border(v, mesh))
    {
      const double share = mesh.point(v).z() / 3;
      EXPECT_NEAR(foliation.parameter(v) / 2, begins_below ? share : 1 - share, 1e-12);
    }
}

// Edges from one opening to another one pass the whole arc.
TEST(Openings_and_poles, edges_may_join_openings)
{
  for (const Open_case& open : all_cases())
  {
    if (open.name != "openings joined by edges" && open.name != "strip")
      continue;
    const Solved solved(open);
    const Mesh& mesh = *solved.mesh;
    std::size_t number = 0;
    for (const auto e : edges(mesh))
    {
      const auto u = source(halfedge(e, mesh), mesh), v = target(halfedge(e, mesh), mesh);
      if (is_border(e, mesh) || !CGAL::is_border(u, mesh) || !CGAL::is_border(v, mesh))
        continue;
      ++number;
      EXPECT_EQ(solved.foliation.edge_value(e), solved.system.height(0));
    }
    EXPECT_GT(number, 0u) << open.name;
  }
}

// The chord of the glasses crosses the saddle between the two holes.
TEST(Openings_and_poles, a_chord_between_openings_is_a_path_in_the_tree)
{
  const std::size_t n = 8;
  const Solved solved(soups::glasses(n, 3),
                      [](const Mesh& mesh) { return smf_test::openings_and_poles(mesh); });
  const auto [h, exists] =
    halfedge(smf_test::vertex(2 * n), smf_test::vertex(2 * n + 1), *solved.mesh);
  ASSERT_TRUE(exists);
  EXPECT_FALSE(is_border(edge(h, *solved.mesh), *solved.mesh));
  const auto path = solved.foliation.path(h);
  ASSERT_EQ(path.size(), 4u); // into the arc, out of it at the saddle, and back
  for (const auto& passage : path)
    EXPECT_EQ(passage.arc, path[0].arc);
  EXPECT_EQ(solved.foliation.edge_value(edge(h, *solved.mesh)),
            2 * solved.system.height(path[0].arc));
}

TEST(Openings_and_poles, a_loop_of_the_users_around_an_opening)
{
  const soups::Point pole = {0, 0, -1};
  const smf_test::Triangle_soup bowl = soups::part_below(soups::icosphere(3), 2, 0.3);
  const std::size_t bottom = soups::nearest_vertex(bowl, pole);
  const Solved solved(bowl, [&](const Mesh& mesh) {
    std::vector<Mesh::Vertex_index> inside; // the border, and a ring around it
    for (const auto v : vertices(mesh))
      if (mesh.point(v).z() > -0.2)
        inside.push_back(v);
    std::vector<SMF::Loop<Mesh>> loops;
    SMF::loops_around_vertices(inside, mesh, std::back_inserter(loops));
    EXPECT_EQ(loops.size(), 1u);
    Input input;
    input.add_border_pole(smf_test::border_halfedges(mesh)[0], loops.at(0), 1.5);
    input.add_pole(smf_test::vertex(bottom), 0.5);
    return input;
  });
  EXPECT_EQ(solved.system.number_of_arcs(), 1u);
  EXPECT_EQ(solved.system.height(0), 2);
  const Solved tight(
    bowl, [&](const Mesh& mesh) { return smf_test::openings_and_poles(mesh, {bottom}); });
  for (const auto e : edges(*solved.mesh))
    EXPECT_NEAR(solved.foliation.edge_value(e), tight.foliation.edge_value(e), 1e-9);
}

TEST(Openings_and_poles, graphs_of_open_meshes_are_matched)
{
  const auto make = [](double cosine, const soups::Point& third) {
    return Solved(
      soups::without_caps(soups::icosphere(3), {{1, 0, 0}, {-0.5, 0.9, 0}, third}, cosine),
      [](const Mesh& mesh) { return smf_test::openings_and_poles(mesh); });
  };
  const Graph one = make(0.9, {-0.5, -0.9, 0}).graph(), other = make(0.95, {0, -0.8, 0.5}).graph();
  EXPECT_TRUE(SMF::reeb_graphs_are_isomorphic(one, other, SMF::parameters::use_pole_labels(false)));
  EXPECT_TRUE(
    SMF::match_reeb_graphs(one, other, SMF::parameters::use_pole_labels(false)).has_value());

  // an opening is not a vertex
  const smf_test::Triangle_soup sphere = soups::icosphere(3);
  const Mesh closed = smf_test::to_mesh(sphere);
  Input input;
  for (const soups::Point& p :
       {soups::Point{1, 0, 0}, soups::Point{-0.5, 0.9, 0}, soups::Point{-0.5, -0.9, 0}})
    input.add_pole(smf_test::vertex(soups::nearest_vertex(sphere, p)));
  const SMF::Loop_system<Mesh> system(closed, input);
  Graph with_poles;
  SMF::reeb_graph(SMF::harmonic_foliation(system), with_poles);
  EXPECT_FALSE(
    SMF::reeb_graphs_are_isomorphic(one, with_poles, SMF::parameters::use_pole_labels(false)));
}

TEST(Openings_and_poles, other_mesh_types)
{
  using Polyhedron = CGAL::Polyhedron_3<smf_test::Kernel>;
  for (const Open_case& open : all_cases())
  {
    SCOPED_TRACE(open.name);
    const Polyhedron mesh = smf_test::to_open_mesh<Polyhedron>(open.soup);
    SMF::Poles_and_loops<Polyhedron> input;
    for (const auto h : smf_test::border_halfedges(mesh))
      input.add_border_pole(h);
    for (const std::size_t v : open.poles)
      input.add_pole(*std::next(vertices(mesh).begin(), static_cast<std::ptrdiff_t>(v)));
    const SMF::Loop_system<Polyhedron> system(mesh, input);
    const auto foliation = SMF::harmonic_foliation(system);
    EXPECT_TRUE(foliation.statistics().is_certified);
    Graph graph;
    SMF::reeb_graph(foliation, graph);
    EXPECT_EQ(num_vertices(graph), open.nodes);
    EXPECT_EQ(num_edges(graph), open.arcs);
    Polyhedron cut;
    SMF::surface_components(foliation, cut);
    EXPECT_NEAR(PMP::area(cut) / PMP::area(mesh), 1, 1e-12);
  }
}

} // namespace test_shapes_with_openings
