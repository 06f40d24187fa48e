// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FEATURES_AVERAGE_GEODESIC_DISTANCES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FEATURES_AVERAGE_GEODESIC_DISTANCES_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Features/Laplacian.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Surface_mesh_copy.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/vertex_farthest_from_centroid.h>

#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The mean distance of each vertex from the whole surface, by the heat method. The surface is
// sampled: each sample is the vertex farthest from the previous ones, and is weighted by the area
// that is nearer to it than to the others.
class Average_geodesic_distances
{
public:
  Average_geodesic_distances(const Flat_mesh& mesh, int number_of_samples)
    : m_mesh(surface_mesh_copy(mesh)),
      m_heat_method(m_mesh),
      m_distance(m_mesh.add_property_map<Vertex, double>("v:distance", 0).first),
      m_area(Laplacian(mesh).mass()),
      m_nearest_distance(mesh.number_of_vertices(), std::numeric_limits<double>::infinity()),
      m_nearest_sample(mesh.number_of_vertices(), 0)
  {
    int sample = vertex_farthest_from_centroid(mesh);
    for (int i = 0; i < number_of_samples && m_nearest_distance[sample] > 0; ++i)
    {
      visit(sample);
      sample =
        static_cast<int>(std::max_element(m_nearest_distance.begin(), m_nearest_distance.end()) -
                         m_nearest_distance.begin());
    }
  }

  std::vector<double> average() const
  {
    std::vector<double> weight(m_distances.size(), 0), result(m_nearest_sample.size(), 0);
    for (std::size_t v = 0; v < result.size(); ++v)
      weight[m_nearest_sample[v]] += m_area[static_cast<Eigen::Index>(v)];
    for (std::size_t s = 0; s < weight.size(); ++s)
      for (std::size_t v = 0; v < result.size(); ++v)
        result[v] += weight[s] * m_distances[s][v];
    return result;
  }

private:
  using Vertex = Surface_mesh_copy::Vertex_index;

  void visit(int sample)
  {
    const Vertex source(static_cast<unsigned int>(sample));
    m_heat_method.add_source(source);
    m_heat_method.estimate_geodesic_distances(m_distance);
    m_heat_method.remove_source(source);
    std::vector<double> distances;
    for (Vertex v : vertices(m_mesh))
    {
      const double distance = v != source && m_distance[v] > 0 ? m_distance[v] : 0;
      if (distance < m_nearest_distance[v])
      {
        m_nearest_distance[v] = distance;
        m_nearest_sample[v] = m_distances.size();
      }
      distances.push_back(distance);
    }
    m_distances.push_back(distances);
  }

  Surface_mesh_copy m_mesh;
  CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Surface_mesh_copy> m_heat_method;
  Surface_mesh_copy::Property_map<Vertex, double> m_distance;
  Eigen::VectorXd m_area;                       // by vertex
  std::vector<double> m_nearest_distance;       // by vertex, from the samples
  std::vector<std::size_t> m_nearest_sample;    // by vertex
  std::vector<std::vector<double>> m_distances; // by sample and vertex
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FEATURES_AVERAGE_GEODESIC_DISTANCES_H
