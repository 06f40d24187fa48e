// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The lifts of loops: which are one and the same, and what they are called in other frames.

#include <CGAL/Surface_mesh_foliation/internal/Homotopy/Deck_cocycle.h>
#include <CGAL/Surface_mesh_foliation/internal/Homotopy/Lifts.h>

#include "include/flat_systems.h"
#include "generators/genus_soups.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace test_lifts {

using namespace smf_test;
using namespace CGAL::Surface_mesh_foliation::internal;

namespace {

const std::vector<Pole> four_poles = {{0}, {1}, {2}, {3}}; // of the tetrahedron: free of rank 3

} // namespace

TEST(Lifts, of_one_loop_are_equal_iff_their_names_are)
{
  const Flat_mesh mesh = flat_mesh(soups::tetrahedron());
  const Deck_cocycle deck(mesh, four_poles);
  ASSERT_EQ(deck.group().rank(), 3);
  Lifts lifts(deck);
  const int a = lifts.intern(0, {1}), b = lifts.intern(0, {2, 1, -2}), c = lifts.intern(2, {1});
  EXPECT_EQ(std::set<int>({a, b, c}).size(), 3u);
  EXPECT_EQ(lifts.intern(0, {1}), a);
  EXPECT_EQ(lifts.intern(0, {2, 1, -2}), b);
  EXPECT_EQ(lifts.intern(2, {1}), c);
  EXPECT_EQ(lifts.arc(a), 0);
  EXPECT_EQ(lifts.arc(c), 2);
  EXPECT_EQ(lifts.name(b), (Group_word{2, 1, -2}));
  EXPECT_NE(lifts.intern(0, {-1}), a); // loops have directions
}

TEST(Lifts, names_are_conjugated_by_the_way)
{
  const Flat_mesh mesh = flat_mesh(soups::tetrahedron());
  const Deck_cocycle deck(mesh, four_poles);
  const Lifts lifts(deck);
  EXPECT_EQ(lifts.transported({1}, {}), Group_word{1});
  EXPECT_EQ(lifts.transported({1}, {2}), (Group_word{-2, 1, 2}));
  EXPECT_EQ(lifts.transported({1}, {1, 1}), Group_word{1}); // along the lift itself
  EXPECT_EQ(lifts.transported({2, 1, -2}, {2}), Group_word{1});
  EXPECT_EQ(lifts.transported(lifts.transported({1, 3}, {2, -1}), {1, -2}), (Group_word{1, 3}));
}

TEST(Lifts, transport_there_and_back_is_nothing)
{
  const Flat_mesh mesh = flat_mesh(soups::seven_vertex_torus());
  const Deck_cocycle deck(mesh, {{0}});
  Lifts lifts(deck);
  const int lift = lifts.intern(1, {1, 2});
  int number_of_ways = 0;
  for (int h = 0; h < mesh.number_of_halfedges(); ++h)
  {
    const int element = deck.transport(h);
    const int there = lifts.transport(lift, element, false);
    EXPECT_EQ(lifts.arc(there), 1);
    EXPECT_EQ(lifts.name(there), lifts.transported({1, 2}, deck.word(element)));
    EXPECT_EQ(lifts.transport(there, element, true), lift);
    EXPECT_EQ(lifts.transport(lift, element, false), there); // remembered
    number_of_ways += element != 0;
    if (element == 0)
    {
      EXPECT_EQ(there, lift);
    }
  }
  EXPECT_GT(number_of_ways, 0);
}

// On a torus the group is abelian, conjugation changes nothing, and lifts are counted along a line.
TEST(Lifts, of_a_torus_without_pole_are_numbers)
{
  const Flat_mesh mesh = flat_mesh(soups::seven_vertex_torus());
  const Deck_cocycle deck(mesh, {});
  ASSERT_TRUE(deck.group().is_abelian());
  Lifts lifts(deck);
  EXPECT_EQ(lifts.transported({1}, {1, 2}), Group_word{1}); // without a loop, nothing is crossed
  lifts.set_torus_loop({1, 1, -2});                         // of class (2, -1)
  // (x, y) crosses it x * -1 - y * 2 times
  EXPECT_EQ(lifts.transported({}, {1}), Group_word{1});
  EXPECT_EQ(lifts.transported({}, {2}), (Group_word{1, 1}));
  EXPECT_EQ(lifts.transported({}, {1, 1, -2}), Group_word{}); // along the loop
  EXPECT_EQ(lifts.transported({1, 1}, {-1, -2, -2}), (Group_word{-1, -1, -1}));
  EXPECT_EQ(lifts.transported({-1}, {1}), Group_word{});
  Lifts others(deck);
  others.set_torus_loop({-1, 2, 2, 2, 2, 2, -1, -1}); // of class (-3, 5)
  EXPECT_EQ(others.transported({1}, {1, 1}), Group_word(9, -1));
  EXPECT_EQ(others.transported({1}, {2, 2}), Group_word(5, -1));
  const int zero = lifts.intern(0, {}), two = lifts.intern(0, {1, 1});
  EXPECT_NE(zero, two);
  EXPECT_EQ(lifts.intern(0, {1, 1}), two);
}

// With two handles an element has several words: a prefix of the relator, and the inverse of the
// rest.
TEST(Lifts, of_a_closed_surface_are_compared_as_group_elements)
{
  const Flat_mesh mesh = flat_mesh(soups::genus_surface(2, 1));
  const Deck_cocycle deck(mesh, {});
  ASSERT_EQ(deck.group().rank(), 4);
  // the words of four letters that occur in the relator are those with another word of four
  Lifts lifts(deck);
  const std::vector<int> letters = {1, 2, 3, 4, -1, -2, -3, -4};
  int number_of_words = 0, number_of_others = 0;
  const auto visit = [&](const Group_word& word) {
    const int lift = lifts.intern(0, word);
    ++number_of_words;
    number_of_others += lifts.name(lift) != word;
    EXPECT_TRUE(deck.group().are_equal(lifts.name(lift), word));
  };
  for (int a : letters)
    for (int b : letters)
      for (int c : letters)
        for (int d : letters)
          if (a != -b && b != -c && c != -d)
            visit({a, b, c, d});
  EXPECT_EQ(number_of_words, 8 * 7 * 7 * 7);
  // 8 places of the relator and 8 of its inverse, in pairs of equal words
  EXPECT_EQ(number_of_others, 8);
}

} // namespace test_lifts
