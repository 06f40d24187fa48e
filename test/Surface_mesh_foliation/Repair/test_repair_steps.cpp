// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The steps of the repair, one by one.

#include "generators/genus_soups.h"

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Polygon_soup.h>
#include <CGAL/Surface_mesh_foliation/internal/Repair/Face_triangulation.h>
#include <CGAL/Surface_mesh_foliation/internal/Repair/Repaired_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Repair/Traced_soup.h>
#include <CGAL/Surface_mesh_foliation/internal/Repair/clean_faces.h>
#include <CGAL/Surface_mesh_foliation/internal/Repair/merge_open_edges.h>
#include <CGAL/Surface_mesh_foliation/internal/Repair/orient_faces.h>
#include <CGAL/Surface_mesh_foliation/internal/Repair/triangulate_polygon.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace test_repair_steps {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
namespace internal = SMF::internal;
namespace soups = smf_test::soups;
using internal::no_element;
using internal::Traced_soup;
using Faces = std::vector<std::vector<std::size_t>>;
using Numbers = std::vector<std::size_t>;

// with as many different points as the faces need
Traced_soup traced(const Faces& faces)
{
  SMF::Polygon_soup soup;
  soup.polygons = faces;
  std::size_t n = 0;
  for (const auto& face : faces)
    for (const std::size_t v : face)
      n = (std::max)(n, v + 1);
  for (std::size_t v = 0; v < n; ++v)
    soup.points.push_back({std::cos(1. * v), std::sin(1. * v), 0.1 * v});
  return Traced_soup(soup);
}

TEST(Traced_soup, remembers_what_faces_come_from)
{
  Traced_soup soup = traced({{0, 1, 2}, {2, 1, 3}, {3, 1, 0}});
  soup.set_faces({{2, 1, 3}, {0, 1, 2}, {0, 1, 3}}, {1, 0, 0});
  soup.set_faces({{0, 1, 3}, {2, 1, 3}}, {2, 0});
  EXPECT_EQ(soup.face_origins, (Numbers{0, 1}));
  EXPECT_EQ(soup.add_new_vertex({7, 7, 7}), 4u);
  EXPECT_EQ(soup.vertex_origins, (Numbers{0, 1, 2, 3, no_element}));
  EXPECT_EQ(soup.is_used(), (std::vector<bool>{true, true, true, true, false}));
  const std::vector<Traced_soup::Edge> edges = {{0, 1}, {0, 3}, {1, 2}, {1, 3}, {1, 3}, {2, 3}};
  EXPECT_EQ(soup.edges_of_faces(), edges);
}

TEST(Merge_open_edges, keeps_the_first)
{
  Traced_soup soup = traced({{0, 1, 2}, {3, 5, 4}, {6, 7, 8}});
  soup.points[3] = soup.points[1]; // the first two faces have two places in common
  soup.points[4] = soup.points[2];
  EXPECT_EQ(internal::merge_open_edges(soup), 2u);
  EXPECT_EQ(soup.faces, (Faces{{0, 1, 2}, {1, 5, 2}, {6, 7, 8}}));
  EXPECT_EQ(internal::merge_open_edges(soup), 0u);
  // 0 and -0 are equal
  soup = traced({{0, 1, 2}, {3, 4, 5}});
  soup.points[0] = {0., 1, 2};
  soup.points[5] = {-0., 1, 2};
  EXPECT_EQ(internal::merge_open_edges(soup), 0u) << "surfaces that touch at a vertex";
  soup.points[4] = soup.points[1];
  EXPECT_EQ(internal::merge_open_edges(soup), 2u);
  EXPECT_EQ(soup.faces[1], (Numbers{3, 1, 0}));
  // an edge of length zero
  soup = traced({{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}});
  soup.points[2] = soup.points[3];
  EXPECT_EQ(internal::merge_open_edges(soup), 1u);
  EXPECT_EQ(soup.faces[0], (Numbers{0, 1, 2}));
  EXPECT_EQ(soup.faces[3], (Numbers{1, 2, 2}));
}

TEST(Clean_faces, splits_faces_at_repeated_vertices)
{
  // a plain face, an hourglass, one with a spike, one that is nothing but spikes
  Traced_soup soup = traced({{0, 1, 2}, {0, 1, 2, 0, 3, 4}, {5, 6, 7, 6, 8}, {1, 2, 1, 2}, {}});
  EXPECT_EQ(internal::remove_repeated_corners(soup), 2u);
  EXPECT_EQ(soup.faces, (Faces{{0, 1, 2}, {0, 1, 2}, {0, 3, 4}, {5, 6, 8}}));
  EXPECT_EQ(soup.face_origins, (Numbers{0, 1, 1, 2}));
  EXPECT_EQ(internal::remove_repeated_triangles(soup), 1u);
  EXPECT_EQ(soup.faces, (Faces{{0, 1, 2}, {0, 3, 4}, {5, 6, 8}}));
  EXPECT_EQ(soup.face_origins, (Numbers{0, 1, 2}));
}

