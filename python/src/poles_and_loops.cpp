// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "poles_and_loops.h"

#include "arrays.h"
#include "errors.h"

#include <CGAL/Surface_mesh_foliation/IO/read_loops.h>
#include <CGAL/Surface_mesh_foliation/IO/write_loops.h>
#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/loops.h>
#include <CGAL/Surface_mesh_foliation/picked_loops.h>

#include <boost/property_map/function_property_map.hpp>

#include <array>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace smf_python {

namespace {

Halfedge halfedge_of(const Mesh& mesh, Index source, Index target)
{
  const Halfedge h = mesh.surface.halfedge(vertex_of(mesh, source), vertex_of(mesh, target));
  if (h == Surface::null_halfedge())
    refuse_argument("no edge joins the vertices " + std::to_string(source) + " and " +
                    std::to_string(target) + ", which a loop is to cross");
  return h;
}

Halfedge border_of(const Mesh& mesh, Index opening)
{
  const auto number = static_cast<Index>(mesh.openings.size());
  if (opening < 0 || opening >= number)
    refuse_argument("there is no opening " + std::to_string(opening) + "; the mesh has " +
                    std::to_string(number) + ", numbered from 0");
  return mesh.openings[static_cast<std::size_t>(opening)];
}

void add_entry(const Mesh& mesh, const py::handle& entry, Poles_and_loops& result)
{
  const auto fields = entry.cast<py::tuple>();
  if (fields.size() != 4)
    throw std::invalid_argument("an entry has four fields");
  const std::vector<Vertex> pole = vertices_of(mesh, fields[0].cast<Indices>());
  const auto opening = fields[1].cast<Index>();
  Loop loop;
  if (!fields[2].is_none())
    loop = loop_of(mesh, fields[2]);
  const auto height = fields[3].cast<double>();
  if (!pole.empty())
    result.add_line_pole(pole, std::move(loop), height);
  else if (opening >= 0)
    result.add_border_pole(border_of(mesh, opening), std::move(loop), height);
  else
    result.add_loop(std::move(loop), height);
}

py::list loops_to_list(const Mesh& mesh, const std::vector<Loop>& loops)
{
  py::list result;
  for (const Loop& loop : loops)
    result.append(loop_to_tuple(mesh, loop));
  return result;
}

// Calls a function that outputs loops.
template <class Function>
py::list found_loops(const Mesh& mesh, const Function& function)
{
  std::vector<Loop> loops;
  without_gil([&] { function(std::back_inserter(loops)); });
  return loops_to_list(mesh, loops);
}

std::array<double, 4> plane_of(const Doubles& plane)
{
  require_shape(plane, "plane", 0);
  if (plane.size() != 4)
    throw std::invalid_argument("a plane has four numbers, a, b, c and d");
  return {plane.at(0), plane.at(1), plane.at(2), plane.at(3)};
}

py::tuple loop_along(const Mesh& mesh, const Indices& cycle)
{
  return loop_to_tuple(mesh, SMF::loop_from_edge_cycle(vertices_of(mesh, cycle), mesh.surface));
}

// The loop keeps clear of the poles and loops that are given.
py::tuple loop_through(const Mesh& mesh, const Indices& picks, const py::list& entries)
{
  const std::vector<Vertex> vertices = vertices_of(mesh, picks);
  Poles_and_loops input = poles_and_loops_of(mesh, entries);
  return loop_to_tuple(mesh, without_gil([&] {
                         if (input.size() == 0)
                           return SMF::loop_through_vertices(vertices, mesh.surface);
                         const std::size_t id =
                           SMF::add_loop_through_vertices(vertices, mesh.surface, input);
                         return input.entries()[id].loop;
                       }));
}

py::list loops_around(const Mesh& mesh, const Indices& inside)
{
  const std::vector<Vertex> vertices = vertices_of(mesh, inside);
  return found_loops(mesh,
                     [&](auto out) { SMF::loops_around_vertices(vertices, mesh.surface, out); });
}

py::list plane_loops(const Mesh& mesh, const Doubles& plane)
{
  const std::array<double, 4> numbers = plane_of(plane);
  return found_loops(mesh, [&](auto out) { SMF::plane_section_loops(mesh.surface, numbers, out); });
}

py::tuple plane_loop(const Mesh& mesh, const Doubles& plane, Index near)
{
  const Vertex v = vertex_of(mesh, near);
  const std::array<double, 4> numbers = plane_of(plane);
  return loop_to_tuple(
    mesh, without_gil([&] { return SMF::plane_section_loop(mesh.surface, numbers, v); }));
}

py::list isoline_loops(const Mesh& mesh, const Doubles& values, double level)
{
  require_shape(values, "values", 0);
  if (static_cast<std::size_t>(values.size()) != mesh.surface.number_of_vertices())
    throw std::invalid_argument("there must be a value for each vertex");
  const double* value = values.data();
  const auto function = boost::make_function_property_map<Vertex>(
    [value](Vertex v) { return value[static_cast<std::size_t>(v)]; });
  return found_loops(mesh,
                     [&](auto out) { SMF::isoline_loops(mesh.surface, function, level, out); });
}

py::tuple pole_loop(const Mesh& mesh, Index vertex, Index rings)
{
  const Vertex v = vertex_of(mesh, vertex);
  if (rings < 1 || rings > static_cast<Index>(mesh.surface.number_of_vertices()))
    refuse_argument("the number of rings, " + std::to_string(rings) +
                    ", is not between 1 and the number of vertices");
  return loop_to_tuple(mesh, without_gil([&] {
                         return SMF::pole_loop(v, mesh.surface, static_cast<unsigned int>(rings));
                       }));
}

py::list read_loops(const Mesh& mesh, const std::string& file)
{
  Poles_and_loops input;
  without_gil([&] { SMF::read_loops(file, mesh.surface, input); });
  std::vector<Loop> loops;
  for (const auto& entry : input.entries())
    loops.push_back(entry.loop);
  return loops_to_list(mesh, loops);
}

void write_loops(const Mesh& mesh, const std::string& file, const py::list& loops)
{
  std::vector<Loop> all;
  for (const py::handle loop : loops)
    all.push_back(loop_of(mesh, loop));
  without_gil([&] { SMF::write_loops(file, mesh.surface, all); });
}

py::array_t<double> points_of_loop(const Mesh& mesh, const py::handle& loop)
{
  std::vector<Point> points;
  for (const auto& crossing : loop_of(mesh, loop))
  {
    const Point &p = mesh.surface.point(mesh.surface.source(crossing.halfedge)),
                &q = mesh.surface.point(mesh.surface.target(crossing.halfedge));
    points.push_back(p + crossing.position * (q - p));
  }
  return to_array(points);
}

py::list validate(const Mesh& mesh, const py::list& entries)
{
  const Poles_and_loops input = poles_and_loops_of(mesh, entries);
  py::list result;
  for (const SMF::Problem& problem :
       without_gil([&] { return SMF::validate(mesh.surface, input); }))
    result.append(problem_to_tuple(problem));
  return result;
}

} // namespace

