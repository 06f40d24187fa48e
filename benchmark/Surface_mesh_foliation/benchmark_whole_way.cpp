// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The whole way from a mesh in memory to its embedded Reeb graph, in units of one analysis,
// factorization and solve of the mesh's Laplacian by Eigen::SimplicialLDLT, measured in turns:
//
//   benchmark_whole_way [--levels=N] [--runs=R]
//
// prints a table of medians of R runs (3): with poles given, the same in parallel, and from the
// bare mesh to its canonical graph; a table of the stages; and the memory that the run with poles
// given needs in addition to the mesh, beside that of the solve. The meshes are CGAL's armadillo
// (26,002 vertices), the same remeshed to about 44,000, and a human body (shared meshes, 6,890
// vertices) or, without shared meshes, CGAL's hand, subdivided up to N times (3).

#include "benchmark_mesh.h"
#include "benchmark_table.h"
#include "generators/remeshed.h"
#include "peak_memory.h"

#include <CGAL/Surface_mesh_foliation/canonical_loops.h>
#include <CGAL/Surface_mesh_foliation/canonical_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/feature_poles.h>
#include <CGAL/Surface_mesh_foliation/foliation_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

using namespace smf_benchmark;

namespace {

using Graph = SMF::Reeb_graph<Mesh::Point>;
using Input = SMF::Poles_and_loops<Mesh>;

std::vector<Vertex> found_poles(const Mesh& mesh)
{
  std::vector<Vertex> result;
  SMF::detect_feature_poles(mesh, std::back_inserter(result));
  return result;
}

Input with_poles(const std::vector<Vertex>& poles)
{
  Input result;
  for (const Vertex v : poles)
    result.add_pole(v);
  return result;
}

const std::vector<std::string> ways = {"poles given", "in parallel", "bare mesh"};
const std::vector<std::string> stages = {"loop system", "foliation", "graph", "poles",
                                         "canonical loops"};

struct Row
{
  std::size_t vertices;
  Series series;
  double memory_of_solve, memory; // in MiB
};

void measure_once(const Mesh& mesh,
                  const Input& input,
                  const One_solve<Eigen_solver>& solve,
                  Series& series)
{
  series.measure("solve", [&] { benchmark::DoNotOptimize(solve()); });
  series.measure("poles given", [&] {
    Graph graph;
    SMF::foliation_reeb_graph(mesh, input, graph);
  });
  series.measure("in parallel", [&] {
    Graph graph;
    SMF::foliation_reeb_graph<CGAL::Parallel_if_available_tag>(mesh, input, graph);
  });
  series.measure("bare mesh", [&] {
    Graph graph;
    SMF::canonical_reeb_graph(mesh, graph);
  });
  // once more, stage by stage
  Input found;
  series.measure("poles", [&] { found = with_poles(found_poles(mesh)); });
  series.measure("canonical loops", [&] { SMF::canonical_loops(mesh, found); });
  std::vector<SMF::Loop_system<Mesh>> system;
  series.measure("loop system", [&] { system.emplace_back(mesh, input); });
  std::vector<SMF::Measured_foliation<Mesh>> foliation;
  series.measure("foliation",
                 [&] { foliation.push_back(SMF::harmonic_foliation(system.front())); });
  series.measure("graph", [&] {
    Graph graph;
    SMF::reeb_graph(foliation.front(), graph);
  });
}

Row measured(const Mesh& mesh, const Input& input, int runs)
{
  const One_solve<Eigen_solver> solve(SMF::Loop_system<Mesh>(mesh, input));
  Row row = {num_vertices(mesh), {}, 0, 0};
  for (int run = 0; run < runs; ++run)
    measure_once(mesh, input, solve, row.series);
  reset_peak_memory();
  const double before = peak_megabytes();
  row.memory_of_solve = peak_megabytes_of([&] { benchmark::DoNotOptimize(solve()); }) - before;
  row.memory = peak_megabytes_of([&] {
                 Graph graph;
                 SMF::foliation_reeb_graph(mesh, input, graph);
               }) -
               before;
  return row;
}

void print_memory(const std::vector<Row>& rows)
{
  print_header({"vertices", "a solve (ms)", "a solve (MiB)", "poles given (MiB)"});
  for (const Row& row : rows)
    print_row({std::to_string(row.vertices), number(1000 * row.series["solve"], "%.1f"),
               number(row.memory_of_solve, "%.0f"), number(row.memory, "%.0f")});
}

} // namespace

int main(int argc, char* argv[])
try
{
  int levels = 3, runs = 3;
  for (int i = 1; i < argc; ++i)
  {
    levels = value_of(argv[i], "--levels=", levels);
    runs = value_of(argv[i], "--runs=", runs);
  }
  std::vector<Row> rows;
  for (int level = 0; level <= levels; ++level)
  {
    rows.push_back(measured(subdivided(level), body_poles(), runs));
    if (level == 0)
    {
      Mesh armadillo;
      SMF::read_triangle_mesh(std::string(SMF_DATA_DIR) + "/armadillo.off", armadillo);
      rows.push_back(measured(armadillo, with_poles(found_poles(armadillo)), runs));
      constexpr std::size_t number_asked_for = 38000; // CGAL's remeshing makes a sixth more
      armadillo = smf_test::remeshed(std::move(armadillo), number_asked_for);
      rows.push_back(measured(armadillo, with_poles(found_poles(armadillo)), runs));
    }
  }
  std::cout << "Times in units of one solve, " << runs << " runs.\n" << std::endl;
  print_in_solves(rows, ways);
  print_in_solves(rows, stages);
  print_memory(rows);
  return EXIT_SUCCESS;
}
catch (const std::exception& exception)
{
  std::cerr << exception.what() << std::endl;
  return EXIT_FAILURE;
}
