// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/example_systems.h"
#include "include/loop_system_counts.h"

#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/components.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace test_special_loop_systems {

// Loop systems that are special, and must work: few poles, poles side by side, heights far apart.

namespace {

using smf_test::ends;
using smf_test::Item;
using smf_test::Mesh;
using smf_test::Solved_example;
using smf_test::vertex;
namespace SMF = CGAL::Surface_mesh_foliation;
namespace soups = smf_test::soups;

using Indices = std::vector<std::size_t>;
using System = SMF::Loop_system<Mesh>;

Solved_example<> solved(const smf_test::Triangle_soup& soup, std::vector<Item> items)
{
  return Solved_example<>({"", soup, std::move(items)});
}

TEST(Special_cases, sphere_with_two_poles)
{
  const auto example = solved(soups::icosphere(3), {{Item::POLE, {0}, 0.75}, {Item::POLE, {3}, 2}});
  const System& system = example.system;
  ASSERT_EQ(system.number_of_arcs(), 1u);
  EXPECT_EQ(system.number_of_nodes(), 2u);
  EXPECT_EQ(system.height(0), 2.75);
  EXPECT_EQ(system.merged_loops(), Indices{1});
  EXPECT_EQ(system.node(0, 0), 0u);
  EXPECT_EQ(system.node(0, 1), 1u);
  EXPECT_EQ(SMF::component_kind(system, 0), SMF::Component_kind::SPHERE);
  EXPECT_EQ(example.foliation.parameter(vertex(0)), 0);
  for (const auto v : vertices(*example.mesh))
    EXPECT_EQ(example.foliation.cell(v).is_arc, v != vertex(0) && v != vertex(3));
}

TEST(Special_cases, sphere_with_two_adjacent_poles)
{
  for (const smf_test::Triangle_soup& soup :
       {soups::tetrahedron(), soups::octahedron(), soups::icosphere(2)})
  {
    const std::size_t u = soup.triangles[0][0], v = soup.triangles[0][1];
    const auto example = solved(soup, {{Item::POLE, {u}}, {Item::POLE, {v}}});
    const auto h = halfedge(vertex(u), vertex(v), *example.mesh).first;
    EXPECT_NEAR(example.foliation.edge_value(edge(h, *example.mesh)), 2, 1e-12);
  }
}

TEST(Special_cases, sphere_with_two_line_poles)
{
  const smf_test::Triangle_soup torus = soups::icosphere(3);
  const Mesh mesh = smf_test::to_mesh(torus);
  const auto straight = [&](std::size_t v) { // some spoke and the one opposite to it
    Indices result;
    const auto h = halfedge(vertex(v), mesh);
    result = {source(h, mesh), v};
    auto g = h;
    for (int i = 0; i < 3; ++i)
      g = opposite(next(g, mesh), mesh);
    result.push_back(source(g, mesh));
    return result;
  };
  const Indices first = straight(50), second = straight(600);
  const auto example = solved(torus, {{Item::LINE_POLE, first}, {Item::LINE_POLE, second}});
  EXPECT_EQ(example.system.number_of_nodes(), 2u);
  for (const std::size_t v : first)
    EXPECT_EQ(example.foliation.cell(vertex(v)).index, 0u);
  for (const std::size_t v : second)
    EXPECT_EQ(example.foliation.cell(vertex(v)).index, 1u);
}

TEST(Special_cases, torus_without_pole)
{
  const std::size_t m = 14, n = 9;
  for (const Indices& cycle : {smf_test::meridian(3, n), smf_test::longitude(2, m, n)})
  {
    const auto example = solved(soups::torus(m, n, 3, 1), {{Item::CYCLE, cycle, 2.5}});
    const System& system = example.system;
    EXPECT_EQ(system.number_of_arcs(), 1u);
    ASSERT_EQ(system.number_of_nodes(), 1u);
    EXPECT_EQ(ends(system, 0), (std::array<std::size_t, 2>{0, 0}));
    EXPECT_EQ(system.degree(0), 2u);
    EXPECT_EQ(system.genus(0), 0u);
    EXPECT_EQ(system.pole(0), -1);
    EXPECT_EQ(SMF::component_kind(system, 0), SMF::Component_kind::CYLINDER);
    EXPECT_TRUE(example.foliation.statistics().has_converged);
  }
}

TEST(Special_cases, parallel_arcs_and_self_arcs)
{
  const Solved_example<> theta(smf_test::theta_example());
  ASSERT_EQ(theta.system.number_of_nodes(), 2u);
  ASSERT_EQ(theta.system.number_of_arcs(), 3u);
  for (const std::size_t a : {0, 1, 2})
    EXPECT_EQ(ends(theta.system, a), (std::array<std::size_t, 2>{0, 1}));
  const Solved_example<> dumbbell(smf_test::dumbbell_example());
  ASSERT_EQ(dumbbell.system.number_of_nodes(), 2u);
  EXPECT_EQ(ends(dumbbell.system, 1), (std::array<std::size_t, 2>{0, 1}));
  EXPECT_EQ(dumbbell.system.node(0, 0), dumbbell.system.node(0, 1));
  EXPECT_EQ(dumbbell.system.node(2, 0), dumbbell.system.node(2, 1));
  EXPECT_NE(dumbbell.system.node(0, 0), dumbbell.system.node(2, 0));
  EXPECT_EQ(dumbbell.system.degree(0), 3u);
}

TEST(Special_cases, regions_with_genus)
{
  const smf_test::Double_torus torus;
  const auto waist = solved(torus.soup, {torus.waist});
  ASSERT_EQ(waist.system.number_of_nodes(), 2u);
  EXPECT_EQ(waist.system.genus(0), 1u);
  EXPECT_EQ(waist.system.genus(1), 1u);
  const auto handle = solved(torus.soup, {torus.left_handle});
  ASSERT_EQ(handle.system.number_of_nodes(), 1u);
  EXPECT_EQ(handle.system.genus(0), 1u);
  EXPECT_EQ(handle.system.degree(0), 2u);
  const auto pole = solved(torus.soup, {{Item::POLE, {4}}});
  ASSERT_EQ(pole.system.number_of_nodes(), 2u);
  EXPECT_EQ(pole.system.genus(0), 0u);
  EXPECT_EQ(pole.system.genus(1), 2u);
}

TEST(Special_cases, poles_that_share_all_neighbors)
{
  // opposite vertices of an octahedron, alone and with one of their neighbors
  EXPECT_EQ(solved(soups::octahedron(), smf_test::pole_items({0, 1})).system.number_of_nodes(), 2u);
  const auto three = solved(soups::octahedron(), smf_test::pole_items({0, 1, 2}));
  EXPECT_EQ(three.system.number_of_nodes(), 4u);
  EXPECT_EQ(three.system.degree(3), 3u);
}

TEST(Special_cases, every_vertex_is_a_pole)
{
  for (const smf_test::Triangle_soup& soup :
       {soups::tetrahedron(), soups::octahedron(), soups::torus(4, 4, 3, 1)})
  {
    Indices all(soup.points.size());
    std::iota(all.begin(), all.end(), std::size_t(0));
    const auto example = solved(soup, smf_test::pole_items(all));
    EXPECT_EQ(example.system.number_of_nodes(), all.size() + 1);
    EXPECT_EQ(example.system.degree(all.size()), all.size());
    for (const auto e : edges(*example.mesh)) // each edge runs from pole to pole: through two arcs
    {
      EXPECT_EQ(example.foliation.path(e).size(), 4u);
      EXPECT_NEAR(example.foliation.edge_value(e), 2, 1e-12);
    }
    EXPECT_TRUE(example.foliation.statistics().has_converged);
  }
}

TEST(Special_cases, a_pole_of_degree_three)
{
  smf_test::Triangle_soup soup = soups::icosphere(2);
  const auto [a, b, c] = soup.triangles[100];
  const std::size_t apex = soup.points.size();
  soup.points.push_back(
    soups::scaled(soups::sum(soups::sum(soup.points[a], soup.points[b]), soup.points[c]), 0.4));
  soup.triangles[100] = {a, b, apex};
  soup.triangles.push_back({b, c, apex});
  soup.triangles.push_back({c, a, apex});
  for (const Indices& others : {Indices{a, b, c}, Indices{a, 3}, Indices{1, 3}, Indices{a}})
  {
    Indices poles = {apex};
    poles.insert(poles.end(), others.begin(), others.end());
    const auto example = solved(soup, smf_test::pole_items(poles));
    EXPECT_EQ(example.system.loop(0).size(), 3u);
    EXPECT_EQ(example.system.number_of_poles(), poles.size());
    EXPECT_TRUE(example.foliation.statistics().has_converged);
  }
}

TEST(Special_cases, line_pole_next_to_a_pole)
{
  const std::size_t n = 9;
  const auto example =
    solved(soups::torus(14, n, 3, 1), {{Item::LINE_POLE, {0, n, 2 * n}}, {Item::POLE, {1}, 3}});
  EXPECT_EQ(example.system.number_of_nodes(), 3u);
  EXPECT_EQ(example.system.genus(2), 1u);
  EXPECT_TRUE(example.foliation.statistics().has_converged);
}

TEST(Special_cases, a_line_pole_of_one_vertex_is_a_pole)
{
  const auto line = solved(soups::icosphere(2), {{Item::LINE_POLE, {0}}, {Item::POLE, {3}}});
  const auto pole = solved(soups::icosphere(2), {{Item::POLE, {0}}, {Item::POLE, {3}}});
  EXPECT_EQ(line.foliation.statistics().energy, pole.foliation.statistics().energy);
}

TEST(Special_cases, heights_far_apart)
{
  const auto example =
    solved(soups::limbed_sphere(3, 3), {{Item::POLE, {soups::limb_tips(3, 3)[0]}, 1e-6},
                                        {Item::POLE, {soups::limb_tips(3, 3)[1]}, 1e6},
                                        {Item::POLE, {soups::limb_tips(3, 3)[2]}}});
  EXPECT_TRUE(example.foliation.statistics().has_converged);
  EXPECT_EQ(example.system.degree(3), 3u);
}

} // namespace

} // namespace test_special_loop_systems
