// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The linear systems inside the solver, against energies and dense matrices, and edge weights
// against triangles of known angles.

#include <CGAL/Surface_mesh_foliation/internal/Foliation/lengths.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Simplicial_cholesky_solver.h>
#include <CGAL/Surface_mesh_foliation/Simplicial_cholesky_solver.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/Shared_array.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Closest_signs.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Factored_matrix.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Newton_system.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/balance.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/grow_fronts.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Updated_solutions.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/weights_of_flat_mesh.h>

#include "include/flat_meshes.h"
#include "include/flat_states.h"
#include "include/flat_systems.h"
#include "generators/Random.h"
#include "generators/genus_soups.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace test_newton_system {

using namespace smf_test;
using namespace CGAL::Surface_mesh_foliation::internal;
using CGAL::Surface_mesh_foliation::Simplicial_cholesky_solver;
using Vector = Eigen::VectorXd;

// ===  Newton_system.h, Factored_matrix.h

namespace {

struct Counting_solver : Simplicial_cholesky_solver
{
  int analyses = 0, factorizations = 0;

  void analyze_pattern(const Eigen::SparseMatrix<double>& matrix)
  {
    ++analyses;
    Simplicial_cholesky_solver::analyze_pattern(matrix);
  }
  bool factorize(const Eigen::SparseMatrix<double>& matrix)
  {
    ++factorizations;
    return Simplicial_cholesky_solver::factorize(matrix);
  }
};

void move(Foliation_state& state, const Vector& step, double share = 1)
{
  for (int v = 0; v < state.mesh().number_of_vertices(); ++v)
    if (state.is_free_in_arc(v))
      state.set_parameter(v, state.parameter(v) + share * step[v]);
}

// the energy if the vertices had gone the given share of the step
double energy_after(Foliation_state& state, const Vector& step, double share)
{
  move(state, step, share);
  const double result = energy_of(state);
  move(state, step, -share);
  return result;
}

} // namespace

TEST(Newton_system, a_step_minimizes_the_quadratic)
{
  const Flat_loop_system system =
    flat_system(soups::midpoint_subdivided(soups::octahedron()), {{4}, {5}});
  Random random(11);
  std::vector<double> weights;
  for (int e = 0; e < system.mesh.number_of_edges(); ++e)
    weights.push_back(random.between(0.5, 2));
  Foliation_state state(system, weights);
  grow_fronts(state);
  for (int v = 0; v < system.mesh.number_of_vertices(); ++v)
    if (state.is_free_in_arc(v))
      state.set_parameter(v, random.between(0.9, 1.1));
  Counting_solver solver;
  Factored_matrix<Counting_solver> matrix(solver);
  Newton_system<Counting_solver> newton(state, matrix);
  const Vector step = newton.step();
  EXPECT_EQ(solver.factorizations, 1);
  for (int pole : {4, 5})
    EXPECT_EQ(step[pole], 0);
  // no word changes, so the energy is this quadratic; at its beginning it falls by the slope
  const double h = 1e-5;
  EXPECT_LT(newton.slope(), 0);
  EXPECT_NEAR((energy_after(state, step, h) - energy_after(state, step, -h)) / (2 * h),
              newton.slope(), 1e-6 * std::abs(newton.slope()));
  const double least = energy_after(state, step, 1);
  EXPECT_LT(least, energy_of(state));
  EXPECT_NEAR(least, energy_of(state) + newton.slope() / 2, 1e-12 * least);
  move(state, step);
  EXPECT_LT(balance(state).optimality, 1e-14);
  EXPECT_LT(newton.step().cwiseAbs().maxCoeff(), 1e-13); // from the minimum nowhere
  EXPECT_EQ(solver.factorizations, 1);                   // with the same matrix
}

TEST(Newton_system, vertices_at_nodes_and_fixed_ones_do_not_move)
{
  Equator e({0.5, 1.75, 1, 1});
  e.state.move_to_node(0, e.state.half_arc(0, 0)); // at the pole above
  e.state.fix(1);
  Simplicial_cholesky_solver solver;
  Factored_matrix<Simplicial_cholesky_solver> matrix(solver);
  const Vector step = Newton_system<Simplicial_cholesky_solver>(e.state, matrix).step();
  for (int v : {0, 1, 4, 5})
    EXPECT_EQ(step[v], 0);
  for (int v : {2, 3}) // between 0, 2, 0 and 1.75
    EXPECT_DOUBLE_EQ(step[v], 3.75 / 4 - 1);
}