Loop loop_of(const Mesh& mesh, const py::handle& loop)
{
  const auto fields = loop.cast<py::tuple>();
  if (fields.size() != 2)
    throw std::invalid_argument("a loop has two fields");
  const auto edges = fields[0].cast<Indices>();
  const auto positions = fields[1].cast<Doubles>();
  require_shape(edges, "the edges of a loop", 2);
  require_shape(positions, "the positions of a loop", 0);
  if (edges.shape(0) != positions.size())
    throw std::invalid_argument("a loop needs a position for each edge that it crosses");
  Loop result;
  for (py::ssize_t i = 0; i < positions.size(); ++i)
    result.push_back({halfedge_of(mesh, edges.at(i, 0), edges.at(i, 1)), positions.at(i)});
  return result;
}

py::tuple loop_to_tuple(const Mesh& mesh, const Loop& loop)
{
  std::vector<std::array<Index, 2>> edges;
  std::vector<double> positions;
  for (const auto& crossing : loop)
  {
    edges.push_back({static_cast<Index>(mesh.surface.source(crossing.halfedge)),
                     static_cast<Index>(mesh.surface.target(crossing.halfedge))});
    positions.push_back(crossing.position);
  }
  return py::make_tuple(to_array(edges), to_array(std::move(positions)));
}

Poles_and_loops poles_and_loops_of(const Mesh& mesh, const py::list& entries)
{
  Poles_and_loops result;
  for (const py::handle entry : entries)
    add_entry(mesh, entry, result);
  return result;
}

void define_loops(py::module_& module)
{
  module.def("loop_along", &loop_along, py::arg("mesh"), py::arg("cycle"));
  module.def("loop_through", &loop_through, py::arg("mesh"), py::arg("picks"), py::arg("entries"));
  module.def("loops_around", &loops_around, py::arg("mesh"), py::arg("vertices"));
  module.def("plane_loops", &plane_loops, py::arg("mesh"), py::arg("plane"));
  module.def("plane_loop", &plane_loop, py::arg("mesh"), py::arg("plane"), py::arg("near"));
  module.def("isoline_loops", &isoline_loops, py::arg("mesh"), py::arg("values"), py::arg("level"));
  module.def("pole_loop", &pole_loop, py::arg("mesh"), py::arg("vertex"), py::arg("rings"));
  module.def("read_loops", &read_loops, py::arg("mesh"), py::arg("file"));
  module.def("write_loops", &write_loops, py::arg("mesh"), py::arg("file"), py::arg("loops"));
  module.def("points_of_loop", &points_of_loop, py::arg("mesh"), py::arg("loop"));
  module.def("validate", &validate, py::arg("mesh"), py::arg("entries"));
}

} // namespace smf_python
