// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Surface_mesh_foliation/internal/Foliation/leaves_in_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Tree_map.h>
#include <CGAL/Surface_mesh_foliation/Supernodal_cholesky_solver.h>
#include <CGAL/Surface_mesh_foliation/edge_weights.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/certify.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/forces.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/leaves_in_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Newton_solver.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Tripod.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/grow_fronts.h>

#include "include/flat_systems.h"
#include "include/random_systems.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace test_foliation_state {

using namespace CGAL::Surface_mesh_foliation::internal;
using namespace smf_test;

namespace {

// A random system with its state, put away on the heap since a state does not move.
struct Case
{
  explicit Case(std::uint64_t seed)
  {
    Random random(seed);
    do
    {
      mesh = random_mesh(random);
      items = Random_items(mesh, random)();
    } while (items.empty());
    system = std::make_unique<SMF::Loop_system<Mesh>>(mesh, poles_and_loops(items, mesh));
    const Flat_loop_system& flat = system->data().flat;
    state = std::make_unique<Foliation_state>(flat, mean_value_weights(flat.mesh));
  }

  Mesh mesh;
  std::vector<Item> items;
  std::unique_ptr<SMF::Loop_system<Mesh>> system;
  std::unique_ptr<Foliation_state> state;
};

void expect_words_are_geodesics(const Foliation_state& state)
{
  for (int e = 0; e < state.mesh().number_of_edges(); ++e)
  {
    for (int i = 1; i < state.word_size(e); ++i)
      ASSERT_TRUE(state.letter(halfedge_of(e), i) != state.letter(halfedge_of(e), i - 1))
        << "edge " << e;
    const bool are_both_arcs_or_nodes = state.is_at_node(state.mesh().source(halfedge_of(e))) ==
                                        state.is_at_node(state.mesh().target(halfedge_of(e)));
    ASSERT_EQ(state.word_size(e) % 2 == 0, are_both_arcs_or_nodes) << "edge " << e;
  }
}

void expect_images_of_triangles_are_tripods(const Foliation_state& state)
{
  for (int f = 0; f < state.mesh().number_of_faces(); ++f)
  {
    const Tripod tripod(state, f);
    for (int i : {0, 1, 2})
    {
      ASSERT_GE(tripod.leg(i), 0) << "face " << f;
      const int e = edge_of(tripod.out(i)), next = (i + 1) % 3;
      ASSERT_EQ(tripod.leg(i) + tripod.leg(next), state.word_size(e));
      if (!tripod.is_center_arc())
      {
        ASSERT_NEAR(tripod.length_of_leg(i) + tripod.length_of_leg(next), length_of_edge(state, e),
                    1e-12);
      }
    }
  }
}

// Two adjacent spokes begin in the same direction iff their corner has a leg: the names of lifts
// and the lengths of words are independent evidence.
void expect_directions_agree_with_legs(const Foliation_state& state)
{
  for (int f = 0; f < state.mesh().number_of_faces(); ++f)
  {
    const Tripod tripod(state, f);
    for (int i : {0, 1, 2})
    {
      const int h = tripod.out(i), g = tripod.other_out(i);
      if (state.is_fixed(tripod.corner(i)) || state.word_size(edge_of(h)) == 0 ||
          state.word_size(edge_of(g)) == 0)
        continue;
      ASSERT_EQ(tripod.leg(i) > 0, state.first_letter(h) == state.first_letter(g)) << "face " << f;
    }
  }
}

// The lengths of stretches of an edge add up to its own.
void expect_lengths_agree(const Foliation_state& state)
{
  for (int h = 0; h < state.mesh().number_of_halfedges(); ++h)
  {
    const int n = state.word_size(edge_of(h)), v = state.mesh().target(h);
    if (n == 0 && state.is_at_node(v))
      continue;
    const double length = state.is_at_node(v)
                            ? length_up_to(state, h, n - 1, parameter_of_passage(state, h, n - 1))
                            : length_up_to(state, h, n, state.parameter(v));
    ASSERT_NEAR(length, length_of_edge(state, edge_of(h)), 1e-12 * (1 + length));
  }
}

// A lift has one name in the frame of a face, whichever edge it is met on, and in those of two
// neighbors names that differ by the element between them.
void expect_names_agree(const Foliation_state& state)
{
  const Surface_group& group = state.deck().group();
  for (int h = 0; h < state.mesh().number_of_halfedges(); ++h)
  {
    const int n = state.word_size(edge_of(h));
    for (int cell = 0; cell <= n; ++cell)
      if (is_cell_arc(state, h, cell))
      {
        ASSERT_TRUE(group.are_equal(
          state.lifts().transported(state.name_of_cell(h, cell), state.deck().element(h)),
          state.name_of_cell(opposite_of(h), n - cell)));
      }
    if (is_cell_arc(state, h, n))
    {
      ASSERT_TRUE(
        group.are_equal(state.name_of_cell(h, n), state.name_of_cell(state.mesh().next(h), 0)));
    }
  }
}

void expect_is_map(const Foliation_state& state)
{
  for (int v = 0; v < state.mesh().number_of_vertices(); ++v)
    EXPECT_TRUE(!state.is_at_node(v) || state.parameter(v) == 0);
  expect_names_agree(state);
  expect_lengths_agree(state);
  expect_words_are_geodesics(state);
  expect_images_of_triangles_are_tripods(state);
  expect_directions_agree_with_legs(state);
}

// moves a vertex over some half-arc, if it can move at all
void move_somewhere(Foliation_state& state, int v, Random& random)
{
  if (state.is_fixed(v))
    return;
  if (!state.is_at_node(v))
    return state.move_to_node(v, state.half_arc(v, static_cast<int>(random.index(2))));
  Directions directions;
  find_directions(state, v, directions);
  if (directions.letters.empty())
    return;
  const Letter letter = directions.letters[random.index(directions.letters.size())];
  state.move_into_arc(v, letter, random.between(0.1, 0.9) * state.length_of_arc(letter));
}

} // namespace

