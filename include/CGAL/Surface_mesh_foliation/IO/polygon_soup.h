// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_IO_POLYGON_SOUP_H
#define CGAL_SURFACE_MESH_FOLIATION_IO_POLYGON_SOUP_H

#include <CGAL/Surface_mesh_foliation/internal/Common/compiled.h>
#include <CGAL/Surface_mesh_foliation/IO/Triangle_soup.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/require_parameter.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Polygon_soup.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/face_messages.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/soup_problems.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <istream>
#include <string>
#include <vector>

#if CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES
#include <CGAL/Surface_mesh_foliation/internal/IO/Face_collectors.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/Text_cursor.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/read_obj.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/read_off.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/read_ply.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/read_stl.h>
#endif // CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// in lower case, with its dot; empty if there is none
inline std::string file_extension(const std::string& file_name)
{
  const std::size_t dot = file_name.find_last_of("./\\");
  if (dot == std::string::npos || file_name[dot] != '.')
    return std::string();
  std::string extension = file_name.substr(dot);
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z')
      c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

#if CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES
inline bool is_known_extension(const std::string& extension)
{
  return extension == ".off" || extension == ".obj" || extension == ".ply" || extension == ".stl";
}

// a file, or something else with a name, whose format is that of a known extension
template <class Collector>
typename Collector::Soup read_soup(const std::string& file_name,
                                   const std::string& text,
                                   const std::string& extension)
{
  if (text.empty())
    throw_file_problem(file_name, ": the file is empty");
  if (extension == ".off")
    return read_off<Collector>(file_name, text);
  if (extension == ".obj")
    return read_obj<Collector>(file_name, text);
  if (extension == ".ply")
    return read_ply<Collector>(file_name, text);
  return read_stl<Collector>(file_name, text);
}

template <class Collector>
typename Collector::Soup read_soup(const std::string& file_name)
{
  const std::string extension = file_extension(file_name);
  if (!is_known_extension(extension))
    throw_file_problem(file_name, ": unknown file name extension; known are .off, .obj, .ply and "
                                  ".stl");
  return read_soup<Collector>(file_name, read_whole_file(file_name), extension);
}
#endif // CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES
} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationIO

reads the vertices and faces of a triangle mesh from a file, without checking how they fit together.

The format follows from the extension of the file name, in upper or lower case:
- `.off`: OFF, ASCII or binary (`OFF BINARY`). Counts may be on the same line as the word `OFF`,
  even without a blank; comments, empty lines and colors after a face are skipped; so are normals,
  colors and texture coordinates of vertices, whether or not the header announces them (for example
  by `COFF`). If lines are not records, the file must have coordinates and triangles only.
- `.obj`: Wavefront OBJ; only the statements `v` and `f` are used, and the rest of the standard is
  skipped. A backslash at the end of a line continues it.
- `.ply`: PLY, ASCII or binary, with the element `face`, or, without faces, `tristrips`. A triangle
  of a strip with two equal vertices is no face.
- `.stl`: STL, ASCII or binary; which of the two is decided by the size of the file, not by its
  first word. Normals, colors and names are skipped; several solids are one mesh.

The readers are strict: except as said for OFF, each record has its own line; all numbers must be of
the right type and in range, faces must be triangles with three different vertices, and nothing may
be missing or left over. Vertices and faces keep the order of the file; nothing is renumbered,
repaired or merged. In STL files alone, where each face has coordinates of its own, corners at
exactly equal positions are the same vertex, and vertices are numbered in the order in which they
come first. A byte-order mark of UTF-8, and NUL characters at the ends of lines of text, are
skipped. Memory is allocated for what the file holds, never for what its header claims.

\param file_name the name of the file

\returns the vertices and faces

\throws Invalid_file_exception if the file cannot be read, has an unknown extension, or does not
  follow its format
\throws Invalid_mesh_exception if a face is not a triangle with three different vertices, or a
  coordinate is not finite

The message of an exception is one line of the form `FILE:LINE: what is wrong`, or, for binary
files, `FILE: byte OFFSET: what is wrong`, and names vertices and faces by their position in the
file, from 0.

Time and memory are linear in the size of the file.

\sa `check_triangle_soup()`
\sa `read_triangle_mesh()`
\sa `read_polygon_soup()`
*/
CGAL_SURFACE_MESH_FOLIATION_INLINE Triangle_soup read_triangle_soup(const std::string& file_name);

/*!
\ingroup PkgSurfaceMeshFoliationIO

reads the vertices and faces of a polygon mesh from a file, like `read_triangle_soup()`, but faces
can have any number of corners, equal ones among them.

\param file_name the name of the file

\returns the vertices and faces

\throws Invalid_file_exception if the file cannot be read, has an unknown extension, or does not
  follow its format
\throws Invalid_mesh_exception if a coordinate is not finite

\sa `repair_polygon_soup()`
*/
CGAL_SURFACE_MESH_FOLIATION_INLINE Polygon_soup read_polygon_soup(const std::string& file_name);

