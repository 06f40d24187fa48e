// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "generators/genus_soups.h"
#include "generators/meshes.h"
#include "include/flat_meshes.h"

#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Spread_source.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace test_spread_source {

namespace {

using namespace CGAL::Surface_mesh_foliation::internal;
namespace soups = smf_test::soups;

// what flows out of a vertex
double flux(const Flat_mesh& mesh, const Eigen::VectorXd& u, int v)
{
  double result = 0;
  for (const int h : mesh.ring(v))
    result += u[v] - u[mesh.target(h)];
  return result;
}

} // namespace

TEST(Spread_source, makes_one_place_of_its_vertices)
{
  for (const smf_test::Triangle_soup& soup :
       {soups::icosphere(2), soups::torus(12, 9, 3, 1), soups::genus_surface(2, 2)})
  {
    const Flat_mesh mesh = smf_test::flat_mesh(soup);
    Vertex_potentials potentials(mesh, std::vector<double>(mesh.number_of_edges(), 1));
    const int sink = mesh.number_of_vertices() / 2;
    std::vector<int> vertices = {0};
    for (const int h : mesh.ring(0))
      if (mesh.target(h) != sink)
        vertices.push_back(mesh.target(h));
    const Spread_source source(potentials, vertices);
    const Eigen::VectorXd u = source.minus(potentials.of_source(sink));
    double sum = 0;
    std::vector<bool> is_source(mesh.number_of_vertices(), false);
    for (const int v : vertices)
    {
      EXPECT_NEAR(u[v], u[0], 1e-12);
      sum += flux(mesh, u, v);
      is_source[v] = true;
    }
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_NEAR(flux(mesh, u, 0), 0, 1e-12); // nothing flows inside the place
    for (int v = 0; v < mesh.number_of_vertices(); ++v)
      if (!is_source[v])
      {
        EXPECT_NEAR(flux(mesh, u, v), v == sink ? -1 : 0, 1e-12);
        EXPECT_LT(u[v], u[0]);
      }
  }
}

TEST(Spread_source, of_one_vertex_is_a_source)
{
  const Flat_mesh mesh = smf_test::flat_mesh(soups::icosphere(2));
  Vertex_potentials potentials(mesh, std::vector<double>(mesh.number_of_edges(), 1));
  const Eigen::VectorXd of_sink = potentials.of_source(5);
  const Eigen::VectorXd u = Spread_source(potentials, {7}).minus(of_sink);
  EXPECT_LT((u - (potentials.of_source(7) - of_sink)).norm(), 1e-12);
}

} // namespace test_spread_source
