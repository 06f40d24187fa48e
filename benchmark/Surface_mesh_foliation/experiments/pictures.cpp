// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the pictures of the experiments show (figures 1, 13, 14 and 15 of the paper): graphs of a
// shape and of some of its poses, each in a folder panels/NAME with the files that
// doc/Surface_mesh_foliation/pictures/draw reads. Prints the sizes of the graphs, and whether they
// are isomorphic to that of the shape's own pose. Runs: the number of other poses of each shape.

#include "Command_line.h"
#include "Panels.h"
#include "Part_graph.h"
#include "Poses.h"
#include "Shapes.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

using namespace smf_experiments;

std::vector<Named_graph> graphs(const Shape& shape, const Mesh& pose)
{
  std::vector<Named_graph> result =
    all_graphs(pose, shape.up, shape.tips(), {0}, shape.part_of_vertex);
  for (Named_graph& graph : graphs_with_loop_by_hand(shape, pose))
    result.push_back(std::move(graph));
  return result;
}

int main(int argc, char* argv[])
{
  return run_experiment(argc, argv, 4, [](Options options) {
    if (options.shapes.empty())
      options.shapes = {"hand", "homer", "camel", "cow"};
    print_row("panel", "nodes", "arcs", "largest degree", "isomorphic");
    for_each_shape(options, [&](const Shape& shape) {
      const Poses poses(shape);
      const std::vector<Named_graph> own = graphs(shape, shape.mesh);
      for (std::size_t pose = 0; pose <= options.runs; ++pose)
      {
        const Mesh mesh = pose == 0 ? shape.mesh : poses.pose(pose);
        const std::vector<Named_graph> posed = pose == 0 ? own : graphs(shape, mesh);
        for (std::size_t kind = 0; kind < own.size(); ++kind)
        {
          const Part_graph& graph = posed[kind].graph;
          const std::string name =
            panel_name(shape.name + " " + std::to_string(pose) + " " + posed[kind].name);
          write_panel(name, mesh, graph);
          print_row(name, graph.number_of_nodes(), graph.number_of_arcs(), graph.largest_degree(),
                    are_isomorphic(own[kind].graph, graph));
        }
      }
    });
  });
}
