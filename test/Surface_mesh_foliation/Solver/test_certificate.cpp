// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The certificate refuses foliations that are spoiled, each in its own way, and says how.

#include <CGAL/Surface_mesh_foliation/internal/Solver/relax_folds.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/finish_certified.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/settle_at_nodes.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/Extraction.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/certify.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>

#include "include/example_systems.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace test_certificate {

using namespace CGAL::Surface_mesh_foliation::internal;

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
using smf_test::Example;
using smf_test::Item;
using smf_test::Mesh;
using smf_test::Solved_example;

void expect_problem_among(const std::vector<SMF::Problem>& problems,
                          const std::string& message,
                          const std::vector<std::size_t>& vertices = {},
                          const std::vector<std::size_t>& loops = {})
{
  std::string all;
  for (const SMF::Problem& problem : problems)
  {
    EXPECT_EQ(problem.kind, SMF::Problem_kind::CERTIFICATE_FAILURE);
    if (problem.message.find(message) == std::string::npos)
      all += problem.message + '\n';
    else
    {
      EXPECT_EQ(problem.vertices, vertices);
      EXPECT_EQ(problem.loops, loops);
      return;
    }
  }
  ADD_FAILURE() << "not found: " << message << "; but there is\n" << all;
}

// A state of an example's loop system that can be spoiled.
class Spoiled
{
public:
  explicit Spoiled(const Example& example)
    : m_mesh(smf_test::to_mesh(example.soup)),
      m_system(m_mesh, smf_test::poles_and_loops(example.items, m_mesh)),
      state(m_system.data().flat, mean_value_weights(m_system.data().flat.mesh))
  {}

  // Takes over a foliation of the mesh, with other arcs (by number), other nodes and other names of
  // lifts.
  void take(
    const Foliation_state& from,
    const std::vector<int>& arcs,
    const std::vector<int>& nodes,
    const std::function<Group_word(int, const Group_word&)>& name =
      [](int, const Group_word& same) { return same; })
  {
    const auto lift = [&](int old) {
      const int arc = from.lifts().arc(old);
      return state.lift(arcs.at(arc), name(arc, from.lifts().name(old)));
    };
    Tree_map map = from.map();
    for (Cell& cell : map.cell)
      cell = cell.is_node() ? Cell::at_node(nodes.at(cell.node())) : Cell::arc(lift(cell.lift()));
    map.paths = Tree_paths(from.mesh().number_of_edges());
    for (int e = 0; e < from.mesh().number_of_edges(); ++e)
      for (int i = 0; i < from.word_size(e); ++i)
      {
        const Letter letter = from.letter(halfedge_of(e), i);
        map.paths.push_back(e, Letter(lift(letter.lift()), letter.end()));
      }
    state.set_map(std::move(map));
  }

  // as it is
  void take(const Foliation_state& from)
  {
    std::vector<int> all(from.system().nodes.size() + from.system().loops.size());
    std::iota(all.begin(), all.end(), 0);
    take(from, all, all);
  }

  std::vector<SMF::Problem> problems() const { return certify(state, Extraction(state)); }

  void expect_problem(const std::string& message,
                      const std::vector<std::size_t>& vertices = {},
                      const std::vector<std::size_t>& loops = {}) const
  {
    expect_problem_among(problems(), message, vertices, loops);
  }

private:
  Mesh m_mesh;
  SMF::Loop_system<Mesh> m_system;

public:
  Foliation_state state;
};

bool has_neighbor(const Foliation_state& state, int v, int u)
{
  const auto ring = state.mesh().ring(v);
  return std::any_of(ring.begin(), ring.end(), [&](int h) { return state.mesh().target(h) == u; });
}

// whether a vertex and all its neighbors lie in one arc
bool is_deep_in_arc(const Foliation_state& state, int v, int arc)
{
  const auto ring = state.mesh().ring(v);
  return !state.is_at_node(v) && state.arc(v) == arc &&
         std::all_of(ring.begin(), ring.end(),
                     [&](int h) { return state.word_size(edge_of(h)) == 0; });
}

