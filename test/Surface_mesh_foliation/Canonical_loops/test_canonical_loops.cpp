// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Canonical loops and the hierarchy they come from.

#include "generators/meshes.h"
#include "generators/openings.h"
#include "generators/revolution.h"

#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/canonical_loops.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/foliation_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/loop_modulus.h>
#include <CGAL/Surface_mesh_foliation/openings.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>

#include <boost/range/iterator_range.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace test_canonical_loops {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
namespace np = SMF::parameters;
using namespace smf_test;
using Input = SMF::Poles_and_loops<Mesh>;

Input poles(const std::vector<std::size_t>& vertices)
{
  Input result;
  for (const std::size_t v : vertices)
    result.add_pole(vertex(v));
  return result;
}

std::vector<double> moduli(const SMF::Loop_hierarchy<Mesh>& hierarchy)
{
  std::vector<double> result;
  for (const auto& loop : hierarchy.loops())
    result.push_back(loop.modulus);
  return result;
}

// with all loops of a hierarchy
SMF::Loop_system<Mesh> full_system(const Mesh& mesh,
                                   Input input,
                                   const SMF::Loop_hierarchy<Mesh>& hierarchy)
{
  for (const auto& loop : hierarchy.loops())
    input.add_loop(loop.loop);
  return SMF::Loop_system<Mesh>(mesh, input); // which throws if they meet or are homotopic
}

} // namespace

TEST(Canonical_loops, of_a_capsule)
{
  const auto [soup, ends] = soups::capsule(3, 48);
  const Mesh mesh = to_mesh(soup);
  Input input = poles({ends[0], ends[1], ends[2], ends[3]});
  const SMF::Loop_hierarchy<Mesh> hierarchy = SMF::loop_hierarchy(mesh, input);
  ASSERT_EQ(hierarchy.loops().size(), 1u);
  const SMF::Canonical_loop<Mesh>& loop = hierarchy.loops()[0];
  EXPECT_TRUE(loop.is_separating);
  EXPECT_FALSE(loop.cuts_handle);
  EXPECT_EQ(loop.parent, -1);
  EXPECT_GE(loop.dominance, 4 * loop.modulus * loop.modulus * (1 - 1e-6));
  EXPECT_DOUBLE_EQ(loop.margin(0.5), std::min(loop.modulus / 0.5, std::sqrt(loop.dominance)));
  EXPECT_DOUBLE_EQ(hierarchy.completeness_bound(), 1 / (4 * loop.modulus));
  EXPECT_TRUE(loop.is_near_bound(loop.modulus * 1.1));
  EXPECT_FALSE(loop.is_near_bound(loop.modulus * 1.3));
  EXPECT_FALSE(loop.is_near_bound(std::numeric_limits<double>::infinity()));
  EXPECT_EQ(SMF::canonical_loops(mesh, input).size(), 1u);
  EXPECT_EQ(input.size(), 5u);
  EXPECT_NEAR(SMF::loop_modulus(mesh, input, 4), loop.modulus, 1e-6);
  SMF::Reeb_graph<Kernel::Point_3> graph;
  SMF::foliation_reeb_graph(mesh, input, graph);
  EXPECT_EQ(num_vertices(graph), 6u);
  EXPECT_EQ(num_edges(graph), 5u);
  Input none = poles({ends[0], ends[1], ends[2], ends[3]});
  EXPECT_TRUE(SMF::canonical_loops(mesh, none, np::min_modulus(2 * loop.modulus)).empty());
  EXPECT_THROW(SMF::canonical_loops(mesh, none, np::min_modulus(-1.)),
               SMF::Invalid_parameter_exception);
  EXPECT_THROW(SMF::loop_hierarchy(mesh, none, np::number_of_proxy_vertices(10)),
               SMF::Invalid_parameter_exception);
  EXPECT_THROW(SMF::loop_hierarchy(mesh, input), SMF::Invalid_loops_exception); // has a loop
}

// Of a pole set without an essential loop, nothing is asked.
TEST(Canonical_loops, there_are_none_with_three_poles_on_a_sphere)
{
  const Mesh mesh = icosphere(3);
  for (const std::vector<std::size_t>& some :
       {std::vector<std::size_t>{0, 1}, std::vector<std::size_t>{0, 1, 2}})
  {
    Input input = poles(some);
    const SMF::Loop_hierarchy<Mesh> hierarchy = SMF::loop_hierarchy(mesh, input);
    EXPECT_TRUE(hierarchy.loops().empty());
    EXPECT_EQ(hierarchy.completeness_bound(), 0); // there are no other classes at all
    EXPECT_TRUE(SMF::canonical_loops(mesh, input).empty());
  }
}

