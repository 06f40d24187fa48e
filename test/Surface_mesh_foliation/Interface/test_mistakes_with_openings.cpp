// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What is refused on meshes with openings, and how it is said.

#include "include/open_meshes.h"
#include "include/solved_open_meshes.h"

#include <CGAL/Surface_mesh_foliation/loops.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace test_mistakes_with_openings {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
namespace soups = smf_test::soups;
using smf_test::Mesh;
using smf_test::Open_case;
using Point = Mesh::Point;
using Input = SMF::Poles_and_loops<Mesh>;
using Halfedge = Mesh::Halfedge_index;
using smf_test::all_cases;

} // namespace

namespace {

std::vector<SMF::Problem> problems_of(const Mesh& mesh, const Input& input)
{
  const std::vector<SMF::Problem> result = SMF::validate(mesh, input);
  EXPECT_FALSE(result.empty());
  return result.empty() ? std::vector<SMF::Problem>(1) : result;
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

} // namespace

TEST(Mistakes_with_openings, an_opening_that_is_no_pole)
{
  const Mesh mesh = smf_test::to_open_mesh(
    soups::without_caps(soups::icosphere(2), {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}}, 0.9));
  Input input;
  input.add_border_pole(smf_test::border_halfedges(mesh).at(1));
  const SMF::Problem problem = problems_of(mesh, input)[0];
  EXPECT_EQ(problem.kind, SMF::Problem_kind::NOT_CLOSED);
  EXPECT_TRUE(contains(problem.message, "3 openings")) << problem.message;
  EXPECT_TRUE(contains(problem.message, "2 of them are no poles")) << problem.message;
  EXPECT_TRUE(contains(problem.message, "add_border_pole")) << problem.message;
  EXPECT_THROW(SMF::Loop_system<Mesh>(mesh, input), SMF::Invalid_mesh_exception);
}

TEST(Mistakes_with_openings, a_halfedge_that_is_no_border)
{
  const Mesh mesh = smf_test::to_open_mesh(soups::plane_annulus(8, 3));
  const Halfedge border = smf_test::border_halfedges(mesh)[0];
  const auto inner = std::find_if(halfedges(mesh).begin(), halfedges(mesh).end(),
                                  [&](Halfedge h) { return !CGAL::is_border_edge(h, mesh); });
  for (const Halfedge h : {opposite(border, mesh), *inner})
  {
    Input input;
    input.add_border_pole(h);
    const SMF::Problem problem = problems_of(mesh, input)[0];
    EXPECT_EQ(problem.kind, SMF::Problem_kind::INVALID_POLE);
    EXPECT_TRUE(contains(problem.message, "pole 0")) << problem.message;
  }
  const Mesh closed = smf_test::icosphere(1);
  Input input;
  input.add_border_pole(*halfedges(closed).begin());
  EXPECT_EQ(problems_of(closed, input)[0].kind, SMF::Problem_kind::INVALID_POLE);
}

TEST(Mistakes_with_openings, the_same_opening_twice)
{
  const Mesh mesh = smf_test::to_open_mesh(soups::plane_annulus(8, 3));
  Input input = smf_test::openings_and_poles(mesh);
  input.add_border_pole(next(smf_test::border_halfedges(mesh)[1], mesh));
  const SMF::Problem problem = problems_of(mesh, input)[0];
  EXPECT_EQ(problem.kind, SMF::Problem_kind::INVALID_POLE);
  EXPECT_TRUE(contains(problem.message, "poles 1 and 2")) << problem.message;
}

TEST(Mistakes_with_openings, borders_that_share_a_vertex)
{
  // two faces at one vertex are missing that are not neighbors
  const smf_test::Triangle_soup sphere = soups::icosphere(1);
  std::vector<soups::Triangle> at_vertex;
  for (const soups::Triangle& t : sphere.triangles)
    if (std::find(t.begin(), t.end(), sphere.triangles[0][0]) != t.end())
      at_vertex.push_back(t);
  const auto shared = [&](const soups::Triangle& t) {
    return std::count_if(t.begin(), t.end(), [&](std::size_t v) {
      return std::find(at_vertex[0].begin(), at_vertex[0].end(), v) != at_vertex[0].end();
    });
  };
  const soups::Triangle other = *std::find_if(
    at_vertex.begin(), at_vertex.end(), [&](const soups::Triangle& t) { return shared(t) == 1; });
  const smf_test::Triangle_soup soup = soups::with_faces(
    sphere, [&](const soups::Triangle& t) { return t != at_vertex[0] && t != other; });
  const std::vector<SMF::Problem> problems =
    SMF::check_triangle_soup(soup, SMF::parameters::allow_openings(true));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].kind, SMF::Problem_kind::NOT_MANIFOLD);
}

