// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Canonical loops depend on nothing but the shape: neither on the order of vertices and poles, nor
// on the triangles, nor on which sweeps proposed candidates.
//
// That holds for separating loops above the bound, and for others with moduli above 1, which
// Minsky's inequality makes unique, if the mesh that moduli are computed on resolves what they go
// around. So coarse meshes are subdivided first, and shared meshes with handles, which may be
// small, or made of needles, are taken if they are not decimated, and not remeshed.
//
// The environment variables SMF_TEST_VARIANTS and SMF_TEST_SWEEPS say how many variants and further
// sweeps are looked at; if one is set, on shared meshes of any size. The target canonical_shapes
// looks at many.

#include "generators/Random.h"
#include "generators/meshes.h"
#include "generators/revolution.h"
#include "include/number_from_environment.h"

#include <CGAL/Surface_mesh_foliation/IO/read_triangle_mesh.h>
#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/canonical_loops.h>
#include <CGAL/Surface_mesh_foliation/feature_poles.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/Poll.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace test_canonical_shapes {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
using namespace smf_test;
using Poles = std::vector<Mesh::Vertex_index>;

const std::size_t number_of_variants = number_from_environment("SMF_TEST_VARIANTS", 2);
const std::size_t number_of_sweeps = number_from_environment("SMF_TEST_SWEEPS", 3);
const bool takes_time = number_of_variants + number_of_sweeps > 5;

struct Shape
{
  std::string name;
  Mesh mesh;
  Poles poles;
  bool is_to_be_remeshed = true;
};

std::vector<Shape> shapes()
{
  std::vector<Shape> result;
  const auto [capsule, ends] = soups::capsule(5, 40);
  Poles four;
  for (const std::size_t v : ends)
    four.push_back(vertex(v));
  result.push_back({"capsule", to_mesh(capsule), four});
  result.push_back({"genus 2", noisy(genus_surface(2, 4, 3), 0.1, 3), {}});
  result.push_back({"limbs", to_mesh(soups::limbed_sphere(7, 4)), {}});
  const std::string shared = SMF_SHARED_DIR;
  for (const std::string& file : all_shared_meshes(shared.empty() ? "" : shared + "/meshes"))
  {
    Mesh mesh;
    SMF::read_triangle_mesh(file, mesh);
    if (takes_time || num_vertices(mesh) <= (genus(mesh) == 0 ? 7000u : 5000u))
      result.push_back({std::filesystem::path(file).stem().string(), mesh, {}, genus(mesh) == 0});
  }
  for (Shape& shape : result)
  {
    if (shape.poles.empty())
      SMF::detect_feature_poles(shape.mesh, std::back_inserter(shape.poles));
    if (num_vertices(shape.mesh) < 3000 && genus(shape.mesh) == 0)
      shape.mesh = midpoint_subdivided(shape.mesh); // whose first vertices are the same
  }
  return result;
}

SMF::Poles_and_loops<Mesh> with_poles(const Poles& poles)
{
  SMF::Poles_and_loops<Mesh> result;
  for (const auto v : poles)
    result.add_pole(v);
  return result;
}

// the poles on the side of an arc without the first one; none if the arc does not separate
std::vector<int> poles_beyond(const SMF::Loop_system<Mesh>& system, std::size_t arc)
{
  std::vector<bool> is_reached(system.number_of_nodes(), false);
  std::vector<std::size_t> stack = {system.node(arc, 0)};
  while (!stack.empty())
  {
    const std::size_t node = stack.back();
    stack.pop_back();
    if (is_reached[node])
      continue;
    is_reached[node] = true;
    for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
      for (const int end : {0, 1})
        if (a != arc && system.node(a, end) == node)
          stack.push_back(system.node(a, 1 - end));
  }
  std::vector<int> result;
  if (is_reached[system.node(arc, 1)])
    return result;
  bool has_first = false;
  for (std::size_t node = 0; node < system.number_of_nodes(); ++node)
    has_first = has_first || (is_reached[node] && system.pole(node) == 0);
  for (std::size_t node = 0; node < system.number_of_nodes(); ++node)
    if (is_reached[node] != has_first && system.pole(node) >= 0)
      result.push_back(system.pole(node));
  std::sort(result.begin(), result.end());
  return result;
}

// The moduli of the canonical loops, by whether they separate the surface, and which poles from the
// first one: all of them, down to a little below the bound.
using Signature = std::multimap<std::pair<bool, std::vector<int>>, double>;

constexpr double bound = SMF::default_min_modulus, tolerance = 0.04;

Signature signature(const Mesh& mesh, const Poles& poles)
{
  SMF::Poles_and_loops<Mesh> input = with_poles(poles);
  const auto loops = SMF::canonical_loops(
    mesh, input, SMF::parameters::min_modulus(bound * (1 - tolerance)).show_handles(false));
  Signature result;
  if (loops.empty())
    return result;
  const SMF::Loop_system<Mesh> system(mesh, input);
  for (std::size_t i = 0; i < loops.size(); ++i)
    result.emplace(std::pair(loops[i].is_separating, poles_beyond(system, poles.size() + i)),
                   loops[i].modulus);
  return result;
}