TEST(Foliation_statistics, say_nothing_at_first)
{
  const SMF::Foliation_statistics statistics;
  EXPECT_EQ(statistics.number_of_iterations, 0u);
  EXPECT_EQ(statistics.energy, 0);
  EXPECT_EQ(statistics.optimality, 0);
  EXPECT_EQ(statistics.resolved_optimality, 0);
  EXPECT_EQ(statistics.number_of_moves, 0u);
  EXPECT_EQ(statistics.number_of_changed_vertices, 0u);
  EXPECT_FALSE(statistics.has_converged);
  EXPECT_FALSE(statistics.is_certified);
}

TEST(Foliation_state, has_the_executor_that_is_set)
{
  const Case c(1);
  EXPECT_EQ(&c.state->executor(), &executor_for<CGAL::Sequential_tag>());
  const Executor other;
  c.state->set_executor(other);
  EXPECT_EQ(&c.state->executor(), &other);
}

TEST(Foliation_state, leaves_in_loops_are_a_map)
{
  for (std::uint64_t seed = 1; seed <= 15; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Case c(seed);
    expect_is_map(*c.state);
  }
}

// On a torus the tree is a line: to the left and to the right of a node are different lifts.
TEST(Leaves_in_loops, of_a_torus_lead_along_a_line)
{
  const Flat_loop_system system = torus_with_one_loop();
  const Foliation_state state(system, unit_weights(system));
  for (int v = 0; v < system.mesh.number_of_vertices(); ++v)
  {
    Directions directions;
    find_directions(state, v, directions);
    ASSERT_EQ(directions.size(), 2);
    EXPECT_NE(directions.letters[0].lift(), directions.letters[1].lift());
    EXPECT_NE(directions.letters[0].end(), directions.letters[1].end());
  }
  expect_is_map(state);
}

