// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What must hold for every harmonic foliation, on generated meshes of genus 0 to 5 and, if there
// are any, on the shared ones.

#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/lengths.h>
#include <CGAL/Surface_mesh_foliation/leaves.h>
#include <CGAL/Surface_mesh_foliation/singularities.h>

#include "include/component_graph.h"
#include "include/edge_value_difference.h"
#include "include/named_meshes.h"
#include "include/random_systems.h"

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Polygon_mesh_processing/transform.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace test_invariants {

using namespace smf_test;

namespace {

using Foliation = SMF::Measured_foliation<Mesh>;
using Loop = SMF::Loop<Mesh>;

// vertices spread over the numbering
std::vector<Vertex> poles(const Mesh& mesh, std::size_t number)
{
  std::vector<Vertex> result;
  for (std::size_t i = 0; i < number; ++i)
    result.push_back(
      Vertex(static_cast<Mesh::size_type>(num_vertices(mesh) * (2 * i + 1) / (2 * number))));
  return result;
}

bool is_one_of(const std::vector<Vertex>& vertices, std::size_t v)
{
  return std::find(vertices.begin(), vertices.end(), Vertex(static_cast<Mesh::size_type>(v))) !=
         vertices.end();
}

bool meets(const Item& cycle, const std::vector<Vertex>& vertices)
{
  return std::any_of(cycle.vertices.begin(), cycle.vertices.end(),
                     [&](std::size_t v) { return is_one_of(vertices, v); });
}

// Up to two handle loops that are valid together with the poles and run through none of them; from
// genus 1 on there is at least one.
std::vector<Item> handles(const Mesh& mesh, const std::vector<Vertex>& poles)
{
  std::vector<Item> result;
  if (genus(mesh) == 0)
    return result;
  Random random(1);
  Random_items items(mesh, random);
  Input input;
  for (const Vertex v : poles)
    input.add_pole(v);
  for (int attempt = 0; result.size() < 2 && attempt < 20; ++attempt)
  {
    const Item item = items.handle();
    if (item.vertices.empty() || meets(item, poles))
      continue;
    Input with_item = input;
    add_item(item, mesh, with_item);
    if (!SMF::validate(mesh, with_item).empty())
      continue;
    input = with_item;
    result.push_back(item);
  }
  EXPECT_FALSE(result.empty());
  return result;
}

Foliation solve_on(const Mesh& mesh, const Input& input)
{
  return SMF::harmonic_foliation(SMF::Loop_system<Mesh>(mesh, input));
}

// Four poles, and handle loops from genus 1 on.
class Invariants : public testing::TestWithParam<std::string>
{
protected:
  void SetUp() override
  {
    mesh = load(GetParam());
    pole_vertices = poles(mesh, 4);
    handle_loops = handles(mesh, pole_vertices);
  }

  // The poles, then the handle loops; those that `loops` gives by id replace the usual ones, and
  // heights are used in turn.
  Input input(const std::vector<double>& all_heights,
              const std::map<std::size_t, Loop>& loops) const
  {
    Input result;
    for (std::size_t id = 0; id < pole_vertices.size() + handle_loops.size(); ++id)
    {
      const double height = all_heights[id % all_heights.size()];
      const auto loop = loops.find(id);
      const bool is_pole = id < pole_vertices.size();
      if (is_pole && loop == loops.end())
        result.add_pole(pole_vertices[id], height);
      else if (is_pole)
        result.add_pole(pole_vertices[id], loop->second, height);
      else
        result.add_loop(loop == loops.end() ? handle_loop(id, false) : loop->second, height);
    }
    return result;
  }

  Foliation solve(const std::vector<double>& all_heights) const
  {
    return solve_on(mesh, input(all_heights, {}));
  }

  // A loop pushed off its cycle to the left or, the other way round, to the right.
  Loop handle_loop(std::size_t id, bool is_to_the_right) const
  {
    std::vector<Vertex> cycle;
    for (const std::size_t v : handle_loops[id - pole_vertices.size()].vertices)
      cycle.push_back(Vertex(static_cast<Mesh::size_type>(v)));
    if (is_to_the_right)
      std::reverse(cycle.begin(), cycle.end());
    return SMF::loop_from_edge_cycle(cycle, mesh);
  }

  // Other loops of the same classes, one after the other as long as they are valid together:
  // pole loops of some rings, and handle loops on the other side of their cycles.
  std::map<std::size_t, Loop> other_loops(unsigned int rings) const
  {
    std::map<std::size_t, Loop> result;
    for (std::size_t id = 0; id < pole_vertices.size() + handle_loops.size(); ++id)
      try
      {
        std::map<std::size_t, Loop> more = result;
        more[id] = id < pole_vertices.size() ? SMF::pole_loop(pole_vertices[id], mesh, rings)
                                             : handle_loop(id, true);
        if (SMF::validate(mesh, input(heights, more)).empty())
          result = more;
      }
      catch (const SMF::Invalid_loops_exception& exception)
      {
        EXPECT_NE(std::string(exception.what()).find("not one curve"), std::string::npos)
          << exception.what();
      }
    return result;
  }

  const std::vector<double> heights = {1, 0.5, 2, 1.5};
  Mesh mesh;
  std::vector<Vertex> pole_vertices;
  std::vector<Item> handle_loops;
};

} // namespace

TEST_P(Invariants, triangle_inequalities_hold)
{
  const Foliation foliation = solve(heights);
  for (const auto f : faces(mesh))
  {
    std::vector<double> w;
    for (const auto h : halfedges_around_face(halfedge(f, mesh), mesh))
      w.push_back(foliation.edge_value(edge(h, mesh)));
    std::sort(w.begin(), w.end());
    EXPECT_LE(w[2], w[0] + w[1] + 1e-12);
  }
}

TEST_P(Invariants, indices_add_up_and_only_poles_are_positive)
{
  const Foliation foliation = solve(heights);
  const SMF::Loop_system<Mesh>& system = foliation.system();
  std::vector<SMF::Singularity<Mesh>> singularities;
  SMF::singularities(foliation, std::back_inserter(singularities));
  std::vector<int> sum(system.number_of_nodes(), 0);
  for (const auto& singularity : singularities)
  {
    sum[singularity.node] += singularity.index;
    if (singularity.index > 0)
    {
      EXPECT_TRUE(is_one_of(pole_vertices, singularity.vertex));
    }
  }
  int total = 0;
  for (std::size_t r = 0; r < sum.size(); ++r)
  {
    const int characteristic =
      2 - 2 * static_cast<int>(system.genus(r)) - static_cast<int>(system.degree(r));
    EXPECT_EQ(sum[r], 2 * characteristic);
    total += sum[r];
  }
  EXPECT_EQ(total, 4 - 4 * static_cast<int>(system.genus()));
}

// The flux is the same through every leaf of an arc, and height times flux adds up to the energy.
TEST_P(Invariants, flux_is_constant_along_arcs)
{
  const Foliation foliation = solve(heights);
  const auto& state = foliation.state();
  double energy = 0;
  for (std::size_t a = 0; a < foliation.system().number_of_arcs(); ++a)
  {
    const double height = foliation.system().height(a);
    energy += height * foliation.flux(a);
    for (double share : {0.037, 0.21, 0.77, 0.959})
    {
      double flux = 0;
      for (const auto& crossing :
           SMF::internal::crossings_of_level(state, static_cast<int>(a), share * height))
      {
        const int e = SMF::internal::edge_of(crossing.halfedge);
        flux += state.weight(e) * length_of_edge(state, e);
      }
      EXPECT_NEAR(flux / foliation.flux(a), 1, 1e-8);
    }
  }
  EXPECT_NEAR(energy / foliation.statistics().energy, 1, 1e-9);
}

TEST_P(Invariants, motion_and_scale_change_nothing)
{
  const Foliation foliation = solve(heights);
  Mesh moved = mesh;
  const double c = std::cos(0.7), s = std::sin(0.7), scale = 13;
  const CGAL::Aff_transformation_3<Kernel> motion(scale * c, -scale * s, 0, 5, scale * s, scale * c,
                                                  0, -3, 0, 0, scale, 11);
  CGAL::Polygon_mesh_processing::transform(motion, moved);
  // rounded coordinates make other slivers
  const bool has_slivers = GetParam().find("plate") != std::string::npos ||
                           GetParam().find("scorpion_49997") != std::string::npos;
  EXPECT_LT(difference(foliation, solve_on(moved, input(heights, {}))), has_slivers ? 1e-6 : 1e-9);
}

// The graph of the components, which follow the heights, is that of the loops, which do not.
TEST_P(Invariants, heights_do_not_change_the_graph)
{
  for (const std::vector<double>& some : {heights, {100, 0.01, 3, 7}})
  {
    const Foliation foliation = solve(some);
    const Cut_mesh cut(foliation);
    expect_same_surface(cut, mesh);
    expect_annuli(cut, foliation.system().number_of_arcs());
    expect_dual_graph(cut, foliation);
  }
}

TEST_P(Invariants, foliation_is_homogeneous_in_the_heights)
{
  const Foliation foliation = solve(heights);
  std::vector<double> doubled = heights;
  for (double& height : doubled)
    height *= 2;
  const Foliation other = solve(doubled);
  EXPECT_NEAR(other.statistics().energy / foliation.statistics().energy, 4, 1e-9);
  for (const auto e : edges(mesh))
    EXPECT_NEAR(other.edge_value(e), 2 * foliation.edge_value(e), 1e-9);
}

TEST_P(Invariants, position_of_loops_in_their_class_does_not_matter)
{
  const Foliation foliation = solve(heights);
  std::size_t number_of_moved_loops = 0;
  for (unsigned int rings : {2, 3})
  {
    const std::map<std::size_t, Loop> loops = other_loops(rings);
    number_of_moved_loops += loops.size();
    EXPECT_LT(difference(foliation, solve_on(mesh, input(heights, loops))), 1e-9);
  }
  EXPECT_GT(number_of_moved_loops, 0u);
}

TEST_P(Invariants, vertices_in_arcs_lie_strictly_inside)
{
  const Foliation foliation = solve(heights);
  for (const auto v : vertices(mesh))
    if (foliation.cell(v).is_arc)
    {
      EXPECT_GT(foliation.parameter(v), 0);
      EXPECT_LT(foliation.parameter(v), foliation.system().height(foliation.cell(v).index));
    }
    else
    {
      EXPECT_EQ(foliation.parameter(v), 0);
    }
}

TEST_P(Invariants, regular_leaves_are_single_closed_curves)
{
  const Foliation foliation = solve(heights);
  const auto& state = foliation.state();
  for (std::size_t a = 0; a < foliation.system().number_of_arcs(); ++a)
    for (double share : {0.037, 0.5, 0.959})
    {
      const double level = share * foliation.system().height(a);
      const int arc = static_cast<int>(a);
      EXPECT_EQ(SMF::internal::essential_leaf(state, arc, level).size(),
                SMF::internal::crossings_of_level(state, arc, level).size());
    }
}

INSTANTIATE_TEST_SUITE_P(Meshes, Invariants, testing::ValuesIn(all_meshes()), name_of_mesh);

TEST(Invariants_of_classes, pole_loops_of_one_to_five_rings_give_one_foliation)
{
  const Mesh mesh = limbed_sphere(5, 4);
  std::vector<Vertex> tips;
  for (std::size_t v : soups::limb_tips(5, 4))
    tips.push_back(Vertex(static_cast<Mesh::size_type>(v)));
  const std::vector<double> heights = {1, 2, 0.5, 1.5, 1};
  const auto solution = [&](unsigned int rings) {
    Input input;
    for (std::size_t i = 0; i < tips.size(); ++i)
      input.add_pole(tips[i], SMF::pole_loop(tips[i], mesh, rings), heights[i]);
    return solve_on(mesh, input);
  };
  const Foliation foliation = solution(1);
  for (unsigned int rings : {2, 3, 4, 5})
    EXPECT_LT(difference(foliation, solution(rings)), 1e-9);
}

} // namespace test_invariants
