// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_EXPERIMENTS_VARIANTS_H
#define SMF_EXPERIMENTS_VARIANTS_H

#include "Face_tree.h"
#include "Shapes.h"
#include "generators/Random.h"
#include "generators/meshes.h"
#include "generators/remeshed.h"

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

// Other meshes of the same shape.

namespace smf_experiments {

// ===  Resolution

inline Mesh simplified(Mesh mesh, double ratio)
{
  namespace Simplification = CGAL::Surface_mesh_simplification;
  const auto wanted = static_cast<std::size_t>(ratio * static_cast<double>(num_edges(mesh)));
  Simplification::edge_collapse(mesh, Simplification::Count_stop_predicate<Mesh>(wanted));
  mesh.collect_garbage();
  return mesh;
}

// ===  Noise

// moves vertices along their normals by up to `amplitude` mean lengths of edges
inline Mesh noisy_along_normals(Mesh mesh, double amplitude, std::uint64_t seed)
{
  const double most = amplitude * smf_test::mean_edge_length(mesh);
  smf_test::Random random(seed);
  std::vector<Kernel::Vector_3> normals;
  for (const Vertex v : vertices(mesh))
    normals.push_back(CGAL::Polygon_mesh_processing::compute_vertex_normal(v, mesh));
  for (const Vertex v : vertices(mesh))
    mesh.point(v) = mesh.point(v) + normals[v.idx()] * random.between(-most, most);
  return mesh;
}

// ===  Triangulation

// with a new vertex next to an edge in a share of the faces
inline Mesh with_slivers(Mesh mesh, double share, std::uint64_t seed)
{
  smf_test::Random random(seed);
  const std::vector<Face> old(faces(mesh).begin(), faces(mesh).end());
  for (const Face f : old)
    if (random.between(0, 1) < share)
    {
      const std::array<Vertex, 3> corner = corners(mesh, f);
      const Point p = CGAL::barycenter(mesh.point(corner[0]), 0.495, mesh.point(corner[1]), 0.495,
                                       mesh.point(corner[2]), 0.01);
      mesh.point(mesh.target(CGAL::Euler::add_center_vertex(mesh.halfedge(f), mesh))) = p;
    }
  return mesh;
}

// with triangles that are long in one direction: an isotropic mesh of the shape squeezed in it
inline Mesh anisotropic(Mesh mesh, int direction, double factor)
{
  const auto scale = [&](double s) {
    for (const Vertex v : vertices(mesh))
    {
      std::array<double, 3> p = {mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()};
      p[direction] *= s;
      mesh.point(v) = Point(p[0], p[1], p[2]);
    }
  };
  const std::size_t n = num_vertices(mesh);
  scale(1 / factor);
  mesh = smf_test::remeshed(std::move(mesh), n);
  scale(factor);
  return mesh;
}

// ===  All

struct Variant
{
  std::string kind, name;
  Mesh mesh;
};

// calls `visit` with each of the variants, one after another; those of resolution first
template <class Visit>
void for_each_variant(const Shape& shape, Visit visit)
{
  for (const std::size_t n : {1000, 4000, 16000, 64000})
    visit(Variant{"resolution", "remeshed to " + std::to_string(n / 1000) + "k",
                  smf_test::remeshed(shape.mesh, n)});
  visit(Variant{"resolution", "simplified to a half", simplified(shape.mesh, 0.5)});
  visit(Variant{"resolution", "midpoint subdivision", smf_test::midpoint_subdivided(shape.mesh)});
  for (const int percent : {10, 20, 30})
  {
    const std::string name = std::to_string(percent) + "%";
    visit(Variant{"noise", name + " along normals",
                  noisy_along_normals(shape.mesh, percent / 100., 1)});
    visit(Variant{"noise", name + " all ways", smf_test::noisy(shape.mesh, percent / 100., 1)});
  }
  visit(Variant{"triangulation", "30% of edges flipped",
                smf_test::flip_random_edges(shape.mesh, 0.3, 1)});
  visit(Variant{"triangulation", "slivers", with_slivers(shape.mesh, 0.3, 1)});
  visit(Variant{"triangulation", "anisotropic", anisotropic(shape.mesh, shape.up, 4)});
}

// ===  Correspondence

// Finds places of a mesh on the mesh of the shape that it is a variant of.
class Places
{
public:
  explicit Places(const Mesh& mesh)
    : m_mesh(mesh), m_tree(faces(mesh).begin(), faces(mesh).end(), mesh)
  {
    m_tree.accelerate_distance_queries();
  }

  // for each face of another mesh the nearest face of this one
  std::vector<Face> nearest_faces(const Mesh& other) const
  {
    std::vector<Face> result;
    for (const Face f : faces(other))
    {
      const std::array<Vertex, 3> corner = corners(other, f);
      result.push_back(nearest_face(
        CGAL::centroid(other.point(corner[0]), other.point(corner[1]), other.point(corner[2]))));
    }
    return result;
  }

  // for each vertex of another mesh the part in which it lies
  std::vector<int> parts_of_vertices(const Mesh& other, const std::vector<int>& part_of_face) const
  {
    std::vector<int> result;
    for (const Vertex v : vertices(other))
      result.push_back(part_of_face[nearest_face(other.point(v)).idx()]);
    return result;
  }

  Face nearest_face(const Point& p) const { return m_tree.closest_point_and_primitive(p).second; }

  // The distance of an inner point from the surface, divided by the distance in the opposite
  // direction: 1 in the middle of a tube or slab, 0 on the surface.
  double balance(const Point& p) const
  {
    const Point q = m_tree.closest_point(p);
    const double near = std::sqrt(CGAL::squared_distance(p, q));
    if (near == 0)
      return 0;
    const auto opposite = m_tree.first_intersected_primitive(Kernel::Ray_3(p, p - q));
    if (!opposite)
      return 0;
    const std::array<Vertex, 3> corner = corners(m_mesh, *opposite);
    const Kernel::Plane_3 plane(m_mesh.point(corner[0]), m_mesh.point(corner[1]),
                                m_mesh.point(corner[2]));
    const Kernel::Vector_3 direction = (p - q) / near, normal = plane.orthogonal_vector();
    const double far = ((m_mesh.point(corner[0]) - p) * normal) / (direction * normal);
    return (std::min)(near / far, 1.);
  }

private:
  const Mesh& m_mesh;
  Face_tree m_tree;
};

// for each of some vertices of a mesh the nearest vertex of another one
inline std::vector<Vertex> nearest_vertices(const Mesh& mesh,
                                            const std::vector<Vertex>& wanted,
                                            const Mesh& other)
{
  std::vector<Vertex> result;
  for (const Vertex w : wanted)
  {
    const auto distance = [&](Vertex v) {
      return CGAL::squared_distance(mesh.point(w), other.point(v));
    };
    result.push_back(
      *std::min_element(vertices(other).begin(), vertices(other).end(),
                        [&](Vertex u, Vertex v) { return distance(u) < distance(v); }));
  }
  return result;
}

} // namespace smf_experiments

#endif // SMF_EXPERIMENTS_VARIANTS_H
