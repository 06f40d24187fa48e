// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes with every defect that can be repaired: what is done is told, the result is a surface, and
// its elements are known to come from those of the input.

#include "generators/Random.h"
#include "generators/genus_soups.h"
#include "generators/openings.h"
#include "include/repaired_soups.h"
#include "include/temporary_folder.h"

#include <CGAL/Surface_mesh_foliation/IO/write_repair_maps.h>
#include <CGAL/Surface_mesh_foliation/repair.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_repair {

namespace {

namespace soups = smf_test::soups;
using namespace smf_test::repaired_soups;
using SMF::Problem_kind;
using smf_test::Triangle_soup;

constexpr std::size_t none = Repaired_soup::none;

TEST(Repair, leaves_closed_surfaces_alone)
{
  for (const Triangle_soup& soup : surfaces())
  {
    const Repaired_soup result = repair(polygons(soup));
    EXPECT_EQ(result.soup.points, soup.points);
    EXPECT_EQ(result.soup.triangles, soup.triangles);
    EXPECT_EQ(number_of_repairs(result.report), 0u);
  }
}

TEST(Repair, leaves_openings_open)
{
  smf_test::Random random(5);
  for (const Triangle_soup& closed : surfaces())
  {
    const Triangle_soup soup = soups::with_random_openings(closed, 2, random);
    const Repaired_soup result = repair(polygons(soup));
    EXPECT_EQ(result.soup.points, soup.points);
    EXPECT_EQ(faces(result.soup), faces(soup));
    EXPECT_EQ(number_of_repairs(result.report), 0u);
  }
}

TEST(Repair, writes_what_has_become_of_vertices_and_faces)
{
  Polygon_soup soup; // a pyramid over a square, a face given twice, and a vertex without faces
  soup.points = {{0, 0, 0}, {1, 0, 0}, {9, 9, 9}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}};
  soup.polygons = {{0, 4, 3, 1}, {0, 1, 5}, {0, 1, 5}, {1, 3, 5}, {3, 4, 5}, {4, 0, 5}};
  const Repaired_soup repaired = repair(soup);
  const smf_test::Temporary_folder folder;
  const std::string vertices = folder.file_name("v"), faces = folder.file_name("f");
  SMF::write_repaired_vertices(vertices, repaired);
  SMF::write_repaired_faces(faces, repaired);
  EXPECT_EQ(smf_test::file_text(vertices), "0\n1\n-1\n2\n3\n4\n");
  EXPECT_EQ(smf_test::file_text(faces), "0 1\n2\n\n3\n4\n5\n");
}

// ===  One defect after the other, on surfaces of genus 0 to 3

TEST(Repair, merges_the_corners_of_faces_that_do_not_know_their_neighbors)
{
  for (const Triangle_soup& soup : surfaces())
  {
    Polygon_soup loose;
    for (const auto& triangle : soup.triangles)
    {
      loose.polygons.emplace_back();
      for (const std::size_t v : triangle)
      {
        loose.polygons.back().push_back(loose.points.size());
        loose.points.push_back(soup.points[v]);
      }
    }
    const Repaired_soup result = repair(loose);
    EXPECT_TRUE(is_closed(result.soup));
    EXPECT_EQ(result.soup.points.size(), soup.points.size());
    EXPECT_EQ(result.soup.triangles.size(), soup.triangles.size());
    EXPECT_EQ(result.report.merged_vertices, loose.points.size() - soup.points.size());
    EXPECT_EQ(number_of_repairs(result.report), result.report.merged_vertices);
    EXPECT_EQ(std::count(result.vertices.begin(), result.vertices.end(), none), 0);
  }
}

TEST(Repair, merges_vertices_along_seams)
{
  const std::size_t m = 9, n = 7;
  const Triangle_soup torus = soups::torus(m, n, 3, 1);
  Polygon_soup input = polygons(torus);
  // the vertices 0 to n - 1 around the tube get copies, which the faces on one side use
  for (std::size_t j = 0; j < n; ++j)
    input.points.push_back(torus.points[j]);
  for (auto& face : input.polygons)
    if (std::any_of(face.begin(), face.end(), [&](std::size_t v) { return v / n == m - 1; }))
      for (std::size_t& v : face)
        if (v < n)
          v += torus.points.size();
  const Repaired_soup result = repair(input);
  EXPECT_EQ(result.report.merged_vertices, n);
  EXPECT_EQ(number_of_repairs(result.report), n);
  EXPECT_EQ(result.soup.points, torus.points);
  EXPECT_EQ(faces(result.soup), faces(torus));
  for (std::size_t j = 0; j < n; ++j)
    EXPECT_EQ(result.vertices[torus.points.size() + j], j);
}

