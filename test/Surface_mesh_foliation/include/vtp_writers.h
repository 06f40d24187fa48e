// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_VTP_WRITERS_H
#define SMF_TEST_VTP_WRITERS_H

#include "example_systems.h"

#include <CGAL/Surface_mesh_foliation/IO/write_component_coordinates.h>
#include <CGAL/Surface_mesh_foliation/IO/write_vtp.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace smf_test {

// all functions that write .vtp files, by what they write, and what they need
template <class TriangleMesh = Mesh>
struct Vtp_writers
{
  using Point = typename SMF::Loop_system<TriangleMesh>::Point;

  explicit Vtp_writers(const Example& example)
    : solved(example),
      embedding(SMF::reeb_graph_embedding(solved.foliation, SMF::parameters::number_of_samples(4)))
  {
    SMF::reeb_graph(solved.foliation, graph, embedding);
  }

  using Writer = std::function<void(const std::string&)>;
  std::vector<std::pair<std::string, Writer>> all() const
  {
    return {
      {"foliation", [&](const auto& file) { SMF::write_foliation_vtp(file, solved.foliation); }},
      {"components", [&](const auto& file) { SMF::write_components_vtp(file, solved.foliation); }},
      {"leaves",
       [&](const auto& file) { SMF::write_leaves_vtp(file, solved.foliation, embedding); }},
      {"coordinates",
       [&](const auto& file) {
         SMF::write_component_coordinates_vtp(
           file, SMF::Component_coordinates<TriangleMesh>(solved.foliation));
       }},
      {"skeleton", [&](const auto& file) { SMF::write_skeleton_vtp(file, graph); }},
      {"singularities",
       [&](const auto& file) { SMF::write_singularities_vtp(file, solved.foliation); }}};
  }

  Solved_example<TriangleMesh> solved;
  SMF::Reeb_graph_embedding<Point> embedding;
  SMF::Reeb_graph<Point> graph;
};

} // namespace smf_test

#endif // SMF_TEST_VTP_WRITERS_H
