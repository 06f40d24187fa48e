// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_FLAT_SYSTEMS_H
#define SMF_TEST_FLAT_SYSTEMS_H

#include "flat_meshes.h"
#include "generators/soups.h"

#include <CGAL/Surface_mesh_foliation/internal/Loops/Flat_loop_system.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <utility>
#include <vector>

// Loop systems on plain arrays, so small that the right answers can be worked out by hand, and
// quick to compile.

namespace smf_test {

namespace internal = CGAL::Surface_mesh_foliation::internal;

namespace soups {

// the torus with the fewest vertices: every two have an edge. Faces 2i are (i, i+1, i+3), faces
// 2i+1 are (i, i+3, i+2), modulo 7. The points are on a curve without four in a plane, and the
// surface meets itself.
inline Triangle_soup seven_vertex_torus()
{
  Triangle_soup result;
  for (std::size_t i = 0; i < 7; ++i)
  {
    const double x = static_cast<double>(i);
    result.points.push_back({x, x * x / 6, x * x * x / 36});
    result.triangles.push_back({i, (i + 1) % 7, (i + 3) % 7});
    result.triangles.push_back({i, (i + 3) % 7, (i + 2) % 7});
  }
  return result;
}

} // namespace soups

// the loop that crosses halfedges given by source and target, each at the same position
inline internal::Flat_loop flat_loop(const internal::Flat_mesh& mesh,
                                     const std::vector<std::pair<int, int>>& halfedges,
                                     double position = 0.5)
{
  internal::Flat_loop result;
  for (const auto& [source, target] : halfedges)
    result.crossings.push_back({mesh.find_halfedge(source, target), position});
  return result;
}

// the halfedges crossed by a loop through all faces of the seven-vertex torus. It is parallel to
// the cycle 0, 2, 4, 6, 1, 3, 5, and crosses all other edges once.
inline std::vector<std::pair<int, int>> seven_vertex_torus_loop()
{
  std::vector<std::pair<int, int>> result;
  for (int k = 0; k < 7; ++k)
  {
    const int i = 2 * k % 7;
    result.emplace_back((i + 3) % 7, i);
    result.emplace_back((i + 3) % 7, (i + 2) % 7);
  }
  return result;
}

// a pole loop that hugs its pole
inline internal::Flat_loop tight_pole_loop(int pole, double height = 1)
{
  internal::Flat_loop result;
  result.height = height;
  result.pole = pole;
  result.is_tight = true;
  return result;
}

inline internal::Flat_loop_system unchecked_system(const Triangle_soup& soup,
                                                   const std::vector<internal::Pole>& poles,
                                                   const std::vector<internal::Flat_loop>& loops)
{
  internal::Flat_loop_system result;
  result.mesh = flat_mesh(soup);
  result.poles = poles;
  for (std::size_t p = 0; p < poles.size(); ++p)
    result.loops.push_back(tight_pole_loop(static_cast<int>(p)));
  result.loops.insert(result.loops.end(), loops.begin(), loops.end());
  return result;
}

// a system of poles, with loops of height 1 that hug them, and further loops
inline internal::Flat_loop_system flat_system(const Triangle_soup& soup,
                                              const std::vector<internal::Pole>& poles,
                                              const std::vector<internal::Flat_loop>& loops = {})
{
  internal::Flat_loop_system result = unchecked_system(soup, poles, loops);
  internal::Problems problems;
  complete(result, problems);
  EXPECT_TRUE(problems.empty());
  return result;
}

// ===  Three systems with known answers

// Both poles of the octahedron are one arc of height 2, and the equator is its middle: the poles
// are vertices 4 (end 0) and 5 (end 1).
inline internal::Flat_loop_system octahedron_with_two_poles()
{
  return flat_system(soups::octahedron(), {{4}, {5}});
}

// Poles at the corners 0, 2 and 4 of a face: arcs 0, 1 and 2, each with its pole at end 0. The
// vertices 1, 3 and 5 of the opposite face are at node 3, and the edges of the face span two arcs.
inline internal::Flat_loop_system octahedron_with_three_poles()
{
  return flat_system(soups::octahedron(), {{0}, {2}, {4}});
}

// One loop and no pole: one arc of height 1 from the only node to itself.
inline internal::Flat_loop_system torus_with_one_loop()
{
  const Triangle_soup soup = soups::seven_vertex_torus();
  return flat_system(soup, {}, {flat_loop(flat_mesh(soup), seven_vertex_torus_loop())});
}

inline std::vector<double> unit_weights(const internal::Flat_loop_system& system)
{
  return std::vector<double>(system.mesh.number_of_edges(), 1);
}

} // namespace smf_test

#endif // SMF_TEST_FLAT_SYSTEMS_H
