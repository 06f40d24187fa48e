// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_LEAF_CENTROIDS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_LEAF_CENTROIDS_H

#include <CGAL/Surface_mesh_foliation/internal/Common/Executor.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/Refined_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Centroid.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The centroids of leaves [5.4]. A leaf is the union of its segments, straight through the pieces
// of the faces, so no leaf has to be traced.
class Leaf_centroids
{
  using Faces = std::vector<Refined_mesh::Face>;

public:
  explicit Leaf_centroids(const Refined_mesh& refined,
                          const Executor& executor = executor_for<CGAL::Sequential_tag>())
    : m_refined(refined), m_executor(executor)
  {
    int number_of_arcs = 0;
    for (const Refined_mesh::Face& face : refined.faces)
      number_of_arcs = (std::max)(number_of_arcs, face.arc + 1);
    m_pieces_of_arc.resize(number_of_arcs);
    for (std::size_t begin = 0; begin < refined.faces.size(); begin = end_of_piece(begin))
      if (refined.faces[begin].arc != Refined_mesh::NONE)
        m_pieces_of_arc[refined.faces[begin].arc].push_back(begin);
  }

  // levels: by arc, ascending, strictly inside the arc
  template <class Centroid = internal::Centroid>
  std::vector<std::vector<Centroid>> of_levels(const std::vector<std::vector<double>>& levels) const
  {
    std::vector<std::vector<Centroid>> result(levels.size());
    for (std::size_t a = 0; a < levels.size(); ++a)
      result[a].resize(levels[a].size());
    const auto add_arc = [&](int, int a, int) {
      for (std::size_t begin : m_pieces_of_arc[a])
        add_segments(begin, end_of_piece(begin), levels[a], result[a]);
    };
    m_executor(static_cast<int>((std::min)(levels.size(), m_pieces_of_arc.size())), add_arc, 1);
    return result;
  }

  // by node; the centroid of a pole without edges is its vertex
  std::vector<Centroid> of_nodes(std::size_t number_of_nodes) const
  {
    std::vector<Centroid> centroids(number_of_nodes);
    for (const Refined_mesh::Face& face : m_refined.faces)
      for (int i : {0, 1, 2})
        if (face.is_critical[i])
          centroids[m_refined.node[face.vertices[i]]].add(
            m_refined.points[face.vertices[i]], m_refined.points[face.vertices[(i + 1) % 3]]);
    for (std::size_t v = 0; v < m_refined.points.size(); ++v)
      if (m_refined.node[v] != Refined_mesh::NONE && centroids[m_refined.node[v]].is_empty())
        centroids[m_refined.node[v]].add(m_refined.points[v], m_refined.points[v]);
    return centroids;
  }

private:
  std::size_t end_of_piece(std::size_t begin) const
  {
    std::size_t end = begin;
    while (end < m_refined.faces.size() &&
           m_refined.faces[end].piece == m_refined.faces[begin].piece)
      ++end;
    return end;
  }

  // adds the segments of the leaves through the piece of the faces [begin, end)
  template <class Centroid>
  void add_segments(std::size_t begin,
                    std::size_t end,
                    const std::vector<double>& levels,
                    std::vector<Centroid>& centroids) const
  {
    double lowest = m_refined.faces[begin].t[0], highest = lowest;
    for (std::size_t f = begin; f < end; ++f)
      for (double t : m_refined.faces[f].t)
      {
        lowest = (std::min)(lowest, t);
        highest = (std::max)(highest, t);
      }
    // a corner at a level counts as above it, so the lowest corner is strictly below
    const auto first = std::upper_bound(levels.begin(), levels.end(), lowest);
    const bool is_triangle = begin + 1 == end;
    for (auto it = first; it != levels.end() && *it <= highest; ++it)
      if (is_triangle)
        add_segment(m_refined.faces[begin], *it, centroids[it - levels.begin()]);
      else
        add_segment(begin, end, *it, centroids[it - levels.begin()]);
  }

  // where a level meets side i of a face
  Point place_on_side(const Refined_mesh::Face& face, int i, double level) const
  {
    const int j = (i + 1) % 3;
    const double share = (level - face.t[i]) / (face.t[j] - face.t[i]);
    return between(m_refined.points[face.vertices[i]], m_refined.points[face.vertices[j]], share);
  }

  // The level meets the two sides of the corner that it parts from the others.
  template <class Centroid>
  void add_segment(const Refined_mesh::Face& face, double level, Centroid& centroid) const
  {
    const bool is_above = face.t[0] >= level, is_next_above = face.t[1] >= level,
               is_last_above = face.t[2] >= level;
    const int apex = is_above == is_next_above ? 2 : is_next_above == is_last_above ? 0 : 1;
    centroid.add(place_on_side(face, apex, level), place_on_side(face, (apex + 2) % 3, level));
  }

  // t rises and falls once around the boundary of a piece, so two of its sides meet the level
  template <class Centroid>
  void add_segment(std::size_t begin, std::size_t end, double level, Centroid& centroid) const
  {
    std::array<Point, 2> ends;
    int number = 0;
    for (std::size_t f = begin; f < end; ++f)
      for (int i : {0, 1, 2})
      {
        const bool is_diagonal = (i == 0 && f != begin) || (i == 2 && f + 1 != end);
        const Refined_mesh::Face& face = m_refined.faces[f];
        const int j = (i + 1) % 3;
        if (is_diagonal || (face.t[i] >= level) == (face.t[j] >= level))
          continue;
        CGAL_assertion(number < 2);
        ends[number++] = place_on_side(face, i, level);
      }
    centroid.add(ends[0], ends[1]);
  }

  const Refined_mesh& m_refined;
  const Executor& m_executor;
  std::vector<std::vector<std::size_t>> m_pieces_of_arc; // the first face of each
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_LEAF_CENTROIDS_H
