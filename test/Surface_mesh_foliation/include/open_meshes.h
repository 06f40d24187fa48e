// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_OPEN_MESHES_H
#define SMF_TEST_OPEN_MESHES_H

#include "generators/meshes.h"
#include "generators/openings.h"

#include <CGAL/Surface_mesh_foliation/Poles_and_loops.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

// Small surfaces with openings whose foliation is known.

namespace smf_test {

namespace soups {

// Rings of n vertices around the z-axis, each turned by half a step against the one before, so that
// the mesh is Delaunay. Ring i has the radius and z of rings[i], and its vertices begin at i * n.
inline Triangle_soup tube(std::size_t n, const std::vector<std::array<double, 2>>& rings)
{
  Triangle_soup result;
  for (std::size_t i = 0; i < rings.size(); ++i)
    for (std::size_t j = 0; j < n; ++j)
    {
      const double angle =
        pi * (2 * static_cast<double>(j) + static_cast<double>(i)) / static_cast<double>(n);
      result.points.push_back(
        {rings[i][0] * std::cos(angle), rings[i][0] * std::sin(angle), rings[i][1]});
      if (i + 1 == rings.size())
        continue;
      const std::size_t k = i * n + j, next = i * n + (j + 1) % n;
      result.triangles.push_back({k, k + n, next});
      result.triangles.push_back({next, k + n, next + n});
    }
  return result;
}

// an annulus in the plane whose radii are a geometric progression, with nearly regular triangles
inline Triangle_soup plane_annulus(std::size_t n, std::size_t number_of_rings)
{
  std::vector<std::array<double, 2>> rings;
  for (std::size_t i = 0; i < number_of_rings; ++i)
    rings.push_back(
      {std::exp(std::sqrt(3.) * pi * static_cast<double>(i) / static_cast<double>(n)), 0});
  return tube(n, rings);
}

// a cone over ring 0 of a tube closes it; its apex is the last vertex
inline Triangle_soup with_apex(Triangle_soup soup, std::size_t n, const Point& apex)
{
  for (std::size_t j = 0; j < n; ++j)
    soup.triangles.push_back({(j + 1) % n, soup.points.size(), j});
  soup.points.push_back(apex);
  return soup;
}

// A triangle on the border edge of a face in which b follows a, with its tip at a new vertex, the
// last one but for a vertex in its middle if there is one. The edge becomes a chord.
inline Triangle_soup with_ear(
  Triangle_soup soup, std::size_t a, std::size_t b, const Point& tip, bool has_inner_vertex)
{
  const std::size_t c = soup.points.size(), middle = c + 1;
  soup.points.push_back(tip);
  if (!has_inner_vertex)
  {
    soup.triangles.push_back({b, a, c});
    return soup;
  }
  soup.points.push_back(scaled(sum(sum(soup.points[a], soup.points[b]), soup.points[c]), 1. / 3));
  for (const Triangle& t : {Triangle{b, a, middle}, Triangle{a, c, middle}, Triangle{c, b, middle}})
    soup.triangles.push_back(t);
  return soup;
}

// Two flat annuli that share one edge of their outer borders: a disk with two holes, and with a
// chord that runs between them.
inline Triangle_soup glasses(std::size_t n, std::size_t number_of_rings)
{
  const Triangle_soup left = plane_annulus(n, number_of_rings);
  Triangle_soup result = left;
  const std::size_t a = (number_of_rings - 1) * n, b = a + 1;
  const Point p = left.points[a], along = normalized(sum(left.points[b], p, -1));
  std::vector<std::size_t> number;
  for (std::size_t v = 0; v < left.points.size(); ++v)
  {
    number.push_back(v == a || v == b ? v : result.points.size());
    if (v == a || v == b)
      continue;
    const Point q = sum(left.points[v], p, -1);
    const Point mirrored = sum(scaled(along, 2 * dot(along, q)), q, -1);
    result.points.push_back(sum(p, mirrored));
  }
  for (const auto& [u, v, w] : left.triangles)
    result.triangles.push_back({number[v], number[u], number[w]});
  return result;
}

// without the faces around some directions, seen from the origin
inline Triangle_soup without_caps(const Triangle_soup& soup,
                                  const std::vector<Point>& directions,
                                  double cosine)
{
  return with_faces(soup, [&](const Triangle& t) {
    return std::none_of(t.begin(), t.end(), [&](std::size_t v) {
      return std::any_of(directions.begin(), directions.end(), [&](const Point& d) {
        return dot(normalized(soup.points[v]), normalized(d)) > cosine;
      });
    });
  });
}

// without the faces at some vertices
inline Triangle_soup without_stars(const Triangle_soup& soup,
                                   const std::vector<std::size_t>& vertices)
{
  return with_faces(soup, [&](const Triangle& t) {
    return std::none_of(t.begin(), t.end(), [&](std::size_t v) {
      return std::find(vertices.begin(), vertices.end(), v) != vertices.end();
    });
  });
}

inline Triangle_soup without_face(Triangle_soup soup, std::size_t face)
{
  soup.triangles.erase(soup.triangles.begin() + static_cast<std::ptrdiff_t>(face));
  return without_isolated_vertices(soup);
}

// the vertex nearest to a point
inline std::size_t nearest_vertex(const Triangle_soup& soup, const Point& p)
{
  const auto is_nearer = [&](const Point& q, const Point& r) {
    return distance(p, q) < distance(p, r);
  };
  return static_cast<std::size_t>(
    std::min_element(soup.points.begin(), soup.points.end(), is_nearer) - soup.points.begin());
}

} // namespace soups

// all openings as poles, and some vertices
inline CGAL::Surface_mesh_foliation::Poles_and_loops<Mesh> openings_and_poles(
  const Mesh& mesh, const std::vector<std::size_t>& poles = {})
{
  CGAL::Surface_mesh_foliation::Poles_and_loops<Mesh> result;
  for (const auto h : border_halfedges(mesh))
    result.add_border_pole(h);
  for (const std::size_t v : poles)
    result.add_pole(vertex(v));
  return result;
}

struct Open_case
{
  std::string name;
  Triangle_soup soup;
  std::vector<std::size_t> poles;
  std::size_t openings, nodes, arcs;
  bool has_ears; // whether some faces lie entirely at an opening
};

inline void PrintTo(const Open_case& open, std::ostream* out)
{
  *out << open.name;
}

inline std::vector<Open_case> open_cases()
{
  using namespace soups;
  std::vector<Open_case> result;
  const Triangle_soup sphere = icosphere(3);
  const Triangle_soup bowl = part_below(sphere, 2, 0.3);
  const std::size_t bottom = nearest_vertex(bowl, {0, 0, -1});
  result.push_back({"disk", bowl, {bottom}, 1, 2, 1, false});
  result.push_back({"disk with two poles", bowl, {bottom, 0}, 1, 4, 3, false});
  result.push_back({"annulus", plane_annulus(12, 5), {}, 2, 2, 1, false});
  result.push_back({"annulus with a pole", plane_annulus(12, 5), {2 * 12}, 2, 4, 3, false});
  result.push_back({"strip", tube(5, {{1, 0}, {1, 1}}), {}, 2, 2, 1, false});
  result.push_back({"smallest strip", tube(3, {{1, 0}, {1, 1}}), {}, 2, 2, 1, false});
  result.push_back({"pair of pants",
                    without_caps(sphere, {{1, 0, 0}, {-0.5, 0.9, 0}, {-0.5, -0.9, 0}}, 0.9),
                    {},
                    3,
                    4,
                    3,
                    false});
  const Triangle_soup cup = with_apex(plane_annulus(9, 3), 9, {0, 0, -0.5});
  const std::size_t apex = cup.points.size() - 1, rim = 2 * 9;
  const Point tip = scaled(sum(cup.points[rim], cup.points[rim + 1]), 0.8);
  result.push_back({"ear", with_ear(cup, rim, rim + 1, tip, false), {apex}, 1, 2, 1, true});
  result.push_back(
    {"ear with a vertex", with_ear(cup, rim, rim + 1, tip, true), {apex}, 1, 2, 1, true});
  result.push_back(
    {"ear with a pole", with_ear(cup, rim, rim + 1, tip, true), {apex, apex + 2}, 1, 4, 3, false});
  Triangle_soup ears = with_ear(cup, rim, rim + 1, tip, true); // one on the other, and a second
  ears = with_ear(ears, rim, apex + 1, scaled(tip, 1.2), false);
  ears = with_ear(ears, rim + 4, rim + 5, sum(ears.points[rim + 4], {0, 0, 1}), false);
  result.push_back({"ears", ears, {apex}, 1, 2, 1, true});
  Triangle_soup strip = with_ear(cup, rim, rim + 1, tip, false); // sticks out
  for (std::size_t i = 0, a = rim, b = apex + 1; i < 4; ++i)
  {
    const Point p = sum(strip.points[i % 2 == 0 ? a : b], {0, 0, 0.3});
    strip = with_ear(strip, a, b, p, false);
    (i % 2 == 0 ? a : b) = strip.points.size() - 1;
  }
  result.push_back({"thin strip", strip, {apex}, 1, 2, 1, true});
  result.push_back({"glasses", glasses(8, 3), {}, 3, 4, 3, false});
  result.push_back({"glasses of chords", glasses(6, 2), {}, 3, 4, 3, false});
  result.push_back({"opening of three edges",
                    without_face(icosphere(2), 100),
                    {nearest_vertex(icosphere(2), {0, 0, 1})},
                    1,
                    2,
                    1,
                    false});
  // two faces with an edge between them
  Triangle_soup neighbors = icosphere(2);
  const Triangle first = neighbors.triangles[0];
  neighbors = with_faces(neighbors, [&](const Triangle& t) { return t != first; });
  const auto has = [&](const Triangle& t, std::size_t v) {
    return std::find(t.begin(), t.end(), v) != t.end();
  };
  const Triangle_soup ball = neighbors;
  Triangle second = {};
  for (const Triangle& t : ball.triangles) // none of whose vertices is one of the first face's
    if (!has(t, first[0]) && !has(t, first[1]) && !has(t, first[2]))
      for (const Triangle& s : ball.triangles) // but one is joined to it
        if (second == Triangle{} && has(s, first[0]) &&
            (has(s, t[0]) || has(s, t[1]) || has(s, t[2])))
          second = t;
  neighbors = with_faces(ball, [&](const Triangle& t) { return t != second; });
  result.push_back({"openings joined by edges", neighbors, {}, 2, 2, 1, false});
  const Triangle_soup ring = torus(14, 9, 3, 1);
  result.push_back({"torus", without_stars(ring, {3, 70}), {}, 2, 3, 2, false});
  result.push_back({"smallest torus", without_stars(torus(3, 3, 3, 1), {0}), {}, 1, 2, 1, false});
  const Triangle_soup plate = genus_surface(2, 2);
  result.push_back(
    {"genus 2",
     without_stars(plate, {nearest_vertex(plate, {0, 0, 0}), nearest_vertex(plate, {10, 6, 2})}),
     {},
     2,
     3,
     2,
     false});
  return result;
}

} // namespace smf_test

#endif // SMF_TEST_OPEN_MESHES_H
