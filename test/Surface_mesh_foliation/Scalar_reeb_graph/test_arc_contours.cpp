// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "generators/genus_soups.h"
#include "generators/Random.h"
#include "generators/soups.h"
#include "include/flat_meshes.h"

#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/Arc_contours.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/Regions.h>
#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/scalar_reeb_graph_of_flat_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_arc_contours {

// A contour for each arc of the Reeb graph of a function: the surface cut along all of them has the
// graph for its dual graph.

namespace {

namespace internal = CGAL::Surface_mesh_foliation::internal;
namespace soups = smf_test::soups;
using CGAL::Surface_mesh_foliation::Critical_kind;
using internal::Flat_loop;
using internal::Flat_mesh;
using internal::Flat_scalar_reeb_graph;
using internal::Vertex_order;
using smf_test::flat_mesh;
using smf_test::Random;
using smf_test::Triangle_soup;

std::vector<Flat_mesh> surfaces()
{
  return {flat_mesh(soups::tetrahedron()),      flat_mesh(soups::octahedron()),
          flat_mesh(soups::icosphere(1)),       flat_mesh(soups::torus(3, 3, 3, 1)),
          flat_mesh(soups::torus(7, 5, 3, 1)),  flat_mesh(soups::genus_surface(2, 1)),
          flat_mesh(soups::genus_surface(5, 1))};
}

// kind 0: no ties. 1: many ties. 2: few different values. 3: constant. 4: height
Vertex_order random_function(const Flat_mesh& mesh, std::size_t kind, Random& random)
{
  std::vector<double> values;
  const std::size_t n = mesh.points().size();
  for (const auto& p : mesh.points())
    values.push_back(kind == 0   ? random.between(-1, 1)
                     : kind == 1 ? static_cast<double>(random.index(n / 3 + 1))
                     : kind == 2 ? static_cast<double>(random.index(3))
                     : kind == 3 ? 7.
                                 : p[0]);
  return Vertex_order(values);
}

// calls check(mesh, order, graph) with many graphs
template <class Check>
void for_each_graph(int number_per_surface, bool has_simple_saddles, const Check& check)
{
  Random random(6);
  for (const Flat_mesh& mesh : surfaces())
    for (int i = 0; i < number_per_surface && !testing::Test::HasFailure(); ++i)
    {
      SCOPED_TRACE("genus " + std::to_string(mesh.genus()) + ", function " + std::to_string(i));
      const Vertex_order order = random_function(mesh, static_cast<std::size_t>(i % 5), random);
      const std::optional<double> persistence =
        i % 2 == 0 ? std::nullopt : std::optional<double>(random.between(0, 1));
      check(mesh, order, internal::scalar_reeb_graph(mesh, order, persistence, has_simple_saddles));
    }
}

std::vector<Flat_loop> loops(const Flat_mesh& mesh,
                             const Vertex_order& order,
                             const Flat_scalar_reeb_graph& graph)
{
  const internal::Arc_contours arc_contours(mesh, order, graph);
  std::vector<internal::Contour> contours;
  for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a)
    contours.push_back(arc_contours.contour(a));
  return internal::loops_of_contours(mesh, order, contours);
}

// ===  Loops

// Segments of loops in one triangle do not cross: each cuts off a corner, and those at one corner
// have the same order on both edges; in particular, those on an edge that cut off the corner at its
// source come before the others.
void expect_disjoint_loops(const Flat_mesh& mesh, const std::vector<Flat_loop>& loops)
{
  const internal::Edge_crossings crossings(mesh, loops);
  std::map<std::array<int, 2>, std::array<int, 2>> other; // (halfedge, place from its source)
  const auto place_from_source = [&](const Flat_loop& loop, int a, int i, int h) {
    const int place = crossings.place(loop, a, i);
    return internal::is_forward(h) ? place : crossings.size(internal::edge_of(h)) - 1 - place;
  };
  for (int a = 0; a < static_cast<int>(loops.size()); ++a)
    for (int i = 0, n = static_cast<int>(loops[a].crossings.size()); i < n; ++i)
    {
      const int in = internal::opposite_of(loops[a].crossings[i].halfedge);
      const int out = loops[a].crossings[(i + 1) % n].halfedge;
      ASSERT_EQ(mesh.face(in), mesh.face(out));
      ASSERT_NE(in, out);
      const std::array<int, 2> x = {in, place_from_source(loops[a], a, i, in)};
      const std::array<int, 2> y = {out, place_from_source(loops[a], a, (i + 1) % n, out)};
      EXPECT_TRUE(other.emplace(x, y).second);
      EXPECT_TRUE(other.emplace(y, x).second);
    }
  for (const auto& [x, y] : other)
  {
    const int before = mesh.prev(x[0]);
    if (y[0] == before)
    {
      EXPECT_EQ(x[1], crossings.size(internal::edge_of(before)) - 1 - y[1])
        << "as near on the other edge";
    }
  }
  for (int e = 0; e < mesh.number_of_edges(); ++e)
    for (int k = 1; k < crossings.size(e); ++k)
      EXPECT_FALSE(
        internal::Edge_crossings::coincide(crossings.entry(e, k - 1), crossings.entry(e, k)));
}

