// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Result.h"

#include "arrays.h"
#include "poles_and_loops.h"

#include <CGAL/Surface_mesh_foliation/components.h>
#include <CGAL/Surface_mesh_foliation/singularities.h>
#include <CGAL/Surface_mesh_foliation/subdivide_saddle_faces.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace smf_python {

namespace {

// A property map into a vector, by the number of a descriptor.
template <class Key, class Value>
struct Vector_map
{
  using key_type = Key;
  using value_type = Value;
  using reference = const Value&;
  using category = boost::writable_property_map_tag;

  std::vector<Index>* values;
  friend void put(const Vector_map& map, const Key& key, const Value& value)
  {
    (*map.values)[static_cast<std::size_t>(key)] = static_cast<Index>(value);
  }
};

// (arc or -1, node or -1, parameter) of all vertices
py::tuple vertex_cells(const Result& result)
{
  const std::size_t n = result.mesh->surface.number_of_vertices();
  std::vector<Index> arcs(n), nodes(n);
  std::vector<double> parameters(n);
  without_gil([&] {
    for (const Vertex v : result.mesh->surface.vertices())
    {
      const Foliation::Cell cell = result.foliation.cell(v);
      arcs[v] = cell.is_arc ? static_cast<Index>(cell.index) : -1;
      nodes[v] = cell.is_arc ? -1 : static_cast<Index>(cell.index);
      parameters[v] = result.foliation.parameter(v);
    }
  });
  return py::make_tuple(to_array(std::move(arcs)), to_array(std::move(nodes)),
                        to_array(std::move(parameters)));
}

py::array_t<double> edge_values(const Result& result)
{
  std::vector<double> values;
  values.reserve(result.mesh->surface.number_of_edges());
  without_gil([&] {
    for (const Edge e : result.mesh->surface.edges())
      values.push_back(result.foliation.edge_value(e));
  });
  return to_array(std::move(values));
}

py::array_t<Index> segments(const Result& result)
{
  std::vector<Index> arcs(result.mesh->surface.number_of_faces());
  without_gil(
    [&] { SMF::face_segmentation(result.foliation, Vector_map<Face, std::size_t>{&arcs}); });
  return to_array(std::move(arcs));
}

py::dict system_to_dict(const Result& result)
{
  const SMF::Loop_system<Surface>& system = result.foliation.system();
  std::vector<std::array<Index, 2>> ends;
  std::vector<double> heights, fluxes;
  for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
  {
    ends.push_back({static_cast<Index>(system.node(a, 0)), static_cast<Index>(system.node(a, 1))});
    heights.push_back(system.height(a));
    fluxes.push_back(result.foliation.flux(a));
  }
  py::list poles;
  for (std::size_t p = 0; p < system.number_of_poles(); ++p)
    poles.append(py::make_tuple(to_indices(system.pole_vertices(p)), system.is_border_pole(p)));
  py::dict dict;
  dict["genus"] = system.genus();
  dict["number_of_nodes"] = system.number_of_nodes();
  dict["ends"] = to_array(ends);
  dict["heights"] = to_array(std::move(heights));
  dict["fluxes"] = to_array(std::move(fluxes));
  dict["poles"] = poles;
  dict["merged_loops"] = to_indices(system.merged_loops());
  return dict;
}

py::dict statistics_to_dict(const Result& result)
{
  const SMF::Foliation_statistics& statistics = result.foliation.statistics();
  py::dict dict;
  dict["is_certified"] = statistics.is_certified;
  dict["has_converged"] = statistics.has_converged;
  dict["energy"] = statistics.energy;
  dict["optimality"] = statistics.optimality;
  dict["resolved_optimality"] = statistics.resolved_optimality;
  dict["iterations"] = statistics.number_of_iterations;
  return dict;
}

py::list loops_to_list(const Result& result)
{
  py::list loops;
  for (std::size_t a = 0; a < result.foliation.system().number_of_arcs(); ++a)
    loops.append(loop_to_tuple(*result.mesh, result.foliation.system().loop(a)));
  return loops;
}

const char* name_of(SMF::Singularity_kind kind)
{
  using Kind = SMF::Singularity_kind;
  return kind == Kind::CENTER_POLE    ? "center_pole"
         : kind == Kind::THORN_POLE   ? "thorn_pole"
         : kind == Kind::TRIPOD       ? "tripod"
         : kind == Kind::MORSE_SADDLE ? "morse_saddle"
                                      : "higher_saddle";
}

// (kind, index, order, node, vertex or -1, face or -1)
py::list singularities_to_list(const Result& result)
{
  std::vector<SMF::Singularity<Surface>> all;
  SMF::singularities(result.foliation, std::back_inserter(all));
  py::list list;
  for (const SMF::Singularity<Surface>& s : all)
    list.append(py::make_tuple(name_of(s.kind), s.index, s.order, s.node,
                               s.is_face ? -1 : static_cast<Index>(s.vertex),
                               s.is_face ? static_cast<Index>(s.face) : -1));
  return list;
}

// (vertices, faces, arc of each face, pairs of vertices of edges on critical leaves)
py::tuple components(const Result& result)
{
  Surface output;
  std::vector<Index> labels;
  auto label = output.add_property_map<Face, std::size_t>("f:component", 0).first;
  auto is_critical = output.add_property_map<Edge, bool>("e:critical", false).first;
  std::vector<Point> points;
  std::vector<std::array<Index, 2>> critical;
  without_gil([&] {
    SMF::surface_components(
      result.foliation, output,
      SMF::parameters::face_component_map(label).edge_is_constrained_map(is_critical));
    for (const Vertex v : output.vertices())
      points.push_back(output.point(v));
    for (const Face f : output.faces())
      labels.push_back(static_cast<Index>(label[f]));
    for (const Edge e : output.edges())
      if (is_critical[e])
        critical.push_back(
          {static_cast<Index>(output.vertex(e, 0)), static_cast<Index>(output.vertex(e, 1))});
  });
  return py::make_tuple(to_array(points), faces_to_array(output), to_array(std::move(labels)),
                        to_array(critical));
}

// (vertices, faces, ends of edges, edge values) of the mesh with singular faces split
py::tuple subdivided(const Result& result)
{
  Surface output;
  const auto value = output.add_property_map<Edge, double>("e:value", 0).first;
  std::vector<Point> points;
  std::vector<std::array<Index, 2>> ends;
  std::vector<double> values;
  without_gil([&] {
    SMF::subdivide_saddle_faces(result.foliation, output, SMF::parameters::edge_value_map(value));
    for (const Vertex v : output.vertices())
      points.push_back(output.point(v));
    for (const Edge e : output.edges())
    {
      ends.push_back(
        {static_cast<Index>(output.vertex(e, 0)), static_cast<Index>(output.vertex(e, 1))});
      values.push_back(value[e]);
    }
  });
  return py::make_tuple(to_array(points), faces_to_array(output), to_array(ends),
                        to_array(std::move(values)));
}

} // namespace

void define_result(py::module_& module)
{
  py::class_<Result>(module, "Result")
    .def_property_readonly("mesh", [](const Result& result) { return result.mesh; })
    .def_property_readonly("system", &system_to_dict)
    .def_property_readonly("statistics", &statistics_to_dict)
    .def_property_readonly("loops", &loops_to_list)
    .def_property_readonly("singularities", &singularities_to_list)
    .def("vertex_cells", &vertex_cells)
    .def("edge_values", &edge_values)
    .def("segments", &segments)
    .def("components", &components)
    .def("subdivided", &subdivided);
}

} // namespace smf_python
