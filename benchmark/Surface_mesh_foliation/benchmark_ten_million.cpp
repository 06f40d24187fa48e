// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// One run from a mesh of ten million vertices in memory to its certified foliation, beside one
// analysis, factorization and solve with its Laplacian. The argument is the number of subdivisions
// of the icosahedron that the mesh, a sphere with five limbs, is made of: 10 gives 10,485,762
// vertices. The target `ten_million` runs it, with CHOLMOD where it is found, whose factor of so
// large a mesh is smaller and sooner computed than that of the default solver. Counters as in
// benchmark_speed.

#include "benchmark_mesh.h"
#include "peak_memory.h"

#ifdef SMF_HAS_CHOLMOD
#include <CGAL/Surface_mesh_foliation/Cholmod_solver.h>
#endif
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>

#include <CGAL/Real_timer.h>

#include <cstddef>
#include <functional>

using namespace smf_benchmark;

namespace {

#ifdef SMF_HAS_CHOLMOD
using Linear_solver = SMF::Cholmod_solver;
#else
using Linear_solver = SMF::Simplicial_cholesky_solver;
#endif

constexpr std::size_t number_of_limbs = 5;

void sphere_with_limbs(benchmark::State& state)
{
  const int level = static_cast<int>(state.range(0));
  const Mesh mesh = smf_test::to_mesh(smf_test::soups::limbed_sphere(number_of_limbs, level));
  SMF::Poles_and_loops<Mesh> poles;
  for (std::size_t tip : smf_test::soups::limb_tips(number_of_limbs, level))
    poles.add_pole(smf_test::vertex(tip));
  for (auto _ : state)
  {
    SMF::Foliation_statistics statistics;
    CGAL::Real_timer timer;
    timer.start();
    const double peak = peak_megabytes_of([&] {
      Linear_solver linear_solver;
      statistics =
        SMF::harmonic_foliation(SMF::Loop_system<Mesh>(mesh, poles),
                                CGAL::parameters::sparse_linear_solver(std::ref(linear_solver)))
          .statistics();
    });
    const double seconds = timer.time();
    state.SetIterationTime(seconds);
    const One_solve<Linear_solver> solve(SMF::Loop_system<Mesh>(mesh, poles));
    timer.reset();
    benchmark::DoNotOptimize(solve());
    state.counters["vertices"] = static_cast<double>(num_vertices(mesh));
    state.counters["solves"] = seconds / timer.time();
    state.counters["iterations"] = static_cast<double>(statistics.number_of_iterations);
    state.counters["converged"] = statistics.has_converged && statistics.is_certified;
    state.counters["peak_MB"] = peak;
  }
}

} // namespace

BENCHMARK(sphere_with_limbs)
  ->DenseRange(5, 10)
  ->Iterations(1)
  ->UseManualTime()
  ->Unit(benchmark::kSecond);

BENCHMARK_MAIN();
