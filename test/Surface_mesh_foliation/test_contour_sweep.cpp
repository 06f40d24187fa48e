// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the Reeb graph of a function is made of: each part against answers worked out by hand, or
// against a simpler program.

#include <CGAL/Surface_mesh_foliation/Critical_kind.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Contour_sweep.h>
#include <CGAL/Surface_mesh_foliation/internal/Cyclic_sequences.h>
#include <CGAL/Surface_mesh_foliation/internal/Flat_scalar_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaf_pruning.h>
#include <CGAL/Surface_mesh_foliation/internal/Vertex_order.h>
#include <CGAL/Surface_mesh_foliation/internal/lower_wedges.h>

#include "include/brute_force_reeb_graph.h"
#include "include/flat_systems.h"
#include "include/genus_soups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace smf_test;
using namespace CGAL::Surface_mesh_foliation::internal;
using CGAL::Surface_mesh_foliation::Invalid_parameter_exception;
using CGAL::Surface_mesh_foliation::Problem_kind;

namespace {

using Kind = CGAL::Surface_mesh_foliation::Critical_kind;
using Ints = std::vector<int>;

constexpr double infinity = std::numeric_limits<double>::infinity();

double just_below(double x)
{
  return std::nextafter(x, -infinity);
}

// ===  Cyclic sequences

// Cyclic sequences as vectors, which are open where those are. Each operation is done with both.
class Sequences_and_vectors
{
public:
  explicit Sequences_and_vectors(std::uint64_t seed) : m_random(seed) {}

  void do_random_operation()
  {
    const std::size_t choice = m_vectors.empty() ? 0 : m_random.index(9);
    if (choice == 0)
      make();
    else if (choice <= 3)
      insert_after();
    else if (choice == 4)
      erase();
    else if (choice == 5)
      cut_at();
    else if (choice == 6)
      split_at();
    else if (choice == 7)
      join();
    else
      set_label();
  }

  // Only of a copy, so that trees keep shapes that no check has tidied up.
  void check() const
  {
    Cyclic_sequences sequences = m_sequences;
    for (std::size_t k = 0; k < m_vectors.size(); ++k)
    {
      const Labelled& v = m_vectors[k];
      for (int x : v.items)
        EXPECT_EQ(v.past.count(sequences.former_label(x)), 1u);
      for (int x : v.items)
      {
        EXPECT_EQ(sequences.label(x), v.label);
        EXPECT_EQ(sequences.is_alone(x), v.items.size() == 1);
        EXPECT_TRUE(sequences.are_in_one_sequence(x, v.items.front()));
        EXPECT_TRUE(k == 0 || !sequences.are_in_one_sequence(x, m_vectors[k - 1].items.back()));
      }
      check_order(sequences, v.items);
    }
  }

  std::size_t longest() const { return m_longest; }

private:
  struct Labelled
  {
    Ints items;
    int label;
    std::set<int> past; // labels, also of what has been joined
  };

  static void check_order(Cyclic_sequences& sequences, const Ints& items)
  {
    for (std::size_t i = 0; i < items.size(); ++i)
    {
      const bool is_last = i + 1 == items.size();
      EXPECT_TRUE(is_last || sequences.are_in_one_sequence(items[i], items[i + 1]));
      const auto [before, behind] = sequences.split_at(items[i]);
      EXPECT_EQ(before, Cyclic_sequences::none);
      EXPECT_EQ(behind == Cyclic_sequences::none, is_last);
    }
  }

  std::size_t random_vector() { return m_random.index(m_vectors.size()); }

  // adds a vector if there are items, which are those of the root
  void add(Ints items, int root, std::set<int> past)
  {
    ASSERT_EQ(root == Cyclic_sequences::none, items.empty());
    if (items.empty())
      return;
    m_sequences.set_label(root, ++m_label);
    past.insert(m_label);
    m_longest = std::max(m_longest, items.size());
    m_vectors.push_back({std::move(items), m_label, std::move(past)});
  }

  Labelled take(std::size_t k)
  {
    Labelled result = std::move(m_vectors[k]);
    m_vectors.erase(m_vectors.begin() + static_cast<std::ptrdiff_t>(k));
    return result;
  }

