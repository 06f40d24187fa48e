// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The time of every stage against the number of vertices, beside one solve of the Laplacian.
//
// The argument of each benchmark is the level of the mesh; `vertices` is printed beside the time.
// The complexity in n is fitted by the library.

#include "benchmark_mesh.h"

#include <CGAL/Surface_mesh_foliation/IO/write_foliation.h>
#include <CGAL/Surface_mesh_foliation/IO/write_polylines.h>
#include <CGAL/Surface_mesh_foliation/IO/write_vtp.h>
#include <CGAL/Surface_mesh_foliation/Component_coordinates.h>
#include <CGAL/Surface_mesh_foliation/Leaf_tracer.h>
#include <CGAL/Surface_mesh_foliation/components.h>
#include <CGAL/Surface_mesh_foliation/curve_skeleton.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/integrate_foliation.h>
#include <CGAL/Surface_mesh_foliation/leaves.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_embedding.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_matching.h>
#include <CGAL/Surface_mesh_foliation/singularities.h>
#include <CGAL/Surface_mesh_foliation/subdivide_saddle_faces.h>

#ifdef SMF_HAS_SPECTRA
#include <CGAL/Surface_mesh_foliation/feature_poles.h>
#endif

#include <CGAL/Surface_mesh/IO/OFF.h>

#include <cstdint>
#include <filesystem>
#include <iterator>
#include <map>
#include <string>
#include <vector>

using namespace smf_benchmark;

