// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_IO_WRITE_FOLIATION_H
#define CGAL_SURFACE_MESH_FOLIATION_IO_WRITE_FOLIATION_H

#include <CGAL/Surface_mesh_foliation/IO/arc_color.h>
#include <CGAL/Surface_mesh_foliation/IO/write_polylines.h>
#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>
#include <CGAL/Surface_mesh_foliation/components.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/text_output.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/soup_of_flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/leaves.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_embedding.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

namespace internal {

template <class Point>
void write_mesh_ply(const std::string& file_name, const CGAL::Surface_mesh<Point>& mesh)
{
  write_file(file_name, [&](std::ostream& output) {
    output.precision(number_of_digits);
    if (!CGAL::IO::write_PLY(output, mesh))
      throw_file_problem(file_name, ": cannot be written");
  });
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationIO

writes the mesh cut into its surface components in PLY, with the face properties `component` (the
arc) and a color per component, `arc_color()`.

\param file_name the name of the file
\param foliation the foliation

\throws Invalid_file_exception if the file cannot be written
*/
template <class TriangleMesh>
void write_components_ply(const std::string& file_name,
                          const Measured_foliation<TriangleMesh>& foliation)
{
  using Mesh = CGAL::Surface_mesh<typename Loop_system<TriangleMesh>::Point>;
  Mesh mesh;
  const auto component =
    mesh.template add_property_map<typename Mesh::Face_index, int>("f:component").first;
  const auto color =
    mesh.template add_property_map<typename Mesh::Face_index, CGAL::IO::Color>("f:color").first;
  surface_components(foliation, mesh, parameters::face_component_map(component));
  for (const auto f : faces(mesh))
    put(color, f, arc_color(static_cast<std::size_t>(get(component, f))));
  internal::write_mesh_ply(file_name, mesh);
}

/*!
\ingroup PkgSurfaceMeshFoliationIO

writes the input mesh in PLY, its vertices and faces in their original order, with the vertex
properties `arc` (-1 at a node) and `t`.

\param file_name the name of the file
\param foliation the foliation

\throws Invalid_file_exception if the file cannot be written
*/
template <class TriangleMesh>
void write_foliation_ply(const std::string& file_name,
                         const Measured_foliation<TriangleMesh>& foliation)
{
  using Mesh = CGAL::Surface_mesh<typename Loop_system<TriangleMesh>::Point>;
  using Vertex = typename Mesh::Vertex_index;
  Mesh mesh;
  internal::build_triangle_mesh(internal::soup_of(foliation.state().mesh()), mesh, mesh.points());
  const auto arc = mesh.template add_property_map<Vertex, int>("v:arc", -1).first;
  const auto t = mesh.template add_property_map<Vertex, double>("v:t", 0).first;
  int i = 0; // a new mesh has its vertices in the order of their creation
  for (const Vertex v : vertices(mesh))
  {
    if (!foliation.state().is_at_node(i))
    {
      put(arc, v, foliation.state().arc(i));
      put(t, v, foliation.state().parameter(i));
    }
    ++i;
  }
  internal::write_mesh_ply(file_name, mesh);
}

/*!
\ingroup PkgSurfaceMeshFoliationIO

writes leaves in PLY, as polylines: the critical leaves, with the edge properties `arc` = -1 and
`node`, and some regular leaves of each arc, with `arc` and `node` = -1.

\param file_name the name of the file
\param foliation the foliation
\param embedding the embedding whose sampled levels are the regular leaves that are written

\throws Invalid_file_exception if the file cannot be written

The time is linear in the sizes of the mesh and of the regular leaves.
*/
template <class TriangleMesh>
void write_leaves_ply(
  const std::string& file_name,
  const Measured_foliation<TriangleMesh>& foliation,
  const Reeb_graph_embedding<typename Loop_system<TriangleMesh>::Point>& embedding)
{
  const auto leaves = internal::all_leaves(foliation, embedding.levels);
  std::vector<std::vector<typename Loop_system<TriangleMesh>::Point>> polylines;
  for (const auto& leaf : leaves)
    polylines.push_back(leaf.points);
  write_polylines_ply(
    file_name, polylines, {},
    {int_property("arc", [&](std::size_t i, std::size_t) { return leaves[i].arc; }),
     int_property("node", [&](std::size_t i, std::size_t) { return leaves[i].node; })});
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_IO_WRITE_FOLIATION_H
