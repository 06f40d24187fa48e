// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Times (Section 5.5 of the paper), on one core: repaired Whitehead moves, plain and over-relaxed,
// until the energy is within 1e-6 of the least, then until the foliation is certified; Newton's
// method; and the graph of the foliation. Times are those of the processor, in seconds. Runs: how
// often all but the moves are measured; the median counts.

#include "Command_line.h"
#include "Part_graph.h"
#include "Shapes.h"

#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/components.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/whitehead_foliation.h>

#include <CGAL/Timer.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

using namespace smf_experiments;

using System = SMF::Loop_system<Mesh>;
using Foliation = SMF::Measured_foliation<Mesh>;

template <class Run>
double seconds_of(Run run)
{
  CGAL::Timer timer;
  timer.start();
  run();
  timer.stop();
  return timer.time();
}

template <class Run>
double median_seconds_of(std::size_t runs, Run run)
{
  std::vector<double> seconds;
  for (std::size_t i = 0; i < runs; ++i)
    seconds.push_back(seconds_of(run));
  std::sort(seconds.begin(), seconds.end());
  return seconds.at(runs / 2);
}

struct Moves
{
  std::size_t sweeps;
  double seconds;
};

Moves whitehead_moves(const System& system, double over_relaxation, double least_energy)
{
  constexpr std::size_t step = 50;
  Moves result{0, 0};
  result.seconds = seconds_of([&] {
    SMF::Whitehead_foliation_solver<Mesh> solver(system,
                                                 SMF::parameters::over_relaxation(over_relaxation));
    for (; solver.statistics().energy > (1 + 1e-6) * least_energy; result.sweeps += step)
      for (std::size_t i = 0; i < step; ++i)
        solver.sweep();
    solver.foliation();
  });
  return result;
}

// with its embedding, and the segments of the surface
void make_graph(const Foliation& foliation)
{
  SMF::Reeb_graph<Point> graph;
  SMF::reeb_graph(foliation, graph);
  const Mesh& mesh = foliation.system().mesh();
  std::vector<std::size_t> segments(num_faces(mesh));
  SMF::face_segmentation(
    foliation, boost::make_iterator_property_map(segments.begin(), get(CGAL::face_index, mesh)));
}

// where the system tells it, without commas
std::string name_of_processor()
{
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.rfind("model name", 0) == 0 && line.find(": ") != std::string::npos)
    {
      std::string name = line.substr(line.find(": ") + 2);
      std::replace(name.begin(), name.end(), ',', ' ');
      return name;
    }
  return "unknown";
}

int main(int argc, char* argv[])
{
  return run_experiment(argc, argv, 5, [](Options options) {
    if (options.runs == 0)
      throw std::invalid_argument("there must be at least one run");
    if (options.shapes.empty())
      options.shapes = {"hand", "elephant", "homer", "human_man_6890", "cat_7949"};
    print_row("shape", "vertices", "sweeps", "moves", "over-relaxed sweeps", "over-relaxed moves",
              "Newton's method", "graph", "processor");
    for_each_shape(options, [&](const Shape& shape) {
      const System system(shape.mesh, with_poles(shape.tips()));
      const Foliation foliation = SMF::harmonic_foliation(system);
      const double least_energy = foliation.statistics().energy;
      const Moves plain = whitehead_moves(system, 1, least_energy),
                  over_relaxed = whitehead_moves(system, 1.9, least_energy);
      const double newton =
        median_seconds_of(options.runs, [&] { SMF::harmonic_foliation(system); });
      const double graph = median_seconds_of(options.runs, [&] { make_graph(foliation); });
      print_row(shape.name, num_vertices(shape.mesh), plain.sweeps, plain.seconds,
                over_relaxed.sweeps, over_relaxed.seconds, newton, graph, name_of_processor());
    });
  });
}
