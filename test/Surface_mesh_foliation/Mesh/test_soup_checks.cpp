// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What `check_triangle_soup()` is made of: each check on the smallest soups that pass or fail it.

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Triangle_soup.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/face_messages.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/soup_problems.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/Disjoint_sets.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Soup_edges.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Soup_orientation_check.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/build_triangle_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/checked_flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/soup_element_checks.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/soup_surface_checks.h>

#include "generators/Random.h"
#include "generators/soups.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace test_soup_checks {

using namespace CGAL::Surface_mesh_foliation::internal;
namespace SMF = CGAL::Surface_mesh_foliation;
namespace soups = smf_test::soups;
using SMF::Problem;
using SMF::Problem_kind;
using SMF::Triangle_soup;
using Numbers = std::vector<std::size_t>;

namespace {

const std::vector<std::array<double, 3>> four_points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

void expect_problem(const std::optional<Problem>& problem,
                    Problem_kind kind,
                    const Numbers& vertices,
                    const Numbers& faces)
{
  ASSERT_TRUE(problem);
  EXPECT_EQ(problem->kind, kind) << problem->message;
  EXPECT_EQ(problem->vertices, vertices) << problem->message;
  EXPECT_EQ(problem->faces, faces) << problem->message;
  EXPECT_TRUE(problem->loops.empty());
}

std::vector<Triangle_soup> good_soups()
{
  return {soups::tetrahedron(), soups::octahedron(), soups::torus(4, 5, 3, 1)};
}

} // namespace

// ===  Disjoint_sets.h

TEST(Disjoint_sets, are_the_classes_of_the_pairs)
{
  constexpr std::size_t n = 40;
  smf_test::Random random(3);
  Disjoint_sets sets(n);
  Numbers label(n); // brute force
  for (std::size_t i = 0; i < n; ++i)
    EXPECT_EQ(sets.find_set(i), label[i] = i);
  for (int step = 0; step < 35; ++step)
  {
    const std::size_t i = random.index(n), j = random.index(n);
    sets.union_set(i, j);
    const std::size_t from = label[i], to = label[j];
    std::replace(label.begin(), label.end(), from, to);
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t l = 0; l < n; ++l)
        ASSERT_EQ(sets.find_set(k) == sets.find_set(l), label[k] == label[l]);
  }
  Disjoint_sets none(0); // and nothing happens
}

// ===  Soup_edges.h

TEST(Soup_edges, sides_and_faces)
{
  EXPECT_EQ(Soup_edges::next(3), 4u);
  EXPECT_EQ(Soup_edges::next(5), 3u);
  EXPECT_EQ(Soup_edges::face(5), 1u);
  const Soup_edges none(Triangle_soup{});
  EXPECT_EQ(none.size(), 0u);
}

TEST(Soup_edges, are_the_pairs_of_vertices_in_lexicographic_order)
{
  std::vector<Triangle_soup> all = good_soups();
  all.push_back({four_points, {{0, 1, 2}}});
  all.push_back({four_points, {{3, 1, 0}, {1, 3, 2}, {3, 1, 2}, {0, 1, 3}}}); // anything goes
  for (const Triangle_soup& soup : all)
  {
    std::map<std::pair<std::size_t, std::size_t>, Numbers> expected;
    for (std::size_t side = 0; side < 3 * soup.triangles.size(); ++side)
    {
      const std::size_t a = soup.triangles[side / 3][side % 3];
      const std::size_t b = soup.triangles[side / 3][(side % 3 + 1) % 3];
      expected[std::minmax(a, b)].push_back(side);
    }
    const Soup_edges edges(soup);
    ASSERT_EQ(edges.size(), expected.size());
    std::size_t edge = 0;
    for (const auto& [ends, sides] : expected)
    {
      ASSERT_EQ(edges.number_of_sides(edge), sides.size());
      for (std::size_t i = 0; i < sides.size(); ++i)
      {
        const std::size_t side = edges.side(edge, i);
        EXPECT_EQ(side, sides[i]);
        const std::pair<std::size_t, std::size_t> found =
          std::minmax({edges.source(side), edges.target(side)});
        EXPECT_EQ(found, ends);
      }
      ++edge;
    }
  }
}

