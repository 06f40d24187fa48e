// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FEATURES_TIP_NEAR_CLUSTER_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FEATURES_TIP_NEAR_CLUSTER_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Mesh_clusters.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>

#include <cstddef>
#include <functional>
#include <queue>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// the clusters within some edges of one
inline std::set<int> clusters_near(const Flat_mesh& coarse, int cluster, int rings)
{
  std::set<int> result = {cluster};
  for (int i = 0; i < rings; ++i)
  {
    const std::vector<int> last(result.begin(), result.end());
    for (int c : last)
      for (int h : coarse.ring(c))
        result.insert(coarse.target(h));
  }
  return result;
}

// The tip of a limb that was found on a coarser mesh, as a vertex of the fine mesh: of the vertices
// in the clusters around, the one that is farthest from all others along edges. It depends on where
// the clusters end, but hardly on what they are.
class Tip_near_cluster
{
public:
  Tip_near_cluster(const Flat_mesh& fine, const Mesh_clusters& clusters)
    : m_fine(fine), m_clusters(clusters)
  {
    m_vertices.resize(clusters.mesh().number_of_vertices());
    for (int v = 0; v < fine.number_of_vertices(); ++v)
      m_vertices[clusters[v]].push_back(v);
  }

  int operator()(int cluster) const
  {
    constexpr int rings = 3;
    const std::set<int> near = clusters_near(m_clusters.mesh(), cluster, rings);
    using Entry = std::pair<double, int>; // distance from the border of the patch, vertex
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    for (int c : near)
      for (int v : m_vertices[c])
        if (is_at_border(v, near))
          queue.emplace(0, v);
    std::unordered_map<int, double> distance;
    int result = m_clusters.representative(cluster);
    while (!queue.empty())
    {
      const auto [d, v] = queue.top();
      queue.pop();
      if (!distance.emplace(v, d).second)
        continue;
      if (!is_at_opening(v))
        result = v; // the last one is the farthest
      for (int h : m_fine.ring(v))
      {
        const int u = m_fine.target(h);
        if (near.count(m_clusters[u]) > 0 && distance.count(u) == 0)
          queue.emplace(d + internal::distance(m_fine.point(u), m_fine.point(v)), u);
      }
    }
    return result;
  }

private:
  bool is_at_border(int v, const std::set<int>& near) const
  {
    for (int h : m_fine.ring(v))
      if (near.count(m_clusters[m_fine.target(h)]) == 0)
        return true;
    return false;
  }

  bool is_at_opening(int v) const
  {
    if (m_fine.is_cap_vertex(v))
      return true;
    for (int h : m_fine.ring(v))
      if (m_fine.is_cap_vertex(m_fine.target(h)))
        return true;
    return false;
  }

  const Flat_mesh& m_fine;
  const Mesh_clusters& m_clusters;
  std::vector<std::vector<int>> m_vertices; // by cluster
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FEATURES_TIP_NEAR_CLUSTER_H