TEST(Repair, does_not_merge_surfaces_that_touch)
{
  // two tetrahedra with a corner at the same place
  Triangle_soup soup = soups::tetrahedron(), other = soup;
  for (auto& point : other.points)
    for (int i : {0, 1, 2})
      point[i] = 2 * soup.points[0][i] - point[i];
  for (const auto& [a, b, c] : other.triangles)
    soup.triangles.push_back({c + 4, b + 4, a + 4});
  soup.points.insert(soup.points.end(), other.points.begin(), other.points.end());
  ASSERT_EQ(soup.points[0], soup.points[4]);
  const Repaired_soup result = repair(polygons(soup));
  EXPECT_EQ(number_of_repairs(result.report), 0u);
  EXPECT_EQ(number_of_parts(result.soup), 2u);
}

TEST(Repair, turns_the_fewer_faces_over)
{
  smf_test::Random random(7);
  for (const Triangle_soup& soup : surfaces())
    for (const std::size_t number : {std::size_t(1), std::size_t(5), soup.triangles.size() / 3})
    {
      Polygon_soup input = polygons(soup);
      std::set<std::size_t> turned = {0}; // that from which CGAL starts
      while (turned.size() < number)
        turned.insert(random.index(input.polygons.size()));
      for (const std::size_t f : turned)
        std::reverse(input.polygons[f].begin(), input.polygons[f].end());
      const Repaired_soup result = repair(input);
      EXPECT_EQ(result.report.reversed_faces, number);
      EXPECT_EQ(number_of_repairs(result.report), number);
      EXPECT_EQ(result.soup.points, soup.points);
      EXPECT_EQ(faces(result.soup), faces(soup));
    }
}

TEST(Repair, merges_edges_of_faces_that_come_twice)
{
  for (const Triangle_soup& soup : surfaces())
  {
    Polygon_soup input; // no face knows its neighbors
    for (const auto& triangle : soup.triangles)
    {
      input.polygons.emplace_back();
      for (const std::size_t v : triangle)
      {
        input.polygons.back().push_back(input.points.size());
        input.points.push_back(soup.points[v]);
      }
    }
    for (const std::size_t f : {std::size_t(0), std::size_t(5), input.polygons.size() - 1})
    {
      const std::vector<std::size_t> face = input.polygons[f];
      input.polygons.push_back({face[1], face[2], face[0]});
      input.polygons.push_back({face[2], face[1], face[0]});
    }
    const Repaired_soup result = repair(input);
    EXPECT_EQ(result.report.repeated_faces, 6u);
    EXPECT_EQ(result.soup.points.size(), soup.points.size());
    EXPECT_EQ(result.soup.triangles.size(), soup.triangles.size());
    EXPECT_EQ(result.report.duplicated_vertices, 0u);
    EXPECT_EQ(number_of_repairs(result.report), 6 + result.report.merged_vertices);
  }
}

TEST(Repair, removes_unused_vertices_and_repeated_faces)
{
  for (const Triangle_soup& soup : surfaces())
  {
    // a vertex in front, one behind, and copies of faces, turned and rotated
    Polygon_soup input = polygons(soup);
    input.points.insert(input.points.begin(), {7, 7, 7});
    input.points.push_back({8, 8, 8});
    for (auto& face : input.polygons)
      for (std::size_t& v : face)
        ++v;
    const std::vector<std::size_t> face = input.polygons[3];
    input.polygons.push_back({face[1], face[2], face[0]});
    input.polygons.push_back({face[2], face[1], face[0]});
    const Repaired_soup result = repair(input);
    EXPECT_EQ(result.report.unused_vertices, 2u);
    EXPECT_EQ(result.report.repeated_faces, 2u);
    EXPECT_EQ(number_of_repairs(result.report), 4u);
    EXPECT_EQ(result.soup.points, soup.points);
    EXPECT_EQ(faces(result.soup), faces(soup));
    EXPECT_EQ(result.vertices.front(), none);
    EXPECT_EQ(result.vertices[1], 0u);
    EXPECT_EQ(result.vertices.back(), none);
    EXPECT_EQ(result.first_faces.back(), soup.triangles.size());
  }
}

