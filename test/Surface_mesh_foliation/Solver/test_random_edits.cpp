// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Edits of poles and loops, one after another with one solver on one mesh: each gives the foliation
// that a new solver finds. A pole that is dragged takes the last foliation with it.
//
// The environment variable SMF_TEST_EDITS says how many there are on each mesh; the target
// thousand_edits makes a thousand.

#include "generators/Random.h"
#include "include/edge_value_difference.h"
#include "include/number_from_environment.h"
#include "include/random_systems.h"

#include <CGAL/Surface_mesh_foliation/Foliation_solver.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Pushed_pole.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace test_random_edits {

using namespace smf_test;
using System = SMF::Loop_system<Mesh>;
using Foliation = SMF::Measured_foliation<Mesh>;

namespace {

// the default linear solver, that counts
struct Counting_solver : SMF::Supernodal_cholesky_solver
{
  int factorizations = 0;
  bool factorize(const Eigen::SparseMatrix<double>& matrix)
  {
    ++factorizations;
    return SMF::Supernodal_cholesky_solver::factorize(matrix);
  }
};

class Random_edits
{
public:
  Random_edits(const Mesh& mesh, Random& random, std::vector<Item> items)
    : m_random(random), m_new_items(mesh, random), m_items(std::move(items))
  {}

  const std::vector<Item>& items() const { return m_items; }

  // Makes an edit that leaves a valid system.
  void next()
  {
    for (;;)
    {
      std::vector<Item> edited = m_items;
      edit(edited);
      if (!m_new_items.is_valid(edited))
        continue;
      m_items = edited;
      return;
    }
  }

private:
  void edit(std::vector<Item>& items)
  {
    Item& item = items[m_random.index(items.size())];
    switch (m_random.index(6))
    {
    case 0:
      item.height = m_new_items.height();
      break;
    case 1: // a pole moves over some edges
    case 2:
      if (item.kind == Item::POLE)
        for (std::size_t steps = 1 + m_random.index(10); steps > 0; --steps)
          item.vertices[0] = static_cast<std::size_t>(
            m_new_items.neighbor(Vertex(static_cast<Mesh::size_type>(item.vertices[0]))));
      break;
    case 3:
      if (items.size() > 2)
        items.erase(items.begin() + (&item - items.data()));
      break;
    case 4:
      if (items.size() < 10)
        items.push_back(m_new_items.pole(items));
      break;
    default:
      if (items.size() < 10)
        items.push_back(m_random.index(2) == 0 ? m_new_items.ball() : m_new_items.handle());
    }
  }

