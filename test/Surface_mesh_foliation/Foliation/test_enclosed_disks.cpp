// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What lies behind a chord of an opening is moved to it, if it is a disk without pole.

#include "generators/Random.h"
#include "include/open_meshes.h"

#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/absorb_enclosed_disks.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/leaves_in_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Homotopy/Deck_cocycle.h>
#include <CGAL/Surface_mesh_foliation/internal/Homotopy/Lifts.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <set>
#include <string>
#include <utility>
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

void expect_only_these_and_poles_are_fixed(const internal::Flat_loop_system& system,
                                           const std::vector<int>& moved)
{
  std::set<int> expected(moved.begin(), moved.end());
  for (const internal::Pole& pole : system.poles)
    expected.insert(pole.begin(), pole.end());
  const internal::Foliation_state state(system,
                                        std::vector<double>(system.mesh.number_of_edges(), 1));
  for (int v = 0; v < system.mesh.number_of_vertices(); ++v)
    EXPECT_EQ(state.is_fixed(v), expected.count(v) > 0);
}

Open_case case_of_name(const std::string& name)
{
  for (const Open_case& open : smf_test::open_cases())
    if (open.name == name)
      return open;
  ADD_FAILURE() << "no case " << name;
  return smf_test::open_cases()[0];
}

// the same with other numbers of vertices
Open_case renamed(const Open_case& open, smf_test::Random& random)
{
  std::vector<std::size_t> number(open.soup.points.size());
  std::iota(number.begin(), number.end(), std::size_t(0));
  for (std::size_t i = number.size() - 1; i > 0; --i)
    std::swap(number[i], number[random.index(i + 1)]);
  Open_case result = open;
  for (std::size_t v = 0; v < number.size(); ++v)
    result.soup.points[number[v]] = open.soup.points[v];
  for (auto& triangle : result.soup.triangles)
    for (std::size_t& v : triangle)
      v = number[v];
  for (std::size_t& v : result.poles)
    v = number[v];
  return result;
}

} // namespace

TEST(Enclosed_disks, do_not_depend_on_numbers)
{
  smf_test::Random random(3);
  for (const Open_case& open : smf_test::open_cases())
    if (open.soup.points.size() < 1000)
    {
      SCOPED_TRACE(open.name);
      const std::size_t expected = number_of_absorbed_faces(Start(open));
      for (int i = 0; i < 10; ++i)
        EXPECT_EQ(number_of_absorbed_faces(Start(renamed(open, random))), expected);
    }
}

// The vertex inside an ear is the last one; one of its faces is split further.
TEST(Enclosed_disks, may_have_several_vertices)
{
  Open_case open = case_of_name("ear with a vertex");
  const std::size_t inside = open.soup.points.size() - 1, new_vertex = inside + 1;
  open.soup.points.push_back(open.soup.points[inside]);
  const auto face =
    std::find_if(open.soup.triangles.begin(), open.soup.triangles.end(),
                 [&](const auto& t) { return std::find(t.begin(), t.end(), inside) != t.end(); });
  ASSERT_NE(face, open.soup.triangles.end());
  const auto t = *face;
  open.soup.points.back() = open.soup.points[t[0]];
  for (std::size_t v : t)
    for (int axis : {0, 1, 2})
      open.soup.points.back()[axis] +=
        (open.soup.points[v][axis] - open.soup.points[t[0]][axis]) / 3;
  *face = {t[0], t[1], new_vertex};
  open.soup.triangles.push_back({t[1], t[2], new_vertex});
  open.soup.triangles.push_back({t[2], t[0], new_vertex});
  smf_test::Random random(4);
  for (int i = 0; i < 10; ++i)
  {
    Start start(renamed(open, random));
    EXPECT_EQ(number_of_absorbed_faces(start), 5u);
    const std::vector<int> moved = internal::absorb_enclosed_disks(start.system, start.map);
    EXPECT_EQ(std::set<int>(moved.begin(), moved.end()).size(), 2u);
  }
}

// A second opening takes the place of the only vertex that is a pole.
TEST(Enclosed_disks, are_found_where_all_poles_are_openings)
{
  Open_case open = case_of_name("ear with a vertex");
  const std::size_t apex = open.poles.at(0), last = open.soup.points.size() - 1;
  auto& triangles = open.soup.triangles;
  triangles.erase(
    std::remove_if(triangles.begin(), triangles.end(),
                   [&](const auto& t) { return std::find(t.begin(), t.end(), apex) != t.end(); }),
    triangles.end());
  for (auto& triangle : triangles)
    std::replace(triangle.begin(), triangle.end(), last, apex);
  std::swap(open.soup.points[apex], open.soup.points[last]);
  open.soup.points.pop_back();
  open.poles.clear();
  Start start(open);
  EXPECT_FALSE(internal::absorb_enclosed_disks(start.system, start.map).empty());
}

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
    expect_only_these_and_poles_are_fixed(start.system, moved);
  }
}

} // namespace test_enclosed_disks
