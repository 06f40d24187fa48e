// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "leaves.h"

#include "Result.h"
#include "arrays.h"
#include "errors.h"

#include <CGAL/Surface_mesh_foliation/Component_coordinates.h>
#include <CGAL/Surface_mesh_foliation/Leaf_tracer.h>
#include <CGAL/Surface_mesh_foliation/leaves.h>

#include <pybind11/stl.h>

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

using Leaf = SMF::Leaf<Point>;
using Uv = SMF::Component_coordinates<Surface>::Uv;

// Traces leaves; it does not change, so threads may share it.
class Tracer
{
public:
  explicit Tracer(const Result& result)
    : m_mesh(result.mesh),
      m_tracer(without_gil([&] { return SMF::Leaf_tracer<Surface>(result.foliation); }))
  {}

  py::tuple leaf(Index arc, double level) const
  {
    if (arc < 0)
      refuse_argument("there is no arc " + std::to_string(arc));
    return to_tuple(
      without_gil([&] { return m_tracer.leaf(static_cast<std::size_t>(arc), level); }));
  }

  py::object leaf_through_vertex(Index vertex) const
  {
    const Vertex v = vertex_of(*m_mesh, vertex);
    return to_object(without_gil([&] { return m_tracer.leaf_through(v); }));
  }

  py::object leaf_through_point(Index face, const std::array<double, 3>& coordinates) const
  {
    const Face f = face_of(*m_mesh, face);
    return to_object(without_gil([&] { return m_tracer.leaf_through(f, coordinates); }));
  }

  // (does it lie in an arc, number of the arc or node, level)
  py::tuple locate(Index face, const std::array<double, 3>& coordinates) const
  {
    const auto location = m_tracer.locate(face_of(*m_mesh, face), coordinates);
    return py::make_tuple(location.is_arc, location.index, location.level);
  }

private:
  // (arc, level, points, length, centroid)
  static py::tuple to_tuple(const Leaf& leaf)
  {
    return py::make_tuple(leaf.arc, leaf.level, to_array(leaf.points), leaf.length,
                          py::make_tuple(leaf.centroid.x(), leaf.centroid.y(), leaf.centroid.z()));
  }
  static py::object to_object(const std::optional<Leaf>& leaf)
  {
    return leaf ? py::object(to_tuple(*leaf)) : py::object(py::none());
  }

  Mesh_pointer m_mesh;
  SMF::Leaf_tracer<Surface> m_tracer;
};

// (node, points) of each part of a critical leaf
py::list critical_leaves(const Result& result)
{
  std::vector<SMF::Critical_polyline<Point>> polylines;
  without_gil([&] { SMF::critical_leaves(result.foliation, std::back_inserter(polylines)); });
  py::list list;
  for (const auto& polyline : polylines)
    list.append(py::make_tuple(polyline.node, to_array(polyline.points)));
  return list;
}

// the coordinates of the three corners of each face, in the order of faces_to_array()
template <class UvMap>
py::array_t<double> corners_to_array(const Surface& surface, const UvMap& uv)
{
  std::vector<double> values;
  for (const Face f : surface.faces())
  {
    Halfedge h = surface.prev(surface.halfedge(f)); // its target is the first corner
    for (int i = 0; i < 3; ++i, h = surface.next(h))
      values.insert(values.end(), uv[h].begin(), uv[h].end());
  }
  return to_array(std::move(values), {static_cast<py::ssize_t>(surface.number_of_faces()), 3, 2});
}

// (vertices, faces, arc, (u, v) of corners, texture coordinates of corners, side of the texture)
py::tuple coordinates(const Result& result)
{
  Surface output;
  auto label = output.add_property_map<Face, std::size_t>("f:component", 0).first;
  auto uv = output.add_property_map<Halfedge, Uv>("h:uv").first;
  Surface textured;
  auto texture = textured.add_property_map<Halfedge, Uv>("h:uv").first;
  double size = 0;
  without_gil([&] {
    const SMF::Component_coordinates<Surface> coordinates(result.foliation);
    coordinates.uv_mesh(output, uv, SMF::parameters::face_component_map(label));
    coordinates.texture_mesh(textured, texture);
    size = coordinates.texture_size();
  });
  std::vector<Point> points;
  for (const Vertex v : output.vertices())
    points.push_back(output.point(v));
  std::vector<Index> labels;
  for (const Face f : output.faces())
    labels.push_back(static_cast<Index>(label[f]));
  return py::make_tuple(to_array(points), faces_to_array(output), to_array(std::move(labels)),
                        corners_to_array(output, uv), corners_to_array(textured, texture), size);
}

} // namespace

void define_leaves(py::module_& module)
{
  py::class_<Tracer>(module, "LeafTracer")
    .def(py::init<const Result&>(), py::arg("result"))
    .def("leaf", &Tracer::leaf, py::arg("arc"), py::arg("level"))
    .def("leaf_through_vertex", &Tracer::leaf_through_vertex, py::arg("vertex"))
    .def("leaf_through_point", &Tracer::leaf_through_point, py::arg("face"), py::arg("coordinates"))
    .def("locate", &Tracer::locate, py::arg("face"), py::arg("coordinates"));
  module.def("critical_leaves", &critical_leaves, py::arg("result"));
  module.def("coordinates", &coordinates, py::arg("result"));
}

} // namespace smf_python
