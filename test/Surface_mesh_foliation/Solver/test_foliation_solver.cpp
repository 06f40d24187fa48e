// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A solver that starts from its last solution finds what one finds that starts cold, and tells the
// linear solver to analyze only patterns that it does not know.

#include <CGAL/Surface_mesh_foliation/Foliation_solver.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/loops.h>

#include "include/edge_value_difference.h"
#include "include/random_systems.h"

#include <Eigen/SparseCholesky>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_foliation_solver {

using namespace smf_test;
using Foliation = SMF::Measured_foliation<Mesh>;
using System = SMF::Loop_system<Mesh>;

namespace {

// the default linear solver, that counts
struct Counting_solver : SMF::Supernodal_cholesky_solver
{
  int analyses = 0, factorizations = 0;

  void analyze_pattern(const Eigen::SparseMatrix<double>& matrix)
  {
    ++analyses;
    SMF::Supernodal_cholesky_solver::analyze_pattern(matrix);
  }
  bool factorize(const Eigen::SparseMatrix<double>& matrix)
  {
    ++factorizations;
    return SMF::Supernodal_cholesky_solver::factorize(matrix);
  }
};

// a model of FoliationLinearSolver that is none of UpdatableFoliationLinearSolver
struct Plain_solver
{
  int factorizations = 0;
  void analyze_pattern(const Eigen::SparseMatrix<double>& matrix) { m_ldlt.analyzePattern(matrix); }
  bool factorize(const Eigen::SparseMatrix<double>& matrix)
  {
    ++factorizations;
    m_ldlt.factorize(matrix);
    return m_ldlt.info() == Eigen::Success;
  }
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const { return m_ldlt.solve(b); }

private:
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> m_ldlt;
};

struct Failing_solver : SMF::Supernodal_cholesky_solver
{
  bool factorize(const Eigen::SparseMatrix<double>&) { return false; }
};

struct Infinite_solver : Plain_solver
{
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const { return b / 0.; }
};

// one that iterates, and gives up
struct Unfinished_solver : Plain_solver
{
  Eigen::VectorXd solve(const Eigen::VectorXd&) const
  {
    throw SMF::Solver_exception(
      {SMF::Problem_kind::SOLVER_FAILURE, "after 7 iterations", {}, {}, {}});
  }
};

// the message of the exception
template <class LinearSolver>
std::string failure_with(LinearSolver& linear_solver, const System& system)
{
  try
  {
    SMF::harmonic_foliation(system,
                            CGAL::parameters::sparse_linear_solver(std::ref(linear_solver)));
    return "no exception";
  }
  catch (const SMF::Solver_exception& exception)
  {
    EXPECT_EQ(exception.problem().kind, SMF::Problem_kind::SOLVER_FAILURE);
    return exception.problem().message;
  }
}

struct Case
{
  std::string name;
  Mesh mesh;
  std::vector<std::size_t> poles;
};

std::vector<Case> cases()
{
  return {{"sphere", icosphere(4), {0, 40, 90, 600}},
          {"limbed sphere", limbed_sphere(5, 4), {0, 20, 60, 150, 300}},
          {"torus", torus(40, 24, 3, 1), {3, 200, 777}},
          {"genus 3", genus_surface(3, 4, 11), {5, 99, 400}}};
}

Input input_of(const std::vector<std::size_t>& poles)
{
  Input result;
  for (std::size_t v : poles)
    result.add_pole(Vertex(static_cast<Mesh::size_type>(v)));
  return result;
}

} // namespace

TEST(Foliation_solver, restarts_after_a_change_of_heights)
{
  for (const Case& c : cases())
  {
    SCOPED_TRACE(c.name);
    Counting_solver linear_solver;
    SMF::Foliation_solver<Mesh, Counting_solver> solver(linear_solver);
    Input input = input_of(c.poles);
    solver.solve(System(c.mesh, input));
    for (double height : {1.1, 0.1, 20.})
    {
      input.set_height(1, height);
      const System system(c.mesh, input);
      const Foliation foliation = solver.solve(system);
      EXPECT_TRUE(foliation.statistics().has_converged);
      EXPECT_TRUE(foliation.statistics().is_certified);
      EXPECT_LT(difference(foliation, SMF::harmonic_foliation(system)), 1e-9);
    }
    EXPECT_EQ(linear_solver.analyses, 1);
  }
}

TEST(Foliation_solver, a_run_with_the_same_input_is_over_at_once)
{
  for (const Case& c : cases())
  {
    SCOPED_TRACE(c.name);
    SMF::Foliation_solver<Mesh> solver;
    const System system(c.mesh, input_of(c.poles));
    const Foliation first = solver.solve(system), second = solver.solve(system);
    EXPECT_GT(first.statistics().number_of_iterations, 0u);
    EXPECT_EQ(second.statistics().number_of_iterations, 0u);
    EXPECT_EQ(difference(first, second), 0);
  }
}

