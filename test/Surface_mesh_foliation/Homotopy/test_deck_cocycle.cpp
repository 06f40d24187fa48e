// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Pole.h>
#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/internal/Homotopy/Deck_cocycle.h>
#include <CGAL/Surface_mesh_foliation/internal/Homotopy/Lifts.h>

#include "include/flat_meshes.h"
#include "include/random_systems.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace test_deck_cocycle {

using namespace CGAL::Surface_mesh_foliation::internal;
using namespace smf_test;

namespace {

// the product of the elements around a vertex, counterclockwise
Group_word around(const Flat_mesh& mesh, const Deck_cocycle& deck, int v)
{
  Group_word result;
  for (int h : mesh.ring(v))
    result = deck.group().product(result, deck.element(opposite_of(h)));
  return result;
}

class Deck_cocycle_of_genus : public testing::TestWithParam<int>
{};

} // namespace

TEST_P(Deck_cocycle_of_genus, relations_hold_at_all_vertices_but_poles)
{
  const int genus = GetParam();
  const Flat_mesh mesh = flat_mesh(to_soup(genus_surface(genus, 2)));
  for (int number_of_poles = genus == 0 ? 2 : 0; number_of_poles < 6; ++number_of_poles)
  {
    std::vector<Pole> poles;
    for (int p = 0; p < number_of_poles; ++p)
      poles.push_back({7 * p + 3});
    const Deck_cocycle deck(mesh, poles);
    EXPECT_EQ(deck.group().rank(), 2 * genus + (poles.empty() ? 0 : number_of_poles - 1));
    EXPECT_EQ(deck.group().is_free(), !poles.empty());
    for (int v = 0; v < mesh.number_of_vertices(); ++v)
    {
      const bool is_pole = v % 7 == 3 && v / 7 < number_of_poles;
      EXPECT_EQ(around(mesh, deck, v).empty(), !is_pole) << "vertex " << v;
    }
  }
}

// The way from the frame of a vertex to that of an edge does not depend on the direction of the
// walk.
TEST_P(Deck_cocycle_of_genus, transports_agree_with_walks_around_vertices)
{
  const Flat_mesh mesh = flat_mesh(to_soup(genus_surface(GetParam(), 1)));
  const std::vector<Pole> poles = {{0}, {5}};
  const Deck_cocycle deck(mesh, poles);
  for (int v = 0; v < mesh.number_of_vertices(); ++v)
  {
    if (v == 0 || v == 5)
      continue;
    Group_word way; // clockwise
    for (int i = mesh.degree(v), h = mesh.ring(v)[0]; i > 0; --i)
    {
      const Group_word to_edge = is_forward(h) ? way : deck.group().product(way, deck.element(h));
      EXPECT_TRUE(deck.group().are_equal(to_edge, deck.word(deck.transport(h))));
      way = deck.group().product(way, deck.element(h));
      h = mesh.next(opposite_of(h));
    }
    EXPECT_TRUE(way.empty());
  }
}

INSTANTIATE_TEST_SUITE_P(Genera, Deck_cocycle_of_genus, testing::Values(0, 1, 2, 3, 5));

// A line is one puncture: the product of the elements around the line as a whole is a generator or
// a product of conjugates of the others, never 1, and the rank counts it once.
TEST(Deck_cocycle, line_pole_is_one_puncture)
{
  const Mesh sphere = icosphere(2);
  const Flat_mesh mesh = flat_mesh(to_soup(sphere));
  const int a = mesh.target(mesh.ring(0)[0]);
  int b = -1;
  for (int h : mesh.ring(a))
    if (mesh.target(h) != 0 && mesh.find_halfedge(0, mesh.target(h)) < 0)
      b = mesh.target(h);
  const std::vector<Pole> poles = {{0, a, b}, {100}, {120}};
  const Deck_cocycle deck(mesh, poles);
  EXPECT_EQ(deck.group().rank(), 2);
  for (int v = 0; v < mesh.number_of_vertices(); ++v)
    if (v != 0 && v != a && v != b && v != 100 && v != 120)
    {
      EXPECT_TRUE(around(mesh, deck, v).empty());
    }
  const Flat_loop loop = tight_loop(mesh, poles[0], 0, 1);
  Group_word translation;
  for (const Flat_crossing& crossing : loop.crossings)
    translation = deck.group().product(translation, deck.element(crossing.halfedge));
  EXPECT_FALSE(translation.empty());
}

// Lifts are told apart by their names, and transport along a way and back is the identity.
TEST(Lifts_of_deck_cocycle, transport_is_invertible)
{
  const Flat_mesh mesh = flat_mesh(to_soup(genus_surface(3, 1)));
  for (const std::vector<Pole>& poles : {std::vector<Pole>{}, std::vector<Pole>{{0}, {9}}})
  {
    const Deck_cocycle deck(mesh, poles);
    Lifts lifts(deck);
    const int lift = lifts.intern(0, {1});
    EXPECT_EQ(lifts.intern(0, {1}), lift);
    EXPECT_NE(lifts.intern(1, {1}), lift);
    EXPECT_NE(lifts.intern(0, {2, 1, -2}), lift);
    for (int h = 0; h < mesh.number_of_halfedges(); ++h)
    {
      const int there = lifts.transport(lift, deck.transport(h), false);
      EXPECT_EQ(lifts.transport(there, deck.transport(h), true), lift);
    }
  }
}

} // namespace test_deck_cocycle
