// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_EDGE_VALUE_PLACES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_EDGE_VALUE_PLACES_H

#include <CGAL/Surface_mesh_foliation/internal/Common/Disjoint_sets.h>
#include <CGAL/Surface_mesh_foliation/internal/Edge_values/Edge_value_surface.h>

#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The places of a foliation that is given by edge values: single vertices, and clusters of vertices
// joined by flat edges, with their indices [3.1, 3.2].
//
// A prong is a leaf that ends at a place; it leaves the place through a regular face whose closed
// corner is there, or along a flat edge, that is, inside the cluster. A place with Euler
// characteristic chi and P prongs has index 2 chi - P: 2 for a center pole, 1 for a thorn, 0 for a
// regular vertex, -m for a saddle of order m. A cluster of index 0 is a disk that a leaf runs
// through, or a closed leaf.
class Edge_value_places
{
public:
  struct Place
  {
    std::vector<int> vertices;
    std::vector<int> prongs; // the regular faces with their closed corner here
    int euler_characteristic = 0;
    bool is_node = false; // a singularity, or a regular place that was made a node

    int index() const { return 2 * euler_characteristic - static_cast<int>(prongs.size()); }
    bool is_pole() const { return is_node && euler_characteristic == 1 && prongs.empty(); }
  };

  explicit Edge_value_places(const Edge_value_surface& surface)
    : m_surface(surface), m_place_of_vertex(surface.mesh().number_of_vertices(), -1)
  {
    find_clusters();
    count_cells();
    [[maybe_unused]] int sum = 0;
    for (Place& place : m_places)
    {
      place.is_node = place.index() != 0;
      m_has_node = m_has_node || place.is_node;
      sum += place.index();
    }
    // an identity, for every choice of closed corners
    CGAL_assertion(sum == 2 * surface.mesh().euler_characteristic());
    // a torus without singularities: the leaf through any place can be its node
    if (!m_has_node)
      m_places[0].is_node = true;
  }

  const std::vector<Place>& places() const { return m_places; }
  int place_of_vertex(int v) const { return m_place_of_vertex[v]; }
  bool is_node(int v) const { return m_places[m_place_of_vertex[v]].is_node; }
  // whether there is a singularity
  bool is_singular() const { return m_has_node; }

private:
  void find_clusters()
  {
    const Flat_mesh& mesh = m_surface.mesh();
    Disjoint_sets sets(static_cast<std::size_t>(mesh.number_of_vertices()));
    for (int e = 0; e < mesh.number_of_edges(); ++e)
      if (m_surface.is_flat(e))
        sets.union_set(static_cast<std::size_t>(mesh.source(halfedge_of(e))),
                       static_cast<std::size_t>(mesh.target(halfedge_of(e))));
    for (int v = 0; v < mesh.number_of_vertices(); ++v)
    {
      int& place = m_place_of_vertex[sets.find_set(static_cast<std::size_t>(v))];
      if (place < 0)
      {
        place = static_cast<int>(m_places.size());
        m_places.emplace_back();
      }
      m_places[place].vertices.push_back(v);
    }
    for (std::size_t p = 0; p < m_places.size(); ++p)
      for (int v : m_places[p].vertices)
        m_place_of_vertex[v] = static_cast<int>(p);
  }

  void count_cells()
  {
    const Flat_mesh& mesh = m_surface.mesh();
    for (Place& place : m_places)
      place.euler_characteristic = static_cast<int>(place.vertices.size());
    for (int e = 0; e < mesh.number_of_edges(); ++e)
      if (m_surface.is_flat(e))
        --place_of(halfedge_of(e)).euler_characteristic;
    for (int f = 0; f < mesh.number_of_faces(); ++f)
    {
      if (m_surface.is_face_flat(f))
        ++place_of(mesh.halfedge_of_face(f)).euler_characteristic;
      if (m_surface.closed_corner(f) != Edge_value_surface::NONE)
        place_of(m_surface.closed_corner(f)).prongs.push_back(f);
    }
  }

  Place& place_of(int h) { return m_places[m_place_of_vertex[m_surface.mesh().source(h)]]; }

  const Edge_value_surface& m_surface;
  std::vector<int> m_place_of_vertex;
  std::vector<Place> m_places;
  bool m_has_node = false;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_EDGE_VALUE_PLACES_H
