// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Foliations of meshes with vertices that nearly coincide. Fuzzers found that solvers failed.

#include "generators/Random.h"
#include "include/example_systems.h"
#include "include/tiny_edges.h"

#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace test_tiny_edges {

namespace {

using smf_test::Example;
using smf_test::Item;
using smf_test::Mesh;
using smf_test::Random;
namespace SMF = CGAL::Surface_mesh_foliation;
namespace soups = smf_test::soups;

using System = SMF::Loop_system<Mesh>;

void expect_foliation(const System& system)
{
  const SMF::Foliation_statistics statistics = SMF::harmonic_foliation(system).statistics();
  EXPECT_TRUE(statistics.is_certified);
  EXPECT_TRUE(statistics.has_converged) << statistics.optimality;
}

} // namespace

TEST(Tiny_edges, of_any_size_do_no_harm)
{
  std::size_t count = 0;
  for (const Example& example : smf_test::all_example_systems())
    for (std::size_t a = 0; a < example.soup.points.size(); a += 1 + example.soup.points.size() / 8)
      for (const double part : {1e-12, 1e-18, 1e-40})
      {
        SCOPED_TRACE(example.name);
        smf_test::Triangle_soup soup = example.soup;
        for (auto& p : soup.points) // so that there are numbers near those of vertex a
          p = soups::sum(p, example.soup.points[a], -1);
        Mesh mesh = smf_test::to_mesh(soup);
        smf_test::add_vertex_beside_target(mesh, halfedge(smf_test::vertex(a), mesh), part);
        std::optional<System> system;
        try
        {
          system.emplace(mesh, smf_test::poles_and_loops(example.items, mesh));
        }
        catch (const SMF::Invalid_loops_exception&)
        {
          continue; // the edge that was split is one of a loop
        }
        expect_foliation(*system);
        ++count;
      }
  EXPECT_GT(count, 150u);
}

// Vertices that are held together by large weights, on a surface that is a million times as long as
// wide.
TEST(Tiny_edges, on_long_surfaces_do_no_harm)
{
  constexpr std::size_t m = 7, n = 5;
  std::size_t count = 0;
  for (std::size_t seed = 0; seed < 600; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    smf_test::Triangle_soup soup = soups::torus(m, n, 3, 1);
    for (auto& p : soup.points)
      p[2] *= 1e6;
    Mesh mesh = smf_test::to_mesh(soup);
    for (int i = 0; i < 3; ++i)
      smf_test::add_vertex_beside_target(
        mesh, Mesh::Halfedge_index(static_cast<Mesh::size_type>(random.index(num_halfedges(mesh)))),
        1e-12);
    std::vector<Item> items = {{Item::CYCLE, random.index(2) == 0
                                               ? smf_test::meridian(random.index(m), n)
                                               : smf_test::longitude(random.index(n), m, n)}};
    for (int i = 0; i < 2; ++i)
      items.push_back({Item::POLE, {random.index(num_vertices(mesh))}, random.between(0.5, 2)});
    std::optional<System> system;
    try
    {
      system.emplace(mesh, smf_test::poles_and_loops(items, mesh));
    }
    catch (const SMF::Foliation_exception&)
    {
      continue; // an edge that was split is one of the loop, or twice, or a pole is on the loop
    }
    expect_foliation(*system);
    ++count;
  }
  EXPECT_GT(count, 200u);
}

} // namespace test_tiny_edges
