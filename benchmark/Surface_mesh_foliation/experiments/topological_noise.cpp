// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Topological noise (figures 7a and 18 of the paper): each posed shape without handles, compared
// with itself with one to five tunnels, or bridges. Cycles of functions are simplified like
// extrema. Runs: the largest number of handles.

#include "Command_line.h"
#include "Cycle_simplification.h"
#include "Part_graph.h"
#include "Parts.h"
#include "Shapes.h"
#include "Tubes.h"
#include "Variants.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

using namespace smf_experiments;

std::vector<Named_graph> graphs(const Mesh& mesh,
                                int up,
                                const std::vector<Vertex>& poles,
                                const std::vector<int>& part_of_vertex)
{
  std::vector<Named_graph> result;
  for (Named_graph& named : graphs_of_functions(mesh, up, poles, {0, 0.02, 0.1}, part_of_vertex))
  {
    if (named.persistence > 0)
      named.graph = without_small_cycles(named.graph, named.persistence);
    result.push_back(std::move(named));
  }
  const auto add = [&](const std::string& name, const SMF::Poles_and_loops<Mesh>& input) {
    result.push_back({name, 0, graph_of_foliation(mesh, input, part_of_vertex)});
  };
  add("ours (star)", with_poles(poles));
  add("ours (canonical loops but no handles)", with_canonical_loops(mesh, poles, {false}));
  add("ours (canonical loops)", with_canonical_loops(mesh, poles));
  return result;
}

void compare(const Shape& shape,
             const std::vector<Named_graph>& base,
             const Places& places,
             const std::string& kind,
             const std::vector<Pair_of_faces>& tubes)
{
  const Mesh mesh = with_tubes(shape.mesh, tubes);
  const std::vector<Named_graph> others =
    graphs(mesh, shape.up, shape.tips(), places.parts_of_vertices(mesh, shape.part_of_face));
  const std::vector<Face> nearest = places.nearest_faces(mesh);
  const std::vector<double> areas = face_areas(mesh);
  for (std::size_t i = 0; i < base.size(); ++i)
  {
    const Part_graph &before = base[i].graph, &after = others[i].graph;
    std::vector<int> carried;
    for (const Face f : nearest)
      carried.push_back(before.arc_of_face[f.idx()]);
    print_row(shape.name, kind, tubes.size(), base[i].name, base[i].persistence,
              before.number_of_nodes(), after.number_of_nodes(), after.number_of_cycles(),
              are_isomorphic(before, after),
              Overlaps(carried, after.arc_of_face, areas).agreement(0.8));
  }
}

int main(int argc, char* argv[])
{
  return run_experiment(argc, argv, 5, [](const Options& options) {
    print_row("shape", "kind", "handles", "graph", "persistence", "nodes before", "nodes", "cycles",
              "isomorphic", "arcs that agree");
    for_each_shape(options, [&](const Shape& shape) {
      if (!shape.is_posed || smf_test::genus(shape.mesh) > 0)
        return;
      const std::vector<Named_graph> base =
        graphs(shape.mesh, shape.up, shape.tips(), shape.part_of_vertex);
      const Places places(shape.mesh);
      for (std::size_t n = 1; n <= options.runs; ++n)
      {
        compare(shape, base, places, "tunnels", Tube_places(shape, n).tunnels(n));
        compare(shape, base, places, "bridges", Tube_places(shape, n).bridges(n));
      }
    });
  });
}
