// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_CHECKED_FLAT_MESH_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_CHECKED_FLAT_MESH_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/soup_element_checks.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/soup_problems.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Mesh_index.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Pole.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/openings.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// A mesh as arrays, closed by a cap on each opening.
struct Capped_mesh
{
  Flat_mesh mesh;
  std::vector<Border> openings; // opening i has the i-th cap
  Problems border_problems;     // what is wrong if no opening is allowed

  // the opening as a pole
  Pole cap(int opening) const
  {
    std::vector<int> vertices = {mesh.number_of_input_vertices() + opening};
    vertices.insert(vertices.end(), openings[opening].begin(), openings[opening].end());
    return Pole(std::move(vertices), true);
  }
};

// Precondition: there are not more faces than find_excess() allows.
inline std::vector<Triangle> int_triangles(const Triangle_soup& soup)
{
  std::vector<Triangle> result;
  result.reserve(soup.triangles.size());
  for (const auto& t : soup.triangles)
    result.push_back({static_cast<int>(t[0]), static_cast<int>(t[1]), static_cast<int>(t[2])});
  return result;
}

// The mesh of a soup in which nothing is wrong and nothing open, as most are; then `soup` loses its
// points. Otherwise soup_problems() tells, in several times as much time, what it is.
inline std::optional<Flat_mesh> closed_flat_mesh(Triangle_soup& soup)
{
  if (find_emptiness(soup) || find_excess(soup.triangles.size()) ||
      find_infinite_coordinate(soup) || find_repeated_vertex_in_face(soup) ||
      find_degenerate_face(soup))
    return std::nullopt;
  return Flat_mesh::of_closed_surface(soup.points, int_triangles(soup));
}

// Checks a mesh as documented for `Loop_system`, but for openings, and returns what is wrong; if
// nothing is, `capped` is the mesh as arrays, with the vertices and faces numbered as in
// `mesh_index`. `np` may have a `vertex_point_map`.
template <class TriangleMesh, class NamedParameters>
std::vector<Problem> build_flat_mesh(const NamedParameters& np,
                                     const Mesh_index<TriangleMesh>& mesh_index,
                                     Capped_mesh& capped)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto vertex_point_map =
    choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                     get_const_property_map(CGAL::vertex_point, mesh_index.mesh()));
  std::vector<Problem> problems;
  Triangle_soup soup = mesh_index.soup(vertex_point_map, problems);
  if (problems.empty())
    if (auto mesh = closed_flat_mesh(soup))
    {
      capped.mesh = std::move(*mesh);
      return {};
    }
  if (problems.empty())
    problems = soup_problems(soup);
  const bool has_openings = problems.size() == 1 && problems[0].kind == Problem_kind::NOT_CLOSED;
  if (has_openings)
    capped.border_problems = std::move(problems);
  else if (!problems.empty())
    return problems;
  std::vector<Triangle> triangles = int_triangles(soup);
  const int number_of_input_faces = static_cast<int>(triangles.size());
  if (has_openings)
  {
    capped.openings = find_openings(soup);
    add_caps(capped.openings, soup.points, triangles);
    if (const auto excess = find_excess(triangles.size()))
      return {*excess};
  }
  capped.mesh = Flat_mesh(std::move(soup.points), triangles,
                          static_cast<int>(capped.openings.size()), number_of_input_faces);
  return {};
}

// A mesh that has been checked in this way, as arrays; throws an exception for the first problem.
template <class TriangleMesh>
struct Checked_mesh
{
  template <class NamedParameters>
  Checked_mesh(const TriangleMesh& mesh, const NamedParameters& np) : Checked_mesh(np, mesh)
  {
    index.number_halfedges(flat);
  }

  // for those who do not ask for halfedges, whose numbers take a quarter of the time
  template <class NamedParameters>
  static Checked_mesh without_halfedges(const TriangleMesh& mesh, const NamedParameters& np)
  {
    return Checked_mesh(np, mesh);
  }

  // for those who need a closed mesh
  void require_no_opening() const
  {
    if (!capped.openings.empty())
      throw Invalid_mesh_exception(capped.border_problems[0]);
  }

  Checked_mesh(const Checked_mesh&) = delete;
  Checked_mesh& operator=(const Checked_mesh&) = delete;

  Mesh_index<TriangleMesh> index;
  Capped_mesh capped;
  const Flat_mesh& flat = capped.mesh;

private:
  template <class NamedParameters>
  Checked_mesh(const NamedParameters& np, const TriangleMesh& mesh) : index(mesh)
  {
    std::vector<Problem> problems = build_flat_mesh(np, index, capped);
    if (!problems.empty())
      throw Invalid_mesh_exception(problems[0]);
  }
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_CHECKED_FLAT_MESH_H
