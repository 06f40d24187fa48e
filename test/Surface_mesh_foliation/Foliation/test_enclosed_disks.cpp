// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What lies behind a chord of an opening is moved to it, if it is a disk without pole.

#include "include/open_meshes.h"

#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/absorb_enclosed_disks.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/leaves_in_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Homotopy/Deck_cocycle.h>
#include <CGAL/Surface_mesh_foliation/internal/Homotopy/Lifts.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace test_enclosed_disks {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
namespace internal = SMF::internal;
using smf_test::Mesh;
using smf_test::Open_case;

// the map whose leaves lie in the loops
struct Start
{
  explicit Start(const Open_case& open)
    : mesh(smf_test::to_open_mesh(open.soup)),
      loops(mesh, smf_test::openings_and_poles(mesh, open.poles)),
      system(loops.data().flat),
      deck(system.mesh, system.poles),
      lifts(deck),
      map(internal::leaves_in_loops(system, deck, lifts))
  {}

  Mesh mesh;
  SMF::Loop_system<Mesh> loops;
  const internal::Flat_loop_system& system;
  internal::Deck_cocycle deck;
  internal::Lifts lifts;
  internal::Tree_map map;
};

std::size_t number_of_absorbed_faces(const Start& start)
{
  const internal::Enclosed_disks enclosed(start.system, start.map);
  std::size_t result = 0;
  for (const auto& disk : enclosed.disks())
    result += disk.faces.size();
  return result;
}

} // namespace

TEST(Enclosed_disks, are_the_ears)
{
  for (const Open_case& open : smf_test::open_cases())
  {
    SCOPED_TRACE(open.name);
    Start start(open);
    const std::size_t faces = number_of_absorbed_faces(start);
    EXPECT_EQ(faces > 0, open.has_ears);
    if (open.name == "ear")
    {
      EXPECT_EQ(faces, 1u);
    }
    if (open.name == "ear with a vertex")
    {
      EXPECT_EQ(faces, 3u);
    }
    if (open.name == "ears" || open.name == "thin strip")
    {
      EXPECT_EQ(faces, 5u);
    }

    // the vertices inside are moved to the pole, and no edge there passes an arc
    const std::vector<internal::Cell> before = start.map.cell;
    const internal::Enclosed_disks enclosed(start.system, start.map);
    const std::vector<int> moved = internal::absorb_enclosed_disks(start.system, start.map);
    EXPECT_EQ(!moved.empty(), open.name == "ear with a vertex" || open.name == "ears");
    for (int v = 0; v < start.system.mesh.number_of_vertices(); ++v)
      if (std::find(moved.begin(), moved.end(), v) == moved.end())
      {
        EXPECT_EQ(start.map.cell[v], before[v]);
      }
    for (const auto& disk : enclosed.disks())
      for (int f : disk.faces)
        for (int h : start.system.mesh.halfedges(f))
        {
          EXPECT_TRUE(start.map.paths.is_empty(internal::edge_of(h)));
          EXPECT_EQ(
            start.map.cell[start.system.mesh.source(h)],
            internal::Cell::at_node(start.system.node_of_vertex[start.system.poles[disk.pole][0]]));
        }
  }
}

} // namespace test_enclosed_disks
