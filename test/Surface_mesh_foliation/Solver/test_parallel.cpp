// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// With Parallel_tag everything is the same, bit for bit, with any number of threads.

#include <CGAL/Surface_mesh_foliation.h>

#include "generators/meshes.h"

#include <tbb/global_control.h>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstring>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace test_parallel {

namespace SMF = CGAL::Surface_mesh_foliation;
using namespace smf_test;
using SMF::internal::Executor;
using SMF::internal::executor_for;

namespace {

// All numbers that a run from the mesh to the embedded graph makes.
template <class ConcurrencyTag>
std::vector<double> numbers(const Mesh& mesh, const SMF::Poles_and_loops<Mesh>& input)
{
  const SMF::Loop_system<Mesh> system(mesh, input);
  const auto foliation = SMF::harmonic_foliation<ConcurrencyTag>(system);
  std::vector<double> result = {foliation.statistics().energy, foliation.statistics().optimality};
  for (const auto v : vertices(mesh))
    result.push_back(foliation.parameter(v));
  for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
    result.push_back(foliation.flux(a));
  for (const auto& face : foliation.extraction().refined_mesh.faces)
    result.insert(result.end(), face.t.begin(), face.t.end());
  for (const auto& p : foliation.extraction().refined_mesh.points)
    result.insert(result.end(), p.begin(), p.end());
  const auto embedding = SMF::reeb_graph_embedding(foliation);
  for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
    for (const auto& p : embedding.arc_polylines[a])
      result.insert(result.end(), {p.x(), p.y(), p.z()});
  return result;
}

bool are_same_bits(const std::vector<double>& a, const std::vector<double>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

// Meshes of several blocks, of genus 0, 1, 2 and 3.
struct Case
{
  std::string name;
  Triangle_soup soup;
  std::vector<std::size_t> poles;
};

std::vector<Case> cases()
{
  return {{"sphere", soups::icosphere(5), {0, 1, 2, 700}},
          {"torus", soups::torus(100, 60, 2, 0.7), {0, 3000, 5000}},
          {"genus_2", soups::genus_surface(2, 9), {0, 1, 300}},
          {"genus_3", soups::genus_surface(3, 9), {5, 200, 900}}};
}

} // namespace

TEST(Parallel, every_bit_is_the_same_with_1_2_and_4_threads)
{
  for (const Case& c : cases())
  {
    SCOPED_TRACE(c.name);
    const Mesh mesh = to_mesh(c.soup);
    SMF::Poles_and_loops<Mesh> input;
    for (std::size_t pole : c.poles)
      input.add_pole(vertex(pole));
    const std::vector<double> expected = numbers<CGAL::Sequential_tag>(mesh, input);
    ASSERT_GT(Executor::number_of_blocks(static_cast<int>(num_edges(mesh))), 1);
    for (std::size_t threads : {1, 2, 4})
    {
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
      EXPECT_TRUE(are_same_bits(numbers<CGAL::Parallel_tag>(mesh, input), expected))
        << threads << " threads";
    }
  }
}

TEST(Parallel, weights_are_the_same)
{
  const Mesh mesh = to_mesh(soups::icosphere(5));
  SMF::Poles_and_loops<Mesh> input;
  for (std::size_t pole : {0, 1, 2})
    input.add_pole(vertex(pole));
  const SMF::Loop_system<Mesh> system(mesh, input);
  const auto& flat = system.data().flat.mesh;
  const auto& executor = executor_for<CGAL::Parallel_tag>();
  EXPECT_TRUE(are_same_bits(SMF::internal::mean_value_weights(flat, executor),
                            SMF::internal::mean_value_weights(flat)));
  EXPECT_TRUE(are_same_bits(SMF::internal::cotangent_weights(flat, executor),
                            SMF::internal::cotangent_weights(flat)));
}

TEST(Parallel, one_call_takes_the_tag)
{
  const Mesh mesh = icosphere(3);
  const std::vector<Mesh::Vertex_index> poles = vertex_range({0, 1, 2});
  SMF::Reeb_graph<Mesh::Point> sequential, parallel;
  SMF::foliation_reeb_graph(mesh, poles, sequential);
  SMF::foliation_reeb_graph<CGAL::Parallel_if_available_tag>(mesh, poles, parallel);
  ASSERT_EQ(num_vertices(parallel), 4u);
  for (const auto v : boost::make_iterator_range(vertices(parallel)))
    EXPECT_EQ(parallel[v].point, sequential[v].point);
}

TEST(Parallel, a_loop_visits_every_number_once_in_the_same_blocks)
{
  for (int n : {0, 1, 99, 100, 101, 12345})
  {
    std::vector<std::atomic<int>> visits(n);
    std::mutex mutex;
    std::set<std::vector<int>> blocks, expected;
    const auto body = [&](int block, int first, int last) {
      for (int i = first; i < last; ++i)
        ++visits[i];
      const std::lock_guard<std::mutex> lock(mutex);
      EXPECT_TRUE(blocks.insert({block, first, last}).second);
    };
    executor_for<CGAL::Parallel_tag>()(n, body, 100);
    for (const auto& number : visits)
      EXPECT_EQ(number, 1);
    executor_for<CGAL::Sequential_tag>()(
      n,
      [&](int block, int first, int last) {
        expected.insert({block, first, last});
      },
      100);
    EXPECT_EQ(blocks, expected);
    EXPECT_EQ(static_cast<int>(blocks.size()), Executor::number_of_blocks(n, 100));
  }
}

TEST(Parallel, lists_are_in_order_and_exceptions_come_through)
{
  const auto odd = [](int i, std::vector<int>& list) {
    if (i % 2 == 1)
      list.push_back(i);
  };
  const auto& executor = executor_for<CGAL::Parallel_tag>();
  const std::vector<int> list = SMF::internal::collected_numbers<int>(executor, 50000, odd);
  ASSERT_EQ(list.size(), 25000u);
  for (int i = 0; i < 25000; ++i)
    ASSERT_EQ(list[i], 2 * i + 1);
  EXPECT_EQ(SMF::internal::sum_of_numbers(executor, 50000, [](int i) { return i; }), 1249975000.);
  EXPECT_THROW(executor(50000, [](int, int, int) { throw std::runtime_error("in a block"); }),
               std::runtime_error);
}

TEST(Parallel, what_is_run_ahead_is_done_when_the_main_task_is)
{
  const auto& executor = executor_for<CGAL::Parallel_tag>();
  for (std::size_t threads : {1, 2})
  {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    bool is_ahead_done = false;
    std::thread::id main_thread;
    executor.run_ahead([&] { is_ahead_done = true; },
                       [&] { main_thread = std::this_thread::get_id(); });
    EXPECT_TRUE(is_ahead_done);
    EXPECT_EQ(main_thread, std::this_thread::get_id()); // it may call a user's visitor

    const auto fail = [] { throw std::runtime_error("in a task"); };
    EXPECT_THROW(executor.run_ahead(fail, [] {}), std::runtime_error);
    EXPECT_THROW(executor.run_ahead(fail, [] { throw std::logic_error("in main"); }),
                 std::logic_error);
    std::atomic<int> begun(0), done(0);
    const auto ahead = [&] {
      ++begun;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      ++done;
    };
    for (int i = 0; i < 20; ++i)
    {
      EXPECT_THROW(executor.run_ahead(ahead, fail), std::runtime_error);
      EXPECT_EQ(done, begun); // it never uses what is left behind
    }
  }
}

TEST(Parallel, the_pattern_is_analyzed_once)
{
  struct Counting_solver : SMF::Supernodal_cholesky_solver
  {
    int analyses = 0;
    void analyze_pattern(const Matrix& matrix)
    {
      ++analyses;
      SMF::Supernodal_cholesky_solver::analyze_pattern(matrix);
    }
  } linear_solver;
  SMF::Foliation_solver<Mesh, Counting_solver, CGAL::Parallel_tag> solver(linear_solver);
  const Mesh mesh = to_mesh(soups::icosphere(5));
  for (std::size_t last : {500, 600})
  {
    SMF::Poles_and_loops<Mesh> input;
    for (std::size_t pole : {std::size_t(0), std::size_t(1), last})
      input.add_pole(vertex(pole));
    EXPECT_TRUE(solver.solve(SMF::Loop_system<Mesh>(mesh, input)).statistics().has_converged);
    EXPECT_EQ(linear_solver.analyses, 1);
  }
}

} // namespace test_parallel
