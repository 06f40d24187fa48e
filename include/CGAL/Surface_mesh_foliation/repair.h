// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_REPAIR_H
#define CGAL_SURFACE_MESH_FOLIATION_REPAIR_H

#include <CGAL/Surface_mesh_foliation/IO/polygon_soup.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/face_messages.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/soup_problems.h>
#include <CGAL/Surface_mesh_foliation/internal/Repair/Face_triangulation.h>
#include <CGAL/Surface_mesh_foliation/internal/Repair/Repaired_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Repair/Traced_soup.h>
#include <CGAL/Surface_mesh_foliation/internal/Repair/clean_faces.h>
#include <CGAL/Surface_mesh_foliation/internal/Repair/merge_open_edges.h>
#include <CGAL/Surface_mesh_foliation/internal/Repair/orient_faces.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

/// \file
/// This header is not included by `Surface_mesh_foliation.h`, since the functions of \cgal that it
/// needs take long to compile.

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationRepair

counts what `repair_polygon_soup()` did.
*/
struct Repair_report
{
  /// vertices that were merged into another one at the same position, since edges with one face lay
  /// at the same place, or an edge of length zero joined them
  std::size_t merged_vertices = 0;
  /// faces with more than three corners, which were cut into triangles
  std::size_t triangulated_faces = 0;
  /// faces with fewer than three different corners, or without area, which were removed
  std::size_t degenerate_faces = 0;
  /// faces with the same vertices as an earlier face, which were removed
  std::size_t repeated_faces = 0;
  /// faces that were turned over
  std::size_t reversed_faces = 0;
  /// copies made of vertices where the surface was not a manifold, or not orientable
  std::size_t duplicated_vertices = 0;
  /// pairs of open edges at the same position that were joined
  std::size_t stitched_edges = 0;
  /// vertices without a face, which were removed
  std::size_t unused_vertices = 0;
};

/// \ingroup PkgSurfaceMeshFoliationRepair
/// tells what was done, one line for each kind of repair, such as `3 faces were turned over`.
inline std::vector<std::string> descriptions(const Repair_report& report)
{
  std::vector<std::string> result;
  const auto add = [&](std::size_t number, const char* one, const char* several, const char* done) {
    if (number > 0)
      result.push_back(internal::text(number, ' ', number == 1 ? one : several,
                                      number == 1 ? " was " : " were ", done));
  };
  add(report.merged_vertices, "vertex", "vertices", "merged with another at the same position");
  add(report.triangulated_faces, "face", "faces", "cut into triangles");
  add(report.degenerate_faces, "face", "faces", "removed for want of area");
  add(report.repeated_faces, "face", "faces", "removed as a copy of another");
  add(report.reversed_faces, "face", "faces", "turned over");
  add(report.duplicated_vertices, "copy of a vertex", "copies of vertices",
      "made where the mesh is not manifold");
  add(report.stitched_edges, "pair of open edges", "pairs of open edges", "joined");
  add(report.unused_vertices, "vertex", "vertices", "removed for want of faces");
  return result;
}

/*!
\ingroup PkgSurfaceMeshFoliationRepair

is a repaired mesh, with maps between its vertices and faces and those of the input.
*/
struct Repaired_soup
{
  /// the number of a vertex or face that does not exist
  static constexpr std::size_t none = internal::no_element;

  /// an oriented manifold of triangles, perhaps with openings, and of several parts. Vertices and
  /// faces are in the order of those of the input that they come from.
  Triangle_soup soup;

  /// by vertex of the result: the vertex of the input that it comes from, or `none`
  std::vector<std::size_t> vertex_origins;

  /// by face of the result: the face of the input that it comes from, or `none`
  std::vector<std::size_t> face_origins;

  /// by vertex of the input: the vertex of the result that stands for it, the first of several
  /// copies, or `none`
  std::vector<std::size_t> vertices;

  /// face `f` of the input became the faces from `first_faces[f]` to `first_faces[f + 1] - 1` of
  /// the result: one, several if it was cut, or none. There is one number more than faces.
  std::vector<std::size_t> first_faces;

  Repair_report report; ///< what was done
};