TEST(Newton_system, goes_on_with_an_old_matrix_and_a_new_state)
{
  Counting_solver solver;
  Factored_matrix<Counting_solver> matrix(solver);
  const auto step_from = [&](const std::vector<double>& t, double weight) {
    Equator e(t, weight);
    return Newton_system<Counting_solver>(e.state, matrix).step();
  };
  const std::vector<double> t = {0.5, 0.25, 1, 1.75};
  const Vector step = step_from(t, 1);
  EXPECT_EQ(step, step_from(t, 1));
  EXPECT_EQ(solver.analyses, 1);
  EXPECT_EQ(solver.factorizations, 1);
  for (int v : equator)
    EXPECT_NEAR(t[v] + step[v], 1, 1e-15);
  step_from(t, 2); // other weights
  EXPECT_EQ(solver.analyses, 1);
  EXPECT_EQ(solver.factorizations, 2);
  matrix.clear();
  EXPECT_FALSE(matrix.is_factored());
  EXPECT_EQ(step, step_from(t, 1));
  EXPECT_EQ(solver.analyses, 2);
  EXPECT_EQ(solver.factorizations, 3);
}

// ===  Closest_signs.h

namespace {

struct Signed_mesh
{
  Flat_mesh mesh;
  std::vector<signed char> signs, agreement;

  Signed_mesh(const Triangle_soup& soup, Random& random) : mesh(flat_mesh(soup))
  {
    for (int v = 0; v < mesh.number_of_vertices(); ++v)
      signs.push_back(random.index(2) == 0 ? 1 : -1);
    for (int e = 0; e < mesh.number_of_edges(); ++e)
      agreement.push_back(product(signs, e));
  }

  signed char product(const std::vector<signed char>& s, int e) const
  {
    return static_cast<signed char>(s[mesh.source(halfedge_of(e))] *
                                    s[mesh.target(halfedge_of(e))]);
  }

  // crosses edges of random faces, one after another
  int turn_along_walk(Random& random, int steps)
  {
    int f = static_cast<int>(random.index(static_cast<std::size_t>(mesh.number_of_faces())));
    for (int i = 0; i < steps; ++i)
    {
      const int h = mesh.halfedges(f)[random.index(3)];
      signed char& a = agreement[edge_of(h)];
      a = static_cast<signed char>(-a);
      f = mesh.face(opposite_of(h));
    }
    return steps;
  }

  int number_of_misfits() const
  {
    const Closest_signs closest(mesh, agreement);
    int result = 0;
    for (int e = 0; e < mesh.number_of_edges(); ++e)
      result += product(closest.signs(), e) * agreement[e] < 0;
    return result;
  }
};

const std::vector<Triangle_soup> soups_of_all_genera = {
  soups::midpoint_subdivided(soups::midpoint_subdivided(soups::octahedron())),
  soups::torus(20, 12, 3, 1), soups::genus_surface(3, 2, 5)};

} // namespace

TEST(Closest_signs, fit_everywhere_if_some_do)
{
  Random random(3);
  for (const Triangle_soup& soup : soups_of_all_genera)
  {
    Signed_mesh m(soup, random);
    EXPECT_EQ(m.number_of_misfits(), 0);
    for (signed char& a : m.agreement)
      if (random.index(10) == 0)
        a = 0;
    EXPECT_EQ(m.number_of_misfits(), 0);
  }
}

TEST(Closest_signs, do_not_fit_on_short_paths_between_odd_faces)
{
  Random random(4);
  for (const Triangle_soup& soup : soups_of_all_genera)
    for (int steps : {1, 2, 3})
    {
      Signed_mesh m(soup, random);
      EXPECT_LE(m.number_of_misfits(), m.turn_along_walk(random, steps));
    }
}

