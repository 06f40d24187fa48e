// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_IO_WRITE_COMPONENT_COORDINATES_H
#define CGAL_SURFACE_MESH_FOLIATION_IO_WRITE_COMPONENT_COORDINATES_H

#include <CGAL/Surface_mesh_foliation/Component_coordinates.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/Vtp_document.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/text_output.h>

#include <array>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

namespace internal {

inline std::string numbers(const double* first, std::size_t n)
{
  std::string result;
  for (std::size_t i = 0; i < n; ++i)
  {
    result += ' ';
    append_number(result, first[i]);
  }
  return result;
}

// Texture vertices of OBJ, from 1: one per vertex of a component, and on the seam two; at a pole
// one per corner. By halfedge that leaves a corner; 0 in faces without coordinates.
class Texture_vertices
{
public:
  explicit Texture_vertices(const Component_layout& layout)
  {
    const Corner_nodes& nodes = layout.nodes();
    std::vector<int> of_place(layout.seams().number_of_places(), 0);
    for (int h = 0; h < nodes.mesh().number_of_halfedges(); ++h)
    {
      m_of_corner.push_back(0);
      if (nodes.arc(h) < 0)
        continue;
      const int place =
        Component_seams::place(nodes.node_of_source(h), layout.seams().is_source_left(h));
      const bool is_known = !nodes.is_pole(nodes.mesh().source(h)) && of_place[place] > 0;
      if (!is_known)
      {
        m_coordinates.push_back(layout.corner(h));
        m_vertices.push_back(nodes.mesh().source(h));
        of_place[place] = static_cast<int>(m_coordinates.size());
      }
      m_of_corner.back() = of_place[place];
    }
  }

