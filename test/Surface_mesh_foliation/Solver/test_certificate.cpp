// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The certificate refuses foliations that are spoiled, each in its own way, and says how.

#include "include/spoiled_foliations.h"

#include <CGAL/Surface_mesh_foliation/internal/Solver/relax_folds.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/finish_certified.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace test_certificate {

using namespace CGAL::Surface_mesh_foliation::internal;

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
using smf_test::Example;
using smf_test::is_deep_in_arc;
using smf_test::Item;
using smf_test::Solved_example;
using smf_test::Spoiled;
using smf_test::vertex_deep_in_arc;

class Certificate_of_four_poles : public smf_test::Spoiled_four_poles
{};

bool has_neighbor(const Foliation_state& state, int v, int u)
{
  const auto ring = state.mesh().ring(v);
  return std::any_of(ring.begin(), ring.end(), [&](int h) { return state.mesh().target(h) == u; });
}

// the end of the arc of a vertex that lies at a node
int end_at_node(const Foliation_state& state, int v, int node)
{
  return state.node_of_letter(state.half_arc(v, 0)) == node ? 0 : 1;
}

// whether a vertex and all its neighbors but u lie in one arc
bool goes_on_in_arc(const Foliation_state& state, int v, int u)
{
  const auto ring = state.mesh().ring(v);
  return !state.is_at_node(v) && std::all_of(ring.begin(), ring.end(), [&](int h) {
    return state.mesh().target(h) == u || state.word_size(edge_of(h)) == 0;
  });
}

// Puts all neighbors of a vertex at distance two from the pole of arc 0 to the pole's node, so
// that the faces around it become a component of their own. Returns the vertex.
int cut_off_disk(Foliation_state& state)
{
  const int pole = state.system().poles[0][0];
  for (int v = 0; v < state.mesh().number_of_vertices(); ++v)
  {
    if (!is_deep_in_arc(state, v, 0) || has_neighbor(state, v, pole))
      continue;
    const auto ring = state.mesh().ring(v);
    if (std::none_of(ring.begin(), ring.end(),
                     [&](int h) { return has_neighbor(state, state.mesh().target(h), pole); }))
      continue;
    for (int h : ring)
    {
      const int u = state.mesh().target(h);
      state.move_to_node(u, state.half_arc(u, 0));
    }
    return v;
  }
  ADD_FAILURE() << "no vertex";
  return 0;
}

} // namespace

TEST_F(Certificate_of_four_poles, holds_if_nothing_is_spoiled)
{
  EXPECT_TRUE(spoiled.problems().empty());
}

TEST_F(Certificate_of_four_poles, singularity_inside_an_arc)
{
  Foliation_state& state = spoiled.state;
  const int v = vertex_deep_in_arc(state, 2);
  double largest = 0;
  for (int h : state.mesh().ring(v))
    largest = std::max(largest, state.parameter(state.mesh().target(h)));
  state.set_parameter(v, (largest + state.system().height(2)) / 2);
  spoiled.expect_problem("vertex " + std::to_string(v) + " is singular inside arc 2",
                         {static_cast<std::size_t>(v)}, {2});
}

TEST_F(Certificate_of_four_poles, pole_that_is_not_given)
{
  Foliation_state& state = spoiled.state;
  const int v = vertex_deep_in_arc(state, 1);
  state.move_to_node(v, state.half_arc(v, 1));
  spoiled.expect_problem("vertex " + std::to_string(v) +
                           " is a pole of index 2 that is not among the poles given",
                         {static_cast<std::size_t>(v)});
  spoiled.expect_problem("the critical leaf of node 4 is not connected, or meets another");
}

// A fuzzer found it: an edge with a weight of 1e16 times all others holds a vertex so close to a
// node that its parameter is that of the node. A critical leaf that ends there is no mistake.
TEST_F(Certificate_of_four_poles, critical_leaf_that_ends_at_a_vertex)
{
  Foliation_state& state = spoiled.state;
  const Tree_map before = state.map();
  int number_of_ends = 0;
  for (int u = 0; u < state.mesh().number_of_vertices() && number_of_ends < 10; ++u)
  {
    // the leaf goes through u
    if (state.is_free_in_arc(u) && !is_deep_in_arc(state, u, state.arc(u)))
      state.move_to_node(u, state.half_arc(u, end_at_node(state, u, 4)));
    if (state.is_at_node(u) && state.node(u) == 4 && spoiled.problems().empty())
      for (int h : state.mesh().ring(u))
        if (const int v = state.mesh().target(h); goes_on_in_arc(state, v, u))
        {
          const Tree_map with_leaf = state.map();
          state.move_to_node(v, state.half_arc(v, end_at_node(state, v, 4)));
          EXPECT_EQ(index_of_vertex(state, v), 1);
          EXPECT_TRUE(spoiled.problems().empty());
          state.set_map(with_leaf);
          ++number_of_ends;
        }
    state.set_map(before);
  }
  EXPECT_GT(number_of_ends, 0);
}

TEST_F(Certificate_of_four_poles, edge_that_is_a_pole)
{
  Foliation_state& state = spoiled.state;
  const int v = vertex_deep_in_arc(state, 1);
  const auto ring = state.mesh().ring(v);
  const auto is_deep = [&](int h) { return is_deep_in_arc(state, state.mesh().target(h), 1); };
  const auto spoke = std::find_if(ring.begin(), ring.end(), is_deep);
  ASSERT_NE(spoke, ring.end());
  const int u = state.mesh().target(*spoke);
  state.move_to_node(v, state.half_arc(v, 1));
  state.move_to_node(u, state.half_arc(u, 1));
  const int first = std::min(u, v);
  spoiled.expect_problem("vertex " + std::to_string(first) +
                           " is a pole of index 2 that is not among the poles given",
                         {static_cast<std::size_t>(first)});
}

