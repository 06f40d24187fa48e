// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes of several parts: each has the graph that it would have alone, and all are in one graph.

#include "generators/genus_soups.h"
#include "generators/openings.h"
#include "include/problem_of.h"

#include <CGAL/Surface_mesh_foliation/IO/read_triangle_mesh.h>
#include <CGAL/Surface_mesh_foliation/add_missing_poles.h>
#include <CGAL/Surface_mesh_foliation/automatic_loops.h>
#include <CGAL/Surface_mesh_foliation/components.h>
#include <CGAL/Surface_mesh_foliation/foliation_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/loops.h>
#include <CGAL/Surface_mesh_foliation/openings.h>
#include <CGAL/Surface_mesh_foliation/parts.h>

#include <CGAL/Polyhedron_3.h>

#include <boost/range/iterator_range.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>
#include <vector>

namespace test_parts {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
namespace soups = smf_test::soups;
using SMF::Triangle_soup;
using smf_test::Mesh;
using Point = Mesh::Point;
using Graph = SMF::Reeb_graph<Point>;
using Part = SMF::Mesh_part<Mesh>;

// Parts with different areas: a small sphere, a torus, a body with four limbs, a sphere with two
// openings, a surface of genus 2.
std::vector<Triangle_soup> soups_of_parts()
{
  smf_test::Random random(3);
  std::vector<Triangle_soup> result = {
    soups::icosphere(1), soups::torus(9, 7, 3, 1), soups::limbed_sphere(4, 3),
    soups::with_random_openings(soups::icosphere(2), 2, random), soups::genus_surface(2)};
  const std::vector<double> scales = {0.1, 1, 2, 0.5, 3};
  for (std::size_t i = 0; i < result.size(); ++i)
    for (auto& p : result[i].points)
    {
      p = soups::scaled(p, scales[i]);
      p[0] += 20. * i;
    }
  return result;
}

// all in one, their faces mixed: one of each in turn
Triangle_soup mixed(const std::vector<Triangle_soup>& parts)
{
  Triangle_soup result;
  std::vector<std::size_t> first;
  std::size_t most = 0;
  for (const Triangle_soup& part : parts)
  {
    first.push_back(result.points.size());
    result.points.insert(result.points.end(), part.points.begin(), part.points.end());
    most = (std::max)(most, part.triangles.size());
  }
  for (std::size_t f = 0; f < most; ++f)
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (f < parts[i].triangles.size())
      {
        const auto& [a, b, c] = parts[i].triangles[f];
        result.triangles.push_back({a + first[i], b + first[i], c + first[i]});
      }
  return result;
}

template <class TriangleMesh>
TriangleMesh to_mesh_of_parts(const Triangle_soup& soup)
{
  TriangleMesh mesh;
  SMF::triangle_soup_to_triangle_mesh(soup, mesh,
                                      SMF::parameters::allow_openings(true).allow_parts(true));
  return mesh;
}

template <class TriangleMesh>
void find(const TriangleMesh& mesh, SMF::Poles_and_loops<TriangleMesh>& input)
{
  SMF::add_border_poles(mesh, input);
  SMF::propose_loops(mesh, input);
  SMF::add_missing_poles(mesh, input);
}

std::vector<std::size_t> sorted_degrees(const Graph& graph)
{
  std::vector<std::size_t> result;
  for (const auto v : boost::make_iterator_range(vertices(graph)))
    result.push_back(degree(v, graph));
  std::sort(result.begin(), result.end());
  return result;
}

class Parts : public ::testing::Test
{
protected:
  const std::vector<Triangle_soup> soups = soups_of_parts();
  const Mesh mesh = to_mesh_of_parts<Mesh>(mixed(soups));
  const std::vector<Part> parts = SMF::mesh_parts(mesh);
};

TEST_F(Parts, come_from_the_largest_area_to_the_smallest)
{
  ASSERT_EQ(parts.size(), soups.size());
  std::vector<double> areas;
  for (const Part& part : parts)
  {
    double area = 0;
    for (const auto f : faces(part))
    {
      const auto h = halfedge(f, part);
      area += std::sqrt(CGAL::squared_area(mesh.point(source(h, part)), mesh.point(target(h, part)),
                                           mesh.point(target(next(h, part), part))));
    }
    areas.push_back(area);
  }
  EXPECT_TRUE(std::is_sorted(areas.rbegin(), areas.rend()));
  std::multiset<std::size_t> sizes, expected;
  for (std::size_t i = 0; i < soups.size(); ++i)
  {
    sizes.insert(vertices(parts[i]).size());
    expected.insert(soups[i].points.size());
  }
  EXPECT_EQ(sizes, expected);
}

TEST_F(Parts, can_be_the_largest_only)
{
  for (const int number : {1, 3, 99})
  {
    const auto some = SMF::mesh_parts(mesh, SMF::parameters::number_of_parts(number));
    ASSERT_EQ(some.size(), (std::min)(parts.size(), static_cast<std::size_t>(number)));
    for (std::size_t i = 0; i < some.size(); ++i)
      EXPECT_EQ(*faces(some[i]).begin(), *faces(parts[i]).begin());
  }
  EXPECT_THROW(SMF::mesh_parts(mesh, SMF::parameters::number_of_parts(0)),
               SMF::Invalid_parameter_exception);
}

// what each part gives alone, as a mesh of its own
TEST_F(Parts, have_the_graphs_that_they_have_alone)
{
  SMF::Poles_and_loops<Mesh> none;
  auto input = SMF::poles_and_loops_of_parts(parts, none);
  for (std::size_t i = 0; i < parts.size(); ++i)
    find(parts[i], input[i]);
  Graph graph;
  const auto foliations = SMF::foliation_reeb_graph_of_parts(parts, input, graph);
  ASSERT_EQ(foliations.size(), parts.size());

  std::size_t first_node = 0, first_loop = 0, first_pole = 0;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    // of the same size
    const auto soup = std::find_if(soups.begin(), soups.end(), [&](const Triangle_soup& candidate) {
      return candidate.points.size() == vertices(parts[i]).size();
    });
    const Mesh alone = to_mesh_of_parts<Mesh>(*soup);
    SMF::Poles_and_loops<Mesh> input_alone;
    find(alone, input_alone);
    Graph graph_alone;
    const auto foliation = SMF::foliation_reeb_graph(alone, input_alone, graph_alone);
    EXPECT_EQ(foliations[i].statistics().energy, foliation.statistics().energy);
    for (std::size_t r = 0; r < num_vertices(graph_alone); ++r)
    {
      const auto& node = graph[first_node + r];
      EXPECT_EQ(node.id, first_node + r);
      EXPECT_EQ(node.part, i);
      EXPECT_EQ(node.kind, graph_alone[r].kind);
      EXPECT_EQ(node.point, graph_alone[r].point);
      EXPECT_EQ(node.pole,
                graph_alone[r].pole < 0 ? -1 : graph_alone[r].pole + static_cast<int>(first_pole));
    }
    first_node += num_vertices(graph_alone);
    first_loop += input_alone.size();
    first_pole += foliation.system().number_of_poles();
  }
  EXPECT_EQ(num_vertices(graph), first_node);
  std::set<std::size_t> loops;
  for (const auto& e : boost::make_iterator_range(edges(graph)))
  {
    EXPECT_EQ(graph[e].part, graph[source(e, graph)].part);
    EXPECT_EQ(graph[e].part, graph[target(e, graph)].part);
    EXPECT_LT(graph[e].loop, first_loop);
    loops.insert(graph[e].loop);
  }
  EXPECT_EQ(loops.size(), num_edges(graph)) << "each arc has a loop of its own";
}

