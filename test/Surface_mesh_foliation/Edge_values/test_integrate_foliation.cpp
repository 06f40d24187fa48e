// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Foliations that are given by the values of their edges, made by hand; and values that are those
// of no foliation.

#include "include/edge_value_examples.h"
#include "include/example_systems.h"
#include "include/problem_of.h"
#include "include/test_models.h"
#include "generators/Random.h"
#include "include/two_roads.h"
#include "include/wrapped_mesh.h"

#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/integrate_foliation.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_of_function.h>
#include <CGAL/Surface_mesh_foliation/singularities.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/iterator.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace test_integrate_foliation {

using namespace smf_test;
using SMF::Problem_kind;
using Vertex = Mesh::Vertex_index;

namespace {

// a mesh, its values as a property map, and the foliation that they are
template <class TriangleMesh = Mesh>
struct Valued_mesh
{
  using Edge = typename boost::graph_traits<TriangleMesh>::edge_descriptor;
  using Values =
    typename boost::property_map<TriangleMesh, CGAL::dynamic_edge_property_t<double>>::type;

  explicit Valued_mesh(const Edge_value_example& example)
    : mesh(to_mesh<TriangleMesh>(example.soup)),
      values(get(CGAL::dynamic_edge_property_t<double>(), mesh))
  {
    std::map<typename boost::graph_traits<TriangleMesh>::vertex_descriptor, std::size_t> number;
    for (const auto v : vertices(mesh))
      number.emplace(v, number.size());
    for (const Edge e : edges(mesh))
      put(values, e, example.value(number.at(source(e, mesh)), number.at(target(e, mesh))));
  }

  void scale(double factor)
  {
    for (const Edge e : edges(mesh))
      put(values, e, factor * get(values, e));
  }

  void expect_values(const SMF::Measured_foliation<TriangleMesh>& foliation, double tolerance) const
  {
    for (const Edge e : edges(mesh))
      EXPECT_NEAR(foliation.edge_value(e), get(values, e), tolerance);
  }

  TriangleMesh mesh;
  Values values;
};

template <class... Parameters>
SMF::Problem problem_of_values(const Edge_value_example& example, const Parameters&... np)
{
  const Valued_mesh<> valued(example);
  return problem_of([&] { SMF::integrate_foliation(valued.mesh, valued.values, np...); });
}

// the tetrahedron with equal values, with the value of edge 0 1 changed
Edge_value_example tetrahedron_with(double value)
{
  return {"tetrahedron", soups::tetrahedron(),
          [=](std::size_t u, std::size_t v) { return u + v == 1 ? value : 2; }};
}

std::vector<int> indices(const SMF::Measured_foliation<Mesh>& foliation)
{
  std::vector<SMF::Singularity<Mesh>> singularities;
  SMF::singularities(foliation, std::back_inserter(singularities));
  std::vector<int> result;
  for (const auto& singularity : singularities)
    result.push_back(singularity.index);
  std::sort(result.begin(), result.end());
  return result;
}

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

} // namespace

// ===  Foliations made by hand

TEST(Integrate_foliation, straight_lines_on_a_torus)
{
  // the leaves run around the tube and the axis p and q times; the height is their distance
  struct Lines
  {
    double a, b, height;
  };
  for (const auto& [a, b, height] :
       std::vector<Lines>{{1, 0, 12}, {0, 1, 8}, {1, 1, 4}, {2, 1, 8}, {2, -3, 24}, {7, 3, 12}})
  {
    SCOPED_TRACE(a);
    SCOPED_TRACE(b);
    const Valued_mesh<> torus(linear_torus(12, 8, a, b));
    const auto foliation = SMF::integrate_foliation(torus.mesh, torus.values);
    EXPECT_EQ(foliation.system().number_of_arcs(), 1u);
    EXPECT_EQ(foliation.system().number_of_nodes(), 1u);
    EXPECT_NEAR(foliation.system().height(0), height, 1e-12);
    EXPECT_TRUE(indices(foliation).empty());
    torus.expect_values(foliation, 1e-12);
  }
}

