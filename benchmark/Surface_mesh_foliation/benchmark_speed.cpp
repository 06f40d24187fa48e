// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// From a mesh in memory to its certified foliation, and from one foliation to the next, beside one
// analysis, factorization and solve with the Laplacian of the same mesh by Eigen::SimplicialLDLT,
// measured in turns. Counters:
//   solves       the time in units of one such solve
//   iterations   linear systems solved on the mesh itself
//   peak_MB      the largest memory of the process in a run of its own, the mesh included
//   speedup      with Parallel_tag: the time in sequence, beside it, in units of that in parallel
// Memory that is freed stays with the process while time is measured, so that it is computing that
// is measured, and not the system's handing out pages.
//
// The argument is the number of midpoint subdivisions of the body of benchmark_mesh.h.

#include "benchmark_mesh.h"
#include "peak_memory.h"

#include <CGAL/Surface_mesh_foliation/Component_coordinates.h>
#include <CGAL/Surface_mesh_foliation/Foliation_solver.h>
#include <CGAL/Surface_mesh_foliation/Leaf_tracer.h>
#include <CGAL/Surface_mesh_foliation/Supernodal_cholesky_solver.h>
#include <CGAL/Surface_mesh_foliation/components.h>
#include <CGAL/Surface_mesh_foliation/curve_skeleton.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/leaves.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_embedding.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_matching.h>
#include <CGAL/Surface_mesh_foliation/singularities.h>
#include <CGAL/Surface_mesh_foliation/subdivide_saddle_faces.h>
#ifdef SMF_HAS_CHOLMOD
#include <CGAL/Surface_mesh_foliation/Cholmod_solver.h>
#endif
#ifdef SMF_HAS_HYPRE
#include <CGAL/Surface_mesh_foliation/Boomer_amg_solver.h>
#endif

#include <cstddef>
#include <functional>
#include <iterator>
#include <vector>

using namespace smf_benchmark;

