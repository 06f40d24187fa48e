// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/example_systems.h"
#include "include/loop_system_counts.h"
#include "include/open_meshes.h"
#include "generators/openings.h"

#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/loops.h>
#include <CGAL/Surface_mesh_foliation/components.h>
#include <CGAL/Surface_mesh_foliation/openings.h>

#include <boost/pending/disjoint_sets.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_loop_system_graph {

// The dual graph of a loop system, and the special cases that must work.

namespace {

using smf_test::Example;
using smf_test::Item;
using smf_test::Mesh;
using smf_test::number_of_cycles;
using smf_test::Solved_example;
using smf_test::total_region_genus;
using smf_test::vertex;
namespace SMF = CGAL::Surface_mesh_foliation;
namespace soups = smf_test::soups;

using Indices = std::vector<std::size_t>;
using System = SMF::Loop_system<Mesh>;

// the nodes at the ends of an arc, in ascending order
std::array<std::size_t, 2> ends(const System& system, std::size_t arc)
{
  const auto [low, high] = std::minmax({system.node(arc, 0), system.node(arc, 1)});
  return {low, high};
}

std::size_t number_of_components(const System& system)
{
  boost::disjoint_sets_with_storage<> sets(system.number_of_nodes());
  std::size_t result = system.number_of_nodes();
  for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
  {
    const auto [u, v] = ends(system, a);
    result -= sets.find_set(u) != sets.find_set(v);
    sets.union_set(u, v);
  }
  return result;
}

// ===  What holds for each system

class Each_system : public ::testing::TestWithParam<Example>
{};

INSTANTIATE_TEST_SUITE_P(Examples,
                         Each_system,
                         ::testing::ValuesIn(smf_test::example_systems()),
                         smf_test::name_of_example);

TEST_P(Each_system, counts_agree)
{
  const Solved_example<> example(GetParam());
  const System& system = example.system;
  EXPECT_EQ(&system.mesh(), example.mesh.get());
  EXPECT_EQ(system.genus(), soups::genus(GetParam().soup));
  Indices degree(system.number_of_nodes(), 0);
  for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
    for (const int end : {0, 1})
    {
      ASSERT_LT(system.node(a, end), system.number_of_nodes());
      ++degree[system.node(a, end)];
    }
  for (std::size_t r = 0; r < system.number_of_nodes(); ++r)
    EXPECT_EQ(system.degree(r), degree[r]) << r;
  EXPECT_EQ(number_of_components(system), 1u);
  EXPECT_EQ(number_of_cycles(system) + total_region_genus(system), system.genus());
}

TEST_P(Each_system, nodes_of_poles_come_first)
{
  const Solved_example<> example(GetParam());
  const System& system = example.system;
  std::vector<Indices> poles;
  for (const Item& item : GetParam().items)
    if (item.kind == Item::POLE || item.kind == Item::LINE_POLE)
      poles.push_back(item.vertices);
  ASSERT_EQ(system.number_of_poles(), poles.size());
  for (std::size_t r = 0; r < system.number_of_nodes(); ++r)
    EXPECT_EQ(system.pole(r), r < poles.size() ? static_cast<int>(r) : -1);
  for (std::size_t p = 0; p < poles.size(); ++p)
  {
    EXPECT_EQ(system.degree(p), 1u);
    EXPECT_EQ(system.genus(p), 0u);
    const std::vector<Mesh::Vertex_index> given = system.pole_vertices(p);
    EXPECT_EQ(Indices(given.begin(), given.end()), poles[p]);
  }
}

TEST_P(Each_system, a_pole_is_to_the_left_of_its_loop)
{
  const Solved_example<> example(GetParam());
  const System& system = example.system;
  for (std::size_t a = 0; a < example.input.size(); ++a)
  {
    const auto& pole = example.input.entries()[a].pole;
    if (pole.empty() || (a == 1 && !system.merged_loops().empty()))
      continue;
    EXPECT_EQ(system.node(a, 0), a); // in the examples poles come first
    const std::set<Mesh::Vertex_index> pole_vertices(pole.begin(), pole.end());
    std::size_t spokes = 0;
    for (const auto& crossing : system.loop(a))
    {
      EXPECT_EQ(pole_vertices.count(target(crossing.halfedge, *example.mesh)), 1u);
      EXPECT_EQ(pole_vertices.count(source(crossing.halfedge, *example.mesh)), 0u);
    }
    for (const auto v : pole)
      spokes += degree(v, *example.mesh);
    EXPECT_EQ(system.loop(a).size(), spokes - 2 * (pole.size() - 1));
  }
}

TEST_P(Each_system, heights_and_loops_are_those_given)
{
  const Solved_example<> example(GetParam());
  const System& system = example.system;
  const auto& entries = example.input.entries();
  if (!system.merged_loops().empty())
  {
    EXPECT_EQ(system.merged_loops(), Indices{1});
    ASSERT_EQ(system.number_of_arcs(), 1u);
    EXPECT_EQ(system.height(0), entries[0].height + entries[1].height);
    return;
  }
  ASSERT_EQ(system.number_of_arcs(), entries.size());
  for (std::size_t a = 0; a < entries.size(); ++a)
  {
    EXPECT_EQ(system.height(a), entries[a].height);
    const SMF::Loop<Mesh> loop = system.loop(a);
    ASSERT_TRUE(entries[a].loop.empty() || entries[a].loop.size() == loop.size());
    for (std::size_t i = 0; i < entries[a].loop.size(); ++i)
    {
      EXPECT_EQ(loop[i].halfedge, entries[a].loop[i].halfedge);
      EXPECT_EQ(loop[i].position, entries[a].loop[i].position);
    }
  }
}

TEST_P(Each_system, its_own_loops_make_the_same_system)
{
  const Solved_example<> example(GetParam());
  const System& system = example.system;
  SMF::Poles_and_loops<Mesh> again;
  for (const auto& entry : example.input.entries())
  {
    const std::size_t a = again.size();
    if (entry.pole.size() == 1 && a < system.number_of_arcs() && system.node(a, 0) == a)
      again.add_pole(entry.pole[0], system.loop(a), entry.height);
    else if (!entry.pole.empty())
      again.add_line_pole(entry.pole, entry.height);
    else
      again.add_loop(system.loop(a), entry.height);
  }
  const System second(*example.mesh, again);
  ASSERT_EQ(second.number_of_nodes(), system.number_of_nodes());
  for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
    for (const int end : {0, 1})
      EXPECT_EQ(second.node(a, end), system.node(a, end));
}

TEST_P(Each_system, a_certified_harmonic_foliation_exists)
{
  const Solved_example<> example(GetParam());
  EXPECT_TRUE(example.foliation.statistics().has_converged);
  EXPECT_TRUE(example.foliation.statistics().is_certified);
  EXPECT_LT(example.foliation.statistics().optimality, 1e-12);
}

TEST_P(Each_system, the_ids_of_the_user_do_not_depend_on_the_order_of_loops)
{
  Example reversed = GetParam();
  std::reverse(reversed.items.begin(), reversed.items.end());
  const Solved_example<> first(GetParam()), second(reversed);
  const std::size_t n = first.system.number_of_arcs();
  ASSERT_EQ(second.system.number_of_arcs(), n);
  ASSERT_EQ(second.system.number_of_nodes(), first.system.number_of_nodes());
  std::multiset<std::pair<std::size_t, std::size_t>> nodes[2]; // genus and degree
  for (std::size_t r = 0; r < first.system.number_of_nodes(); ++r)
  {
    nodes[0].emplace(first.system.genus(r), first.system.degree(r));
    nodes[1].emplace(second.system.genus(r), second.system.degree(r));
  }
  EXPECT_EQ(nodes[0], nodes[1]);
  EXPECT_NEAR(second.foliation.statistics().energy, first.foliation.statistics().energy,
              1e-12 * first.foliation.statistics().energy);
  for (std::size_t a = 0; a < n; ++a)
  {
    EXPECT_EQ(second.system.height(n - 1 - a), first.system.height(a));
    EXPECT_NEAR(second.foliation.flux(n - 1 - a), first.foliation.flux(a),
                1e-9 * first.foliation.flux(a));
  }
}

TEST_P(Each_system, copies_share_their_contents_and_live_on)
{
  const auto example = std::make_unique<Solved_example<>>(GetParam());
  auto original = std::make_unique<System>(*example->mesh, example->input);
  const System copy = *original;
  const std::size_t arcs = original->number_of_arcs();
  original.reset();
  example->input = SMF::Poles_and_loops<Mesh>(); // what was given is no longer needed
  EXPECT_EQ(copy.number_of_arcs(), arcs);
  EXPECT_EQ(SMF::harmonic_foliation(copy).statistics().energy,
            example->foliation.statistics().energy);
}

// ===  Systems on one mesh

TEST_P(Each_system, poles_and_loops_on_the_mesh_of_another_make_the_same_system)
{
  const Solved_example<> example(GetParam());
  auto other = std::make_unique<System>(*example.mesh, example.input);
  const System system(*other, example.input);
  other.reset(); // what they shared lives on
  EXPECT_EQ(&system.mesh(), example.mesh.get());
  ASSERT_EQ(system.number_of_nodes(), example.system.number_of_nodes());
  ASSERT_EQ(system.number_of_arcs(), example.system.number_of_arcs());
  for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
    for (const int end : {0, 1})
      EXPECT_EQ(system.node(a, end), example.system.node(a, end));
  EXPECT_EQ(SMF::harmonic_foliation(system).statistics().energy,
            example.foliation.statistics().energy);
}

TEST(Systems_on_one_mesh, are_checked_like_the_first)
{
  const Mesh mesh = smf_test::icosphere(2);
  SMF::Poles_and_loops<Mesh> input;
  input.add_pole(vertex(0));
  input.add_pole(vertex(1));
  const System system(mesh, input);
  input.add_pole(vertex(0));
  const std::vector<SMF::Problem> problems = SMF::validate(mesh, input);
  ASSERT_FALSE(problems.empty());
  try
  {
    System(system, input);
    ADD_FAILURE() << "no exception";
  }
  catch (const SMF::Invalid_loops_exception& exception)
  {
    EXPECT_EQ(exception.problem().message, problems[0].message);
    EXPECT_EQ(exception.problem().kind, problems[0].kind);
  }
}

TEST(Systems_on_one_mesh, have_all_its_openings_as_poles)
{
  const Mesh mesh = smf_test::to_open_mesh(soups::tube(12, {{1, 0}, {1, 1}, {1, 2}, {1, 3}}));
  SMF::Poles_and_loops<Mesh> input;
  SMF::add_border_poles(mesh, input);
  const System system(mesh, input);
  SMF::Poles_and_loops<Mesh> one;
  one.add_border_pole(input.entries()[0].border);
  one.add_pole(vertex(20));
  EXPECT_THROW(System(system, one), SMF::Invalid_mesh_exception);
  input.add_pole(vertex(20)); // of the second ring
  EXPECT_EQ(System(system, input).number_of_poles(), 3u);
}

// ===  Special cases

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

} // namespace test_loop_system_graph
