// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Symmetry (figure 17 of the paper): whether limbs that were marked as a pair ("foot" and "other
// foot") are exchanged by symmetries of the graphs, and the handles of a jug with three handles.
// There is one run of each shape.

#include "Command_line.h"
#include "Part_graph.h"
#include "Shapes.h"
#include "generators/jug.h"

#include <CGAL/Surface_mesh_foliation/reeb_graph_symmetries.h>

#include <cstddef>
#include <utility>
#include <vector>

using namespace smf_experiments;

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>; // of limbs

Pairs marked_pairs(const Shape& shape)
{
  Pairs result;
  for (std::size_t i = 0; i < shape.limbs.size(); ++i)
    for (std::size_t j = 0; j < shape.limbs.size(); ++j)
      if (shape.limbs[j].name == "other " + shape.limbs[i].name)
        result.emplace_back(i, j);
  return result;
}

std::size_t arc_at(const Shape& shape, const Part_graph& graph, Vertex v)
{
  return static_cast<std::size_t>(graph.arc_of_face[shape.mesh.face(shape.mesh.halfedge(v)).idx()]);
}

void print(const Shape& shape, const Pairs& pairs, const Named_graph& named)
{
  const std::vector<std::size_t> classes =
    SMF::reeb_graph_symmetries(named.graph.graph).arc_classes;
  std::size_t found = 0;
  for (const auto& [i, j] : pairs)
  {
    const std::size_t a = arc_at(shape, named.graph, shape.limbs[i].tip),
                      b = arc_at(shape, named.graph, shape.limbs[j].tip);
    found += a != b && classes[a] == classes[b] ? 1 : 0;
  }
  print_row(shape.name, named.name, named.persistence, named.graph.number_of_nodes(),
            named.graph.number_of_arcs(), pairs.size(), found);
}

// its limbs are the outermost vertices of the handles
Shape jug()
{
  auto [soup, tips] = smf_test::soups::jug_with_three_handles();
  Shape result;
  result.name = "jug";
  result.mesh = smf_test::to_mesh(soup);
  for (const std::size_t tip : tips)
    result.limbs.push_back({"handle", smf_test::vertex(tip), 0.1});
  mark_parts(result);
  return result;
}

int main(int argc, char* argv[])
{
  return run_experiment(argc, argv, 1, [](const Options& options) {
    print_row("shape", "graph", "persistence", "nodes", "arcs", "pairs", "pairs found");
    const auto print_all = [](const Shape& shape, const Pairs& pairs,
                              const std::vector<Named_graph>& graphs) {
      for (const Named_graph& named : graphs)
        print(shape, pairs, named);
    };
    if (options.shapes.empty())
    {
      const Shape shape = jug();
      const Pairs pairs = {{0, 1}, {1, 2}, {2, 0}};
      print_all(
        shape, pairs,
        all_graphs(shape.mesh, shape.up, shape.tips(), {0, 0.02, 0.1}, shape.part_of_vertex));
    }
    for_each_shape(options, [&](const Shape& shape) {
      const Pairs pairs = marked_pairs(shape);
      if (!pairs.empty())
        print_all(
          shape, pairs,
          all_graphs(shape.mesh, shape.up, shape.tips(), {0, 0.02, 0.1}, shape.part_of_vertex));
    });
  });
}
