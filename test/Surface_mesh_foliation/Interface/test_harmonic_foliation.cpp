// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/example_systems.h"

#include <CGAL/Surface_mesh_foliation/Foliation_visitor.h>
#include <CGAL/Surface_mesh_foliation/edge_weights.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_harmonic_foliation {

// The solver from outside: iterations, tolerance, visitor, weights.

namespace {

using smf_test::Example;
using smf_test::Item;
using smf_test::Mesh;
using smf_test::Solved_example;
namespace SMF = CGAL::Surface_mesh_foliation;
namespace soups = smf_test::soups;

using Foliation = SMF::Measured_foliation<Mesh>;
using System = SMF::Loop_system<Mesh>;
using SMF::parameters::tolerance;

class Each_solution : public ::testing::TestWithParam<Example>
{
protected:
  Each_solution() : example(GetParam()) {}
  Solved_example<> example;
};

INSTANTIATE_TEST_SUITE_P(Examples,
                         Each_solution,
                         ::testing::ValuesIn(smf_test::all_example_systems()),
                         smf_test::name_of_example);

// a foliation in the class of the loops, whatever the solver did
void expect_valid(const Foliation& foliation)
{
  const Mesh& mesh = foliation.mesh();
  EXPECT_TRUE(foliation.statistics().is_certified);
  EXPECT_TRUE(std::isfinite(foliation.statistics().energy));
  EXPECT_GE(foliation.statistics().optimality, 0);
  for (const auto v : vertices(mesh))
  {
    const auto cell = foliation.cell(v);
    const double t = foliation.parameter(v);
    EXPECT_TRUE(cell.is_arc ? t > 0 && t < foliation.system().height(cell.index) : t == 0);
  }
  for (const auto f : faces(mesh))
  {
    const auto h = halfedge(f, mesh);
    const double a = foliation.edge_value(edge(h, mesh));
    const double b = foliation.edge_value(edge(next(h, mesh), mesh));
    const double c = foliation.edge_value(edge(prev(h, mesh), mesh));
    const double slack = 1e-12 * (a + b + c);
    EXPECT_TRUE(a <= b + c + slack && b <= c + a + slack && c <= a + b + slack) << f;
  }
}

// ===  Iterations and tolerance

TEST_P(Each_solution, is_valid_after_any_number_of_iterations)
{
  const SMF::Foliation_statistics& best = example.foliation.statistics();
  for (int n = 0; n <= static_cast<int>(best.number_of_iterations) + 1; ++n)
  {
    SCOPED_TRACE(n);
    const Foliation foliation =
      SMF::harmonic_foliation(example.system, CGAL::parameters::number_of_iterations(n));
    expect_valid(foliation);
    const SMF::Foliation_statistics& statistics = foliation.statistics();
    // it may go on until folds are gone, but not beyond the end
    const std::size_t least = (std::min)(static_cast<std::size_t>(n), best.number_of_iterations);
    EXPECT_GE(statistics.number_of_iterations, least);
    EXPECT_LE(statistics.number_of_iterations, best.number_of_iterations);
    EXPECT_EQ(statistics.has_converged, statistics.optimality < 1e-12);
    EXPECT_EQ(statistics.has_converged,
              statistics.number_of_iterations == best.number_of_iterations);
    EXPECT_GE(statistics.energy, best.energy * (1 - 1e-12)); // there is one minimum
  }
}

TEST_P(Each_solution, stops_at_the_tolerance)
{
  std::size_t iterations = 0;
  for (const double bound : {1e300, 1., 0.3, 0.1, 0.01, 1e-3, 1e-6, 1e-12})
  {
    SCOPED_TRACE(bound);
    const Foliation foliation = SMF::harmonic_foliation(example.system, tolerance(bound));
    expect_valid(foliation);
    EXPECT_TRUE(foliation.statistics().has_converged);
    EXPECT_LT(foliation.statistics().optimality, bound * (1 + 1e-12)); // up to rounding
    EXPECT_GE(foliation.statistics().number_of_iterations, iterations);
    iterations = foliation.statistics().number_of_iterations;
  }
}

TEST_P(Each_solution, is_still_valid_if_the_tolerance_cannot_be_reached)
{
  const Foliation foliation = SMF::harmonic_foliation(
    example.system, tolerance((std::numeric_limits<double>::min)()).number_of_iterations(40));
  expect_valid(foliation);
  EXPECT_NEAR(foliation.statistics().energy, example.foliation.statistics().energy,
              1e-12 * example.foliation.statistics().energy);
  // only rounding is left
  EXPECT_LT(foliation.statistics().optimality, 1e-12);
}

TEST_P(Each_solution, is_the_same_in_every_run)
{
  const Solved_example<> again(GetParam());
  const Foliation &first = example.foliation, &second = again.foliation;
  EXPECT_EQ(first.statistics().energy, second.statistics().energy);
  EXPECT_EQ(first.statistics().optimality, second.statistics().optimality);
  EXPECT_EQ(first.statistics().number_of_iterations, second.statistics().number_of_iterations);
  for (const auto v : vertices(*example.mesh))
  {
    EXPECT_EQ(first.cell(v).is_arc, second.cell(v).is_arc);
    EXPECT_EQ(first.cell(v).index, second.cell(v).index);
    EXPECT_EQ(first.parameter(v), second.parameter(v));
  }
  for (const auto e : edges(*example.mesh))
    EXPECT_EQ(first.edge_value(e), second.edge_value(e));
  for (std::size_t a = 0; a < first.system().number_of_arcs(); ++a)
    EXPECT_EQ(first.flux(a), second.flux(a));
}

// ===  Visitors

struct Counting_visitor
{
  bool after_iteration(const SMF::Foliation_statistics& statistics)
  {
    seen.push_back(statistics);
    return seen.size() < limit;
  }
  std::size_t limit = std::numeric_limits<std::size_t>::max();
  std::vector<SMF::Foliation_statistics> seen = {};
};

TEST_P(Each_solution, tells_the_visitor_about_each_iteration)
{
  Counting_visitor visitor;
  const Foliation foliation =
    SMF::harmonic_foliation(example.system, CGAL::parameters::visitor(std::ref(visitor)));
  const SMF::Foliation_statistics& last = foliation.statistics();
  ASSERT_EQ(visitor.seen.size(), last.number_of_iterations);
  for (std::size_t i = 0; i < visitor.seen.size(); ++i)
  {
    const SMF::Foliation_statistics& statistics = visitor.seen[i];
    EXPECT_EQ(statistics.number_of_iterations, i + 1);
    EXPECT_EQ(statistics.has_converged, statistics.optimality < 1e-12);
    EXPECT_EQ(statistics.has_converged, i + 1 == visitor.seen.size());
    EXPECT_FALSE(statistics.is_certified) << "that comes after the last iteration";
    EXPECT_GE(statistics.energy, last.energy * (1 - 1e-12));
  }
  EXPECT_EQ(last.energy, example.foliation.statistics().energy);
}

TEST_P(Each_solution, stops_when_the_visitor_wants_it)
{
  const std::size_t all = example.foliation.statistics().number_of_iterations;
  for (std::size_t limit = 1; limit <= all; ++limit)
  {
    Counting_visitor visitor = {limit};
    const Foliation foliation =
      SMF::harmonic_foliation(example.system, CGAL::parameters::visitor(std::ref(visitor)));
    expect_valid(foliation);
    EXPECT_EQ(visitor.seen.size(), limit);
    EXPECT_GE(foliation.statistics().number_of_iterations, limit); // more if there were folds
    EXPECT_LE(foliation.statistics().number_of_iterations, all);
    EXPECT_EQ(foliation.statistics().has_converged,
              foliation.statistics().number_of_iterations == all);
  }
}

// Notes the calls, and stops after some of them.
struct Recorder
{
  explicit Recorder(std::size_t calls) : limit(calls) {}

