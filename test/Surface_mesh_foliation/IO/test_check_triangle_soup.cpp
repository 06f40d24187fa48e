// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "generators/meshes.h"

#include <CGAL/Surface_mesh_foliation/IO/polygon_soup.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_check_triangle_soup {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
using SMF::Problem;
using SMF::Problem_kind;
using SMF::Triangle_soup;
using Triangle = std::array<std::size_t, 3>;

std::vector<Problem_kind> problem_kinds(const Triangle_soup& soup)
{
  std::vector<Problem_kind> kinds;
  for (const Problem& problem : SMF::check_triangle_soup(soup))
    kinds.push_back(problem.kind);
  return kinds;
}

using Kinds = std::vector<Problem_kind>;

TEST(Check_triangle_soup, valid_soups_have_no_problems)
{
  EXPECT_EQ(problem_kinds(smf_test::soups::tetrahedron()), Kinds());
  EXPECT_EQ(problem_kinds(smf_test::soups::genus_surface(12)), Kinds());
  Triangle_soup inside_out = smf_test::soups::icosphere(2);
  for (auto& triangle : inside_out.triangles)
    std::swap(triangle[0], triangle[1]);
  EXPECT_EQ(problem_kinds(inside_out), Kinds());
}

TEST(Check_triangle_soup, halfedges_are_counted_with_32_bits)
{
  using CGAL::Surface_mesh_foliation::internal::find_excess;
  EXPECT_FALSE(find_excess(715827882));
  const auto problem = find_excess(715827883);
  ASSERT_TRUE(problem);
  EXPECT_EQ(problem->kind, Problem_kind::TOO_LARGE);
  EXPECT_EQ(problem->message, "the mesh has 715827883 faces; at most 715827882 are possible");
}

TEST(Check_triangle_soup, nothing_is_checked_after_emptiness_or_a_wrong_index)
{
  EXPECT_EQ(problem_kinds({}), Kinds({Problem_kind::EMPTY_MESH}));
  EXPECT_EQ(problem_kinds({{{0, 0, 0}}, {}}), Kinds({Problem_kind::EMPTY_MESH}));
  EXPECT_EQ(problem_kinds({{}, {{0, 0, 7}}}), Kinds({Problem_kind::EMPTY_MESH}));
  EXPECT_EQ(problem_kinds({{{0, 0, 0}}, {{0, 0, 7}}}), Kinds({Problem_kind::FILE}));
  const std::size_t huge = (std::numeric_limits<std::size_t>::max)();
  EXPECT_EQ(problem_kinds({{{0, 0, 0}}, {{0, huge, 0}}}), Kinds({Problem_kind::FILE}));
}

TEST(Check_triangle_soup, the_first_problem_of_each_kind_is_found)
{
  Triangle_soup soup = smf_test::soups::tetrahedron();
  soup.points.push_back({std::nan(""), 0, 0});
  EXPECT_EQ(problem_kinds(soup), Kinds({Problem_kind::NOT_FINITE, Problem_kind::ISOLATED_VERTEX}));

  soup.triangles.push_back({4, 4, 4});
  EXPECT_EQ(problem_kinds(soup),
            Kinds({Problem_kind::NOT_FINITE, Problem_kind::NOT_TRIANGLE_MESH}));

  // a degenerate triangle beside a tetrahedron of which a face is reversed
  soup = smf_test::soups::tetrahedron();
  std::swap(soup.triangles[3][0], soup.triangles[3][1]);
  for (const double x : {1.0, 2.0, 3.0})
    soup.points.push_back({x, 0, 0});
  soup.triangles.push_back({4, 5, 6});
  EXPECT_EQ(problem_kinds(soup),
            Kinds({Problem_kind::NOT_CLOSED, Problem_kind::NOT_ORIENTABLE,
                   Problem_kind::NOT_CONNECTED, Problem_kind::DEGENERATE_FACE}));
}

TEST(Check_triangle_soup, problems_name_their_places)
{
  Triangle_soup soup = smf_test::soups::tetrahedron();
  soup.points.push_back({5, 5, 5});
  soup.triangles.push_back({0, 1, 4});
  const std::vector<Problem> problems = SMF::check_triangle_soup(soup);
  ASSERT_EQ(problems.size(), 2u);
  EXPECT_EQ(problems[0].kind, Problem_kind::NOT_MANIFOLD);
  EXPECT_EQ(problems[0].vertices, std::vector<std::size_t>({0, 1}));
  EXPECT_EQ(problems[0].faces, std::vector<std::size_t>({0, 2, 4}));
  EXPECT_EQ(problems[1].kind, Problem_kind::NOT_CLOSED);
  EXPECT_EQ(problems[1].faces, std::vector<std::size_t>({4}));
}

TEST(Check_triangle_soup, the_fewer_faces_are_to_be_reversed)
{
  for (const std::size_t number_reversed : {1u, 2u, 100u, 318u, 319u})
  {
    Triangle_soup soup = smf_test::soups::icosphere(2);
    for (std::size_t i = 0; i < number_reversed; ++i)
      std::swap(soup.triangles[i][0], soup.triangles[i][1]);
    const std::vector<Problem> problems = SMF::check_triangle_soup(soup);
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_EQ(problems[0].kind, Problem_kind::NOT_ORIENTABLE);
    EXPECT_EQ(problems[0].faces.size(),
              std::min<std::size_t>(number_reversed, 320 - number_reversed));
  }
}

