// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The mesh cut along its critical leaves, and what is read off it: leaves, components and
// labels. On octahedra and the torus of seven vertices all numbers are known.

#include <CGAL/Surface_mesh_foliation/internal/Leaves/Leaf_graph.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/Refined_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/component_labels.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/critical_polylines.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/soup_of_flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/grow_fronts.h>

#include "include/flat_states.h"
#include "include/flat_systems.h"
#include "include/refined_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace test_refined_mesh {

using namespace smf_test;
using namespace CGAL::Surface_mesh_foliation::internal;

namespace {

double area(const Point& a, const Point& b, const Point& c)
{
  const soups::Point normal = soups::cross(soups::sum(b, a, -1), soups::sum(c, a, -1));
  return std::sqrt(soups::dot(normal, normal)) / 2;
}

// the edges of the critical leaves, and whether all faces agree about them
std::set<std::pair<int, int>> critical_edges(const Refined_mesh& mesh)
{
  std::map<std::pair<int, int>, int> faces;
  for (const Refined_mesh::Face& face : mesh.faces)
    for (int i : {0, 1, 2})
      if (face.is_critical[i])
        ++faces[std::minmax({face.vertices[i], face.vertices[(i + 1) % 3]})];
  std::set<std::pair<int, int>> result;
  for (const auto& [edge, number] : faces)
  {
    EXPECT_EQ(number, 2);
    result.insert(edge);
  }
  return result;
}

// Pieces have the areas of their faces, and parameters within their arcs.
void expect_is_refinement(const Foliation_state& state, const Refined_mesh& mesh)
{
  std::vector<double> areas(state.mesh().number_of_faces(), 0);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    const Refined_mesh::Face& face = mesh.faces[f];
    const auto [a, b, c] = face.vertices;
    areas[face.origin] += area(mesh.points[a], mesh.points[b], mesh.points[c]);
    EXPECT_LE(face.piece, static_cast<int>(f));
    EXPECT_EQ(mesh.faces[face.piece].origin, face.origin);
    EXPECT_EQ(mesh.faces[face.piece].arc, face.arc);
    for (int i : {0, 1, 2})
    {
      if (face.is_critical[i])
      {
        EXPECT_GE(mesh.node[face.vertices[i]], 0);
        EXPECT_EQ(mesh.node[face.vertices[i]], mesh.node[face.vertices[(i + 1) % 3]]);
      }
      if (face.arc == Refined_mesh::NONE)
        continue;
      EXPECT_GE(face.t[i], 0);
      EXPECT_LE(face.t[i], state.system().height(face.arc));
      if (mesh.node[face.vertices[i]] == Refined_mesh::NONE)
      {
        EXPECT_EQ(face.t[i], state.parameter(face.vertices[i]));
      }
      else // at the end of the arc that lies at this node
        EXPECT_EQ(state.system().node_of_end(face.arc, face.t[i] == 0 ? 0 : 1),
                  mesh.node[face.vertices[i]]);
    }
  }
  for (int f = 0; f < state.mesh().number_of_faces(); ++f)
  {
    const auto [h, i, j] = state.mesh().halfedges(f);
    EXPECT_NEAR(areas[f],
                area(state.mesh().point(state.mesh().source(h)),
                     state.mesh().point(state.mesh().source(i)),
                     state.mesh().point(state.mesh().source(j))),
                1e-14);
  }
}

// the state of three poles before any step
struct Star
{
  Star() : system(octahedron_with_three_poles()), state(system, unit_weights(system)) {}

  Flat_loop_system system;
  Foliation_state state;
};

// with two poles, before the fronts grow: the lower half lies at its node
struct Lower_half
{
  Lower_half() : system(octahedron_with_two_poles()), state(system, unit_weights(system)) {}

  Flat_loop_system system;
  Foliation_state state;
};

struct Torus
{
  Torus() : system(torus_with_one_loop()), state(system, unit_weights(system)) {}

  Flat_loop_system system;
  Foliation_state state;
};

} // namespace

// ===  Refined_mesh.h

