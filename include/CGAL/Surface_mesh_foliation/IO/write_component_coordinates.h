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
#include <CGAL/Surface_mesh_foliation/internal/IO/write_file.h>

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

// Texture vertices of OBJ, from 1: one per vertex of a component, two on the seam, and one per
// corner at a pole. Indexed by the halfedge that leaves a corner; 0 in faces without coordinates.
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
        m_arcs.push_back(static_cast<std::size_t>(nodes.arc(h)));
        of_place[place] = static_cast<int>(m_coordinates.size());
      }
      m_of_corner.back() = of_place[place];
    }
  }

  const std::vector<std::array<double, 2>>& coordinates() const { return m_coordinates; }
  int of_corner(int h) const { return m_of_corner[h]; }
  // the vertex of the mesh that the i-th of them, from 0, lies at
  int vertex(std::size_t i) const { return m_vertices[i]; }
  // its component
  std::size_t arc(std::size_t i) const { return m_arcs[i]; }

private:
  std::vector<std::array<double, 2>> m_coordinates;
  std::vector<int> m_vertices;
  std::vector<std::size_t> m_arcs;
  std::vector<int> m_of_corner;
};

// of the i-th texture vertex, from 0
template <class TriangleMesh>
std::array<double, 2> texture_uv(const Component_coordinates<TriangleMesh>& coordinates,
                                 const Texture_vertices& vertices,
                                 std::size_t i)
{
  return coordinates.texture_chart(vertices.arc(i))(vertices.coordinates()[i]);
}

// the faces of each component, and last those in none; without caps
inline std::vector<std::vector<int>> faces_by_component(const Corner_nodes& nodes,
                                                        std::size_t number_of_components)
{
  std::vector<std::vector<int>> result(number_of_components + 1);
  for (int f = 0; f < nodes.refined().first_cap_face; ++f)
  {
    const int arc = nodes.arc(nodes.mesh().halfedge_of_face(f));
    result[arc < 0 ? number_of_components : static_cast<std::size_t>(arc)].push_back(f);
  }
  return result;
}

inline void write_obj_face(std::ostream& output,
                           const Corner_nodes& nodes,
                           const Texture_vertices& texture_vertices,
                           int f)
{
  output << 'f';
  for (int h : nodes.mesh().halfedges(f))
  {
    output << ' '
           << std::to_string(nodes.refined().number_without_caps(nodes.mesh().source(h)) + 1);
    if (texture_vertices.of_corner(h) > 0)
      output << '/' << std::to_string(texture_vertices.of_corner(h));
  }
  output << '\n';
}

template <class TriangleMesh>
void write_component_coordinates_obj_text(std::ostream& output,
                                          const Component_coordinates<TriangleMesh>& coordinates)
{
  const Component_layout& layout = coordinates.layout();
  for (const Point& p : points_without_caps(layout.nodes().refined()))
    output << 'v' << numbers(p.data(), 3) << '\n';
  const Texture_vertices texture_vertices(layout);
  for (std::size_t i = 0; i < texture_vertices.coordinates().size(); ++i)
    output << "vt" << numbers(texture_uv(coordinates, texture_vertices, i).data(), 2) << '\n';
  const std::size_t n = coordinates.foliation().system().number_of_arcs();
  const std::vector<std::vector<int>> faces = faces_by_component(layout.nodes(), n);
  for (std::size_t a = 0; a <= n; ++a)
  {
    if (faces[a].empty())
      continue;
    output << (a == n ? "g none" : "g component_" + std::to_string(a)) << '\n';
    for (int f : faces[a])
      write_obj_face(output, layout.nodes(), texture_vertices, f);
  }
}

template <class TriangleMesh>
void write_component_coordinates_ply_text(std::ostream& output,
                                          const Component_coordinates<TriangleMesh>& coordinates)
{
  const Corner_nodes& nodes = coordinates.layout().nodes();
  const Flat_mesh& mesh = nodes.mesh();
  const Refined_mesh& refined = nodes.refined();
  const std::vector<Point> points = points_without_caps(refined);
  output << "ply\nformat ascii 1.0\n";
  for (std::size_t a = 0; a < coordinates.foliation().system().number_of_arcs(); ++a)
  {
    const Component_shape shape = component_shape(coordinates.foliation(), a);
    const Texture_chart chart = coordinates.texture_chart(a);
    output << "comment component " << std::to_string(a) << " height" << numbers(&shape.height, 1)
           << " circumference" << numbers(&shape.circumference, 1) << " origin"
           << numbers(chart.origin.data(), 2) << " scale" << numbers(chart.scale.data(), 2) << '\n';
  }
  output << "element vertex " << std::to_string(points.size())
         << "\nproperty double x\nproperty double y\nproperty double z\nelement face "
         << std::to_string(refined.first_cap_face)
         << "\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n"
            "property int component\nend_header\n";
  for (const Point& p : points)
    output << numbers(p.data(), 3).substr(1) << '\n';
  for (int f = 0; f < refined.first_cap_face; ++f)
  {
    const int arc = nodes.arc(mesh.halfedge_of_face(f));
    std::string vertices = "3", uvs = " 6";
    for (int h : mesh.halfedges(f))
    {
      vertices += ' ' + std::to_string(refined.number_without_caps(mesh.source(h)));
      uvs += arc < 0 ? " 0 0" : numbers(coordinates.texture_uv(h).data(), 2);
    }
    output << vertices << uvs << ' ' << std::to_string(arc) << '\n';
  }
}

