// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_PROXY_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_PROXY_H

#include <CGAL/Surface_mesh_foliation/internal/Common/Named_parameters.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/require_parameter.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/user_count.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/Flat_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Edge_collapses.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Lengths_along_surface.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Mesh_clusters.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Pole.h>

#include <CGAL/Named_function_parameters.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// by vertex, whether it is an end of an edge that one of the loops crosses
inline std::vector<bool> vertices_beside_loops(const Flat_mesh& mesh,
                                               const std::vector<Flat_loop>& loops)
{
  std::vector<bool> result(mesh.number_of_vertices(), false);
  for (const Flat_loop& loop : loops)
    for (const Flat_crossing& crossing : loop.crossings)
      result[mesh.source(crossing.halfedge)] = result[mesh.target(crossing.halfedge)] = true;
  return result;
}

// A coarser mesh in place of a fine one, with the same poles. Loops are carried from one to the
// other without any change of class, and disjoint loops stay disjoint.
class Proxy
{
public:
  // Keeps the vertices beside the given loops, so that these can be carried to the proxy.
  // fineness: see Edge_collapses
  Proxy(const Flat_mesh& fine,
        const std::vector<Pole>& poles,
        const std::vector<Flat_loop>& loops,
        int number_of_vertices,
        std::vector<double> fineness = {})
    : m_clusters(fine,
                 Edge_collapses::with_even_lengths(
                   fine, kept(fine, poles, loops), number_of_vertices, std::move(fineness))),
      m_lengths(Lengths_along_surface(fine, m_clusters).lengths()),
      m_poles(poles)
  {
    for (Pole& pole : m_poles)
      for (int& v : pole)
        v = m_clusters[v];
  }

  static std::vector<Flat_loop> no_loops() { return {}; }

  Proxy(const Proxy&) = delete;
  Proxy& operator=(const Proxy&) = delete;

  const Flat_mesh& mesh() const { return m_clusters.mesh(); }
  const std::vector<double>& lengths() const { return m_lengths; } // see Lengths_along_surface
  const std::vector<Pole>& poles() const { return m_poles; }
  const Mesh_clusters& clusters() const { return m_clusters; }

  // one of the loops whose vertices were kept
  Flat_loop on_proxy(Flat_loop loop) const
  {
    for (Flat_crossing& crossing : loop.crossings)
      crossing.halfedge = m_clusters.coarse_halfedge(crossing.halfedge);
    return loop;
  }

  // any loop on the proxy
  Flat_loop on_fine_mesh(const Flat_loop& loop) const
  {
    Flat_loop result = loop;
    result.crossings.clear();
    for (const Flat_crossing& crossing : loop.crossings)
      m_clusters.for_each_in_chain(crossing.halfedge, [&](int h) {
        result.crossings.push_back({h, crossing.position});
      });
    return result;
  }

private:
  static std::vector<bool> kept(const Flat_mesh& fine,
                                const std::vector<Pole>& poles,
                                const std::vector<Flat_loop>& loops)
  {
    std::vector<bool> result = vertices_beside_loops(fine, loops);
    for (const Pole& pole : poles)
      for (int v : pole)
        result[v] = true;
    return result;
  }

  const Mesh_clusters m_clusters;
  const std::vector<double> m_lengths;
  std::vector<Pole> m_poles;
};

template <class NamedParameters>
int number_of_proxy_vertices(const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const int result =
    user_count(choose_parameter(get_parameter(np, internal_np::number_of_proxy_vertices), 5000));
  require_parameter(result >= 100, "there are fewer than 100 proxy vertices");
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_PROXY_H
