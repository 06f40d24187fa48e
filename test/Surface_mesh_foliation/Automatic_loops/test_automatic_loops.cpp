// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Loops that are proposed for poles: they show all handles but short ones, lie on level sets, and
// do not depend on the order of vertices.

#include "generators/meshes.h"
#include "generators/Random.h"
#include "include/loop_system_counts.h"
#include "include/problem_of.h"

#include <CGAL/Surface_mesh_foliation/IO/read_triangle_mesh.h>
#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/automatic_loops.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Automatic_loops/Proposed_loops.h>
#include <CGAL/Surface_mesh_foliation/loops.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace test_automatic_loops {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
namespace np = SMF::parameters;
using smf_test::Mesh;
using smf_test::number_of_cycles;
using smf_test::Random;
using smf_test::total_region_genus;
using smf_test::vertex;
using Input = SMF::Poles_and_loops<Mesh>;
using System = SMF::Loop_system<Mesh>;
using Function = Mesh::Property_map<Mesh::Vertex_index, double>;

// ===  Meshes, poles and functions

Mesh surface(std::size_t genus, std::uint64_t seed)
{
  return smf_test::noisy(seed % 2 == 0 || genus == 0 ? smf_test::handle_surface(genus, seed)
                                                     : smf_test::genus_surface(genus, 2, seed),
                         0.05, seed);
}

// calls check(mesh) with meshes of genus 0 to 5
void for_each_surface(const std::function<void(const Mesh&)>& check)
{
  for (std::size_t genus = 0; genus <= 5; ++genus)
    for (std::uint64_t seed : {1, 2})
    {
      SCOPED_TRACE("genus " + std::to_string(genus) + ", seed " + std::to_string(seed));
      check(surface(genus, seed));
    }
}

Input random_poles(const Mesh& mesh, std::size_t number, std::uint64_t seed)
{
  Input result;
  const std::vector<std::size_t> vertices = Random(seed).permutation(num_vertices(mesh));
  for (std::size_t p = 0; p < number; ++p)
    result.add_pole(vertex(vertices[p]));
  return result;
}

// The walk from a random vertex, always to a neighbor that is next to no other vertex of the walk.
std::vector<Mesh::Vertex_index> random_line(const Mesh& mesh, std::size_t length, Random& random)
{
  std::vector<Mesh::Vertex_index> line = {vertex(random.index(num_vertices(mesh)))};
  const auto is_next = [&](Mesh::Vertex_index v) {
    return std::all_of(line.begin(), line.end(), [&](Mesh::Vertex_index u) {
      return u != v && (u == line.back()) == halfedge(u, v, mesh).second;
    });
  };
  while (line.size() < length)
  {
    std::vector<Mesh::Vertex_index> candidates;
    for (const auto v : CGAL::vertices_around_target(line.back(), mesh))
      if (is_next(v))
        candidates.push_back(v);
    if (candidates.empty())
      break;
    line.push_back(candidates[random.index(candidates.size())]);
  }
  return line;
}

// kind 0: height. 1: random. 2: a few different values. 3: constant
Function function_of_kind(std::size_t kind, Mesh& mesh, std::uint64_t seed)
{
  const Function result = mesh.add_property_map<Mesh::Vertex_index, double>("v:function").first;
  Random random(seed);
  for (const auto v : vertices(mesh))
    result[v] = kind == 0   ? mesh.point(v).z()
                : kind == 1 ? random.between(-1, 1)
                : kind == 2 ? static_cast<double>(random.index(3))
                            : 7.;
  return result;
}

// ===  What the system has

// the proposal is accepted, and shows every handle
void expect_all_handles(const Mesh& mesh, const Input& input)
{
  if (input.size() == 0)
  {
    EXPECT_EQ(smf_test::genus(mesh), 0u);
    return;
  }
  const System system(mesh, input);
  EXPECT_EQ(number_of_cycles(system), system.genus());
  EXPECT_EQ(total_region_genus(system), 0u);
}

// ===  Proposals

