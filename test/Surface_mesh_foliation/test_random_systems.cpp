// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Random loop systems on random meshes: each must converge to a certified foliation, and to the
// same foliation when the vertices are numbered in another order.
//
// Prints the seed of every failure; `test_random_systems --seed=S --systems=N` runs others.

#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>

#include "include/random_systems.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using namespace smf_test;

namespace {

std::uint64_t first_seed = 1;
int number_of_systems = 1000;

struct Summary
{
  int seeds = 0, systems = 0, with_handles = 0, with_lines = 0, with_sets = 0, without_pole = 0;
  std::size_t iterations = 0, most_iterations = 0;
  double largest_difference = 0;
};

void count(const std::vector<Wish>& wishes, Summary& summary)
{
  const auto has = [&](Wish::Kind kind) {
    return std::any_of(wishes.begin(), wishes.end(), [&](const Wish& w) { return w.kind == kind; });
  };
  ++summary.systems;
  summary.with_handles += has(Wish::CYCLE);
  summary.with_lines += has(Wish::LINE_POLE);
  summary.with_sets += has(Wish::SET);
  summary.without_pole += !has(Wish::POLE) && !has(Wish::LINE_POLE);
}

void count(const SMF::Foliation_statistics& statistics, Summary& summary)
{
  summary.iterations += statistics.number_of_iterations;
  summary.most_iterations = std::max(summary.most_iterations, statistics.number_of_iterations);
}

// the largest difference of edge values to those on the mesh with other vertex numbers, divided by
// the largest edge value
double difference_after_relabelling(const Mesh& mesh,
                                    const std::vector<Wish>& wishes,
                                    const SMF::Measured_foliation<Mesh>& foliation,
                                    std::uint64_t seed)
{
  const std::vector<std::size_t> label = new_labels(num_vertices(mesh), seed);
  const Mesh other = relabelled(mesh, seed);
  const SMF::Loop_system<Mesh> system(other, granted(wishes, other, label));
  const SMF::Measured_foliation<Mesh> other_foliation = SMF::harmonic_foliation(system);
  const auto image = [&](Vertex v) { return Vertex(static_cast<Mesh::size_type>(label[v])); };
  double largest = 0, difference = 0;
  for (const auto e : edges(mesh))
  {
    const auto h = halfedge(image(source(halfedge(e, mesh), mesh)),
                            image(target(halfedge(e, mesh), mesh)), other);
    const double value = foliation.edge_value(e);
    largest = std::max(largest, value);
    difference =
      std::max(difference, std::abs(value - other_foliation.edge_value(edge(h.first, other))));
  }
  return difference / largest;
}

// A solver that may not finish still returns a certified foliation, whose energy is not below the
// least.
void expect_certified_wherever_stopped(const SMF::Loop_system<Mesh>& system)
{
  const double least_energy = SMF::harmonic_foliation(system).statistics().energy;
  for (int iterations : {0, 1, 2, 3, 5})
  {
    const SMF::Foliation_statistics statistics =
      SMF::harmonic_foliation(system, CGAL::parameters::number_of_iterations(iterations))
        .statistics();
    EXPECT_TRUE(statistics.is_certified);
    EXPECT_GE(statistics.energy, least_energy * (1 - 1e-9));
  }
}

void run(std::uint64_t seed, Summary& summary)
{
  ++summary.seeds;
  Random random(seed);
  const Mesh mesh = random_mesh(random);
  const std::vector<Wish> wishes = Random_wishes(mesh, random)();
  if (wishes.empty())
    return;
  count(wishes, summary); // also if an exception follows
  SCOPED_TRACE("seed " + std::to_string(seed) + ": " + to_string(wishes));
  try
  {
    const SMF::Loop_system<Mesh> system(mesh, granted(wishes, mesh));
    const SMF::Measured_foliation<Mesh> foliation = SMF::harmonic_foliation(system);
    const SMF::Foliation_statistics& statistics = foliation.statistics();
    count(statistics, summary);
    EXPECT_TRUE(statistics.has_converged);
    EXPECT_TRUE(statistics.is_certified);
    double energy = 0; // of the components: height times flux
    for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
      energy += system.height(a) * foliation.flux(a);
    EXPECT_NEAR(energy / statistics.energy, 1, 1e-9);
    if (seed % 4 == 1)
      expect_certified_wherever_stopped(system);
    if (seed % 4 == 0)
    {
      const double difference = difference_after_relabelling(mesh, wishes, foliation, seed);
      EXPECT_LT(difference, 1e-9);
      summary.largest_difference = std::max(summary.largest_difference, difference);
    }
  }
  catch (const std::exception& exception)
  {
    ADD_FAILURE() << exception.what();
  }
}

} // namespace

TEST(Random_systems, all_converge_certified_and_independently_of_vertex_order)
{
  Summary summary;
  const int most_seeds = 2 * number_of_systems + 20; // for some seeds no system is found
  while (summary.systems < number_of_systems && summary.seeds < most_seeds)
    run(first_seed + static_cast<std::uint64_t>(summary.seeds), summary);
  std::cout << summary.seeds << " seeds from " << first_seed << ": " << summary.systems
            << " systems, " << summary.with_handles << " with handle loops, " << summary.with_lines
            << " with line poles, " << summary.with_sets << " with separating loops, "
            << summary.without_pole << " without pole; iterations "
            << static_cast<double>(summary.iterations) / summary.systems << " on average, "
            << summary.most_iterations << " at most; largest difference of edge values "
            << summary.largest_difference << std::endl;
  EXPECT_EQ(summary.systems, number_of_systems) << "too many seeds give no system";
  EXPECT_GT(summary.with_handles, 0);
  EXPECT_GT(summary.with_lines, 0);
  EXPECT_GT(summary.with_sets, 0);
  EXPECT_GT(summary.without_pole, 0);
}

int main(int argc, char* argv[])
{
  testing::InitGoogleTest(&argc, argv);
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if (argument.rfind("--seed=", 0) == 0)
      first_seed = std::strtoull(argument.c_str() + 7, nullptr, 10);
    else if (argument.rfind("--systems=", 0) == 0)
      number_of_systems = std::atoi(argument.c_str() + 10);
  }
  return RUN_ALL_TESTS();
}