int vertex_deep_in_arc(const Foliation_state& state, int arc)
{
  for (int v = 0; v < state.mesh().number_of_vertices(); ++v)
    if (is_deep_in_arc(state, v, arc))
      return v;
  ADD_FAILURE() << "no vertex";
  return 0;
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

// arcs 0 to 3 of the poles meet at node 4
Example four_poles()
{
  const smf_test::Triangle_soup sphere = smf_test::soups::icosphere(3);
  return {"four poles", sphere, smf_test::pole_items({0, 1, 2, 3})};
}

class Certificate_of_four_poles : public ::testing::Test
{
protected:
  Certificate_of_four_poles() : solved(four_poles()), spoiled(four_poles())
  {
    spoiled.take(solved.foliation.state());
  }

  const std::vector<int> same = {0, 1, 2, 3, 4};
  Solved_example<> solved;
  Spoiled spoiled;
};

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

// What differs from a node by rounding only goes there, and nothing else.
TEST_F(Certificate_of_four_poles, vertices_beside_a_node_settle_there)
{
  Foliation_state& state = spoiled.state;
  settle_at_nodes(state); // on a sphere that is so regular, some vertices lie there
  EXPECT_FALSE(settle_at_nodes(state));
  EXPECT_TRUE(spoiled.problems().empty());
  for (const int arc : {0, 1, 2, 3})
  {
    const int end = state.system().nodes[state.system().nodes_of_arc[arc][0]].pole < 0 ? 0 : 1;
    const double height = state.system().height(arc);
    const auto distance = [&](int v) {
      return state.is_at_node(v) || state.arc(v) != arc ? height
             : end == 0                                 ? state.parameter(v)
                                                        : height - state.parameter(v);
    };
    int nearest = 0;
    for (int v = 0; v < state.mesh().number_of_vertices(); ++v)
      if (distance(v) < distance(nearest))
        nearest = v;
    state.set_parameter(nearest, end == 0 ? 1e-15 * height : (1 - 1e-15) * height);
    const std::vector<Cell> before = state.map().cell;
    EXPECT_TRUE(settle_at_nodes(state));
    EXPECT_TRUE(state.is_at_node(nearest) && state.node(nearest) == 4);
    for (int v = 0; v < state.mesh().number_of_vertices(); ++v)
      EXPECT_TRUE(v == nearest || state.map().cell[v] == before[v]);
    EXPECT_TRUE(spoiled.problems().empty());
  }
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

// What has been extracted is wrong, not the foliation.
TEST_F(Certificate_of_four_poles, critical_leaf_at_no_node)
{
  Extraction extraction(spoiled.state);
  std::vector<int>& node = extraction.refined_mesh.node;
  int v = 0;
  while (extraction.leaf_graph.leaf_of_vertex(v) < 0)
    ++v;
  node[v] = Refined_mesh::NONE;
  expect_problem_among(certify(spoiled.state, extraction),
                       "vertex " + std::to_string(v) + " of a critical leaf lies at no node");
}

TEST_F(Certificate_of_four_poles, each_node_without_its_singularities)
{
  for (const int node : same)
  {
    Extraction extraction(spoiled.state);
    std::vector<Singular_place>& places = extraction.singular_places;
    places.erase(std::remove_if(places.begin(), places.end(),
                                [&](const Singular_place& place) { return place.node == node; }),
                 places.end());
    expect_problem_among(certify(spoiled.state, extraction),
                         "the indices at node " + std::to_string(node) + " add up to 0 instead of");
  }
}

TEST_F(Certificate_of_four_poles, each_arc_without_its_middle_leaf)
{
  for (const std::size_t arc : {0, 1, 2, 3})
  {
    Extraction extraction(spoiled.state);
    extraction.middle_leaves[arc].clear();
    expect_problem_among(
      certify(spoiled.state, extraction),
      "the middle leaf of arc " + std::to_string(arc) + " is not homotopic to its loop", {}, {arc});
  }
}

// One leaf is that of the arc, and one is not; the latter is one of arc 2, whose lifts have wrong
// names.
TEST_F(Certificate_of_four_poles, middle_leaf_beside_the_right_one)
{
  spoiled.take(solved.foliation.state(), same, same, [](int arc, const Group_word& name) {
    Group_word result = name;
    if (arc == 2)
      result.insert(result.end(), name.begin(), name.end());
    return result;
  });
  Extraction extraction(spoiled.state);
  extraction.middle_leaves[3].insert(extraction.middle_leaves[3].end(),
                                     extraction.middle_leaves[2].begin(),
                                     extraction.middle_leaves[2].end());
  expect_problem_among(certify(spoiled.state, extraction),
                       "the middle leaf of arc 3 is not homotopic to its loop", {}, {3});
}

TEST_F(Certificate_of_four_poles, component_with_a_handle)
{
  Extraction extraction(spoiled.state);
  auto& component = const_cast<Leaf_graph::Component&>(extraction.leaf_graph.components()[0]);
  component.euler_characteristic = -2;
  const int arc = extraction.refined_mesh.faces[component.first_face].arc;
  expect_problem_among(certify(spoiled.state, extraction),
                       "is not an annulus: Euler characteristic -2, 2 ends", {},
                       {static_cast<std::size_t>(arc)});
}

TEST_F(Certificate_of_four_poles, thorn_that_is_not_given)
{
  Extraction extraction(spoiled.state);
  const int v = vertex_deep_in_arc(spoiled.state, 1);
  extraction.singular_places.push_back({false, v, 1, 4});
  expect_problem_among(certify(spoiled.state, extraction),
                       "vertex " + std::to_string(v) +
                         " is a pole of index 1 that is not among the poles given",
                       {static_cast<std::size_t>(v)});
}

TEST_F(Certificate_of_four_poles, component_in_no_arc)
{
  Extraction extraction(spoiled.state);
  const int first = extraction.leaf_graph.components()[0].first_face;
  const int other = extraction.leaf_graph.components()[1].first_face;
  extraction.refined_mesh.faces[first].arc = Refined_mesh::NONE;
  expect_problem_among(certify(spoiled.state, extraction), "a component lies in no arc");
  extraction.refined_mesh.faces[first].arc = extraction.refined_mesh.faces[other].arc;
  expect_problem_among(certify(spoiled.state, extraction), "has several components", {},
                       {static_cast<std::size_t>(extraction.refined_mesh.faces[other].arc)});
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
