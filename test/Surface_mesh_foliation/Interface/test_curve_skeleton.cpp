// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Curve skeletons with the vertices around each point, as code for CGAL's skeletons expects them.

#include "include/example_systems.h"
#include "include/polylines.h"
#include "include/test_models.h"

#include <CGAL/Surface_mesh_foliation/curve_skeleton.h>
#include <CGAL/Surface_mesh_foliation/leaves.h>

#include <CGAL/Mean_curvature_flow_skeletonization.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/split_graph_into_polylines.h>

#include <boost/graph/connected_components.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace test_curve_skeleton {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
namespace soups = smf_test::soups;
using SMF::parameters::number_of_samples;
using smf_test::Example;
using smf_test::Mesh;
using smf_test::Solved_example;

template <class TriangleMesh>
class Skeletons : public ::testing::Test
{};

using Models = ::testing::Types<smf_test::Polyhedron_model<smf_test::Kernel>,
                                smf_test::Linear_cell_complex_model<smf_test::Kernel>,
                                smf_test::Surface_mesh_model<CGAL::Simple_cartesian<double>>>;
TYPED_TEST_SUITE(Skeletons, Models);

// What programs do with a skeleton of CGAL's, whose type they know as `Skeleton`: a value for each
// vertex of the mesh by way of the skeleton, which must reach every vertex exactly once.
template <class TriangleMesh, class Skeleton>
void expect_partition(const TriangleMesh& mesh, const Skeleton& skeleton)
{
  const auto times = get(CGAL::dynamic_vertex_property_t<int>(), mesh);
  for (const auto v : vertices(mesh))
    put(times, v, 0);
  std::size_t sum = 0;
  for (const auto p : CGAL::make_range(vertices(skeleton)))
    for (const auto v : skeleton[p].vertices)
    {
      put(times, v, get(times, v) + 1);
      ++sum;
    }
  EXPECT_EQ(sum, smf_test::vertex_list(mesh).size());
  for (const auto v : vertices(mesh))
    EXPECT_EQ(get(times, v), 1);
}

template <class TriangleMesh, class Skeleton>
void check(const Solved_example<TriangleMesh>& solved, int samples)
{
  const auto embedding = SMF::reeb_graph_embedding(solved.foliation, number_of_samples(samples));
  Skeleton skeleton;
  const auto points = SMF::curve_skeleton(solved.foliation, embedding, skeleton);
  ASSERT_EQ(points.size(), num_vertices(skeleton));
  expect_partition(*solved.mesh, skeleton);

  // nodes, then samples
  std::size_t number = 0;
  for (const auto& p : embedding.node_points)
    EXPECT_EQ(skeleton[points[number++]].point, p);
  for (const auto& polyline : embedding.arc_polylines)
    for (std::size_t i = 1; i + 1 < polyline.size(); ++i)
      EXPECT_EQ(skeleton[points[number++]].point, polyline[i]);
  EXPECT_EQ(number, points.size());
  EXPECT_EQ(num_edges(skeleton) + solved.system.number_of_nodes(),
            num_vertices(skeleton) + solved.system.number_of_arcs());
  for (std::size_t r = 0; r < solved.system.number_of_nodes(); ++r)
    EXPECT_EQ(degree(points[r], skeleton), solved.system.degree(r));
  std::vector<int> piece(num_vertices(skeleton));
  EXPECT_EQ(boost::connected_components(skeleton, piece.data()), 1);

  // the property map says the same
  const auto sample = get(CGAL::dynamic_vertex_property_t<std::size_t>(), *solved.mesh);
  EXPECT_EQ(SMF::vertex_samples(solved.foliation, embedding, sample), points.size());
  for (std::size_t p = 0; p < points.size(); ++p)
    for (const auto v : skeleton[points[p]].vertices)
      EXPECT_EQ(get(sample, v), p);
}

std::vector<Example> examples()
{
  std::vector<Example> result;
  for (const Example& example : smf_test::example_systems())
    if (example.name != "theta" && example.name != "genus in a region")
      result.push_back(example);
  return result;
}

TYPED_TEST(Skeletons, have_each_vertex_once)
{
  for (const Example& example : examples())
  {
    SCOPED_TRACE(example.name);
    const Solved_example<TypeParam> solved(example);
    for (const int samples : {0, 1, 20})
      check<TypeParam, SMF::Curve_skeleton<TypeParam>>(solved, samples);
  }
}

// the type of CGAL's package itself
TEST(Skeleton, of_Mean_curvature_flow_skeletonization)
{
  using Polyhedron = smf_test::Polyhedron_model<smf_test::Kernel>;
  for (const Example& example : examples())
  {
    SCOPED_TRACE(example.name);
    check<Mesh, CGAL::Mean_curvature_flow_skeletonization<Mesh>::Skeleton>(
      Solved_example<>(example), 20);
    check<Polyhedron, CGAL::Mean_curvature_flow_skeletonization<Polyhedron>::Skeleton>(
      Solved_example<Polyhedron>(example), 20);
  }
}

// as in CGAL's example simple_mcfskel_example.cpp
template <class Skeleton>
struct Polyline_counter
{
  const Skeleton& skeleton;
  std::size_t& number;
  std::size_t& points;
  void start_new_polyline() { ++number; }
  void add_node(typename boost::graph_traits<Skeleton>::vertex_descriptor) { ++points; }
  void end_polyline() {}
};

