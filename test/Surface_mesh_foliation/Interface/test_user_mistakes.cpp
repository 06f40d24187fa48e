// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Inputs that users come up with by mistake, or that look like one and are not.

#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/loops.h>

#include "include/random_systems.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace test_user_mistakes {

using namespace smf_test;

TEST(User_mistakes, a_vertex_of_another_mesh_is_no_pole)
{
  const Mesh mesh = icosphere(2);
  for (const Vertex stranger : {Vertex(99999), Mesh::null_vertex()})
  {
    Input input;
    input.add_pole(Vertex(0));
    input.add_pole(stranger);
    const std::vector<SMF::Problem> problems = SMF::validate(mesh, input);
    ASSERT_FALSE(problems.empty());
    EXPECT_EQ(problems[0].kind, SMF::Problem_kind::INVALID_POLE);
  }
}

// Two edges of a walk may belong to one triangle on its left. The pushed-off loop then takes the
// shortcut, and is the same up to homotopy as that of the walk along the third edge.
TEST(User_mistakes, an_edge_cycle_may_run_around_corners_of_triangles)
{
  const Mesh mesh = torus(12, 9, 3, 1);
  Random random(1);
  int number_of_detours = 0;
  while (number_of_detours < 10)
    for (const Item& item : Random_items(mesh, random)())
    {
      if (item.kind != Item::CYCLE)
        continue;
      std::vector<Vertex> walk, detour;
      for (std::size_t v : item.vertices)
        walk.push_back(Vertex(static_cast<Mesh::size_type>(v)));
      // around the triangle to the right of the first edge, which so comes to lie to the left
      const auto h = halfedge(walk[0], walk[1], mesh).first;
      const Vertex corner = target(next(opposite(h, mesh), mesh), mesh);
      if (std::find(walk.begin(), walk.end(), corner) != walk.end())
        continue;
      detour = walk;
      detour.insert(detour.begin() + 1, corner);
      Input straight_input, detour_input;
      straight_input.add_loop(SMF::loop_from_edge_cycle(walk, mesh));
      detour_input.add_loop(SMF::loop_from_edge_cycle(detour, mesh));
      const SMF::Loop_system<Mesh> straight(mesh, straight_input), around(mesh, detour_input);
      EXPECT_NEAR(SMF::harmonic_foliation(straight).statistics().energy,
                  SMF::harmonic_foliation(around).statistics().energy, 1e-9);
      ++number_of_detours;
    }
}

} // namespace test_user_mistakes