TEST_F(Parts, are_given_their_poles_and_loops)
{
  // a pole on each vertex of one face of each part, and the borders
  SMF::Poles_and_loops<Mesh> input;
  for (const Part& part : parts)
    for (const auto v : vertices_around_face(halfedge(*faces(part).begin(), part), part))
      if (!is_border(v, part))
        input.add_pole(v, 2.5);
  const std::size_t number_of_poles = input.size();
  const std::size_t number_of_openings = SMF::add_border_poles(mesh, input, 0.5);
  ASSERT_GT(number_of_openings, 0u);
  std::vector<SMF::Loop<Mesh>> loops;
  const auto v = *vertices(parts[0]).begin();
  std::vector<Mesh::Vertex_index> disk = {v};
  SMF::loops_around_vertices(disk, mesh, std::back_inserter(loops));
  input.add_loop(loops[0], 7);
  const auto distributed = SMF::poles_and_loops_of_parts(parts, input);
  std::size_t number = 0;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    number += distributed[i].size();
    for (const auto& entry : distributed[i].entries())
    {
      EXPECT_EQ(entry.height, !entry.pole.empty() ? 2.5 : entry.is_pole_loop() ? 0.5 : 7);
      EXPECT_TRUE(entry.pole.empty() || parts[i].is_in_cc(entry.pole[0]));
      EXPECT_TRUE(entry.pole.size() > 0 || !entry.is_pole_loop() ||
                  is_border(entry.border, parts[i]));
    }
  }
  EXPECT_EQ(number, input.size());
  EXPECT_EQ(input.size(), number_of_poles + number_of_openings + 1);
  EXPECT_EQ(distributed[0].entries().back().loop.size(), loops[0].size());
}