  bool after_coarse_iteration(std::size_t number_of_vertices, const SMF::Foliation_statistics& s)
  {
    EXPECT_TRUE(sizes.empty() || s.number_of_iterations == 1 || sizes.back() == number_of_vertices);
    EXPECT_GT(s.energy, 0);
    sizes.push_back(number_of_vertices);
    return sizes.size() < limit;
  }
  bool after_iteration(const SMF::Foliation_statistics& statistics)
  {
    ++iterations;
    changed += statistics.number_of_changed_vertices;
    return sizes.size() + iterations < limit;
  }

  std::size_t limit;
  std::vector<std::size_t> sizes = {};
  std::size_t iterations = 0, changed = 0;
};

TEST(Visitor, is_told_about_coarse_meshes_and_stops_there_too)
{
  for (std::size_t genus : {0, 1, 3})
  {
    SCOPED_TRACE(genus);
    const auto mesh = smf_test::to_mesh(genus == 0 ? smf_test::soups::icosphere(5)
                                                   : smf_test::soups::genus_surface(genus, 9));
    SMF::Poles_and_loops<smf_test::Mesh> poles;
    for (std::size_t pole : {0, 1, 7})
      poles.add_pole(smf_test::vertex(pole));
    const SMF::Loop_system<smf_test::Mesh> system(mesh, poles);
    Recorder all(std::numeric_limits<std::size_t>::max());
    const Foliation foliation =
      SMF::harmonic_foliation(system, CGAL::parameters::visitor(std::ref(all)));
    EXPECT_EQ(all.iterations, foliation.statistics().number_of_iterations);
    EXPECT_GT(all.changed, 0u);
    ASSERT_FALSE(all.sizes.empty());
    EXPECT_TRUE(std::is_sorted(all.sizes.begin(), all.sizes.end()));
    EXPECT_LT(all.sizes.back(), num_vertices(mesh));
    for (std::size_t limit = 1; limit < all.sizes.size() + all.iterations; ++limit)
    {
      Recorder some(limit);
      const Foliation stopped =
        SMF::harmonic_foliation(system, CGAL::parameters::visitor(std::ref(some)));
      EXPECT_EQ(some.sizes.size() + some.iterations, limit);
      EXPECT_TRUE(stopped.statistics().is_certified);
    }
  }
}

TEST(Visitor, is_copied_unless_passed_by_reference)
{
  const Solved_example<> example(smf_test::theta_example());
  const Counting_visitor visitor = {1};
  EXPECT_EQ(SMF::harmonic_foliation(example.system, CGAL::parameters::visitor(visitor))
              .statistics()
              .number_of_iterations,
            1u);
  EXPECT_TRUE(visitor.seen.empty());
  EXPECT_TRUE(SMF::harmonic_foliation(example.system,
                                      CGAL::parameters::visitor(SMF::Default_foliation_visitor()))
                .statistics()
                .has_converged);
}

TEST(Visitor, may_throw)
{
  struct Thrower
  {
    bool after_iteration(const SMF::Foliation_statistics&) { throw std::length_error("enough"); }
  };
  const Solved_example<> example(smf_test::theta_example());
  EXPECT_THROW(SMF::harmonic_foliation(example.system, CGAL::parameters::visitor(Thrower())),
               std::length_error);
}

// ===  Parameters out of their range

template <class NamedParameters>
SMF::Problem problem_with(const System& system, const NamedParameters& np)
{
  try
  {
    SMF::harmonic_foliation(system, np);
  }
  catch (const SMF::Invalid_parameter_exception& exception)
  {
    return exception.problem();
  }
  return {SMF::Problem_kind::FILE, "no problem", {}, {}, {}};
}

TEST(Parameters_of_harmonic_foliation, out_of_range)
{
  const Solved_example<> example(smf_test::theta_example());
  for (const double bad : {0., -1e-12, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_EQ(problem_with(example.system, tolerance(bad)).kind,
              SMF::Problem_kind::INVALID_PARAMETER);
  EXPECT_EQ(problem_with(example.system, CGAL::parameters::number_of_iterations(-1)).kind,
            SMF::Problem_kind::INVALID_PARAMETER);
}

// ===  Weights

TEST(Weights, mean_value_is_the_default)
{
  const Solved_example<> example(smf_test::dumbbell_example());
  const Foliation foliation =
    SMF::harmonic_foliation(example.system, SMF::parameters::weights(SMF::Mean_value_weights()));
  EXPECT_EQ(foliation.statistics().energy, example.foliation.statistics().energy);
}

TEST(Weights, cotangent_on_delaunay_meshes)
{
  const Solved_example<> example(
    {"", soups::icosphere(3), smf_test::pole_items({0, 1, 2, 100, 200})});
  const Foliation foliation =
    SMF::harmonic_foliation(example.system, SMF::parameters::weights(SMF::Cotangent_weights()));
  expect_valid(foliation);
  EXPECT_TRUE(foliation.statistics().has_converged);
  EXPECT_NE(foliation.statistics().energy, example.foliation.statistics().energy);
  double energy = 0;
  const auto weight = example.mesh->add_property_map<Mesh::Edge_index, double>("e:cot").first;
  SMF::edge_weights(example.system, SMF::Cotangent_weights(), weight);
  for (const auto e : edges(*example.mesh))
    energy += weight[e] * std::pow(foliation.edge_value(e), 2);
  EXPECT_NEAR(foliation.statistics().energy, energy, 1e-12 * energy);
}

// Heights multiplied by a factor multiply edge values by it, and the energy by its square.
TEST(Weights, energy_is_quadratic_in_the_heights)
{
  for (const double factor : {0.5, 4., 1e-3, 1e100})
  {
    Example example = smf_test::dumbbell_example();
    const Solved_example<> original(example);
    for (Item& item : example.items)
      item.height *= factor;
    const Solved_example<> scaled(example);
    const double energy = original.foliation.statistics().energy * factor * factor;
    EXPECT_NEAR(scaled.foliation.statistics().energy, energy, 1e-12 * energy);
    for (const auto e : edges(*original.mesh))
    {
      const double value = original.foliation.edge_value(e) * factor;
      EXPECT_NEAR(scaled.foliation.edge_value(e), value, 1e-9 * factor);
    }
  }
}

TEST(Weights, scaled_weights_change_nothing_but_the_energy)
{
  const Solved_example<> example(smf_test::theta_example());
  const auto weight = example.mesh->add_property_map<Mesh::Edge_index, double>("e:weight").first;
  SMF::edge_weights(example.system, SMF::Mean_value_weights(), weight);
  for (const double factor : {1e-200, 0.125, 1e150})
  {
    const auto scaled = example.mesh->add_property_map<Mesh::Edge_index, double>("e:scaled").first;
    for (const auto e : edges(*example.mesh))
      scaled[e] = factor * weight[e];
    const Foliation foliation =
      SMF::harmonic_foliation(example.system, SMF::parameters::weights(scaled));
    EXPECT_TRUE(foliation.statistics().has_converged) << factor;
    const double energy = factor * example.foliation.statistics().energy;
    EXPECT_NEAR(foliation.statistics().energy, energy, 1e-10 * energy);
    for (const auto e : edges(*example.mesh))
      EXPECT_NEAR(foliation.edge_value(e), example.foliation.edge_value(e), 1e-9);
  }
}

} // namespace

// A fuzzer found it: the force between two poles that nearly coincide, which nothing gives way to,
// made all others look small.
TEST(Harmonic_foliation, does_not_depend_on_the_weight_of_an_edge_between_poles)
{
  Mesh mesh = smf_test::icosphere<Mesh>(1);
  const auto between =
    edge(*CGAL::halfedges_around_target(smf_test::vertex(0), mesh).begin(), mesh);
  SMF::Poles_and_loops<Mesh> input;
  input.add_pole(mesh.vertex(between, 0));
  input.add_pole(mesh.vertex(between, 1), 2);
  input.add_pole(smf_test::vertex(20), 3);
  input.add_pole(smf_test::vertex(41), 4);
  const System system(mesh, input);
  auto weight = get(CGAL::dynamic_edge_property_t<double>(), mesh);
  for (const auto e : edges(mesh))
    put(weight, e, 1);
  const Foliation expected = SMF::harmonic_foliation(system, SMF::parameters::weights(weight));
  put(weight, between, 1e22);
  const Foliation found = SMF::harmonic_foliation(system, SMF::parameters::weights(weight));
  EXPECT_TRUE(found.statistics().has_converged);
  for (const auto e : edges(mesh))
    EXPECT_NEAR(found.edge_value(e), expected.edge_value(e), 1e-10);
}

} // namespace test_harmonic_foliation