TEST(Closest_signs, do_not_fit_on_some_path_between_far_faces)
{
  Random random(5);
  for (const Triangle_soup& soup : soups_of_all_genera)
  {
    Signed_mesh m(soup, random);
    for (int walk = 0; walk < 5; ++walk)
      m.turn_along_walk(random, 20);
    const int misfits = m.number_of_misfits();
    EXPECT_GT(misfits, 0);
    EXPECT_LT(misfits, 100);
  }
}

// ===  Updated_solutions.h

namespace {

// the Laplacian of a square grid plus a diagonal: its lower triangle
Eigen::SparseMatrix<double> grid_matrix(int n)
{
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n * n; ++i)
  {
    entries.emplace_back(i, i, 5);
    if (i % n + 1 < n)
      entries.emplace_back(i + 1, i, -1);
    if (i + n < n * n)
      entries.emplace_back(i + n, i, -1);
  }
  Eigen::SparseMatrix<double> result(n * n, n * n);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

Eigen::MatrixXd dense(const Eigen::SparseMatrix<double>& lower)
{
  const Eigen::MatrixXd l = Eigen::MatrixXd(lower);
  return l + l.transpose() - Eigen::MatrixXd(l.diagonal().asDiagonal());
}

Vector right_side(int size)
{
  Random random(2);
  Vector result(size);
  for (int i = 0; i < size; ++i)
    result[i] = random.between(-1, 1);
  return result;
}

} // namespace

TEST(Matrix_change, touches_each_unknown_once)
{
  EXPECT_TRUE(Matrix_change().unknowns().empty());
  const Matrix_change change{{{7, 3, 1.}, {5, 3, 1.}, {9, 7, 2.}}};
  EXPECT_EQ(change.unknowns(), (std::vector<int>{3, 5, 7, 9}));
}

TEST(Simplicial_cholesky_solver, factors_again_after_its_memory_was_freed)
{
  const Eigen::SparseMatrix<double> matrix = grid_matrix(5);
  const Vector b = right_side(25);
  Simplicial_cholesky_solver solver;
  for (int round = 0; round < 2; ++round)
  {
    solver.analyze_pattern(matrix);
    ASSERT_TRUE(solver.factorize(matrix));
    EXPECT_LT((dense(matrix) * solver.solve(b) - b).norm(), 1e-12);
    solver.clear();
  }
}

// Each change alone, and after all those before it, whose columns are kept.
TEST(Updated_solutions, solve_with_changed_matrices)
{
  constexpr int n = 15;
  const Eigen::SparseMatrix<double> matrix = grid_matrix(n);
  Simplicial_cholesky_solver solver;
  solver.analyze_pattern(matrix);
  ASSERT_TRUE(solver.factorize(matrix));
  const Vector b = right_side(n * n);
  Updated_solutions kept(solver);
  for (const Matrix_change& change :
       {Matrix_change{}, Matrix_change{{{1, 0, 2.}}},
        Matrix_change{{{n + 1, 1, 0.5}, {100, 99, 1.}, {115, 100, 2.}}},
        Matrix_change{{{100, 99, 0.3}, {224, 223, 1.}}}, Matrix_change{{{1, 0, -0.5}}},
        Matrix_change{{{50, 49, 0.}}}})
  {
    Eigen::MatrixXd changed = dense(matrix);
    for (const Matrix_change::Entry& entry : change.entries)
    {
      changed(entry.row, entry.column) += entry.value;
      changed(entry.column, entry.row) += entry.value;
    }
    for (const std::optional<Vector>& x : {Updated_solutions(solver)(b, change), kept(b, change)})
    {
      ASSERT_TRUE(x);
      EXPECT_LT((changed * *x - b).cwiseAbs().maxCoeff(), 1e-13);
    }
  }
}

TEST(Updated_solutions, forget_a_former_matrix)
{
  constexpr int n = 15;
  Eigen::SparseMatrix<double> matrix = grid_matrix(n);
  Simplicial_cholesky_solver solver;
  solver.analyze_pattern(matrix);
  ASSERT_TRUE(solver.factorize(matrix));
  const Vector b = right_side(n * n);
  const Matrix_change change{{{101, 100, 0.5}}};
  Updated_solutions updated(solver);
  ASSERT_TRUE(updated(b, change));
  for (int i = 0; i < n * n; ++i)
    matrix.coeffRef(i, i) += 1;
  ASSERT_TRUE(solver.factorize(matrix));
  updated.forget();
  const std::optional<Vector> x = updated(b, change);
  ASSERT_TRUE(x);
  EXPECT_EQ(*x, *Updated_solutions(solver)(b, change));
}

