// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_SOLVED_OPEN_MESHES_H
#define SMF_TEST_SOLVED_OPEN_MESHES_H

#include "include/open_meshes.h"

#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>

#include <memory>
#include <vector>

// Meshes with openings, and their harmonic foliations.

namespace smf_test {

namespace SMF = CGAL::Surface_mesh_foliation;

// solved; `mesh` stays where it is
struct Solved_open_mesh
{
  using Input = SMF::Poles_and_loops<Mesh>;
  using Graph = SMF::Reeb_graph<Mesh::Point>;

  explicit Solved_open_mesh(const Open_case& open)
    : Solved_open_mesh(open.soup, [&](const Mesh& m) { return openings_and_poles(m, open.poles); })
  {}

  template <class Make_input>
  Solved_open_mesh(const Triangle_soup& soup, const Make_input& make_input)
    : mesh(new Mesh(to_open_mesh(soup))),
      input(make_input(*mesh)),
      system(*mesh, input),
      foliation(SMF::harmonic_foliation(system))
  {}

  Graph graph() const
  {
    Graph result;
    SMF::reeb_graph(foliation, result);
    return result;
  }

  std::unique_ptr<Mesh> mesh;
  Input input;
  SMF::Loop_system<Mesh> system;
  SMF::Measured_foliation<Mesh> foliation;
};

// made once
inline const std::vector<Open_case>& all_cases()
{
  static const std::vector<Open_case> result = open_cases();
  return result;
}

} // namespace smf_test

#endif // SMF_TEST_SOLVED_OPEN_MESHES_H