  Random& m_random;
  Random_items m_new_items;
  std::vector<Item> m_items;
};

struct Case
{
  std::string name;
  Mesh mesh;
  std::vector<std::size_t> poles; // that are dragged
};

std::ostream& operator<<(std::ostream& out, const Case& c)
{
  return out << c.name;
}

std::string name_of_case(const testing::TestParamInfo<Case>& info)
{
  return info.param.name;
}

std::vector<Case> cases()
{
  return {{"sphere", icosphere(4), {0, 40, 90, 600}},
          {"limbs", limbed_sphere(5, 4), {0, 20, 60, 150, 300}},
          {"noise", noisy(icosphere(4), 0.2, 7), {0, 40, 90, 600}},
          {"torus", torus(40, 24, 3, 1), {3, 200, 777}},
          {"genus_3", genus_surface(3, 4, 11), {5, 99, 400}}};
}

Input input_of(const std::vector<std::size_t>& poles)
{
  Input result;
  for (const std::size_t v : poles)
    result.add_pole(Vertex(static_cast<Mesh::size_type>(v)));
  return result;
}

class Random_edits_of : public testing::TestWithParam<Case>
{};

TEST_P(Random_edits_of, each_gives_what_a_new_solver_finds)
{
  const std::size_t number_of_edits = number_from_environment("SMF_TEST_EDITS", 12);
  const Mesh& mesh = GetParam().mesh;
  Random random(20);
  Random_edits edits(mesh, random, {{Item::POLE, {0}}, {Item::POLE, {100}}, {Item::POLE, {300}}});
  Counting_solver linear_solver;
  SMF::Foliation_solver<Mesh, Counting_solver> solver(linear_solver);
  System system(mesh, poles_and_loops(edits.items(), mesh));
  solver.solve(system);
  double largest_difference = 0;
  for (std::size_t i = 0; i < number_of_edits; ++i)
  {
    edits.next();
    SCOPED_TRACE("edit " + std::to_string(i) + ": " + to_string(edits.items()));
    const Input input = poles_and_loops(edits.items(), mesh);
    system = System(system, input);
    const Foliation foliation = solver.solve(system);
    EXPECT_TRUE(foliation.statistics().has_converged);
    EXPECT_TRUE(foliation.statistics().is_certified);
    const Foliation cold = SMF::harmonic_foliation(System(mesh, input));
    largest_difference = std::max(largest_difference, difference(foliation, cold));
    EXPECT_LT(difference(foliation, cold), 1e-9);
  }
  RecordProperty("largest_difference", std::to_string(largest_difference));
  std::cout << number_of_edits << " edits, " << linear_solver.factorizations
            << " factorizations, largest difference " << largest_difference << std::endl;
}

INSTANTIATE_TEST_SUITE_P(Shapes, Random_edits_of, testing::ValuesIn(cases()), name_of_case);

// Nothing is coarsened, and nothing factored, when a pole is dragged inside its component.
TEST(Edits, a_dragged_pole_goes_on_from_the_last_solution)
{
  struct Counting_visitor : SMF::Default_foliation_visitor
  {
    explicit Counting_visitor(int* number) : coarse_iterations(number) {}
    int* coarse_iterations;
    bool after_coarse_iteration(std::size_t, const SMF::Foliation_statistics&)
    {
      ++*coarse_iterations;
      return true;
    }
  };
  for (const Case& c : cases())
  {
    SCOPED_TRACE(c.name);
    Counting_solver linear_solver;
    SMF::Foliation_solver<Mesh, Counting_solver> solver(linear_solver);
    System system(c.mesh, input_of(c.poles));
    solver.solve(system);
    const int factorizations = linear_solver.factorizations;
    std::vector<std::size_t> poles = c.poles;
    for (int step = 0; step < 4; ++step)
    {
      const auto h = halfedge(Vertex(static_cast<Mesh::size_type>(poles[0])), c.mesh);
      poles[0] = static_cast<std::size_t>(source(h, c.mesh));
      system = System(system, input_of(poles));
      int coarse_iterations = 0;
      const Foliation foliation =
        solver.solve(system, CGAL::parameters::visitor(Counting_visitor(&coarse_iterations)));
      EXPECT_EQ(coarse_iterations, 0);
      EXPECT_TRUE(foliation.statistics().is_certified);
      EXPECT_LT(difference(foliation, SMF::harmonic_foliation(System(c.mesh, input_of(poles)))),
                1e-9);
    }
    EXPECT_LE(linear_solver.factorizations, factorizations + 2);
  }
}

TEST(Pushed_pole, is_found_only_if_one_vertex_has_moved_inside_its_arc)
{
  using SMF::internal::Pushed_pole;
  const Case c = cases()[1];
  const System system(c.mesh, input_of(c.poles));
  const Foliation foliation = SMF::harmonic_foliation(system);
  const auto is_found = [&](const Input& input) {
    return Pushed_pole::find(foliation.state(), System(system, input).data().flat).has_value();
  };
  const auto neighbor = [&](std::size_t v) {
    const auto h = halfedge(Vertex(static_cast<Mesh::size_type>(v)), c.mesh);
    return static_cast<std::size_t>(source(h, c.mesh));
  };
  std::vector<std::size_t> poles = c.poles;
  poles[2] = neighbor(poles[2]);
  EXPECT_TRUE(is_found(input_of(poles)));
  poles[3] = neighbor(poles[3]);
  EXPECT_FALSE(is_found(input_of(poles))); // two have moved
  poles = c.poles;
  EXPECT_FALSE(is_found(input_of(poles))); // none has
  poles.pop_back();
  EXPECT_FALSE(is_found(input_of(poles)));
  for (std::size_t v = 0; v < num_vertices(c.mesh); v += 10) // into another component
    if (foliation.cell(Vertex(static_cast<Mesh::size_type>(v))).is_arc &&
        foliation.cell(Vertex(static_cast<Mesh::size_type>(v))).index != 0 &&
        std::count(c.poles.begin(), c.poles.end(), v) == 0)
    {
      poles = c.poles;
      poles[0] = v;
      EXPECT_FALSE(is_found(input_of(poles))) << v;
    }
  EXPECT_FALSE(Pushed_pole::find(
    foliation.state(), System(c.mesh, input_of(c.poles)).data().flat)); // not a copy of the mesh
}

} // namespace

} // namespace test_random_edits
