// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The paper's algorithm, repaired, converges to what Newton's method finds; the literal one
// freezes.

#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/lengths.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/weights_of_flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Newton_steps.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Whitehead_solver.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/grow_fronts.h>
#include <CGAL/Surface_mesh_foliation/whitehead_foliation.h>

#include "include/edge_value_difference.h"
#include "include/random_systems.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <ostream>
#include <string>
#include <vector>

namespace test_whitehead_foliation {

using namespace smf_test;
using Foliation = SMF::Measured_foliation<Mesh>;
using System = SMF::Loop_system<Mesh>;
namespace np = SMF::parameters;

namespace {

struct Case
{
  std::string name;
  Mesh mesh;
  std::vector<std::size_t> poles;
};

std::ostream& operator<<(std::ostream& out, const Case& c)
{
  return out << c.name;
}

std::vector<Case> cases()
{
  return {{"tetrahedron", tetrahedron(), {0, 1, 2, 3}},
          {"sphere", icosphere(3), {0, 40, 90, 300}},
          {"limbed sphere", limbed_sphere(5, 3), {0, 20, 60, 150, 300}},
          {"torus", torus(30, 18, 3, 1), {3, 200, 277}},
          {"genus 2", genus_surface(2, 3, 7), {0, 60}},
          {"genus 4", genus_surface(4, 3, 5), {5, 99, 200}},
          {"rough genus 3", noisy(genus_surface(3, 3, 2), 0.25, 9), {17}}};
}

System system_of(const Case& c)
{
  Input input;
  for (std::size_t i = 0; i < c.poles.size(); ++i)
    input.add_pole(Vertex(static_cast<Mesh::size_type>(c.poles[i])),
                   1 + 0.5 * static_cast<double>(i));
  return System(c.mesh, input);
}

class Each_case : public testing::TestWithParam<Case>
{
protected:
  Each_case() : system(system_of(GetParam())), newton(SMF::harmonic_foliation(system)) {}

