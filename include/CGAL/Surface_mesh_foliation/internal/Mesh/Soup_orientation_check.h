// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_SOUP_ORIENTATION_CHECK_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_SOUP_ORIENTATION_CHECK_H

#include <CGAL/Surface_mesh_foliation/internal/Common/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Soup_edges.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// determines whether all faces of a soup are oriented consistently and, if not, whether reversing
// some would help. Edges must have at most two sides.
class Soup_orientation_check
{
public:
  Soup_orientation_check(const Soup_edges& edges, std::size_t number_of_faces)
    : m_edges(edges), m_turn(number_of_faces, Turn::UNKNOWN), m_opposite(3 * number_of_faces, none)
  {
    for (std::size_t edge = 0; edge < edges.size(); ++edge)
      if (edges.number_of_sides(edge) == 2)
      {
        m_opposite[edges.side(edge, 0)] = edges.side(edge, 1);
        m_opposite[edges.side(edge, 1)] = edges.side(edge, 0);
      }
  }

  std::optional<Problem> run()
  {
    for (std::size_t face = 0; face < m_turn.size(); ++face)
      if (m_turn[face] == Turn::UNKNOWN)
      {
        const std::size_t conflict = orient_component(face);
        if (conflict != none)
          return one_sidedness(conflict);
      }
    if (m_to_reverse.empty())
      return std::nullopt;
    return inconsistency();
  }

private:
  enum class Turn : char { UNKNOWN, KEPT, REVERSED };

  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  // The two sides of an edge between consistently oriented faces run in opposite directions.
  bool agree(std::size_t side, std::size_t opposite) const
  {
    return m_edges.source(side) == m_edges.target(opposite);
  }

  // decides for each face reachable from `seed` whether to reverse it; returns a side where that
  // fails
  std::size_t orient_component(std::size_t seed)
  {
    std::vector<std::size_t> component(1, seed);
    m_turn[seed] = Turn::KEPT;
    for (std::size_t i = 0; i < component.size(); ++i)
      for (std::size_t side = 3 * component[i]; side < 3 * component[i] + 3; ++side)
      {
        if (m_opposite[side] == none)
          continue;
        const std::size_t neighbor = Soup_edges::face(m_opposite[side]);
        const bool is_kept = agree(side, m_opposite[side]) == (m_turn[component[i]] == Turn::KEPT);
        const Turn wanted = is_kept ? Turn::KEPT : Turn::REVERSED;
        if (m_turn[neighbor] == Turn::UNKNOWN)
        {
          m_turn[neighbor] = wanted;
          component.push_back(neighbor);
        }
        else if (m_turn[neighbor] != wanted)
          return side;
      }
    collect_minority(component);
    return none;
  }

  void collect_minority(const std::vector<std::size_t>& component)
  {
    const auto is_kept = [this](std::size_t face) { return m_turn[face] == Turn::KEPT; };
    const auto number_kept =
      static_cast<std::size_t>(std::count_if(component.begin(), component.end(), is_kept));
    const bool is_minority_kept = 2 * number_kept < component.size();
    for (const std::size_t face : component)
      if (is_kept(face) == is_minority_kept)
        m_to_reverse.push_back(face);
  }

  Problem one_sidedness(std::size_t side) const
  {
    const std::size_t face = Soup_edges::face(side);
    const std::size_t neighbor = Soup_edges::face(m_opposite[side]);
    return problem(Problem_kind::NOT_ORIENTABLE,
                   "the mesh is not orientable: no reversal of faces makes all agree (seen "
                   "between the faces ",
                   face, " and ", neighbor, ")")
      .vertices({m_edges.source(side), m_edges.target(side)})
      .faces({face, neighbor});
  }

  Problem inconsistency() const
  {
    const std::size_t first = *std::min_element(m_to_reverse.begin(), m_to_reverse.end());
    const std::string message =
      m_to_reverse.size() == 1
        ? face_name(first) + " is oriented against its neighbors: reversing it would help"
        : "the faces are not oriented alike: reversing " + std::to_string(m_to_reverse.size()) +
            " of them would help, the first is face " + std::to_string(first);
    return problem(Problem_kind::NOT_ORIENTABLE, message).faces(m_to_reverse);
  }

  const Soup_edges& m_edges;
  std::vector<Turn> m_turn;            // of each face
  std::vector<std::size_t> m_opposite; // the other side of the same edge, or none
  std::vector<std::size_t> m_to_reverse;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_SOUP_ORIENTATION_CHECK_H