  // an item is new, and those that were freed are used first
  void count_item(int x)
  {
    for (const Labelled& v : m_vectors)
      EXPECT_EQ(std::count(v.items.begin(), v.items.end(), x), 0);
    m_largest_number_of_items = std::max(m_largest_number_of_items, ++m_number_of_items);
    EXPECT_LT(x, m_largest_number_of_items);
  }

  void make()
  {
    const int x = m_sequences.make(++m_label);
    count_item(x);
    m_vectors.push_back({{x}, m_label, {m_label}});
  }

  void insert_after()
  {
    Labelled& v = m_vectors[random_vector()];
    const std::size_t i = m_random.index(v.items.size());
    const int y = m_sequences.insert_after(v.items[i]);
    count_item(y);
    v.items.insert(v.items.begin() + static_cast<std::ptrdiff_t>(i) + 1, y);
    m_longest = std::max(m_longest, v.items.size());
  }

  // those behind the i-th item, and those before it
  static Ints others(const Ints& items, std::size_t i)
  {
    const auto x = items.begin() + static_cast<std::ptrdiff_t>(i);
    Ints result(x + 1, items.end());
    result.insert(result.end(), items.begin(), x);
    return result;
  }

  void erase()
  {
    const std::size_t k = random_vector();
    Labelled& v = m_vectors[k];
    const std::size_t i = m_random.index(v.items.size());
    m_sequences.erase(v.items[i]);
    --m_number_of_items;
    v.items = others(v.items, i);
    if (v.items.empty())
      take(k);
  }

  void cut_at()
  {
    const Labelled v = take(random_vector());
    const std::size_t i = m_random.index(v.items.size());
    const int x = v.items[i];
    add(others(v.items, i), m_sequences.cut_at(x), v.past);
    if (m_random.index(2) == 0)
      m_vectors.push_back({{x}, v.label, v.past}); // keeps its label
    else
    {
      m_sequences.free(x);
      --m_number_of_items;
    }
  }

  void split_at()
  {
    const Labelled v = take(random_vector());
    const std::size_t i = m_random.index(v.items.size());
    const auto x = v.items.begin() + static_cast<std::ptrdiff_t>(i);
    const auto [before, behind] = m_sequences.split_at(*x);
    add(Ints(v.items.begin(), x), before, v.past);
    m_vectors.push_back({{*x}, v.label, v.past});
    add(Ints(x + 1, v.items.end()), behind, v.past);
  }

  // joins up to four sequences, and labels only the last result
  void join()
  {
    int root = Cyclic_sequences::none;
    Ints items;
    std::set<int> past;
    const std::size_t number = std::min(m_vectors.size(), 1 + m_random.index(4));
    for (std::size_t i = 0; i < number; ++i)
    {
      const Labelled v = take(random_vector());
      const int x = v.items[m_random.index(v.items.size())];
      EXPECT_EQ(m_sequences.label(x), v.label);
      root = m_sequences.join(root, x); // x is a root now
      root = m_sequences.join(root, Cyclic_sequences::none);
      items.insert(items.end(), v.items.begin(), v.items.end());
      past.insert(v.past.begin(), v.past.end());
    }
    add(std::move(items), root, std::move(past));
  }

  void set_label()
  {
    Labelled& v = m_vectors[random_vector()];
    v.label = ++m_label;
    v.past.insert(m_label);
    m_sequences.set_label(v.items[m_random.index(v.items.size())], m_label);
  }

  Random m_random;
  Cyclic_sequences m_sequences;
  std::vector<Labelled> m_vectors;
  int m_label = 0, m_number_of_items = 0, m_largest_number_of_items = 0;
  std::size_t m_longest = 0;
};

TEST(Cyclic_sequences, are_like_vectors)
{
  std::size_t longest = 0;
  for (std::uint64_t seed = 1; seed <= 100 && !HasFailure(); ++seed)
  {
    Sequences_and_vectors both(seed);
    for (int step = 0; step < 200 && !HasFailure(); ++step)
    {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", step " + std::to_string(step));
      both.do_random_operation();
      both.check();
    }
    longest = std::max(longest, both.longest());
  }
  EXPECT_GT(longest, 30u) << "the test has the cases that it is meant to have";
}