/*!
\ingroup PkgSurfaceMeshFoliationIO

reads the vertices and faces of a polygon mesh from a stream, to its end, like `read_polygon_soup()`
from a file.

\param input the stream, in binary mode where there is a difference
\param format `"off"`, `"obj"`, `"ply"` or `"stl"`
\param name what messages call the stream

\returns the vertices and faces

\throws Invalid_file_exception if the stream cannot be read, is empty, or does not follow its format
\throws Invalid_mesh_exception if a coordinate is not finite
\throws Invalid_parameter_exception if the format is none of these
*/
CGAL_SURFACE_MESH_FOLIATION_INLINE Polygon_soup read_polygon_soup(
  std::istream& input, const std::string& format, const std::string& name = "the input");

/*!
\ingroup PkgSurfaceMeshFoliationIO

returns a soup of triangles as such.

\throws Invalid_mesh_exception if a face is not a triangle with three different vertices

The time is linear in the size of the soup.
*/
CGAL_SURFACE_MESH_FOLIATION_INLINE Triangle_soup
polygon_soup_to_triangle_soup(const Polygon_soup& soup);

/*!
\ingroup PkgSurfaceMeshFoliationIO

determines whether a triangle soup is an oriented manifold triangle mesh, closed unless openings are
allowed, and connected unless several parts are allowed, with finite coordinates and without
degenerate faces.

These are rejected:
- a soup without vertices or faces;
- a soup of more than 715,827,882 faces;
- an index that is out of range;
- a coordinate that is not finite;
- a face that uses a vertex twice;
- two faces with the same three vertices, even if their orientations differ;
- an edge with more than two faces;
- an edge with one face, that is, a mesh that is not closed, unless `allow_openings` is `true`;
- faces that are not all oriented consistently, whether or not reversing some would help;
- a vertex whose faces form several umbrellas;
- several connected components, unless `allow_parts` is `true`;
- a vertex that no face uses;
- a face whose corners lie on a line, decided exactly.

An inward orientation, and several vertices at the same position, are accepted.

\param soup the vertices and faces
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
  below

\cgalNamedParamsBegin
  \cgalParamNBegin{allow_openings}
    \cgalParamDescription{whether the mesh may have openings, bounded by edges with one face}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{allow_parts}
    \cgalParamDescription{whether the mesh may have several connected components}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns the first problem of each `Problem_kind`, most important first; nothing if the soup is
  valid. After a problem of the first three items or the fifth, the remaining checks are meaningless
  and are skipped.

The time is \f$O(n \log n)\f$ and the memory \f$O(n)\f$ for \f$n\f$ vertices and faces.

\sa `read_triangle_mesh()`
*/
template <class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<Problem> check_triangle_soup(
  const Triangle_soup& soup, const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  internal::check_parameters<internal_np::allow_openings_t, internal_np::allow_parts_t>(np);
  return internal::soup_problems(
    soup, {choose_parameter(get_parameter(np, internal_np::allow_openings), false),
           choose_parameter(get_parameter(np, internal_np::allow_parts), false)});
}

#if CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES
CGAL_SURFACE_MESH_FOLIATION_INLINE Triangle_soup read_triangle_soup(const std::string& file_name)
{
  return internal::read_soup<internal::Triangle_collector>(file_name);
}

CGAL_SURFACE_MESH_FOLIATION_INLINE Polygon_soup read_polygon_soup(const std::string& file_name)
{
  return internal::read_soup<internal::Polygon_collector>(file_name);
}

CGAL_SURFACE_MESH_FOLIATION_INLINE Polygon_soup read_polygon_soup(std::istream& input,
                                                                  const std::string& format,
                                                                  const std::string& name)
{
  internal::require_parameter(internal::is_known_extension("." + format),
                              "the format of a mesh is none of off, obj, ply and stl");
  return internal::read_soup<internal::Polygon_collector>(
    name, internal::read_whole_stream(input, name), "." + format);
}

CGAL_SURFACE_MESH_FOLIATION_INLINE Triangle_soup
polygon_soup_to_triangle_soup(const Polygon_soup& soup)
{
  Triangle_soup result;
  result.points = soup.points;
  result.triangles.reserve(soup.polygons.size());
  const auto refuse = [](std::size_t face, const std::string& message) {
    throw Invalid_mesh_exception(
      internal::problem(Problem_kind::NOT_TRIANGLE_MESH, message).faces({face}));
  };
  for (const std::vector<std::size_t>& polygon : soup.polygons)
  {
    const std::size_t face = result.triangles.size();
    if (polygon.size() != 3)
      refuse(face, internal::corner_count_message(face, std::to_string(polygon.size())));
    result.triangles.push_back({polygon[0], polygon[1], polygon[2]});
    if (const auto vertex = internal::repeated_vertex(result.triangles.back()))
      refuse(face, internal::repeated_vertex_message(face, *vertex));
  }
  return result;
}
#endif // CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_IO_POLYGON_SOUP_H