TEST(Refined_mesh, is_the_mesh_where_nothing_is_cut)
{
  const Equator e({0.5, 1, 1, 1.5});
  const Refined_mesh mesh = refined(e.state);
  expect_is_refinement(e.state, mesh);
  EXPECT_EQ(mesh.points, e.system.mesh.points());
  EXPECT_EQ(mesh.node, (std::vector<int>{-1, -1, -1, -1, 0, 1}));
  ASSERT_EQ(mesh.faces.size(), 8u);
  for (const Refined_mesh::Face& face : mesh.faces)
    EXPECT_EQ(face.arc, 0);
  EXPECT_TRUE(critical_edges(mesh).empty());
}

TEST(Refined_mesh, has_a_point_where_an_edge_passes_a_node_and_one_in_a_tripod)
{
  const Star star;
  const Refined_mesh mesh = refined(star.state);
  expect_is_refinement(star.state, mesh);
  ASSERT_EQ(mesh.points.size(), 10u);
  EXPECT_EQ(mesh.faces.size(), 16u);
  EXPECT_EQ(mesh.node, (std::vector<int>{0, 3, 1, 3, 2, 3, 3, 3, 3, 3}));
  const std::set<Point> middles(mesh.points.begin() + 6, mesh.points.begin() + 9);
  EXPECT_EQ(middles, (std::set<Point>{{0.5, 0.5, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}}));
  expect_near(mesh.points[9], {1. / 3, 1. / 3, 1. / 3});
  int number_at_node = 0;
  for (const Refined_mesh::Face& face : mesh.faces)
    number_at_node += face.arc == Refined_mesh::NONE;
  EXPECT_EQ(number_at_node, 1);
  // 1, 3 and 5 with one another and with the middle opposite each, and middles with the center
  EXPECT_EQ(critical_edges(mesh).size(), 9u);
}

TEST(Refined_mesh, node_points_divide_edges_by_length)
{
  Flat_loop_system system = unchecked_system(soups::octahedron(), {{0}, {2}, {4}}, {});
  system.loops[2].height = 3; // of pole 4
  Problems problems;
  complete(system, problems);
  const Foliation_state state(system, unit_weights(system));
  const Refined_mesh mesh = refined(state);
  expect_is_refinement(state, mesh);
  const std::set<Point> points(mesh.points.begin() + 6, mesh.points.begin() + 9);
  EXPECT_EQ(points, (std::set<Point>{{0.5, 0.5, 0}, {0, 0.75, 0.25}, {0.75, 0, 0.25}}));
}

TEST(Refined_mesh, of_a_torus_whose_vertices_are_all_at_the_node)
{
  const Torus torus;
  const Refined_mesh mesh = refined(torus.state);
  expect_is_refinement(torus.state, mesh);
  EXPECT_EQ(mesh.points.size(), 7u);
  ASSERT_EQ(mesh.faces.size(), 14u);
  std::set<std::pair<int, int>> cycle;
  for (int i = 0; i < 7; ++i)
    cycle.insert(std::minmax(i, (i + 2) % 7));
  EXPECT_EQ(critical_edges(mesh), cycle);
  for (const Refined_mesh::Face& face : mesh.faces) // from one side of the arc to the other
    EXPECT_EQ(*std::max_element(face.t.begin(), face.t.end()) -
                *std::min_element(face.t.begin(), face.t.end()),
              1);
}

TEST(Refined_mesh, edges_that_cross_a_whole_arc_between_two_nodes)
{
  // A tetrahedron with a pole at each corner: all four faces have a tripod.
  const Flat_loop_system system = flat_system(soups::tetrahedron(), {{0}, {1}, {2}, {3}});
  const Foliation_state state(system, unit_weights(system));
  const Refined_mesh mesh = refined(state);
  expect_is_refinement(state, mesh);
  EXPECT_EQ(mesh.points.size(), 4u + 6u + 4u);
  EXPECT_EQ(mesh.faces.size(), 4u * 6u);
  EXPECT_EQ(critical_edges(mesh).size(), 12u);
}

TEST(Refined_mesh, edges_that_pass_two_nodes)
{
  // and a loop between the poles 0 and 1 and the poles 2 and 3
  const Triangle_soup soup = soups::tetrahedron();
  const Flat_loop loop = flat_loop(flat_mesh(soup), {{2, 0}, {3, 0}, {3, 1}, {2, 1}});
  const Flat_loop_system system = flat_system(soup, {{0}, {1}, {2}, {3}}, {loop});
  ASSERT_EQ(system.nodes.size(), 6u);
  const Foliation_state state(system, unit_weights(system));
  const Refined_mesh mesh = refined(state);
  expect_is_refinement(state, mesh);
  EXPECT_EQ(mesh.points.size(), 4u + 2u + 2u * 4u + 4u);
  EXPECT_EQ(Leaf_graph(mesh).components().size(), 5u);
}