TEST(Cyclic_sequences, of_one_item)
{
  Cyclic_sequences s;
  const int x = s.make(5);
  EXPECT_TRUE(s.is_alone(x));
  EXPECT_TRUE(s.are_in_one_sequence(x, x));
  EXPECT_EQ(s.cut_at(x), Cyclic_sequences::none);
  EXPECT_EQ(s.split_at(x), std::make_pair(Cyclic_sequences::none, Cyclic_sequences::none));
  EXPECT_EQ(s.join(Cyclic_sequences::none, Cyclic_sequences::none), Cyclic_sequences::none);
  EXPECT_EQ(s.label(x), 5);
  s.erase(x);
  EXPECT_EQ(s.make(6), x) << "it is used again";
  EXPECT_EQ(s.label(x), 6);
}

// ===  Order of vertices

TEST(Vertex_order, breaks_ties_by_vertex)
{
  const Vertex_order order({2, 1, 2, -3, 1, 2});
  ASSERT_EQ(order.size(), 6);
  const Ints expected = {3, 1, 4, 0, 2, 5};
  for (int r = 0; r < 6; ++r)
  {
    EXPECT_EQ(order.vertex(r), expected[r]);
    EXPECT_EQ(order.rank(expected[r]), r);
  }
  EXPECT_EQ(order.value(3), -3);
  EXPECT_EQ(order.value(4), 1);
}

TEST(Vertex_order, zeros_of_both_signs_are_a_tie)
{
  const Vertex_order order({0., -0., 0.});
  EXPECT_EQ((Ints{order.vertex(0), order.vertex(1), order.vertex(2)}), (Ints{0, 1, 2}));
  EXPECT_EQ(order.number_up_to(-0.), 3);
  EXPECT_EQ(order.number_up_to(-std::numeric_limits<double>::denorm_min()), 0);
}

TEST(Vertex_order, counts_vertices_up_to_a_level)
{
  const Vertex_order order({2, 1, 2, -3, 1, 2});
  const std::vector<std::pair<double, int>> expected = {
    {-infinity, 0}, {-4, 0},  {just_below(-3), 0}, {-3, 1}, {-1, 1},     {just_below(1), 1},
    {1, 3},         {1.5, 3}, {just_below(2), 3},  {2, 6},  {2.0001, 6}, {infinity, 6}};
  for (const auto& [level, number] : expected)
    EXPECT_EQ(order.number_up_to(level), number) << level;
  EXPECT_EQ(Vertex_order().number_up_to(0), 0);
  EXPECT_EQ(Vertex_order().size(), 0);
}

TEST(Vertex_order, of_the_largest_numbers)
{
  const double largest = std::numeric_limits<double>::max();
  const Vertex_order order({largest, -largest});
  EXPECT_EQ(order.vertex(0), 1);
  EXPECT_EQ(order.number_up_to(just_below(largest)), 1);
}

TEST(Vertex_order, names_the_first_vertex_whose_value_is_not_finite)
{
  for (const double bad : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()})
    try
    {
      Vertex_order({1, 2, bad, 3, bad});
      ADD_FAILURE() << bad << " is accepted";
    }
    catch (const Invalid_parameter_exception& exception)
    {
      EXPECT_EQ(exception.problem().kind, Problem_kind::NOT_FINITE);
      EXPECT_EQ(exception.problem().vertices, std::vector<std::size_t>{2});
      EXPECT_NE(exception.problem().message.find("vertex 2 is not finite"), std::string::npos);
    }
}

// ===  Wedges of lower neighbours, of a vertex of rank 5

Ints lower_wedges(const Ints& neighbour_ranks)
{
  Ints result = {7, 7, 7, 7}; // is replaced
  find_lower_wedges(neighbour_ranks, 5, result);
  return result;
}

TEST(Lower_wedges, of_extrema_have_no_begin)
{
  EXPECT_EQ(lower_wedges({6, 7, 8}), Ints{});
  EXPECT_EQ(lower_wedges({1, 3, 2}), Ints{});
}

TEST(Lower_wedges, of_a_regular_vertex)
{
  EXPECT_EQ(lower_wedges({6, 7, 1, 2}), Ints{2});
  EXPECT_EQ(lower_wedges({6, 7, 2, 1}), Ints{2}) << "it begins with the first, not the lowest";
  EXPECT_EQ(lower_wedges({1, 2, 7}), Ints{0});
  EXPECT_EQ(lower_wedges({1, 7, 6, 2}), Ints{3}) << "where the cycle is cut open";
  EXPECT_EQ(lower_wedges({7, 6, 8, 4}), Ints{3});
  EXPECT_EQ(lower_wedges({1, 2, 6, 3}), Ints{3});
}

