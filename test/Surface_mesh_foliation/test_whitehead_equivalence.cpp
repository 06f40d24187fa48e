// Foliations that differ by Whitehead moves are equivalent [3.1]: singularities that are split and
// merged along a critical leaf are others, but components and graph stay as they are.

#include "include/component_graph.h"
#include "include/example_systems.h"
#include "include/test_random.h"

#include <CGAL/Surface_mesh_foliation/Simplicial_cholesky_solver.h>
#include <CGAL/Surface_mesh_foliation/internal/Newton_solver.h>
#include <CGAL/Surface_mesh_foliation/internal/Singular_places.h>
#include <CGAL/Surface_mesh_foliation/internal/grow_fronts.h>
#include <CGAL/Surface_mesh_foliation/internal/weights_of_flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_matching.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace {

namespace smf = CGAL::Surface_mesh_foliation;
using namespace smf::internal;
using smf_test::Example;
using smf_test::Mesh;
using smf_test::Random;
using smf_test::Solved_example;

using Foliation = smf::Measured_foliation<Mesh>;
using Singularities = std::vector<std::tuple<bool, int, int, int>>; // face?, place, index, node

// A foliation whose leaves can be moved over its vertices.
class Movable_foliation
{
public:
  explicit Movable_foliation(const smf::Loop_system<Mesh>& system)
    : m_data(
        std::make_shared<Foliation_data<Mesh>>(system, mean_value_weights(system.data().flat.mesh)))
  {
    grow_fronts(state());
    relax_to_the_minimum();
  }

  Foliation_state& state() { return m_data->state; }

  void relax_to_the_minimum()
  {
    smf::Simplicial_cholesky_solver linear_solver;
    EXPECT_TRUE(Newton_solver(state(), linear_solver)(Solver_options()).has_converged);
  }

  // whether the foliation is one of the class
  bool certify()
  {
    m_data->certificate.emplace(m_data->state);
    return m_data->certificate->problems().empty();
  }

  Singularities singularities() const
  {
    Singularities result;
    for (const Singular_place& place : m_data->certificate->singular_places())
      result.emplace_back(place.is_face, place.place, place.index, place.node);
    return result;
  }

  // shares the state; precondition: it is certified
  Foliation foliation() const { return Foliation(m_data); }

private:
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

// A Whitehead move at a vertex next to a singularity: over the half-arc `letter`, from its node into
// the arc or back.
struct Move
{
  int vertex;
  int letter;
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
      result.push_back({v, 2 * state.map().cell[v]});
      result.push_back({v, 2 * state.map().cell[v] + 1});
      continue;
    }
    state.find_directions(v, directions);
    for (int letter : directions.letters)
      result.push_back({v, letter});
  }
  return result;
}

// how far the nearest neighbour in the direction is inside the arc, at most to its other end
double reach(const Foliation_state& state, const Move& move)
{
  double result = state.length_of_arc(move.letter);
  for (int h : state.mesh().ring(move.vertex))
    if (state.word_size(h / 2) == 1 && state.first_letter(h) == move.letter)
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
                      move.letter % 2 == 0 ? step : state.length_of_arc(move.letter) - step);
}

smf::Reeb_graph<Mesh::Point> graph_of(const Foliation& foliation)
{
  smf::Reeb_graph<Mesh::Point> result;
  smf::reeb_graph(foliation, result);
  return result;
}

std::vector<double> edge_values(const Foliation_state& state)
{
  std::vector<double> result;
  for (int e = 0; e < state.mesh().number_of_edges(); ++e)
    result.push_back(state.length(e));
  return result;
}

void expect_same_components_and_graph(const Foliation& foliation,
                                      const smf_test::Incidences& incidences,
                                      const smf::Reeb_graph<Mesh::Point>& graph)
{
  const smf_test::Cut_mesh cut(foliation);
  smf_test::expect_same_surface(cut, foliation.mesh());
  smf_test::expect_annuli(cut, foliation.system().number_of_arcs());
  EXPECT_EQ(smf_test::Component_graph(cut).incidences(), incidences);
  EXPECT_TRUE(smf::reeb_graphs_are_isomorphic(graph_of(foliation), graph));
}

struct Walk
{
  int splits = 0, merges = 0, others = 0;
};

// A random walk of Whitehead moves that stay in the class. Each move is within the critical leaf of
// one node, or turns a regular vertex into another.
Walk walk(Movable_foliation& moved, int number_of_steps, std::uint64_t seed)
{
  Random random(seed);
  Walk result;
  const Foliation start = moved.foliation();
  const smf_test::Incidences incidences =
    smf_test::Component_graph(smf_test::Cut_mesh(start)).incidences();
  const auto graph = graph_of(start);
  for (int step = 0; step < number_of_steps; ++step)
  {
    const Singularities before = moved.singularities();
    const std::vector<Move> moves = moves_near(before, moved.state());
    const Tree_map map = moved.state().map();
    make(moves[random.index(moves.size())], moved.state());
    if (!moved.certify()) // an accidental pole, that is no Whitehead move
    {
      moved.state().set_map(map);
      EXPECT_TRUE(moved.certify());
      continue;
    }
    const Singularities after = moved.singularities();
    if (after == before)
      continue;
    ++(after.size() > before.size()   ? result.splits
       : after.size() < before.size() ? result.merges
                                      : result.others);
    if (indices(after) != indices(before))
      expect_same_components_and_graph(moved.foliation(), incidences, graph);
  }
  return result;
}

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

class Each_example : public ::testing::TestWithParam<Example>
{
protected:
  Each_example() : solved(GetParam()) {}

  Solved_example<> solved;
};

INSTANTIATE_TEST_SUITE_P(Examples,
                         Each_example,
                         ::testing::ValuesIn(examples()),
                         smf_test::name_of_example);

TEST_P(Each_example, splits_and_merges_keep_components_and_graph)
{
  Movable_foliation moved(solved.system);
  ASSERT_TRUE(moved.certify());
  const Singularities before = moved.singularities();
  const std::vector<double> values = edge_values(moved.state());
  const Walk steps = walk(moved, 150, 1);
  RecordProperty("splits", steps.splits);
  RecordProperty("merges", steps.merges);
  EXPECT_GE(steps.splits, 3);
  EXPECT_GE(steps.merges, 3);
  EXPECT_GE(steps.others, 3) << "singularities that move along a leaf";
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
TEST_P(Each_example, moves_can_be_undone)
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
    if (moved.certify() && indices(moved.singularities()) != indices(before))
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