// ===  Leaf_graph.h

namespace {

void expect_component(const Leaf_graph::Component& component, std::vector<int> ends)
{
  EXPECT_EQ(component.euler_characteristic, 0); // an annulus, without its ends
  std::vector<int> found = component.ends;
  std::sort(found.begin(), found.end());
  std::sort(ends.begin(), ends.end());
  EXPECT_EQ(found, ends);
}

} // namespace

TEST(Leaf_graph, of_two_poles)
{
  const Equator e({0.5, 1, 1, 1.5});
  const Leaf_graph graph(refined(e.state));
  EXPECT_EQ(graph.number_of_leaves(), 2);
  EXPECT_EQ(graph.leaf_of_vertex(4), 0);
  EXPECT_EQ(graph.leaf_of_vertex(5), 1);
  EXPECT_EQ(graph.leaf_of_vertex(0), -1);
  ASSERT_EQ(graph.components().size(), 1u);
  expect_component(graph.components()[0], {0, 1});
}

TEST(Leaf_graph, of_faces_at_a_node)
{
  const Lower_half half;
  const Leaf_graph graph(refined(half.state));
  EXPECT_EQ(graph.number_of_leaves(), 2);
  for (int v : {1, 2, 3, 5})
    EXPECT_EQ(graph.leaf_of_vertex(v), graph.leaf_of_vertex(0));
  ASSERT_EQ(graph.components().size(), 1u);
  expect_component(graph.components()[0], {0, 1});
  int number_in_leaf = 0;
  for (int f = 0; f < graph.mesh().number_of_faces(); ++f)
    number_in_leaf += graph.component_of_face(f) == -1;
  EXPECT_EQ(number_in_leaf, 4);
}

TEST(Leaf_graph, of_three_poles)
{
  const Star star;
  const Refined_mesh mesh = refined(star.state);
  const Leaf_graph graph(mesh);
  EXPECT_EQ(graph.mesh().genus(), 0);
  EXPECT_EQ(graph.number_of_leaves(), 4);
  const int saddle = graph.leaf_of_vertex(1);
  for (int v : {3, 5, 6, 7, 8, 9})
    EXPECT_EQ(graph.leaf_of_vertex(v), saddle);
  ASSERT_EQ(graph.components().size(), 3u);
  for (const Leaf_graph::Component& component : graph.components())
  {
    const int arc = mesh.faces[component.first_face].arc; // of pole 2 * arc
    expect_component(component, {saddle, graph.leaf_of_vertex(2 * arc)});
  }
  for (int f = 0; f < graph.mesh().number_of_faces(); ++f)
    if (graph.component_of_face(f) >= 0)
    {
      EXPECT_EQ(mesh.faces[f].arc,
                mesh.faces[graph.components()[graph.component_of_face(f)].first_face].arc);
    }
}

TEST(Leaf_graph, of_an_arc_from_a_leaf_to_itself)
{
  const Torus torus;
  const Leaf_graph graph(refined(torus.state));
  EXPECT_EQ(graph.mesh().genus(), 1);
  EXPECT_EQ(graph.number_of_leaves(), 1);
  ASSERT_EQ(graph.components().size(), 1u);
  expect_component(graph.components()[0], {0, 0}); // once on each side
}

// ===  critical_polylines.h

namespace {

std::vector<std::size_t> sorted_sizes(const std::vector<std::vector<int>>& chains)
{
  std::vector<std::size_t> result;
  for (const std::vector<int>& chain : chains)
    result.push_back(chain.size());
  std::sort(result.begin(), result.end());
  return result;
}

// every critical edge is in one chain, once
void expect_chains_are_the_critical_edges(const Refined_mesh& mesh)
{
  std::set<std::pair<int, int>> edges;
  std::size_t number = 0;
  for (const std::vector<int>& chain : critical_polylines(mesh, Leaf_graph(mesh)))
    for (std::size_t i = 1; i < chain.size(); ++i, ++number)
      edges.insert(std::minmax(chain[i - 1], chain[i]));
  EXPECT_EQ(edges, critical_edges(mesh));
  EXPECT_EQ(number, edges.size());
}

} // namespace

