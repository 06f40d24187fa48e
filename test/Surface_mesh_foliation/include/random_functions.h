// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_RANDOM_FUNCTIONS_H
#define SMF_TEST_RANDOM_FUNCTIONS_H

#include "brute_force_reeb_graph.h"
#include "generators/genus_soups.h"
#include "generators/meshes.h"
#include "generators/Random.h"
#include "generators/soups.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

// Small surfaces of genus 0 to 5, and random functions on them: with and without ties.

namespace smf_test {

struct Surface
{
  std::size_t genus;
  Triangle_soup soup;
  Edges_of_soup edges;
  Mesh mesh;

  explicit Surface(const Triangle_soup& s)
    : genus(soups::genus(s)), soup(s), edges(soup), mesh(to_mesh(soup))
  {}
};

inline const std::vector<Surface>& surfaces()
{
  static const std::vector<Surface> result = [] {
    std::vector<Surface> surfaces;
    for (const Triangle_soup& soup :
         {soups::tetrahedron(), soups::octahedron(), soups::icosphere(1), soups::torus(3, 3, 3, 1),
          soups::torus(7, 5, 3, 1), soups::genus_surface(2, 1), soups::genus_surface(3, 1),
          soups::genus_surface(4, 1), soups::genus_surface(5, 1)})
      surfaces.emplace_back(soup);
    return surfaces;
  }();
  return result;
}

// kind 0: no ties. 1: many ties. 2: few different values. 3: constant. 4: smooth, so few nodes
inline std::vector<double> random_function(const Surface& surface, std::size_t kind, Random& random)
{
  std::vector<double> result;
  const std::array<double, 3> direction = {random.between(-1, 1), random.between(-1, 1),
                                           random.between(-1, 1)};
  for (const auto& p : surface.soup.points)
    result.push_back(kind == 0 ? random.between(-1, 1)
                     : kind == 1
                       ? static_cast<double>(random.index(surface.soup.points.size() / 3 + 1))
                     : kind == 2 ? static_cast<double>(random.index(3))
                     : kind == 3 ? 7.
                                 : direction[0] * p[0] + direction[1] * p[1] + direction[2] * p[2]);
  return result;
}

// calls check(surface, values) with many functions
template <class Check>
void for_each_function(int number_per_surface, const Check& check)
{
  Random random(5);
  for (const Surface& surface : surfaces())
    for (int i = 0; i < number_per_surface && !testing::Test::HasFailure(); ++i)
    {
      SCOPED_TRACE("genus " + std::to_string(surface.genus) + ", function " + std::to_string(i));
      check(surface, random_function(surface, static_cast<std::size_t>(i % 5), random));
    }
}

} // namespace smf_test

#endif // SMF_TEST_RANDOM_FUNCTIONS_H
