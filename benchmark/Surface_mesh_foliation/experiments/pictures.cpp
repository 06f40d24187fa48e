// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the pictures of the experiments show (figures 1, 14 and 15 of the paper): graphs of a shape
// and of some of its poses, each in a folder panels/NAME with the files that
// doc/Surface_mesh_foliation/pictures/draw reads. Prints the sizes of the graphs. Runs: the number
// of poses of each shape besides its own.

#include "Command_line.h"
#include "Part_graph.h"
#include "Poses.h"
#include "Shapes.h"

#include <CGAL/Surface_mesh_foliation/IO/write_polylines.h>
#include <CGAL/Surface_mesh_foliation/IO/write_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/IO/write_segments.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

using namespace smf_experiments;

void write_panel(const std::string& name, const Mesh& mesh, const Part_graph& graph)
{
  const std::string folder = "panels/" + name;
  std::filesystem::create_directories(folder);
  const std::vector<std::size_t> components(graph.arc_of_face.begin(), graph.arc_of_face.end());
  SMF::write_segments_ply(
    folder + "/components.ply", mesh,
    boost::make_iterator_property_map(components.begin(), get(CGAL::face_index, mesh)));
  SMF::write_skeleton_ply(folder + "/skeleton.ply", graph.graph);
  SMF::write_reeb_graph_graphml(folder + "/reeb_graph.graphml", graph.graph);
  print_row(name, graph.number_of_nodes(), graph.number_of_arcs());
}

int main(int argc, char* argv[])
{
  return run_experiment(argc, argv, 2, [](Options options) {
    if (options.shapes.empty())
      options.shapes = {"hand", "homer", "camel"};
    print_row("panel", "nodes", "arcs");
    for_each_shape(options, [&](const Shape& shape) {
      const Poses poses(shape);
      for (std::size_t run = 0; run <= options.runs; ++run)
      {
        const Mesh mesh = run == 0 ? shape.mesh : poses.pose(run);
        for (const Named_graph& graph :
             all_graphs(mesh, shape.up, shape.tips(), {0}, shape.part_of_vertex))
        {
          std::string name = shape.name + "_" + std::to_string(run) + "_" + graph.name;
          std::replace(name.begin(), name.end(), ' ', '_');
          for (const char bracket : {'(', ')'})
            name.erase(std::remove(name.begin(), name.end(), bracket), name.end());
          write_panel(name, mesh, graph.graph);
        }
      }
    });
  });
}
