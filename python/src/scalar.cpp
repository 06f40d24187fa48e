// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scalar.h"

#include "Mesh.h"
#include "arrays.h"

#include <CGAL/Surface_mesh_foliation/reeb_graph_of_function.h>

#include <pybind11/stl.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/range/iterator_range.hpp>

#include <cstddef>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace smf_python {

namespace {

using Scalar_graph = SMF::Scalar_reeb_graph<Surface>;
using Scalar_arc = boost::graph_traits<Scalar_graph>::edge_descriptor;

const char* name_of(SMF::Critical_kind kind)
{
  return kind == SMF::Critical_kind::MINIMUM   ? "minimum"
         : kind == SMF::Critical_kind::MAXIMUM ? "maximum"
                                               : "saddle";
}

py::list nodes_to_list(const Scalar_graph& graph)
{
  py::list result;
  for (const auto v : boost::make_iterator_range(vertices(graph)))
    result.append(
      py::dict(py::arg("vertex") = static_cast<Index>(graph[v].vertex),
               py::arg("value") = graph[v].value, py::arg("kind") = name_of(graph[v].kind),
               py::arg("multiplicity") = graph[v].multiplicity, py::arg("genus") = graph[v].genus));
  return result;
}

py::list arcs_to_list(const Scalar_graph& graph)
{
  py::list result;
  for (const Scalar_arc& e : boost::make_iterator_range(edges(graph)))
    result.append(py::dict(py::arg("ends") = py::make_tuple(source(e, graph), target(e, graph)),
                           py::arg("lower") = graph[e].lower, py::arg("upper") = graph[e].upper,
                           py::arg("number_of_vertices") = graph[e].number_of_vertices));
  return result;
}

// (nodes, arcs, arc of each vertex)
py::tuple scalar_reeb_graph(const Mesh& mesh,
                            const Doubles& values,
                            const std::optional<double>& persistence,
                            bool unfold_saddles)
{
  require_shape(values, "values", 0);
  if (static_cast<std::size_t>(values.size()) != mesh.surface.number_of_vertices())
    throw std::invalid_argument("there must be a value for each vertex");
  Scalar_graph graph;
  std::vector<Scalar_arc> arcs(mesh.surface.number_of_vertices());
  const double* const value = values.data();
  without_gil([&] {
    const auto function = boost::make_function_property_map<Vertex>(
      [value](Vertex v) { return value[static_cast<std::size_t>(v)]; });
    const auto arc_of_vertex =
      boost::make_iterator_property_map(arcs.begin(), get(boost::vertex_index, mesh.surface));
    const auto parameters =
      SMF::parameters::unfold_saddles(unfold_saddles).vertex_to_arc_map(arc_of_vertex);
    if (persistence)
      SMF::reeb_graph_of_function(mesh.surface, function, graph,
                                  parameters.persistence(*persistence));
    else
      SMF::reeb_graph_of_function(mesh.surface, function, graph, parameters);
  });
  std::map<Scalar_arc, Index> number;
  for (const Scalar_arc& e : boost::make_iterator_range(edges(graph)))
    number.emplace(e, static_cast<Index>(number.size()));
  std::vector<Index> numbers;
  for (const Scalar_arc& e : arcs)
    numbers.push_back(number.at(e));
  return py::make_tuple(nodes_to_list(graph), arcs_to_list(graph), to_array(std::move(numbers)));
}

} // namespace

void define_scalar(py::module_& module)
{
  module.def("scalar_reeb_graph", &scalar_reeb_graph, py::arg("mesh"), py::arg("values"),
             py::arg("persistence"), py::arg("unfold_saddles"));
}

} // namespace smf_python
