// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/brute_force_reeb_graph.h"
#include "include/random_functions.h"
#include "include/scalar_reeb_graphs.h"
#include "generators/meshes.h"
#include "include/test_models.h"
#include "generators/Random.h"
#include "generators/soups.h"

#include <CGAL/Surface_mesh_foliation/Critical_kind.h>
#include <CGAL/Surface_mesh_foliation/IO/read_triangle_mesh.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_of_function.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace test_reeb_graph_of_function {

// Reeb graphs of functions, compared with a tracer of all contours, and with graphs that are known.

namespace {

using smf_test::Brute_force_reeb_graph;
using smf_test::expect_simple_saddles;
using smf_test::for_each_function;
using smf_test::Mesh;
using smf_test::random_function;
using smf_test::reeb_graph;
using smf_test::Surface;
using smf_test::surfaces;
using smf_test::Triangle_soup;
namespace SMF = CGAL::Surface_mesh_foliation;
namespace smf_np = CGAL::Surface_mesh_foliation::parameters;

using Kind = SMF::Critical_kind;
using Result = smf_test::Numbered_reeb_graph;
using Values = std::vector<double>;

// ===  Against brute force

template <class Ends>
std::vector<std::array<std::size_t, 2>> sorted(Ends ends)
{
  std::sort(ends.begin(), ends.end());
  return ends;
}

void expect_equal_nodes(const Result& result, const Brute_force_reeb_graph& expected)
{
  ASSERT_EQ(result.nodes.size(), expected.nodes.size());
  std::set<std::size_t> vertices;
  for (const Result::Node& node : result.nodes)
  {
    vertices.insert(node.vertex);
    const Brute_force_reeb_graph::Node& other = expected.nodes.at(node.vertex);
    EXPECT_EQ(node.kind, other.contours_below == 0   ? Kind::MINIMUM
                         : other.contours_above == 0 ? Kind::MAXIMUM
                                                     : Kind::SADDLE);
    const std::size_t multiplicity = node.kind == Kind::SADDLE ? other.lower_wedges - 1 : 0;
    EXPECT_EQ(node.multiplicity, multiplicity);
    // the surface near the critical level has Euler characteristic -multiplicity
    const bool is_saddle = node.kind == Kind::SADDLE;
    EXPECT_EQ(2 * node.genus,
              is_saddle ? 2 + multiplicity - other.contours_below - other.contours_above : 0);
  }
  EXPECT_EQ(vertices.size(), result.nodes.size());
}

// Arcs have the same ends, and the same vertices lie on them.
void expect_equal_arcs(const Result& result, const Brute_force_reeb_graph& expected)
{
  std::vector<std::array<std::size_t, 2>> ends;
  for (std::size_t a = 0; a < result.arcs.size(); ++a)
    ends.push_back(result.ends(a));
  EXPECT_EQ(sorted(ends), sorted(expected.arcs));
  std::map<std::size_t, std::size_t> arc_of_arc;
  std::vector<std::size_t> sizes(result.arcs.size(), 0);
  for (const auto& [v, arc] : expected.arc_of_vertex)
  {
    const std::size_t found = result.arc_of_vertex[v];
    ++sizes[found];
    EXPECT_EQ(arc_of_arc.emplace(arc, found).first->second, found);
    EXPECT_EQ(result.ends(found), expected.arcs[arc]);
  }
  std::set<std::size_t> images;
  for (const auto& entry : arc_of_arc)
    EXPECT_TRUE(images.insert(entry.second).second);
  for (std::size_t a = 0; a < sizes.size(); ++a)
    EXPECT_EQ(sizes[a], result.arcs[a].number_of_vertices);
  for (const Result::Node& node : result.nodes)
  {
    const auto [lower, upper] = result.ends(result.arc_of_vertex[node.vertex]);
    EXPECT_TRUE(lower == node.vertex || upper == node.vertex);
  }
}

TEST(Reeb_graph_of_function, is_that_of_all_contours)
{
  std::size_t number_of_hidden_handles = 0, number_of_multiple_saddles = 0;
  for_each_function(400, [&](const Surface& surface, const Values& values) {
    const Brute_force_reeb_graph expected(surface.soup, surface.edges, values);
    const Result result = reeb_graph(surface.mesh, values, smf_np::unfold_saddles(false));
    expect_equal_nodes(result, expected);
    expect_equal_arcs(result, expected);
    std::size_t genus = result.number_of_cycles();
    for (const Result::Node& node : result.nodes)
    {
      genus += node.genus;
      number_of_hidden_handles += node.genus;
      number_of_multiple_saddles += node.multiplicity > 1;
    }
    EXPECT_EQ(genus, surface.genus);
  });
  EXPECT_GT(number_of_hidden_handles, 100u) << "the test has the cases that it is meant to have";
  EXPECT_GT(number_of_multiple_saddles, 1000u);
}

TEST(Reeb_graph_of_function, with_unfolded_saddles_has_as_many_cycles_as_the_genus)
{
  for_each_function(400, [&](const Surface& surface, const Values& values) {
    const Result result = reeb_graph(surface.mesh, values);
    EXPECT_EQ(result.number_of_cycles(), surface.genus);
    expect_simple_saddles(result);
    // without the arcs inside vertices it is the other one
    const Result folded = reeb_graph(surface.mesh, values, smf_np::unfold_saddles(false));
    std::vector<std::array<std::size_t, 2>> ends, folded_ends;
    for (std::size_t a = 0; a < result.arcs.size(); ++a)
      if (result.ends(a)[0] != result.ends(a)[1])
        ends.push_back(result.ends(a));
    for (std::size_t a = 0; a < folded.arcs.size(); ++a)
      folded_ends.push_back(folded.ends(a));
    EXPECT_EQ(sorted(ends), sorted(folded_ends));
    for (std::size_t v = 0; v < values.size(); ++v)
      EXPECT_EQ(result.ends(result.arc_of_vertex[v]), folded.ends(folded.arc_of_vertex[v]));
  });
}

TEST(Reeb_graph_of_function, of_shared_meshes_has_as_many_cycles_as_the_genus)
{
  const std::string shared = SMF_SHARED_DIR;
  const auto files = smf_test::all_shared_meshes(shared.empty() ? shared : shared + "/meshes");
  if (files.empty())
    GTEST_SKIP() << "there are no shared meshes";
  for (const std::string& file : files)
  {
    SCOPED_TRACE(file);
    Mesh mesh;
    SMF::read_triangle_mesh(file, mesh);
    const std::size_t genus = smf_test::genus(mesh);
    smf_test::Random random(3);
    for (const int axis : {0, 1, 2, 3})
    {
      Values values;
      for (const auto v : vertices(mesh))
        values.push_back(axis < 3 ? mesh.point(v)[axis] : random.between(0, 1));
      const Result result = reeb_graph(mesh, values);
      EXPECT_EQ(result.number_of_cycles(), genus);
      expect_simple_saddles(result);
    }
  }
}

// ===  Known graphs

TEST(Reeb_graph_of_function, of_the_height_of_a_lying_torus)
{
  const std::size_t m = 24, n = 12;
  const Mesh mesh = smf_test::torus(m, n, 3, 1);
  Values values;
  for (const auto v : vertices(mesh))
    values.push_back(mesh.point(v).x());
  const Result result = reeb_graph(mesh, values);
  ASSERT_EQ(result.nodes.size(), 4u);
  EXPECT_EQ(result.nodes[0].kind, Kind::MINIMUM);
  EXPECT_EQ(result.nodes[1].kind, Kind::SADDLE);
  EXPECT_EQ(result.nodes[2].kind, Kind::SADDLE);
  EXPECT_EQ(result.nodes[3].kind, Kind::MAXIMUM);
  ASSERT_EQ(result.arcs.size(), 4u);
  std::size_t number_of_vertices = 4;
  for (const Result::Arc& arc : result.arcs)
  {
    EXPECT_EQ(arc.upper, arc.lower == 0 ? 1u : arc.lower == 1 ? 2u : 3u);
    number_of_vertices += arc.number_of_vertices;
  }
  EXPECT_EQ(number_of_vertices, m * n);
}

// A torus of seven vertices, all adjacent to each other: every order of the vertices has just one
// minimum and one maximum.
TEST(Reeb_graph_of_function, of_a_torus_with_a_saddle_that_hides_the_handle)
{
  Triangle_soup soup;
  for (std::size_t i = 0; i < 7; ++i)
  {
    soup.points.push_back({std::cos(double(i)), std::sin(double(i)), double(i * i)});
    soup.triangles.push_back({i, (i + 1) % 7, (i + 3) % 7});
    soup.triangles.push_back({i, (i + 3) % 7, (i + 2) % 7});
  }
  const Mesh mesh = smf_test::to_mesh(soup);
  bool has_hidden_handle = false;
  std::vector<double> values = {0, 1, 2, 3, 4, 5, 6};
  do
  {
    EXPECT_EQ(reeb_graph(mesh, values).number_of_cycles(), 1u);
    const Result folded = reeb_graph(mesh, values, smf_np::unfold_saddles(false));
    if (folded.nodes.size() == 3)
    {
      EXPECT_EQ(folded.nodes[1].multiplicity, 2u);
      EXPECT_EQ(folded.nodes[1].genus, 1u);
      EXPECT_EQ(folded.arcs.size(), 2u);
      has_hidden_handle = true;
    }
    else
      EXPECT_EQ(folded.number_of_cycles(), 1u);
  } while (std::next_permutation(values.begin() + 1, values.end()));
  EXPECT_TRUE(has_hidden_handle);
}

// a double pyramid over a polygon with 2m corners, alternately high and low
TEST(Reeb_graph_of_function, of_a_saddle_of_high_multiplicity)
{
  const std::size_t m = 50;
  Triangle_soup soup;
  for (std::size_t i = 0; i < 2 * m; ++i)
  {
    const double angle = 3.14159265358979 * static_cast<double>(i) / static_cast<double>(m);
    soup.points.push_back({std::cos(angle), std::sin(angle), 0});
    soup.triangles.push_back({i, (i + 1) % (2 * m), 2 * m});
    soup.triangles.push_back({(i + 1) % (2 * m), i, 2 * m + 1});
  }
  soup.points.push_back({0, 0, 1});
  soup.points.push_back({0, 0, -1});
  const Mesh mesh = smf_test::to_mesh(soup);
  Values values;
  for (std::size_t i = 0; i < 2 * m; ++i)
    values.push_back(i % 2 == 0 ? 1 : -1);
  values.push_back(0);
  values.push_back(-2);
  const Result result = reeb_graph(mesh, values, smf_np::unfold_saddles(false));
  ASSERT_EQ(result.nodes.size(), m + 2); // all low corners are regular
  EXPECT_EQ(result.nodes[1].kind, Kind::SADDLE);
  EXPECT_EQ(result.nodes[1].multiplicity, m - 1);
  EXPECT_EQ(reeb_graph(mesh, values).nodes.size(), m + 1 + m - 1);
}

// ===  Order of vertices

using Description = std::vector<std::vector<double>>;

// what does not depend on numbers
Description description(const Result& result, const Values& values)
{
  Description lines;
  for (const Result::Node& node : result.nodes)
    lines.push_back({values[node.vertex], static_cast<double>(node.kind),
                     static_cast<double>(node.multiplicity), static_cast<double>(node.genus)});
  for (std::size_t a = 0; a < result.arcs.size(); ++a)
    lines.push_back({static_cast<double>(result.arcs[a].lower),
                     static_cast<double>(result.arcs[a].upper),
                     static_cast<double>(result.arcs[a].number_of_vertices)});
  for (std::size_t v = 0; v < values.size(); ++v)
    lines.push_back({values[v], static_cast<double>(result.arcs[result.arc_of_vertex[v]].lower),
                     static_cast<double>(result.arcs[result.arc_of_vertex[v]].upper), 0, 0});
  std::sort(lines.begin(), lines.end());
  return lines;
}

TEST(Reeb_graph_of_function, does_not_depend_on_the_order_of_vertices_if_there_are_no_ties)
{
  smf_test::Random random(8);
  for (const Surface& surface : surfaces())
    for (std::uint64_t seed = 0; seed < 20; ++seed)
    {
      const Values values = random_function(surface, 0, random);
      const std::vector<std::size_t> labels = smf_test::new_labels(values.size(), seed);
      Values new_values(values.size());
      for (std::size_t v = 0; v < values.size(); ++v)
        new_values[labels[v]] = values[v];
      const Mesh mesh = smf_test::relabeled(surface.mesh, seed);
      for (const double persistence : {0., 0.3})
      {
        const auto np = smf_np::persistence(persistence);
        EXPECT_EQ(description(reeb_graph(mesh, new_values, np), new_values),
                  description(reeb_graph(surface.mesh, values, np), values));
      }
    }
}

// ===  Models

template <class TriangleMesh>
class Reeb_graph_of_function_models : public ::testing::Test
{};

using Models = ::testing::Types<smf_test::Surface_mesh_model<smf_test::Kernel>,
                                smf_test::Polyhedron_model<smf_test::Kernel>,
                                smf_test::Linear_cell_complex_model<smf_test::Kernel>>;
TYPED_TEST_SUITE(Reeb_graph_of_function_models, Models);

TYPED_TEST(Reeb_graph_of_function_models, give_equal_results)
{
  smf_test::Random random(4);
  for (const Surface& surface : surfaces())
  {
    const TypeParam mesh = smf_test::to_mesh<TypeParam>(surface.soup);
    const Values values = random_function(surface, 1, random);
    EXPECT_EQ(description(reeb_graph(mesh, values), values),
              description(reeb_graph(surface.mesh, values), values));
  }
}

TEST(Reeb_graph_of_function, of_a_mesh_with_removed_elements)
{
  Mesh mesh = smf_test::tetrahedron();
  const auto second = smf_test::torus(7, 5, 3, 1);
  mesh += second;
  const auto first_faces =
    std::vector<Mesh::Face_index>(faces(mesh).begin(), faces(mesh).begin() + 4);
  for (const auto f : first_faces)
    CGAL::Euler::remove_face(halfedge(f, mesh), mesh);
  Values values;
  for (const auto v : vertices(second))
    values.push_back(second.point(v).x());
  EXPECT_EQ(description(reeb_graph(mesh, values), values),
            description(reeb_graph(second, values), values));
}

// ===  Other graphs, other values

TEST(Reeb_graph_of_function, goes_to_property_maps)
{
  using Graph = boost::adjacency_list<boost::listS, boost::vecS, boost::bidirectionalS>;
  const Mesh mesh = smf_test::torus(7, 5, 3, 1);
  std::map<Mesh::Vertex_index, int> function;
  for (const auto v : vertices(mesh))
    function[v] = static_cast<int>(v) % 4;
  Graph graph(3); // is appended to
  std::map<Graph::vertex_descriptor, SMF::Scalar_reeb_node<Mesh>> nodes;
  std::map<Graph::edge_descriptor, SMF::Scalar_reeb_arc> arcs;
  SMF::reeb_graph_of_function(
    mesh, boost::make_assoc_property_map(function), graph,
    smf_np::combine(smf_np::node_map(boost::make_assoc_property_map(nodes)),
                    smf_np::arc_map(boost::make_assoc_property_map(arcs))));
  EXPECT_EQ(num_vertices(graph), nodes.size() + 3);
  EXPECT_EQ(num_edges(graph), arcs.size());
  EXPECT_EQ(arcs.size(), nodes.size());
  for (const auto& [arc, properties] : arcs)
  {
    EXPECT_EQ(properties.lower, nodes.at(source(arc, graph)).value);
    EXPECT_EQ(properties.upper, nodes.at(target(arc, graph)).value);
    EXPECT_LE(properties.lower, properties.upper);
  }
}

TEST(Reeb_graph_of_function, of_extreme_values)
{
  const Mesh mesh = smf_test::torus(7, 5, 3, 1);
  Values values;
  for (const auto v : vertices(mesh))
    values.push_back(mesh.point(v).x() / 4);
  const Description expected = description(reeb_graph(mesh, values), values);
  for (const double scale : {5e-300, 1.7e308})
  {
    Values scaled = values;
    for (double& value : scaled)
      value *= scale;
    Description found = description(reeb_graph(mesh, scaled), scaled);
    EXPECT_EQ(found.size(), expected.size());
    EXPECT_EQ(reeb_graph(mesh, scaled, smf_np::persistence(1.)).number_of_cycles(), 1u);
  }
}

TEST(Reeb_graph_of_function, does_not_look_at_the_positions_of_vertices)
{
  Mesh mesh = smf_test::torus(7, 5, 3, 1);
  Values values;
  for (const auto v : vertices(mesh))
    values.push_back(mesh.point(v).x());
  const Description expected = description(reeb_graph(mesh, values), values);
  for (const auto v : vertices(mesh))
    mesh.point(v) = CGAL::ORIGIN;
  EXPECT_EQ(description(reeb_graph(mesh, values), values), expected);
}

} // namespace

} // namespace test_reeb_graph_of_function
