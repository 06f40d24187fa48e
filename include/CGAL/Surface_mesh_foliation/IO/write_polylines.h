// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_IO_WRITE_POLYLINES_H
#define CGAL_SURFACE_MESH_FOLIATION_IO_WRITE_POLYLINES_H

#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/text_output.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/write_file.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <functional>
#include <iterator>
#include <ostream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationIO

describes a number that `write_polylines_ply()` writes with each vertex or each edge.
*/
struct Polyline_property
{
  /// is called as `f(i, j)` for vertex or edge `j` of polyline `i`; edge `j` follows vertex `j`.
  template <class Number>
  using Function = std::function<Number(std::size_t, std::size_t)>;

  std::string name;                                    ///< one word
  std::variant<Function<double>, Function<int>> value; ///< the numbers
};

/*!
\ingroup PkgSurfaceMeshFoliationIO

returns a property of type `double` (not `int`, even if `function` returns integers).
\param name the name of the property, one word
\param function is called as `function(i, j)` for vertex or edge `j` of polyline `i`
*/
inline Polyline_property double_property(std::string name,
                                         Polyline_property::Function<double> function)
{
  return {std::move(name), std::move(function)};
}

/*!
\ingroup PkgSurfaceMeshFoliationIO

returns a property of type `int`.
\param name the name of the property, one word
\param function is called as `function(i, j)` for vertex or edge `j` of polyline `i`
*/
inline Polyline_property int_property(std::string name, Polyline_property::Function<int> function)
{
  return {std::move(name), std::move(function)};
}

namespace internal {

// There is no edge after the last vertex of a polyline, and none in a polyline without vertices.
inline std::size_t number_of_polyline_edges(std::size_t number_of_vertices)
{
  return number_of_vertices == 0 ? 0 : number_of_vertices - 1;
}

template <class Polyline>
std::size_t number_of_polyline_vertices(const Polyline& polyline)
{
  return static_cast<std::size_t>(std::distance(std::begin(polyline), std::end(polyline)));
}

inline void append_property_declarations(std::string& text,
                                         const std::vector<Polyline_property>& properties)
{
  for (const Polyline_property& property : properties)
  {
    const bool is_double = property.value.index() == 0;
    text += std::string("property ") + (is_double ? "double " : "int ") + property.name + "\n";
  }
}

inline void append_property_values(std::string& text,
                                   const std::vector<Polyline_property>& properties,
                                   std::size_t polyline,
                                   std::size_t position)
{
  for (const Polyline_property& property : properties)
  {
    text += ' ';
    if (const auto* function = std::get_if<Polyline_property::Function<double>>(&property.value))
      append_number(text, (*function)(polyline, position));
    else
      text += std::to_string(
        std::get<Polyline_property::Function<int>>(property.value)(polyline, position));
  }
}

template <class PolylineRange>
std::string polylines_ply_header(const PolylineRange& polylines,
                                 const std::vector<Polyline_property>& vertex_properties,
                                 const std::vector<Polyline_property>& edge_properties)
{
  std::size_t number_of_vertices = 0;
  std::size_t number_of_edges = 0;
  for (const auto& polyline : polylines)
  {
    number_of_vertices += number_of_polyline_vertices(polyline);
    number_of_edges += number_of_polyline_edges(number_of_polyline_vertices(polyline));
  }
  std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(number_of_vertices) +
                     "\nproperty double x\nproperty double y\nproperty double z\n";
  append_property_declarations(text, vertex_properties);
  text += "element edge " + std::to_string(number_of_edges) +
          "\nproperty int vertex1\nproperty int vertex2\n";
  append_property_declarations(text, edge_properties);
  return text + "end_header\n";
}

template <class Polyline>
void write_polyline_vertices(std::ostream& output,
                             const Polyline& polyline,
                             std::size_t polyline_number,
                             const std::vector<Polyline_property>& properties)
{
  std::string text;
  std::size_t position = 0;
  for (const auto& point : polyline)
  {
    append_number(text, CGAL::to_double(point.x()));
    text += ' ';
    append_number(text, CGAL::to_double(point.y()));
    text += ' ';
    append_number(text, CGAL::to_double(point.z()));
    append_property_values(text, properties, polyline_number, position++);
    text += '\n';
  }
  output << text;
}

inline void write_polyline_edges(std::ostream& output,
                                 std::size_t number_of_edges,
                                 std::size_t first_vertex,
                                 std::size_t polyline_number,
                                 const std::vector<Polyline_property>& properties)
{
  std::string text;
  for (std::size_t position = 0; position < number_of_edges; ++position)
  {
    text +=
      std::to_string(first_vertex + position) + ' ' + std::to_string(first_vertex + position + 1);
    append_property_values(text, properties, polyline_number, position);
    text += '\n';
  }
  output << text;
}

template <class PolylineRange>
void write_polylines_ply_text(std::ostream& output,
                              const PolylineRange& polylines,
                              const std::vector<Polyline_property>& vertex_properties,
                              const std::vector<Polyline_property>& edge_properties)
{
  output << polylines_ply_header(polylines, vertex_properties, edge_properties);
  std::size_t polyline_number = 0;
  for (const auto& polyline : polylines)
    write_polyline_vertices(output, polyline, polyline_number++, vertex_properties);

  std::size_t first_vertex = 0;
  polyline_number = 0;
  for (const auto& polyline : polylines)
  {
    const std::size_t number_of_vertices = number_of_polyline_vertices(polyline);
    write_polyline_edges(output, number_of_polyline_edges(number_of_vertices), first_vertex,
                         polyline_number++, edge_properties);
    first_vertex += number_of_vertices;
  }
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationIO

writes polylines in ASCII PLY: their points, with 17 significant digits, as elements `vertex`, and
their segments as elements `edge` with the properties `vertex1` and `vertex2`.

Points and segments come polyline by polyline. A closed polyline repeats its first point at the end.
A polyline of one point gives a vertex without edges.

\tparam PolylineRange a forward range of forward ranges of a point type with members `x()`, `y()`
  and `z()`, such as `Point_3`, whose results `CGAL::to_double()` accepts

\param output the stream to write to
\param polylines the polylines
\param vertex_properties numbers to be written with the vertices
\param edge_properties numbers to be written with the edges

\throws Invalid_file_exception if the stream reports a failure
*/
template <class PolylineRange>
void write_polylines_ply(std::ostream& output,
                         const PolylineRange& polylines,
                         const std::vector<Polyline_property>& vertex_properties = {},
                         const std::vector<Polyline_property>& edge_properties = {})
{
  internal::write_polylines_ply_text(output, polylines, vertex_properties, edge_properties);
  output.flush();
  internal::check_output(output, "the output stream");
}

/*!
\ingroup PkgSurfaceMeshFoliationIO

writes polylines to a PLY file; see the overload that takes a stream.

\param file_name the name of the file; an existing file is overwritten
\param polylines the polylines
\param vertex_properties numbers to be written with the vertices
\param edge_properties numbers to be written with the edges

\throws Invalid_file_exception if the file cannot be written, for example because there is no such
  directory or the disk is full
*/
template <class PolylineRange>
void write_polylines_ply(const std::string& file_name,
                         const PolylineRange& polylines,
                         const std::vector<Polyline_property>& vertex_properties = {},
                         const std::vector<Polyline_property>& edge_properties = {})
{
  internal::write_file(file_name, [&](std::ostream& output) {
    internal::write_polylines_ply_text(output, polylines, vertex_properties, edge_properties);
  });
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_IO_WRITE_POLYLINES_H