// Loops are disjoint, in different classes, and cut the surface into pairs of pants.
TEST(Loop_hierarchy, is_a_pants_decomposition)
{
  for (std::uint64_t seed = 1; seed <= 12; ++seed)
  {
    SCOPED_TRACE(seed);
    const std::size_t g = seed % 4;
    const Mesh mesh = noisy(genus_surface(g, 3, seed), 0.1, seed);
    const Input input = seed % 3 == 0 && g > 0 ? Input() : poles({0, 11, 22, 33, 44});
    const SMF::Loop_hierarchy<Mesh> hierarchy = SMF::loop_hierarchy(mesh, input);
    const std::size_t p = input.size();
    EXPECT_EQ(hierarchy.loops().size(), g == 1 && p == 0 ? 1 : 3 * g + p - 3);
    EXPECT_TRUE(hierarchy.is_complete());
    const std::vector<double> all = moduli(hierarchy);
    EXPECT_TRUE(std::is_sorted(all.rbegin(), all.rend()));
    const SMF::Loop_system<Mesh> system = full_system(mesh, input, hierarchy);
    for (std::size_t node = 0; node < system.number_of_nodes(); ++node)
      EXPECT_EQ(system.genus(node), 0u);
    const auto number_of_cuts = std::count_if(hierarchy.loops().begin(), hierarchy.loops().end(),
                                              [](const auto& loop) { return loop.cuts_handle; });
    EXPECT_EQ(static_cast<std::size_t>(number_of_cuts), g);
    for (std::size_t i = 0; i < hierarchy.loops().size(); ++i)
    {
      const auto& loop = hierarchy.loops()[i];
      EXPECT_LT(loop.parent, static_cast<std::ptrdiff_t>(i));
      EXPECT_GE(loop.parent, -1);
      if (loop.cuts_handle)
      {
        EXPECT_FALSE(loop.is_separating);
      }
    }
    // with the loops that cut handles alone, all handles show
    for (const double detail : {0., 0.6, std::numeric_limits<double>::infinity()})
    {
      Input shown = input;
      SMF::canonical_loops(mesh, shown, np::min_modulus(detail));
      if (shown.size() == 0)
        continue;
      const SMF::Loop_system<Mesh> few(mesh, shown);
      for (std::size_t node = 0; node < few.number_of_nodes(); ++node)
        EXPECT_EQ(few.genus(node), 0u);
    }
  }
}

TEST(Loop_hierarchy, does_not_depend_on_the_order_of_vertices)
{
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
  {
    SCOPED_TRACE(seed);
    const Mesh mesh = noisy(genus_surface(seed % 3, 3, seed), 0.1, seed);
    const std::vector<std::size_t> some = {0, 11, 22, 33, 44};
    const std::vector<double> expected = moduli(SMF::loop_hierarchy(mesh, poles(some)));
    const std::vector<std::size_t> label = new_labels(num_vertices(mesh), seed);
    std::vector<std::size_t> others;
    for (const std::size_t v : some)
      others.push_back(label[v]);
    std::rotate(others.begin(), others.begin() + 2, others.end());
    const std::vector<double> found =
      moduli(SMF::loop_hierarchy(relabeled(mesh, seed), poles(others)));
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_NEAR(found[i], expected[i], 1e-3 * expected[i]) << i;
  }
}

// The loops are found on a coarser mesh, and carried to the mesh itself.
TEST(Loop_hierarchy, of_a_large_mesh_is_that_of_a_coarser_one)
{
  const auto [soup, ends] = soups::capsule(4, 128);
  const Mesh mesh = to_mesh(soup);
  EXPECT_GT(num_vertices(mesh), 15000u);
  const Input input = poles({ends[0], ends[1], ends[2], ends[3]});
  const SMF::Loop_hierarchy<Mesh> coarse =
    SMF::loop_hierarchy(mesh, input, np::number_of_proxy_vertices(2000));
  ASSERT_EQ(coarse.loops().size(), 1u);
  full_system(mesh, input, coarse);
  const SMF::Loop_hierarchy<Mesh> fine =
    SMF::loop_hierarchy(mesh, input, np::number_of_proxy_vertices(100000));
  EXPECT_NEAR(coarse.loops()[0].modulus / fine.loops()[0].modulus, 1, 0.05);
}

// Openings are punctures like poles.
TEST(Canonical_loops, of_tubes_with_openings)
{
  // a tube with an opening at each end and a pole beside each: one loop between the pairs
  std::vector<soups::Profile_point> profile;
  for (int i = 0; i <= 60; ++i)
    profile.push_back({0.1 * i, 1});
  constexpr std::size_t n = 60;
  const Mesh mesh = to_open_mesh(soups::tube_of_revolution(profile, n));
  Input input;
  EXPECT_EQ(SMF::add_border_poles(mesh, input), 2u);
  input.add_pole(vertex(5 * n));
  input.add_pole(vertex(55 * n));
  const std::vector<SMF::Canonical_loop<Mesh>> loops = SMF::canonical_loops(mesh, input);
  ASSERT_EQ(loops.size(), 1u);
  // at least the cylinder between the poles, of length 5 and circumference 2 pi
  EXPECT_GT(loops[0].modulus, 0.98 * 5 / (2 * 3.14159265358979));
  SMF::Reeb_graph<Kernel::Point_3> graph;
  SMF::foliation_reeb_graph(mesh, input, graph);
  std::vector<std::size_t> degrees;
  for (const auto v : boost::make_iterator_range(vertices(graph)))
    degrees.push_back(degree(v, graph));
  std::sort(degrees.begin(), degrees.end());
  EXPECT_EQ(degrees, (std::vector<std::size_t>{1, 1, 1, 1, 3, 3}));
}

} // namespace test_canonical_loops
