// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The default linear solver, on matrices of many graphs, beside dense computations.

#include "generators/Random.h"
#include "generators/meshes.h"
#include "generators/soups.h"

#include <CGAL/Surface_mesh_foliation/Simplicial_cholesky_solver.h>
#include <CGAL/Surface_mesh_foliation/Supernodal_cholesky_solver.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Elimination_tree.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Supernodal_cholesky_solver.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Supernodal_factor.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Supernodes.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Updated_solutions.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/dense_ldlt.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_supernodal_cholesky_solver {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
using namespace smf_test;
using SMF::Supernodal_cholesky_solver;
using SMF::internal::Elimination_tree;
using SMF::internal::Supernodes;
using Matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;
using Pairs = std::set<std::pair<int, int>>;

// the lower triangle of a matrix with random entries at these pairs, the larger index first, that
// is positive definite
Matrix matrix(int size, const Pairs& pairs, std::uint64_t seed)
{
  Random random(seed);
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<double> diagonal(static_cast<std::size_t>(size), 0.5);
  for (const auto& [i, j] : pairs)
  {
    const double value = random.between(-1, 1);
    entries.emplace_back(i, j, value);
    diagonal[static_cast<std::size_t>(i)] += std::abs(value);
    diagonal[static_cast<std::size_t>(j)] += std::abs(value);
  }
  for (int i = 0; i < size; ++i)
    entries.emplace_back(i, i, diagonal[static_cast<std::size_t>(i)]);
  Matrix result(size, size);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

struct Example
{
  std::string name;
  Matrix matrix;
};

std::vector<Example> examples()
{
  std::vector<Example> result;
  const auto add = [&](const std::string& name, int size, const Pairs& pairs) {
    result.push_back({name, matrix(size, pairs, result.size() + 1)});
  };
  add("one", 1, {});
  add("many parts", 20000, {{1, 0}, {19999, 19990}});
  add("diagonal", 7, {});
  add("two parts", 6, {{1, 0}, {2, 1}, {4, 3}, {5, 4}});
  Pairs path, star, complete, dense_tail;
  for (int i = 1; i < 90; ++i)
  {
    path.insert({i, i - 1});
    star.insert({i, 0});
    for (int j = 0; j < i; ++j)
      complete.insert({i, j});
    for (int j = i < 50 ? i - 1 : 40; j < i; ++j)
      dense_tail.insert({i, j});
  }
  add("path", 90, path);
  add("star", 90, star);
  add("complete", 90, complete);
  add("dense tail", 90, dense_tail);
  for (const auto& [name, soup] :
       {std::pair<std::string, Triangle_soup>{"sphere", soups::icosphere(3)},
        {"torus", soups::torus(40, 25, 3, 1)},
        {"limbs", soups::limbed_sphere(5, 4)}})
  {
    Pairs edges;
    for (const auto& [a, b, c] : soup.triangles)
      for (const auto& [i, j] : {std::pair(a, b), {b, c}, {c, a}})
        edges.insert({static_cast<int>(std::max(i, j)), static_cast<int>(std::min(i, j))});
    add(name, static_cast<int>(soup.points.size()), edges);
  }
  Random random(5);
  for (int k = 0; k < 30; ++k)
  {
    const int size = 1 + static_cast<int>(random.index(60));
    Pairs pairs;
    for (std::size_t i = random.index(150); i > 0; --i)
    {
      const int a = static_cast<int>(random.index(static_cast<std::size_t>(size))),
                b = static_cast<int>(random.index(static_cast<std::size_t>(size)));
      if (a != b)
        pairs.insert({std::max(a, b), std::min(a, b)});
    }
    add("random " + std::to_string(k), size, pairs);
  }
  return result;
}

Eigen::MatrixXd dense(const Matrix& lower)
{
  return lower.selfadjointView<Eigen::Lower>() *
         Eigen::MatrixXd::Identity(lower.rows(), lower.cols());
}

// the same in the order of elimination
Eigen::MatrixXd ordered(const Matrix& lower, const Elimination_tree& tree)
{
  const Eigen::MatrixXd whole = dense(lower);
  Eigen::MatrixXd result(whole.rows(), whole.cols());
  for (int k = 0; k < tree.size(); ++k)
    for (int l = 0; l < tree.size(); ++l)
      result(k, l) = whole(tree.unknown(k), tree.unknown(l));
  return result;
}

Vector right_side(Eigen::Index size)
{
  Random random(9);
  Vector result(size);
  for (double& x : result)
    x = random.between(-1, 1);
  return result;
}

} // namespace

