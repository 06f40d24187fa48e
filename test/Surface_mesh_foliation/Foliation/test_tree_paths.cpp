// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Words of any length behave like deques, whether they lie in the array or in the table.

#include <CGAL/Surface_mesh_foliation/internal/Foliation/Cell.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Letter.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Tree_map.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Tree_paths.h>

#include "generators/Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <vector>

namespace test_tree_paths {

using CGAL::Surface_mesh_foliation::internal::Cell;
using CGAL::Surface_mesh_foliation::internal::Letter;
using CGAL::Surface_mesh_foliation::internal::Tree_paths;

namespace {

// a different one for each i >= 0
Letter some_letter(int i)
{
  return Letter(i / 2, i % 2);
}

void expect_equal(const Tree_paths& paths, int e, const std::deque<Letter>& letters)
{
  ASSERT_EQ(paths.size(e), static_cast<int>(letters.size()));
  EXPECT_EQ(paths.is_empty(e), letters.empty());
  for (std::size_t i = 0; i < letters.size(); ++i)
    EXPECT_EQ(paths(e, static_cast<int>(i)), letters[i]);
  if (!letters.empty())
  {
    EXPECT_EQ(paths.front(e), letters.front());
    EXPECT_EQ(paths.back(e), letters.back());
  }
}

} // namespace

TEST(Tree_paths, are_empty_at_first)
{
  const Tree_paths paths(3);
  for (int e : {0, 1, 2})
    expect_equal(paths, e, {});
}

TEST(Tree_paths, behave_like_deques)
{
  smf_test::Random random(5);
  constexpr int number_of_edges = 7;
  Tree_paths paths(number_of_edges);
  std::vector<std::deque<Letter>> letters(number_of_edges);
  std::size_t longest = 0;
  for (int step = 0; step < 20000; ++step)
  {
    const int e = static_cast<int>(random.index(number_of_edges));
    const Letter letter = some_letter(static_cast<int>(random.index(100)));
    // phases of growth and of decay, so that words pass the border of the array to and fro
    const bool grows = random.index(10) < (step / 500 % 2 == 0 ? 6u : 4u);
    const bool at_front = random.index(2) == 0;
    if (grows && at_front)
    {
      paths.push_front(e, letter);
      letters[e].push_front(letter);
    }
    else if (grows)
    {
      paths.push_back(e, letter);
      letters[e].push_back(letter);
    }
    else if (!letters[e].empty() && at_front)
    {
      paths.pop_front(e);
      letters[e].pop_front();
    }
    else if (!letters[e].empty())
    {
      paths.pop_back(e);
      letters[e].pop_back();
    }
    longest = std::max(longest, letters[e].size());
    expect_equal(paths, e, letters[e]);
  }
  EXPECT_GT(longest, 10u);
}

TEST(Tree_paths, copies_are_independent)
{
  Tree_paths paths(1);
  for (int i : {1, 2, 3, 4})
    paths.push_back(0, some_letter(i));
  Tree_paths copy = paths;
  copy.pop_front(0);
  copy.pop_back(0);
  copy.pop_back(0);
  expect_equal(paths, 0, {some_letter(1), some_letter(2), some_letter(3), some_letter(4)});
  expect_equal(copy, 0, {some_letter(2)});
}

TEST(Letter, is_an_end_of_a_lift)
{
  for (int lift : {0, 1, 17})
    for (int end : {0, 1})
    {
      const Letter letter(lift, end);
      EXPECT_FALSE(letter.is_none());
      EXPECT_EQ(letter.lift(), lift);
      EXPECT_EQ(letter.end(), end);
      EXPECT_TRUE(letter.other_end() == Letter(lift, 1 - end));
      EXPECT_TRUE(letter != letter.other_end());
      EXPECT_TRUE(letter != Letter(lift + 1, end));
    }
  EXPECT_TRUE(Letter().is_none());
}

TEST(Cell, is_an_arc_or_a_node)
{
  for (int i : {0, 1, 17})
  {
    const Cell arc = Cell::arc(i), node = Cell::at_node(i);
    EXPECT_FALSE(arc.is_node());
    EXPECT_EQ(arc.lift(), i);
    EXPECT_TRUE(node.is_node());
    EXPECT_EQ(node.node(), i);
    EXPECT_TRUE(arc == Cell::arc(i));
    EXPECT_TRUE(arc != node);
    EXPECT_TRUE(arc != Cell::arc(i + 1));
  }
}

TEST(Tree_map, inner_parameters_are_strictly_between_the_ends)
{
  using CGAL::Surface_mesh_foliation::internal::inner_parameter;
  for (double height : {1e-300, 1., 1e300})
  {
    EXPECT_EQ(inner_parameter(0.25 * height, height), 0.25 * height);
    for (double t : {-height, 0., height, 2 * height})
    {
      EXPECT_GT(inner_parameter(t, height), 0);
      EXPECT_LT(inner_parameter(t, height), height);
    }
  }
}

} // namespace test_tree_paths
