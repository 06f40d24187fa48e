// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "minima.h"
#include "require.h"
#include "systems_from_bytes.h"
#include "targets.h"

#include <CGAL/Surface_mesh_foliation/Leaf_tracer.h>
#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/components.h>
#include <CGAL/Surface_mesh_foliation/curve_skeleton.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/leaves.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_embedding.h>
#include <CGAL/Surface_mesh_foliation/singularities.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <vector>

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
using namespace smf_fuzz;
using Point_3 = smf_test::Kernel::Point_3;

void check_results(const Foliation& foliation)
{
  const System& system = foliation.system();
  SMF::Reeb_graph<Point_3> graph;
  const auto embedding = SMF::reeb_graph_embedding(foliation);
  SMF::reeb_graph(foliation, graph, embedding);
  require(num_vertices(graph) == system.number_of_nodes() &&
            num_edges(graph) == system.number_of_arcs(),
          "the graph is not the dual graph");
  Mesh components;
  SMF::surface_components(foliation, components);
  require(components.is_valid(), "invalid components");
  std::vector<SMF::Singularity<Mesh>> singularities;
  SMF::singularities(foliation, std::back_inserter(singularities));
  std::vector<SMF::Critical_polyline<Point_3>> leaves;
  SMF::critical_leaves(foliation, std::back_inserter(leaves));
  SMF::Leaf_tracer<Mesh> tracer(foliation);
  for (std::size_t arc = 0; arc < system.number_of_arcs(); ++arc)
    SMF::leaf(foliation, arc, system.height(arc) / 2);
}

} // namespace

// Poles, borders, loops and heights on a small mesh; the foliation and its graph, if they form a
// system.
void smf_fuzz::loop_systems(const std::uint8_t* data, std::size_t size)
{
  FuzzedDataProvider bytes(data, size);
  const std::optional<Mesh> mesh = mesh_from_bytes(bytes, 24);
  if (!mesh)
    return;
  Loops_from_bytes source(*mesh, bytes);
  std::vector<Entry> entries = source.openings();
  add_entries(*mesh, source, bytes.ConsumeIntegralInRange<std::size_t>(0, 9), entries);
  const bool has_odd_heights = bytes.ConsumeIntegral<std::uint8_t>() % 8 == 7;
  for (Entry& entry : entries)
    if (has_odd_heights && bytes.ConsumeBool())
      entry.height = source.odd_height();

  if (is_printing())
    print(*mesh, entries);
  std::optional<System> system;
  if (!survives([&] { system.emplace(*mesh, to_input(entries)); }))
    return;
  std::optional<Foliation> foliation;
  const bool is_solved =
    survives([&] { foliation = SMF::harmonic_foliation(*system); }, !has_odd_heights);
  require(is_solved || has_odd_heights, "a loop system without a foliation");
  if (!is_solved)
    return;
  if (has_odd_heights)
    require(foliation->statistics().is_certified, "no certificate");
  else
    require_minimum(*foliation);
  require(survives([&] { check_results(*foliation); }), "a foliation without results");
}
