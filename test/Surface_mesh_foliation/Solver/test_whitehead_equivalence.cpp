// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Foliations that differ by Whitehead moves are equivalent [3.1]: singularities that are split and
// merged along a critical leaf are others, but components and graph stay as they are.

#include "include/component_graph.h"
#include "include/example_systems.h"

#include <CGAL/Surface_mesh_foliation/Supernodal_cholesky_solver.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/forces.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/lengths.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Tripod.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Newton_solver.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Singular_places.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/grow_fronts.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/singular_points.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/weights_of_flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_matching.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace test_whitehead_equivalence {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
using namespace SMF::internal;
using smf_test::Example;
using smf_test::Mesh;
using smf_test::Solved_example;

using Foliation = SMF::Measured_foliation<Mesh>;
using Singularities = std::vector<std::tuple<bool, int, int, int>>; // face?, place, index, node

// A foliation whose leaves can be moved over its vertices.
class Movable_foliation
{
public:
  explicit Movable_foliation(const SMF::Loop_system<Mesh>& system)
    : m_data(
        std::make_shared<Foliation_data<Mesh>>(system, mean_value_weights(system.data().flat.mesh)))
  {
    grow_fronts(state());
    relax_to_the_minimum();
  }

  Foliation_state& state() { return m_data->state; }

  void relax_to_the_minimum()
  {
    SMF::Supernodal_cholesky_solver linear_solver;
    EXPECT_TRUE(Newton_solver(state(), linear_solver)(Solver_options()).has_converged);
  }

  // whether the foliation is one of the class, and no leaf ends at a vertex that is no pole
  bool certify()
  {
    m_data->extraction.emplace(m_data->state);
    for (int v = 0; v < state().mesh().number_of_vertices(); ++v)
      if (is_end_of_leaf(v))
        return false;
    return m_data->problems().empty();
  }

  Singularities singularities() const
  {
    Singularities result;
    for (const Singular_place& place : m_data->extraction->singular_places)
      result.emplace_back(place.is_face, place.place, place.index, place.node);
    return result;
  }

  // in the same order
  std::vector<Point> singular_points() const
  {
    return SMF::internal::singular_points(*m_data->extraction);
  }

  // shares the state; precondition: it is certified
  Foliation foliation() const { return Foliation(m_data); }

private:
  // Such foliations are certified, too, but no Whitehead move leads to them.
  bool is_end_of_leaf(int v)
  {
    const auto ring = state().mesh().ring(v);
    return state().is_at_node(v) && !state().is_fixed(v) && index_of_vertex(state(), v) > 0 &&
           std::none_of(ring.begin(), ring.end(),
                        [&](int h) { return Tripod(state(), state().mesh().face(h)).is_zero(); });
  }

  std::shared_ptr<Foliation_data<Mesh>> m_data;
};

// the indices at each node, in ascending order
std::map<int, std::vector<int>> indices(const Singularities& singularities)
{
  std::map<int, std::vector<int>> result;
  for (const auto& [is_face, place, index, node] : singularities)
    result[node].push_back(index);
  for (auto& entry : result)
    std::sort(entry.second.begin(), entry.second.end());
  return result;
}

// A Whitehead move at a vertex next to a singularity: over the half-arc `letter`, from its node
// into the arc or back.
struct Move
{
  int vertex;
  Letter letter;
};

std::vector<Move> moves_near(const Singularities& singularities, const Foliation_state& state)
{
  std::set<int> vertices;
  for (const auto& [is_face, place, index, node] : singularities)
    if (is_face)
      for (int h : state.mesh().halfedges(place))
        vertices.insert(state.mesh().source(h));
    else
    {
      vertices.insert(place);
      for (int h : state.mesh().ring(place))
        vertices.insert(state.mesh().target(h));
    }
  std::vector<Move> result;
  Directions directions;
  for (int v : vertices)
  {
    if (state.is_fixed(v))
      continue;
    if (!state.is_at_node(v))
    {
      result.push_back({v, state.half_arc(v, 0)});
      result.push_back({v, state.half_arc(v, 1)});
      continue;
    }
    find_directions(state, v, directions);
    for (Letter letter : directions.letters)
      result.push_back({v, letter});
  }
  return result;
}