// ===  soup_element_checks.h

TEST(Soup_element_checks, pass_good_soups)
{
  for (const Triangle_soup& soup : good_soups())
  {
    EXPECT_FALSE(find_emptiness(soup));
    EXPECT_FALSE(find_index_out_of_range(soup));
    EXPECT_FALSE(find_repeated_vertex_in_face(soup));
    EXPECT_FALSE(find_infinite_coordinate(soup));
    EXPECT_FALSE(find_isolated_vertex(soup));
    EXPECT_FALSE(find_degenerate_face(soup));
  }
}

TEST(Soup_element_checks, find_the_first_defect)
{
  expect_problem(find_emptiness({}), Problem_kind::EMPTY_MESH, {}, {});
  expect_problem(find_emptiness({four_points, {}}), Problem_kind::EMPTY_MESH, {}, {});
  expect_problem(find_index_out_of_range({four_points, {{0, 1, 3}, {0, 4, 1}, {9, 9, 9}}}),
                 Problem_kind::FILE, {}, {1});
  expect_problem(find_repeated_vertex_in_face({four_points, {{0, 1, 3}, {2, 1, 2}}}),
                 Problem_kind::NOT_TRIANGLE_MESH, {2}, {1});
  expect_problem(find_isolated_vertex({four_points, {{0, 1, 3}}}), Problem_kind::ISOLATED_VERTEX,
                 {2}, {});
  Triangle_soup soup = soups::tetrahedron();
  soup.points[2][1] = std::numeric_limits<double>::infinity();
  soup.points[3][0] = std::numeric_limits<double>::quiet_NaN();
  expect_problem(find_infinite_coordinate(soup), Problem_kind::NOT_FINITE, {2}, {});
}

TEST(Soup_element_checks, only_exactly_collinear_corners_are_degenerate)
{
  Triangle_soup soup{{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {0.1, 0.2, 0.3}}, {{0, 1, 3}, {2, 1, 0}}};
  expect_problem(find_degenerate_face(soup), Problem_kind::DEGENERATE_FACE, {2, 1, 0}, {1});
  soup.points[2][0] = std::nextafter(3., 4.);
  EXPECT_FALSE(find_degenerate_face(soup));
  soup.points[2] = soup.points[1];
  expect_problem(find_degenerate_face(soup), Problem_kind::DEGENERATE_FACE, {2, 1, 0}, {1});
}

// ===  soup_surface_checks.h

TEST(Soup_surface_checks, pass_good_soups)
{
  for (const Triangle_soup& soup : good_soups())
  {
    const Soup_edges edges(soup);
    EXPECT_FALSE(find_duplicate_face(edges));
    EXPECT_FALSE(find_non_manifold_edge(edges));
    EXPECT_FALSE(find_border(soup, edges));
    EXPECT_FALSE(find_non_manifold_vertex(soup, edges));
    EXPECT_FALSE(find_second_component(soup));
    EXPECT_FALSE(Soup_orientation_check(edges, soup.triangles.size()).run());
  }
}

TEST(Soup_surface_checks, copies_and_backs_of_faces)
{
  for (const auto& copy : {soups::Triangle{1, 3, 0}, soups::Triangle{3, 1, 0}})
  {
    const Triangle_soup soup{four_points, {{0, 1, 2}, {0, 1, 3}, copy}};
    expect_problem(find_duplicate_face(Soup_edges(soup)), Problem_kind::NOT_MANIFOLD, {0, 1, 3},
                   {1, 2});
  }
}