TEST(Lower_wedges, of_a_saddle)
{
  EXPECT_EQ(lower_wedges({1, 6, 2, 7}), (Ints{0, 2}));
  EXPECT_EQ(lower_wedges({2, 6, 1, 7}), (Ints{2, 0}));
  EXPECT_EQ(lower_wedges({6, 1, 7, 2}), (Ints{1, 3}));
  EXPECT_EQ(lower_wedges({6, 2, 7, 1}), (Ints{3, 1}));
  EXPECT_EQ(lower_wedges({2, 6, 4, 3, 1, 7}), (Ints{2, 0})) << "the lowest one is not the first";
  EXPECT_EQ(lower_wedges({1, 6, 2, 7, 3}), (Ints{4, 2})) << "the first wedge is cut open";
  EXPECT_EQ(lower_wedges({3, 6, 1, 7, 2}), (Ints{2, 4})) << "the second wedge is cut open";
}

TEST(Lower_wedges, of_a_monkey_saddle_do_not_depend_on_where_the_cycle_is_cut_open)
{
  EXPECT_EQ(lower_wedges({3, 9, 1, 8, 2, 7}), (Ints{2, 4, 0}));
  Ints cycle = {9, 10, 4, 0, 8, 1, 7, 2, 3, 6};
  for (std::size_t i = 0; i < cycle.size(); ++i)
  {
    Ints ranks;
    for (int begin : lower_wedges(cycle))
      ranks.push_back(cycle[begin]);
    EXPECT_EQ(ranks, (Ints{4, 1, 2})) << i;
    std::rotate(cycle.begin(), cycle.begin() + 1, cycle.end());
  }
}

// ===  The sweep

constexpr int any = -1;

struct Expected_node
{
  int vertex;
  Kind kind;
  int step = 0;
};

struct Expected_arc
{
  int lower, upper; // nodes
  int target;       // of the halfedge, or any
};

void expect_nodes(const Flat_scalar_reeb_graph& graph, const std::vector<Expected_node>& expected)
{
  ASSERT_EQ(graph.nodes.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    SCOPED_TRACE("node " + std::to_string(i));
    EXPECT_EQ(graph.nodes[i].vertex, expected[i].vertex);
    EXPECT_EQ(graph.nodes[i].kind, expected[i].kind);
    EXPECT_EQ(graph.nodes[i].step, expected[i].step);
    EXPECT_EQ(graph.nodes[i].multiplicity, expected[i].kind == Kind::SADDLE ? 1 : 0);
    EXPECT_EQ(graph.nodes[i].genus, 0);
  }
}

void expect_arcs(const Flat_mesh& mesh,
                 const Flat_scalar_reeb_graph& graph,
                 const std::vector<Expected_arc>& expected)
{
  ASSERT_EQ(graph.arcs.size(), expected.size());
  ASSERT_EQ(graph.pieces.size(), expected.size());
  for (std::size_t a = 0; a < expected.size(); ++a)
  {
    SCOPED_TRACE("arc " + std::to_string(a));
    const auto [lower, upper, target] = expected[a];
    EXPECT_EQ(graph.arcs[a].lower, lower);
    EXPECT_EQ(graph.arcs[a].upper, upper);
    EXPECT_EQ(graph.arcs[a].first_piece, static_cast<int>(a));
    const Flat_scalar_reeb_graph::Piece& piece = graph.pieces[a];
    EXPECT_EQ(piece.lower_vertex, graph.nodes[lower].vertex);
    EXPECT_EQ(piece.upper_vertex, graph.nodes[upper].vertex);
    EXPECT_EQ(piece.lower_step, graph.nodes[lower].step);
    EXPECT_EQ(piece.next, -1);
    EXPECT_EQ(mesh.source(piece.halfedge), piece.lower_vertex);
    EXPECT_TRUE(target == any || mesh.target(piece.halfedge) == target)
      << mesh.target(piece.halfedge);
  }
}

