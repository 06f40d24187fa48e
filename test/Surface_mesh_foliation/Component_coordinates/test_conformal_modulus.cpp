// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The conformal modulus of components: on tori where it is known, as the resolution grows, and what
// the weights have to do with it.

#include "include/conformal_tori.h"
#include "include/example_systems.h"
#include "generators/meshes.h"
#include "generators/Random.h"
#include "generators/soups.h"
#include "include/uv_mesh.h"

#include <CGAL/Surface_mesh_foliation/Component_coordinates.h>

#include <CGAL/boost/graph/iterator.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <vector>

namespace test_conformal_modulus {

namespace {

using smf_test::Item;
using smf_test::Mesh;
using smf_test::Uv_mesh;
namespace SMF = CGAL::Surface_mesh_foliation;
namespace soups = smf_test::soups;

using Foliation = SMF::Measured_foliation<Mesh>;
using Coordinates = SMF::Component_coordinates<Mesh>;

// the foliation of a torus with one loop and cotangent weights
struct Torus
{
  Torus(const soups::Torus_of_revolution& surface, std::size_t m, std::size_t n, bool is_meridian)
    : mesh(smf_test::to_mesh(surface.soup(m, n))),
      input(smf_test::poles_and_loops(
        {{Item::CYCLE, is_meridian ? smf_test::meridian(0, n) : smf_test::longitude(0, m, n)}},
        mesh)),
      system(mesh, input),
      foliation(SMF::harmonic_foliation(system, SMF::parameters::weights(SMF::Cotangent_weights())))
  {}

  Mesh mesh;
  SMF::Poles_and_loops<Mesh> input;
  SMF::Loop_system<Mesh> system;
  Foliation foliation;
};

// The energy of u and v less twice the area of their image, divided by this: 0 if the map is
// conformal.
double conformal_energy(const Uv_mesh& uv_mesh)
{
  double energy = 0, total = 0;
  for (const auto f : faces(uv_mesh.mesh))
  {
    total += uv_mesh.area_of(f);
    for (const auto h : CGAL::halfedges_around_face(halfedge(f, uv_mesh.mesh), uv_mesh.mesh))
    {
      const auto g = next(h, uv_mesh.mesh), i = next(g, uv_mesh.mesh);
      const auto a =
        uv_mesh.mesh.point(target(i, uv_mesh.mesh)) - uv_mesh.mesh.point(target(h, uv_mesh.mesh));
      const auto b =
        uv_mesh.mesh.point(target(g, uv_mesh.mesh)) - uv_mesh.mesh.point(target(h, uv_mesh.mesh));
      const double cotangent = a * b / std::sqrt(CGAL::cross_product(a, b).squared_length());
      for (int k : {0, 1})
        energy += cotangent / 2 * std::pow(uv_mesh.uv[g][k] - uv_mesh.uv[i][k], 2);
    }
  }
  return energy / (2 * total) - 1;
}

TEST(Modulus, of_a_torus_of_revolution_converges_at_second_order)
{
  for (const double small_radius : {1., 2.})
    for (const bool is_meridian : {true, false})
    {
      const soups::Torus_of_revolution surface(3, small_radius, 0.1);
      const double exact = is_meridian ? 1 / surface.ratio() : surface.ratio();
      double last_error = 0, last_energy = 0;
      for (std::size_t level = 0; level < 3; ++level)
      {
        const std::size_t n = std::size_t(16) << level;
        const Torus torus(surface, surface.number_of_rows(16) << level, n, is_meridian);
        const double error =
          std::abs(SMF::component_shape(torus.foliation, 0).modulus() / exact - 1);
        const Uv_mesh uv_mesh((Coordinates(torus.foliation)));
        const double energy = conformal_energy(uv_mesh);
        for (const auto f : faces(uv_mesh.mesh))
          EXPECT_GT(uv_mesh.area_of(f), 0);
        std::cout << "R/r " << 3 / small_radius << (is_meridian ? ", meridian" : ", longitude")
                  << ", n " << n << ": modulus error " << error << ", conformal energy " << energy;
        if (level > 0)
        {
          std::cout << ", orders " << std::log2(last_error / error) << ' '
                    << std::log2(last_energy / energy);
          EXPECT_GT(std::log2(last_error / error), 1.8);
          EXPECT_GT(std::log2(last_energy / energy), 1.8);
        }
        std::cout << std::endl;
        last_error = error;
        last_energy = energy;
      }
      EXPECT_LT(last_error, 2e-3);
    }
}

// A flat torus is one by its weights, wherever its vertices are.
class Flat_torus
{
public:
  // the step from row to row is (0.9, shear), that along a row (0, 1)
  Flat_torus(std::size_t m, std::size_t n, double shear)
    : mesh(smf_test::to_mesh(soups::Torus_of_revolution(3, 1, 0).soup(m, n))),
      weight(mesh.add_property_map<Mesh::Edge_index, double>("e:weight", 0).first),
      m_m(m),
      m_n(n),
      m_step({0.9, shear, 0})
  {
    smf_test::Random random(3);
    for (std::size_t i = 0; i < m * n; ++i)
      m_noise.push_back({random.between(-0.05, 0.05), random.between(-0.05, 0.05), 0});
    for (std::size_t i = 0; i < m; ++i)
      for (std::size_t j = 0; j < n; ++j)
      {
        const std::size_t even = i % 2 == 0 ? 1 : 0; // as staggered_triangles()
        add({{{i, j}, {i + 1, j + 1 - even}, {i, j + 1}}});
        add({{{i, j + even}, {i + 1, j}, {i + 1, j + 1}}});
      }
  }