namespace {

// runs `stage` for the mesh of the level that the benchmark's argument says
template <class Stage>
void measure(benchmark::State& state, const Stage& stage)
{
  for (auto _ : state)
    benchmark::DoNotOptimize(stage());
  const auto n = num_vertices(hand(static_cast<int>(state.range(0))).mesh);
  state.counters["vertices"] = static_cast<double>(n);
  state.SetComplexityN(static_cast<benchmark::IterationCount>(n));
}

SMF::Loop_system<Mesh> system_of(const benchmark::State& state)
{
  const Case& c = hand(static_cast<int>(state.range(0)));
  return SMF::Loop_system<Mesh>(c.mesh, c.poles);
}

#ifdef SMF_HAS_SPECTRA
// with checks of the mesh; the largest meshes are decimated
void feature_poles(benchmark::State& state)
{
  const Mesh& mesh = hand(static_cast<int>(state.range(0))).mesh;
  measure(state, [&] {
    std::vector<Vertex> poles;
    SMF::detect_feature_poles(mesh, std::back_inserter(poles));
    return poles.size();
  });
}
#endif

// computed once per level: the library calls a benchmark several times
const SMF::Measured_foliation<Mesh>& foliation_of(const benchmark::State& state)
{
  static std::map<std::int64_t, SMF::Measured_foliation<Mesh>> foliations;
  auto it = foliations.find(state.range(0));
  if (it == foliations.end())
    it = foliations.emplace(state.range(0), SMF::harmonic_foliation(system_of(state))).first;
  return it->second;
}

void one_solve(benchmark::State& state)
{
  const SMF::Loop_system<Mesh> system = system_of(state);
  const One_solve<> solve(system);
  measure(state, solve);
}

// with its strict checks
void read(benchmark::State& state)
{
  const std::string file =
    (std::filesystem::temp_directory_path() / "surface_mesh_foliation_benchmark.off").string();
  CGAL::IO::write_OFF(file, hand(static_cast<int>(state.range(0))).mesh);
  measure(state, [&] {
    Mesh mesh;
    SMF::read_triangle_mesh(file, mesh);
    return num_vertices(mesh);
  });
  std::filesystem::remove(file);
}

void weights(benchmark::State& state)
{
  const SMF::Loop_system<Mesh> system = system_of(state);
  measure(state, [&] { return SMF::internal::mean_value_weights(system.data().flat.mesh).size(); });
}

void loop_system(benchmark::State& state)
{
  measure(state, [&] { return system_of(state); });
}

// from the loop system to the certified foliation
void foliation(benchmark::State& state)
{
  const SMF::Loop_system<Mesh> system = system_of(state);
  measure(state, [&] { return SMF::harmonic_foliation(system); });
  // a label, because all rows of the library's CSV must have the same counters
  const auto iterations = foliation_of(state).statistics().number_of_iterations;
  state.SetLabel(std::to_string(iterations) + " iterations");
}

// The other road: from edge values alone to the same foliation.
void integration(benchmark::State& state)
{
  Mesh mesh = hand(static_cast<int>(state.range(0))).mesh; // has the same descriptors
  const auto value = mesh.add_property_map<Mesh::Edge_index, double>("e:value").first;
  SMF::edge_values(foliation_of(state), value);
  measure(state, [&] { return SMF::integrate_foliation(mesh, value); });
}

// the part of a foliation that is no linear algebra and no iteration
void certificate(benchmark::State& state)
{
  const auto& foliation = foliation_of(state);
  measure(state, [&] {
    const SMF::internal::Foliation_state& map = foliation.state();
    return SMF::internal::certify(map, SMF::internal::Extraction(map)).size();
  });
}

void components(benchmark::State& state)
{
  const auto& foliation = foliation_of(state);
  measure(state, [&] {
    Mesh output;
    SMF::surface_components(foliation, output);
    return num_faces(output);
  });
}

void critical_leaves(benchmark::State& state)
{
  using Polyline = SMF::Critical_polyline<SMF::Loop_system<Mesh>::Point>;
  const auto& foliation = foliation_of(state);
  measure(state, [&] {
    std::vector<Polyline> polylines;
    SMF::critical_leaves(foliation, std::back_inserter(polylines));
    return polylines.size();
  });
}

void singularities(benchmark::State& state)
{
  const auto& foliation = foliation_of(state);
  measure(state, [&] {
    std::vector<SMF::Singularity<Mesh>> result;
    SMF::singularities(foliation, std::back_inserter(result));
    return result.size();
  });
}

void saddle_subdivision(benchmark::State& state)
{
  const auto& foliation = foliation_of(state);
  measure(state, [&] {
    Mesh output;
    return SMF::subdivide_saddle_faces(foliation, output);
  });
}

// what is done once
void leaf_tracer(benchmark::State& state)
{
  const auto& foliation = foliation_of(state);
  measure(state, [&] { return SMF::Leaf_tracer<Mesh>(foliation).leaf(0, 0.5).length; });
}

// a hundred in each arc
void hundred_leaves(benchmark::State& state)
{
  const SMF::Leaf_tracer<Mesh> tracer(foliation_of(state));
  measure(state, [&] {
    std::vector<SMF::Leaf<SMF::Loop_system<Mesh>::Point>> leaves;
    for (std::size_t a = 0; a < foliation_of(state).system().number_of_arcs(); ++a)
      tracer.evenly_spaced_leaves(a, 100, std::back_inserter(leaves));
    return leaves.size();
  });
}

void component_coordinates(benchmark::State& state)
{
  const auto& foliation = foliation_of(state);
  measure(state, [&] { return SMF::Component_coordinates<Mesh>(foliation).uv(0)[0]; });
}

void embedding(benchmark::State& state)
{
  const auto& foliation = foliation_of(state);
  measure(state, [&] { return SMF::reeb_graph_embedding(foliation).node_points.size(); });
}

// components, leaves and foliation as files
void write(benchmark::State& state)
{
  const auto& foliation = foliation_of(state);
  const std::string file =
    (std::filesystem::temp_directory_path() / "surface_mesh_foliation_benchmark.ply").string();
  const auto samples = SMF::reeb_graph_embedding(foliation);
  measure(state, [&] {
    SMF::write_components_ply(file, foliation);
    SMF::write_leaves_ply(file, foliation, samples);
    SMF::write_foliation_ply(file, foliation);
    return std::filesystem::file_size(file);
  });
  std::filesystem::remove(file);
}

// skeleton, components, leaves, foliation and singularities as files
void write_vtp(benchmark::State& state)
{
  const auto& foliation = foliation_of(state);
  const std::string file =
    (std::filesystem::temp_directory_path() / "surface_mesh_foliation_benchmark.vtp").string();
  const auto samples = SMF::reeb_graph_embedding(foliation);
  SMF::Reeb_graph<SMF::Loop_system<Mesh>::Point> graph;
  SMF::reeb_graph(foliation, graph, samples);
  measure(state, [&] {
    SMF::write_skeleton_vtp(file, graph);
    SMF::write_components_vtp(file, foliation);
    SMF::write_leaves_vtp(file, foliation, samples);
    SMF::write_foliation_vtp(file, foliation);
    SMF::write_singularities_vtp(file, foliation);
    return std::filesystem::file_size(file);
  });
  std::filesystem::remove(file);
}

void segmentation(benchmark::State& state)
{
  const auto& foliation = foliation_of(state);
  Mesh mesh = hand(static_cast<int>(state.range(0))).mesh; // has the same descriptors
  const auto segment = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  measure(state, [&] { return SMF::face_segmentation(foliation, segment); });
}

// without the embedding
void curve_skeleton(benchmark::State& state)
{
  const auto& foliation = foliation_of(state);
  const auto samples = SMF::reeb_graph_embedding(foliation);
  measure(state, [&] {
    SMF::Curve_skeleton<Mesh> skeleton;
    return SMF::curve_skeleton(foliation, samples, skeleton).size();
  });
}

// of the graph with itself, all poles alike; does not depend on the size of the mesh
void matching(benchmark::State& state)
{
  SMF::Reeb_graph<SMF::Loop_system<Mesh>::Point> graph;
  SMF::reeb_graph(foliation_of(state), graph);
  measure(state, [&] {
    return SMF::match_reeb_graphs(graph, graph, SMF::parameters::use_pole_labels(false))->distance;
  });
}

// graph and embedding
void reeb_graph(benchmark::State& state)
{
  const auto& foliation = foliation_of(state);
  measure(state, [&] {
    SMF::Reeb_graph<SMF::Loop_system<Mesh>::Point> graph;
    SMF::reeb_graph(foliation, graph);
    return num_edges(graph);
  });
}

} // namespace

