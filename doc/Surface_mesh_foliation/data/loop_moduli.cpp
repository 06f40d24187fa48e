// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How fast moduli of homotopy classes of loops converge to those of smooth surfaces, in closed
// form. Prints a line per resolution: the number of vertices around the surface, and by how much
// the modulus is too small, relative to it: around a capsule with four poles, around a tube of
// varying width between two openings, around the tube of a torus, and in a disk around two poles.

#include "generators/known_moduli.h"
#include "generators/meshes.h"
#include "generators/openings.h"
#include "generators/revolution.h"

#include <CGAL/Surface_mesh_foliation/Poles_and_loops.h>
#include <CGAL/Surface_mesh_foliation/loop_modulus.h>
#include <CGAL/Surface_mesh_foliation/openings.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <vector>

namespace SMF = CGAL::Surface_mesh_foliation;
namespace soups = smf_test::soups;

using Mesh = smf_test::Mesh;
using Input = SMF::Poles_and_loops<Mesh>;
using smf_test::vertex;
using soups::pi;

// of a loop of a system, on the mesh itself
double modulus(const Mesh& mesh, const Input& input, std::size_t loop)
{
  const int all = (std::max)(static_cast<int>(num_vertices(mesh)), 100);
  return SMF::loop_modulus(mesh, input, loop, SMF::parameters::number_of_proxy_vertices(all));
}

double error_on_capsule(std::size_t n)
{
  constexpr double length = 3;
  const auto [soup, poles] = soups::capsule(length, n);
  const Mesh mesh = smf_test::to_mesh(soup);
  Input input;
  for (const std::size_t v : poles)
    input.add_pole(vertex(v));
  input.add_loop(smf_test::section(mesh, 0, 0.501 * length).at(0));
  return 1 - modulus(mesh, input, 4) / smf_test::modulus_of_capsule(length);
}

// The radius of the tube at x is 1 + 0.4 sin x. Its circles are where the modulus of what lies
// before them grows by equal amounts, so that triangles are similar.
double error_on_tube(std::size_t n)
{
  constexpr double length = 6;
  constexpr int fine = 100000;
  const auto radius = [](double x) { return 1 + 0.4 * std::sin(x); };
  double exact = 0;
  std::vector<double> before = {0};
  for (int i = 0; i < fine; ++i)
  {
    const double x = length * (i + 0.5) / fine;
    exact += std::hypot(1, 0.4 * std::cos(x)) / radius(x) * length / fine / (2 * pi);
    before.push_back(exact);
  }
  const auto circles = static_cast<std::size_t>(std::round(exact * static_cast<double>(n)));
  std::vector<soups::Profile_point> profile;
  for (std::size_t c = 0, i = 0; c <= circles; ++c)
  {
    while (i < fine && before[i] < exact * static_cast<double>(c) / static_cast<double>(circles))
      ++i;
    const double x = length * static_cast<double>(i) / fine;
    profile.push_back({x, radius(x)});
  }
  const Mesh mesh = smf_test::to_open_mesh(soups::tube_of_revolution(profile, n));
  Input input;
  SMF::add_border_poles(mesh, input);
  return 1 - modulus(mesh, input, 0) / exact;
}

// radii 2 and 1
double error_on_torus(std::size_t n)
{
  const Mesh mesh = smf_test::torus(2 * n, n, 2, 1);
  Input input;
  input.add_loop(smf_test::section(mesh, 0, 0.01).at(0));
  return 1 - modulus(mesh, input, 0) / std::sqrt(3.);
}

// the loop beside the border; the poles are halfway from the center to the border
double error_on_disk(std::size_t n)
{
  const std::size_t circles = n / 4;
  const Mesh mesh = smf_test::to_open_mesh(soups::disk(circles, n));
  Input input;
  SMF::add_border_poles(mesh, input);
  input.add_pole(vertex((circles / 2 - 1) * n));
  input.add_pole(vertex((circles / 2 - 1) * n + n / 2));
  return 1 - modulus(mesh, input, 0) / (smf_test::ratio_of_elliptic_integrals(0.25) / 8);
}

int main()
try
{
  for (const std::size_t n : {16, 32, 64, 128, 256})
    std::printf("%zu,%.1e,%.1e,%.1e,%.1e\n", n, error_on_capsule(n), error_on_tube(n),
                error_on_torus(n), error_on_disk(n));
  return EXIT_SUCCESS;
}
catch (const std::exception& exception)
{
  std::cerr << exception.what() << std::endl;
  return EXIT_FAILURE;
}