// Each crossing is a passage over both ends of a lift of its loop.
TEST(Leaves_in_loops, pass_one_arc_at_each_crossing)
{
  int number_of_passages = 0;
  for (std::uint64_t seed = 1; seed <= 15; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Case c(seed);
    const Flat_loop_system& flat = c.system->data().flat;
    const Deck_cocycle deck(flat.mesh, flat.poles);
    Lifts lifts(deck);
    const Tree_map map = leaves_in_loops(flat, deck, lifts);
    for (int v = 0; v < flat.mesh.number_of_vertices(); ++v)
      EXPECT_TRUE(map.cell[v] == Cell::at_node(flat.node_of_vertex[v])) << "vertex " << v;
    for (int e = 0; e < flat.mesh.number_of_edges(); ++e)
    {
      if (map.paths.size(e) != 2 * flat.crossings.size(e))
        continue; // a loop crosses to and fro
      for (int i = 0; i < flat.crossings.size(e); ++i)
      {
        const Edge_crossings::Entry& entry = flat.crossings.entry(e, i);
        const Letter first = map.paths(e, 2 * i);
        EXPECT_EQ(lifts.arc(first.lift()), entry.loop);
        EXPECT_EQ(first.end(), is_forward(entry.halfedge) ? 1 : 0);
        EXPECT_TRUE(map.paths(e, 2 * i + 1) == first.other_end());
        ++number_of_passages;
      }
    }
  }
  EXPECT_GT(number_of_passages, 100);
}

TEST(Foliation_state, any_moves_leave_a_map)
{
  for (std::uint64_t seed = 1; seed <= 12; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Case c(seed);
    Random random(seed);
    for (int i = 0; i < 3 * c.state->mesh().number_of_vertices(); ++i)
      move_somewhere(*c.state, static_cast<int>(random.index(c.state->mesh().number_of_vertices())),
                     random);
    expect_is_map(*c.state);
  }
}

TEST(Foliation_state, a_move_and_its_reverse_change_nothing)
{
  for (std::uint64_t seed = 1; seed <= 12; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Case c(seed);
    Foliation_state& state = *c.state;
    grow_fronts(state);
    for (int v = 0; v < state.mesh().number_of_vertices(); ++v)
    {
      if (!state.is_free_in_arc(v))
        continue;
      std::vector<Letter> before, after;
      for (int h : state.mesh().ring(v))
        before.push_back(state.word_size(edge_of(h)) == 0 ? Letter() : state.first_letter(h));
      const Letter letter = state.half_arc(v, static_cast<int>(seed % 2));
      const double t = state.parameter(v);
      state.move_to_node(v, letter);
      EXPECT_TRUE(state.is_at_node(v));
      state.move_into_arc(v, letter, t);
      for (int h : state.mesh().ring(v))
        after.push_back(state.word_size(edge_of(h)) == 0 ? Letter() : state.first_letter(h));
      EXPECT_TRUE(before == after) << "vertex " << v;
    }
  }
}

// Up is toward end 1. A vertex that comes to a node, and leaves it over another half-arc, goes on
// in the same direction, though up may have become down.
TEST(Foliation_state, vertices_keep_their_headings_at_nodes)
{
  int number_of_turns = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
  {
    Case c(seed);
    Foliation_state& state = *c.state;
    grow_fronts(state);
    Random random(seed);
    for (int v = 0; v < state.mesh().number_of_vertices(); ++v)
    {
      if (!state.is_free_in_arc(v))
        continue;
      const int before = state.orientation(v), end = static_cast<int>(random.index(2));
      const int heading = end == 1 ? before : -before;
      state.move_to_node(v, state.half_arc(v, end));
      EXPECT_EQ(state.orientation(v), heading);
      Directions directions;
      find_directions(state, v, directions);
      const Letter letter = directions.letters.back();
      state.move_into_arc(v, letter, state.length_of_arc(letter) / 2);
      EXPECT_EQ(state.orientation(v), letter.end() == 0 ? heading : -heading);
      number_of_turns += state.orientation(v) != before;
    }
  }
  EXPECT_GT(number_of_turns, 10);
}

// In front growth a vertex moves only where all its leaves already go: the result is certified.
TEST(Foliation_state, fronts_are_certified)
{
  for (std::uint64_t seed = 1; seed <= 15; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Case c(seed);
    grow_fronts(*c.state);
    expect_is_map(*c.state);
    EXPECT_TRUE(certify(*c.state, Extraction(*c.state)).empty());
  }
}