// how far the nearest neighbor in the direction is inside the arc, at most to its other end
double reach(const Foliation_state& state, const Move& move)
{
  double result = state.length_of_arc(move.letter);
  for (int h : state.mesh().ring(move.vertex))
    if (state.word_size(edge_of(h)) == 1 && state.first_letter(h) == move.letter)
      result = (std::min)(
        result, state.distance_to_end(move.letter, state.parameter(state.mesh().target(h))));
  return result;
}

void make(const Move& move, Foliation_state& state)
{
  if (!state.is_at_node(move.vertex))
    return state.move_to_node(move.vertex, move.letter);
  const double step = reach(state, move) / 2;
  state.move_into_arc(move.vertex, move.letter,
                      move.letter.end() == 0 ? step : state.length_of_arc(move.letter) - step);
}

SMF::Reeb_graph<Mesh::Point> graph_of(const Foliation& foliation)
{
  SMF::Reeb_graph<Mesh::Point> result;
  SMF::reeb_graph(foliation, result);
  return result;
}

std::vector<double> edge_values(const Foliation_state& state)
{
  std::vector<double> result;
  for (int e = 0; e < state.mesh().number_of_edges(); ++e)
    result.push_back(length_of_edge(state, e));
  return result;
}

void expect_same_components_and_graph(const Foliation& foliation,
                                      const smf_test::Incidences& incidences,
                                      const SMF::Reeb_graph<Mesh::Point>& graph)
{
  const smf_test::Cut_mesh cut(foliation);
  smf_test::expect_same_surface(cut, foliation.mesh());
  smf_test::expect_annuli(cut, foliation.system().number_of_arcs());
  EXPECT_EQ(smf_test::Component_graph(cut).incidences(), incidences);
  EXPECT_TRUE(SMF::reeb_graphs_are_isomorphic(graph_of(foliation), graph));
}

// the two singularities of one node that are closest to each other
Singularities closest_pair(const Movable_foliation& moved)
{
  const Singularities all = moved.singularities();
  const std::vector<Point> points = moved.singular_points();
  Singularities result;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (std::get<3>(all[i]) == std::get<3>(all[j]) && distance(points[i], points[j]) < least)
      {
        least = distance(points[i], points[j]);
        result = {all[i], all[j]};
      }
  return result;
}

double distance_of_closest_pair(const Movable_foliation& moved)
{
  const Singularities all = moved.singularities(), pair = closest_pair(moved);
  const std::vector<Point> points = moved.singular_points();
  std::vector<Point> ends;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (std::find(pair.begin(), pair.end(), all[i]) != pair.end())
      ends.push_back(points[i]);
  return ends.size() == 2 ? distance(ends[0], ends[1]) : std::numeric_limits<double>::infinity();
}

// what is counted on the way; others are singularities that move along their leaf
struct Walk
{
  int splits = 0, merges = 0, others = 0;
};

// Goes on from an equivalent foliation to the next, and looks at each.
class Walker
{
public:
  explicit Walker(Movable_foliation& moved) : m_moved(moved)
  {
    m_incidences = smf_test::Component_graph(smf_test::Cut_mesh(moved.foliation())).incidences();
    m_graph = graph_of(moved.foliation());
  }

  // Moves the two closest singularities of a node toward each other until one is left.
  bool merge()
  {
    const std::size_t before = m_moved.singularities().size();
    for (int step = 0; step < 60 && m_moved.singularities().size() >= before; ++step)
      take_best(
        [&] {
          return m_moved.singularities().size() < before ? -1 : distance_of_closest_pair(m_moved);
        },
        closest_pair(m_moved));
    return m_moved.singularities().size() < before;
  }

  // Takes a singularity apart.
  bool split()
  {
    const std::size_t before = m_moved.singularities().size();
    Singularities candidates;
    for (const auto& singularity : m_moved.singularities())
      if (std::get<2>(singularity) < -1)
        candidates.push_back(singularity);
    if (!candidates.empty())
      take_best([&] { return -static_cast<double>(m_moved.singularities().size()); }, candidates);
    return m_moved.singularities().size() > before;
  }

