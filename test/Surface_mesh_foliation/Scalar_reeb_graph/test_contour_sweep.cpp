// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The Reeb graph of a function by a sweep of its contours, and what the sweep goes by: the order of
// vertices, and the wedges of lower neighbors around each. Against answers worked out by hand, or
// against a simpler program.

#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/Critical_kind.h>
#include <CGAL/Surface_mesh_foliation/Critical_kind.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/Contour_sweep.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/Flat_scalar_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/Vertex_order.h>
#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/lower_wedges.h>

#include "include/brute_force_reeb_graph.h"
#include "include/flat_meshes.h"
#include "include/flat_systems.h"
#include "generators/genus_soups.h"
#include "generators/Random.h"
#include "generators/soups.h"

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

namespace test_contour_sweep {

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

// ===  Wedges of lower neighbors, of a vertex of rank 5

Ints lower_wedges(const Ints& neighbor_ranks)
{
  Ints result = {7, 7, 7, 7}; // is replaced
  find_lower_wedges(neighbor_ranks, 5, result);
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
// neighbor, 5, come first, and 0 is between them and those of 4 at 3, and 1 at 2.
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

// The neighbors of vertex i are i + 1, i + 3, i + 2, i + 6, i + 4, i + 5, counterclockwise. So 2
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

} // namespace

} // namespace test_contour_sweep