// The tree is a postorder, and tells which entries of the factor are not zero.
TEST(Elimination_tree, is_that_of_the_factor)
{
  for (const auto& [name, lower] : examples())
  {
    if (lower.rows() > 200)
      continue;
    SCOPED_TRACE(name);
    const Elimination_tree tree(lower);
    std::vector<int> places = tree.places();
    for (int k = 0; k < tree.size(); ++k)
      EXPECT_EQ(places[static_cast<std::size_t>(tree.unknown(k))], k);
    // eliminated with values that never cancel
    Eigen::MatrixXd pattern = ordered(lower, tree).cwiseAbs();
    for (int k = 0; k < tree.size(); ++k)
    {
      int parent = Elimination_tree::NONE, height = 1;
      for (int i = k + 1; i < tree.size(); ++i)
        if (pattern(i, k) != 0)
        {
          parent = height == 1 ? i : parent;
          ++height;
          for (int j = k + 1; j < tree.size(); ++j)
            pattern(i, j) += pattern(j, k) != 0;
        }
      EXPECT_EQ(tree.parent(k), parent);
      EXPECT_EQ(tree.height(k), height);
      // descendants are the places just before
      int number = 1;
      for (int i = 0; i < k; ++i)
      {
        int j = i;
        while (j != Elimination_tree::NONE && j < k)
          j = tree.parent(j);
        number += j == k;
      }
      for (int i = k - number + 1; i < k; ++i)
      {
        EXPECT_NE(tree.parent(i), Elimination_tree::NONE);
        EXPECT_LE(tree.parent(i), k);
      }
    }
  }
}

TEST(Supernodes, have_all_rows_of_their_columns)
{
  for (const auto& [name, lower] : examples())
  {
    SCOPED_TRACE(name);
    const Elimination_tree tree(lower);
    const Supernodes supernodes(tree);
    EXPECT_EQ(supernodes.first(0), 0);
    EXPECT_EQ(supernodes.first(supernodes.size()), tree.size());
    double entries = 0, stored = 0;
    for (int s = 0; s < supernodes.size(); ++s)
    {
      ASSERT_GT(supernodes.width(s), 0);
      const int* const rows = supernodes.rows(s);
      const int* const end = rows + supernodes.number_of_rows(s);
      EXPECT_TRUE(std::is_sorted(rows, end));
      EXPECT_TRUE(rows == end || *rows >= supernodes.first(s + 1));
      for (int k = supernodes.first(s); k < supernodes.first(s + 1); ++k)
      {
        EXPECT_EQ(supernodes.of_column(k), s);
        entries += tree.height(k);
        stored += supernodes.height(s) - (k - supernodes.first(s));
        // the rows of a column are on the path to the root
        const int parent = tree.parent(k);
        EXPECT_TRUE(parent == Elimination_tree::NONE || parent < supernodes.first(s + 1) ||
                    std::binary_search(rows, end, parent));
      }
      if (supernodes.parent(s) != Supernodes::NONE)
      {
        EXPECT_GT(supernodes.parent(s), s);
      }
    }
    EXPECT_GE(stored, entries);
    EXPECT_LE(stored, (lower.rows() > 200 ? 1.5 : 5) * entries); // zeros of merged columns
  }
}

TEST(Supernodal_cholesky_solver, solves)
{
  for (const auto& [name, lower] : examples())
  {
    SCOPED_TRACE(name);
    Supernodal_cholesky_solver solver;
    EXPECT_FALSE(solver.factorize(lower)); // not analyzed
    solver.analyze_pattern(lower);
    ASSERT_TRUE(solver.factorize(lower));
    const Vector b = right_side(lower.rows());
    const auto residual = [&](const Matrix& m, const Vector& x) {
      return (m.selfadjointView<Eigen::Lower>() * x - b).cwiseAbs().maxCoeff();
    };
    const Vector x = solver.solve(b);
    EXPECT_LT(residual(lower, x), 1e-13);
    ASSERT_TRUE(solver.factorize(lower)); // again, to the last bit
    EXPECT_EQ(solver.solve(b), x);
    const Matrix other = 3. * lower;
    ASSERT_TRUE(solver.factorize(other));
    EXPECT_LT(residual(other, solver.solve(b)), 1e-13);
    // with a matrix that is not positive definite, but whose pivots are not zero
    Matrix indefinite = lower;
    indefinite.coeffRef(0, 0) = -10;
    ASSERT_TRUE(solver.factorize(indefinite));
    EXPECT_LT(residual(indefinite, solver.solve(b)), 1e-11);
  }
}

TEST(Supernodal_cholesky_solver, reports_pivots_that_are_zero_or_no_numbers)
{
  for (const auto& [name, lower] : examples())
  {
    SCOPED_TRACE(name);
    Supernodal_cholesky_solver solver;
    solver.analyze_pattern(lower);
    EXPECT_FALSE(solver.factorize(Matrix(0. * lower)));
    Matrix bad = lower;
    bad.coeffRef(lower.rows() - 1, lower.rows() - 1) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(solver.factorize(bad));
    ASSERT_TRUE(solver.factorize(lower));
    solver.clear();
    EXPECT_FALSE(solver.factorize(lower));
  }
}

