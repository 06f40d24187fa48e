// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LOOPS_LOOP_AFTER_FLIPS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LOOPS_LOOP_AFTER_FLIPS_H

#include <CGAL/Surface_mesh_foliation/internal/Loops/Flat_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Delaunay_flips.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Carries a simple loop from a mesh to the one after some of its edges were flipped or divided. It
// stays where it is, but for where it crosses an edge that is divided: only crossings with edges
// that change, or are new, change.
class Loop_after_flips
{
public:
  Loop_after_flips(const Flat_mesh& before, const Flat_loop& loop) : m_loop(loop)
  {
    for (const Flat_crossing& crossing : loop.crossings)
      m_crossings.push_back(
        {before.source(crossing.halfedge), before.target(crossing.halfedge), crossing.position});
  }

  void operator()(const Edge_change& change)
  {
    const auto [u, v, left, right, middle] = change;
    if (middle == Edge_change::NONE)
      return cross_diagonal(u, v, left, right);
    for (Crossing& x : m_crossings) // all of them cross the half at u
      if (x.source == u && x.target == v)
        x.target = middle;
      else if (x.source == v && x.target == u)
        x.source = middle;
    cross_diagonal(u, v, left, middle);
    cross_diagonal(v, u, right, middle);
  }

  Flat_loop on(const Flat_mesh& after) const
  {
    Flat_loop result = m_loop;
    result.crossings.clear();
    for (const Crossing& x : m_crossings)
      result.crossings.push_back({after.find_halfedge(x.source, x.target), x.position});
    return result;
  }

private:
  struct Crossing
  {
    int source, target; // of the halfedge that is crossed
    double position;
  };

  // the part of the loop after a crossing
  struct Piece
  {
    std::size_t after;
    bool is_from_u; // whether it starts in the new face at u
    double way;     // of its end there, from the right corner over u to the left one
  };

  // The diagonal from right to left of the quadrilateral u, right, v, left, with no other inside.
  void cross_diagonal(int u, int v, int left, int right)
  {
    // counterclockwise around the quadrilateral; the first and the last meet at u
    const std::array<std::array<int, 2>, 4> sides = {
      {{u, right}, {right, v}, {v, left}, {left, u}}};
    const auto last =
      std::remove_if(m_crossings.begin(), m_crossings.end(), [u = u, v = v](const Crossing& x) {
        return (x.source == u && x.target == v) || (x.source == v && x.target == u);
      });
    m_crossings.erase(last, m_crossings.end());
    // the pieces of the loop inside it that cross the new diagonal
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < m_crossings.size(); ++i)
    {
      const int first = side_of(sides, m_crossings[i].target, m_crossings[i].source);
      if (first < 0)
        continue;
      const std::size_t next = (i + 1) % m_crossings.size();
      const int second = side_of(sides, m_crossings[next].source, m_crossings[next].target);
      if (is_at_u(first) != is_at_u(second))
        pieces.push_back({i, is_at_u(first),
                          is_at_u(first) ? way(first, 1 - m_crossings[i].position)
                                         : way(second, m_crossings[next].position)});
    }
    insert(pieces, right, left);
  }

  static int side_of(const std::array<std::array<int, 2>, 4>& sides, int source, int target)
  {
    for (int i = 0; i < 4; ++i)
      if (sides[i][0] == source && sides[i][1] == target)
        return i;
    return -1;
  }

  static bool is_at_u(int side) { return side == 0 || side == 3; }

  static double way(int side, double position) { return side == 0 ? 1 - position : 2 - position; }

  // Pieces are disjoint, so they cross the diagonal in the order of their ends.
  void insert(std::vector<Piece>& pieces, int right, int left)
  {
    std::sort(pieces.begin(), pieces.end(),
              [](const Piece& x, const Piece& y) { return x.way < y.way; });
    std::vector<std::pair<std::size_t, Crossing>> added;
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
      const double position = double(i + 1) / double(pieces.size() + 1);
      added.emplace_back(pieces[i].after, pieces[i].is_from_u
                                            ? Crossing{right, left, position}
                                            : Crossing{left, right, 1 - position});
    }
    std::sort(added.begin(), added.end(),
              [](const auto& x, const auto& y) { return x.first > y.first; });
    for (const auto& [after, crossing] : added)
      m_crossings.insert(m_crossings.begin() + static_cast<std::ptrdiff_t>(after) + 1, crossing);
  }

  const Flat_loop& m_loop;
  std::vector<Crossing> m_crossings;
};

inline Flat_loop loop_after_flips(const Flat_mesh& before,
                                  const Flat_loop& loop,
                                  const Delaunay_flips& flips)
{
  Loop_after_flips result(before, loop);
  for (const Edge_change& change : flips.changes())
    result(change);
  return result.on(flips.mesh());
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LOOPS_LOOP_AFTER_FLIPS_H