TEST(Foliation_state, newton_never_raises_the_energy_and_keeps_the_map)
{
  for (std::uint64_t seed = 1; seed <= 15; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Case c(seed);
    grow_fronts(*c.state);
    SMF::Supernodal_cholesky_solver linear_solver;
    Newton_solver solve(*c.state, linear_solver);
    Solver_options options;
    double energy = std::numeric_limits<double>::infinity();
    options.goes_on = [&](const SMF::Foliation_statistics& iteration) {
      EXPECT_LE(iteration.energy, energy * (1 + 1e-12));
      energy = iteration.energy;
      expect_words_are_geodesics(*c.state);
      expect_images_of_triangles_are_tripods(*c.state);
      return true;
    };
    EXPECT_TRUE(solve(options).has_converged);
    expect_is_map(*c.state);
  }
}

TEST(Foliation_state, newton_stops_when_it_is_told_to)
{
  Case c(1);
  grow_fronts(*c.state);
  SMF::Supernodal_cholesky_solver linear_solver;
  Newton_solver solve(*c.state, linear_solver);
  Solver_options options;
  options.goes_on = [](const SMF::Foliation_statistics&) { return false; };
  EXPECT_EQ(solve(options).number_of_iterations, 1u);
  expect_is_map(*c.state);
}

// ===  The certificate finds what is wrong

namespace {

// a solved state of a sphere with five limbs
Case solved()
{
  Case c(1);
  c.mesh = limbed_sphere(5, 3);
  Input input;
  for (std::size_t v : {0, 20, 60, 150, 300})
    input.add_pole(Vertex(static_cast<Mesh::size_type>(v)));
  c.system = std::make_unique<SMF::Loop_system<Mesh>>(c.mesh, input);
  const Flat_loop_system& flat = c.system->data().flat;
  c.state = std::make_unique<Foliation_state>(flat, mean_value_weights(flat.mesh));
  grow_fronts(*c.state);
  SMF::Supernodal_cholesky_solver linear_solver;
  Newton_solver solve(*c.state, linear_solver);
  EXPECT_TRUE(solve(Solver_options()).has_converged);
  EXPECT_TRUE(certify(*c.state, Extraction(*c.state)).empty());
  return c;
}

// a free vertex all of whose neighbors lie in its arc
int vertex_inside_arc(const Foliation_state& state)
{
  for (int v = 0; v < state.mesh().number_of_vertices(); ++v)
  {
    bool is_inside = state.is_free_in_arc(v);
    for (int h : state.mesh().ring(v))
      is_inside = is_inside && state.word_size(edge_of(h)) == 0;
    if (is_inside)
      return v;
  }
  return -1;
}

} // namespace

TEST(Certificate_of_state, finds_an_extremum_inside_an_arc)
{
  const Case c = solved();
  const int v = vertex_inside_arc(*c.state);
  ASSERT_GE(v, 0);
  c.state->set_parameter(v, 0.999999 * c.system->height(c.state->arc(v)));
  const std::vector<SMF::Problem> problems = certify(*c.state, Extraction(*c.state));
  ASSERT_FALSE(problems.empty());
  EXPECT_NE(problems[0].message.find("singular inside arc"), std::string::npos);
}

TEST(Certificate_of_state, finds_a_pole_that_is_not_given)
{
  const Case c = solved();
  const int v = vertex_inside_arc(*c.state);
  ASSERT_GE(v, 0);
  // to the node of the saddle leaf, which lies at the end without pole
  const int arc = c.state->arc(v);
  const int end = c.system->pole(c.system->node(arc, 0)) >= 0 ? 1 : 0;
  c.state->move_to_node(v, c.state->half_arc(v, end));
  const std::vector<SMF::Problem> problems = certify(*c.state, Extraction(*c.state));
  ASSERT_FALSE(problems.empty());
  EXPECT_NE(problems[0].message.find("not among the poles given"), std::string::npos);
  bool finds_extra_leaf = false;
  for (const SMF::Problem& problem : problems)
    finds_extra_leaf |= problem.message.find("critical leaf") != std::string::npos;
  EXPECT_TRUE(finds_extra_leaf);
}

} // namespace test_foliation_state