// whether every unique loop of one that is not too close to the bound is in the other
bool is_part(const Signature& one, Signature other)
{
  for (const auto& [kind, modulus] : one)
  {
    if (modulus < (kind.first ? bound : 1) * (1 + tolerance))
      continue;
    const auto [begin, end] = other.equal_range(kind);
    auto found = other.end(); // the nearest one
    double least = tolerance;
    for (auto it = begin; it != end; ++it)
      if (const double difference = std::abs(it->second / modulus - 1); difference < least)
      {
        found = it;
        least = difference;
      }
    if (found == other.end())
      return false;
    other.erase(found);
  }
  return true;
}

std::string text(const Signature& signature)
{
  std::string result;
  for (const auto& [kind, modulus] : signature)
  {
    result += kind.first ? " {" : " around a handle {";
    for (const int pole : kind.second)
      result += ' ' + std::to_string(pole);
    result += " } " + std::to_string(modulus);
  }
  return result;
}

// with edges of about the same length, whichever that is
Mesh remeshed(const Mesh& mesh, std::uint64_t seed)
{
  using Kernel_with_predicates = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Exact_mesh = CGAL::Surface_mesh<Kernel_with_predicates::Point_3>;
  const Triangle_soup soup = to_soup(mesh);
  Exact_mesh result = to_mesh<Exact_mesh>(soup);
  const double length = soups::mean_edge_length(soup) * Random(seed).between(0.8, 1.2);
  CGAL::Polygon_mesh_processing::isotropic_remeshing(faces(result), length, result,
                                                     CGAL::parameters::number_of_iterations(3));
  result.collect_garbage();
  return to_mesh(to_soup(result));
}

// the vertices nearest to those of another mesh
Poles nearest(const Mesh& mesh, const Mesh& other, const Poles& poles)
{
  Poles result;
  for (const auto p : poles)
    result.push_back(
      *std::min_element(vertices(mesh).begin(), vertices(mesh).end(), [&](auto u, auto v) {
        return CGAL::squared_distance(mesh.point(u), other.point(p)) <
               CGAL::squared_distance(mesh.point(v), other.point(p));
      }));
  return result;
}

} // namespace

TEST(Canonical_shapes, do_not_depend_on_order_or_triangles)
{
  for (const Shape& shape : shapes())
  {
    SCOPED_TRACE(shape.name);
    const Signature expected = signature(shape.mesh, shape.poles);
    std::size_t equal = 0;
    for (std::size_t k = 1; k <= number_of_variants; ++k)
    {
      Mesh variant;
      Poles poles;
      if (k % 2 == 1 || !shape.is_to_be_remeshed)
      {
        variant = relabeled(shape.mesh, k);
        const std::vector<std::size_t> label = new_labels(num_vertices(shape.mesh), k);
        for (const auto v : shape.poles)
          poles.push_back(vertex(label[v]));
      }
      else
      {
        variant = remeshed(shape.mesh, k);
        poles = nearest(variant, shape.mesh, shape.poles);
      }
      const Signature found = signature(variant, poles);
      const bool is_equal = is_part(expected, found) && is_part(found, expected);
      EXPECT_TRUE(is_equal) << "variant " << k << ":" << text(found) << "\ninstead of"
                            << text(expected);
      equal += is_equal;
    }
    std::cout << shape.name << ": " << equal << " of " << number_of_variants
              << " variants have the same loops:" << text(expected) << std::endl;
  }
}

TEST(Canonical_shapes, do_not_depend_on_which_sweeps_proposed_candidates)
{
  for (const Shape& shape : shapes())
  {
    SCOPED_TRACE(shape.name);
    const SMF::internal::Checked_mesh<Mesh> checked(shape.mesh, CGAL::parameters::default_values());
    const std::vector<SMF::internal::Pole> poles =
      SMF::internal::poles_to_sweep_from(with_poles(shape.poles), checked.index, checked.capped);
    const SMF::internal::Proxy proxy(checked.flat, poles, {}, 5000);
    Random random(1);
    std::vector<std::vector<int>> sweeps(number_of_sweeps);
    for (std::vector<int>& sources : sweeps)
      for (std::size_t i = 0, number = 1 + random.index(4); i < number; ++i)
        sources.push_back(static_cast<int>(
          random.index(static_cast<std::size_t>(proxy.mesh().number_of_vertices()))));
    const auto moduli = [&](const std::vector<std::vector<int>>& more) {
      std::vector<double> result;
      const SMF::internal::Flat_loop_hierarchy hierarchy(
        proxy.mesh(), proxy.lengths(), proxy.poles(), SMF::internal::poll_nobody, 0, more);
      for (const auto& loop : hierarchy.loops())
        if (loop.modulus >= bound)
          result.push_back(loop.modulus);
      return result;
    };
    const std::vector<double> expected = moduli({}), found = moduli(sweeps);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_NEAR(found[i], expected[i], 1e-6 * expected[i]);
    std::cout << shape.name << ": " << number_of_sweeps << " more sweeps change none of "
              << expected.size() << " loops" << std::endl;
  }
}

} // namespace test_canonical_shapes
