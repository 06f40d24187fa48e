// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The measures by which the experiments compare segmentations, against small cases and against
// counting pairs of faces.

#include "benchmark/Surface_mesh_foliation/experiments/Parts.h"
#include "generators/Random.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace test_segment_overlaps {

namespace {

using smf_experiments::Overlaps;
using Segments = std::vector<int>;

// four faces: two in each segment, against one and three
const Segments halves = {0, 0, 1, 1}, quarters = {5, 7, 7, 7};
const std::vector<double> areas = {1, 1, 1, 1};

TEST(Segment_overlaps, pairs_overlap_by_the_share_of_their_union)
{
  const Overlaps overlaps(halves, quarters, areas); // 1 of 2, and 2 of 3
  EXPECT_EQ(overlaps.number_of_pairs(0.5), 2U);
  EXPECT_EQ(overlaps.number_of_pairs(0.6), 1U);
  EXPECT_EQ(overlaps.number_of_pairs(0.7), 0U);
  EXPECT_DOUBLE_EQ(overlaps.agreement(0.6), 0.5);
  EXPECT_DOUBLE_EQ(Overlaps(halves, halves, areas).agreement(1), 1);
}

TEST(Segment_overlaps, areas_count)
{
  const Overlaps overlaps(halves, quarters, {9, 1, 1, 9}); // 9 of 10, and 10 of 11
  EXPECT_EQ(overlaps.number_of_pairs(0.9), 2U);
}

TEST(Segment_overlaps, a_limb_is_found_alone_if_no_other_limb_is_in_its_segment)
{
  const Segments limbs = {0, 1, 2, 2}; // and 2 is the rest
  EXPECT_TRUE(Overlaps({0, 1, 1, 1}, limbs, areas).is_found_alone(0, 2, 0.8));
  EXPECT_TRUE(Overlaps({0, 1, 1, 1}, limbs, areas).is_found_alone(1, 2, 0.8));
  EXPECT_FALSE(Overlaps({0, 0, 1, 1}, limbs, areas).is_found_alone(0, 2, 0.8));
  // a limb that is cut in two is not found
  EXPECT_FALSE(Overlaps({0, 1, 2, 3}, {0, 0, 2, 2}, areas).is_found_alone(0, 2, 0.8));
}

TEST(Segment_overlaps, hamming_difference_is_the_area_outside_the_largest_overlaps)
{
  // of halves 1 + 2 of 4 faces lie in the largest overlaps, and of quarters 1 + 2
  EXPECT_DOUBLE_EQ(Overlaps(halves, quarters, areas).hamming_difference(), 0.25);
  EXPECT_DOUBLE_EQ(Overlaps(halves, halves, areas).hamming_difference(), 0);
}

TEST(Segment_overlaps, rand_difference_is_that_of_pairs_of_faces)
{
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
  {
    smf_test::Random random(seed);
    constexpr std::size_t n = 30;
    Segments first, second;
    std::vector<double> area;
    for (std::size_t f = 0; f < n; ++f)
    {
      first.push_back(static_cast<int>(random.index(4)));
      second.push_back(static_cast<int>(random.index(3)));
      area.push_back(random.between(0.1, 1));
    }
    double different = 0, all = 0;
    for (std::size_t f = 0; f < n; ++f)
      for (std::size_t g = 0; g < n; ++g)
      {
        all += area[f] * area[g];
        if ((first[f] == first[g]) != (second[f] == second[g]))
          different += area[f] * area[g];
      }
    EXPECT_NEAR(Overlaps(first, second, area).rand_difference(), different / all, 1e-12);
  }
}

} // namespace

} // namespace test_segment_overlaps