TEST(Arc_contours, are_disjoint_simple_loops)
{
  for_each_graph(200, true, [&](const auto& mesh, const auto& order, const auto& graph) {
    expect_disjoint_loops(mesh, loops(mesh, order, graph));
  });
}

// The regions between the loops of all arcs correspond to nodes: node and region have the same arcs
// to the same sides, and the region has the genus of the node.
void expect_dual_graph(const Flat_mesh& mesh,
                       const Flat_scalar_reeb_graph& graph,
                       const std::vector<Flat_loop>& loops)
{
  const internal::Edge_crossings crossings(mesh, loops);
  const internal::Regions regions(mesh, {}, loops, crossings);
  ASSERT_EQ(regions.number_of_regions(), static_cast<int>(graph.nodes.size()));
  using Sides = std::set<std::pair<int, int>>;  // loop and side
  std::vector<Sides> sides(graph.nodes.size()); // higher values lie to the left
  for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a)
  {
    sides[graph.arcs[a].upper].emplace(a, 0);
    sides[graph.arcs[a].lower].emplace(a, 1);
  }
  std::map<Sides, int> node_of_sides;
  for (std::size_t i = 0; i < sides.size(); ++i)
    node_of_sides[sides[i]] = static_cast<int>(i);
  std::vector<int> node_of_region;
  for (int r = 0; r < regions.number_of_regions(); ++r)
  {
    Sides sides_of_region;
    for (const internal::Regions::Side& side : regions.region(r).sides)
      sides_of_region.emplace(side.loop, side.side);
    ASSERT_EQ(node_of_sides.count(sides_of_region), 1u);
    node_of_region.push_back(node_of_sides.at(sides_of_region));
    EXPECT_EQ(graph.nodes[node_of_region.back()].genus, regions.region(r).genus());
  }
  // a vertex lies in the region of a node at the vertex, or of an end of an arc that it lies on
  for (int v = 0; v < mesh.number_of_vertices(); ++v)
  {
    const int node = node_of_region[regions.region_of_vertex(v)];
    const auto is_on = [&](const Flat_scalar_reeb_graph::Arc& arc) {
      return &arc == &graph.arcs[graph.arc_of_vertex[v]] || graph.nodes[arc.lower].vertex == v ||
             graph.nodes[arc.upper].vertex == v;
    };
    EXPECT_TRUE(graph.nodes[node].vertex == v ||
                std::any_of(graph.arcs.begin(), graph.arcs.end(),
                            [&](const Flat_scalar_reeb_graph::Arc& arc) {
                              return is_on(arc) && (arc.lower == node || arc.upper == node);
                            }))
      << "vertex " << v;
  }
}

TEST(Arc_contours, cut_the_surface_into_planar_regions_that_are_the_nodes)
{
  bool has_steps = false;
  for_each_graph(200, true, [&](const auto& mesh, const auto& order, const auto& graph) {
    expect_dual_graph(mesh, graph, loops(mesh, order, graph));
    for (const auto& node : graph.nodes)
    {
      EXPECT_EQ(node.genus, 0);
      has_steps = has_steps || node.step > 1;
    }
  });
  EXPECT_TRUE(has_steps);
}

TEST(Arc_contours, cut_the_surface_into_the_folded_nodes)
{
  bool has_genus = false;
  for_each_graph(200, false, [&](const auto& mesh, const auto& order, const auto& graph) {
    expect_dual_graph(mesh, graph, loops(mesh, order, graph));
    for (const auto& node : graph.nodes)
      has_genus = has_genus || node.genus > 0;
  });
  EXPECT_TRUE(has_genus);
}

// ===  Levels

TEST(Arc_contours, lie_halfway_between_the_ends_of_their_arcs)
{
  for_each_graph(20, false, [&](const auto& mesh, const auto& order, const auto& graph) {
    const internal::Arc_contours arc_contours(mesh, order, graph);
    for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a)
    {
      const double low = order.value(graph.nodes[graph.arcs[a].lower].vertex);
      const double high = order.value(graph.nodes[graph.arcs[a].upper].vertex);
      for (const auto& crossing : arc_contours.contour(a))
      {
        EXPECT_LE(order.value(mesh.source(crossing.halfedge)), (low + high) / 2);
        EXPECT_TRUE(low == high || order.value(mesh.target(crossing.halfedge)) > (low + high) / 2);
      }
    }
  });
}

} // namespace

} // namespace test_arc_contours