TEST(Soup_surface_checks, edges_with_three_faces)
{
  Triangle_soup soup = soups::tetrahedron();
  soup.points.push_back({5, 5, 5});
  soup.triangles.push_back({3, 1, 4});
  expect_problem(find_non_manifold_edge(Soup_edges(soup)), Problem_kind::NOT_MANIFOLD, {3, 1},
                 {2, 3, 4});
}

TEST(Soup_surface_checks, openings_are_counted)
{
  Triangle_soup soup = soups::tetrahedron();
  soup.triangles.pop_back(); // the sides of 1, 3 and 2 are left
  const std::optional<Problem> problem = find_border(soup, Soup_edges(soup));
  expect_problem(problem, Problem_kind::NOT_CLOSED, {1, 2}, {0});
  EXPECT_NE(problem->message.find("1 opening bounded by 3 edges"), std::string::npos);
  EXPECT_EQ(problem->message.find("merging"), std::string::npos);
  const Triangle_soup apart{std::vector<std::array<double, 3>>(6), {{0, 1, 2}, {3, 4, 5}}};
  EXPECT_NE(find_border(apart, Soup_edges(apart))->message.find("merging"), std::string::npos);
}

TEST(Soup_surface_checks, vertices_with_two_umbrellas)
{
  Triangle_soup soup = soups::tetrahedron();
  soup.points.insert(soup.points.end(), {{3, 1, 1}, {1, 3, 1}, {1, 1, 3}});
  const std::size_t top = 2; // shared by two tetrahedra
  for (const auto& [a, b, c] : soups::tetrahedron().triangles)
  {
    const auto moved = [&](std::size_t v) { return v == top ? v : v + 4 - (v > top); };
    soup.triangles.push_back({moved(a), moved(b), moved(c)});
  }
  const Soup_edges edges(soup);
  EXPECT_FALSE(find_border(soup, edges));
  expect_problem(find_non_manifold_vertex(soup, edges), Problem_kind::NOT_MANIFOLD, {top}, {});
  EXPECT_FALSE(find_second_component(soup));
}

TEST(Soup_surface_checks, components_without_isolated_vertices)
{
  Triangle_soup soup{std::vector<std::array<double, 3>>(9), {{1, 2, 3}, {3, 2, 5}}};
  EXPECT_FALSE(find_second_component(soup)); // 0, 4, 6, 7 and 8 are isolated
  soup.triangles.push_back({8, 6, 4});
  const std::optional<Problem> problem = find_second_component(soup);
  expect_problem(problem, Problem_kind::NOT_CONNECTED, {1, 4}, {});
  EXPECT_NE(problem->message.find("2 components"), std::string::npos);
}

// ===  Soup_orientation_check.h

namespace {

std::optional<Problem> orientation_problem(const Triangle_soup& soup)
{
  return Soup_orientation_check(Soup_edges(soup), soup.triangles.size()).run();
}

void reverse(Triangle_soup& soup, std::size_t face)
{
  std::swap(soup.triangles[face][0], soup.triangles[face][1]);
}

} // namespace

TEST(Soup_orientation_check, names_the_smaller_part)
{
  Triangle_soup soup = soups::octahedron();
  reverse(soup, 3);
  expect_problem(orientation_problem(soup), Problem_kind::NOT_ORIENTABLE, {}, {3});
  for (std::size_t face : {0, 1, 2, 4, 5})
    reverse(soup, face);
  std::optional<Problem> problem = orientation_problem(soup);
  ASSERT_TRUE(problem);
  std::sort(problem->faces.begin(), problem->faces.end());
  expect_problem(problem, Problem_kind::NOT_ORIENTABLE, {}, {6, 7});
  for (std::size_t face : {6, 7})
    reverse(soup, face);
  EXPECT_FALSE(orientation_problem(soup)); // inside out
}

