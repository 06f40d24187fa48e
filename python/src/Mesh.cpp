// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Mesh.h"

#include "arrays.h"
#include "errors.h"

#include <CGAL/Surface_mesh_foliation/IO/polygon_soup.h>
#include <CGAL/Surface_mesh_foliation/IO/read_triangle_mesh.h>
#include <CGAL/Surface_mesh_foliation/fill_openings.h>
#include <CGAL/Surface_mesh_foliation/openings.h>
#include <CGAL/Surface_mesh_foliation/parts.h>
#include <CGAL/Surface_mesh_foliation/repair.h>

#include <CGAL/boost/graph/helpers.h>

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace smf_python {

namespace {

// the longest border of an opening that is filled; nothing: that of fill_openings()
using Fill_length = std::optional<double>;

void fill_openings(Mesh& mesh, const Fill_length& length)
{
  auto is_filled = mesh.surface.add_property_map<Face, bool>("f:filled", false).first;
  const auto parameters = SMF::parameters::filled_face_map(is_filled);
  if (!CGAL::is_closed(mesh.surface))
    mesh.number_of_filled_openings =
      length ? SMF::fill_openings(mesh.surface, parameters.max_opening_length(*length))
             : SMF::fill_openings(mesh.surface, parameters);
  for (const Face f : mesh.surface.faces())
    mesh.is_filled.push_back(is_filled[f]);
  mesh.surface.remove_property_map(is_filled);
}

Mesh_pointer mesh_of_soup(const SMF::Triangle_soup& soup, const Fill_length& length)
{
  auto mesh = std::make_shared<Mesh>();
  SMF::triangle_soup_to_triangle_mesh(soup, mesh->surface,
                                      SMF::parameters::allow_openings(true).allow_parts(true));
  fill_openings(*mesh, length);
  std::vector<SMF::Opening<Surface>> openings;
  SMF::openings(mesh->surface, std::back_inserter(openings));
  for (const SMF::Opening<Surface>& opening : openings)
    mesh->openings.push_back(opening.border);
  return mesh;
}

std::vector<std::array<double, 3>> points_of(const Doubles& vertices)
{
  require_shape(vertices, "vertices", 3);
  std::vector<std::array<double, 3>> points(static_cast<std::size_t>(vertices.shape(0)));
  const double* p = vertices.data();
  for (std::array<double, 3>& point : points)
    for (double& coordinate : point)
      coordinate = *p++;
  return points;
}

std::size_t checked_corner(Index corner, Index face, std::size_t number_of_vertices)
{
  if (corner < 0 || static_cast<std::size_t>(corner) >= number_of_vertices)
    refuse_mesh(SMF::Problem_kind::FILE,
                "face " + std::to_string(face) + " has the vertex " + std::to_string(corner) +
                  ", but there are only " + std::to_string(number_of_vertices) +
                  " vertices, numbered from 0",
                face);
  return static_cast<std::size_t>(corner);
}

Mesh_pointer mesh_of_triangles(const Doubles& vertices,
                               const Indices& faces,
                               const Fill_length& length)
{
  require_shape(faces, "faces", 3);
  SMF::Triangle_soup soup;
  soup.points = points_of(vertices);
  soup.triangles.resize(static_cast<std::size_t>(faces.shape(0)));
  const Index* corner = faces.data();
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    for (std::size_t& v : soup.triangles[f])
      v = checked_corner(*corner++, static_cast<Index>(f), soup.points.size());
  return without_gil([&] { return mesh_of_soup(soup, length); });
}

// Face `f` has the corners from `first[f]` to `first[f + 1] - 1`.
SMF::Polygon_soup polygons_of(const Doubles& vertices, const Indices& corners, const Indices& first)
{
  require_shape(corners, "corners", 0);
  require_shape(first, "first", 0);
  SMF::Polygon_soup soup;
  soup.points = points_of(vertices);
  for (py::ssize_t f = 0; f + 1 < first.size(); ++f)
  {
    const Index begin = first.at(f), end = first.at(f + 1);
    if (begin < 0 || end < begin || end > corners.size())
      refuse_argument("face " + std::to_string(f) + " has corners that are not given");
    soup.polygons.emplace_back();
    for (Index i = begin; i < end; ++i)
      soup.polygons.back().push_back(checked_corner(corners.at(i), f, soup.points.size()));
  }
  return soup;
}

py::dict to_dict(const SMF::Repaired_soup& repaired)
{
  const SMF::Repair_report& report = repaired.report;
  py::dict result;
  result["merged_vertices"] = report.merged_vertices;
  result["triangulated_faces"] = report.triangulated_faces;
  result["degenerate_faces"] = report.degenerate_faces;
  result["repeated_faces"] = report.repeated_faces;
  result["reversed_faces"] = report.reversed_faces;
  result["duplicated_vertices"] = report.duplicated_vertices;
  result["stitched_edges"] = report.stitched_edges;
  result["unused_vertices"] = report.unused_vertices;
  result["descriptions"] = SMF::descriptions(report);
  result["vertex_origins"] = to_indices(repaired.vertex_origins); // none becomes -1
  result["face_origins"] = to_indices(repaired.face_origins);
  result["vertices"] = to_indices(repaired.vertices);
  result["first_faces"] = to_indices(repaired.first_faces);
  return result;
}

std::pair<Mesh_pointer, py::dict> repaired_mesh(const SMF::Polygon_soup& soup,
                                                const Fill_length& length)
{
  SMF::Repaired_soup repaired;
  Mesh_pointer mesh;
  without_gil([&] {
    repaired = SMF::repair_polygon_soup(soup);
    mesh = mesh_of_soup(repaired.soup, length);
  });
  return {mesh, to_dict(repaired)};
}

std::pair<Mesh_pointer, py::dict> repaired_mesh_of_polygons(const Doubles& vertices,
                                                            const Indices& corners,
                                                            const Indices& first,
                                                            const Fill_length& length)
{
  return repaired_mesh(polygons_of(vertices, corners, first), length);
}

// the message of an exception begins with the file name
template <class Function>
auto about_file(const std::string& file, const Function& function)
{
  try
  {
    return function();
  }
  catch (const SMF::Invalid_mesh_exception& exception)
  {
    SMF::Problem problem = exception.problem();
    if (problem.message.find(file) != 0)
      problem.message.insert(0, file + ": ");
    throw SMF::Invalid_mesh_exception(problem);
  }
}

Mesh_pointer read_mesh(const std::string& file, const Fill_length& length)
{
  return about_file(file, [&] {
    return without_gil([&] { return mesh_of_soup(SMF::read_triangle_soup(file), length); });
  });
}

std::pair<Mesh_pointer, py::dict> read_repaired_mesh(const std::string& file,
                                                     const Fill_length& length)
{
  return about_file(file, [&] {
    const SMF::Polygon_soup soup = without_gil([&] { return SMF::read_polygon_soup(file); });
    return repaired_mesh(soup, length);
  });
}

py::array_t<double> vertices_to_array(const py::object& self)
{
  static_assert(sizeof(Point) == 3 * sizeof(double), "points are stored as in an array");
  const auto& mesh = self.cast<const Mesh&>();
  const auto n = static_cast<py::ssize_t>(mesh.surface.number_of_vertices());
  const double* data = n == 0 ? nullptr : &mesh.surface.point(Vertex(0))[0];
  return read_only_view(data, {n, 3}, self);
}

py::array_t<Index> edges_to_array(const Mesh& mesh)
{
  std::vector<std::array<Index, 2>> rows;
  for (const Edge e : mesh.surface.edges())
    rows.push_back({static_cast<Index>(mesh.surface.vertex(e, 0)),
                    static_cast<Index>(mesh.surface.vertex(e, 1))});
  return to_array(rows);
}

// the vertices around each opening
py::list openings_to_list(const Mesh& mesh)
{
  py::list result;
  for (const Halfedge border : mesh.openings)
    result.append(to_indices(CGAL::vertices_around_face(border, mesh.surface)));
  return result;
}

// (vertices, faces) of each connected component, the largest first
py::list parts_to_list(const Mesh& mesh)
{
  const auto parts = without_gil([&] { return SMF::mesh_parts(mesh.surface); });
  py::list result;
  for (const SMF::Mesh_part<Surface>& part : parts)
    result.append(py::make_tuple(to_indices(vertices(part)), to_indices(faces(part))));
  return result;
}

} // namespace

Vertex vertex_of(const Mesh& mesh, Index number)
{
  const Index n = mesh.surface.number_of_vertices();
  if (number < 0 || number >= n)
    refuse_argument("there is no vertex " + std::to_string(number) + "; the mesh has " +
                    std::to_string(n) + ", numbered from 0");
  return Vertex(static_cast<Surface::size_type>(number));
}

Face face_of(const Mesh& mesh, Index number)
{
  const Index n = mesh.surface.number_of_faces();
  if (number < 0 || number >= n)
    refuse_argument("there is no face " + std::to_string(number) + "; the mesh has " +
                    std::to_string(n) + ", numbered from 0");
  return Face(static_cast<Surface::size_type>(number));
}

std::vector<Vertex> vertices_of(const Mesh& mesh, const Indices& numbers)
{
  require_shape(numbers, "vertices", 0);
  std::vector<Vertex> result;
  for (py::ssize_t i = 0; i < numbers.size(); ++i)
    result.push_back(vertex_of(mesh, numbers.at(i)));
  return result;
}

py::array_t<Index> faces_to_array(const Surface& surface)
{
  std::vector<std::array<Index, 3>> rows;
  rows.reserve(surface.number_of_faces());
  for (const Face f : surface.faces())
  {
    // the first corner of a face of a soup is the source of its halfedge
    const Halfedge h = surface.halfedge(f);
    rows.push_back({static_cast<Index>(surface.source(h)), static_cast<Index>(surface.target(h)),
                    static_cast<Index>(surface.target(surface.next(h)))});
  }
  return to_array(rows);
}

void define_mesh(py::module_& module)
{
  py::class_<Mesh, Mesh_pointer>(module, "Mesh")
    .def_property_readonly("vertices", &vertices_to_array)
    .def_property_readonly("faces", [](const Mesh& mesh) { return faces_to_array(mesh.surface); })
    .def_property_readonly("edges", &edges_to_array)
    .def_property_readonly(
      "is_filled",
      [](const Mesh& mesh) {
        py::array_t<bool> result(static_cast<py::ssize_t>(mesh.is_filled.size()));
        std::copy(mesh.is_filled.begin(), mesh.is_filled.end(), result.mutable_data());
        return result;
      })
    .def_readonly("number_of_filled_openings", &Mesh::number_of_filled_openings)
    .def_property_readonly("openings", &openings_to_list)
    .def("parts", &parts_to_list);
  module.def("mesh_of_triangles", &mesh_of_triangles, py::arg("vertices"), py::arg("faces"),
             py::arg("fill_length"));
  module.def("repaired_mesh_of_polygons", &repaired_mesh_of_polygons, py::arg("vertices"),
             py::arg("corners"), py::arg("first"), py::arg("fill_length"));
  module.def("read_mesh", &read_mesh, py::arg("file"), py::arg("fill_length"));
  module.def("read_repaired_mesh", &read_repaired_mesh, py::arg("file"), py::arg("fill_length"));
}

} // namespace smf_python
