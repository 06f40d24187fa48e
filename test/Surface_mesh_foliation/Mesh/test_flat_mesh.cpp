// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The arrays of a flat mesh are a halfedge data structure, and half-edge collapses keep it one.

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Edge_collapses.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/flat_surface.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/halfedges.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>

#include "generators/meshes.h"
#include "include/flat_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace test_flat_mesh {

using namespace smf_test;
using namespace CGAL::Surface_mesh_foliation::internal;

namespace {

std::vector<std::pair<Mesh, int>> meshes_and_genera()
{
  return {{tetrahedron(), 0},
          {icosphere(3), 0},
          {to_mesh(soups::spindle(200, 3)), 0},
          {torus(20, 12, 3, 1), 1},
          {genus_surface(4, 3, 2), 4},
          {flip_random_edges(genus_surface(2, 3, 5), 0.3, 1), 2}};
}

} // namespace

TEST(Flat_mesh, is_a_halfedge_data_structure)
{
  for (const auto& [mesh, genus] : meshes_and_genera())
  {
    const Flat_mesh f = flat_mesh(to_soup(mesh));
    EXPECT_EQ(f.number_of_vertices(), static_cast<int>(num_vertices(mesh)));
    EXPECT_EQ(f.number_of_edges(), static_cast<int>(num_edges(mesh)));
    EXPECT_EQ(f.number_of_faces(), static_cast<int>(num_faces(mesh)));
    EXPECT_EQ(f.genus(), genus);
    for (int h = 0; h < f.number_of_halfedges(); ++h)
    {
      EXPECT_EQ(f.next(f.next(f.next(h))), h);
      EXPECT_EQ(f.prev(f.next(h)), h);
      EXPECT_EQ(f.source(f.next(h)), f.target(h));
      EXPECT_EQ(f.face(f.next(h)), f.face(h));
      EXPECT_EQ(f.source(opposite_of(h)), f.target(h));
      EXPECT_NE(f.face(opposite_of(h)), f.face(h));
      EXPECT_EQ(f.source(f.rotate(h)), f.source(h));
      EXPECT_EQ(f.find_halfedge(f.source(h), f.target(h)), h);
    }
  }
}

TEST(Halfedges, belong_to_edges_two_by_two)
{
  for (int e : {0, 1, 17})
  {
    const auto [h, g] = halfedges_of_edge(e);
    EXPECT_EQ(h, halfedge_of(e));
    EXPECT_EQ(opposite_of(h), g);
    EXPECT_EQ(opposite_of(g), h);
    EXPECT_EQ(edge_of(h), e);
    EXPECT_EQ(edge_of(g), e);
    EXPECT_TRUE(is_forward(h));
    EXPECT_FALSE(is_forward(g));
  }
}

TEST(Flat_mesh, faces_begin_at_their_first_corners)
{
  for (const auto& [mesh, genus] : meshes_and_genera())
  {
    const Flat_mesh f = flat_mesh(to_soup(mesh));
    const Triangle_soup soup = to_soup(mesh);
    for (int face = 0; face < f.number_of_faces(); ++face)
      for (int i : {0, 1, 2})
        EXPECT_EQ(f.source(f.halfedges(face)[i]), static_cast<int>(soup.triangles[face][i]));
  }
}

TEST(Flat_mesh, rings_are_counterclockwise_and_whole)
{
  for (const auto& [mesh, genus] : meshes_and_genera())
  {
    const Flat_mesh f = flat_mesh(to_soup(mesh));
    int number = 0;
    for (int v = 0; v < f.number_of_vertices(); ++v)
    {
      const Flat_mesh::Ring ring = f.ring(v);
      EXPECT_EQ(ring.size(), f.degree(v));
      number += ring.size();
      for (int i = 0; i < ring.size(); ++i)
      {
        EXPECT_EQ(f.source(ring[i]), v);
        EXPECT_EQ(f.rotate(ring[i]), ring[(i + 1) % ring.size()]);
      }
    }
    EXPECT_EQ(number, f.number_of_halfedges());
  }
}

// Each side of a face must be that of one other face, in the opposite direction, the faces around a
// vertex one ring, and all connected.
TEST(Flat_mesh, is_only_made_of_a_closed_surface)
{
  using Triangle = CGAL::Surface_mesh_foliation::internal::Triangle;
  const std::vector<Triangle> tetrahedron = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
  const auto is_made_of = [](const std::vector<Triangle>& triangles, int number_of_vertices) {
    std::vector<Point> points(number_of_vertices);
    const bool result = Flat_mesh::of_closed_surface(points, triangles).has_value();
    EXPECT_EQ(points.empty(), result);
    return result;
  };
  using CGAL::Surface_mesh_foliation::internal::are_edges_closed;
  EXPECT_TRUE(is_made_of(tetrahedron, 4));
  EXPECT_TRUE(are_edges_closed(4, tetrahedron));
  std::vector<Triangle> other = tetrahedron;
  std::swap(other[0][0], other[0][1]);
  EXPECT_FALSE(is_made_of(other, 4)); // turned over
  EXPECT_FALSE(are_edges_closed(4, other));
  other.pop_back();
  EXPECT_FALSE(is_made_of(other, 4)); // open
  EXPECT_FALSE(are_edges_closed(4, other));
  const auto with_second = [&](int shift, int shared) {
    std::vector<Triangle> result = tetrahedron;
    for (const Triangle& t : tetrahedron)
    {
      result.push_back(t);
      for (int& v : result.back())
        v = v == shared ? v : v + shift;
    }
    return result;
  };
  EXPECT_FALSE(is_made_of(with_second(4, -1), 8)); // two parts
  EXPECT_FALSE(is_made_of(with_second(3, 0), 7));  // two parts that meet in vertex 0
}

