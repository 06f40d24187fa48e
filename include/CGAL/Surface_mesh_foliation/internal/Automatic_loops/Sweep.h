// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_AUTOMATIC_LOOPS_SWEEP_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_AUTOMATIC_LOOPS_SWEEP_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Pole.h>
#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/Vertex_order.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The order in which a function sweeps over the vertices, arranged so that the vertices of each
// pole directly follow one another: all have the least of their values. Among equal values, those
// of poles come last, by the number of the pole and along it; the others are ordered by vertex.
//
// A level is given by the number of vertices below it.
class Sweep
{
public:
  // Precondition: the values are finite and the poles disjoint.
  Sweep(std::vector<double> values, const std::vector<Pole>& poles)
    : m_values(std::move(values)), m_pole_of_vertex(m_values.size(), -1)
  {
    std::vector<int> place(m_values.size());
    std::iota(place.begin(), place.end(), 0);
    for (std::size_t p = 0; p < poles.size(); ++p)
    {
      double least = m_values[poles[p][0]];
      for (int v : poles[p])
        least = (std::min)(least, m_values[v]);
      for (std::size_t i = 0; i < poles[p].size(); ++i)
      {
        m_values[poles[p][i]] = least;
        m_pole_of_vertex[poles[p][i]] = static_cast<int>(p);
        place[poles[p][i]] = static_cast<int>(i);
      }
    }
    std::vector<int> vertices(m_values.size());
    std::iota(vertices.begin(), vertices.end(), 0);
    const auto key = [&](int v) {
      return std::make_tuple(m_values[v], m_pole_of_vertex[v], place[v]);
    };
    std::sort(vertices.begin(), vertices.end(), [&](int u, int v) { return key(u) < key(v); });
    std::vector<double> ranks(m_values.size());
    for (std::size_t r = 0; r < ranks.size(); ++r)
      ranks[vertices[r]] = static_cast<double>(r);
    m_order = Vertex_order(std::move(ranks));
  }

  // the ranks are its values
  const Vertex_order& order() const { return m_order; }

  double value(int v) const { return m_values[v]; }
  int pole_of_vertex(int v) const { return m_pole_of_vertex[v]; }

  // whether one pole has vertices on both sides of a level
  bool meets_pole(int number_below) const
  {
    const int below = pole_of_vertex(m_order.vertex(number_below - 1));
    return below >= 0 && below == pole_of_vertex(m_order.vertex(number_below));
  }

  // The level halfway between the values of two vertices, or as near to that as possible, that
  // meets no pole; -1 if there is none. Precondition: u comes before v.
  int level_between(int u, int v) const
  {
    const int least = m_order.rank(u) + 1, greatest = m_order.rank(v);
    const double middle = value(u) / 2 + value(v) / 2;
    int first = least, last = greatest; // the first level above the middle, or the greatest
    while (first < last)
    {
      const int level = first + (last - first) / 2;
      if (value(m_order.vertex(level)) > middle)
        last = level;
      else
        first = level + 1;
    }
    int level = first;
    while (level < greatest && meets_pole(level))
      ++level;
    if (meets_pole(level))
      level = first;
    while (level > least && meets_pole(level))
      --level;
    return meets_pole(level) ? -1 : level;
  }

private:
  std::vector<double> m_values; // by vertex
  std::vector<int> m_pole_of_vertex;
  Vertex_order m_order;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_AUTOMATIC_LOOPS_SWEEP_H
