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
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
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

// From the definition: the lowest vertex `v` such that the vertices from above down to it that are
// connected with the highest one, with the edges and faces between them, are a disk.
int last_disk(const Flat_mesh& mesh, const Values& values)
{
  int highest = 0;
  for (int v = 0; v < mesh.number_of_vertices(); ++v)
    if (is_above(values, v, highest))
      highest = v;
  int result = highest;
  for (int lowest = 0; lowest < mesh.number_of_vertices(); ++lowest)
  {
    std::set<int> hill = {highest};
    std::vector<int> stack = {highest};
    while (!stack.empty())
    {
      const int v = stack.back();
      stack.pop_back();
      for (int h : mesh.ring(v))
        if (!is_above(values, lowest, mesh.target(h)) && hill.insert(mesh.target(h)).second)
          stack.push_back(mesh.target(h));
    }
    int euler = static_cast<int>(hill.size());
    for (int e = 0; e < mesh.number_of_edges(); ++e)
    {
      const int h = CGAL::Surface_mesh_foliation::internal::halfedge_of(e);
      euler -= hill.count(mesh.source(h)) > 0 && hill.count(mesh.target(h)) > 0;
    }
    for (int f = 0; f < mesh.number_of_faces(); ++f)
    {
      bool is_inside = true;
      for (int h : mesh.halfedges(f))
        is_inside = is_inside && hill.count(mesh.source(h)) > 0;
      euler += is_inside;
    }
    if (euler == 1 && hill.count(lowest) > 0 && is_above(values, result, lowest))
      result = lowest;
  }
  return result;
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
    if (pass < 0)
      pass = mesh.genus() > 0 ? last_disk(mesh, values) : lowest;
    result[v] = values[v] / values[pass];
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

// A ring whose crest is nearly of one height, and the same with a limb.
TEST(Persistent_maxima, are_no_tips_of_rings)
{
  const std::size_t m = 24, n = 12;
  const Flat_mesh mesh = smf_test::flat_mesh(smf_test::soups::torus(m, n, 3, 1));
  Values values(mesh.number_of_vertices());
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < n; ++j)
      values[i * n + j] = 10 + 5 * std::cos(2 * std::acos(-1) * j / n) + 0.001 * std::cos(i * i);
  EXPECT_LT(Persistent_maxima(mesh, values).maxima()[0].persistence, 1.001);
  values[5 * n] = 40;
  for (int h : mesh.ring(5 * n))
    values[mesh.target(h)] = 30;
  const Persistent_maxima with_limb(mesh, values);
  EXPECT_EQ(with_limb.maxima()[0].vertex, static_cast<int>(5 * n));
  EXPECT_GT(with_limb.maxima()[0].persistence, 2.6);
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
