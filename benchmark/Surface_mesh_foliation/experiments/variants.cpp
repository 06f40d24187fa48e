// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Stability under changes of the mesh (figure 16 of the paper): each posed shape, compared with its
// variants in other resolutions, with noise, and with bad triangles. Runs: the number of variants.

#include "Command_line.h"
#include "Part_graph.h"
#include "Parts.h"
#include "Shapes.h"
#include "Variants.h"

#include <cstddef>
#include <vector>

using namespace smf_experiments;

std::vector<Named_graph> graphs_of(const Mesh& mesh,
                                   int up,
                                   const std::vector<Vertex>& poles,
                                   const std::vector<int>& part_of_vertex)
{
  return all_graphs(mesh, up, poles, {0, 0.02, 0.1}, part_of_vertex);
}

void compare(const Shape& shape,
             const std::vector<Named_graph>& base,
             const Places& places,
             const Variant& variant)
{
  const Mesh& mesh = variant.mesh;
  const std::vector<Named_graph> other =
    graphs_of(mesh, shape.up, nearest_vertices(shape.mesh, shape.tips(), mesh),
              places.parts_of_vertices(mesh, shape.part_of_face));
  const std::vector<Face> nearest = places.nearest_faces(mesh);
  const std::vector<double> areas = face_areas(mesh);
  for (std::size_t kind = 0; kind < base.size(); ++kind)
  {
    const Named_graph& named = base[kind];
    const Part_graph &before = named.graph, &after = other[kind].graph;
    std::vector<int> carried;
    for (const Face f : nearest)
      carried.push_back(before.arc_of_face[f.idx()]);
    print_row(shape.name, variant.kind, variant.name, num_vertices(mesh), named.name,
              named.persistence, are_isomorphic(before, after),
              Overlaps(carried, after.arc_of_face, areas).agreement(0.8));
  }
}

int main(int argc, char* argv[])
{
  return run_experiment(argc, argv, 1000, [](const Options& options) {
    print_row("shape", "kind", "variant", "vertices", "graph", "persistence", "isomorphic",
              "arcs that agree");
    for_each_shape(options, [&](const Shape& shape) {
      if (!shape.is_posed)
        return;
      const std::vector<Named_graph> base =
        graphs_of(shape.mesh, shape.up, shape.tips(), shape.part_of_vertex);
      const Places places(shape.mesh);
      std::size_t runs = 0;
      for_each_variant(shape, [&](const Variant& variant) {
        if (runs++ < options.runs)
          compare(shape, base, places, variant);
      });
    });
  });
}
