// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_CRITICAL_LEAF_TRACER_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_CRITICAL_LEAF_TRACER_H

#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Edge_values/Disk_function.h>
#include <CGAL/Surface_mesh_foliation/internal/Edge_values/Edge_value_places.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The critical leaves of a foliation given by edge values [5.2.4]: from each prong of a node, the
// leaf is followed through the triangles, at the level given by the transition functions, until it
// reaches the closed corner of a node.
//
// Numbers decide only two things: on which side of the middle vertex of a triangle a leaf passes,
// and whether it hits a node there. Everything else is combinatorial, so rounding cannot lead a
// leaf out of a triangle.
class Critical_leaf_tracer
{
public:
  // A point where a leaf crosses an edge.
  struct Crossing
  {
    double way; // measured along the forward halfedge
    int leaf;
  };

  // Throws if a leaf is longer than the bound, or if two leaves end at the same prong.
  Critical_leaf_tracer(const Edge_value_surface& surface,
                       const Edge_value_places& places,
                       const Disk_function& function,
                       std::size_t max_length)
    : m_surface(surface),
      m_places(places),
      m_function(function),
      m_max_length(max_length),
      m_crossings(surface.mesh().number_of_edges()),
      m_has_prong(surface.mesh().number_of_faces(), false)
  {
    for (const Edge_value_places::Place& place : places.places())
      if (place.is_node)
        for (int prong : place.prongs)
          if (!m_has_prong[prong])
            trace(prong);
    for (std::vector<Crossing>& crossings : m_crossings)
      std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
        return a.way != b.way ? a.way < b.way : a.leaf < b.leaf;
      });
  }

  // the crossings of an edge, along its forward halfedge
  const std::vector<Crossing>& crossings(int e) const { return m_crossings[e]; }
  // whether a leaf ends at the closed corner of a face
  bool has_prong(int f) const { return m_has_prong[f]; }
  // the places at both ends of each leaf
  const std::vector<std::pair<int, int>>& ends() const { return m_ends; }

private:
  const Flat_mesh& mesh() const { return m_surface.mesh(); }
  int place_of_prong(int f) const
  {
    return m_places.place_of_vertex(mesh().source(m_surface.closed_corner(f)));
  }

  void trace(int prong)
  {
    const int leaf = static_cast<int>(m_ends.size()), corner = m_surface.closed_corner(prong);
    m_has_prong[prong] = true;
    double level = m_function.at_source(corner);
    int h = mesh().next(corner), entered = prong;
    for (std::size_t length = 0; h >= 0; ++length)
    {
      if (length >= m_max_length)
        throw_open_leaf(prong);
      m_crossings[edge_of(h)].push_back({way(h, level), leaf});
      level = m_function.transition(h)(level);
      entered = mesh().face(opposite_of(h));
      h = next_crossed(opposite_of(h), level);
    }
    end_at(entered, prong);
  }

  // where a level crosses h, measured along the forward halfedge
  double way(int h, double level) const
  {
    const double value = m_surface.value(edge_of(h)), up = m_function.goes_up(h) ? 1 : -1;
    const double from_source = std::clamp(up * (level - m_function.at_source(h)), 0., value);
    return is_forward(h) ? from_source : value - from_source;
  }

  // the halfedge across which a leaf that enters the face of g across g leaves it, or -1 if it ends
  // there
  int next_crossed(int g, double level) const
  {
    const int next = mesh().next(g), prev = mesh().prev(g);
    const int closed = m_surface.closed_corner(mesh().face(g));
    if (closed == Edge_value_surface::NONE)
      return m_surface.is_flat(edge_of(next)) ? prev : next;
    if (closed != prev) // opposite to the closed corner
      return closed == g ? next : prev;
    const double from_apex = level - m_function.at_source(prev);
    if (m_places.is_node(mesh().source(prev)) &&
        std::abs(from_apex) <= m_surface.tolerances().snap())
      return -1;
    return (from_apex > 0) == m_function.goes_up(prev) ? prev : next;
  }

  void end_at(int face, int prong)
  {
    if (m_has_prong[face])
      throw Invalid_foliation_exception(
        problem(Problem_kind::UNRESOLVED_LEAF,
                "two critical leaves come to one closed corner of face ",
                m_surface.origin_of_face(face), ": they cannot be told apart at this tolerance")
          .faces({index(m_surface.origin_of_face(face))}));
    m_has_prong[face] = true;
    m_ends.push_back({place_of_prong(prong), place_of_prong(face)});
  }

  [[noreturn]] void throw_open_leaf(int prong) const
  {
    const int v = mesh().source(m_surface.closed_corner(prong));
    const int f = m_surface.origin_of_face(prong);
    const std::string start =
      m_surface.is_center(v) ? text("face ", f) : text("vertex ", v, " in face ", f);
    throw Invalid_foliation_exception(
      problem(Problem_kind::OPEN_LEAF, "the leaf from ", start, " has not ended after ",
              m_max_length, " crossings")
        .vertices(m_surface.is_center(v) ? Indices() : Indices({index(v)}))
        .faces({index(f)}));
  }

  const Edge_value_surface& m_surface;
  const Edge_value_places& m_places;
  const Disk_function& m_function;
  std::size_t m_max_length;
  std::vector<std::vector<Crossing>> m_crossings; // by edge
  std::vector<bool> m_has_prong;                  // by face
  std::vector<std::pair<int, int>> m_ends;        // by leaf
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_CRITICAL_LEAF_TRACER_H