  // of leaves along a row, or across
  double modulus(bool is_along_row) const
  {
    const soups::Point across = soups::scaled(m_step, static_cast<double>(m_m));
    const soups::Point along = {0, static_cast<double>(m_n), 0};
    const soups::Point& loop = is_along_row ? along : across;
    return std::abs(soups::cross(across, along)[2]) / soups::dot(loop, loop);
  }

  Mesh mesh;
  Mesh::Property_map<Mesh::Edge_index, double> weight; // half the sum of both cotangents

private:
  using Place = std::array<std::size_t, 2>; // not reduced modulo m and n

  soups::Point point(const Place& p) const
  {
    const auto [i, j] = p;
    const soups::Point along = {0, static_cast<double>(j) + (i % 2 == 0 ? 0 : 0.5), 0};
    return soups::sum(soups::sum(along, m_step, static_cast<double>(i)),
                      m_noise[i % m_m * m_n + j % m_n]);
  }

  Mesh::Vertex_index vertex(const Place& p) const
  {
    return smf_test::vertex(p[0] % m_m * m_n + p[1] % m_n);
  }

  void add(const std::array<Place, 3>& triangle)
  {
    for (std::size_t k : {0, 1, 2})
    {
      const Place &p = triangle[(k + 1) % 3], &q = triangle[(k + 2) % 3];
      const soups::Point a = soups::sum(point(p), point(triangle[k]), -1);
      const soups::Point b = soups::sum(point(q), point(triangle[k]), -1);
      const auto [h, exists] = halfedge(vertex(p), vertex(q), mesh);
      ASSERT_TRUE(exists);
      weight[edge(h, mesh)] += soups::dot(a, b) / std::abs(soups::cross(a, b)[2]) / 2;
    }
  }

  std::size_t m_m, m_n;
  soups::Point m_step;
  std::vector<soups::Point> m_noise;
};

// There t is linear, and the modulus exact on any mesh that is Delaunay in the flat metric.
TEST(Modulus, of_a_flat_torus_is_exact)
{
  const std::size_t m = 12, n = 10;
  for (const double shear : {0., 0.15, -0.2})
    for (const bool is_along_row : {true, false})
    {
      const Flat_torus torus(m, n, shear);
      const Item loop = {
        Item::CYCLE, is_along_row ? smf_test::meridian(0, n) : smf_test::longitude(0, m, n), 2.5};
      const SMF::Loop_system<Mesh> system(torus.mesh,
                                          smf_test::poles_and_loops({loop}, torus.mesh));
      const Foliation foliation =
        SMF::harmonic_foliation(system, SMF::parameters::weights(torus.weight));
      const double exact = torus.modulus(is_along_row);
      EXPECT_NEAR(SMF::component_shape(foliation, 0).modulus(), exact, 1e-11 * exact);
      const Uv_mesh uv_mesh((Coordinates(foliation)));
      for (const auto f : faces(uv_mesh.mesh))
        EXPECT_GT(uv_mesh.area_of(f), 0);
    }
}

// Each bisection of edges adds log(2) / (2 pi) at each of the two poles.
TEST(Modulus, grows_with_the_logarithm_of_the_resolution_at_poles)
{
  double last = 0;
  for (int level = 2; level < 6; ++level)
  {
    const smf_test::Triangle_soup soup = soups::icosphere(level);
    const Mesh mesh = smf_test::to_mesh(soup);
    const SMF::Loop_system<Mesh> system(
      mesh,
      smf_test::poles_and_loops(smf_test::pole_items({smf_test::extreme_vertex(soup, {0, 0, 1}),
                                                      smf_test::extreme_vertex(soup, {0, 0, -1})}),
                                mesh));
    const Foliation foliation =
      SMF::harmonic_foliation(system, SMF::parameters::weights(SMF::Cotangent_weights()));
    const double modulus = SMF::component_shape(foliation, 0).modulus();
    if (level > 2)
    {
      EXPECT_NEAR(modulus - last, std::log(2) / soups::pi, 0.03 * std::log(2) / soups::pi);
    }
    last = modulus;
  }
}

// With cotangents the modulus belongs to the shape, with mean values to its size as well.
TEST(Modulus, of_mean_value_weights_is_not_conformal)
{
  const Torus torus(soups::Torus_of_revolution(3, 1, 0.1), 52, 16, true);
  Mesh large = torus.mesh;
  for (const auto v : vertices(large))
    large.point(v) = CGAL::ORIGIN + 4 * (large.point(v) - CGAL::ORIGIN);
  const SMF::Loop_system<Mesh> system(
    large, smf_test::poles_and_loops({{Item::CYCLE, smf_test::meridian(0, 16)}}, large));
  const auto modulus = [](const Foliation& foliation) {
    return SMF::component_shape(foliation, 0).modulus();
  };
  const double cotangent =
    modulus(SMF::harmonic_foliation(system, SMF::parameters::weights(SMF::Cotangent_weights())));
  EXPECT_NEAR(cotangent, modulus(torus.foliation), 1e-11 * cotangent);
  const double small_mean_value = modulus(SMF::harmonic_foliation(torus.system));
  EXPECT_NEAR(modulus(SMF::harmonic_foliation(system)), 4 * small_mean_value,
              1e-9 * small_mean_value);
}

} // namespace

} // namespace test_conformal_modulus