  const Walk& walk() const { return m_walk; }

private:
  // Tries the moves next to the given singularities, and makes the one that stays in the class and
  // gives the least value; rather one that leads to singularities not seen before.
  template <class Value>
  void take_best(const Value& value, const Singularities& singularities)
  {
    const Tree_map start = m_moved.state().map();
    const Singularities before = m_moved.singularities();
    std::vector<std::pair<double, Tree_map>> found;
    for (const Move& move : moves_near(singularities, m_moved.state()))
    {
      make(move, m_moved.state());
      if (m_moved.certify() && m_moved.singularities() != before)
        found.emplace_back(value() + (m_seen.count(m_moved.singularities()) != 0 ? 1e6 : 0),
                           m_moved.state().map());
      m_moved.state().set_map(start);
    }
    if (!found.empty())
      m_moved.state().set_map(
        std::min_element(found.begin(), found.end(), [](const auto& a, const auto& b) {
          return a.first < b.first;
        })->second);
    ASSERT_TRUE(m_moved.certify());
    note(before);
  }

  void note(const Singularities& before)
  {
    const Singularities after = m_moved.singularities();
    m_seen.insert(after);
    if (after == before)
      return;
    ++(after.size() > before.size()   ? m_walk.splits
       : after.size() < before.size() ? m_walk.merges
                                      : m_walk.others);
    expect_same_components_and_graph(m_moved.foliation(), m_incidences, m_graph);
  }

  Movable_foliation& m_moved;
  smf_test::Incidences m_incidences;
  SMF::Reeb_graph<Mesh::Point> m_graph;
  std::set<Singularities> m_seen;
  Walk m_walk;
};

// genus 0, 1, 2 and 4
std::vector<Example> examples()
{
  std::vector<Example> result;
  for (const Example& example : smf_test::all_example_systems())
    if (example.name == "limbs" || example.name == "torus with poles" || example.name == "theta" ||
        example.name == "dumbbell" || example.name == "rough surface")
      result.push_back(example);
  return result;
}

class Whitehead_moves_of_example : public ::testing::TestWithParam<Example>
{
protected:
  Whitehead_moves_of_example() : solved(GetParam()) {}

  Solved_example<> solved;
};

INSTANTIATE_TEST_SUITE_P(Examples,
                         Whitehead_moves_of_example,
                         ::testing::ValuesIn(examples()),
                         smf_test::name_of_example);

TEST_P(Whitehead_moves_of_example, splits_and_merges_keep_components_and_graph)
{
  Movable_foliation moved(solved.system);
  ASSERT_TRUE(moved.certify());
  const Singularities before = moved.singularities();
  const std::vector<double> values = edge_values(moved.state());
  Walker walker(moved);
  for (int round = 0; round < 3; ++round)
  {
    EXPECT_TRUE(walker.merge()) << "round " << round;
    const auto merged = indices(moved.singularities());
    EXPECT_TRUE(walker.split()) << "round " << round;
    EXPECT_NE(indices(moved.singularities()), merged);
  }
  RecordProperty("merges", walker.walk().merges);
  RecordProperty("splits", walker.walk().splits);
  RecordProperty("others", walker.walk().others);
  EXPECT_NE(moved.singularities(), before);

  // one class has one harmonic foliation
  moved.relax_to_the_minimum();
  ASSERT_TRUE(moved.certify());
  const std::vector<double> again = edge_values(moved.state());
  const double largest = *std::max_element(values.begin(), values.end());
  for (std::size_t e = 0; e < values.size(); ++e)
    EXPECT_NEAR(again[e], values[e], 1e-9 * largest);
}

// A move and the one back.
TEST_P(Whitehead_moves_of_example, moves_can_be_undone)
{
  Movable_foliation moved(solved.system);
  ASSERT_TRUE(moved.certify());
  const Singularities before = moved.singularities();
  const std::vector<double> values = edge_values(moved.state());
  int undone = 0;
  for (const Move& move : moves_near(before, moved.state()))
  {
    const double t = moved.state().parameter(move.vertex);
    const bool was_at_node = moved.state().is_at_node(move.vertex);
    make(move, moved.state());
    if (moved.certify() && moved.singularities() != before)
      ++undone;
    if (was_at_node)
      moved.state().move_to_node(move.vertex, move.letter);
    else
      moved.state().move_into_arc(move.vertex, move.letter, t);
    ASSERT_TRUE(moved.certify());
    EXPECT_EQ(moved.singularities(), before);
    EXPECT_EQ(edge_values(moved.state()), values);
  }
  EXPECT_GT(undone, 0);
}

} // namespace

} // namespace test_whitehead_equivalence