TEST(Mistakes_with_openings, a_pole_on_a_border)
{
  const Mesh mesh = smf_test::to_open_mesh(soups::plane_annulus(8, 3));
  const SMF::Problem problem = problems_of(mesh, smf_test::openings_and_poles(mesh, {0}))[0];
  EXPECT_EQ(problem.kind, SMF::Problem_kind::INVALID_POLE);
  EXPECT_TRUE(contains(problem.message, "an opening is a pole")) << problem.message;
}

TEST(Mistakes_with_openings, a_disk_without_another_pole)
{
  for (const smf_test::Triangle_soup& soup :
       {soups::part_below(soups::icosphere(2), 2, 0.3),
        smf_test::Triangle_soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
                                {{0, 1, 2}, {1, 3, 2}}},
        smf_test::Triangle_soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}})
  {
    const Mesh mesh = smf_test::to_open_mesh(soup);
    const SMF::Problem problem = problems_of(mesh, smf_test::openings_and_poles(mesh))[0];
    EXPECT_EQ(problem.kind, SMF::Problem_kind::INESSENTIAL_LOOP) << problem.message;
    EXPECT_EQ(problem.loops, std::vector<std::size_t>{0});
  }
}

TEST(Mistakes_with_openings, a_loop_in_an_ear)
{
  const auto& cases = all_cases();
  const Open_case& open = *std::find_if(
    cases.begin(), cases.end(), [](const Open_case& c) { return c.name == "ear with a vertex"; });
  const Mesh mesh = smf_test::to_open_mesh(open.soup);
  Input input = smf_test::openings_and_poles(mesh, open.poles);
  EXPECT_TRUE(SMF::validate(mesh, input).empty());
  input.add_loop(SMF::pole_loop(smf_test::vertex(open.soup.points.size() - 1), mesh));
  EXPECT_EQ(problems_of(mesh, input)[0].kind, SMF::Problem_kind::INESSENTIAL_LOOP);
}

TEST(Mistakes_with_openings, a_loop_that_crosses_a_border)
{
  const Mesh mesh = smf_test::to_open_mesh(soups::plane_annulus(8, 3));
  Input input = smf_test::openings_and_poles(mesh);
  const Halfedge border = smf_test::border_halfedges(mesh)[0];
  SMF::Loop<Mesh> loop;
  for (const Halfedge h : halfedges_around_face(opposite(border, mesh), mesh))
    loop.push_back({h, 0.5});
  input.add_loop(loop);
  const std::vector<SMF::Problem> problems = problems_of(mesh, input);
  EXPECT_TRUE(std::any_of(problems.begin(), problems.end(), [](const SMF::Problem& problem) {
    return problem.kind == SMF::Problem_kind::INVALID_LOOP && contains(problem.message, "border");
  }));
}

TEST(Mistakes_with_openings, an_edge_cycle_with_an_opening_to_its_left)
{
  const std::size_t n = 8;
  const Mesh mesh = smf_test::to_open_mesh(soups::plane_annulus(n, 3));
  std::vector<Mesh::Vertex_index> inner, outer;
  for (std::size_t j = 0; j < n; ++j)
  {
    inner.push_back(smf_test::vertex(j));
    outer.push_back(smf_test::vertex(2 * n + j));
  }
  // counterclockwise, so that the hole is to the left of the inner one
  EXPECT_THROW(SMF::loop_from_edge_cycle(inner, mesh), SMF::Invalid_loops_exception);
  EXPECT_EQ(SMF::loop_from_edge_cycle(outer, mesh).size(), 2 * n);
  std::reverse(inner.begin(), inner.end());
  std::reverse(outer.begin(), outer.end());
  EXPECT_EQ(SMF::loop_from_edge_cycle(inner, mesh).size(), 2 * n);
  EXPECT_THROW(SMF::loop_from_edge_cycle(outer, mesh), SMF::Invalid_loops_exception);
  try
  {
    SMF::loop_from_edge_cycle(outer, mesh);
  }
  catch (const SMF::Invalid_loops_exception& exception)
  {
    EXPECT_TRUE(contains(exception.what(), "opening of the mesh to its left")) << exception.what();
  }
}

} // namespace test_mistakes_with_openings