void expect_sweep(const Triangle_soup& soup,
                  const std::vector<double>& values,
                  const std::vector<Expected_node>& nodes,
                  const std::vector<Expected_arc>& arcs,
                  const Ints& arc_of_vertex)
{
  const Flat_mesh mesh = flat_mesh(soup);
  const Vertex_order order(values);
  const Flat_scalar_reeb_graph graph = Contour_sweep(mesh, order).take_graph();
  expect_nodes(graph, nodes);
  expect_arcs(mesh, graph, arcs);
  EXPECT_EQ(graph.arc_of_vertex, arc_of_vertex);
}

// from the south pole 5 to the north pole 4; the others are a tie
TEST(Contour_sweep, octahedron_that_stands_on_a_vertex)
{
  expect_sweep(soups::octahedron(), {0, 0, 0, 0, 1, -1}, {{5, Kind::MINIMUM}, {4, Kind::MAXIMUM}},
               {{0, 1, any}}, {0, 0, 0, 0, 0, 0});
}

// Opposite vertices are 0 and 1, 2 and 3, 4 and 5. Vertex 2 joins the minima 0 and 1, and vertex 3
// splits the contour into one around each of the maxima 4 and 5.
TEST(Contour_sweep, octahedron_with_two_saddles)
{
  expect_sweep(soups::octahedron(), {0, 1, 2, 3, 4, 5},
               {{0, Kind::MINIMUM},
                {1, Kind::MINIMUM},
                {2, Kind::SADDLE},
                {3, Kind::SADDLE},
                {4, Kind::MAXIMUM},
                {5, Kind::MAXIMUM}},
               {{0, 2, any}, {1, 2, any}, {2, 3, 5}, {3, 4, 4}, {3, 5, 5}}, {0, 1, 0, 2, 3, 4});
}

// Counterclockwise, 0, 4, 1, 5 are around 3, and 4, 0, 5, 1 around 2. So the wedges of the lowest
// neighbour, 5, come first, and 0 is between them and those of 4 at 3, and 1 at 2.
TEST(Contour_sweep, octahedron_upside_down)
{
  expect_sweep(soups::octahedron(), {6, 5, 4, 3, 2, 1},
               {{5, Kind::MINIMUM},
                {4, Kind::MINIMUM},
                {3, Kind::SADDLE},
                {2, Kind::SADDLE},
                {1, Kind::MAXIMUM},
                {0, Kind::MAXIMUM}},
               {{0, 2, any}, {1, 2, any}, {2, 3, 0}, {3, 4, 1}, {3, 5, 0}}, {4, 3, 2, 0, 1, 0});
}

// The neighbours of vertex i are i + 1, i + 3, i + 2, i + 6, i + 4, i + 5, counterclockwise. So 2
// is a saddle with the lower wedges 0 and 1 and the upper wedges 3, 5, 4 and 6, and 4 is one with
// the lower wedges 0 and 3, 1, 2 and the upper wedges 5 and 6. Between them one contour crosses
// 23, 25, 24, 14, 13, 03, with vertex 3 above it, and another one 26, 06, 04, 05, 15, 16.
TEST(Contour_sweep, seven_vertex_torus)
{
  for (const std::vector<double>& values :
       {std::vector<double>{0, 1, 2, 3, 4, 5, 6}, std::vector<double>(7, 1.5)})
    expect_sweep(soups::seven_vertex_torus(), values,
                 {{0, Kind::MINIMUM}, {2, Kind::SADDLE}, {4, Kind::SADDLE}, {6, Kind::MAXIMUM}},
                 {{0, 1, any}, {1, 2, 4}, {1, 2, 6}, {2, 3, 6}}, {0, 0, 0, 1, 2, 3, 3});
}

// 1, 2, 4 are below vertex 0 and 3, 5, 6 above it. It splits the contour and joins the halves.
TEST(Contour_sweep, seven_vertex_torus_with_its_handle_in_one_vertex)
{
  expect_sweep(soups::seven_vertex_torus(), {3, 0, 1, 4, 2, 5, 6},
               {{1, Kind::MINIMUM}, {0, Kind::SADDLE, 0}, {0, Kind::SADDLE, 1}, {6, Kind::MAXIMUM}},
               {{0, 1, any}, {1, 2, 3}, {1, 2, 1}, {2, 3, 6}}, {0, 0, 0, 3, 0, 3, 3});
}

