// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_GENERATORS_MESHES_H
#define SMF_GENERATORS_MESHES_H

#include "generators/genus_soups.h"
#include "Random.h"
#include "soups.h"

#include <CGAL/Surface_mesh_foliation/IO/read_triangle_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

// Meshes for tests and benchmarks. The same arguments give the same mesh everywhere, whatever its
// type: the i-th vertex and face are those of the soup. Without template argument the result is a
// `Surface_mesh`:
//
//   const auto mesh = smf_test::genus_surface(3);
//   const auto polyhedron = smf_test::genus_surface<Polyhedron>(3);

namespace smf_test {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// ===  Between soups and meshes

template <class TriangleMesh = Mesh>
TriangleMesh to_mesh(const Triangle_soup& soup)
{
  TriangleMesh mesh;
  CGAL::Surface_mesh_foliation::triangle_soup_to_triangle_mesh(soup, mesh);
  return mesh;
}

template <class TriangleMesh>
Triangle_soup to_soup(const TriangleMesh& mesh)
{
  const auto vertex_point_map = get(CGAL::vertex_point, mesh);
  const auto vertex_index_map = CGAL::get_initialized_vertex_index_map(mesh);
  Triangle_soup soup;
  for (const auto vertex : vertices(mesh))
  {
    const auto& point = get(vertex_point_map, vertex);
    soup.points.push_back(
      {CGAL::to_double(point.x()), CGAL::to_double(point.y()), CGAL::to_double(point.z())});
  }
  for (const auto face : faces(mesh))
  {
    const auto first = prev(halfedge(face, mesh), mesh);
    soups::Triangle triangle;
    auto current = first;
    for (std::size_t& corner : triangle)
    {
      corner = static_cast<std::size_t>(get(vertex_index_map, target(current, mesh)));
      current = next(current, mesh);
    }
    soup.triangles.push_back(triangle);
  }
  return soup;
}

// ===  Vertices by index

inline Mesh::Vertex_index vertex(std::size_t index)
{
  return Mesh::Vertex_index(static_cast<Mesh::size_type>(index));
}

inline std::vector<Mesh::Vertex_index> vertex_range(const std::vector<std::size_t>& indices)
{
  std::vector<Mesh::Vertex_index> result;
  for (const std::size_t index : indices)
    result.push_back(vertex(index));
  return result;
}

// ===  Surfaces

template <class TriangleMesh = Mesh>
TriangleMesh tetrahedron()
{
  return to_mesh<TriangleMesh>(soups::tetrahedron());
}

template <class TriangleMesh = Mesh>
TriangleMesh octahedron()
{
  return to_mesh<TriangleMesh>(soups::octahedron());
}

template <class TriangleMesh = Mesh>
TriangleMesh icosphere(int level)
{
  return to_mesh<TriangleMesh>(soups::icosphere(level));
}

template <class TriangleMesh = Mesh>
TriangleMesh torus(std::size_t m, std::size_t n, double large_radius, double small_radius)
{
  return to_mesh<TriangleMesh>(soups::torus(m, n, large_radius, small_radius));
}

template <class TriangleMesh = Mesh>
TriangleMesh genus_surface(std::size_t genus, std::size_t resolution = 2, std::uint64_t seed = 1)
{
  return to_mesh<TriangleMesh>(soups::genus_surface(genus, resolution, seed));
}

template <class TriangleMesh = Mesh>
TriangleMesh handle_surface(std::size_t genus, std::uint64_t seed = 1)
{
  return to_mesh<TriangleMesh>(soups::handle_surface(genus, seed));
}

// for its tips see soups::limb_tips()
template <class TriangleMesh = Mesh>
TriangleMesh limbed_sphere(std::size_t number_of_limbs, int level)
{
  return to_mesh<TriangleMesh>(soups::limbed_sphere(number_of_limbs, level));
}

// ===  Measures

template <class TriangleMesh>
double mean_edge_length(const TriangleMesh& mesh)
{
  return soups::mean_edge_length(to_soup(mesh));
}

template <class TriangleMesh>
std::size_t genus(const TriangleMesh& mesh)
{
  return soups::genus(to_soup(mesh));
}

// ===  Changes

template <class TriangleMesh>
TriangleMesh midpoint_subdivided(const TriangleMesh& mesh)
{
  return to_mesh<TriangleMesh>(soups::midpoint_subdivided(to_soup(mesh)));
}

// moves every vertex by at most `amplitude` mean edge lengths in each coordinate
template <class TriangleMesh>
TriangleMesh noisy(const TriangleMesh& mesh, double amplitude, std::uint64_t seed)
{
  return to_mesh<TriangleMesh>(soups::noisy(to_soup(mesh), amplitude, seed));
}

template <class TriangleMesh>
TriangleMesh with_handles(const TriangleMesh& mesh, std::size_t count, std::uint64_t seed)
{
  return to_mesh<TriangleMesh>(soups::with_handles(to_soup(mesh), count, seed));
}

// for each vertex its position in the result of `relabeled(mesh, seed)`
inline std::vector<std::size_t> new_labels(std::size_t number_of_vertices, std::uint64_t seed)
{
  return Random(seed).permutation(number_of_vertices);
}

// the same mesh with vertices and faces in a random order
template <class TriangleMesh>
TriangleMesh relabeled(const TriangleMesh& mesh, std::uint64_t seed)
{
  const Triangle_soup soup = to_soup(mesh);
  const std::vector<std::size_t> labels = new_labels(soup.points.size(), seed);
  return to_mesh<TriangleMesh>(soups::relabeled(soup, labels, seed + 1));
}

// whether the edge of `h` can be flipped so that the mesh stays a simplicial complex without
// degenerate faces
inline bool is_flippable(Mesh::Halfedge_index h, const Mesh& mesh)
{
  const Mesh::Halfedge_index o = opposite(h, mesh);
  const Mesh::Vertex_index a = source(h, mesh);
  const Mesh::Vertex_index b = target(h, mesh);
  const Mesh::Vertex_index c = target(next(h, mesh), mesh);
  const Mesh::Vertex_index d = target(next(o, mesh), mesh);
  return c != d && !halfedge(c, d, mesh).second &&
         !CGAL::collinear(mesh.point(a), mesh.point(c), mesh.point(d)) &&
         !CGAL::collinear(mesh.point(b), mesh.point(c), mesh.point(d));
}

// tries to flip as many random edges as `fraction` says; only the connectivity is looked after, not
// the shape
template <class TriangleMesh>
TriangleMesh flip_random_edges(const TriangleMesh& mesh, double fraction, std::uint64_t seed)
{
  Mesh flipped = to_mesh(to_soup(mesh));
  Random random(seed);
  const std::size_t number_of_edges = num_edges(flipped);
  const auto attempts = static_cast<std::size_t>(fraction * static_cast<double>(number_of_edges));
  for (std::size_t i = 0; i < attempts; ++i)
  {
    const Mesh::Edge_index edge(static_cast<Mesh::size_type>(random.index(number_of_edges)));
    if (is_flippable(halfedge(edge, flipped), flipped))
      CGAL::Euler::flip_edge(halfedge(edge, flipped), flipped);
  }
  return to_mesh<TriangleMesh>(to_soup(flipped));
}

// ===  Files

// the OFF files of a folder, in alphabetical order; none if the name of the folder is empty
inline std::vector<std::string> all_shared_meshes(const std::string& folder)
{
  std::vector<std::string> file_names;
  if (folder.empty())
    return file_names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".off")
      file_names.push_back(entry.path().string());
  std::sort(file_names.begin(), file_names.end());
  return file_names;
}

} // namespace smf_test

#endif // SMF_GENERATORS_MESHES_H
