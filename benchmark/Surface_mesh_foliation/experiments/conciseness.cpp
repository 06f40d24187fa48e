// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Conciseness (figures 13 and 14 of the paper): the sizes of Reeb graphs of functions, raw and
// simplified, and of foliations, and how many marked parts of the shapes have an arc of their own.
// Runs: the number of levels of persistence, from 0 upward.

#include "Command_line.h"
#include "Part_graph.h"
#include "Parts.h"
#include "Shapes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

using namespace smf_experiments;

constexpr std::array<double, 6> persistences = {0, 0.01, 0.02, 0.05, 0.1, 0.2};

void print(const Shape& shape, const Named_graph& named)
{
  const Overlaps overlaps(named.graph.arc_of_face, shape.part_of_face, face_areas(shape.mesh));
  std::size_t limbs = 0;
  for (int i = 0; i < shape.trunk(); ++i)
    if (overlaps.is_found_alone(i, shape.trunk(), 0.8))
      ++limbs;
  print_row(shape.name, named.name, named.persistence, named.graph.number_of_nodes(),
            named.graph.number_of_arcs(), named.graph.number_of_cycles(),
            named.graph.largest_degree(), shape.limbs.size(), limbs, overlaps.number_of_pairs(0.5));
}

int main(int argc, char* argv[])
{
  return run_experiment(argc, argv, persistences.size(), [](const Options& options) {
    const std::vector<double> levels(
      persistences.begin(), persistences.begin() + (std::min)(options.runs, persistences.size()));
    print_row("shape", "graph", "persistence", "nodes", "arcs", "cycles", "largest degree", "limbs",
              "limbs in one arc", "parts like one arc");
    for_each_shape(options, [&](const Shape& shape) {
      for (const Named_graph& graph :
           all_graphs(shape.mesh, shape.up, shape.tips(), levels, shape.part_of_vertex))
        print(shape, graph);
    });
  });
}
