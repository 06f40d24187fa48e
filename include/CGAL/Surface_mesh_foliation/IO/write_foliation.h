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
#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/Kept_soup.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/text_output.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/write_file.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/Refined_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/component_labels.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/build_triangle_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/soup_of_flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/leaves.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_embedding.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

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

// Tells which faces of the input mesh are written: all but those that filled its openings.
template <class TriangleMesh, class NamedParameters>
auto is_written(const Measured_foliation<TriangleMesh>& foliation, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  check_parameters<internal_np::filled_face_map_t>(np);
  const auto filled = choose_parameter(get_parameter(np, internal_np::filled_face_map),
                                       CGAL::Constant_property_map<face_descriptor, bool>(false));
  const auto& mesh_index = foliation.system().data().mesh_index;
  return [filled, &mesh_index](int f) { return !get(filled, mesh_index.face(f)); };
}

// what is written of the cut mesh
template <class TriangleMesh, class NamedParameters>
Kept_soup kept_components(const Measured_foliation<TriangleMesh>& foliation,
                          const NamedParameters& np)
{
  const Refined_mesh& refined = foliation.extraction().refined_mesh;
  const auto is_kept = is_written(foliation, np);
  return Kept_soup(soup_of(refined), [&](int f) { return is_kept(refined.faces[f].origin); });
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationIO

writes the mesh cut into its surface components in PLY, with the face properties `component` (the
arc) and a color per component, `arc_color()`.

\param file_name the name of the file
\param foliation the foliation
\param np an optional sequence of named parameters: `filled_face_map`, a readable property map of
  `fill_openings()`; faces for which it is `true` are not written, nor vertices that only these use

\throws Invalid_file_exception if the file cannot be written
*/
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
void write_components_ply(const std::string& file_name,
                          const Measured_foliation<TriangleMesh>& foliation,
                          const NamedParameters& np = CGAL::parameters::default_values())
{
  using Mesh = CGAL::Surface_mesh<typename Loop_system<TriangleMesh>::Point>;
  Mesh mesh;
  const auto component =
    mesh.template add_property_map<typename Mesh::Face_index, int>("f:component").first;
  const auto color =
    mesh.template add_property_map<typename Mesh::Face_index, CGAL::IO::Color>("f:color").first;
  const internal::Kept_soup kept = internal::kept_components(foliation, np);
  const std::vector<int> label = internal::component_labels(foliation.extraction().refined_mesh,
                                                            foliation.extraction().leaf_graph);
  const auto new_faces = internal::build_triangle_mesh(kept.soup, mesh, mesh.points());
  for (std::size_t f = 0; f < new_faces.size(); ++f)
  {
    put(component, new_faces[f], label[kept.faces[f]]);
    put(color, new_faces[f], arc_color(static_cast<std::size_t>(label[kept.faces[f]])));
  }
  internal::write_mesh_ply(file_name, mesh);
}

/*!
\ingroup PkgSurfaceMeshFoliationIO

writes the input mesh in PLY, its vertices and faces in their original order, with the vertex
properties `arc` (-1 at a node) and `t`.

\param file_name the name of the file
\param foliation the foliation
\param np an optional sequence of named parameters: `filled_face_map`, a readable property map of
  `fill_openings()`; faces for which it is `true` are not written, nor vertices that only these use

\throws Invalid_file_exception if the file cannot be written
*/
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
void write_foliation_ply(const std::string& file_name,
                         const Measured_foliation<TriangleMesh>& foliation,
                         const NamedParameters& np = CGAL::parameters::default_values())
{
  using Mesh = CGAL::Surface_mesh<typename Loop_system<TriangleMesh>::Point>;
  using Vertex = typename Mesh::Vertex_index;
  Mesh mesh;
  const internal::Kept_soup kept(internal::soup_of(foliation.state().mesh()),
                                 internal::is_written(foliation, np));
  internal::build_triangle_mesh(kept.soup, mesh, mesh.points());
  const auto arc = mesh.template add_property_map<Vertex, int>("v:arc", -1).first;
  const auto t = mesh.template add_property_map<Vertex, double>("v:t", 0).first;
  auto i = kept.vertices.begin(); // a new mesh has its vertices in the order of their creation
  for (const Vertex v : vertices(mesh))
  {
    if (!foliation.state().is_at_node(*i))
    {
      put(arc, v, foliation.state().arc(*i));
      put(t, v, foliation.state().parameter(*i));
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
