// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// From a mesh to its Reeb graph in one call.

#include "include/example_systems.h"

#include <CGAL/Surface_mesh_foliation/foliation_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>

#include <boost/range/iterator_range.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace test_foliation_reeb_graph {

namespace {

using smf_test::Example;
using smf_test::Mesh;
using smf_test::Solved_example;
namespace SMF = CGAL::Surface_mesh_foliation;
namespace soups = smf_test::soups;

using Point = Mesh::Point;
using Foliation = SMF::Measured_foliation<Mesh>;

void expect_equal(const SMF::Reeb_graph<Point>& first, const SMF::Reeb_graph<Point>& second)
{
  ASSERT_EQ(num_vertices(first), num_vertices(second));
  ASSERT_EQ(num_edges(first), num_edges(second));
  for (const auto v : boost::make_iterator_range(vertices(first)))
  {
    EXPECT_EQ(first[v].point, second[v].point);
    EXPECT_EQ(first[v].kind, second[v].kind);
    EXPECT_EQ(first[v].pole, second[v].pole);
  }
  auto other = edges(second).first;
  for (const auto& e : boost::make_iterator_range(edges(first)))
  {
    EXPECT_EQ(source(e, first), source(*other, second));
    EXPECT_EQ(target(e, first), target(*other, second));
    EXPECT_EQ(first[e].loop, second[*other].loop);
    EXPECT_EQ(first[e].flux, second[*other].flux);
    EXPECT_EQ(first[e].polyline, second[*other].polyline);
    ++other;
  }
}

class One_call_of_example : public ::testing::TestWithParam<Example>
{
protected:
  One_call_of_example() : example(GetParam()) {}
  Solved_example<> example;
};

INSTANTIATE_TEST_SUITE_P(Examples,
                         One_call_of_example,
                         ::testing::ValuesIn(smf_test::all_example_systems()),
                         smf_test::name_of_example);

TEST_P(One_call_of_example, is_the_same_as_the_stages)
{
  SMF::Reeb_graph<Point> by_stages, by_one_call;
  SMF::reeb_graph(example.foliation, by_stages);
  const Foliation foliation = SMF::foliation_reeb_graph(*example.mesh, example.input, by_one_call);
  expect_equal(by_one_call, by_stages);
  EXPECT_EQ(foliation.statistics().energy, example.foliation.statistics().energy);
  EXPECT_EQ(&foliation.mesh(), example.mesh.get());
}

TEST(One_call, takes_a_range_of_poles)
{
  const Mesh mesh = smf_test::limbed_sphere(4, 3);
  std::vector<Mesh::Vertex_index> poles;
  SMF::Poles_and_loops<Mesh> input;
  for (const std::size_t tip : soups::limb_tips(4, 3))
  {
    poles.push_back(Mesh::Vertex_index(static_cast<Mesh::size_type>(tip)));
    input.add_pole(poles.back());
  }
  SMF::Reeb_graph<Point> first, second;
  SMF::foliation_reeb_graph(mesh, poles, first);
  SMF::foliation_reeb_graph(mesh, input, second);
  expect_equal(first, second);
  EXPECT_EQ(num_vertices(first), 5u);
}

TEST(One_call, passes_the_parameters_of_all_stages)
{
  const Solved_example<> example(smf_test::dumbbell_example());
  const auto weight =
    example.mesh->add_property_map<Mesh::Edge_index, double>("e:weight", 0.5).first;
  SMF::Reeb_graph<Point> by_stages, by_one_call;
  const Foliation foliation = SMF::harmonic_foliation(
    example.system, SMF::parameters::weights(weight).number_of_iterations(2));
  SMF::reeb_graph(foliation, by_stages, SMF::parameters::number_of_samples(5));
  const auto np = SMF::parameters::combine(
    SMF::parameters::number_of_samples(5).vertex_point_map(example.mesh->points()),
    SMF::parameters::weights(weight), CGAL::parameters::number_of_iterations(2));
  SMF::foliation_reeb_graph(*example.mesh, example.input, by_one_call, np);
  expect_equal(by_one_call, by_stages);
}

// ===  Exceptions leave the graph alone

template <class Call>
void expect_unchanged(const Call& call)
{
  SMF::Reeb_graph<Point> graph(2);
  graph[0].id = 17;
  add_edge(0, 1, graph);
  EXPECT_THROW(call(graph), SMF::Foliation_exception);
  EXPECT_EQ(num_vertices(graph), 2u);
  EXPECT_EQ(num_edges(graph), 1u);
  EXPECT_EQ(graph[0].id, 17u);
}

TEST(Exceptions_of_reeb_graph, leave_the_graph_unchanged)
{
  using Graph = SMF::Reeb_graph<Point>;
  const Solved_example<> example(smf_test::dumbbell_example());
  const Mesh& mesh = *example.mesh;
  const std::vector<Mesh::Vertex_index> twice(2, Mesh::Vertex_index(3)), none;
  expect_unchanged([&](Graph& graph) { SMF::foliation_reeb_graph(mesh, twice, graph); });
  expect_unchanged([&](Graph& graph) { SMF::foliation_reeb_graph(mesh, none, graph); });
  expect_unchanged([&](Graph& graph) { SMF::foliation_reeb_graph(Mesh(), twice, graph); });
  const auto few = SMF::parameters::number_of_samples(-1);
  expect_unchanged(
    [&](Graph& graph) { SMF::foliation_reeb_graph(mesh, example.input, graph, few); });
  expect_unchanged([&](Graph& graph) { SMF::reeb_graph(example.foliation, graph, few); });
  const auto bad_tolerance = SMF::parameters::tolerance(-1.);
  expect_unchanged(
    [&](Graph& graph) { SMF::foliation_reeb_graph(mesh, example.input, graph, bad_tolerance); });
  const auto zero = CGAL::Constant_property_map<Mesh::Edge_index, double>(0);
  expect_unchanged([&](Graph& graph) {
    SMF::foliation_reeb_graph(mesh, example.input, graph, SMF::parameters::weights(zero));
  });
}

} // namespace

} // namespace test_foliation_reeb_graph
