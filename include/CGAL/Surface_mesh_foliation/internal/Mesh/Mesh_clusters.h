// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_MESH_CLUSTERS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_MESH_CLUSTERS_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Edge_collapses.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>

#include <CGAL/assertions.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// A coarser mesh of the same surface, whose vertices are clusters of vertices of a fine mesh, each
// formed by half-edge collapses.
//
// A face of the fine mesh survives if its corners are in three different clusters. The fine edges
// between two clusters follow each other, separated by faces that do not survive; so a coarse edge
// stands for a chain of fine ones, and a curve that crosses coarse edges for one that crosses all
// edges of their chains.
class Mesh_clusters
{
public:
  static constexpr int NONE = -1;

  // Precondition: no vertex of a cap was merged into another.
  Mesh_clusters(const Flat_mesh& fine, Edge_collapses collapses)
    : m_fine(fine), m_cluster(fine.number_of_vertices(), NONE)
  {
    std::vector<Point> points;
    for (int v = 0; v < fine.number_of_vertices(); ++v)
      if (collapses.representative(v) == v)
      {
        m_cluster[v] = static_cast<int>(m_representative.size());
        m_representative.push_back(v);
        points.push_back(fine.point(v));
      }
    for (int v = 0; v < fine.number_of_vertices(); ++v)
      m_cluster[v] = m_cluster[collapses.representative(v)];
    std::vector<Triangle> triangles;
    int first_cap_face = 0;
    for (int f = 0; f < fine.number_of_faces(); ++f)
    {
      const auto [h, i, j] = fine.halfedges(f);
      const Triangle triangle = {of_source(h), of_source(i), of_source(j)};
      if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])
        continue;
      triangles.push_back(triangle);
      m_fine_face.push_back(f);
      if (!fine.is_cap_face(f))
        first_cap_face = static_cast<int>(triangles.size());
    }
    m_mesh = Flat_mesh(std::move(points), triangles, fine.number_of_caps(), first_cap_face);
  }

  const Flat_mesh& mesh() const { return m_mesh; }

  // by fine vertex
  int operator[](int v) const { return m_cluster[v]; }
  int of_source(int h) const { return m_cluster[m_fine.source(h)]; }
  int of_target(int h) const { return m_cluster[m_fine.target(h)]; }

  // the fine vertex that a cluster was formed around, and whose point it has
  int representative(int cluster) const { return m_representative[cluster]; }

  // the coarse halfedge between the clusters of the ends of a fine one
  int coarse_halfedge(int h) const { return m_mesh.find_halfedge(of_source(h), of_target(h)); }

  // calls visit(g) for the fine halfedges that coarse halfedge h stands for, in the order in which
  // they are crossed on the way from face(h)
  template <class Visit>
  void for_each_in_chain(int h, const Visit& visit) const
  {
    for (int g = first_of_chain(h); g != NONE; g = next_in_chain(g))
      visit(g);
  }

private:
  // the fine halfedge in the face of coarse halfedge h
  int first_of_chain(int h) const
  {
    for (int g : m_fine.halfedges(m_fine_face[m_mesh.face(h)]))
      if (of_source(g) == m_mesh.source(h) && of_target(g) == m_mesh.target(h))
        return g;
    CGAL_assertion(false);
    return NONE;
  }

  // the other halfedge between the same clusters of the face across h, if there is one
  int next_in_chain(int h) const
  {
    for (int g : {m_fine.next(opposite_of(h)), m_fine.prev(opposite_of(h))})
      if (of_source(g) == of_source(h) && of_target(g) == of_target(h))
        return g;
    return NONE;
  }

  const Flat_mesh& m_fine;
  Flat_mesh m_mesh;
  std::vector<int> m_cluster;        // by fine vertex
  std::vector<int> m_representative; // by cluster
  std::vector<int> m_fine_face;      // by coarse face
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_MESH_CLUSTERS_H