TEST_F(Parts, refuse_what_lies_on_none_of_them)
{
  SMF::Poles_and_loops<Mesh> input;
  input.add_pole(*vertices(parts[0]).begin());
  input.add_pole(*vertices(parts[1]).begin());
  const auto largest = SMF::mesh_parts(mesh, SMF::parameters::number_of_parts(1));
  const SMF::Problem problem =
    smf_test::problem_of([&] { SMF::poles_and_loops_of_parts(largest, input); });
  EXPECT_EQ(problem.kind, SMF::Problem_kind::INVALID_POLE);
  EXPECT_EQ(problem.loops, std::vector<std::size_t>{1});
  Graph graph;
  EXPECT_THROW(SMF::foliation_reeb_graph_of_parts(largest, {}, graph),
               SMF::Invalid_parameter_exception);
}

TEST_F(Parts, share_property_maps_of_the_mesh)
{
  SMF::Poles_and_loops<Mesh> none;
  auto input = SMF::poles_and_loops_of_parts(parts, none);
  Graph graph;
  for (std::size_t i = 0; i < parts.size(); ++i)
    find(parts[i], input[i]);
  const auto foliations = SMF::foliation_reeb_graph_of_parts(parts, input, graph);
  Mesh copy = mesh;
  const std::size_t unset = 1000;
  auto component = copy.add_property_map<Mesh::Face_index, std::size_t>("f:component", unset).first;
  for (const auto& foliation : foliations)
    SMF::face_segmentation(foliation, component);
  for (const auto f : faces(copy))
    EXPECT_LT(component[f], unset);
}

// models of other kinds
TEST(Parts_of_a_polyhedron, have_graphs)
{
  using Polyhedron = CGAL::Polyhedron_3<smf_test::Kernel>;
  const Polyhedron mesh = to_mesh_of_parts<Polyhedron>(mixed(soups_of_parts()));
  const auto parts = SMF::mesh_parts(mesh);
  ASSERT_EQ(parts.size(), 5u);
  auto input = SMF::poles_and_loops_of_parts(parts, SMF::Poles_and_loops<Polyhedron>());
  for (std::size_t i = 0; i < parts.size(); ++i)
    find(parts[i], input[i]);
  Graph graph, expected;
  SMF::foliation_reeb_graph_of_parts(parts, input, graph);
  const Mesh same = to_mesh_of_parts<Mesh>(mixed(soups_of_parts()));
  const auto same_parts = SMF::mesh_parts(same);
  auto same_input = SMF::poles_and_loops_of_parts(same_parts, SMF::Poles_and_loops<Mesh>());
  for (std::size_t i = 0; i < parts.size(); ++i)
    find(same_parts[i], same_input[i]);
  SMF::foliation_reeb_graph_of_parts(same_parts, same_input, expected);
  EXPECT_EQ(sorted_degrees(graph), sorted_degrees(expected));
}

TEST(Part, that_is_all_of_a_mesh_is_the_mesh)
{
  for (const Triangle_soup& soup :
       {soups::limbed_sphere(4, 3), soups::torus(9, 7, 3, 1), soups::handle_surface(3)})
  {
    const Mesh mesh = to_mesh_of_parts<Mesh>(soup);
    const auto parts = SMF::mesh_parts(mesh);
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_EQ(faces(parts[0]).size(), faces(mesh).size());
    SMF::Poles_and_loops<Mesh> input;
    find(mesh, input);
    Graph graph, graph_of_part;
    const auto foliation = SMF::foliation_reeb_graph(mesh, input, graph);
    SMF::foliation_reeb_graph_of_parts(parts, SMF::poles_and_loops_of_parts(parts, input),
                                       graph_of_part);
    ASSERT_EQ(num_edges(graph), num_edges(graph_of_part));
    auto e = edges(graph_of_part).first;
    for (const auto& arc : boost::make_iterator_range(edges(graph)))
    {
      EXPECT_EQ(graph[arc].flux, graph_of_part[*e].flux);
      EXPECT_EQ(graph[arc].polyline, graph_of_part[*e].polyline);
      ++e;
    }
  }
}

} // namespace

} // namespace test_parts
