// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FEATURES_AVERAGE_GEODESIC_DISTANCES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FEATURES_AVERAGE_GEODESIC_DISTANCES_H

#include <CGAL/Surface_mesh_foliation/internal/Common/Poll.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Geodesic_distances.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/vertex_areas.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/vertex_farthest_from_centroid.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The mean distance of each vertex from the whole surface. The surface is sampled: each sample is
// the vertex farthest from the previous ones, and is weighted by the area that is nearer to it than
// to the others.
class Average_geodesic_distances
{
public:
  Average_geodesic_distances(const Flat_mesh& mesh,
                             int number_of_samples,
                             const Poll& poll = poll_nobody)
    : m_area(vertex_areas(mesh)),
      m_nearest_distance(mesh.number_of_vertices(), std::numeric_limits<double>::infinity()),
      m_nearest_sample(mesh.number_of_vertices(), 0)
  {
    const std::vector<double> lengths = edge_lengths(mesh);
    int sample = vertex_farthest_from_centroid(mesh);
    for (int i = 0; i < number_of_samples && m_nearest_distance[sample] > 0; ++i)
    {
      poll();
      visit(Geodesic_distances(mesh, lengths, {sample}).distances());
      sample =
        static_cast<int>(std::max_element(m_nearest_distance.begin(), m_nearest_distance.end()) -
                         m_nearest_distance.begin());
    }
  }

  std::vector<double> average() const
  {
    std::vector<double> weight(m_distances.size(), 0), result(m_nearest_sample.size(), 0);
    for (std::size_t v = 0; v < result.size(); ++v)
      weight[m_nearest_sample[v]] += m_area[v];
    for (std::size_t s = 0; s < weight.size(); ++s)
      for (std::size_t v = 0; v < result.size(); ++v)
        result[v] += weight[s] * m_distances[s][v];
    return result;
  }

private:
  void visit(std::vector<double> distances)
  {
    for (std::size_t v = 0; v < distances.size(); ++v)
      if (distances[v] < m_nearest_distance[v])
      {
        m_nearest_distance[v] = distances[v];
        m_nearest_sample[v] = m_distances.size();
      }
    m_distances.push_back(std::move(distances));
  }

  std::vector<double> m_area;                   // by vertex, as a share
  std::vector<double> m_nearest_distance;       // by vertex, from the samples
  std::vector<std::size_t> m_nearest_sample;    // by vertex
  std::vector<std::vector<double>> m_distances; // by sample and vertex
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FEATURES_AVERAGE_GEODESIC_DISTANCES_H