namespace {

using Default_solver = SMF::Supernodal_cholesky_solver;

// measures `run`, which returns a number of iterations, and one solve in turns
template <class Run>
void measure(benchmark::State& state, const Run& run)
{
  const double peak = peak_megabytes_of([&] { run(); });
  keep_freed_memory(true);
  std::size_t iterations = 0;
  measure_beside_solve(state, body(state), [&] { iterations = run(); });
  state.counters["iterations"] = static_cast<double>(iterations);
  state.counters["peak_MB"] = peak;
}

// returns the number of iterations
template <class LinearSolver, class ConcurrencyTag = CGAL::Sequential_tag>
std::size_t run_from_cold(const Mesh& mesh)
{
  LinearSolver linear_solver;
  return SMF::harmonic_foliation<ConcurrencyTag>(
           SMF::Loop_system<Mesh>(mesh, body_poles()),
           CGAL::parameters::sparse_linear_solver(std::ref(linear_solver)))
    .statistics()
    .number_of_iterations;
}

template <class LinearSolver>
void from_cold(benchmark::State& state)
{
  const Mesh& mesh = body(state);
  measure(state, [&] { return run_from_cold<LinearSolver>(mesh); });
}

#ifdef CGAL_LINKED_WITH_TBB
// From cold on all cores, in turns with a run in sequence; `speedup` is the ratio of the times.
void from_cold_in_parallel(benchmark::State& state)
{
  const Mesh& mesh = body(state);
  keep_freed_memory(true);
  double parallel = 0, sequential = 0;
  for (auto _ : state)
  {
    const double seconds =
      seconds_of([&] { run_from_cold<Default_solver, CGAL::Parallel_tag>(mesh); });
    state.SetIterationTime(seconds);
    parallel += seconds;
    sequential += seconds_of([&] { run_from_cold<Default_solver>(mesh); });
  }
  state.counters["vertices"] = static_cast<double>(num_vertices(mesh));
  state.counters["speedup"] = sequential / parallel;
}
#endif

struct Cost
{
  double seconds = 0, megabytes = 0;
};

template <class LinearSolver>
Cost cost_from_cold(const Mesh& mesh, std::size_t& iterations)
{
  reset_peak_memory();
  const double seconds = seconds_of([&] { iterations = run_from_cold<LinearSolver>(mesh); });
  return {seconds, peak_megabytes()};
}

// A foliation with one linear solver and with the default one, in turns. Counters: `times_default`
// and `memory_of_default`, the ratios of both.
template <class LinearSolver>
void beside_default(benchmark::State& state)
{
  const Mesh& mesh = body(state);
  const LinearSolver first; // what it does once per program is not measured
  Cost sum, default_sum;
  std::size_t iterations = 0, default_iterations = 0;
  for (auto _ : state)
  {
    const Cost cost = cost_from_cold<LinearSolver>(mesh, iterations);
    const Cost other = cost_from_cold<Default_solver>(mesh, default_iterations);
    state.SetIterationTime(cost.seconds);
    sum = {sum.seconds + cost.seconds, sum.megabytes + cost.megabytes};
    default_sum = {default_sum.seconds + other.seconds, default_sum.megabytes + other.megabytes};
  }
  state.counters["vertices"] = static_cast<double>(num_vertices(mesh));
  state.counters["iterations"] = static_cast<double>(iterations);
  state.counters["times_default"] = sum.seconds / default_sum.seconds;
  state.counters["memory_of_default"] = sum.megabytes / default_sum.megabytes;
}

// measures the runs on input(0), input(1), ... with one solver, after a first one that is not
// measured
template <class NextSystem>
void restart(benchmark::State& state, const NextSystem& next_system)
{
  SMF::Foliation_solver<Mesh> solver;
  int step = 0;
  solver.solve(next_system(step));
  measure(state,
          [&] { return solver.solve(next_system(++step)).statistics().number_of_iterations; });
}

void moved_pole(benchmark::State& state)
{
  restart(state,
          [&](int step) { return SMF::Loop_system<Mesh>(body(state), body_poles(step % 2)); });
}

void other_height(benchmark::State& state)
{
  restart(state, [&](int step) {
    SMF::Poles_and_loops<Mesh> input = body_poles();
    input.set_height(1, 1 + 0.1 * (step % 2));
    return SMF::Loop_system<Mesh>(body(state), input);
  });
}

void other_pose(benchmark::State& state)
{
  const std::vector<Mesh> poses = {body(state), smf_test::noisy(body(state), 0.1, 1)};
  restart(state, [&](int step) { return SMF::Loop_system<Mesh>(poses[step % 2], body_poles()); });
}

// every stage after the solve that is combinatorial, each once
void stages_after_solve(benchmark::State& state)
{
  using Point = SMF::Loop_system<Mesh>::Point;
  Mesh& mesh = body(state);
  auto segment = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  const SMF::Measured_foliation<Mesh> foliation =
    SMF::harmonic_foliation(SMF::Loop_system<Mesh>(mesh, body_poles()));
  keep_freed_memory(true);
  measure_beside_solve(state, mesh, [&] {
    const SMF::internal::Foliation_state& map = foliation.state();
    benchmark::DoNotOptimize(SMF::internal::certify(map, SMF::internal::Extraction(map)).size());
    std::vector<SMF::Singularity<Mesh>> singularities;
    SMF::singularities(foliation, std::back_inserter(singularities));
    std::vector<SMF::Critical_polyline<Point>> polylines;
    SMF::critical_leaves(foliation, std::back_inserter(polylines));
    Mesh components, subdivided;
    SMF::surface_components(foliation, components);
    SMF::subdivide_saddle_faces(foliation, subdivided);
    const auto samples = SMF::reeb_graph_embedding(foliation);
    SMF::Reeb_graph<Point> graph;
    SMF::reeb_graph(foliation, graph, samples);
    SMF::face_segmentation(foliation, segment);
    SMF::Curve_skeleton<Mesh> skeleton;
    SMF::curve_skeleton(foliation, samples, skeleton);
    std::vector<SMF::Leaf<Point>> leaves;
    const SMF::Leaf_tracer<Mesh> tracer(foliation);
    for (std::size_t a = 0; a < foliation.system().number_of_arcs(); ++a)
      tracer.evenly_spaced_leaves(a, 10, std::back_inserter(leaves));
    benchmark::DoNotOptimize(SMF::match_reeb_graphs(graph, graph));
  });
  mesh.remove_property_map(segment);
}

// coordinates of all components, which take a linear system each
void component_coordinates(benchmark::State& state)
{
  const Mesh& mesh = body(state);
  const SMF::Measured_foliation<Mesh> foliation =
    SMF::harmonic_foliation(SMF::Loop_system<Mesh>(mesh, body_poles()));
  keep_freed_memory(true);
  measure_beside_solve(state, mesh, [&] {
    benchmark::DoNotOptimize(SMF::Component_coordinates<Mesh>(foliation).uv(0));
  });
}

} // namespace

#define SMF_SPEED(name) BENCHMARK(name)->UseManualTime()->Unit(benchmark::kMillisecond)

SMF_SPEED(from_cold<Default_solver>)->DenseRange(0, 4);
#ifdef SMF_HAS_CHOLMOD
SMF_SPEED(from_cold<SMF::Cholmod_solver>)->DenseRange(0, 4);
SMF_SPEED(beside_default<SMF::Cholmod_solver>)->DenseRange(0, 4);
#endif
#ifdef SMF_HAS_HYPRE
SMF_SPEED(beside_default<SMF::Boomer_amg_solver>)->DenseRange(0, 4);
#endif
#ifdef CGAL_LINKED_WITH_TBB
SMF_SPEED(from_cold_in_parallel)->DenseRange(0, 4);
#endif
SMF_SPEED(moved_pole)->DenseRange(0, 3);
SMF_SPEED(other_height)->DenseRange(0, 3);
SMF_SPEED(other_pose)->DenseRange(0, 3);
SMF_SPEED(stages_after_solve)->DenseRange(0, 3);
SMF_SPEED(component_coordinates)->DenseRange(0, 3);

BENCHMARK_MAIN();
