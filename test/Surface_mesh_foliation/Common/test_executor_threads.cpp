// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// All that runs block by block has no data races and gives the same bits, with threads made here: a
// thread sanitizer sees how they wait for each other, which it does not in TBB's library.

#include <CGAL/Surface_mesh_foliation/Supernodal_cholesky_solver.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/Arc_embedding.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/Executor.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/certify.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Newton_solver.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/start_from_coarse.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/weights_of_flat_mesh.h>

#include "include/flat_systems.h"
#include "generators/genus_soups.h"
#include "generators/soups.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstring>
#include <functional>
#include <thread>
#include <vector>

namespace test_executor_threads {

using namespace CGAL::Surface_mesh_foliation::internal;
using CGAL::Surface_mesh_foliation::Problem;
using CGAL::Surface_mesh_foliation::Supernodal_cholesky_solver;
using namespace smf_test;

namespace {

// takes the blocks from a counter
class Thread_executor : public Executor
{
public:
  explicit Thread_executor(int number_of_threads) : m_number_of_threads(number_of_threads) {}

  void operator()(int n, const Body& body, int size = default_size) const override
  {
    std::atomic<int> next(0);
    std::vector<std::thread> threads;
    for (int i = 0; i < m_number_of_threads; ++i)
      threads.emplace_back([&] {
        for (int block = next++; block < number_of_blocks(n, size); block = next++)
          run(n, body, size, block);
      });
    for (std::thread& thread : threads)
      thread.join();
  }

  void run_ahead(const std::function<void()>& ahead,
                 const std::function<void()>& main) const override
  {
    std::thread thread(ahead);
    main();
    thread.join();
  }

private:
  int m_number_of_threads;
};

// the numbers of a run from weights to embedding
std::vector<double> numbers(const Flat_loop_system& system, const Executor& executor)
{
  Foliation_state state(system, mean_value_weights(system.mesh, executor));
  state.set_executor(executor);
  Supernodal_cholesky_solver linear_solver;
  Newton_solver solve(state, linear_solver);
  executor.run_ahead([&] { solve.analyze_pattern(); }, [&] { start_from_coarse(state); });
  const auto end = solve(Solver_options());
  EXPECT_TRUE(end.has_converged);
  const Extraction extraction(state);
  EXPECT_TRUE(certify(state, extraction).empty());
  std::vector<double> result = {end.energy, end.optimality};
  result.insert(result.end(), state.map().t.begin(), state.map().t.end());
  result.insert(result.end(), extraction.flux.begin(), extraction.flux.end());
  for (const Refined_mesh::Face& face : extraction.refined_mesh.faces)
    result.insert(result.end(), face.t.begin(), face.t.end());
  for (const Point& p : extraction.refined_mesh.points)
    result.insert(result.end(), p.begin(), p.end());
  for (const auto& samples : Arc_embedding(state, extraction.refined_mesh).even_samples(5))
    for (const auto& sample : samples)
      result.insert(result.end(), {sample.level, sample.length, sample.point[0]});
  return result;
}

Flat_loop_system system_of(const Triangle_soup& soup, const std::vector<int>& poles)
{
  Flat_loop_system result;
  result.mesh = flat_mesh(soup);
  for (int pole : poles)
  {
    Flat_loop loop;
    loop.height = 1;
    loop.pole = static_cast<int>(result.poles.size());
    loop.is_tight = true;
    result.loops.push_back(loop);
    result.poles.push_back({pole});
  }
  std::vector<Problem> problems;
  complete(result, problems);
  EXPECT_TRUE(problems.empty());
  return result;
}

void expect_same_bits(const Flat_loop_system& system)
{
  ASSERT_GT(Executor::number_of_blocks(system.mesh.number_of_edges()), 1);
  const std::vector<double> expected = numbers(system, executor_for<CGAL::Sequential_tag>());
  for (int threads : {1, 2, 4})
  {
    const std::vector<double> found = numbers(system, Thread_executor(threads));
    ASSERT_EQ(found.size(), expected.size());
    EXPECT_EQ(std::memcmp(found.data(), expected.data(), found.size() * sizeof(double)), 0)
      << threads << " threads";
  }
}

} // namespace

TEST(Executor_threads, sphere)
{
  expect_same_bits(system_of(soups::icosphere(5), {0, 1, 2, 700}));
}

TEST(Executor_threads, torus)
{
  expect_same_bits(system_of(soups::torus(80, 60, 2, 0.7), {0, 1700, 3000}));
}

TEST(Executor_threads, genus_2)
{
  expect_same_bits(system_of(soups::genus_surface(2, 9), {0, 1, 300}));
}

} // namespace test_executor_threads