namespace internal {

inline void check_repairable(const Polygon_soup& soup)
{
  for (std::size_t face = 0; face < soup.polygons.size(); ++face)
    for (const std::size_t corner : soup.polygons[face])
      if (corner >= soup.points.size())
        throw Invalid_mesh_exception(
          problem(Problem_kind::FILE,
                  index_range_message(face, std::to_string(corner), soup.points.size()))
            .faces({face}));
  for (std::size_t vertex = 0; vertex < soup.points.size(); ++vertex)
    for (const double coordinate : soup.points[vertex])
      if (!std::isfinite(coordinate))
        throw Invalid_mesh_exception(problem(Problem_kind::NOT_FINITE, vertex_name(vertex),
                                             " has a coordinate that is not finite")
                                       .vertices({vertex}));
}

inline bool is_closed_surface(const Polygon_soup& soup)
{
  const auto is_triangle = [](const auto& polygon) {
    return polygon.size() == 3 && polygon[0] != polygon[1] && polygon[1] != polygon[2] &&
           polygon[2] != polygon[0];
  };
  return std::all_of(soup.polygons.begin(), soup.polygons.end(), is_triangle) &&
         soup_problems(polygon_soup_to_triangle_soup(soup), {false, true}).empty();
}

inline Repaired_soup unchanged(const Polygon_soup& soup)
{
  Repaired_soup result;
  result.soup = polygon_soup_to_triangle_soup(soup);
  result.vertices.resize(soup.points.size());
  std::iota(result.vertices.begin(), result.vertices.end(), std::size_t(0));
  result.vertex_origins = result.vertices;
  result.first_faces.resize(soup.polygons.size() + 1);
  std::iota(result.first_faces.begin(), result.first_faces.end(), std::size_t(0));
  result.face_origins.assign(result.first_faces.begin(), result.first_faces.end() - 1);
  return result;
}

// The vertex of the result for each of the input: the first that comes from it, or else the first
// at its position.
inline std::vector<std::size_t> vertices_by_input(const Polygon_soup& input,
                                                  const std::vector<bool>& is_used,
                                                  const Repaired_soup& repaired)
{
  std::vector<std::size_t> result(input.points.size(), no_element);
  std::map<Point, std::size_t> vertex_at;
  for (std::size_t v = 0; v < repaired.soup.points.size(); ++v)
  {
    vertex_at.emplace(repaired.soup.points[v], v);
    const std::size_t origin = repaired.vertex_origins[v];
    if (origin != no_element && result[origin] == no_element)
      result[origin] = v;
  }
  for (std::size_t v = 0; v < result.size(); ++v)
    if (result[v] == no_element && is_used[v])
    {
      const auto found = vertex_at.find(input.points[v]);
      if (found != vertex_at.end())
        result[v] = found->second;
    }
  return result;
}

// the first face of the result by face of the input; faces are sorted by their origins
inline std::vector<std::size_t> faces_by_input(std::size_t number_of_input_faces,
                                               const std::vector<std::size_t>& face_origins)
{
  std::vector<std::size_t> result;
  for (std::size_t f = 0; f <= number_of_input_faces; ++f)
    result.push_back(std::lower_bound(face_origins.begin(), face_origins.end(), f) -
                     face_origins.begin());
  return result;
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationRepair

makes the faces of a polygon mesh an oriented manifold of triangles, and tells what it did.

These are the steps. Most of them are functions of \cgal's package Polygon Mesh Processing, to which
is added that nothing loses track of what it comes from.
1. Edges with one face are merged if their ends have exactly equal positions, such as those of faces
   that do not know their neighbors, or along seams of textures; and so are the ends of edges of
   length zero. Other vertices stay apart, since surfaces may touch.
2. Faces lose repeated corners, and those with fewer than three are removed.
3. Faces with more than three corners are cut into triangles.
4. Triangles with the same three vertices as an earlier one are removed; those of the input before
   step 1, since their edges have more than one face, though they lie open.
5. Faces are oriented alike; where more than two meet at an edge, or a vertex has several umbrellas,
   or faces cannot be oriented alike, vertices are duplicated, so that the surface comes apart
   there.
6. Borders of a part that lie at the same positions are joined.
7. Faces without area are removed by flips and collapses of edges. Where that leaves a vertex with
   several umbrellas, it is duplicated. If two triangles are all that is left of a part, back to
   back, the later one is removed.
8. Vertices without faces are removed.

A mesh that is already a closed surface of triangles without degenerate faces, oriented alike, is
returned as it is. Openings stay open (see `fill_openings()`), and parts stay (see `mesh_parts()`).

\param soup the vertices and faces, for example from `read_polygon_soup()`

\returns the repaired mesh, from which `triangle_soup_to_triangle_mesh()` makes a mesh with the
  parameters `allow_openings(true)` and `allow_parts(true)`

\throws Invalid_mesh_exception if an index is out of range, or a coordinate is not finite: nobody
  can tell what was meant

The time is \f$O(n \log n)\f$ for \f$n\f$ corners in all, but for polygons with many corners, see
`CGAL::Polygon_mesh_processing::triangulate_hole_polyline()`.

\sa `read_polygon_soup()`
*/
inline Repaired_soup repair_polygon_soup(const Polygon_soup& soup)
{
  internal::check_repairable(soup);
  if (internal::is_closed_surface(soup))
    return internal::unchanged(soup);
  internal::Traced_soup traced(soup);
  const std::vector<bool> is_used = traced.is_used();
  Repaired_soup result;
  Repair_report& report = result.report;
  report.unused_vertices = std::count(is_used.begin(), is_used.end(), false);
  report.repeated_faces = internal::remove_repeated_triangles(traced);
  report.merged_vertices = internal::merge_open_edges(traced);
  report.degenerate_faces = internal::remove_repeated_corners(traced);
  report.triangulated_faces = internal::Face_triangulation(traced).run();
  report.repeated_faces += internal::remove_repeated_triangles(traced);
  const auto counts = internal::orient_faces(traced);
  report.reversed_faces = counts.reversed_faces;
  report.duplicated_vertices = counts.duplicated_vertices;
  internal::Repaired_mesh mesh(traced);
  report.stitched_edges = mesh.stitch();
  report.degenerate_faces += mesh.remove_degenerate_faces();
  report.duplicated_vertices += mesh.separate_umbrellas();
  report.repeated_faces += mesh.remove_backs_of_faces();
  mesh.output(result.soup, result.vertex_origins, result.face_origins);
  result.vertices = internal::vertices_by_input(soup, is_used, result);
  result.first_faces = internal::faces_by_input(soup.polygons.size(), result.face_origins);
  return result;
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_REPAIR_H
