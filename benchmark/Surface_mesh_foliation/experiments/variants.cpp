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

#include <CGAL/Surface_mesh_foliation/reeb_graph_matching.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

using namespace smf_experiments;

// The graphs of one mesh, and the moduli of the canonical loops of the given poles.
struct Result
{
  std::vector<Named_graph> graphs;
  std::vector<double> moduli;
};

Result results_of(const Mesh& mesh,
                  int up,
                  const std::vector<Vertex>& poles,
                  const std::vector<int>& part_of_vertex)
{
  Result result;
  result.graphs = all_graphs(mesh, up, poles, {0, 0.02, 0.1}, part_of_vertex);
  result.moduli = canonical_moduli(mesh, poles);
  return result;
}

double change(double before, double after)
{
  return std::abs(after - before) / before;
}

// the largest change of a quantity of matched arcs, or nothing if the graphs do not match
template <class Quantity>
std::string largest_change(const Part_graph& before,
                           const Part_graph& after,
                           const Quantity& quantity)
{
  const auto matching = SMF::match_reeb_graphs(before.graph, after.graph);
  if (!matching)
    return "";
  double result = 0;
  for (const auto& [first, second] : matching->arcs)
    result =
      (std::max)(result, change(quantity(before.graph[first]), quantity(after.graph[second])));
  return std::to_string(result);
}

std::string largest_change(const std::vector<double>& before, const std::vector<double>& after)
{
  if (before.size() != after.size() || before.empty())
    return "";
  double result = 0;
  for (std::size_t i = 0; i < before.size(); ++i)
    result = (std::max)(result, change(before[i], after[i]));
  return std::to_string(result);
}

void compare(const Shape& shape, const Result& base, const Places& places, const Variant& variant)
{
  const Mesh& mesh = variant.mesh;
  const Result other = results_of(mesh, shape.up, nearest_vertices(shape.mesh, shape.tips(), mesh),
                                  places.parts_of_vertices(mesh, shape.part_of_face));
  const std::vector<Face> nearest = places.nearest_faces(mesh);
  const std::vector<double> areas = face_areas(mesh);
  for (std::size_t kind = 0; kind < base.graphs.size(); ++kind)
  {
    const Named_graph& named = base.graphs[kind];
    const Part_graph &before = named.graph, &after = other.graphs[kind].graph;
    std::vector<int> carried;
    for (const Face f : nearest)
      carried.push_back(before.arc_of_face[f.idx()]);
    const bool is_ours = named.is_of_foliation();
    using Arc = SMF::Reeb_arc<Point>;
    print_row(shape.name, variant.kind, variant.name, num_vertices(mesh), named.name,
              named.persistence, are_isomorphic(before, after),
              Overlaps(carried, after.arc_of_face, areas).agreement(0.8),
              is_ours ? largest_change(before, after, [](const Arc& arc) { return arc.flux; }) : "",
              is_ours ? largest_change(before, after,
                                       [](const Arc& arc) { return SMF::length(arc.polyline); })
                      : "",
              is_ours ? largest_change(base.moduli, other.moduli) : "");
  }
}

int main(int argc, char* argv[])
{
  return run_experiment(argc, argv, 1000, [](const Options& options) {
    print_row("shape", "kind", "variant", "vertices", "graph", "persistence", "isomorphic",
              "arcs that agree", "change of flux", "change of length", "change of modulus");
    for_each_shape(options, [&](const Shape& shape) {
      if (!shape.is_posed)
        return;
      const Result base = results_of(shape.mesh, shape.up, shape.tips(), shape.part_of_vertex);
      const Places places(shape.mesh);
      std::size_t runs = 0;
      for_each_variant(shape, [&](const Variant& variant) {
        if (runs++ < options.runs)
          compare(shape, base, places, variant);
      });
    });
  });
}