  const std::vector<std::array<double, 2>>& coordinates() const { return m_coordinates; }
  int of_corner(int h) const { return m_of_corner[h]; }
  // the vertex of the mesh that the i-th of them, from 0, lies at
  int vertex(std::size_t i) const { return m_vertices[i]; }

private:
  std::vector<std::array<double, 2>> m_coordinates;
  std::vector<int> m_vertices;
  std::vector<int> m_of_corner;
};

inline void write_component_coordinates_obj_text(std::ostream& output,
                                                 const Component_layout& layout)
{
  const Flat_mesh& mesh = layout.nodes().mesh();
  for (const Point& p : mesh.points())
    output << 'v' << numbers(p.data(), 3) << '\n';
  const Texture_vertices texture_vertices(layout);
  for (const std::array<double, 2>& uv : texture_vertices.coordinates())
    output << "vt" << numbers(uv.data(), 2) << '\n';
  int component = Refined_mesh::NONE - 1;
  for (int f = 0; f < mesh.number_of_faces(); ++f)
  {
    const std::array<int, 3> halfedges = mesh.halfedges(f);
    if (const int arc = layout.nodes().arc(halfedges[0]); arc != component)
    {
      component = arc;
      output << (arc < 0 ? "g none" : "g component_" + std::to_string(arc)) << '\n';
    }
    output << 'f';
    for (int h : halfedges)
    {
      output << ' ' << std::to_string(mesh.source(h) + 1);
      if (texture_vertices.of_corner(h) > 0)
        output << '/' << std::to_string(texture_vertices.of_corner(h));
    }
    output << '\n';
  }
}

template <class TriangleMesh>
void write_component_coordinates_ply_text(std::ostream& output,
                                          const Component_coordinates<TriangleMesh>& coordinates)
{
  const Corner_nodes& nodes = coordinates.layout().nodes();
  const Flat_mesh& mesh = nodes.mesh();
  output << "ply\nformat ascii 1.0\n";
  for (std::size_t a = 0; a < coordinates.foliation().system().number_of_arcs(); ++a)
  {
    const Component_shape shape = component_shape(coordinates.foliation(), a);
    output << "comment component " << std::to_string(a) << " height" << numbers(&shape.height, 1)
           << " circumference" << numbers(&shape.circumference, 1) << '\n';
  }
  output << "element vertex " << std::to_string(mesh.number_of_vertices())
         << "\nproperty double x\nproperty double y\nproperty double z\nelement face "
         << std::to_string(mesh.number_of_faces())
         << "\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n"
            "property int component\nend_header\n";
  for (const Point& p : mesh.points())
    output << numbers(p.data(), 3).substr(1) << '\n';
  for (int f = 0; f < mesh.number_of_faces(); ++f)
  {
    const int arc = nodes.arc(mesh.halfedge_of_face(f));
    std::string vertices = "3", uvs = " 6";
    for (int h : mesh.halfedges(f))
    {
      vertices += ' ' + std::to_string(mesh.source(h));
      uvs += arc < 0 ? " 0 0" : numbers(coordinates.uv(h).data(), 2);
    }
    output << vertices << uvs << ' ' << std::to_string(arc) << '\n';
  }
}

// a point per texture vertex, and per corner of a face without coordinates
inline Vtp_document document_of_coordinates(const Component_layout& layout)
{
  const Flat_mesh& mesh = layout.nodes().mesh();
  const Texture_vertices texture_vertices(layout);
  Vtp_document result;
  std::vector<double> u, v;
  std::vector<int> component;
  const auto add = [&](int vertex, const std::array<double, 2>& uv) {
    result.add_point(mesh.point(vertex));
    u.push_back(uv[0]);
    v.push_back(uv[1]);
    return result.number_of_points() - 1;
  };
  for (std::size_t i = 0; i < texture_vertices.coordinates().size(); ++i)
    add(texture_vertices.vertex(i), texture_vertices.coordinates()[i]);
  for (int f = 0; f < mesh.number_of_faces(); ++f)
  {
    std::vector<std::size_t> polygon;
    for (int h : mesh.halfedges(f))
      polygon.push_back(texture_vertices.of_corner(h) > 0
                          ? static_cast<std::size_t>(texture_vertices.of_corner(h) - 1)
                          : add(mesh.source(h), {0, 0}));
    result.add_polygon(polygon);
    component.push_back(layout.nodes().arc(mesh.halfedge_of_face(f)));
  }
  result.add_point_array("u", u);
  result.add_point_array("v", v);
  result.add_cell_array("component", component);
  return result;
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationIO

writes the mesh cut into its surface components in OBJ, with the coordinates \f$u\f$ and \f$v\f$ of
corners as texture vertices `vt`: those of one vertex are different on both sides of a seam or a
critical leaf. The faces of component \f$a\f$ are in the group `component_a`; those that lie at a
node as a whole, in the group `none`, have no texture vertices.

Coordinates are not scaled to the unit square: a checkerboard of side 1 shows squares of side 1 in
the metric of the foliation.

\param file_name the name of the file
\param coordinates the coordinates

\throws Invalid_file_exception if the file cannot be written
*/
template <class TriangleMesh>
void write_component_coordinates_obj(const std::string& file_name,
                                     const Component_coordinates<TriangleMesh>& coordinates)
{
  internal::write_file(file_name, [&](std::ostream& output) {
    internal::write_component_coordinates_obj_text(output, coordinates.layout());
  });
}

/*!
\ingroup PkgSurfaceMeshFoliationIO

writes the mesh cut into its surface components in ASCII PLY, with the face properties `texcoord`, a
list of \f$u\f$ and \f$v\f$ for each corner, as MeshLab reads it, and `component`, the arc.
Comments tell height and circumference of each component. In faces that lie at a node as a whole,
`component` is -1 and `texcoord` zero.

\param file_name the name of the file
\param coordinates the coordinates

\throws Invalid_file_exception if the file cannot be written
*/
template <class TriangleMesh>
void write_component_coordinates_ply(const std::string& file_name,
                                     const Component_coordinates<TriangleMesh>& coordinates)
{
  internal::write_file(file_name, [&](std::ostream& output) {
    internal::write_component_coordinates_ply_text(output, coordinates);
  });
}

/*!
\ingroup PkgSurfaceMeshFoliationIO

writes the mesh cut into its surface components in VTK's XML format (.vtp), with the point arrays
`u` and `v` and the cell array `component`. A vertex where coordinates jump, at a seam or on a
critical leaf, is a point on each side, and a pole one for each face. In faces that lie at a node as
a whole, `component` is -1 and the coordinates are zero.

\param file_name the name of the file
\param coordinates the coordinates

\throws Invalid_file_exception if the file cannot be written
*/
template <class TriangleMesh>
void write_component_coordinates_vtp(const std::string& file_name,
                                     const Component_coordinates<TriangleMesh>& coordinates)
{
  const internal::Vtp_document document = internal::document_of_coordinates(coordinates.layout());
  internal::write_file(file_name, [&](std::ostream& output) { document.write(output); });
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_IO_WRITE_COMPONENT_COORDINATES_H
