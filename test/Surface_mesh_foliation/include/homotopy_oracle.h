// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_HOMOTOPY_ORACLE_H
#define SMF_TEST_HOMOTOPY_ORACLE_H

#include "generators/meshes.h"

#include <CGAL/Surface_mesh_foliation/Loop.h>

#include <CGAL/Curves_on_surface_topology.h>
#include <CGAL/Path_on_surface.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace smf_test {

// CGAL's tests of homotopy for arbitrary curves (Erickson and Whittlesey, "Transforming curves on
// surfaces redux"), on a surface minus poles that share no neighbor: the faces around them are
// taken out.
class Homotopy_oracle
{
public:
  using Vertex = Mesh::Vertex_index;
  using Loop = CGAL::Surface_mesh_foliation::Loop<Mesh>;
  using Walk = std::vector<Mesh::Halfedge_index>; // closed; empty: it stays at a vertex

  Homotopy_oracle(const Mesh& mesh, std::vector<Vertex> poles)
    : m_mesh(mesh), m_with_holes(mesh), m_poles(std::move(poles))
  {
    for (const Vertex v : m_poles)
      make_hole(v);
    m_topology = std::make_unique<Topology>(m_with_holes);
  }

  // by pole, the walk around its hole
  const std::vector<Walk>& rims() const { return m_rims; }

  // The walk along the vertices to the left of a loop, or else to its right, that meets no pole.
  std::optional<Walk> walk_beside(const Loop& loop) const
  {
    for (bool is_left : {true, false})
    {
      std::vector<Vertex> corners;
      for (const auto& crossing : loop)
        corners.push_back(is_left ? target(crossing.halfedge, m_mesh)
                                  : source(crossing.halfedge, m_mesh));
      if (std::any_of(corners.begin(), corners.end(), [&](Vertex v) { return is_pole(v); }))
        continue;
      Walk walk;
      for (std::size_t i = 0; i < corners.size(); ++i)
      {
        const Vertex u = corners[i], v = corners[(i + 1) % corners.size()];
        if (u != v)
          walk.push_back(halfedge(u, v, m_mesh).first);
      }
      return walk;
    }
    return std::nullopt;
  }

  bool is_contractible(const Walk& walk) const
  {
    return walk.empty() || m_topology->is_contractible(path(walk));
  }

  // in one direction or the other
  bool are_freely_homotopic(const Walk& a, const Walk& b) const
  {
    if (a.empty() || b.empty())
      return a.empty() && b.empty();
    Path p = path(a);
    const Path q = path(b);
    if (m_topology->are_freely_homotopic(p, q))
      return true;
    p.reverse();
    return m_topology->are_freely_homotopic(p, q);
  }

private:
  using Path = CGAL::Surface_mesh_topology::Path_on_surface<Mesh>;
  using Topology = CGAL::Surface_mesh_topology::Curves_on_surface_topology<Mesh>;

  bool is_pole(Vertex v) const
  {
    return std::find(m_poles.begin(), m_poles.end(), v) != m_poles.end();
  }

  void make_hole(Vertex v)
  {
    Walk rim;
    for (const auto h : CGAL::halfedges_around_target(v, m_with_holes))
      rim.push_back(prev(h, m_with_holes));
    // they come clockwise, each of them runs counterclockwise
    std::reverse(rim.begin(), rim.end());
    m_rims.push_back(rim);
    const auto faces = CGAL::faces_around_target(halfedge(v, m_with_holes), m_with_holes);
    for (const auto f : std::vector<Mesh::Face_index>(faces.begin(), faces.end()))
      CGAL::Euler::remove_face(halfedge(f, m_with_holes), m_with_holes);
  }

  Path path(const Walk& walk) const
  {
    Path result(m_with_holes);
    for (const auto h : walk)
      result.push_back(h);
    EXPECT_TRUE(result.is_closed());
    return result;
  }

  Mesh m_mesh, m_with_holes; // the elements of both have the same numbers
  std::vector<Vertex> m_poles;
  std::vector<Walk> m_rims;
  std::unique_ptr<Topology> m_topology;
};

} // namespace smf_test

#endif // SMF_TEST_HOMOTOPY_ORACLE_H