// L^-1 P e_i, row by row of the factor
TEST(Supernodal_cholesky_solver, gives_columns_of_the_inverse_factor)
{
  Random random(7);
  for (const auto& [name, lower] : examples())
  {
    SCOPED_TRACE(name);
    Supernodal_cholesky_solver solver;
    solver.analyze_pattern(lower);
    ASSERT_TRUE(solver.factorize(lower));
    const int n = static_cast<int>(lower.rows());
    std::set<int> some;
    for (int i = 0; i < 5; ++i)
      some.insert(static_cast<int>(random.index(static_cast<std::size_t>(n))));
    const std::vector<int> unknowns(some.begin(), some.end());
    const std::vector<int> rows = solver.forward_rows(unknowns);
    EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end()));
    const Eigen::MatrixXd columns = solver.forward_columns(unknowns, rows);
    for (std::size_t c = 0; c < unknowns.size(); ++c)
    {
      Vector expected = solver.forward(Vector::Unit(n, unknowns[c]));
      for (std::size_t i = 0; i < rows.size(); ++i)
      {
        EXPECT_NEAR(columns(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(c)),
                    expected[rows[i]], 1e-14);
        expected[rows[i]] = 0;
      }
      EXPECT_EQ(expected.cwiseAbs().maxCoeff(), 0);
    }
    // A = P^T L D L^T P
    const Vector b = right_side(n);
    const Vector z = solver.forward(b);
    double energy = 0;
    for (int k = 0; k < n; ++k)
      energy += z[k] * z[k] / solver.pivot(k);
    EXPECT_NEAR(energy, b.dot(solver.solve(b)), 1e-12 * std::abs(energy));
    EXPECT_GE(solver.work_of_factorization(), n);
  }
}

TEST(Supernodal_cholesky_solver, is_that_of_eigen_up_to_rounding)
{
  for (const auto& [name, lower] : examples())
  {
    SMF::Simplicial_cholesky_solver other;
    other.analyze_pattern(lower);
    ASSERT_TRUE(other.factorize(lower));
    Supernodal_cholesky_solver solver;
    solver.analyze_pattern(lower);
    ASSERT_TRUE(solver.factorize(lower));
    const Vector b = right_side(lower.rows());
    EXPECT_LT((solver.solve(b) - other.solve(b)).cwiseAbs().maxCoeff(), 1e-12) << name;
  }
}

TEST(Supernodal_cholesky_solver, is_updated)
{
  for (const auto& [name, lower] : examples())
  {
    if (lower.rows() < 200 || lower.nonZeros() < 3 * lower.rows())
      continue; // there a factorization is less work
    SCOPED_TRACE(name);
    Supernodal_cholesky_solver solver;
    solver.analyze_pattern(lower);
    ASSERT_TRUE(solver.factorize(lower));
    SMF::internal::Updated_solutions updated(solver);
    Matrix changed = lower;
    SMF::internal::Matrix_change change;
    const Vector b = right_side(lower.rows());
    for (const int column : {3, 100, 57})
    {
      const int row = lower.innerIndexPtr()[lower.outerIndexPtr()[column] + 1];
      const double value = -2 * lower.coeff(row, column);
      change.entries.push_back({row, column, value});
      changed.coeffRef(row, column) += value;
      const std::optional<Vector> x = updated(b, change);
      ASSERT_TRUE(x);
      EXPECT_LT((changed.selfadjointView<Eigen::Lower>() * *x - b).cwiseAbs().maxCoeff(), 1e-12);
    }
  }
}

// All sizes of blocks, through plain loops and through Eigen's products.
TEST(Dense_ldlt, factors_blocks)
{
  Random random(8);
  Eigen::MatrixXd scratch;
  const SMF::internal::Executor executor;
  for (const int height : {1, 2, 5, 31, 32, 33, 64, 100, 150})
    for (const int width : {1, 2, 31, 32, 33, 64, 90})
    {
      if (width > height)
        continue;
      SCOPED_TRACE(std::to_string(height) + ' ' + std::to_string(width));
      Eigen::MatrixXd whole(height, height);
      for (int i = 0; i < height; ++i)
        for (int j = 0; j <= i; ++j)
          whole(i, j) = whole(j, i) = i == j ? height + 1 : random.between(-1, 1);
      Eigen::MatrixXd block = whole.leftCols(width);
      Vector pivots(width);
      ASSERT_TRUE(
        SMF::internal::factor_panel(block.data(), height, width, pivots.data(), scratch, executor));
      Eigen::MatrixXd l = Eigen::MatrixXd::Zero(height, width);
      for (int j = 0; j < width; ++j)
      {
        l(j, j) = 1;
        l.col(j).tail(height - j - 1) = block.col(j).tail(height - j - 1);
      }
      const Eigen::MatrixXd product = l * pivots.asDiagonal() * l.transpose();
      EXPECT_LT((product - whole).leftCols(width).cwiseAbs().maxCoeff(), 1e-11);
      const int rest = height - width;
      if (rest == 0)
        continue;
      Eigen::MatrixXd square = whole.bottomRightCorner(rest, rest);
      SMF::internal::subtract_square(SMF::internal::Const_dense_block(block.data() + width, rest,
                                                                      width,
                                                                      Eigen::OuterStride<>(height)),
                                     pivots.data(), square.data(), scratch, executor);
      const Eigen::MatrixXd expected = (whole - product).bottomRightCorner(rest, rest);
      for (int j = 0; j < rest; ++j)
        EXPECT_LT((square - expected).col(j).tail(rest - j).cwiseAbs().maxCoeff(), 1e-11);
    }
}

} // namespace test_supernodal_cholesky_solver