  System system;
  Foliation newton;
};

struct Visitor
{
  std::size_t sweeps = 0, limit = 1000000;
  double energy = 1e300;
  bool after_iteration(const SMF::Foliation_statistics& statistics)
  {
    ++sweeps;
    EXPECT_EQ(statistics.number_of_iterations, sweeps);
    EXPECT_LE(statistics.energy, energy * (1 + 1e-12));
    energy = statistics.energy;
    return sweeps < limit;
  }
};

} // namespace

TEST_P(Each_case, newton_steps_go_on_where_sweeps_end)
{
  namespace SI = SMF::internal;
  const SI::Flat_loop_system& flat = system.data().flat;
  SI::Foliation_state state(flat, SI::mean_value_weights(flat.mesh));
  SI::Whitehead_solver sweeps(state, SI::Whitehead_options());
  for (int i = 0; i < 10; ++i)
    sweeps.sweep();
  SI::Newton_steps steps(state, 1e-12);
  SMF::Foliation_statistics statistics = sweeps.statistics(1e-12);
  for (int i = 0; i < 50 && !statistics.has_converged; ++i)
  {
    const std::size_t before = statistics.number_of_iterations;
    statistics = steps.next(before, SI::poll_nobody);
    EXPECT_EQ(statistics.number_of_iterations, before + 1);
  }
  EXPECT_TRUE(statistics.has_converged);
  EXPECT_NEAR(statistics.energy / newton.statistics().energy, 1, 1e-9);
}

TEST_P(Each_case, repaired_moves_converge_to_newtons_solution)
{
  for (double factor : {1., 1.6, 1.9})
    for (bool is_staged : {false, true})
    {
      SCOPED_TRACE("factor " + std::to_string(factor) + (is_staged ? ", staged" : ""));
      const Foliation foliation = SMF::whitehead_foliation(
        system, np::combine(np::over_relaxation(factor), np::stage_critical_moves(is_staged)));
      EXPECT_TRUE(foliation.statistics().has_converged);
      EXPECT_TRUE(foliation.statistics().is_certified);
      EXPECT_NEAR(foliation.statistics().energy / newton.statistics().energy, 1, 1e-8);
      EXPECT_LT(difference(foliation, newton), 1e-6);
    }
}

TEST_P(Each_case, starts_and_orders_do_not_matter)
{
  using namespace SMF::internal;
  const Flat_loop_system& flat = system.data().flat;
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
    for (bool starts_from_fronts : {false, true})
    {
      Foliation_state state(flat, mean_value_weights(flat.mesh));
      if (starts_from_fronts)
        grow_fronts(state);
      std::vector<int> order(flat.mesh.number_of_vertices());
      std::iota(order.begin(), order.end(), 0);
      Random random(seed);
      for (std::size_t i = order.size(); i > 1; --i)
        std::swap(order[i - 1], order[random.index(i)]);
      Whitehead_options options;
      options.over_relaxation = 1.8;
      Whitehead_solver solver(state, options);
      solver.set_order(order);
      for (int i = 0; i < 20000 && solver.statistics(1e-12).optimality > 1e-11; i += 50)
        for (int sweep = 0; sweep < 50; ++sweep)
          solver.sweep();
      EXPECT_NEAR(energy_of(state) / newton.statistics().energy, 1, 1e-8);
      double largest = 0, gap = 0;
      for (int e = 0; e < flat.mesh.number_of_edges(); ++e)
      {
        largest = std::max(largest, length_of_edge(newton.state(), e));
        gap = std::max(gap, std::abs(length_of_edge(state, e) - length_of_edge(newton.state(), e)));
      }
      EXPECT_LT(gap, 1e-6 * largest);
      EXPECT_TRUE(certify(state, Extraction(state)).empty());
    }
}

TEST_P(Each_case, the_visitor_sees_falling_energies_and_edge_values)
{
  Mesh mesh = GetParam().mesh;
  auto value = mesh.add_property_map<Mesh::Edge_index, double>("e:value", -1).first;
  Visitor visitor;
  visitor.limit = 40;
  const auto sum_of_squares = [&] {
    double result = 0;
    for (const auto e : edges(GetParam().mesh))
      result += value[e] * value[e];
    return result;
  };
  const Foliation foliation = SMF::whitehead_foliation(
    system, np::combine(np::edge_value_map(value), CGAL::parameters::visitor(std::ref(visitor))));
  EXPECT_GT(sum_of_squares(), 0);
  EXPECT_TRUE(foliation.statistics().is_certified);
  EXPECT_GE(foliation.statistics().energy, newton.statistics().energy * (1 - 1e-12));
  EXPECT_GE(foliation.statistics().number_of_iterations, visitor.sweeps);
}

TEST_P(Each_case, sweeps_are_those_of_the_class)
{
  SMF::Whitehead_foliation_solver<Mesh> solver(system);
  EXPECT_EQ(solver.statistics().number_of_iterations, 0u);
  double energy = solver.statistics().energy;
  for (int sweep = 1; sweep <= 10; ++sweep)
  {
    solver.sweep();
    EXPECT_EQ(solver.statistics().number_of_iterations, static_cast<std::size_t>(sweep));
    EXPECT_LE(solver.statistics().energy, energy * (1 + 1e-12));
    energy = solver.statistics().energy;
  }
  Mesh mesh = GetParam().mesh;
  auto value = mesh.add_property_map<Mesh::Edge_index, double>("e:value", -1).first;
  solver.edge_values(value);
  for (const auto e : edges(mesh))
    EXPECT_GE(value[e], 0);
  EXPECT_TRUE(solver.foliation().statistics().is_certified);
  EXPECT_THROW(solver.sweep(), SMF::Solver_exception);
  EXPECT_THROW(solver.foliation(), SMF::Solver_exception);
}

INSTANTIATE_TEST_SUITE_P(Cases, Each_case, testing::ValuesIn(cases()), [](const auto& one) {
  std::string name = one.param.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
});

TEST(Whitehead_foliation, literal_moves_freeze_with_accidental_thorns)
{
  int frozen = 0;
  for (const Case& c : cases())
  {
    SCOPED_TRACE(c.name);
    const System system = system_of(c);
    SMF::Whitehead_foliation_solver<Mesh> solver(system, np::use_literal_moves(true));
    for (int sweep = 0; sweep < 3000; ++sweep)
      solver.sweep();
    if (solver.accidental_thorns().empty())
      continue;
    ++frozen;
    EXPECT_GT(solver.statistics().energy,
              1.001 * SMF::harmonic_foliation(system).statistics().energy);
    EXPECT_THROW(solver.foliation(), SMF::Certificate_exception);
  }
  EXPECT_GE(frozen, 3);
}

TEST(Whitehead_foliation, staged_moves_end_their_first_stage_and_report_critical_moves)
{
  int with_events = 0;
  for (const Case& c : cases())
  {
    SCOPED_TRACE(c.name);
    SMF::Whitehead_foliation_solver<Mesh> solver(system_of(c), np::stage_critical_moves(true));
    EXPECT_TRUE(solver.is_in_first_stage());
    for (int sweep = 0; sweep < 2000 && solver.is_in_first_stage(); ++sweep)
    {
      EXPECT_TRUE(solver.critical_moves().empty());
      solver.sweep();
    }
    EXPECT_FALSE(solver.is_in_first_stage());
    for (int sweep = 0; sweep < 200; ++sweep)
      solver.sweep();
    with_events += !solver.critical_moves().empty();
    for (const Vertex v : solver.critical_moves())
      EXPECT_TRUE(std::find(c.poles.begin(), c.poles.end(), static_cast<std::size_t>(v)) ==
                  c.poles.end());
  }
  EXPECT_GE(with_events, 3);
}

TEST(Whitehead_foliation, wrong_factors_are_refused)
{
  const System system = system_of(cases()[1]);
  for (double factor : {0., 2., -1., std::nan("")})
    EXPECT_THROW(SMF::whitehead_foliation(system, np::over_relaxation(factor)),
                 SMF::Invalid_parameter_exception);
}

} // namespace test_whitehead_foliation