TEST(Integrate_foliation, leaves_of_irrational_slope_do_not_close)
{
  const SMF::Problem problem = problem_of_values(linear_torus(12, 8, 1, std::sqrt(2.)));
  EXPECT_EQ(problem.kind, Problem_kind::OPEN_LEAF);
  EXPECT_EQ(problem.vertices, (std::vector<std::size_t>{0}));
  EXPECT_EQ(problem.faces.size(), 1u);
}

TEST(Integrate_foliation, bound_on_the_length_of_leaves)
{
  const Edge_value_example example = linear_torus(12, 8, 7, 3);
  EXPECT_EQ(problem_of_values(example, SMF::parameters::max_leaf_length(20)).kind,
            Problem_kind::OPEN_LEAF);
  const Valued_mesh<> torus(example);
  SMF::integrate_foliation(torus.mesh, torus.values, SMF::parameters::max_leaf_length(1000));
}

TEST(Integrate_foliation, critical_leaves_along_edges)
{
  for (const bool is_wide : {false, true})
  {
    SCOPED_TRACE(is_wide);
    const Valued_mesh<> valued(three_disks(is_wide));
    const auto foliation = SMF::integrate_foliation(valued.mesh, valued.values);
    const auto& system = foliation.system();
    ASSERT_EQ(system.number_of_arcs(), 3u);
    ASSERT_EQ(system.number_of_nodes(), 4u);
    valued.expect_values(foliation, 0);
    for (std::size_t a = 0; a < 3; ++a)
    {
      const int pole = system.pole(system.node(a, 0));
      ASSERT_GE(pole, 0);
      const auto v = system.pole_vertices(static_cast<std::size_t>(pole)).at(0);
      EXPECT_EQ(system.height(a), 1. + static_cast<double>(std::size_t(v)));
    }
    for (const auto v : vertices(valued.mesh))
      EXPECT_FALSE(foliation.cell(v).is_arc);
    EXPECT_EQ(indices(foliation),
              (is_wide ? std::vector<int>{-2, 2, 2, 2} : std::vector<int>{-1, -1, 2, 2, 2}));
  }
}

TEST(Integrate_foliation, closed_leaf_along_edges_inside_a_component)
{
  const Valued_mesh<> valued(flat_equator());
  const auto foliation = SMF::integrate_foliation(valued.mesh, valued.values);
  ASSERT_EQ(foliation.system().number_of_arcs(), 1u);
  EXPECT_EQ(foliation.system().height(0), 3);
  valued.expect_values(foliation, 0);
  for (std::size_t v : {0, 1, 2, 3})
    EXPECT_TRUE(foliation.cell(vertex(v)).is_arc);
}

// The level sets of a function are the leaves of its differences.
TEST(Integrate_foliation, level_sets_of_functions)
{
  std::size_t arcs = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    Mesh mesh = genus_surface(seed % 5);
    const auto function = mesh.add_property_map<Vertex, double>("v:function").first;
    const auto value = mesh.add_property_map<Mesh::Edge_index, double>("e:value").first;
    for (const auto v : vertices(mesh)) // many critical points, or few
      function[v] = random.between(0, seed % 2 == 0 ? 1 : 0.01) + mesh.point(v).x();
    for (const auto e : edges(mesh))
      value[e] = std::abs(function[mesh.vertex(e, 0)] - function[mesh.vertex(e, 1)]);
    SMF::Scalar_reeb_graph<Mesh> graph;
    SMF::reeb_graph_of_function(mesh, function, graph, SMF::parameters::unfold_saddles(false));
    const auto foliation = SMF::integrate_foliation(mesh, value);
    const auto& system = foliation.system();
    EXPECT_EQ(system.number_of_nodes(), num_vertices(graph));
    std::vector<double> heights, spans;
    for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
      heights.push_back(system.height(a));
    for (const auto& arc : CGAL::make_range(boost::edges(graph)))
      spans.push_back(graph[arc].upper - graph[arc].lower);
    std::sort(heights.begin(), heights.end());
    std::sort(spans.begin(), spans.end());
    ASSERT_EQ(heights.size(), spans.size());
    for (std::size_t a = 0; a < heights.size(); ++a)
      EXPECT_NEAR(heights[a], spans[a], 1e-12);
    for (const auto e : edges(mesh))
      EXPECT_NEAR(foliation.edge_value(e), value[e], 1e-12);
    arcs += heights.size();
  }
  EXPECT_GT(arcs, 200u);
}

