// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Families of parallel loops: the order in which a sweep with poles comes to vertices, which
// families are given up because they are homotopic, and which because a handle is short.

#include <CGAL/Surface_mesh_foliation/internal/Automatic_loops/Loop_families.h>
#include <CGAL/Surface_mesh_foliation/internal/Automatic_loops/Sweep.h>
#include <CGAL/Surface_mesh_foliation/internal/Automatic_loops/fill_short_handles.h>

#include <gtest/gtest.h>

#include <array>
#include <utility>
#include <vector>

namespace test_loop_families {

namespace {

namespace internal = CGAL::Surface_mesh_foliation::internal;

TEST(Sweep, vertices_of_a_pole_are_consecutive)
{
  const internal::Sweep sweep({5, 1, 4, 1, 0, 4}, {{2, 0}, {5}, {1}});
  std::vector<int> vertices;
  for (int r = 0; r < 6; ++r)
    vertices.push_back(sweep.order().vertex(r));
  EXPECT_EQ(vertices, (std::vector<int>{4, 3, 1, 2, 0, 5}));
  EXPECT_EQ(sweep.value(0), 4);
  EXPECT_EQ(sweep.pole_of_vertex(3), -1);
  EXPECT_TRUE(sweep.meets_pole(4));
  EXPECT_FALSE(sweep.meets_pole(3));
  EXPECT_EQ(sweep.level_between(4, 5), 3); // halfway is at value 2
  EXPECT_EQ(sweep.level_between(2, 5), 5); // not between 2 and 0
  EXPECT_EQ(sweep.level_between(2, 0), -1);
}

using Families = internal::Loop_families;

std::vector<int> alive(const Families& families)
{
  std::vector<int> result;
  for (int f = 0; f < families.number_of_families(); ++f)
    if (families.family(f).is_alive)
      result.push_back(f);
  return result;
}

// a disk - pants = pants - disk; the weights are those of four families
Families torus_families(const std::array<double, 4>& weights)
{
  Families families;
  for (int r = 0; r < 4; ++r)
    families.add_piece();
  families.add_family(0, 1, {weights[0], 0});
  families.add_family(1, 2, {weights[1], 0});
  families.add_family(1, 2, {weights[2], 0});
  families.add_family(2, 3, {weights[3], 0});
  return families;
}

TEST(Loop_families, the_heavier_of_two_homotopic_ones_stays)
{
  for (int heavy : {1, 2})
  {
    Families families = torus_families({9, heavy == 1 ? 2. : 1., heavy == 1 ? 1. : 2., 9});
    families.reduce(false);
    EXPECT_EQ(alive(families), std::vector<int>{heavy});
  }
}

TEST(Loop_families, poles_keep_families_apart)
{
  for (const bool is_punctured : {false, true})
  {
    Families families = torus_families({1, 1, 1, 1});
    for (int piece : {0, 3, 3})
      families.add_pole(piece);
    families.reduce(is_punctured);
    EXPECT_EQ(alive(families),
              is_punctured ? (std::vector<int>{1, 2, 3}) : (std::vector<int>{1, 2}));
  }
}

TEST(Fill_short_handles, all_of_the_cycle_goes)
{
  // a theta graph of two pants with a short and two long families, and a bridge that is shorter
  const auto theta = [] {
    Families families;
    for (int r = 0; r < 4; ++r)
      families.add_piece();
    for (const auto& [u, v] : {std::pair{0, 1}, {0, 1}, {0, 2}, {1, 3}, {2, 2}, {3, 3}})
      families.add_family(u, v, {1, 0});
    return families;
  };
  const std::vector<double> lengths = {3, 10, 1, 1, 5, 6};
  const auto filled = [&](double bound) {
    Families families = theta();
    internal::fill_short_handles(families, lengths, bound, false);
    return alive(families);
  };
  EXPECT_EQ(filled(2).size(), 6u); // bridges are no handles
  EXPECT_EQ(filled(4), (std::vector<int>{2, 4, 5}));
  EXPECT_EQ(filled(5.5), std::vector<int>{5});
  EXPECT_TRUE(filled(7).empty());
}

} // namespace

} // namespace test_loop_families
