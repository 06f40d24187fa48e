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
#include <CGAL/Surface_mesh_foliation/openings.h>

#include <boost/pending/disjoint_sets.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <set>
#include <vector>

namespace test_loop_system_graph {

// The dual graph of a loop system, and systems on one mesh.

namespace {

using smf_test::ends;
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

} // namespace

} // namespace test_loop_system_graph