TEST(Integrate_foliation, does_not_depend_on_the_unit)
{
  const Solved_example<> solved(theta_example());
  for (const double factor : {1e-200, 3e-5, 1e9, 1e150})
  {
    SCOPED_TRACE(factor);
    Valued_mesh<> valued({"", theta_example().soup, [](std::size_t, std::size_t) { return 0.; }});
    SMF::edge_values(solved.foliation, valued.values);
    valued.scale(factor);
    const auto foliation = SMF::integrate_foliation(valued.mesh, valued.values);
    valued.expect_values(foliation, 1e-13 * factor);
    EXPECT_EQ(foliation.system().number_of_nodes(), 2u);
    EXPECT_EQ(foliation.system().number_of_arcs(), 3u);
  }
}

TEST(Integrate_foliation, rounded_values_need_a_tolerance)
{
  for (const Example& example : example_systems())
  {
    SCOPED_TRACE(example.name);
    const Solved_example<> solved(example);
    Valued_mesh<> valued({"", example.soup, [](std::size_t, std::size_t) { return 0.; }});
    SMF::edge_values(solved.foliation, valued.values);
    for (const auto e : edges(valued.mesh))
      put(valued.values, e, static_cast<double>(static_cast<float>(get(valued.values, e))));
    const auto foliation =
      SMF::integrate_foliation(valued.mesh, valued.values, SMF::parameters::tolerance(1e-5));
    EXPECT_EQ(foliation.system().number_of_nodes(), solved.system.number_of_nodes());
    EXPECT_EQ(foliation.system().number_of_arcs(), solved.system.number_of_arcs());
    valued.expect_values(foliation, 1e-5);
  }
}

TEST(Integrate_foliation, statistics_are_those_of_the_solver)
{
  const Solved_example<> solved(example_systems()[0]);
  const auto weight = solved.mesh->add_property_map<Mesh::Edge_index, double>("e:weight", 3).first;
  const auto value = solved.mesh->add_property_map<Mesh::Edge_index, double>("e:value").first;
  SMF::edge_values(solved.foliation, value);
  const auto same = SMF::integrate_foliation(*solved.mesh, value);
  EXPECT_NEAR(same.statistics().energy, solved.foliation.statistics().energy, 1e-12);
  EXPECT_TRUE(same.statistics().has_converged);
  EXPECT_EQ(same.statistics().number_of_iterations, 0u);
  const auto other =
    SMF::integrate_foliation(*solved.mesh, value, SMF::parameters::weights(weight));
  EXPECT_FALSE(other.statistics().has_converged);
  EXPECT_TRUE(other.statistics().is_certified);
}

// ===  Values of no foliation

TEST(Integrate_foliation, bad_values_are_refused)
{
  for (const double value : {-1., not_a_number, (std::numeric_limits<double>::infinity)()})
  {
    SCOPED_TRACE(value);
    const SMF::Problem problem = problem_of_values(tetrahedron_with(value));
    EXPECT_EQ(problem.kind, Problem_kind::INVALID_EDGE_VALUE);
    EXPECT_EQ(problem.vertices.size(), 2u);
    EXPECT_EQ(problem.vertices[0] + problem.vertices[1], 1u);
    EXPECT_EQ(problem.faces.size(), 2u);
  }
  const Edge_value_example zero = {"", soups::tetrahedron(),
                                   [](std::size_t, std::size_t) { return 0.; }};
  EXPECT_EQ(problem_of_values(zero).kind, Problem_kind::INVALID_EDGE_VALUE);
}

