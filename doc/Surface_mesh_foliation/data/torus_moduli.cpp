// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How fast moduli and coordinates of a component converge to conformal ones: on the torus of
// revolution with radii 3 and 1, for leaves around the tube and around the axis. Prints a line per
// resolution: the number of vertices around the tube, the relative errors of the two moduli, and
// how far the two energies are above those of a conformal map.

#include <CGAL/Surface_mesh_foliation.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <vector>

namespace SMF = CGAL::Surface_mesh_foliation;

using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;
using Uv = SMF::Component_coordinates<Mesh>::Uv;

constexpr double pi = 3.14159265358979323846;
constexpr double large_radius = 3, small_radius = 1;

// The metric (R + r cos psi)^2 dx^2 + r^2 dpsi^2 is, with
// tan(psi/2) = sqrt((R+r)/(R-r)) tan(y/2), a multiple of dx^2 + (r^2 / (R^2-r^2)) dy^2: that of a
// rectangle with sides of this ratio, around the tube to around the axis.
const double ratio =
  small_radius / std::sqrt(large_radius * large_radius - small_radius * small_radius);

// The coordinates are bent, so that no symmetry helps.
Point_3 point(double a, double b)
{
  constexpr double skew = 0.1;
  const double x = a + skew * std::sin(b + 0.3);
  const double y = b + skew * (std::sin(a) + std::sin(2 * b + 1) / 2);
  const double stretch = std::sqrt((large_radius + small_radius) / (large_radius - small_radius));
  const double psi = 2 * std::atan2(stretch * std::sin(y / 2), std::cos(y / 2));
  const double distance = large_radius + small_radius * std::cos(psi);
  return {distance * std::cos(x), distance * std::sin(x), small_radius * std::sin(psi)};
}

// A torus with m rows of n vertices around the tube, vertex i * n + j in row i. Every other row is
// shifted by half a step, so that triangles are nearly equilateral. m is even.
Mesh torus(std::size_t m, std::size_t n)
{
  Mesh mesh;
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < n; ++j)
      mesh.add_vertex(
        point(2 * pi * static_cast<double>(i) / static_cast<double>(m),
              2 * pi * (static_cast<double>(j) + (i % 2 == 0 ? 0 : 0.5)) / static_cast<double>(n)));
  const auto vertex = [&](std::size_t i, std::size_t j) {
    return Vertex(static_cast<Mesh::size_type>(i % m * n + j % n));
  };
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < n; ++j)
    {
      const Vertex a = vertex(i, j), b = vertex(i, j + 1);
      const Vertex c = vertex(i + 1, j), d = vertex(i + 1, j + 1);
      mesh.add_face(a, i % 2 == 0 ? c : d, b);
      mesh.add_face(i % 2 == 0 ? b : a, c, d);
    }
  return mesh;
}

// A cycle of edges around the tube, or around the axis.
std::vector<Vertex> cycle(std::size_t m, std::size_t n, bool is_around_tube)
{
  std::vector<Vertex> result;
  for (std::size_t i = 0; i < (is_around_tube ? n : m); ++i)
    result.emplace_back(static_cast<Mesh::size_type>(is_around_tube ? i : i * n));
  return result;
}

// The Dirichlet energy of u and v less twice the area of their image, divided by the latter: 0 if
// the map is conformal.
double energy_above_conformal(const SMF::Component_coordinates<Mesh>& coordinates)
{
  Mesh mesh;
  const auto uv = mesh.add_property_map<Halfedge, Uv>("h:uv").first;
  coordinates.uv_mesh(mesh, uv);
  double energy = 0, area = 0;
  for (const auto f : faces(mesh))
  {
    const Halfedge first = mesh.halfedge(f);
    const std::array<Halfedge, 3> h = {first, mesh.next(first), mesh.prev(first)};
    area += ((uv[h[1]][0] - uv[h[0]][0]) * (uv[h[2]][1] - uv[h[0]][1]) -
             (uv[h[1]][1] - uv[h[0]][1]) * (uv[h[2]][0] - uv[h[0]][0])) /
            2;
    for (std::size_t k : {0, 1, 2})
    {
      const Halfedge p = h[(k + 1) % 3], q = h[(k + 2) % 3];
      const auto a = mesh.point(mesh.target(p)) - mesh.point(mesh.target(h[k]));
      const auto b = mesh.point(mesh.target(q)) - mesh.point(mesh.target(h[k]));
      const double cotangent =
        a * b / CGAL::approximate_sqrt(CGAL::cross_product(a, b).squared_length());
      for (int i : {0, 1})
        energy += cotangent / 2 * CGAL::square(uv[p][i] - uv[q][i]);
    }
  }
  return energy / (2 * area) - 1;
}

struct Errors
{
  double modulus, energy;
};

// `n` vertices around the tube, `m` around the axis
Errors errors(const Mesh& mesh, std::size_t m, std::size_t n, bool is_around_tube)
{
  SMF::Poles_and_loops<Mesh> loops;
  loops.add_loop(SMF::loop_from_edge_cycle(cycle(m, n, is_around_tube), mesh));
  const SMF::Loop_system<Mesh> system(mesh, loops);
  const auto foliation =
    SMF::harmonic_foliation(system, SMF::parameters::weights(SMF::Cotangent_weights()));
  const double exact = is_around_tube ? 1 / ratio : ratio;
  return {std::abs(SMF::component_shape(foliation, 0).modulus() / exact - 1),
          energy_above_conformal(SMF::Component_coordinates<Mesh>(foliation))};
}

int main()
try
{
  for (std::size_t level : {0, 1, 2, 3})
  {
    const std::size_t n = std::size_t(16) << level;
    const std::size_t m = 2 * std::lround(16 / ratio / std::sqrt(3.)) << level;
    const Mesh mesh = torus(m, n);
    const Errors tube = errors(mesh, m, n, true), axis = errors(mesh, m, n, false);
    std::printf("%zu,%.1e,%.1e,%.1e,%.1e\n", n, tube.modulus, axis.modulus, tube.energy,
                axis.energy);
  }
  return EXIT_SUCCESS;
}
catch (const std::exception& exception)
{
  std::cerr << exception.what() << std::endl;
  return EXIT_FAILURE;
}
