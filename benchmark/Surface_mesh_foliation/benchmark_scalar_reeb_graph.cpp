// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The Reeb graph of a function on a mesh in memory, beside one analysis, factorization and solve
// with the Laplacian of the same mesh, measured in turns. Counters:
//   solves  the time in units of one such solve
//   nodes   of the graph
//
// The argument is the number of midpoint subdivisions of a human body (shared meshes, 6,890
// vertices) or, without shared meshes, of CGAL's hand. The functions are the height; and random
// values, so that more than half of the vertices are critical.

#include "benchmark_mesh.h"
#include "generators/Random.h"

#include <CGAL/Surface_mesh_foliation/reeb_graph_of_function.h>

using namespace smf_benchmark;

namespace {

using Graph = SMF::Scalar_reeb_graph<Mesh>;
using Function = Mesh::Property_map<Vertex, double>;

void measure(benchmark::State& state, const Mesh& mesh, const Function& function)
{
  measure_beside_solve(state, mesh, [&] {
    Graph graph;
    SMF::reeb_graph_of_function(mesh, function, graph);
    state.counters["nodes"] = static_cast<double>(num_vertices(graph));
  });
}

void height(benchmark::State& state)
{
  Mesh& mesh = body(state);
  const Function function = mesh.add_property_map<Vertex, double>("v:height").first;
  for (const Vertex v : vertices(mesh))
    function[v] = mesh.point(v).y();
  measure(state, mesh, function);
}

void random_values(benchmark::State& state)
{
  Mesh& mesh = body(state);
  const Function function = mesh.add_property_map<Vertex, double>("v:random").first;
  smf_test::Random random(1);
  for (const Vertex v : vertices(mesh))
    function[v] = random.between(0, 1);
  measure(state, mesh, function);
}

} // namespace

#define SMF_SPEED(name) \
  BENCHMARK(name)->UseManualTime()->Unit(benchmark::kMillisecond)->DenseRange(0, 3)

SMF_SPEED(height);
SMF_SPEED(random_values);

BENCHMARK_MAIN();