TEST(Edge_collapses, leave_a_closed_mesh_of_the_same_genus)
{
  for (const auto& [mesh, genus] : meshes_and_genera())
  {
    const Flat_mesh f = flat_mesh(to_soup(mesh));
    std::vector<bool> is_kept(f.number_of_vertices(), false);
    is_kept[0] = is_kept[3] = true;
    Edge_collapses collapses(f, is_kept, f.number_of_vertices() / 4);
    EXPECT_EQ(collapses.representative(0), 0);
    EXPECT_EQ(collapses.representative(3), 3);
    std::set<int> left;
    for (int v = 0; v < f.number_of_vertices(); ++v)
    {
      left.insert(collapses.representative(v));
      EXPECT_EQ(collapses.representative(collapses.representative(v)), collapses.representative(v));
    }
    EXPECT_EQ(static_cast<int>(left.size()), collapses.number_left());
    if (f.number_of_vertices() > 100)
    {
      EXPECT_LE(collapses.number_left(), f.number_of_vertices() / 3);
    }

    // every edge of what is left has one face on each side
    std::map<std::pair<int, int>, int> faces;
    int number_of_faces = 0;
    for (int face = 0; face < f.number_of_faces(); ++face)
    {
      std::vector<int> corners;
      for (int h : f.halfedges(face))
        corners.push_back(collapses.representative(f.source(h)));
      if (std::set<int>(corners.begin(), corners.end()).size() < 3)
        continue;
      ++number_of_faces;
      for (int i : {0, 1, 2})
        ++faces[{corners[i], corners[(i + 1) % 3]}];
    }
    for (const auto& [edge, number] : faces)
    {
      EXPECT_EQ(number, 1);
      EXPECT_EQ(faces.count({edge.second, edge.first}), 1u);
    }
    const int chi = collapses.number_left() - static_cast<int>(faces.size()) / 2 + number_of_faces;
    EXPECT_EQ(chi, 2 - 2 * genus);
  }
}

TEST(Edge_collapses, end_where_nothing_can_be_collapsed)
{
  const Flat_mesh f = flat_mesh(to_soup(icosphere(2)));
  const std::vector<bool> all(f.number_of_vertices(), true), none(f.number_of_vertices(), false);
  EXPECT_EQ(Edge_collapses(f, all, 1).number_left(), f.number_of_vertices());
  EXPECT_GE(Edge_collapses(f, none, 1).number_left(), 4);
}

// ===  points.h

TEST(Distance, neither_over_nor_underflows)
{
  namespace internal = CGAL::Surface_mesh_foliation::internal;
  EXPECT_DOUBLE_EQ(internal::distance({3, 1, 1}, {1, 4, 7}), 7);
  for (const double size : {1e300, 1e-300})
    EXPECT_DOUBLE_EQ(internal::distance({size, 0, 0}, {0, 0, size}), size * std::sqrt(2.));
}

TEST(Vectors, are_points_to_compute_with)
{
  const Point p = {1, 2, 3}, q = {5, -2, 3};
  EXPECT_EQ(coordinates(to_vector(p)), p);
  EXPECT_EQ(coordinates(difference(q, p)), (Point{4, -4, 0}));
  EXPECT_DOUBLE_EQ(norm({2, 3, 6}), 7);
  EXPECT_EQ(between(p, q, 0), p);
  EXPECT_EQ(between(p, q, 0.25), (Point{2, 1, 3}));
  EXPECT_EQ(between(p, q, 1), q);
}

TEST(Dot, adds_from_left_to_right)
{
  EXPECT_EQ(dot({1, 2, 3}, {4, -5, 6}), 12);
  const double half_ulp = std::ldexp(1., -53);
  EXPECT_EQ(dot({1, half_ulp, half_ulp}, {1, 1, 1}), 1);
  EXPECT_GT(dot({half_ulp, half_ulp, 1}, {1, 1, 1}), 1);
}

TEST(Centroid_of_points, neither_overflows_nor_is_minus_0)
{
  EXPECT_EQ(centroid({3, 0, 6}, {0, 3, 9}, {3, 12, 0}), (Point{2, 5, 5}));
  constexpr double huge = 1.5e308;
  EXPECT_DOUBLE_EQ(centroid({huge, 0, 0}, {huge, 0, 0}, {huge, 0, 0})[0], huge);
  EXPECT_FALSE(std::signbit(centroid({-0., 0, 0}, {-0., 0, 0}, {-0., 0, 0})[0]));
}

TEST(Bounding_box, has_a_diagonal_and_a_size)
{
  const CGAL::Bbox_3 box = bounding_box({{1, 2, 12}, {3, 6, 0}, {0, 3, 5}, {2, 2, 2}});
  EXPECT_EQ(box, CGAL::Bbox_3(0, 2, 0, 3, 6, 12));
  EXPECT_DOUBLE_EQ(diagonal(box), 13);
  EXPECT_EQ(half_size(box), 6);
  constexpr double largest = (std::numeric_limits<double>::max)();
  EXPECT_EQ(half_size(bounding_box({{0, -largest, 0}, {0, largest, 0}})), largest);
}

} // namespace test_flat_mesh