TEST(Integrate_foliation, violated_triangle_inequality_is_refused)
{
  const SMF::Problem problem = problem_of_values(tetrahedron_with(4.001));
  EXPECT_EQ(problem.kind, Problem_kind::INVALID_EDGE_VALUE);
  EXPECT_EQ(problem.faces, (std::vector<std::size_t>{0})); // of both with edge 0 1 the first
  EXPECT_NE(problem.message.find("face 0"), std::string::npos);
  EXPECT_NO_THROW(Valued_mesh<>(tetrahedron_with(3.9)));
}

TEST(Integrate_foliation, thorns_that_are_no_ends_of_lines_are_refused)
{
  const SMF::Problem problem = problem_of_values(pillow());
  EXPECT_EQ(problem.kind, Problem_kind::INVALID_POLE);
  EXPECT_EQ(problem.vertices, (std::vector<std::size_t>{0}));
}

TEST(Integrate_foliation, wide_poles_are_refused)
{
  // all values but those to one vertex are zero
  const Edge_value_example wide = {"", soups::octahedron(),
                                   [](std::size_t u, std::size_t v) { return u == 4 || v == 4; }};
  EXPECT_EQ(problem_of_values(wide).kind, Problem_kind::INVALID_POLE);
}

TEST(Integrate_foliation, bad_parameters_are_refused)
{
  const Edge_value_example example = tetrahedron_with(2);
  for (const double tolerance : {0., -1., 1., not_a_number})
    EXPECT_EQ(problem_of_values(example, SMF::parameters::tolerance(tolerance)).kind,
              Problem_kind::INVALID_PARAMETER);
  EXPECT_EQ(problem_of_values(example, SMF::parameters::max_leaf_length(-1)).kind,
            Problem_kind::INVALID_PARAMETER);
}

TEST(Integrate_foliation, bad_meshes_are_refused)
{
  Mesh mesh = tetrahedron();
  const auto value = mesh.add_property_map<Mesh::Edge_index, double>("e:value", 1).first;
  CGAL::Euler::remove_face(halfedge(*faces(mesh).begin(), mesh), mesh);
  EXPECT_EQ(problem_of([&] { SMF::integrate_foliation(mesh, value); }).kind,
            Problem_kind::NOT_CLOSED);
}

// ===  Types of meshes

template <class TriangleMesh>
class Integrate_on : public testing::Test
{};

using Models = testing::Types<Polyhedron_model<Kernel>, Linear_cell_complex_model<Kernel>, Mesh>;
TYPED_TEST_SUITE(Integrate_on, Models);

TYPED_TEST(Integrate_on, all_models_alike)
{
  for (const Example& example : example_systems())
  {
    SCOPED_TRACE(example.name);
    const TypeParam mesh = to_mesh<TypeParam>(example.soup); // a copy might have another order
    const SMF::Loop_system<TypeParam> system(mesh, poles_and_loops(example.items, mesh));
    expect_both_roads_agree(SMF::harmonic_foliation(system));
  }
}

TEST(Integrate_foliation, meets_descriptors_of_its_own_mesh_only)
{
  using Wrapper = Wrapped_mesh<Mesh::Point>; // asserts that
  using Edge = boost::graph_traits<Wrapper>::edge_descriptor;
  Mesh mesh = octahedron();
  Wrapper wrapper(mesh);
  const auto value = [&](const Edge& e) {
    return flat_equator().value(std::size_t(source(e.descriptor, mesh)),
                                std::size_t(target(e.descriptor, mesh)));
  };
  const auto foliation =
    SMF::integrate_foliation(wrapper, boost::make_function_property_map<Edge, double>(value));
  EXPECT_EQ(foliation.system().number_of_arcs(), 1u);
}

} // namespace test_integrate_foliation
