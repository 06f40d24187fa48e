// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_EXPERIMENTS_TUBES_H
#define SMF_EXPERIMENTS_TUBES_H

#include "Face_tree.h"
#include "Shapes.h"
#include "generators/Random.h"
#include "generators/genus_soups.h"
#include "generators/meshes.h"

#include <CGAL/Polygon_mesh_processing/compute_normal.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

// Small handles: topological noise.

namespace smf_experiments {

using Pair_of_faces = std::pair<Face, Face>;

// adds a straight tube with triangular rings between two faces that the caller removes
inline void add_straight_tube(smf_test::Triangle_soup& soup,
                              const smf_test::soups::Triangle first,
                              const smf_test::soups::Triangle second)
{
  namespace soups = smf_test::soups;
  constexpr std::size_t segments = 8;
  const soups::Triangle last = soups::matched_corners(soup, second, first);
  soups::Triangle ring = first;
  for (std::size_t i = 1; i <= segments; ++i)
  {
    soups::Triangle next_ring = last;
    const double t = static_cast<double>(i) / static_cast<double>(segments);
    for (std::size_t j = 0; i < segments && j < 3; ++j)
    {
      next_ring[j] = soup.points.size();
      soup.points.push_back(
        soups::sum(soups::scaled(soup.points[first[j]], 1 - t), soup.points[last[j]], t));
    }
    for (std::size_t j = 0; j < 3; ++j)
    {
      const std::size_t k = (j + 1) % 3;
      soup.triangles.push_back({ring[j], ring[k], next_ring[k]});
      soup.triangles.push_back({ring[j], next_ring[k], next_ring[j]});
    }
    ring = next_ring;
  }
}

// A copy of a mesh, whose vertices come first, with a thin tube between the faces of each pair. No
// two of the faces may share a vertex.
inline Mesh with_tubes(const Mesh& mesh, const std::vector<Pair_of_faces>& pairs)
{
  smf_test::Triangle_soup soup = smf_test::to_soup(mesh);
  std::vector<std::size_t> removed;
  for (const auto& [f, g] : pairs)
  {
    add_straight_tube(soup, soup.triangles[f.idx()], soup.triangles[g.idx()]);
    removed.push_back(f.idx());
    removed.push_back(g.idx());
  }
  std::sort(removed.begin(), removed.end());
  for (std::size_t i = removed.size(); i-- > 0;)
    soup.triangles.erase(soup.triangles.begin() + static_cast<std::ptrdiff_t>(removed[i]));
  return smf_test::to_mesh(soup);
}

// Chooses faces for tubes, at random, none next to another or to the tip of a limb.
class Tube_places
{
public:
  Tube_places(const Shape& shape, std::uint64_t seed)
    : m_shape(shape), m_random(seed), m_is_used(num_vertices(shape.mesh), false)
  {
    for (const Limb& limb : shape.limbs)
      m_is_used[limb.tip.idx()] = true;
    for (const Face f : faces(shape.mesh))
    {
      const std::array<Vertex, 3> corner = corners(shape.mesh, f);
      m_centers.push_back(CGAL::centroid(shape.mesh.point(corner[0]), shape.mesh.point(corner[1]),
                                         shape.mesh.point(corner[2])));
    }
  }

  // from one side of the body to the other
  std::vector<Pair_of_faces> tunnels(std::size_t number)
  {
    const Mesh& mesh = m_shape.mesh;
    const Face_tree tree(faces(mesh).begin(), faces(mesh).end(), mesh);
    return pairs(number, [&](Face f) {
      const auto inward = -CGAL::Polygon_mesh_processing::compute_face_normal(f, mesh);
      const auto hit = tree.first_intersected_primitive(Kernel::Ray_3(m_centers[f.idx()], inward),
                                                        [f](Face g) { return g == f; });
      return hit ? *hit : f;
    });
  }

  // from the outer half of a limb through the air to the nearest face of another part
  std::vector<Pair_of_faces> bridges(std::size_t number)
  {
    const double unit = diagonal(m_shape.mesh);
    return pairs(number, [&](Face f) {
      const int limb = m_shape.part_of_face[f.idx()];
      const Vertex v = corners(m_shape.mesh, f)[0];
      if (limb == m_shape.trunk() ||
          m_shape.distances[limb][v.idx()] > m_shape.limbs[limb].length * unit / 2)
        return f;
      Face result = f;
      double least = std::numeric_limits<double>::infinity();
      for (const Face g : faces(m_shape.mesh))
      {
        const double distance = CGAL::squared_distance(m_centers[f.idx()], m_centers[g.idx()]);
        if (m_shape.part_of_face[g.idx()] != limb && distance < least && is_free(g))
        {
          least = distance;
          result = g;
        }
      }
      return result;
    });
  }

private:
  bool is_free(Face f) const
  {
    const std::array<Vertex, 3> corner = corners(m_shape.mesh, f);
    return std::none_of(corner.begin(), corner.end(), [&](Vertex v) { return m_is_used[v.idx()]; });
  }

  void use(Face f)
  {
    for (const Vertex v : corners(m_shape.mesh, f))
      m_is_used[v.idx()] = true;
  }

  // random faces, each with `other(face)`, unless that is the same one
  template <class Other>
  std::vector<Pair_of_faces> pairs(std::size_t number, const Other& other)
  {
    std::vector<Pair_of_faces> result;
    for (int attempt = 0; attempt < 10000 && result.size() < number; ++attempt)
    {
      const Face f(static_cast<Mesh::size_type>(m_random.index(num_faces(m_shape.mesh))));
      if (!is_free(f))
        continue;
      const Face g = other(f);
      if (g == f || !is_free(g) || share_vertex(f, g))
        continue;
      use(f);
      use(g);
      result.emplace_back(f, g);
    }
    if (result.size() < number)
      throw std::runtime_error("there is no place for a tube on " + m_shape.name);
    return result;
  }

  bool share_vertex(Face f, Face g) const
  {
    const std::array<Vertex, 3> a = corners(m_shape.mesh, f), b = corners(m_shape.mesh, g);
    return std::any_of(a.begin(), a.end(),
                       [&](Vertex v) { return std::find(b.begin(), b.end(), v) != b.end(); });
  }

  const Shape& m_shape;
  smf_test::Random m_random;
  std::vector<bool> m_is_used;  // by vertex
  std::vector<Point> m_centers; // by face
};

} // namespace smf_experiments

#endif // SMF_EXPERIMENTS_TUBES_H