TEST(Skeleton, splits_into_the_arcs)
{
  for (const Example& example : examples())
  {
    SCOPED_TRACE(example.name);
    const Solved_example<> solved(example);
    const auto embedding = SMF::reeb_graph_embedding(solved.foliation, number_of_samples(5));
    SMF::Curve_skeleton<Mesh> skeleton;
    SMF::curve_skeleton(solved.foliation, embedding, skeleton);
    std::size_t number = 0, points = 0;
    Polyline_counter<SMF::Curve_skeleton<Mesh>> counter = {skeleton, number, points};
    CGAL::split_graph_into_polylines(skeleton, counter);
    std::size_t expected_points = 0;
    for (const auto& polyline : embedding.arc_polylines)
      expected_points += polyline.size();
    EXPECT_EQ(number, solved.system.number_of_arcs());
    EXPECT_EQ(points, expected_points);
  }
}

TEST(Skeleton, vertices_are_around_their_points)
{
  const Example limbs = {"", soups::limbed_sphere(5, 4),
                         smf_test::pole_items(soups::limb_tips(5, 4))};
  const Solved_example<> solved(limbs);
  const auto embedding = SMF::reeb_graph_embedding(solved.foliation);
  SMF::Curve_skeleton<Mesh> skeleton;
  const auto points = SMF::curve_skeleton(solved.foliation, embedding, skeleton);
  const auto number = solved.mesh->add_property_map<Mesh::Vertex_index, std::size_t>("v:n").first;
  SMF::vertex_samples(solved.foliation, embedding, number);
  for (const auto v : vertices(*solved.mesh))
  {
    const auto cell = solved.foliation.cell(v);
    if (!cell.is_arc)
    {
      EXPECT_EQ(number[v], cell.index);
      continue;
    }
    // no other level of the arc is nearer
    const std::vector<double>& levels = embedding.levels[cell.index];
    const double t = solved.foliation.parameter(v), height = solved.system.height(cell.index);
    double nearest = (std::min)(t, height - t);
    for (const double level : levels)
      nearest = (std::min)(nearest, std::abs(t - level));
    std::size_t first = solved.system.number_of_nodes();
    for (std::size_t a = 0; a < cell.index; ++a)
      first += embedding.levels[a].size();
    const double own = number[v] >= first ? levels.at(number[v] - first)
                       : number[v] == solved.system.node(cell.index, 0) ? 0
                                                                        : height;
    EXPECT_EQ(std::abs(t - own), nearest);
    if (number[v] < first)
    {
      EXPECT_TRUE(number[v] == solved.system.node(cell.index, 0) ||
                  number[v] == solved.system.node(cell.index, 1));
    }
  }
  for (std::size_t a = 0; a < embedding.levels.size(); ++a)
    for (std::size_t i = 0; i < embedding.levels[a].size(); ++i)
      EXPECT_EQ(skeleton[points[6 + 20 * a + i]].radius, embedding.leaf_radii[a][i]);
}

// A bundle of the user's with members of the same names that mean something else.
struct Own_point
{
  Mesh::Point point;
  std::vector<Mesh::Vertex_index> vertices;
  int level = 17;
};

TEST(Skeleton, points_know_their_arc_or_node_and_level)
{
  for (const Example& example : examples())
  {
    SCOPED_TRACE(example.name);
    const Solved_example<> solved(example);
    const auto embedding = SMF::reeb_graph_embedding(solved.foliation, number_of_samples(7));
    SMF::Curve_skeleton<Mesh> skeleton;
    const auto points = SMF::curve_skeleton(solved.foliation, embedding, skeleton);
    std::size_t number = 0;
    for (std::size_t r = 0; r < solved.system.number_of_nodes(); ++r)
    {
      const auto& point = skeleton[points[number++]];
      EXPECT_FALSE(point.cell.is_arc);
      EXPECT_EQ(point.cell.index, r);
      EXPECT_EQ(point.level, 0);
    }
    for (std::size_t a = 0; a < solved.system.number_of_arcs(); ++a)
      for (const double level : embedding.levels[a])
      {
        const auto& point = skeleton[points[number++]];
        EXPECT_TRUE(point.cell.is_arc);
        EXPECT_EQ(point.cell.index, a);
        EXPECT_EQ(point.level, level);
        // so do the vertices around it
        for (const auto v : point.vertices)
        {
          ASSERT_TRUE(solved.foliation.cell(v).is_arc);
          EXPECT_EQ(solved.foliation.cell(v).index, a);
        }
      }
    EXPECT_EQ(number, points.size());

    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Own_point> own;
    for (const auto p : SMF::curve_skeleton(solved.foliation, embedding, own))
      EXPECT_EQ(own[p].level, 17) << "only with a cell does it mean the level";
  }
}

TEST(Skeleton, of_another_foliation_is_refused)
{
  const std::vector<Example> all = examples();
  const Solved_example<> first(all[0]), second(all[1]);
  const auto embedding = SMF::reeb_graph_embedding(first.foliation);
  SMF::Curve_skeleton<Mesh> skeleton;
  EXPECT_THROW(SMF::curve_skeleton(second.foliation, embedding, skeleton),
               SMF::Invalid_parameter_exception);
  EXPECT_EQ(num_vertices(skeleton), 0u);
  const auto number = second.mesh->add_property_map<Mesh::Vertex_index, std::size_t>("v:n").first;
  EXPECT_THROW(SMF::vertex_samples(second.foliation, embedding, number),
               SMF::Invalid_parameter_exception);
}

} // namespace

} // namespace test_curve_skeleton
