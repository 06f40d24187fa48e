// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Poles, lines, canonical and other loops that are found or picked, beside one analysis,
// factorization and solve with the Laplacian of the same mesh, measured in turns. Counters:
//   solves  the time in units of one such solve
//   found   poles, lines or loops
//
// The argument is the number of midpoint subdivisions of a human body (shared meshes, 6,890
// vertices) or, without shared meshes, of CGAL's hand; for loops, of CGAL's elephant (2,775
// vertices, genus 3).

#include "benchmark_mesh.h"

#include <CGAL/Surface_mesh_foliation/automatic_loops.h>
#include <CGAL/Surface_mesh_foliation/canonical_loops.h>
#include <CGAL/Surface_mesh_foliation/feature_lines.h>
#include <CGAL/Surface_mesh_foliation/feature_poles.h>
#include <CGAL/Surface_mesh_foliation/foliation_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/picked_loops.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>

#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

using namespace smf_benchmark;

namespace {

void found(benchmark::State& state, std::size_t number)
{
  state.counters["found"] = static_cast<double>(number);
}

template <class Detector>
void poles(benchmark::State& state)
{
  const Mesh& mesh = body(state);
  measure_beside_solve(state, mesh, [&] {
    std::vector<Vertex> result;
    SMF::detect_feature_poles(mesh, std::back_inserter(result),
                              SMF::parameters::pole_detector(Detector()));
    found(state, result.size());
  });
}

SMF::Poles_and_loops<Mesh> with_poles_found(const Mesh& mesh)
{
  std::vector<Vertex> poles;
  SMF::detect_feature_poles(mesh, std::back_inserter(poles));
  SMF::Poles_and_loops<Mesh> result;
  for (const Vertex v : poles)
    result.add_pole(v);
  return result;
}

void canonical_loops(benchmark::State& state)
{
  const Mesh& mesh = body(state);
  const SMF::Poles_and_loops<Mesh> poles = with_poles_found(mesh);
  measure_beside_solve(state, mesh, [&] {
    SMF::Poles_and_loops<Mesh> result = poles;
    found(state, SMF::canonical_loops(mesh, result).size());
  });
}

// from the bare mesh to the embedded graph
void canonical_graph(benchmark::State& state)
{
  const Mesh& mesh = body(state);
  measure_beside_solve(state, mesh, [&] {
    SMF::Poles_and_loops<Mesh> input = with_poles_found(mesh);
    found(state, SMF::canonical_loops(mesh, input).size());
    SMF::Reeb_graph<Mesh::Point> graph;
    SMF::foliation_reeb_graph(mesh, input, graph);
  });
}

void lines(benchmark::State& state)
{
  const Mesh& mesh = body(state);
  measure_beside_solve(state, mesh, [&] {
    std::vector<std::vector<Vertex>> result;
    SMF::detect_feature_lines(mesh, std::back_inserter(result));
    found(state, result.size());
  });
}

Mesh elephant(const benchmark::State& state)
{
  Mesh result;
  SMF::read_triangle_mesh(std::string(SMF_DATA_DIR) + "/elephant.off", result);
  for (int level = 0; level < state.range(0); ++level)
    result = smf_test::midpoint_subdivided(result);
  return result;
}

SMF::Poles_and_loops<Mesh> poles_of_elephant()
{
  SMF::Poles_and_loops<Mesh> result;
  for (int v : {2759, 2555, 2047, 1671, 2279, 1401, 982})
    result.add_pole(Vertex(static_cast<Mesh::size_type>(v)));
  return result;
}

void loops_around_handles(benchmark::State& state)
{
  const Mesh mesh = elephant(state);
  measure_beside_solve(state, mesh, [&] {
    SMF::Poles_and_loops<Mesh> result = poles_of_elephant();
    found(state, SMF::propose_loops(mesh, result));
  });
}

void loop_through_vertices(benchmark::State& state)
{
  const Mesh mesh = elephant(state);
  measure_beside_solve(state, mesh, [&] {
    SMF::Poles_and_loops<Mesh> result = poles_of_elephant();
    const std::vector<Vertex> picks = {Vertex(567), Vertex(1456), Vertex(433), Vertex(2734)};
    SMF::add_loop_through_vertices(picks, mesh, result);
    found(state, 1);
  });
}

} // namespace

#define SMF_FEATURES(...) \
  BENCHMARK(__VA_ARGS__)->UseManualTime()->Unit(benchmark::kMillisecond)->DenseRange(0, 2)

#ifdef CGAL_SURFACE_MESH_FOLIATION_HAS_SPECTRA
BENCHMARK_TEMPLATE(poles, SMF::Heat_kernel_signature)
  ->UseManualTime()
  ->Unit(benchmark::kMillisecond)
  ->DenseRange(0, 2);
#endif
BENCHMARK_TEMPLATE(poles, SMF::Average_geodesic_distance)
  ->UseManualTime()
  ->Unit(benchmark::kMillisecond)
  ->DenseRange(0, 2);
BENCHMARK(canonical_loops)->UseManualTime()->Unit(benchmark::kMillisecond)->DenseRange(0, 3);
BENCHMARK(canonical_graph)->UseManualTime()->Unit(benchmark::kMillisecond)->DenseRange(0, 3);
SMF_FEATURES(lines);
SMF_FEATURES(loops_around_handles);
SMF_FEATURES(loop_through_vertices);

BENCHMARK_MAIN();
