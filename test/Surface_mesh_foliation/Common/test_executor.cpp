// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Loops over blocks, and what is put together from them. (test_parallel runs them on threads.)

#include <CGAL/Surface_mesh_foliation/internal/Common/Executor.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/Sum.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/balanced_signs.h>

#include <gtest/gtest.h>

#include <vector>

namespace test_executor {

using namespace CGAL::Surface_mesh_foliation::internal;

TEST(Executor, blocks_follow_each_other_and_are_full_but_the_last)
{
  std::vector<std::vector<int>> blocks;
  executor_for<CGAL::Sequential_tag>()(
    25,
    [&](int block, int first, int last) {
      blocks.push_back({block, first, last});
    },
    10);
  EXPECT_EQ(blocks, (std::vector<std::vector<int>>{{0, 0, 10}, {1, 10, 20}, {2, 20, 25}}));
  EXPECT_EQ(Executor::number_of_blocks(0, 10), 0);
  EXPECT_EQ(Executor::number_of_blocks(10, 10), 1);
  EXPECT_EQ(Executor::number_of_blocks(11, 10), 2);
  EXPECT_EQ(Executor::number_of_blocks(2147483647, 8192), 262144);
}

TEST(Executor, lists_are_in_order)
{
  const int n = 3 * Executor::default_size + 5;
  const std::vector<int> twice = collected_numbers<int>(executor_for<CGAL::Sequential_tag>(), n,
                                                        [](int i, std::vector<int>& list) {
                                                          list.insert(list.end(), {i, i});
                                                        });
  ASSERT_EQ(twice.size(), 2u * n);
  for (int i = 0; i < 2 * n; ++i)
    ASSERT_EQ(twice[i], i / 2);
}

TEST(Sum, small_terms_are_not_lost)
{
  Sum sum;
  double plain = 1;
  sum.add(1);
  for (int i = 0; i < 1 << 20; ++i)
  {
    sum.add(1e-17); // less than half a unit of the last place of 1
    plain += 1e-17;
  }
  EXPECT_EQ(plain, 1);
  EXPECT_NEAR(sum.value() - 1, 1048576e-17, 3e-16);
}

// Two triangles of unknowns. In the first, one entry is positive whatever the signs are.
TEST(Balanced_signs, entries_along_a_tree_become_negative)
{
  Eigen::SparseMatrix<double> matrix(6, 6);
  const std::vector<Eigen::Triplet<double>> entries = {
    {0, 1, 1.}, {1, 0, 1.}, {0, 2, 1.},  {2, 0, 1.},  {1, 2, 1.}, {2, 1, 1.},
    {3, 4, 1.}, {4, 3, 1.}, {3, 5, -1.}, {5, 3, -1.}, {4, 5, 1.}, {5, 4, 1.}};
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd signs = balanced_signs(matrix);
  EXPECT_EQ(signs, (Eigen::VectorXd(6) << 1, -1, -1, 1, -1, 1).finished());
}

} // namespace test_executor