// a double pyramid over the hexagon 0, ..., 5 with the apices 6, above, and 7
Triangle_soup hexagonal_double_pyramid()
{
  Triangle_soup result;
  for (std::size_t i = 0; i < 6; ++i)
  {
    result.triangles.push_back({i, (i + 1) % 6, 6});
    result.triangles.push_back({(i + 1) % 6, i, 7});
  }
  result.points.resize(8);
  return result;
}

TEST(Contour_sweep, monkey_saddle_that_splits_twice)
{
  expect_sweep(hexagonal_double_pyramid(), {1, -1, 1, -1, 1, -1, 0, -2},
               {{7, Kind::MINIMUM},
                {6, Kind::SADDLE, 0},
                {6, Kind::SADDLE, 1},
                {0, Kind::MAXIMUM},
                {2, Kind::MAXIMUM},
                {4, Kind::MAXIMUM}},
               {{0, 1, any}, {1, 4, 2}, {1, 2, 1}, {2, 5, 4}, {2, 3, 0}}, {4, 0, 1, 0, 3, 0, 0, 0});
}

TEST(Contour_sweep, monkey_saddle_that_joins_twice)
{
  expect_sweep(hexagonal_double_pyramid(), {1, -1, 1, -1, 1, -1, 0, 2},
               {{1, Kind::MINIMUM},
                {3, Kind::MINIMUM},
                {5, Kind::MINIMUM},
                {6, Kind::SADDLE, 0},
                {6, Kind::SADDLE, 1},
                {7, Kind::MAXIMUM}},
               {{0, 3, any}, {1, 3, any}, {2, 4, any}, {3, 4, 2}, {4, 5, 4}},
               {4, 0, 4, 1, 4, 2, 0, 4});
}

using Ends = std::multiset<std::array<std::size_t, 2>>; // vertices of arcs, the lower one first

// without the arcs between the steps of a saddle
Ends ends_of_arcs(const Flat_scalar_reeb_graph& graph)
{
  Ends result;
  for (const auto& arc : graph.arcs)
  {
    const auto lower = static_cast<std::size_t>(graph.nodes[arc.lower].vertex);
    const auto upper = static_cast<std::size_t>(graph.nodes[arc.upper].vertex);
    if (lower != upper)
      result.insert({lower, upper});
  }
  return result;
}

// The cyclic orders of the sequences decide at which saddles contours are split.
TEST(Contour_sweep, random_functions_have_the_arcs_of_all_contours)
{
  for (const Triangle_soup& soup : {soups::genus_surface(2, 1), soups::genus_surface(4, 1)})
  {
    const Flat_mesh mesh = flat_mesh(soup);
    const Edges_of_soup edges(soup);
    for (std::uint64_t seed = 1; seed <= 50 && !HasFailure(); ++seed)
    {
      SCOPED_TRACE("genus " + std::to_string(mesh.genus()) + ", seed " + std::to_string(seed));
      Random random(seed);
      std::vector<double> values;
      for (std::size_t v = 0; v < soup.points.size(); ++v)
        values.push_back(random.between(0, 1));
      const Vertex_order order(values);
      const Flat_scalar_reeb_graph graph = Contour_sweep(mesh, order).take_graph();
      EXPECT_EQ(graph.arcs.size() + 1, graph.nodes.size() + soups::genus(soup));
      const Brute_force_reeb_graph expected(soup, edges, values);
      EXPECT_EQ(ends_of_arcs(graph), Ends(expected.arcs.begin(), expected.arcs.end()));
    }
  }
}

// ===  Pruning

struct Graph_and_order
{
  Flat_scalar_reeb_graph graph;
  Vertex_order order;
};

// Node i is at vertex i, and one vertex more lies inside each arc; arcs are given by their nodes.
Graph_and_order graph_and_order(std::vector<double> values,
                                const std::vector<Kind>& kinds,
                                const std::vector<std::array<int, 2>>& arcs)
{
  Flat_scalar_reeb_graph graph;
  const int n = static_cast<int>(kinds.size());
  graph.arc_of_vertex.assign(kinds.size(), -1);
  for (int v = 0; v < n; ++v)
    graph.nodes.push_back({v, kinds[v], 0, kinds[v] == Kind::SADDLE, 0});
  for (const auto& [lower, upper] : arcs)
  {
    const int a = static_cast<int>(graph.arcs.size());
    graph.arcs.push_back({lower, upper, a, 0});
    graph.pieces.push_back({lower, upper, 0, -1, -1});
    graph.arc_of_vertex[lower] = graph.arc_of_vertex[upper] = a;
    graph.arc_of_vertex.push_back(a);
    values.push_back((values[lower] + values[upper]) / 2);
  }
  return {graph, Vertex_order(values)};
}