#define SMF_BENCHMARK_STAGE(stage) \
  BENCHMARK(stage)->DenseRange(0, 3)->Unit(benchmark::kMillisecond)->Complexity()

SMF_BENCHMARK_STAGE(one_solve);
SMF_BENCHMARK_STAGE(read);
#ifdef SMF_HAS_SPECTRA
SMF_BENCHMARK_STAGE(feature_poles);
#endif
SMF_BENCHMARK_STAGE(loop_system);
SMF_BENCHMARK_STAGE(weights);
SMF_BENCHMARK_STAGE(foliation);
SMF_BENCHMARK_STAGE(integration);
SMF_BENCHMARK_STAGE(certificate);
SMF_BENCHMARK_STAGE(singularities);
SMF_BENCHMARK_STAGE(components);
SMF_BENCHMARK_STAGE(critical_leaves);
SMF_BENCHMARK_STAGE(saddle_subdivision);
SMF_BENCHMARK_STAGE(leaf_tracer);
SMF_BENCHMARK_STAGE(hundred_leaves);
SMF_BENCHMARK_STAGE(component_coordinates);
SMF_BENCHMARK_STAGE(embedding);
SMF_BENCHMARK_STAGE(reeb_graph);
SMF_BENCHMARK_STAGE(segmentation);
SMF_BENCHMARK_STAGE(curve_skeleton);
SMF_BENCHMARK_STAGE(matching);
SMF_BENCHMARK_STAGE(write);
SMF_BENCHMARK_STAGE(write_vtp);

BENCHMARK_MAIN();
