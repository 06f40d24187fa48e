// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Stability under changes of pose (figures 1 and 15 of the paper): each posed shape and its poses,
// compared in pairs. Runs: the number of poses of a shape besides its own.

#include "Command_line.h"
#include "Part_graph.h"
#include "Parts.h"
#include "Poses.h"
#include "Shapes.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

using namespace smf_experiments;

// All graphs of all poses: by pose, then by kind, in the same order for each pose.
std::vector<std::vector<Named_graph>> graphs_of_poses(const Shape& shape,
                                                      const std::vector<Mesh>& poses)
{
  std::vector<std::vector<Named_graph>> result;
  for (const Mesh& pose : poses)
  {
    result.push_back(
      all_graphs(pose, shape.up, shape.tips(), {0, 0.02, 0.1}, shape.part_of_vertex));
    if (shape.name == "hand") // loops on other shapes are plane sections, which poses change
      for (Named_graph& graph : graphs_with_loop_by_hand(shape, pose))
        result.back().push_back(std::move(graph));
  }
  return result;
}

void print_pairs(const Shape& shape, const std::vector<std::vector<Named_graph>>& graphs)
{
  const std::vector<double> areas = face_areas(shape.mesh);
  for (std::size_t kind = 0; kind < graphs[0].size(); ++kind)
  {
    std::size_t pairs = 0, isomorphic = 0;
    double agreement = 0, nodes = 0;
    for (std::size_t i = 0; i < graphs.size(); ++i)
    {
      const Part_graph& first = graphs[i][kind].graph;
      nodes += static_cast<double>(first.number_of_nodes()) / static_cast<double>(graphs.size());
      for (std::size_t j = 0; j < i; ++j)
      {
        const Part_graph& second = graphs[j][kind].graph;
        ++pairs;
        isomorphic += are_isomorphic(first, second) ? 1 : 0;
        agreement += Overlaps(first.arc_of_face, second.arc_of_face, areas).agreement(0.8);
      }
    }
    const auto share = [&](double x) { return x / static_cast<double>(pairs); };
    print_row(shape.name, graphs[0][kind].name, graphs[0][kind].persistence, nodes, pairs,
              share(static_cast<double>(isomorphic)), share(agreement));
  }
}

// Of all poles found in all poses, the share that has one in another pose within a twentieth of the
// diagonal: the mean over all ordered pairs of poses.
double repeatability(const Mesh& mesh, const std::vector<std::vector<Vertex>>& poles)
{
  const double radius = 0.05 * diagonal(mesh);
  double found = 0, all = 0;
  for (std::size_t i = 0; i < poles.size(); ++i)
    for (std::size_t j = 0; j < poles.size(); ++j)
      for (const Vertex v : i == j ? std::vector<Vertex>() : poles[i])
      {
        ++all;
        found += std::any_of(poles[j].begin(), poles[j].end(), [&](Vertex w) {
          return CGAL::squared_distance(mesh.point(v), mesh.point(w)) <= radius * radius;
        });
      }
  return found / all;
}

int main(int argc, char* argv[])
{
  return run_experiment(argc, argv, 20, [](const Options& options) {
    print_row("shape", "graph", "persistence", "mean nodes", "pairs", "isomorphic",
              "arcs that agree");
    for_each_shape(options, [&](const Shape& shape) {
      if (!shape.is_posed)
        return;
      const Poses poses(shape);
      std::vector<Mesh> meshes = {shape.mesh};
      for (std::size_t i = 1; i <= options.runs; ++i)
        meshes.push_back(poses.pose(i));
      print_pairs(shape, graphs_of_poses(shape, meshes));
      std::vector<std::vector<Vertex>> found;
      for (const Mesh& mesh : meshes)
        found.push_back(found_poles(mesh));
      print_row(shape.name, "poles found again", 0, "", "", "", repeatability(shape.mesh, found));
    });
  });
}