TEST(Updated_solutions, give_up_where_a_factorization_is_less_work)
{
  constexpr int n = 15;
  const Eigen::SparseMatrix<double> matrix = grid_matrix(n);
  Simplicial_cholesky_solver solver;
  solver.analyze_pattern(matrix);
  ASSERT_TRUE(solver.factorize(matrix));
  Matrix_change change;
  for (int i = 0; i + 1 < n * n; i += 2)
    change.entries.push_back({i + 1, i, 0.1});
  EXPECT_FALSE(Updated_solutions(solver)(right_side(n * n), change));
}

TEST(Is_updatable, tells_models_of_the_refined_concept)
{
  struct Plain_solver
  {
    Vector solve(const Vector& b) const { return b; }
  };
  EXPECT_TRUE(Is_updatable<Simplicial_cholesky_solver>::value);
  EXPECT_FALSE(Is_updatable<Plain_solver>::value);
}

// ===  weights_of_flat_mesh.h

namespace {

// with three right angles at vertex 0
Triangle_soup corner_of_cube(double scale = 1)
{
  return {{{0, 0, 0}, {scale, 0, 0}, {0, scale, 0}, {0, 0, scale}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

} // namespace

TEST(Weights_of_flat_mesh, of_equilateral_triangles)
{
  const Flat_mesh mesh = flat_mesh(soups::octahedron());
  for (double weight : mean_value_weights(mesh)) // four corners of 60 degrees, edges of sqrt 2
    EXPECT_DOUBLE_EQ(weight, 4. / 2 * std::sqrt(1. / 3) / std::sqrt(2.));
  for (double weight : cotangent_weights(mesh))
    EXPECT_DOUBLE_EQ(weight, std::sqrt(1. / 3));
}

TEST(Weights_of_flat_mesh, of_right_angles)
{
  const Flat_mesh mesh = flat_mesh(corner_of_cube());
  const std::vector<double> mean_value = mean_value_weights(mesh),
                            cotangent = cotangent_weights(mesh);
  const double tan_of_22_5 = std::sqrt(2.) - 1, tan_of_30 = std::sqrt(1. / 3);
  for (int e = 0; e < mesh.number_of_edges(); ++e)
  {
    const bool is_at_corner = mesh.source(halfedge_of(e)) == 0 || mesh.target(halfedge_of(e)) == 0;
    EXPECT_DOUBLE_EQ(mean_value[e],
                     is_at_corner ? 1 + tan_of_22_5 : (tan_of_22_5 + tan_of_30) / std::sqrt(2.));
    EXPECT_NEAR(cotangent[e], is_at_corner ? 1 : std::sqrt(1. / 3) / 2, 1e-15);
  }
}

TEST(Weights_of_flat_mesh, scale_exactly)
{
  const Flat_mesh mesh = flat_mesh(corner_of_cube());
  const std::vector<double> mean_value = mean_value_weights(mesh),
                            cotangent = cotangent_weights(mesh);
  for (int exponent : {-1000, -1, 1, 1000})
  {
    const Flat_mesh scaled = flat_mesh(corner_of_cube(std::scalbn(1., exponent)));
    EXPECT_EQ(cotangent_weights(scaled), cotangent);
    const std::vector<double> found = mean_value_weights(scaled);
    for (std::size_t e = 0; e < found.size(); ++e)
      EXPECT_EQ(found[e], std::scalbn(mean_value[e], -exponent));
  }
}

TEST(Weights_of_flat_mesh, of_mean_values_are_positive_and_finite_even_for_slivers)
{
  for (double height : {1e-3, 1e-9, 1e-17, 1e-40, 0.})
  {
    Triangle_soup soup = corner_of_cube();
    soup.points[3] = {0.5, 0.25 * height, height}; // above an edge, or on it
    for (double weight : mean_value_weights(flat_mesh(soup)))
    {
      EXPECT_GT(weight, 0) << height;
      EXPECT_LT(weight, std::numeric_limits<double>::infinity()) << height;
    }
  }
}

} // namespace test_newton_system