TEST(Critical_polylines, go_from_branch_to_branch)
{
  const Star star;
  const Refined_mesh mesh = refined(star.state);
  const auto chains = critical_polylines(mesh, Leaf_graph(mesh));
  // three poles, the edges between 1, 3 and 5, and from each over a middle to the center
  EXPECT_EQ(sorted_sizes(chains), (std::vector<std::size_t>{1, 1, 1, 2, 2, 2, 3, 3, 3}));
  for (const std::vector<int>& chain : chains)
    if (chain.size() == 3)
    {
      EXPECT_EQ(std::count(chain.begin(), chain.end(), 9), 1);
      EXPECT_NE(chain[1], 9);
    }
  expect_chains_are_the_critical_edges(mesh);
}

TEST(Critical_polylines, close_where_there_is_no_branch)
{
  const Torus torus;
  const Refined_mesh mesh = refined(torus.state);
  const auto chains = critical_polylines(mesh, Leaf_graph(mesh));
  ASSERT_EQ(chains.size(), 1u);
  EXPECT_EQ(chains[0].size(), 8u);
  EXPECT_EQ(chains[0].front(), chains[0].back());
  expect_chains_are_the_critical_edges(mesh);
}

TEST(Critical_polylines, of_poles_and_of_faces_at_a_node)
{
  const Equator e({0.5, 1, 1, 1.5});
  const Refined_mesh whole = refined(e.state);
  EXPECT_EQ(critical_polylines(whole, Leaf_graph(whole)),
            (std::vector<std::vector<int>>{{4}, {5}}));
  const Lower_half half;
  const Refined_mesh mesh = refined(half.state);
  EXPECT_EQ(sorted_sizes(critical_polylines(mesh, Leaf_graph(mesh))),
            (std::vector<std::size_t>{1, 2, 2, 2, 2, 2, 2, 2, 2}));
  expect_chains_are_the_critical_edges(mesh);
}

// ===  component_labels.h

TEST(Component_labels, the_smallest_arc_wins_at_equal_distance)
{
  const Star star;
  const Refined_mesh mesh = refined(star.state);
  const std::vector<int> labels = component_labels(mesh, Leaf_graph(mesh));
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    EXPECT_EQ(labels[f], mesh.faces[f].arc == Refined_mesh::NONE ? 0 : mesh.faces[f].arc);
}

// Brute force: a face at a node takes the smallest label among its neighbors that are closer to
// the outside.
TEST(Component_labels, spread_in_rounds)
{
  const Flat_loop_system system = flat_system(
    soups::midpoint_subdivided(soups::midpoint_subdivided(soups::octahedron())), {{0}, {2}, {5}});
  const Foliation_state state(system, unit_weights(system)); // with nearly all vertices at a node
  const Refined_mesh mesh = refined(state);
  const Leaf_graph graph(mesh);
  const std::vector<int> labels = component_labels(mesh, graph);
  std::vector<int> expected;
  for (const Refined_mesh::Face& face : mesh.faces)
    expected.push_back(face.arc);
  int rounds = 0;
  for (; std::count(expected.begin(), expected.end(), Refined_mesh::NONE) > 0; ++rounds)
  {
    const std::vector<int> last = expected;
    for (int f = 0; f < graph.mesh().number_of_faces(); ++f)
      for (int h : graph.mesh().halfedges(f))
      {
        const int label = last[graph.mesh().face(opposite_of(h))];
        if (last[f] == Refined_mesh::NONE && label != Refined_mesh::NONE)
          expected[f] = expected[f] == Refined_mesh::NONE ? label : std::min(expected[f], label);
      }
  }
  EXPECT_GT(rounds, 4);
  EXPECT_EQ(labels, expected);
}

TEST(Soup_of, keeps_points_and_corners)
{
  const Triangle_soup soup = soups::octahedron();
  EXPECT_EQ(soup_of(flat_mesh(soup)).points, soup.points);
  EXPECT_EQ(soup_of(flat_mesh(soup)).triangles, soup.triangles);
  const Star star;
  const Refined_mesh mesh = refined(star.state);
  const Triangle_soup of_refined = soup_of(mesh);
  EXPECT_EQ(of_refined.points, mesh.points);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (int i : {0, 1, 2})
      EXPECT_EQ(static_cast<int>(of_refined.triangles[f][i]), mesh.faces[f].vertices[i]);
}

} // namespace test_refined_mesh
