// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Surface_mesh_foliation/internal/Homotopy/Surface_group.h>

#include "generators/Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <vector>

namespace test_surface_group {

using namespace CGAL::Surface_mesh_foliation::internal;

namespace {

Group_word random_word(smf_test::Random& random, int rank, std::size_t max_length)
{
  Group_word result;
  for (std::size_t i = random.index(max_length + 1); i > 0; --i)
  {
    const int letter = 1 + static_cast<int>(random.index(rank));
    multiply(result, {random.index(2) == 0 ? letter : -letter});
  }
  return result;
}

// [1,2][3,4]...
Group_word standard_relator(int genus)
{
  Group_word result;
  for (int i = 1; i < 2 * genus; i += 2)
    result.insert(result.end(), {i, i + 1, -i, -i - 1});
  return result;
}

// a product of conjugates of the relator and its inverse
Group_word trivial_word(smf_test::Random& random, int genus)
{
  Group_word result;
  for (std::size_t i = 1 + random.index(4); i > 0; --i)
  {
    Group_word relator = standard_relator(genus);
    std::rotate(relator.begin(), relator.begin() + random.index(relator.size()), relator.end());
    const Group_word way = random_word(random, 2 * genus, 6);
    multiply(result, way);
    multiply(result, random.index(2) == 0 ? relator : inverse(relator));
    multiply(result, inverse(way));
  }
  return result;
}

// how often each generator occurs, counted with sign: a homomorphism to an abelian group
std::vector<int> abelianized(const Group_word& word, int rank)
{
  std::vector<int> result(rank, 0);
  for (int letter : word)
    result[std::abs(letter) - 1] += letter > 0 ? 1 : -1;
  return result;
}

} // namespace

TEST(Surface_group, free_words_cancel)
{
  const Surface_group group(3);
  EXPECT_TRUE(group.is_free());
  EXPECT_EQ(group.rank(), 3);
  EXPECT_EQ(Surface_group().rank(), 0);
  EXPECT_EQ(group.product({1, 2}, {-2, 3}), Group_word({1, 3}));
  EXPECT_TRUE(group.product({1, -2, 3}, inverse({1, -2, 3})).empty());
  EXPECT_FALSE(group.are_equal({1, 2}, {2, 1}));
}

TEST(Surface_group, cyclic_reduction_removes_conjugation)
{
  EXPECT_EQ(cyclically_reduced({1, 2, 3, -2, -1}), Group_word({3}));
  EXPECT_EQ(cyclically_reduced({1, 2, -1}), Group_word({2}));
  EXPECT_EQ(cyclically_reduced({1, 2}), Group_word({1, 2}));
  EXPECT_EQ(cyclically_reduced({1, 1}), Group_word({1, 1}));
  for (const Group_word& word : {Group_word{}, Group_word{1, -1}, Group_word{1, 2, -2, -1}})
    EXPECT_TRUE(cyclically_reduced(word).empty());
}

TEST(Surface_group, torus_is_abelian)
{
  const Surface_group group(2, {1, 2, -1, -2});
  EXPECT_TRUE(group.is_abelian());
  EXPECT_TRUE(group.are_equal({1, 2, 1}, {2, 1, 1}));
  EXPECT_TRUE(group.product({1, 2}, {-1, -2}).empty());
  EXPECT_FALSE(group.are_equal({1}, {2}));
  EXPECT_FALSE(group.are_equal({1}, {-1}));
}

// What is more than half of the relator, wherever it begins, is replaced by what is left of it.
TEST(Surface_group, dehns_algorithm_shortens)
{
  const Surface_group group(4, standard_relator(2));
  EXPECT_EQ(group.product({1, 2, -1, -2, 3}, {}), Group_word({4, 3, -4}));
  EXPECT_EQ(group.product({1, 1, 2, -1, -2, 3}, {}), Group_word({1, 4, 3, -4}));
  EXPECT_EQ(group.product({1, 2, -1, -2, 3, 3}, {}), Group_word({4, 3, -4, 3}));
  EXPECT_EQ(group.product({-4, 1, 2, -1, -2}, {}), Group_word({3, -4, -3}));
  EXPECT_EQ(group.product({4, 3, -4, -3, 2}, {}), Group_word({1, 2, -1}));
  EXPECT_EQ(group.product({1, 2, -1, -2}, {}), Group_word({1, 2, -1, -2})); // half of it stays
  for (int turns : {1, 2, 3})
  {
    Group_word word = {3};
    for (int i = 0; i < turns; ++i)
      multiply(word, standard_relator(2));
    EXPECT_EQ(group.product(word, {}), Group_word{3});
  }
}

TEST(Surface_group, consequences_of_the_relator_are_trivial)
{
  smf_test::Random random(7);
  for (int genus = 1; genus <= 6; ++genus)
  {
    const Surface_group group(2 * genus, standard_relator(genus));
    for (int i = 0; i < 2000; ++i)
    {
      const Group_word trivial = trivial_word(random, genus);
      EXPECT_TRUE(group.product(trivial, {}).empty());
      const Group_word word = random_word(random, 2 * genus, 12);
      Group_word other = word;
      multiply(other, trivial);
      EXPECT_TRUE(group.are_equal(word, other));
      EXPECT_TRUE(group.are_equal(group.product(other, {}), word));
    }
  }
}

// What differs in the abelian quotient differs, and a simple closed curve is not null-homotopic,
// even where the quotient does not see it: [1,2] on genus >= 2.
TEST(Surface_group, other_words_are_not_trivial)
{
  smf_test::Random random(8);
  for (int genus = 2; genus <= 6; ++genus)
  {
    const Surface_group group(2 * genus, standard_relator(genus));
    EXPECT_FALSE(group.are_equal({1, 2, -1, -2}, {}));
    EXPECT_FALSE(group.are_equal({1, 2}, {2, 1}));
    for (int i = 0; i < 2000; ++i)
    {
      const Group_word word = random_word(random, 2 * genus, 12);
      const Group_word other = group.product(random_word(random, 2 * genus, 12), {});
      if (abelianized(word, 2 * genus) != abelianized(other, 2 * genus))
      {
        EXPECT_FALSE(group.are_equal(word, other));
      }
    }
  }
}

} // namespace test_surface_group