// ===  Against the definitions

// the edges opposite to a vertex form one cycle
bool is_link_a_cycle(const Triangle_soup& soup, std::size_t vertex)
{
  std::map<std::size_t, std::size_t> next;
  std::size_t degree = 0;
  for (Triangle triangle : soup.triangles)
  {
    const auto corner = std::find(triangle.begin(), triangle.end(), vertex);
    if (corner == triangle.end())
      continue;
    std::rotate(triangle.begin(), corner, triangle.end());
    next[triangle[1]] = triangle[2];
    ++degree;
  }
  if (degree == 0 || next.size() != degree)
    return false;
  std::size_t current = next.begin()->first;
  for (std::size_t i = 1; i <= degree; ++i)
  {
    if (next.count(current) == 0)
      return false;
    current = next[current];
    if (current == next.begin()->first)
      return i == degree;
  }
  return false;
}

bool is_connected(const Triangle_soup& soup)
{
  std::vector<std::size_t> component(soup.points.size());
  std::iota(component.begin(), component.end(), std::size_t(0));
  for (std::size_t i = 0; i < soup.points.size(); ++i)
    for (const Triangle& triangle : soup.triangles)
    {
      const std::size_t smallest =
        std::min({component[triangle[0]], component[triangle[1]], component[triangle[2]]});
      for (const std::size_t corner : triangle)
        component[corner] = smallest;
    }
  return std::count(component.begin(), component.end(), component[0]) ==
         static_cast<std::ptrdiff_t>(component.size());
}

// of a soup with at least one face, valid indices and points in general position
bool is_valid_by_definition(const Triangle_soup& soup)
{
  std::map<std::pair<std::size_t, std::size_t>, int> sides;
  std::set<std::set<std::size_t>> faces;
  for (const Triangle& triangle : soup.triangles)
  {
    const std::set<std::size_t> corners(triangle.begin(), triangle.end());
    if (corners.size() != 3 || !faces.insert(corners).second)
      return false;
    for (std::size_t i = 0; i < 3; ++i)
      ++sides[{triangle[i], triangle[(i + 1) % 3]}];
  }
  for (const auto& [side, count] : sides)
    if (count != 1 || sides.count({side.second, side.first}) == 0)
      return false;
  for (std::size_t vertex = 0; vertex < soup.points.size(); ++vertex)
    if (!is_link_a_cycle(soup, vertex))
      return false;
  return is_connected(soup);
}

Triangle_soup random_small_surface(smf_test::Random& random)
{
  namespace soups = smf_test::soups;
  switch (random.index(4))
  {
  case 0:
    return soups::tetrahedron();
  case 1:
    return soups::octahedron();
  case 2:
    return soups::torus(3, 3, 2, 1);
  default:
    return soups::genus_surface(1, 1);
  }
}

void damage(Triangle_soup& soup, smf_test::Random& random)
{
  const std::size_t face = random.index(soup.triangles.size());
  switch (random.index(5))
  {
  case 0: // another corner
    soup.triangles[face][random.index(3)] = random.index(soup.points.size());
    break;
  case 1: // the other orientation
    std::swap(soup.triangles[face][0], soup.triangles[face][1]);
    break;
  case 2: // a face once more
    soup.triangles.push_back(soup.triangles[face]);
    break;
  case 3: // a face less
    soup.triangles[face] = soup.triangles.back();
    if (soup.triangles.size() > 1)
      soup.triangles.pop_back();
    break;
  default: // the last vertex merged with another one
    if (soup.points.size() == 1)
      break;
    soup.points.pop_back();
    for (Triangle& triangle : soup.triangles)
      std::replace(triangle.begin(), triangle.end(), soup.points.size(),
                   triangle[0] % soup.points.size());
  }
}

TEST(Check_triangle_soup, agrees_with_the_definitions_on_random_soups)
{
  smf_test::Random random(2026);
  int number_valid = 0;
  for (int i = 0; i < 5000; ++i)
  {
    Triangle_soup soup = random_small_surface(random);
    for (std::size_t j = random.index(4); j > 0; --j)
      damage(soup, random);
    for (auto& point : soup.points)
      for (double& coordinate : point)
        coordinate = random.between(-1, 1);
    const bool is_valid = is_valid_by_definition(soup);
    const std::vector<Problem> problems = SMF::check_triangle_soup(soup);
    ASSERT_EQ(problems.empty(), is_valid)
      << "run " << i << ": " << (problems.empty() ? "" : problems.front().message);
    if (is_valid)
    {
      ++number_valid;
      EXPECT_TRUE(CGAL::is_valid_polygon_mesh(smf_test::to_mesh(soup)));
    }
  }
  EXPECT_GT(number_valid, 500);
  EXPECT_LT(number_valid, 4500);
}

} // namespace

} // namespace test_check_triangle_soup