// Splits the edges from a vertex by vertices on their middles, which a neighbor does not know: its
// face is closed by one without area.
TEST(Repair, removes_faces_without_area)
{
  for (const Triangle_soup& soup : {soups::icosphere(1), soups::torus(8, 6, 3, 1)})
  {
    Polygon_soup input = polygons(soup);
    const auto face = input.polygons[5];
    const std::size_t middle = input.points.size();
    std::array<double, 3> point;
    for (int i : {0, 1, 2}) // coordinates that a half of their sum does not round
    {
      const auto round = [](double x) { return std::ldexp(std::round(std::ldexp(x, 20)), -20); };
      for (const std::size_t v : {face[0], face[1]})
        input.points[v][i] = round(input.points[v][i]);
      point[i] = (input.points[face[0]][i] + input.points[face[1]][i]) / 2;
    }
    input.points.push_back(point);
    input.polygons[5] = {middle, face[1], face[2]};
    input.polygons.push_back({face[0], middle, face[2]});
    input.polygons.push_back({face[0], face[1], middle}); // without area
    const Repaired_soup result = repair(input);
    EXPECT_EQ(result.report.degenerate_faces, 1u);
    EXPECT_TRUE(is_closed(result.soup));
    EXPECT_EQ(soups::genus(result.soup), soups::genus(soup));
  }
}

TEST(Repair, collapses_edges_of_length_zero)
{
  for (const Triangle_soup& soup : surfaces())
  {
    // vertex 0 is split in two at the same place, with two faces between
    Polygon_soup input = polygons(soup);
    const std::size_t copy = input.points.size();
    input.points.push_back(input.points[0]);
    std::map<std::size_t, std::pair<std::size_t, std::size_t>> next; // around vertex 0: and face
    for (std::size_t f = 0; f < input.polygons.size(); ++f)
      for (std::size_t i = 0; i < 3; ++i)
        if (input.polygons[f][i] == 0)
          next[input.polygons[f][(i + 1) % 3]] = {input.polygons[f][(i + 2) % 3], f};
    const std::size_t first = next.begin()->first;
    std::size_t last = first;
    for (int i = 0; i < 2; ++i) // two faces go to the copy
    {
      const auto [vertex, f] = next.at(last);
      std::replace(input.polygons[f].begin(), input.polygons[f].end(), std::size_t(0), copy);
      last = vertex;
    }
    input.polygons.push_back({0, first, copy});
    input.polygons.push_back({0, copy, last});
    const Repaired_soup result = repair(input);
    EXPECT_EQ(result.report.merged_vertices, 1u);
    EXPECT_EQ(result.report.degenerate_faces, 2u);
    EXPECT_EQ(number_of_repairs(result.report), 3u);
    EXPECT_EQ(faces(result.soup), faces(soup));
    EXPECT_EQ(result.vertices[copy], 0u);
  }
}

// ===  What nobody can repair

TEST(Repair, refuses_what_nobody_understands)
{
  const auto kind_of = [](const Polygon_soup& soup) {
    try
    {
      SMF::repair_polygon_soup(soup);
    }
    catch (const SMF::Invalid_mesh_exception& exception)
    {
      return exception.problem().kind;
    }
    return Problem_kind::STOPPED;
  };
  Polygon_soup soup = polygons(soups::tetrahedron());
  soup.polygons[2][1] = 4;
  EXPECT_EQ(kind_of(soup), Problem_kind::FILE);
  soup = polygons(soups::tetrahedron());
  soup.points[1][2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(kind_of(soup), Problem_kind::NOT_FINITE);
}

TEST(Repair, of_nothing_is_nothing)
{
  EXPECT_TRUE(SMF::repair_polygon_soup(Polygon_soup()).soup.triangles.empty());
  const Repaired_soup result = SMF::repair_polygon_soup({{{0, 0, 0}, {1, 0, 0}}, {{0, 1}}});
  EXPECT_TRUE(result.soup.points.empty());
  EXPECT_EQ(result.vertices, (std::vector<std::size_t>{none, none}));
}

// ===  The report

TEST(Repair, is_described_in_words)
{
  SMF::Repair_report report;
  report.reversed_faces = 3;
  report.unused_vertices = 1;
  EXPECT_EQ(descriptions(report), (std::vector<std::string>{"3 faces were turned over",
                                                            "1 vertex was removed for want of "
                                                            "faces"}));
}

} // namespace

} // namespace test_repair
