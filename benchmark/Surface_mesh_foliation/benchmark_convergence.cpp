// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Convergence of the foliation: the time to finish each iteration, with the optimality and the
// energy gap reached by then as counters. Arguments: level of the mesh, number of iterations. The
// first row of each level is one solve of its Laplacian.

#include "benchmark_mesh.h"

#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>

using namespace smf_benchmark;

namespace {

void one_solve(benchmark::State& state)
{
  const Case& c = hand(static_cast<int>(state.range(0)));
  const SMF::Loop_system<Mesh> system(c.mesh, c.poles);
  const One_solve<> solve(system);
  for (auto _ : state)
    benchmark::DoNotOptimize(solve());
}

// what the solver does without its certificate
SMF::Foliation_statistics iterate(const SMF::Loop_system<Mesh>& system, int iterations)
{
  const SMF::internal::Flat_loop_system& flat = system.data().flat;
  SMF::internal::Foliation_state foliation(flat, SMF::internal::mean_value_weights(flat.mesh));
  SMF::internal::start_from_coarse(foliation);
  SMF::Simplicial_cholesky_solver linear_solver;
  SMF::internal::Newton_solver solve(foliation, linear_solver);
  SMF::internal::Solver_options options;
  options.max_iterations = iterations;
  return solve(options);
}

void convergence(benchmark::State& state)
{
  const Case& c = hand(static_cast<int>(state.range(0)));
  const SMF::Loop_system<Mesh> system(c.mesh, c.poles);
  SMF::Foliation_statistics result;
  for (auto _ : state)
    result = iterate(system, static_cast<int>(state.range(1)));
  const double least_energy = iterate(system, 100).energy;
  state.counters["vertices"] = static_cast<double>(num_vertices(c.mesh));
  state.counters["optimality"] = result.optimality;
  state.counters["energy_gap"] = result.energy / least_energy - 1;
  state.counters["moves"] = static_cast<double>(result.number_of_moves);
}

void levels_and_iterations(benchmark::internal::Benchmark* benchmark)
{
  for (int level : {0, 1, 2})
  {
    const Case& c = hand(level);
    const auto last =
      static_cast<int>(iterate(SMF::Loop_system<Mesh>(c.mesh, c.poles), 100).number_of_iterations);
    for (int iterations = 0; iterations <= last; ++iterations)
      benchmark->Args({level, iterations});
  }
}

} // namespace

BENCHMARK(one_solve)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);
BENCHMARK(convergence)->Apply(levels_and_iterations)->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