// the vertices at the ends of an arc, its pieces from below, and the vertices inside former arcs
struct Pruned_arc
{
  std::array<int, 2> ends;
  Ints pieces, former_arcs;

  bool operator==(const Pruned_arc& other) const
  {
    return ends == other.ends && pieces == other.pieces && former_arcs == other.former_arcs;
  }
};

std::vector<Pruned_arc> pruned(const Graph_and_order& input, double persistence)
{
  Flat_scalar_reeb_graph graph = input.graph;
  Leaf_pruning(graph, input.order, persistence);
  std::vector<Pruned_arc> result;
  std::set<int> nodes;
  for (const auto& arc : graph.arcs)
  {
    nodes.insert({arc.lower, arc.upper});
    result.push_back(
      {{graph.nodes.at(arc.lower).vertex, graph.nodes.at(arc.upper).vertex}, {}, {}});
    for (int p = arc.first_piece; p >= 0; p = graph.pieces[p].next)
      result.back().pieces.push_back(p);
  }
  EXPECT_EQ(nodes.size(), graph.nodes.size()) << "nodes that are left are at an arc";
  const std::size_t n = input.graph.nodes.size();
  for (std::size_t v = n; v < graph.arc_of_vertex.size(); ++v)
    result.at(graph.arc_of_vertex[v]).former_arcs.push_back(static_cast<int>(v - n));
  for (const auto& node : graph.nodes)
  {
    const auto& [lower, upper] = result.at(graph.arc_of_vertex[node.vertex]).ends;
    EXPECT_TRUE(lower == node.vertex || upper == node.vertex);
    EXPECT_EQ(node.kind, input.graph.nodes[node.vertex].kind);
  }
  return result;
}

// Saddle 2 joins the minima 0 and 1, saddle 3 has maximum 4 beside it, saddle 5 a branch which
// saddle 6 splits into maxima 7 and 8; two arcs go from saddle 9 to saddle 10, and one to maximum
// 11.
Graph_and_order branches_and_a_cycle()
{
  const Kind saddle = Kind::SADDLE, maximum = Kind::MAXIMUM;
  return graph_and_order({0, 1, 2, 3, 3.5, 4, 5, 5.75, 8, 9, 10, 20},
                         {Kind::MINIMUM, Kind::MINIMUM, saddle, saddle, maximum, saddle, saddle,
                          maximum, maximum, saddle, saddle, maximum},
                         {{0, 2},
                          {1, 2}, // span 1
                          {2, 3},
                          {3, 4}, // span 0.5
                          {3, 5},
                          {5, 6},
                          {5, 9},
                          {6, 7}, // span 0.75; then 5-6-8 is an arc of span 4
                          {6, 8},
                          {9, 10},
                          {9, 10},
                          {10, 11}});
}

void expect_pruned(double from, double below, const std::vector<Pruned_arc>& expected)
{
  const Graph_and_order input = branches_and_a_cycle();
  EXPECT_TRUE(pruned(input, from) == expected) << from;
  EXPECT_TRUE(pruned(input, just_below(below)) == expected) << "just below " << below;
}

