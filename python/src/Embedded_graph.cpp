// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Embedded_graph.h"

#include "Result.h"
#include "arrays.h"
#include "pickled_graph.h"

#include <CGAL/Surface_mesh_foliation/IO/write_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/IO/write_swc.h>
#include <CGAL/Surface_mesh_foliation/curve_skeleton.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_matching.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_symmetries.h>

#include <pybind11/stl.h>

#include <boost/property_map/property_map.hpp>
#include <boost/range/iterator_range.hpp>

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace smf_python {

namespace {

using Node = boost::graph_traits<Graph>::vertex_descriptor;
using Arc = boost::graph_traits<Graph>::edge_descriptor;

// `number_of_samples` leaves in each arc, and more where a chord is off by more than
// `max_chord_deviation` radii
std::shared_ptr<Embedded_graph> embed(const Result& result,
                                      int number_of_samples,
                                      bool use_uniform_levels,
                                      double max_chord_deviation,
                                      int number_of_smoothing_steps)
{
  return without_gil([&] {
    auto embedded = std::make_shared<Embedded_graph>();
    embedded->embedding = SMF::reeb_graph_embedding(
      result.foliation, SMF::parameters::number_of_samples(number_of_samples)
                          .use_uniform_levels(use_uniform_levels)
                          .max_chord_deviation(max_chord_deviation)
                          .number_of_smoothing_steps(number_of_smoothing_steps));
    SMF::reeb_graph(result.foliation, embedded->graph, embedded->embedding);
    return embedded;
  });
}

py::list nodes_to_list(const Embedded_graph& embedded)
{
  py::list result;
  for (const Node v : boost::make_iterator_range(vertices(embedded.graph)))
  {
    const SMF::Reeb_node<Point>& node = embedded.graph[v];
    result.append(
      py::dict(py::arg("kind") = SMF::name(node.kind), py::arg("genus") = node.genus,
               py::arg("pole") = node.pole,
               py::arg("point") = py::make_tuple(node.point.x(), node.point.y(), node.point.z()),
               py::arg("radius") = node.radius));
  }
  return result;
}

py::list arcs_to_list(const Embedded_graph& embedded)
{
  py::list result;
  for (const Arc& e : boost::make_iterator_range(edges(embedded.graph)))
  {
    const SMF::Reeb_arc<Point>& arc = embedded.graph[e];
    result.append(py::dict(
      py::arg("ends") = py::make_tuple(source(e, embedded.graph), target(e, embedded.graph)),
      py::arg("loop") = arc.loop, py::arg("component") = SMF::name(arc.component),
      py::arg("height") = arc.height, py::arg("flux") = arc.flux, py::arg("area") = arc.area,
      py::arg("length") = SMF::length(arc.polyline), py::arg("polyline") = to_array(arc.polyline),
      py::arg("radii") = to_array(std::vector<double>(arc.radii))));
  }
  return result;
}

// arrays of numbers, one for each arc
py::list numbers_to_list(const std::vector<std::vector<double>>& values)
{
  py::list result;
  for (const std::vector<double>& of_arc : values)
    result.append(to_array(std::vector<double>(of_arc)));
  return result;
}

// the number of the point of the skeleton that stands for the surface around each vertex: first the
// nodes, then the samples, arc by arc
py::array_t<Index> vertex_samples(const Result& result, const Embedded_graph& embedded)
{
  std::vector<std::size_t> numbers(result.mesh->surface.number_of_vertices());
  without_gil([&] {
    SMF::vertex_samples(result.foliation, embedded.embedding,
                        boost::make_iterator_property_map(
                          numbers.begin(), get(boost::vertex_index, result.mesh->surface)));
  });
  return to_indices(numbers);
}

std::map<Arc, Index> numbers_of_arcs(const Graph& graph)
{
  std::map<Arc, Index> result;
  for (const Arc& e : boost::make_iterator_range(edges(graph)))
    result.emplace(e, static_cast<Index>(result.size()));
  return result;
}

// (nodes of the second graph by node of the first, arcs likewise, three distances), or nothing
py::object match(const Embedded_graph& first, const Embedded_graph& second, bool use_pole_labels)
{
  const auto matching = without_gil([&] {
    return SMF::match_reeb_graphs(first.graph, second.graph,
                                  SMF::parameters::use_pole_labels(use_pole_labels));
  });
  if (!matching)
    return py::none();
  std::vector<Index> nodes, arcs;
  for (const auto& pair : matching->nodes)
    nodes.push_back(static_cast<Index>(pair.second));
  const std::map<Arc, Index> number = numbers_of_arcs(second.graph);
  for (const auto& pair : matching->arcs)
    arcs.push_back(number.at(pair.second));
  return py::make_tuple(to_array(std::move(nodes)), to_array(std::move(arcs)),
                        matching->length_distance, matching->area_distance,
                        matching->flux_distance);
}

// (generators: pairs of images of nodes and of arcs, classes of nodes, of arcs, is it incomplete)
py::tuple symmetries(const Embedded_graph& embedded, double tolerance)
{
  const auto found = without_gil([&] {
    return SMF::reeb_graph_symmetries(embedded.graph, SMF::parameters::tolerance(tolerance));
  });
  const std::map<Arc, Index> number = numbers_of_arcs(embedded.graph);
  py::list generators;
  for (const auto& symmetry : found.generators)
  {
    std::vector<Index> arcs;
    for (const Arc& e : symmetry.arcs)
      arcs.push_back(number.at(e));
    generators.append(py::make_tuple(to_indices(symmetry.nodes), to_array(std::move(arcs))));
  }
  return py::make_tuple(generators, to_indices(found.node_classes), to_indices(found.arc_classes),
                        found.is_incomplete);
}

} // namespace

void define_embedded_graph(py::module_& module)
{
  py::class_<Embedded_graph, std::shared_ptr<Embedded_graph>>(module, "EmbeddedGraph")
    .def_property_readonly("nodes", &nodes_to_list)
    .def_property_readonly("arcs", &arcs_to_list)
    .def_property_readonly(
      "levels", [](const Embedded_graph& e) { return numbers_to_list(e.embedding.levels); })
    .def_property_readonly(
      "leaf_lengths",
      [](const Embedded_graph& e) { return numbers_to_list(e.embedding.leaf_lengths); })
    .def(py::pickle(&pickled, &unpickled))
    .def(
      "write_swc",
      [](const Embedded_graph& e, const std::string& file) {
        SMF::write_skeleton_swc(file, e.graph);
      },
      py::arg("file"))
    .def(
      "write_graphml",
      [](const Embedded_graph& e, const std::string& file) {
        SMF::write_reeb_graph_graphml(file, e.graph);
      },
      py::arg("file"));
  module.def("embed", &embed, py::arg("result"), py::arg("number_of_samples"),
             py::arg("use_uniform_levels"), py::arg("max_chord_deviation"),
             py::arg("number_of_smoothing_steps"));
  module.def("vertex_samples", &vertex_samples, py::arg("result"), py::arg("graph"));
  module.def("match", &match, py::arg("first"), py::arg("second"), py::arg("use_pole_labels"));
  module.def("symmetries", &symmetries, py::arg("graph"), py::arg("tolerance"));
}

} // namespace smf_python