TEST(Foliation_solver, restarts_with_other_weights)
{
  for (const Case& c : cases())
  {
    SCOPED_TRACE(c.name);
    Counting_solver linear_solver;
    SMF::Foliation_solver<Mesh, Counting_solver> solver(linear_solver);
    const System system(c.mesh, input_of(c.poles));
    solver.solve(system);
    Mesh mesh = c.mesh;
    Random random(3);
    auto weight = mesh.add_property_map<Mesh::Edge_index, double>("e:weight").first;
    for (const auto e : edges(mesh))
      weight[e] = random.between(0.5, 2);
    const Foliation foliation = solver.solve(system, SMF::parameters::weights(weight));
    EXPECT_LT(
      difference(foliation, SMF::harmonic_foliation(system, SMF::parameters::weights(weight))),
      1e-9);
    EXPECT_EQ(linear_solver.analyses, 1);
  }
}

TEST(Foliation_solver, restarts_in_another_pose)
{
  for (const Case& c : cases())
  {
    SCOPED_TRACE(c.name);
    Counting_solver linear_solver;
    SMF::Foliation_solver<Mesh, Counting_solver> solver(linear_solver);
    solver.solve(System(c.mesh, input_of(c.poles)));
    const Mesh pose = noisy(c.mesh, 0.2, 5);
    const System system(pose, input_of(c.poles));
    const Foliation foliation = solver.solve(system);
    EXPECT_LT(difference(foliation, SMF::harmonic_foliation(system)), 1e-9);
    EXPECT_EQ(linear_solver.analyses, 1);
  }
}

TEST(Foliation_solver, a_moved_pole_and_another_loop_keep_the_analysis)
{
  for (const Case& c : cases())
  {
    SCOPED_TRACE(c.name);
    Counting_solver linear_solver;
    SMF::Foliation_solver<Mesh, Counting_solver> solver(linear_solver);
    Input input = input_of(c.poles);
    solver.solve(System(c.mesh, input));
    std::vector<std::size_t> moved = c.poles;
    moved.back() += 7;
    for (const Input& other : {input_of(moved), input_of({moved[0], moved[1]}), input})
    {
      const System system(c.mesh, other);
      const Foliation foliation = solver.solve(system);
      EXPECT_TRUE(foliation.statistics().is_certified);
      EXPECT_LT(difference(foliation, SMF::harmonic_foliation(system)), 1e-9);
    }
    EXPECT_EQ(linear_solver.analyses, 1);
  }
}

TEST(Foliation_solver, another_mesh_is_analyzed)
{
  Counting_solver linear_solver;
  SMF::Foliation_solver<Mesh, Counting_solver> solver(linear_solver);
  int runs = 0;
  for (const Case& c : cases())
  {
    if (c.name == "limbed sphere") // it has the connectivity of the sphere
      continue;
    SCOPED_TRACE(c.name);
    const System system(c.mesh, input_of(c.poles));
    EXPECT_LT(difference(solver.solve(system), SMF::harmonic_foliation(system)), 1e-9);
    EXPECT_EQ(linear_solver.analyses, ++runs);
  }
}

TEST(Foliation_solver, results_do_not_change_when_the_solver_goes_on)
{
  const Case c = cases()[3];
  SMF::Foliation_solver<Mesh> solver;
  Input input = input_of(c.poles);
  const Foliation first = solver.solve(System(c.mesh, input));
  std::vector<double> before;
  for (const auto e : edges(c.mesh))
    before.push_back(first.edge_value(e));
  input.set_height(0, 7);
  solver.solve(System(c.mesh, input));
  std::size_t i = 0;
  for (const auto e : edges(c.mesh))
    EXPECT_EQ(first.edge_value(e), before[i++]);
}

TEST(Foliation_solver, a_run_that_fails_in_its_start_leaves_none)
{
  struct Throwing_visitor : SMF::Default_foliation_visitor
  {
    bool after_coarse_iteration(std::size_t, const SMF::Foliation_statistics&)
    {
      throw std::runtime_error("in the visitor");
    }
  };
  const Case c = cases()[2], other = cases()[1]; // which has a coarser mesh
  SMF::Foliation_solver<Mesh> solver;
  const System system(c.mesh, input_of(c.poles));
  const Foliation first = solver.solve(system);
  solver.start(system);
  EXPECT_THROW(solver.solve(System(other.mesh, input_of(other.poles)),
                            CGAL::parameters::visitor(Throwing_visitor())),
               std::runtime_error);
  EXPECT_THROW(solver.iterate(), SMF::Solver_exception);
  EXPECT_THROW(solver.foliation(), SMF::Solver_exception);
  EXPECT_LT(difference(solver.solve(system), first), 1e-9);
}