TEST(Propose_loops, every_handle_is_shown)
{
  for_each_surface([](const Mesh& mesh) {
    const std::size_t genus = smf_test::genus(mesh);
    for (const std::size_t number_of_poles : {0, 1, 2, 5})
    {
      if (genus == 0 && number_of_poles == 1)
        continue;
      Input input = random_poles(mesh, number_of_poles, genus);
      const std::size_t number = SMF::propose_loops(mesh, input);
      EXPECT_EQ(input.size(), number_of_poles + number);
      if (genus == 0)
      {
        EXPECT_EQ(number, 0u); // a star
      }
      else
      {
        EXPECT_GE(number, genus);
      }
      expect_all_handles(mesh, input);
    }
  });
}

// Then the pieces are pairs of pants: 2g - 2 + p of them, with three arc ends each.
TEST(Propose_loops, poles_as_punctures_give_as_many_loops_as_there_can_be)
{
  for_each_surface([](const Mesh& mesh) {
    const std::size_t genus = smf_test::genus(mesh);
    for (const std::size_t number_of_poles : {0, 1, 2, 3, 4, 7})
    {
      if (2 * genus + number_of_poles < 3)
        continue;
      Input input = random_poles(mesh, number_of_poles, genus + 1);
      const std::size_t number = SMF::propose_loops(mesh, input, np::use_poles_as_punctures(true));
      EXPECT_EQ(number, 3 * genus + number_of_poles - 3);
      expect_all_handles(mesh, input);
    }
  });
}

TEST(Propose_loops, small_and_symmetric_meshes)
{
  for (const bool is_punctured : {false, true})
  {
    const auto parameters = np::use_poles_as_punctures(is_punctured);
    const Mesh tetrahedron = smf_test::tetrahedron();
    Input all_corners = random_poles(tetrahedron, 4, 1);
    EXPECT_EQ(SMF::propose_loops(tetrahedron, all_corners, parameters), is_punctured ? 1u : 0u);
    expect_all_handles(tetrahedron, all_corners);
    const Mesh torus = smf_test::torus(3, 3, 3, 1);
    for (const std::size_t number_of_poles : {0, 1, 2, 9})
    {
      Input input = random_poles(torus, number_of_poles, 2);
      const std::size_t number = SMF::propose_loops(torus, input, parameters);
      EXPECT_GE(number, 1u);
      if (is_punctured)
      {
        EXPECT_LE(number, std::max<std::size_t>(1, number_of_poles)); // fewer: a pole at a saddle
      }
      expect_all_handles(torus, input);
    }
  }
}

TEST(Propose_loops, any_function_and_line_poles)
{
  std::size_t number_of_lines = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Mesh mesh = seed % 2 == 0 ? smf_test::genus_surface(random.index(4), 2, seed)
                              : smf_test::handle_surface(random.index(4), seed);
    const Function function = function_of_kind(random.index(4), mesh, seed);
    Input input;
    for (std::size_t i = random.index(4); i > 0; --i)
    {
      input.add_line_pole(random_line(mesh, 1 + random.index(8), random));
      const auto problems = SMF::validate(mesh, input);
      if (!problems.empty() && problems[0].kind == SMF::Problem_kind::INVALID_POLE)
        input = Input(); // they meet
    }
    for (const auto& entry : input.entries())
      number_of_lines += entry.pole.size() > 1;
    if (smf_test::genus(mesh) == 0 && input.size() < 2)
      continue;
    for (const bool is_punctured : {false, true})
    {
      const auto parameters = np::use_poles_as_punctures(is_punctured);
      Input by_distance = input, by_function = input;
      SMF::propose_loops(mesh, by_distance, parameters);
      SMF::propose_loops(mesh, by_function,
                         np::combine(parameters, np::vertex_scalar_map(function)));
      expect_all_handles(mesh, by_distance);
      expect_all_handles(mesh, by_function);
    }
  }
  EXPECT_GT(number_of_lines, 20u);
}

