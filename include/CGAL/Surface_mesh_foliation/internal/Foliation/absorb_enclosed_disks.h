// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_ABSORB_ENCLOSED_DISKS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_ABSORB_ENCLOSED_DISKS_H

#include <CGAL/Surface_mesh_foliation/internal/Foliation/Tree_map.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/Flat_loop_system.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// A chord of an opening joins two vertices of its border that are not neighbors there. If it and a
// piece of the border bound a disk without pole, its word is empty, and no leaf of the harmonic
// foliation enters the disk: all of it lies at the pole.
class Enclosed_disks
{
public:
  Enclosed_disks(const Flat_loop_system& system, const Tree_map& map)
    : m_system(system), m_mesh(system.mesh), m_map(map)
  {
    m_pole_of_vertex.assign(m_mesh.number_of_vertices(), NONE);
    for (std::size_t p = 0; p < system.poles.size(); ++p)
      for (int v : system.poles[p])
        m_pole_of_vertex[v] = static_cast<int>(p);
    m_is_reached.assign(m_mesh.number_of_faces(), false);
    for (int e = 0; e < m_mesh.number_of_edges(); ++e)
      if (is_trivial_chord(e))
        for (int h : halfedges_of_edge(e))
          explore(h);
  }

  // the faces of each disk, and the pole that it lies at
  struct Disk
  {
    std::vector<int> faces;
    int pole;
  };
  const std::vector<Disk>& disks() const { return m_disks; }
  bool is_pole(int v) const { return m_pole_of_vertex[v] != NONE; }

private:
  static constexpr int NONE = -1;

  int pole_of_ends(int e) const
  {
    const int h = halfedge_of(e);
    const int p = m_pole_of_vertex[m_mesh.source(h)];
    return p == m_pole_of_vertex[m_mesh.target(h)] ? p : NONE;
  }

  bool is_trivial_chord(int e) const
  {
    const int p = pole_of_ends(e);
    return p != NONE && m_system.poles[p].is_cap() && m_map.paths.is_empty(e) &&
           !m_mesh.is_border_edge(e) && !m_mesh.is_cap_edge(e);
  }

  // Collects the faces on the left of a chord up to borders and other trivial chords. They are an
  // open disk without another pole iff their Euler characteristic is 1: vertices of poles do not
  // count, and so another pole inside takes one away.
  void explore(int chord)
  {
    if (m_is_reached[m_mesh.face(chord)])
      return;
    std::vector<int> faces = {m_mesh.face(chord)}, vertices;
    m_is_reached[faces[0]] = true;
    int inner_sides = 0;
    const int pole = m_pole_of_vertex[m_mesh.source(chord)];
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (int h : m_mesh.halfedges(faces[i]))
      {
        const int v = m_mesh.source(h), g = m_mesh.face(opposite_of(h));
        if (m_pole_of_vertex[v] == NONE)
          vertices.push_back(v);
        if (m_mesh.is_border_edge(edge_of(h)) || is_trivial_chord(edge_of(h)))
          continue;
        ++inner_sides;
        if (!m_is_reached[g])
        {
          m_is_reached[g] = true;
          faces.push_back(g);
        }
      }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    const int euler_characteristic =
      static_cast<int>(vertices.size()) - inner_sides / 2 + static_cast<int>(faces.size());
    if (euler_characteristic == 1)
      m_disks.push_back({std::move(faces), pole});
  }

  const Flat_loop_system& m_system;
  const Flat_mesh& m_mesh;
  const Tree_map& m_map;
  std::vector<int> m_pole_of_vertex;
  std::vector<bool> m_is_reached; // by face
  std::vector<Disk> m_disks;
};

// Moves all enclosed disks to their poles in the map whose leaves lie in the loops, and says which
// vertices these are. No edge leaves a disk, so nothing else changes.
inline std::vector<int> absorb_enclosed_disks(const Flat_loop_system& system, Tree_map& map)
{
  std::vector<int> result;
  if (std::none_of(system.poles.begin(), system.poles.end(),
                   [](const Pole& pole) { return pole.is_cap(); }))
    return result;
  const Enclosed_disks enclosed(system, map);
  for (const Enclosed_disks::Disk& disk : enclosed.disks())
    for (int f : disk.faces)
      for (int h : system.mesh.halfedges(f))
      {
        while (!map.paths.is_empty(edge_of(h)))
          map.paths.pop_back(edge_of(h));
        const int v = system.mesh.source(h);
        if (enclosed.is_pole(v))
          continue;
        map.cell[v] = Cell::at_node(system.node_of_vertex[system.poles[disk.pole][0]]);
        result.push_back(v);
      }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_ABSORB_ENCLOSED_DISKS_H