TEST(Soup_orientation_check, one_sided_surfaces)
{
  // a Moebius strip, and a strip with as many faces that is none
  const std::vector<std::array<double, 3>> six(6);
  const Triangle_soup moebius{six, {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 0, 4}, {4, 0, 1}}};
  const Triangle_soup ring{six, {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 5, 4}, {4, 5, 0}, {5, 1, 0}}};
  const std::optional<Problem> problem = orientation_problem(moebius);
  ASSERT_TRUE(problem);
  EXPECT_EQ(problem->kind, Problem_kind::NOT_ORIENTABLE);
  ASSERT_EQ(problem->faces.size(), 2u);
  EXPECT_NE(problem->message.find("no reversal"), std::string::npos);
  EXPECT_FALSE(orientation_problem(ring));
}

// ===  build_triangle_mesh.h

TEST(Build_triangle_mesh, keeps_vertices_faces_and_first_corners)
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  using Mesh = CGAL::Surface_mesh<Point>;
  for (const Triangle_soup& soup : good_soups())
  {
    Mesh mesh;
    const auto faces = build_triangle_mesh(soup, mesh, mesh.points());
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
    EXPECT_TRUE(CGAL::is_closed(mesh));
    ASSERT_EQ(faces.size(), soup.triangles.size());
    for (std::size_t v = 0; v < soup.points.size(); ++v)
    {
      const auto& [x, y, z] = soup.points[v];
      EXPECT_EQ(mesh.point(Mesh::Vertex_index(static_cast<Mesh::size_type>(v))), Point(x, y, z));
    }
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      const auto h = mesh.halfedge(faces[f]);
      EXPECT_EQ(mesh.source(h).idx(), soup.triangles[f][0]);
      EXPECT_EQ(mesh.target(h).idx(), soup.triangles[f][1]);
      EXPECT_EQ(mesh.target(mesh.next(h)).idx(), soup.triangles[f][2]);
    }
  }
}

// The short check accepts what the long ones have nothing to say about, and nothing else.
TEST(Closed_flat_mesh, is_there_if_and_only_if_there_is_no_problem)
{
  smf_test::Random random(3);
  std::size_t accepted = 0;
  std::map<Problem_kind, std::size_t> refused;
  for (const Triangle_soup& whole :
       {soups::tetrahedron(), soups::octahedron(), soups::icosphere(1), soups::torus(5, 4, 3, 1)})
    for (int round = 0; round < 2000; ++round)
    {
      Triangle_soup soup = whole;
      for (std::size_t damages = random.index(4); damages > 0; --damages)
      {
        auto& triangle = soup.triangles[random.index(soup.triangles.size())];
        const std::size_t corner = random.index(3), kind = random.index(7);
        if (kind == 0)
          std::swap(triangle[0], triangle[1]);
        else if (kind == 1)
          triangle[corner] = random.index(soup.points.size());
        else if (kind == 2)
          soup.triangles.push_back(triangle);
        else if (kind == 3)
          soup.points[triangle[corner]] = soup.points[triangle[(corner + 1) % 3]];
        else if (kind == 4)
          soup.points.push_back({9, 9, 9});
        else if (kind == 5)
          soup.points[triangle[corner]][0] = std::numeric_limits<double>::infinity();
        else // another copy beside it, which meets it or not
          for (const auto& [a, b, c] : whole.triangles)
            soup.triangles.push_back({a, b, c + (soup.points.size() > whole.points.size())});
        soup.triangles.erase(soup.triangles.begin(),
                             soup.triangles.begin() +
                               static_cast<std::ptrdiff_t>(random.index(40) == 0));
      }
      const std::vector<Problem> problems = soup_problems(soup);
      Triangle_soup copy = soup;
      const std::optional<Flat_mesh> mesh = closed_flat_mesh(copy);
      ASSERT_EQ(mesh.has_value(), problems.empty());
      if (mesh)
        ++accepted;
      else
      {
        ++refused[problems[0].kind];
        EXPECT_EQ(copy.points.size(), soup.points.size());
      }
    }
  EXPECT_GT(accepted, 500u);
  EXPECT_GE(refused.size(), 6u);
}

} // namespace test_soup_checks
