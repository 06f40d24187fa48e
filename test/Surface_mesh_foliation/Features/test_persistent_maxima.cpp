// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/flat_meshes.h"
#include "generators/Random.h"
#include "generators/soups.h"

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Features/Persistent_maxima.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <vector>

namespace test_persistent_maxima {

namespace {

using CGAL::Surface_mesh_foliation::internal::Flat_mesh;
using CGAL::Surface_mesh_foliation::internal::Maximum;
using CGAL::Surface_mesh_foliation::internal::Persistent_maxima;

using Values = std::vector<double>;

// above in the order of the package: of equal values the first vertex is the higher one
bool is_above(const Values& values, int u, int v)
{
  return values[u] > values[v] || (values[u] == values[v] && u < v);
}

// Whether a walk from `start` that never goes below `level` comes to a vertex above `start`.
bool reaches_higher(const Flat_mesh& mesh, const Values& values, int start, int level)
{
  std::vector<bool> is_visited(values.size(), false);
  std::vector<int> stack = {start};
  is_visited[start] = true;
  while (!stack.empty())
  {
    const int v = stack.back();
    stack.pop_back();
    if (is_above(values, v, start))
      return true;
    for (const int h : mesh.ring(v))
    {
      const int u = mesh.target(h);
      if (!is_visited[u] && !is_above(values, level, u))
      {
        is_visited[u] = true;
        stack.push_back(u);
      }
    }
  }
  return false;
}

// from the definition: by maximum, the value there over that of the highest pass to a higher vertex
std::map<int, double> maxima_by_walking(const Flat_mesh& mesh, const Values& values)
{
  std::map<int, double> result;
  for (int v = 0; v < mesh.number_of_vertices(); ++v)
  {
    const auto ring = mesh.ring(v);
    if (std::any_of(ring.begin(), ring.end(),
                    [&](int h) { return is_above(values, mesh.target(h), v); }))
      continue;
    int pass = -1, lowest = v;
    for (int u = 0; u < mesh.number_of_vertices(); ++u)
    {
      if ((pass < 0 || is_above(values, u, pass)) && reaches_higher(mesh, values, v, u))
        pass = u;
      if (is_above(values, lowest, u))
        lowest = u;
    }
    result[v] = values[v] / values[pass < 0 ? lowest : pass];
  }
  return result;
}

TEST(Persistent_maxima, are_those_of_the_definition)
{
  smf_test::Random random(1);
  for (const auto& soup : {smf_test::soups::icosphere(1), smf_test::soups::torus(7, 5, 2, 1)})
    for (int levels : {2, 5, 1000})
      for (int run = 0; run < 20; ++run)
      {
        const Flat_mesh mesh = smf_test::flat_mesh(soup);
        Values values(mesh.number_of_vertices());
        for (double& value : values)
          value = 1 + static_cast<double>(random.index(levels)); // with ties
        const Persistent_maxima maxima(mesh, values);
        std::map<int, double> found;
        for (const Maximum& maximum : maxima.maxima())
          found[maximum.vertex] = maximum.persistence;
        EXPECT_EQ(found, maxima_by_walking(mesh, values));
        EXPECT_EQ(found.size(), maxima.maxima().size());
      }
}

TEST(Persistent_maxima, come_in_the_order_of_persistence)
{
  smf_test::Random random(2);
  const Flat_mesh mesh = smf_test::flat_mesh(smf_test::soups::icosphere(3));
  Values values(mesh.number_of_vertices());
  for (double& value : values)
    value = random.between(1, 2);
  const Persistent_maxima maxima(mesh, values);
  ASSERT_GT(maxima.maxima().size(), 10u);
  for (std::size_t i = 1; i < maxima.maxima().size(); ++i)
    EXPECT_GE(maxima.maxima()[i - 1].persistence, maxima.maxima()[i].persistence);
  const double largest = *std::max_element(values.begin(), values.end());
  const double smallest = *std::min_element(values.begin(), values.end());
  EXPECT_EQ(values[maxima.maxima()[0].vertex], largest);
  EXPECT_EQ(maxima.maxima()[0].persistence, largest / smallest);
}

TEST(Persistent_maxima, a_constant_function_has_no_persistent_one)
{
  const Flat_mesh mesh = smf_test::flat_mesh(smf_test::soups::icosphere(2));
  const Persistent_maxima maxima(mesh, Values(mesh.number_of_vertices(), 3.));
  for (const Maximum& maximum : maxima.maxima())
    EXPECT_EQ(maximum.persistence, 1);
}

} // namespace

} // namespace test_persistent_maxima
