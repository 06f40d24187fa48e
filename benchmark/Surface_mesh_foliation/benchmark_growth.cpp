// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How time and memory grow with the size of the mesh, stage by stage, with the default linear
// solver, from 642 vertices to more than ten million:
//
//   benchmark_growth [--first=F] [--last=L]
//
// prints comma-separated values, a line for each level F to L (3 to 8; 10 gives 10,485,762
// vertices): the seconds of the stages and of one solve by Eigen::SimplicialLDLT, and the peak
// memory, both of the whole and of the solve, in addition to the mesh; then, for each column, the
// exponent of a power of the number of vertices that fits its lines with 10,000 vertices and more
// best. The mesh is a sphere with five limbs.

#include "benchmark_mesh.h"
#include "benchmark_table.h"
#include "peak_memory.h"

#include <CGAL/Surface_mesh_foliation/Foliation_solver.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

using namespace smf_benchmark;

namespace {

constexpr std::size_t number_of_limbs = 5;

const std::vector<std::string> columns = {
  "loop system", "start", "first iteration", "other iterations", "certificate",
  "graph",       "all",   "one solve",       "memory (MiB)",     "memory of one solve (MiB)"};

// By column. The stages are those of a run, so that their sum is its time.
std::vector<double> stages_of(const Mesh& mesh, const SMF::Poles_and_loops<Mesh>& poles)
{
  std::vector<double> result;
  std::optional<SMF::Loop_system<Mesh>> system;
  result.push_back(seconds_of([&] { system.emplace(mesh, poles); }));
  SMF::Foliation_solver<Mesh> solver;
  solver.expect_no_more_runs();
  result.push_back(seconds_of([&] { solver.start(*system); }));
  result.push_back(seconds_of([&] { solver.iterate(); }));
  result.push_back(seconds_of([&] {
    while (!solver.statistics().has_converged)
      solver.iterate();
  }));
  std::optional<SMF::Measured_foliation<Mesh>> foliation;
  result.push_back(seconds_of([&] { foliation = solver.foliation(); }));
  result.push_back(seconds_of([&] {
    SMF::Reeb_graph<Mesh::Point> graph;
    SMF::reeb_graph(*foliation, graph);
  }));
  double all = 0;
  for (const double stage : result)
    all += stage;
  result.push_back(all);
  return result;
}

struct Line
{
  double vertices;
  std::vector<double> values; // by column
};

Line measured(int level)
{
  const Mesh mesh = smf_test::to_mesh(smf_test::soups::limbed_sphere(number_of_limbs, level));
  SMF::Poles_and_loops<Mesh> poles;
  for (const std::size_t tip : smf_test::soups::limb_tips(number_of_limbs, level))
    poles.add_pole(smf_test::vertex(tip));
  Line line = {static_cast<double>(num_vertices(mesh)), {}};
  reset_peak_memory();
  const double before = peak_megabytes();
  const double memory = peak_megabytes_of([&] { line.values = stages_of(mesh, poles); }) - before;
  const One_solve<Eigen_solver> solve(SMF::Loop_system<Mesh>(mesh, poles));
  reset_peak_memory();
  const double before_solve = peak_megabytes();
  double seconds = 0;
  const double memory_of_solve =
    peak_megabytes_of([&] { seconds = seconds_of([&] { benchmark::DoNotOptimize(solve()); }); }) -
    before_solve;
  line.values.insert(line.values.end(), {seconds, memory, memory_of_solve});
  return line;
}

void print_cells(const std::string& first, const std::vector<double>& values)
{
  std::cout << first;
  for (const double value : values)
    std::cout << ',' << number(value, "%.4g");
  std::cout << std::endl;
}

// by least squares of logarithms
double exponent(const std::vector<Line>& lines, std::size_t column)
{
  constexpr double least_size = 10000;
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const Line& line : lines)
    if (line.vertices >= least_size && line.values[column] > 0)
    {
      const double u = std::log(line.vertices), v = std::log(line.values[column]);
      n += 1;
      x += u;
      y += v;
      xx += u * u;
      xy += u * v;
    }
  return n < 2 ? std::nan("") : (n * xy - x * y) / (n * xx - x * x);
}

} // namespace

int main(int argc, char* argv[])
try
{
  int first = 3, last = 8;
  for (int i = 1; i < argc; ++i)
  {
    first = value_of(argv[i], "--first=", first);
    last = value_of(argv[i], "--last=", last);
  }
  std::cout << "vertices";
  for (const std::string& column : columns)
    std::cout << ',' << column;
  std::cout << std::endl;
  std::vector<Line> lines;
  for (int level = first; level <= last; ++level)
  {
    lines.push_back(measured(level));
    print_cells(number(lines.back().vertices, "%.0f"), lines.back().values);
  }
  std::vector<double> exponents;
  for (std::size_t column = 0; column < columns.size(); ++column)
    exponents.push_back(exponent(lines, column));
  print_cells("exponent", exponents);
  return EXIT_SUCCESS;
}
catch (const std::exception& exception)
{
  std::cerr << exception.what() << std::endl;
  return EXIT_FAILURE;
}
