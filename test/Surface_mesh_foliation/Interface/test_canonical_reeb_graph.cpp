// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// From nothing but a mesh to its graph, in one call, which gives what the functions for each stage
// give.

#include "generators/meshes.h"
#include "generators/openings.h"
#include "generators/revolution.h"

#include <CGAL/Surface_mesh_foliation/add_missing_poles.h>
#include <CGAL/Surface_mesh_foliation/canonical_loops.h>
#include <CGAL/Surface_mesh_foliation/canonical_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/feature_poles.h>
#include <CGAL/Surface_mesh_foliation/foliation_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/openings.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>

#include <CGAL/Polyhedron_3.h>

#include <boost/range/iterator_range.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <vector>

namespace test_canonical_reeb_graph {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
namespace np = SMF::parameters;
using namespace smf_test;
using Graph = SMF::Reeb_graph<Kernel::Point_3>;

std::vector<std::size_t> degrees(const Graph& graph)
{
  std::vector<std::size_t> result;
  for (const auto v : boost::make_iterator_range(vertices(graph)))
    result.push_back(degree(v, graph));
  std::sort(result.begin(), result.end());
  return result;
}

template <class TriangleMesh>
std::vector<std::size_t> degrees_in_one_call(const TriangleMesh& mesh)
{
  Graph graph;
  const auto foliation = SMF::canonical_reeb_graph(mesh, graph);
  EXPECT_TRUE(foliation.statistics().has_converged);
  EXPECT_TRUE(foliation.statistics().is_certified);
  return degrees(graph);
}

std::vector<std::size_t> degrees_stage_by_stage(const Mesh& mesh)
{
  SMF::Poles_and_loops<Mesh> input;
  SMF::add_border_poles(mesh, input);
  std::vector<Mesh::Vertex_index> poles;
  SMF::detect_feature_poles(mesh, std::back_inserter(poles));
  for (const auto v : poles)
    input.add_pole(v);
  SMF::add_missing_poles(mesh, input);
  SMF::canonical_loops(mesh, input);
  Graph graph;
  SMF::foliation_reeb_graph(mesh, input, graph);
  return degrees(graph);
}

std::vector<Mesh> meshes()
{
  std::vector<Mesh> result = {icosphere(3),
                              to_mesh(soups::limbed_sphere(5, 4)),
                              to_mesh(soups::limbed_sphere(6, 5)), // larger than its proxy
                              torus(60, 30, 3, 1),
                              noisy(genus_surface(2, 4, 1), 0.1, 1),
                              to_mesh(soups::capsule(6, 40).first)};
  std::vector<soups::Profile_point> tube;
  for (int i = 0; i <= 40; ++i)
    tube.push_back({0.1 * i, 1});
  result.push_back(to_open_mesh(soups::tube_of_revolution(tube, 40)));
  result.push_back(to_open_mesh(soups::part_below(soups::icosphere(4), 2, 0.3)));
  return result;
}

} // namespace

TEST(Canonical_reeb_graph, is_that_of_the_stages)
{
  for (const Mesh& mesh : meshes())
    EXPECT_EQ(degrees_in_one_call(mesh), degrees_stage_by_stage(mesh)) << num_vertices(mesh);
}

TEST(Canonical_reeb_graph, of_meshes_without_integers)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  const Triangle_soup soup = soups::limbed_sphere(5, 4);
  EXPECT_EQ(degrees_in_one_call(to_mesh<Polyhedron>(soup)), degrees_in_one_call(to_mesh(soup)));
  EXPECT_EQ(degrees_in_one_call(to_mesh<Polyhedron>(soup)),
            (std::vector<std::size_t>{1, 1, 1, 1, 1, 5}));
}

// With a given detail, and the loops.
TEST(Canonical_reeb_graph, has_the_loops_that_are_told)
{
  const Mesh mesh = noisy(genus_surface(3, 4, 2), 0.1, 2);
  std::size_t last = 0;
  for (const double detail : {std::numeric_limits<double>::infinity(), 0.3, 0.})
  {
    std::vector<SMF::Canonical_loop<Mesh>> loops;
    Graph graph;
    const auto foliation = SMF::canonical_reeb_graph(
      mesh, graph,
      np::min_modulus(detail).canonical_loop_output_iterator(std::back_inserter(loops)));
    const auto& system = foliation.system();
    EXPECT_EQ(system.number_of_arcs(), system.number_of_poles() + loops.size());
    EXPECT_GE(loops.size(), 3u); // for the handles
    EXPECT_GE(loops.size(), last);
    last = loops.size();
    for (std::size_t i = 0; i < loops.size(); ++i)
    {
      EXPECT_EQ(system.loop(system.number_of_poles() + i).size(), loops[i].loop.size());
      EXPECT_TRUE(loops[i].modulus >= detail || loops[i].cuts_handle);
    }
  }
  Graph graph;
  EXPECT_THROW(SMF::canonical_reeb_graph(mesh, graph, np::min_modulus(-1.)),
               SMF::Invalid_parameter_exception);
  EXPECT_THROW(SMF::canonical_reeb_graph(mesh, graph, np::persistence(0.5)),
               SMF::Invalid_parameter_exception);
  EXPECT_THROW(SMF::canonical_reeb_graph(Mesh(), graph), SMF::Invalid_mesh_exception);
  EXPECT_EQ(num_vertices(graph), 0u);
}

TEST(Canonical_reeb_graph, with_few_poles_is_smaller)
{
  const Mesh mesh = to_mesh(soups::limbed_sphere(6, 4));
  for (const std::size_t number : {2, 3, 4})
  {
    Graph graph;
    SMF::canonical_reeb_graph(mesh, graph, np::number_of_poles(number));
    EXPECT_EQ(num_edges(graph), number == 2 ? 1 : number);
  }
}

} // namespace test_canonical_reeb_graph