TEST(Triangulate_polygon, keeps_to_the_inside)
{
  // a plane polygon with a notch: its triangles have its area
  const std::vector<internal::Point> notched = {
    {0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {2, 0.5, 0}, {0, 3, 0}};
  const auto triangles = internal::triangulate_polygon(notched);
  ASSERT_TRUE(triangles);
  EXPECT_EQ(triangles->size(), 3u);
  double area = 0;
  for (const auto& [i, j, k] : *triangles)
    area += ((notched[j][0] - notched[i][0]) * (notched[k][1] - notched[i][1]) -
             (notched[j][1] - notched[i][1]) * (notched[k][0] - notched[i][0])) /
            2;
  EXPECT_NEAR(area, 4 * 0.5 + 2 * 2.5, 1e-12); // two right triangles and a flat one
  EXPECT_EQ(internal::diagonals_of_triangulation(*triangles, 5).size(), 2u);
  const std::vector<internal::Point> line = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  EXPECT_FALSE(internal::triangulate_polygon(line));
  const internal::Point center =
    internal::centroid_of_polygon({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  EXPECT_EQ(center, (internal::Point{1, 1, 0}));
}

TEST(Face_triangulation, does_not_make_edges_twice)
{
  Traced_soup soup = traced({{0, 1, 2, 3}, {0, 2, 4}, {1, 3, 5}});
  EXPECT_EQ(internal::Face_triangulation(soup).run(), 1u); // both diagonals are edges
  EXPECT_EQ(soup.faces.size(), 6u);
  EXPECT_EQ(soup.points.size(), 7u);
  EXPECT_EQ(soup.face_origins, (Numbers{0, 0, 0, 0, 1, 2}));
  soup = traced({{0, 1, 2, 3, 4}, {5, 6, 7}});
  EXPECT_EQ(internal::Face_triangulation(soup).run(), 1u);
  EXPECT_EQ(soup.face_origins, (Numbers{0, 0, 0, 1}));
}

TEST(Orient_faces, counts_and_traces)
{
  for (const auto& surface :
       {soups::icosphere(1), soups::torus(6, 5, 3, 1), soups::genus_surface(2)})
  {
    Faces faces;
    for (const auto& triangle : surface.triangles)
      faces.emplace_back(triangle.begin(), triangle.end());
    for (const std::size_t f : {0, 3, 4})
      std::reverse(faces[f].begin(), faces[f].end());
    Traced_soup soup = traced(faces);
    const auto counts = internal::orient_faces(soup);
    EXPECT_EQ(counts.reversed_faces, 3u);
    EXPECT_EQ(counts.duplicated_vertices, 0u);
  }
  Traced_soup bow_tie = traced({{0, 1, 2}, {0, 3, 4}});
  EXPECT_EQ(internal::orient_faces(bow_tie).duplicated_vertices, 1u);
  EXPECT_EQ(bow_tie.points.size(), 6u);
  EXPECT_EQ(bow_tie.points[5], bow_tie.points[0]);
  EXPECT_EQ(bow_tie.vertex_origins, (Numbers{0, 1, 2, 3, 4, 0}));
}

TEST(Repaired_mesh, is_in_the_order_of_what_it_comes_from)
{
  // a fan, closed but for its last edge, which is the first one at the same place
  Traced_soup soup = traced({{0, 1, 2}, {0, 2, 3}, {0, 3, 4}});
  soup.points[4] = soup.points[1];
  soup.vertex_origins = {4, 2, 1, 0, no_element};
  internal::Repaired_mesh mesh(soup);
  EXPECT_EQ(mesh.stitch(), 1u);
  EXPECT_EQ(mesh.remove_degenerate_faces(), 0u);
  SMF::Triangle_soup result;
  Numbers vertex_origins, face_origins;
  mesh.output(result, vertex_origins, face_origins);
  EXPECT_TRUE(std::is_sorted(vertex_origins.begin(), vertex_origins.end()));
  EXPECT_EQ(face_origins, (Numbers{0, 1, 2}));
  EXPECT_EQ(result.points.size(), 4u);
  EXPECT_EQ(vertex_origins.size(), 4u);
  EXPECT_EQ(result.triangles.size(), 3u);
}

} // namespace

} // namespace test_repair_steps
