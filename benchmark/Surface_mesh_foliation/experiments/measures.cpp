// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What graphs measure, under changes of the mesh (figure 16 of the paper): fluxes and lengths of
// all arcs of the star and of the graph with canonical loops, and the moduli of canonical loops, on
// each posed shape and on its variants. There are rows only for variants whose graph is the same.
// Runs: the number of variants.

#include "Command_line.h"
#include "Part_graph.h"
#include "Shapes.h"
#include "Variants.h"

#include <CGAL/Surface_mesh_foliation/reeb_graph_matching.h>

#include <cstddef>
#include <vector>

using namespace smf_experiments;

struct Result
{
  Part_graph star, canonical;
  std::vector<double> moduli; // by loop of the canonical graph
};

Result results_of(const Mesh& mesh,
                  const std::vector<Vertex>& poles,
                  const std::vector<int>& part_of_vertex)
{
  const auto [loops, moduli] = canonical_loops_and_moduli(mesh, poles);
  return {graph_of_foliation(mesh, with_poles(poles), part_of_vertex),
          graph_of_foliation(mesh, loops, part_of_vertex), moduli};
}

// calls `visit(arc, other arc)` with each arc of a graph and its counterpart in another one, if the
// graphs are the same
template <class Visit>
void for_each_pair_of_arcs(const Part_graph& before, const Part_graph& after, Visit visit)
{
  if (const auto matching = SMF::match_reeb_graphs(before.graph, after.graph))
    for (const auto& [first, second] : matching->arcs)
      visit(before.graph[first], after.graph[second]);
}

void compare(const Shape& shape, const Result& base, const Places& places, const Variant& variant)
{
  const Result other =
    results_of(variant.mesh, nearest_vertices(shape.mesh, shape.tips(), variant.mesh),
               places.parts_of_vertices(variant.mesh, shape.part_of_face));
  using Arc = SMF::Reeb_arc<Point>;
  const auto print = [&](const char* graph, const Arc& arc, const char* quantity, double before,
                         double after) {
    print_row(shape.name, variant.kind, variant.name, graph, arc.loop, quantity, before, after);
  };
  const auto print_arc = [&](const char* graph, const Arc& before, const Arc& after) {
    print(graph, before, "flux", before.flux, after.flux);
    print(graph, before, "length", SMF::length(before.polyline), SMF::length(after.polyline));
  };
  for_each_pair_of_arcs(base.star, other.star, [&](const Arc& before, const Arc& after) {
    print_arc("ours (star)", before, after);
  });
  for_each_pair_of_arcs(base.canonical, other.canonical, [&](const Arc& before, const Arc& after) {
    const char* graph = "ours (canonical loops)";
    print_arc(graph, before, after);
    if (base.moduli[before.loop] > 0) // not of a pole
      print(graph, before, "modulus", base.moduli[before.loop], other.moduli[after.loop]);
  });
}

int main(int argc, char* argv[])
{
  return run_experiment(argc, argv, 1000, [](const Options& options) {
    print_row("shape", "kind", "variant", "graph", "arc", "quantity", "before", "after");
    for_each_shape(options, [&](const Shape& shape) {
      if (!shape.is_posed)
        return;
      const Result base = results_of(shape.mesh, shape.tips(), shape.part_of_vertex);
      const Places places(shape.mesh);
      std::size_t runs = 0;
      for_each_variant(shape, [&](const Variant& variant) {
        if (runs++ < options.runs)
          compare(shape, base, places, variant);
      });
    });
  });
}