TEST_F(Certificate_of_four_poles, wrong_sum_of_indices)
{
  Foliation_state& state = spoiled.state;
  const int v = vertex_deep_in_arc(state, 1);
  state.move_to_node(v, state.half_arc(v, 1));
  state.fix(v); // as if it were given
  spoiled.expect_problem("the indices at node 4 add up to -2 instead of -4");
  EXPECT_EQ(spoiled.problems()[0].message.find("is a pole"), std::string::npos);
}

TEST_F(Certificate_of_four_poles, middle_leaf_of_another_class)
{
  spoiled.take(solved.foliation.state(), same, same, [](int arc, const Group_word& name) {
    Group_word result = name;
    if (arc == 3) // twice around
      result.insert(result.end(), name.begin(), name.end());
    return result;
  });
  spoiled.expect_problem("the middle leaf of arc 3 is not homotopic to its loop", {}, {3});
  EXPECT_EQ(spoiled.problems().size(), 1u);
}

TEST_F(Certificate_of_four_poles, component_too_many)
{
  cut_off_disk(spoiled.state);
  spoiled.expect_problem("there are 5 components for 4 loops");
}

TEST_F(Certificate_of_four_poles, two_components_of_one_arc)
{
  spoiled.take(solved.foliation.state(), {0, 0, 2, 3}, same);
  spoiled.expect_problem("arc 0 has several components", {}, {0});
}

TEST_F(Certificate_of_four_poles, arcs_at_wrong_nodes)
{
  spoiled.take(solved.foliation.state(), {1, 0, 2, 3}, same);
  spoiled.expect_problem("arc 0 joins nodes", {}, {0});
  spoiled.expect_problem("arc 1 joins nodes", {}, {1});
  const Flat_loop_system& system = spoiled.state.system();
  const std::string instead = " instead of " + std::to_string(system.node_of_end(0, 0)) + " and " +
                              std::to_string(system.node_of_end(0, 1));
  bool is_said = false; // in the order of the component's ends
  for (const SMF::Problem& problem : spoiled.problems())
    is_said = is_said ||
              problem.message.find("arc 0 joins nodes 1 and 4" + instead) != std::string::npos ||
              problem.message.find("arc 0 joins nodes 4 and 1" + instead) != std::string::npos;
  EXPECT_TRUE(is_said);
}

TEST_F(Certificate_of_four_poles, part_of_a_face_in_a_wrong_component)
{
  Foliation_state& state = spoiled.state;
  const int v = vertex_deep_in_arc(state, 2);
  Tree_map map = state.map();
  map.cell[v] = map.cell[vertex_deep_in_arc(state, 1)];
  state.set_map(map);
  spoiled.expect_problem("lies in a wrong component");
}

// Poles 2 and 3 lie above loop 4. The foliation is that of a system with one pole there, which is
// taken for the node between arcs 2, 3 and 4.
TEST(Certificate, missing_critical_leaves)
{
  const smf_test::Triangle_soup sphere = smf_test::soups::icosphere(3);
  const auto extreme = [&](double x, double y, double z) {
    return smf_test::extreme_vertex(sphere, {x, y, z});
  };
  Example all = {"two above", sphere,
                 smf_test::pole_items(
                   {extreme(1, 0, -1), extreme(-1, 0, -1), extreme(1, 0, 1), extreme(-1, 0, 1)})};
  Item above = {Item::SET, {}};
  for (std::size_t v = 0; v < sphere.points.size(); ++v)
    if (sphere.points[v][2] > 0)
      above.vertices.push_back(v);
  all.items.push_back(above);
  const Solved_example<> solved(
    {"one above", sphere,
     smf_test::pole_items({extreme(1, 0, -1), extreme(-1, 0, -1), extreme(0, 0, 1)})});
  Spoiled spoiled(all);
  const Flat_loop_system& system = spoiled.state.system();
  spoiled.take(solved.foliation.state(), {0, 1, 4},
               {0, 1, system.node_of_end(4, 0), system.node_of_end(4, 1)});
  spoiled.expect_problem("there are 4 critical leaves for 6 nodes");
  spoiled.expect_problem("the middle leaf of arc 2 is not homotopic to its loop", {}, {2});
}

TEST(Certificate, component_that_is_no_annulus)
{
  const std::size_t m = 20, n = 14;
  const smf_test::Triangle_soup torus = smf_test::soups::torus(m, n, 3, 1);
  const Solved_example<> solved({"pole", torus, {{Item::POLE, {0}}}});
  Spoiled spoiled(
    {"pole and loop", torus, {{Item::POLE, {0}}, {Item::CYCLE, smf_test::meridian(10, n)}}});
  spoiled.take(solved.foliation.state());
  Foliation_state& state = spoiled.state;
  const int v = cut_off_disk(state);
  Tree_map map = state.map(); // the disk takes the place of the missing annulus
  map.cell[v] = Cell::arc(state.lift(1, {}));
  for (int h : state.mesh().ring(v))
  {
    map.paths.pop_back(edge_of(h));
    map.paths.push_back(edge_of(h), Letter(map.cell[v].lift(), 0));
  }
  state.set_map(map);
  spoiled.expect_problem("the component of arc 1 is not an annulus: Euler characteristic 1, 1 ends",
                         {}, {1});
}

} // namespace test_certificate
