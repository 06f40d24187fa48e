// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_DISK_FUNCTION_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_DISK_FUNCTION_H

#include <CGAL/Surface_mesh_foliation/internal/Edge_values/Disk_cut.h>
#include <CGAL/Surface_mesh_foliation/internal/Edge_values/Edge_value_surface.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// What a level becomes where its leaf crosses an edge: sign * y + shift.
struct Level_transition
{
  int sign;
  double shift;
  double operator()(double y) const { return sign * y + shift; }
};

// The function on the disk whose differential is the foliation [5.2.3]; the leaves are its level
// sets. Each face has its own values at its corners; they agree across edges that are not cut. A
// cut edge has a transition function: Eq. (2), y -> -y + c, if the values along it run in opposite
// directions on its two sides, otherwise Eq. (3), y -> y + c.
//
// No leaf crosses a flat edge, so the walk from face to face never crosses one, and flat faces get
// no values. (A closed flat curve, which is a leaf, separates its two sides.)
class Disk_function
{
public:
  Disk_function(const Edge_value_surface& surface, const Disk_cut& cut)
    : m_surface(surface),
      m_cut(cut),
      m_value(surface.mesh().number_of_halfedges(), 0),
      m_goes_up(surface.mesh().number_of_halfedges(), false),
      m_is_reached(surface.mesh().number_of_faces(), false)
  {
    for (int f = 0; f < mesh().number_of_faces(); ++f)
      if (!m_is_reached[f] && !surface.is_face_flat(f))
        integrate_from(f);
  }

  // at source(h), in the face of h
  double at_source(int h) const { return m_value[h]; }
  double at_target(int h) const { return m_value[mesh().next(h)]; }
  // whether it increases along h in the face of h; precondition: h is not flat
  bool goes_up(int h) const { return m_goes_up[h]; }

  // how a level changes across h, from face(h) to the face beyond; precondition: h is not flat
  Level_transition transition(int h) const
  {
    if (!m_cut.is_cut(edge_of(h)))
      return {1, 0};
    const int sign =
      goes_up(h) == goes_up(opposite_of(h)) ? -1 : 1; // they run in opposite directions
    return {sign, at_target(opposite_of(h)) - sign * at_source(h)};
  }

private:
  const Flat_mesh& mesh() const { return m_surface.mesh(); }

  void integrate_from(int first)
  {
    std::vector<int> queue = {first};
    m_is_reached[first] = true;
    int h = mesh().halfedge_of_face(first);
    while (m_surface.is_flat(edge_of(h)))
      h = mesh().next(h);
    set_values(h, 0, m_surface.value(edge_of(h)), true);
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (int g : mesh().halfedges(queue[i]))
      {
        const int face = mesh().face(opposite_of(g));
        if (m_is_reached[face] || m_cut.is_cut(edge_of(g)) || m_surface.is_flat(edge_of(g)))
          continue;
        m_is_reached[face] = true;
        queue.push_back(face);
        set_values(opposite_of(g), at_target(g), at_source(g), !goes_up(g));
      }
  }

  // Orients and integrates the form on the face of h, given the values at both ends of h.
  void set_values(int h, double at_p, double at_q, bool goes_up)
  {
    const int next = mesh().next(h), prev = mesh().prev(h);
    const int closed = m_surface.closed_corner(mesh().face(h));
    const double up = goes_up ? 1 : -1; // from p to q
    m_value[h] = at_p;
    m_value[next] = at_q;
    m_goes_up[h] = goes_up;
    m_goes_up[next] = closed == next ? goes_up : !goes_up;
    m_goes_up[prev] = closed == h ? goes_up : !goes_up;
    if (closed == Edge_value_surface::NONE)
      m_value[prev] = m_surface.is_flat(edge_of(next)) ? at_q : at_p;
    else if (closed == h) // p lies between the apex and q
      m_value[prev] = at_p - up * m_surface.value(edge_of(prev));
    else if (closed == next) // q lies between p and the apex
      m_value[prev] = at_q + up * m_surface.value(edge_of(next));
    else // the apex lies between p and q; from the nearer one the rounding error is smaller
      m_value[prev] = m_surface.value(edge_of(prev)) < m_surface.value(edge_of(next))
                        ? at_p + up * m_surface.value(edge_of(prev))
                        : at_q - up * m_surface.value(edge_of(next));
  }

  const Edge_value_surface& m_surface;
  const Disk_cut& m_cut;
  std::vector<double> m_value; // by halfedge: at its source, in its face
  std::vector<bool> m_goes_up; // by halfedge, in its face
  std::vector<bool> m_is_reached;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_DISK_FUNCTION_H
