// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Random loop systems on random meshes, and on the shared ones: each must converge to a certified
// foliation, and to the same one when its fronts grow in a random order, and when the vertices are
// numbered in another order.
//
// The same on surfaces with openings, and, with both solvers, on meshes with flat faces.
//
// Prints the seed of every failure; `test_random_systems --seed=S --systems=N` runs others. The
// target ten_thousand_systems runs ten thousand, and two thousand with flat faces.

#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/forces.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/lengths.h>
#include <CGAL/Surface_mesh_foliation/whitehead_foliation.h>

#include <CGAL/Real_timer.h>

#include "include/flat_faces.h"
#include "include/random_systems.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_random_systems {

using namespace smf_test;

namespace {

std::uint64_t first_seed = 1;
int number_of_systems = 1000, number_of_open_systems = 200, number_of_flat_systems = 150;

struct Summary
{
  int seeds = 0, systems = 0, with_handles = 0, with_lines = 0, with_sets = 0, with_openings = 0,
      without_pole = 0, with_rings = 0, with_several_inner_nodes = 0, on_shared_meshes = 0;
  std::set<int> genera;
  std::vector<std::size_t> iterations, cold_iterations; // with and without coarse meshes
  std::size_t most_iterations = 0;
  std::uint64_t worst_seed = 0;
  double seconds = 0, largest_difference = 0;
};

void count(const std::vector<Item>& items, Summary& summary)
{
  const auto has = [&](Item::Kind kind) {
    return std::any_of(items.begin(), items.end(), [&](const Item& w) { return w.kind == kind; });
  };
  ++summary.systems;
  summary.with_handles += has(Item::CYCLE);
  summary.with_lines += has(Item::LINE_POLE);
  summary.with_sets += has(Item::SET);
  summary.with_openings += has(Item::BORDER);
  summary.without_pole += !has(Item::POLE) && !has(Item::LINE_POLE);
  summary.with_rings +=
    std::any_of(items.begin(), items.end(), [](const Item& w) { return w.rings > 0; });
}

void count(const SMF::Measured_foliation<Mesh>& foliation, std::uint64_t seed, Summary& summary)
{
  const std::size_t iterations = foliation.statistics().number_of_iterations;
  summary.iterations.push_back(iterations);
  if (iterations > summary.most_iterations)
  {
    summary.most_iterations = iterations;
    summary.worst_seed = seed;
  }
  const auto& flat = foliation.system().data().flat;
  summary.genera.insert(flat.mesh.genus());
  summary.with_several_inner_nodes +=
    std::count_if(flat.nodes.begin(), flat.nodes.end(),
                  [](const auto& node) { return node.pole < 0; }) > 1;
}

// a mesh of the shared folder for every fiftieth seed, of fifty thousand vertices for every
// thousandth
Mesh mesh_of(std::uint64_t seed, Random& random, Summary& summary)
{
  const std::string folder = SMF_SHARED_DIR;
  if (folder.empty() || seed % 50 != 49)
    return random_mesh(random);
  const std::vector<std::string> small = {"plate_2212", "wingnut_3047", "spot_829",
                                          "fish_945",   "torus_2304",   "skull_5154",
                                          "cat_7949",   "hand_7993",    "airplane_8730"};
  const std::vector<std::string> large = {"scorpion_49997", "skull_49999", "boot_19931"};
  const std::vector<std::string>& names = seed % 1000 == 999 ? large : small;
  Mesh result;
  SMF::read_triangle_mesh(folder + "/meshes/" + names[random.index(names.size())] + ".off", result);
  ++summary.on_shared_meshes;
  return result;
}

// Lets the fronts grow in a random order: of the vertices that see one direction any may be next.
void grow_fronts_at_random(SMF::internal::Foliation_state& state, Random& random)
{
  SMF::internal::Directions directions;
  std::vector<int> candidates(state.mesh().number_of_vertices());
  std::iota(candidates.begin(), candidates.end(), 0);
  while (!candidates.empty())
  {
    std::swap(candidates[random.index(candidates.size())], candidates.back());
    const int v = candidates.back();
    candidates.pop_back();
    if (state.is_fixed(v) || !state.is_at_node(v))
      continue;
    find_directions(state, v, directions);
    if (directions.size() != 1)
      continue;
    const auto letter = directions.letters[0];
    state.move_into_arc(v, letter, state.length_of_arc(letter) / 2);
    for (int h : state.mesh().ring(v))
      candidates.push_back(state.mesh().target(h));
  }
}

// the largest difference of edge values to those found from random fronts, divided by the largest
// edge value
double difference_with_other_fronts(const SMF::Measured_foliation<Mesh>& foliation,
                                    Random& random,
                                    Summary& summary)
{
  using namespace SMF::internal;
  const Flat_loop_system& flat = foliation.system().data().flat;
  Foliation_state state(flat, mean_value_weights(flat.mesh));
  grow_fronts_at_random(state, random);
  SMF::Supernodal_cholesky_solver linear_solver;
  const SMF::Foliation_statistics result = Newton_solver(state, linear_solver)(Solver_options());
  EXPECT_TRUE(result.has_converged);
  EXPECT_TRUE(certify(state, Extraction(state)).empty());
  summary.cold_iterations.push_back(result.number_of_iterations);
  double largest = 0, difference = 0;
  for (int e = 0; e < flat.mesh.number_of_edges(); ++e)
  {
    largest = std::max(largest, length_of_edge(state, e));
    difference = std::max(
      difference, std::abs(length_of_edge(state, e) - length_of_edge(foliation.state(), e)));
  }
  return difference / largest;
}

// the largest difference of edge values to those on the mesh with other vertex numbers, divided by
// the largest edge value
double difference_after_relabeling(const Mesh& mesh,
                                   const std::vector<Item>& items,
                                   const SMF::Measured_foliation<Mesh>& foliation,
                                   std::uint64_t seed)
{
  const std::vector<std::size_t> label = new_labels(num_vertices(mesh), seed);
  const Mesh other = relabeled(mesh, seed);
  const SMF::Loop_system<Mesh> system(other, poles_and_loops(relabeled_items(items, label), other));
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

// with one to six openings
Mesh open_mesh_of(std::uint64_t seed, Random& random, Summary& summary)
{
  const Mesh closed = mesh_of(seed, random, summary);
  return to_open_mesh(soups::with_random_openings(to_soup(closed), 1 + random.index(6), random));
}

void run(std::uint64_t seed, bool is_open, Summary& summary)
{
  ++summary.seeds;
  Random random(seed);
  const Mesh mesh = is_open ? open_mesh_of(seed, random, summary) : mesh_of(seed, random, summary);
  if (is_open && CGAL::is_closed(mesh)) // too small to be cut
    return;
  const std::vector<Item> items = Random_items(mesh, random)();
  if (items.empty())
    return;
  count(items, summary); // also if an exception follows
  SCOPED_TRACE("seed " + std::to_string(seed) + ": " + to_string(items));
  try
  {
    const SMF::Loop_system<Mesh> system(mesh, poles_and_loops(items, mesh));
    CGAL::Real_timer timer;
    timer.start();
    const SMF::Measured_foliation<Mesh> foliation = SMF::harmonic_foliation(system);
    summary.seconds += timer.time();
    const SMF::Foliation_statistics& statistics = foliation.statistics();
    count(foliation, seed, summary);
    EXPECT_TRUE(statistics.has_converged);
    EXPECT_TRUE(statistics.is_certified);
    double energy = 0; // of the components: height times flux
    for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
      energy += system.height(a) * foliation.flux(a);
    EXPECT_NEAR(energy / statistics.energy, 1, 1e-9);
    const auto expect_same = [&](double difference) {
      EXPECT_LT(difference, 1e-9);
      summary.largest_difference = std::max(summary.largest_difference, difference);
    };
    expect_same(difference_with_other_fronts(foliation, random, summary));
    if (seed % 4 == 1)
      expect_certified_wherever_stopped(system);
    if (seed % 4 == 0 && !is_open)
      expect_same(difference_after_relabeling(mesh, items, foliation, seed));
  }
  catch (const std::exception& exception)
  {
    ADD_FAILURE() << exception.what();
  }
}

// A system on a mesh with faces that are flat up to rounding, some of them at its poles and along
// its loops. Returns whether there is one.
bool run_with_flat_faces(std::uint64_t seed)
{
  Random random(seed);
  const Mesh base = random_mesh(random);
  const std::vector<Item> items = Random_items(base, random)();
  if (items.empty())
    return false;
  std::vector<std::size_t> vertices;
  for (const Item& item : items)
    vertices.insert(vertices.end(), item.vertices.begin(), item.vertices.end());
  Triangle_soup soup = to_soup(base);
  add_flat_faces(soup, vertices, random);
  if (!SMF::check_triangle_soup(soup).empty())
    return false; // a face is exactly degenerate
  const Mesh mesh = to_mesh(soup);
  Input input;
  try
  {
    input = poles_and_loops(items, mesh);
  }
  catch (const SMF::Invalid_loops_exception&)
  {
    return false; // a wide loop meets itself where new vertices divide a ring
  }
  if (!SMF::validate(mesh, input).empty())
    return false;
  SCOPED_TRACE("seed " + std::to_string(seed) + ": " + to_string(items));
  try
  {
    const SMF::Loop_system<Mesh> system(mesh, input);
    const SMF::Foliation_statistics newton = SMF::harmonic_foliation(system).statistics();
    EXPECT_TRUE(newton.has_converged) << newton.optimality;
    EXPECT_TRUE(newton.is_certified);
    const SMF::Foliation_statistics whitehead =
      SMF::whitehead_foliation(system,
                               SMF::parameters::over_relaxation(1.9).number_of_iterations(100))
        .statistics();
    EXPECT_TRUE(whitehead.is_certified);
    EXPECT_GE(whitehead.energy, newton.energy * (1 - 1e-9));
  }
  catch (const std::exception& exception)
  {
    ADD_FAILURE() << exception.what();
  }
  return true;
}

// the rare systems that need more than the usual number of iterations
std::ptrdiff_t number_above_six(const std::vector<std::size_t>& iterations)
{
  return std::count_if(iterations.begin(), iterations.end(), [](std::size_t i) { return i > 6; });
}

void print(const char* what, std::vector<std::size_t> iterations)
{
  std::sort(iterations.begin(), iterations.end());
  const double sum = std::accumulate(iterations.begin(), iterations.end(), 0.);
  std::cout << "iterations " << what << ": mean " << sum / static_cast<double>(iterations.size())
            << ", median " << iterations[iterations.size() / 2] << ", worst " << iterations.back()
            << ", more than six in " << number_above_six(iterations) << '\n';
}

} // namespace

Summary run_all(int number, bool is_open)
{
  Summary summary;
  const int most_seeds = 2 * number + 20; // for some seeds no system is found
  while (summary.systems < number && summary.seeds < most_seeds)
    run(first_seed + static_cast<std::uint64_t>(summary.seeds), is_open, summary);
  std::cout << summary.seeds << " seeds from " << first_seed << ": " << summary.systems
            << " systems, " << summary.with_handles << " with handle loops, " << summary.with_lines
            << " with line poles, " << summary.with_sets << " with separating loops, "
            << summary.with_openings << " with openings, " << summary.without_pole
            << " without pole, " << summary.with_rings << " with wide pole loops, "
            << summary.with_several_inner_nodes << " with several inner nodes, "
            << summary.on_shared_meshes << " on shared meshes; genera up to "
            << *summary.genera.rbegin() << '\n';
  print("as a user gets them", summary.iterations);
  print("from random fronts", summary.cold_iterations);
  std::cout << "worst seed " << summary.worst_seed << "; "
            << 1000 * summary.seconds / summary.systems
            << " ms a foliation; largest difference of edge values " << summary.largest_difference
            << std::endl;
  EXPECT_EQ(summary.systems, number) << "too many seeds give no system";
  EXPECT_GT(summary.with_handles, 0);
  EXPECT_GT(summary.with_lines, 0);
  EXPECT_GT(summary.with_sets, 0);
  EXPECT_GT(summary.with_rings, 0);
  EXPECT_GT(summary.with_several_inner_nodes, 0);
  return summary;
}

TEST(Random_systems, all_converge_certified_and_independently_of_vertex_order)
{
  const Summary summary = run_all(number_of_systems, false);
  EXPECT_LE(number_above_six(summary.iterations), number_of_systems / 1000);
  EXPECT_GT(summary.without_pole, 0);
}

TEST(Random_systems, with_openings_all_converge_certified)
{
  const Summary summary = run_all(number_of_open_systems, true);
  EXPECT_EQ(summary.with_openings, summary.systems);
}

TEST(Random_systems, with_flat_faces_all_converge_certified)
{
  int systems = 0, seeds = 0;
  for (; systems < number_of_flat_systems && seeds < 4 * number_of_flat_systems; ++seeds)
    systems += run_with_flat_faces(first_seed + static_cast<std::uint64_t>(seeds));
  std::cout << seeds << " seeds from " << first_seed << ": " << systems
            << " systems with flat faces" << std::endl;
  EXPECT_EQ(systems, number_of_flat_systems) << "too many seeds give no system";
}

} // namespace test_random_systems

int main(int argc, char* argv[])
{
  testing::InitGoogleTest(&argc, argv);
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if (argument.rfind("--seed=", 0) == 0)
      test_random_systems::first_seed = std::strtoull(argument.c_str() + 7, nullptr, 10);
    else if (argument.rfind("--systems=", 0) == 0)
    {
      const int number = std::atoi(argument.c_str() + 10);
      test_random_systems::number_of_systems = test_random_systems::number_of_open_systems = number;
      test_random_systems::number_of_flat_systems = number / 5; // which two solvers solve
    }
  }
  return RUN_ALL_TESTS();
}