TEST(Propose_loops, loops_lie_on_level_sets_of_the_function)
{
  Mesh mesh = smf_test::torus(20, 12, 3, 1);
  const Function function = mesh.add_property_map<Mesh::Vertex_index, double>("v:f").first;
  for (const auto v : vertices(mesh))
    function[v] = mesh.point(v).x() + 0.01 * mesh.point(v).z();
  Input input;
  ASSERT_EQ(SMF::propose_loops(mesh, input, np::vertex_scalar_map(function)), 1u);
  double low = -10, high = 10;
  for (const auto& crossing : input.entries()[0].loop)
  {
    EXPECT_LT(function[source(crossing.halfedge, mesh)], function[target(crossing.halfedge, mesh)]);
    low = std::max(low, function[source(crossing.halfedge, mesh)]);
    high = std::min(high, function[target(crossing.halfedge, mesh)]);
  }
  EXPECT_LT(low, high);
  EXPECT_LT(std::abs(low + high), 1.); // halfway between saddles at -2 and 2
}

// ===  Relabeling

// Loops as sets of crossings of the original mesh: from vertex, to vertex, position.
using Crossings = std::set<std::tuple<std::size_t, std::size_t, double>>;

std::set<Crossings> loops_by_label(const Mesh& mesh,
                                   const Input& input,
                                   const std::vector<std::size_t>& label_of_vertex)
{
  std::set<Crossings> result;
  for (const auto& entry : input.entries())
  {
    Crossings crossings;
    for (const auto& crossing : entry.loop)
    {
      const std::size_t u = label_of_vertex[source(crossing.halfedge, mesh)];
      const std::size_t v = label_of_vertex[target(crossing.halfedge, mesh)];
      crossings.emplace(u, v, std::round(crossing.position * 1e9)); // 1 - x rounds
    }
    if (!crossings.empty())
      result.insert(crossings);
  }
  return result;
}

// Without symmetry, the loops are not only homotopic but the same.
void expect_no_dependence_on_order(std::size_t genus,
                                   std::size_t number_of_poles,
                                   bool is_punctured,
                                   double length)
{
  const Mesh mesh = surface(genus, number_of_poles + 1);
  std::vector<std::size_t> identity(num_vertices(mesh));
  std::iota(identity.begin(), identity.end(), std::size_t(0));
  const auto poles = Random(7).permutation(num_vertices(mesh));
  const auto propose = [&](const Mesh& m, const std::vector<std::size_t>& new_label) {
    Input input;
    for (std::size_t p = 0; p < number_of_poles; ++p)
      input.add_pole(vertex(new_label[poles[p]]));
    SMF::propose_loops(
      m, input,
      np::combine(np::use_poles_as_punctures(is_punctured), np::min_relative_loop_length(length)));
    return input;
  };
  const auto expected = loops_by_label(mesh, propose(mesh, identity), identity);
  EXPECT_FALSE(expected.empty());
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
  {
    const Mesh other = smf_test::relabeled(mesh, seed);
    const auto new_label = smf_test::new_labels(num_vertices(mesh), seed);
    std::vector<std::size_t> old_label(new_label.size());
    for (std::size_t v = 0; v < new_label.size(); ++v)
      old_label[new_label[v]] = v;
    EXPECT_EQ(loops_by_label(other, propose(other, new_label), old_label), expected);
  }
}

TEST(Propose_loops, the_order_of_vertices_and_faces_does_not_matter)
{
  for (const std::size_t number_of_poles : {0, 1, 4})
  {
    expect_no_dependence_on_order(1, number_of_poles, false, 0);
    expect_no_dependence_on_order(4, number_of_poles, false, 0);
    expect_no_dependence_on_order(4, number_of_poles, true, 0);
    expect_no_dependence_on_order(5, number_of_poles, false, 0.3);
  }
}

// ===  Small handles

TEST(Propose_loops, the_handle_of_a_short_loop_is_not_shown)
{
  const Mesh torus = smf_test::torus(40, 20, 3, 0.5); // around the tube: 3.1
  const double diagonal = std::hypot(7., 7., 1.);
  for (const double length : {3., 5.})
  {
    Input absolute = random_poles(torus, 1, 1), relative = absolute;
    SMF::propose_loops(torus, absolute, np::min_loop_length(length));
    SMF::propose_loops(torus, relative, np::min_relative_loop_length(length / diagonal));
    EXPECT_EQ(absolute.size(), relative.size());
    const System system(torus, absolute);
    EXPECT_EQ(number_of_cycles(system), length < 4 ? 1u : 0u);
    EXPECT_EQ(total_region_genus(system), length < 4 ? 0u : 1u);
  }
}