TEST(Leaf_pruning, takes_leaves_away_when_the_persistence_reaches_their_spans)
{
  const Pruned_arc leaf_1 = {{1, 2}, {1}, {1}}, u_9 = {{5, 9}, {6}, {6}};
  const Pruned_arc once = {{9, 10}, {9}, {9}}, twice = {{9, 10}, {10}, {10}};
  const Pruned_arc top = {{10, 11}, {11}, {11}};
  expect_pruned(0, 0.5,
                {{{0, 2}, {0}, {0}},
                 leaf_1,
                 {{2, 3}, {2}, {2}},
                 {{3, 4}, {3}, {3}},
                 {{3, 5}, {4}, {4}},
                 {{5, 6}, {5}, {5}},
                 u_9,
                 {{6, 7}, {7}, {7}},
                 {{6, 8}, {8}, {8}},
                 once,
                 twice,
                 top});
  expect_pruned(0.5, 0.75,
                {{{0, 2}, {0}, {0}},
                 leaf_1,
                 {{2, 5}, {2, 4}, {2, 3, 4}},
                 {{5, 6}, {5}, {5}},
                 u_9,
                 {{6, 7}, {7}, {7}},
                 {{6, 8}, {8}, {8}},
                 once,
                 twice,
                 top});
  expect_pruned(0.75, 1,
                {{{0, 2}, {0}, {0}},
                 leaf_1,
                 {{2, 5}, {2, 4}, {2, 3, 4}},
                 {{5, 8}, {5, 8}, {5, 7, 8}},
                 u_9,
                 once,
                 twice,
                 top});
  // The arc from 0 to 2, of span 2, is a leaf no more, nor that from 6 to 8, of span 3.
  expect_pruned(
    1, 4,
    {{{0, 5}, {0, 2, 4}, {0, 1, 2, 3, 4}}, {{5, 8}, {5, 8}, {5, 7, 8}}, u_9, once, twice, top});
  // The cycle stays.
  expect_pruned(4, infinity,
                {{{0, 9}, {0, 2, 4, 6}, {0, 1, 2, 3, 4, 5, 6, 7, 8}}, once, twice, top});
}

// Saddle 2 joins the minima 0 and 1, and saddle 4 them and minimum 3. Arc 0 is a leaf of span 2,
// until it becomes one of span 9.
TEST(Leaf_pruning, forgets_the_spans_of_leaves_that_have_grown)
{
  const Graph_and_order input = graph_and_order(
    {0, 1, 2, 3, 9, 20},
    {Kind::MINIMUM, Kind::MINIMUM, Kind::SADDLE, Kind::MINIMUM, Kind::SADDLE, Kind::MAXIMUM},
    {{0, 2}, {1, 2}, {2, 4}, {3, 4}, {4, 5}});
  EXPECT_TRUE(
    pruned(input, just_below(6)) ==
    (std::vector<Pruned_arc>{{{0, 4}, {0, 2}, {0, 1, 2}}, {{3, 4}, {3}, {3}}, {{4, 5}, {4}, {4}}}));
  EXPECT_TRUE(pruned(input, 6) == (std::vector<Pruned_arc>{{{0, 5}, {0, 2, 4}, {0, 1, 2, 3, 4}}}));
}

TEST(Leaf_pruning, of_equal_spans_begins_with_the_lowest_extremum)
{
  // maxima 2 and 3 above saddle 1, with a tie
  const Graph_and_order two_maxima =
    graph_and_order({0, 1, 2, 2}, {Kind::MINIMUM, Kind::SADDLE, Kind::MAXIMUM, Kind::MAXIMUM},
                    {{0, 1}, {1, 2}, {1, 3}});
  EXPECT_EQ(pruned(two_maxima, just_below(1)).size(), 3u);
  EXPECT_TRUE(pruned(two_maxima, 1) == (std::vector<Pruned_arc>{{{0, 3}, {0, 2}, {0, 1, 2}}}));
  // minima 0 and 1 below saddle 2, with a tie
  const Graph_and_order two_minima =
    graph_and_order({0, 0, 1, 2}, {Kind::MINIMUM, Kind::MINIMUM, Kind::SADDLE, Kind::MAXIMUM},
                    {{0, 2}, {1, 2}, {2, 3}});
  EXPECT_EQ(pruned(two_minima, just_below(1)).size(), 3u);
  EXPECT_TRUE(pruned(two_minima, 1) == (std::vector<Pruned_arc>{{{1, 3}, {1, 2}, {0, 1, 2}}}));
}

TEST(Leaf_pruning, up_to_zero_takes_away_what_only_ties_make)
{
  const Graph_and_order input =
    graph_and_order({0, 1, 1, 1.5}, {Kind::MINIMUM, Kind::SADDLE, Kind::MAXIMUM, Kind::MAXIMUM},
                    {{0, 1}, {1, 2}, {1, 3}});
  for (const double zero : {0., -0.})
    EXPECT_TRUE(pruned(input, zero) == (std::vector<Pruned_arc>{{{0, 3}, {0, 2}, {0, 1, 2}}}));
}

} // namespace
