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
  using Point = typename smf::Loop_system<TriangleMesh>::Point;

  explicit Vtp_writers(const Example& example)
    : solved(example),
      embedding(smf::reeb_graph_embedding(solved.foliation, smf::parameters::number_of_samples(4)))
  {
    smf::reeb_graph(solved.foliation, graph, embedding);
  }

  using Writer = std::function<void(const std::string&)>;
  std::vector<std::pair<std::string, Writer>> all() const
  {
    return {
      {"foliation", [&](const auto& file) { smf::write_foliation_vtp(file, solved.foliation); }},
      {"components", [&](const auto& file) { smf::write_components_vtp(file, solved.foliation); }},
      {"leaves",
       [&](const auto& file) { smf::write_leaves_vtp(file, solved.foliation, embedding); }},
      {"coordinates",
       [&](const auto& file) {
         smf::write_component_coordinates_vtp(
           file, smf::Component_coordinates<TriangleMesh>(solved.foliation));
       }},
      {"skeleton", [&](const auto& file) { smf::write_skeleton_vtp(file, graph); }},
      {"singularities",
       [&](const auto& file) { smf::write_singularities_vtp(file, solved.foliation); }}};
  }

  Solved_example<TriangleMesh> solved;
  smf::Reeb_graph_embedding<Point> embedding;
  smf::Reeb_graph<Point> graph;
};

} // namespace smf_test

#endif // SMF_TEST_VTP_WRITERS_H
