// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_CHECKED_FLAT_MESH_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_CHECKED_FLAT_MESH_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/soup_problems.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Mesh_index.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Checks a mesh as documented for `Loop_system`, and returns what is wrong; if nothing is, `flat`
// is the mesh as arrays, with the halfedges numbered as in `mesh_index`. `np` may have a
// `vertex_point_map`.
template <class TriangleMesh, class NamedParameters>
std::vector<Problem> build_flat_mesh(const NamedParameters& np,
                                     Mesh_index<TriangleMesh>& mesh_index,
                                     Flat_mesh& flat)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto vertex_point_map =
    choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                     get_const_property_map(CGAL::vertex_point, mesh_index.mesh()));
  std::vector<Problem> problems;
  const Triangle_soup soup = mesh_index.soup(vertex_point_map, problems);
  if (problems.empty())
    problems = soup_problems(soup);
  if (!problems.empty())
    return problems;
  std::vector<Triangle> triangles;
  triangles.reserve(soup.triangles.size());
  for (const auto& t : soup.triangles)
    triangles.push_back({static_cast<int>(t[0]), static_cast<int>(t[1]), static_cast<int>(t[2])});
  flat = Flat_mesh(soup.points, triangles);
  mesh_index.number_halfedges(flat);
  return problems;
}

// A mesh that has been checked in this way, as arrays; throws an exception for the first problem.
template <class TriangleMesh>
struct Checked_mesh
{
  template <class NamedParameters>
  Checked_mesh(const TriangleMesh& mesh, const NamedParameters& np) : index(mesh)
  {
    const std::vector<Problem> problems = build_flat_mesh(np, index, flat);
    if (!problems.empty())
      throw Invalid_mesh_exception(problems[0]);
  }

  Mesh_index<TriangleMesh> index;
  Flat_mesh flat;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_CHECKED_FLAT_MESH_H