// a point per texture vertex, and per corner of a face without coordinates
template <class TriangleMesh>
Vtp_document document_of_coordinates(const Component_coordinates<TriangleMesh>& coordinates)
{
  const Component_layout& layout = coordinates.layout();
  const Flat_mesh& mesh = layout.nodes().mesh();
  const Texture_vertices texture_vertices(layout);
  Vtp_document result;
  std::vector<double> u, v, texture_u, texture_v;
  std::vector<int> component;
  const auto add = [&](int vertex, const std::array<double, 2>& uv,
                       const std::array<double, 2>& texture) {
    result.add_point(mesh.point(vertex));
    u.push_back(uv[0]);
    v.push_back(uv[1]);
    texture_u.push_back(texture[0]);
    texture_v.push_back(texture[1]);
    return result.number_of_points() - 1;
  };
  for (std::size_t i = 0; i < texture_vertices.coordinates().size(); ++i)
    add(texture_vertices.vertex(i), texture_vertices.coordinates()[i],
        texture_uv(coordinates, texture_vertices, i));
  for (int f = 0; f < layout.nodes().refined().first_cap_face; ++f)
  {
    std::vector<std::size_t> polygon;
    for (int h : mesh.halfedges(f))
      polygon.push_back(texture_vertices.of_corner(h) > 0
                          ? static_cast<std::size_t>(texture_vertices.of_corner(h) - 1)
                          : add(mesh.source(h), {0, 0}, {0, 0}));
    result.add_polygon(polygon);
    component.push_back(layout.nodes().arc(mesh.halfedge_of_face(f)));
  }
  result.add_point_array("u", u);
  result.add_point_array("v", v);
  result.add_point_array("texture_u", texture_u);
  result.add_point_array("texture_v", texture_v);
  result.add_cell_array("component", component);
  return result;
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationIO

writes the mesh cut into its surface components in OBJ, with the texture coordinates of corners (see
`Component_coordinates`) as texture vertices `vt`: those of one vertex differ between the two sides
of a seam or a critical leaf. The faces are sorted by component, and otherwise in the order of
`surface_components()`: those of component \f$a\f$ are the group `component_a`. Faces that lie
entirely at a node have no texture vertices; they come last, in the group `none`, if there are any.

\param file_name the name of the file
\param coordinates the coordinates

\throws Invalid_file_exception if the file cannot be written
*/
template <class TriangleMesh>
void write_component_coordinates_obj(const std::string& file_name,
                                     const Component_coordinates<TriangleMesh>& coordinates)
{
  internal::write_file(file_name, [&](std::ostream& output) {
    internal::write_component_coordinates_obj_text(output, coordinates);
  });
}

/*!
\ingroup PkgSurfaceMeshFoliationIO

writes the mesh cut into its surface components in ASCII PLY, with the face properties `texcoord`, a
list of two texture coordinates (see `Component_coordinates`) for each corner, as MeshLab reads it,
and `component`, the arc. Comments give the height and circumference of each component, and the
origin and scale of its `Texture_chart`, from which \f$u\f$ and \f$v\f$ can be recovered. In faces
that lie entirely at a node, `component` is -1 and `texcoord` is zero.

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
`u` and `v`, in units of the foliation, `texture_u` and `texture_v`, the texture coordinates, and
the cell array `component`. A vertex where coordinates jump, at a seam or on a critical leaf,
becomes one point for each side, and a pole becomes one for each face. In faces that lie entirely at
a node, `component` is -1 and the coordinates are zero.

\param file_name the name of the file
\param coordinates the coordinates

\throws Invalid_file_exception if the file cannot be written
*/
template <class TriangleMesh>
void write_component_coordinates_vtp(const std::string& file_name,
                                     const Component_coordinates<TriangleMesh>& coordinates)
{
  internal::write_vtp(file_name, internal::document_of_coordinates(coordinates));
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_IO_WRITE_COMPONENT_COORDINATES_H