TEST(Foliation_solver, steps_do_what_a_run_does)
{
  for (const Case& c : cases())
  {
    SCOPED_TRACE(c.name);
    const System system(c.mesh, input_of(c.poles));
    SMF::Foliation_solver<Mesh> solver;
    solver.start(system, SMF::parameters::tolerance(1e-10));
    double energy = solver.statistics().energy;
    while (!solver.statistics().has_converged)
    {
      solver.iterate();
      EXPECT_LE(solver.statistics().energy, energy * (1 + 1e-12));
      energy = solver.statistics().energy;
    }
    const Foliation foliation = solver.foliation();
    EXPECT_EQ(
      difference(foliation, SMF::harmonic_foliation(system, SMF::parameters::tolerance(1e-10))), 0);
    EXPECT_THROW(solver.iterate(), SMF::Solver_exception);
    EXPECT_THROW(solver.foliation(), SMF::Solver_exception);
  }
}

TEST(Foliation_solver, factors_less_often_than_it_iterates)
{
  int iterations = 0, factorizations = 0;
  for (const Case& c : cases())
  {
    Counting_solver linear_solver;
    const System system(c.mesh, input_of(c.poles));
    const Foliation foliation = SMF::harmonic_foliation(
      system, CGAL::parameters::sparse_linear_solver(std::ref(linear_solver)));
    iterations += static_cast<int>(foliation.statistics().number_of_iterations);
    factorizations += linear_solver.factorizations;
  }
  EXPECT_LT(factorizations, iterations);
}

TEST(Linear_solvers, one_without_updates_finds_the_same_foliation)
{
  for (const Case& c : cases())
  {
    SCOPED_TRACE(c.name);
    Plain_solver linear_solver;
    const System system(c.mesh, input_of(c.poles));
    const Foliation foliation = SMF::harmonic_foliation(
      system, CGAL::parameters::sparse_linear_solver(std::ref(linear_solver)));
    EXPECT_TRUE(foliation.statistics().has_converged);
    EXPECT_LT(difference(foliation, SMF::harmonic_foliation(system)), 1e-9);
    EXPECT_EQ(linear_solver.factorizations,
              static_cast<int>(foliation.statistics().number_of_iterations));
  }
}

TEST(Linear_solvers, memory_is_freed_when_nothing_more_will_be_solved)
{
  struct Clearable_solver : Plain_solver
  {
    int clearances = 0;
    void clear() { ++clearances; }
  } linear_solver;
  const Case c = cases()[0];
  const System system(c.mesh, input_of(c.poles));
  SMF::Foliation_solver<Mesh, Clearable_solver> solver(linear_solver);
  solver.solve(system);
  EXPECT_EQ(linear_solver.clearances, 0);
  SMF::harmonic_foliation(system, CGAL::parameters::sparse_linear_solver(std::ref(linear_solver)));
  EXPECT_EQ(linear_solver.clearances, 1);
}

TEST(Linear_solvers, failures_are_exceptions)
{
  const Case c = cases()[0];
  const System system(c.mesh, input_of(c.poles));
  Failing_solver failing;
  EXPECT_EQ(failure_with(failing, system),
            "the linear system of the foliation could not be factored");
  Infinite_solver infinite;
  EXPECT_EQ(failure_with(infinite, system),
            "the linear system of the foliation has no finite solution");
  Unfinished_solver unfinished;
  EXPECT_EQ(failure_with(unfinished, system), "after 7 iterations");
}

// The updated solution is that of the changed matrix, whatever was changed.
TEST(Linear_solvers, updated_solutions_solve_the_changed_system)
{
  Random random(1);
  int updated = 0;
  for (int n : {30, 100, 400})
    for (int changes : {0, 1, 2, 5})
    {
      SCOPED_TRACE(std::to_string(n) + " unknowns, " + std::to_string(changes) + " changes");
      const int width = static_cast<int>(std::sqrt(n));
      std::vector<Eigen::Triplet<double>> entries;
      std::vector<std::pair<int, int>> places;
      for (int i = 0; i < n; ++i)
      {
        entries.emplace_back(i, i, 5);
        for (int j : {i + 1, i + width})
          if (j < n)
          {
            entries.emplace_back(j, i, -random.between(0, 1));
            places.emplace_back(j, i);
          }
      }
      Eigen::SparseMatrix<double> matrix(n, n);
      matrix.setFromTriplets(entries.begin(), entries.end());
      SMF::Supernodal_cholesky_solver solver;
      solver.analyze_pattern(matrix);
      ASSERT_TRUE(solver.factorize(matrix));
      SMF::internal::Matrix_change change;
      for (int k = 0; k < changes; ++k)
      {
        const auto [row, column] = places[random.index(places.size())];
        const double value = -2 * matrix.coeff(row, column);
        if (value == 0)
          continue;
        change.entries.push_back({row, column, value});
        matrix.coeffRef(row, column) += value;
      }
      const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(n, -1, 2);
      const auto x = SMF::internal::Updated_solutions(solver)(b, change);
      if (!x)
        continue;
      ++updated;
      const Eigen::VectorXd residual = matrix.selfadjointView<Eigen::Lower>() * *x - b;
      EXPECT_LT(residual.cwiseAbs().maxCoeff(), 1e-13);
    }
  EXPECT_GE(updated, 6);
}

} // namespace test_foliation_solver
