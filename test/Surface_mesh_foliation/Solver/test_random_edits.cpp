// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Edits of poles and loops, one after another with one solver on one mesh: each gives the foliation
// that a new solver finds.
//
// The environment variable SMF_TEST_EDITS says how many there are on each mesh; the target
// thousand_edits makes a thousand.

#include "generators/Random.h"
#include "include/edge_value_difference.h"
#include "include/number_from_environment.h"
#include "include/random_systems.h"

#include <CGAL/Surface_mesh_foliation/Foliation_solver.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>

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
  return {{"sphere", icosphere(4)},
          {"limbs", limbed_sphere(5, 4)},
          {"noise", noisy(icosphere(4), 0.2, 7)},
          {"torus", torus(40, 24, 3, 1)},
          {"genus_3", genus_surface(3, 4, 11)}};
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

} // namespace

} // namespace test_random_edits
