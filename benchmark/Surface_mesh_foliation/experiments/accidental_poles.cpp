// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Accidental poles (figures 9 and 10 of the paper): Whitehead moves with cotangent and with mean
// value weights on meshes that are far from Delaunay, and what the default solver makes of them.
// Runs: the number of meshes of each shape, with random edges flipped.

#include "Command_line.h"
#include "Part_graph.h"
#include "Shapes.h"

#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/edge_weights.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/whitehead_foliation.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

using namespace smf_experiments;

using System = SMF::Loop_system<Mesh>;

// the share of edges whose cotangent weight is not positive
double non_delaunay_share(const System& system)
{
  std::vector<double> weights(num_edges(system.mesh()));
  SMF::edge_weights(
    system, SMF::Cotangent_weights(),
    boost::make_iterator_property_map(weights.begin(), get(boost::edge_index, system.mesh())));
  return static_cast<double>(
           std::count_if(weights.begin(), weights.end(), [](double w) { return w <= 0; })) /
         static_cast<double>(weights.size());
}

struct Count
{
  std::size_t sweeps, accidental_poles;
};

template <class EdgeWeights>
Count whitehead_moves(const System& system, EdgeWeights weights, bool are_literal)
{
  constexpr std::size_t step = 100, most = 2000;
  SMF::Whitehead_foliation_solver<Mesh> solver(system, SMF::parameters::weights(weights)
                                                         .allow_any_weights(true)
                                                         .over_relaxation(are_literal ? 1. : 1.9)
                                                         .use_literal_moves(are_literal));
  std::size_t sweeps = 0;
  for (; sweeps < most && !solver.statistics(1e-8).has_converged; sweeps += step)
    for (std::size_t i = 0; i < step; ++i)
      solver.sweep();
  return {sweeps, solver.accidental_thorns().size()};
}

// what the default solver makes of it: "certified", or what is wrong
template <class EdgeWeights>
std::string default_solver(const System& system, EdgeWeights weights)
{
  try
  {
    SMF::harmonic_foliation(system, SMF::parameters::weights(weights).allow_any_weights(true));
    return "certified";
  }
  catch (const SMF::Foliation_exception& exception)
  {
    std::string message = exception.what();
    std::replace(message.begin(), message.end(), ',', ';');
    return message;
  }
}

template <class EdgeWeights>
void print(const std::string& shape,
           std::size_t run,
           const System& system,
           const std::string& name,
           EdgeWeights weights)
{
  const Count literal = whitehead_moves(system, weights, true);
  const Count repaired = whitehead_moves(system, weights, false);
  print_row(shape, run, non_delaunay_share(system), name, literal.accidental_poles,
            repaired.accidental_poles, repaired.sweeps, default_solver(system, weights));
}

int main(int argc, char* argv[])
{
  return run_experiment(argc, argv, 25, [](Options options) {
    if (options.shapes.empty())
      options.shapes = {"hand", "elephant", "cow", "cactus"};
    print_row("shape", "mesh", "edges that are not Delaunay", "weights",
              "accidental poles of literal moves", "of repaired moves", "sweeps of repaired moves",
              "default solver");
    for_each_shape(options, [&](const Shape& shape) {
      for (std::size_t run = 1; run <= options.runs; ++run)
      {
        const Mesh mesh = smf_test::flip_random_edges(shape.mesh, 0.3, run);
        const System system(mesh, with_poles(shape.tips()));
        print(shape.name, run, system, "cotangent", SMF::Cotangent_weights());
        print(shape.name, run, system, "mean value", SMF::Mean_value_weights());
      }
    });
  });
}
