// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How long the paper's moves take, beside Newton's method.

#include "benchmark_mesh.h"
#include "peak_memory.h"

#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/whitehead_foliation.h>

#include <CGAL/Real_timer.h>

#include <functional>

using namespace smf_benchmark;

namespace {

// stops where the energy is within 1e-6 of the least, and knows when that was
struct Until_gap : SMF::Default_foliation_visitor
{
  explicit Until_gap(double least) : least_energy(least) { timer.start(); }

  bool after_iteration(const SMF::Foliation_statistics& statistics)
  {
    seconds = timer.time();
    return statistics.energy > (1 + 1e-6) * least_energy;
  }

  double least_energy;
  CGAL::Real_timer timer;
  double seconds = 0;
};

// Repaired Whitehead moves until the energy is within 1e-6 of the least, from the leaves in the
// loops. The arguments are the mesh, 0 for CGAL's hand and 1 for the body of benchmark_mesh.h, and
// the over-relaxation in percent. Counters, the time in units of what is measured beside it on the
// same loop system:
//   newtons            a certified foliation by Newton's method
//   parallel_newtons   the same on all cores, with TBB
//   newtons_to_gap     Newton's method until it is within 1e-6, too, without a certificate
void whitehead_moves(benchmark::State& state)
{
  keep_freed_memory(true);
  const Mesh mesh = state.range(0) == 0 ? hand(0).mesh : subdivided(0);
  const SMF::Loop_system<Mesh> system(mesh, state.range(0) == 0 ? hand(0).poles : body_poles());
  const double least_energy = SMF::harmonic_foliation(system).statistics().energy;
  const double factor = static_cast<double>(state.range(1)) / 100;
  constexpr int repetitions = 20;
  double newton = 0, parallel = 0, to_gap = 0, moves = 0, sweeps = 0;
  for (auto _ : state)
  {
    for (int i = 0; i < repetitions; ++i)
    {
      newton += seconds_of([&] { SMF::harmonic_foliation(system); });
#ifdef CGAL_LINKED_WITH_TBB
      parallel += seconds_of([&] { SMF::harmonic_foliation<CGAL::Parallel_tag>(system); });
#endif
      Until_gap until_gap(least_energy);
      SMF::harmonic_foliation(system, CGAL::parameters::visitor(std::ref(until_gap)));
      to_gap += until_gap.seconds;
    }
    const double seconds = seconds_of([&] {
      SMF::Whitehead_foliation_solver<Mesh> solver(system,
                                                   SMF::parameters::over_relaxation(factor));
      for (sweeps = 0; solver.statistics().energy > (1 + 1e-6) * least_energy; sweeps += 50)
        for (int i = 0; i < 50; ++i)
          solver.sweep();
    });
    state.SetIterationTime(seconds);
    moves += seconds;
  }
  state.counters["vertices"] = static_cast<double>(num_vertices(mesh));
  state.counters["sweeps"] = sweeps;
  state.counters["newtons"] = moves * repetitions / newton;
  if (parallel > 0)
    state.counters["parallel_newtons"] = moves * repetitions / parallel;
  state.counters["newtons_to_gap"] = moves * repetitions / to_gap;
}

} // namespace

BENCHMARK(whitehead_moves)
  ->ArgsProduct({{0, 1}, {100, 190}})
  ->UseManualTime()
  ->Unit(benchmark::kMillisecond)
  ->Iterations(1);

BENCHMARK_MAIN();
