// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/spoiled_foliations.h"

#include <CGAL/Surface_mesh_foliation/internal/Solver/settle_at_nodes.h>

#include <gtest/gtest.h>

#include <vector>

namespace test_settle_at_nodes {

using namespace CGAL::Surface_mesh_foliation::internal;

namespace {

class Settling_at_nodes : public smf_test::Spoiled_four_poles
{};

} // namespace

// What differs from a node by rounding only goes there, and nothing else.
TEST_F(Settling_at_nodes, vertices_beside_a_node_settle_there)
{
  Foliation_state& state = spoiled.state;
  settle_at_nodes(state); // on a sphere that is so regular, some vertices lie there
  EXPECT_FALSE(settle_at_nodes(state));
  EXPECT_TRUE(spoiled.problems().empty());
  for (const int arc : {0, 1, 2, 3})
  {
    const int end = state.system().nodes[state.system().nodes_of_arc[arc][0]].pole < 0 ? 0 : 1;
    const double height = state.system().height(arc);
    const auto distance = [&](int v) {
      return state.is_at_node(v) || state.arc(v) != arc ? height
             : end == 0                                 ? state.parameter(v)
                                                        : height - state.parameter(v);
    };
    int nearest = 0;
    for (int v = 0; v < state.mesh().number_of_vertices(); ++v)
      if (distance(v) < distance(nearest))
        nearest = v;
    state.set_parameter(nearest, end == 0 ? 1e-15 * height : (1 - 1e-15) * height);
    const std::vector<Cell> before = state.map().cell;
    EXPECT_TRUE(settle_at_nodes(state));
    EXPECT_TRUE(state.is_at_node(nearest) && state.node(nearest) == 4);
    for (int v = 0; v < state.mesh().number_of_vertices(); ++v)
      EXPECT_TRUE(v == nearest || state.map().cell[v] == before[v]);
    EXPECT_TRUE(spoiled.problems().empty());
  }
}

} // namespace test_settle_at_nodes