TEST(Propose_loops, more_and_more_handles_are_left_out)
{
  for (std::uint64_t seed : {1, 2, 3, 4})
  {
    const Mesh mesh = surface(5, seed);
    std::set<std::size_t> numbers;
    std::size_t before = 5;
    for (double length = 0; length < 60; length = length * 1.3 + 0.1)
    {
      Input input = random_poles(mesh, 3, seed);
      SMF::propose_loops(mesh, input, np::min_loop_length(length));
      const System system(mesh, input);
      EXPECT_EQ(number_of_cycles(system) + total_region_genus(system), 5u);
      EXPECT_LE(number_of_cycles(system), before);
      before = number_of_cycles(system);
      numbers.insert(before);
      if (before == 0)
      {
        EXPECT_EQ(input.size(), 3u); // a star
      }
    }
    EXPECT_GT(numbers.size(), 2u);
    EXPECT_EQ(before, 0u);
  }
}

// ===  A real mesh

TEST(Propose_loops, elephant)
{
  const std::string folder = SMF_DATA_DIR;
  if (folder.empty())
    GTEST_SKIP() << "no folder with CGAL's meshes";
  Mesh mesh;
  SMF::read_triangle_mesh(folder + "/elephant.off", mesh);
  for (const std::vector<std::size_t>& poles :
       {std::vector<std::size_t>{}, {2759, 2555, 2047, 1671, 2279, 1401, 982}})
  {
    Input input;
    for (std::size_t v : poles)
      input.add_pole(vertex(v));
    SMF::propose_loops(mesh, input);
    expect_all_handles(mesh, input);
    EXPECT_EQ(number_of_cycles(System(mesh, input)), 3u);
  }
}

// ===  Errors

template <class NamedParameters>
SMF::Problem problem_with(const Mesh& mesh, Input input, const NamedParameters& parameters)
{
  return smf_test::problem_of([&] { SMF::propose_loops(mesh, input, parameters); });
}

TEST(Propose_loops, errors_say_what_is_wrong)
{
  Mesh mesh = smf_test::torus(7, 5, 3, 1);
  const auto defaults = CGAL::parameters::default_values();
  Input with_loop = random_poles(mesh, 2, 1);
  with_loop.add_loop(SMF::pole_loop(vertex(0), mesh));
  EXPECT_EQ(problem_with(mesh, with_loop, defaults).loops, std::vector<std::size_t>{2});
  Input with_wide_loop;
  with_wide_loop.add_pole(vertex(0), SMF::pole_loop(vertex(0), mesh, 2));
  EXPECT_EQ(problem_with(mesh, with_wide_loop, defaults).loops, std::vector<std::size_t>{0});
  Input twice;
  twice.add_pole(vertex(3));
  twice.add_pole(vertex(3));
  EXPECT_EQ(problem_with(mesh, twice, defaults).kind, SMF::Problem_kind::INVALID_POLE);
  EXPECT_EQ(problem_with(mesh, Input(), np::min_loop_length(-1.)).kind,
            SMF::Problem_kind::INVALID_PARAMETER);
  EXPECT_EQ(problem_with(mesh, Input(), np::min_relative_loop_length(std::nan(""))).kind,
            SMF::Problem_kind::INVALID_PARAMETER);
  const Function function = function_of_kind(0, mesh, 1);
  function[vertex(6)] = std::numeric_limits<double>::infinity();
  const SMF::Problem problem = problem_with(mesh, Input(), np::vertex_scalar_map(function));
  EXPECT_EQ(problem.kind, SMF::Problem_kind::NOT_FINITE);
  EXPECT_EQ(problem.vertices, std::vector<std::size_t>{6});
  mesh.add_vertex();
  EXPECT_EQ(problem_with(mesh, Input(), defaults).kind, SMF::Problem_kind::ISOLATED_VERTEX);
}

} // namespace

} // namespace test_automatic_loops
