// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pickled_graph.h"

#include "arrays.h"

#include <pybind11/stl.h>

#include <boost/range/iterator_range.hpp>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace smf_python {

namespace {

// (kind, genus, pole, point, radius) of each node
py::list pickled_nodes(const Graph& graph)
{
  py::list result;
  for (const auto v : boost::make_iterator_range(vertices(graph)))
  {
    const SMF::Reeb_node<Point>& node = graph[v];
    const std::array<double, 3> point = {node.point.x(), node.point.y(), node.point.z()};
    result.append(
      py::make_tuple(static_cast<int>(node.kind), node.genus, node.pole, point, node.radius));
  }
  return result;
}

// (ends, loop, component, height, flux, area, points, radii, levels, lengths of leaves) of each arc
py::list pickled_arcs(const Embedded_graph& embedded)
{
  py::list result;
  std::size_t a = 0;
  for (const auto& e : boost::make_iterator_range(edges(embedded.graph)))
  {
    const SMF::Reeb_arc<Point>& arc = embedded.graph[e];
    result.append(py::make_tuple(source(e, embedded.graph), target(e, embedded.graph), arc.loop,
                                 static_cast<int>(arc.component), arc.height, arc.flux, arc.area,
                                 to_array(arc.polyline), arc.radii, embedded.embedding.levels[a],
                                 embedded.embedding.leaf_lengths[a]));
    ++a;
  }
  return result;
}

[[noreturn]] void refuse_pickle()
{
  throw std::invalid_argument("this is not a pickled graph");
}

py::tuple fields_of(const py::handle& pickle, std::size_t number)
{
  const auto fields = pickle.cast<py::tuple>();
  if (fields.size() != number)
    refuse_pickle();
  return fields;
}

// the value of an enumeration whose last one is given
template <class Enumeration>
Enumeration to_enumeration(const py::handle& pickle, Enumeration last)
{
  const int value = pickle.cast<int>();
  if (value < 0 || value > static_cast<int>(last))
    refuse_pickle();
  return static_cast<Enumeration>(value);
}

std::vector<Point> points_of_array(const Doubles& array)
{
  require_shape(array, "points", 3);
  std::vector<Point> result;
  for (py::ssize_t i = 0; i < array.shape(0); ++i)
    result.emplace_back(array.at(i, 0), array.at(i, 1), array.at(i, 2));
  return result;
}

void add_node(const py::handle& pickle, Embedded_graph& result)
{
  const py::tuple fields = fields_of(pickle, 5);
  const auto point = fields[3].cast<std::array<double, 3>>();
  SMF::Reeb_node<Point> node;
  node.id = num_vertices(result.graph);
  node.kind = to_enumeration(fields[0], SMF::Node_kind::BOUNDARY);
  node.genus = fields[1].cast<std::size_t>();
  node.pole = fields[2].cast<int>();
  node.point = Point(point[0], point[1], point[2]);
  node.radius = fields[4].cast<double>();
  result.embedding.node_points.push_back(node.point);
  result.embedding.node_radii.push_back(node.radius);
  add_vertex(node, result.graph);
}

void add_arc(const py::handle& pickle, Embedded_graph& result)
{
  const py::tuple fields = fields_of(pickle, 11);
  const auto first = fields[0].cast<std::size_t>(), last = fields[1].cast<std::size_t>();
  SMF::Reeb_arc<Point> arc;
  arc.loop = fields[2].cast<std::size_t>();
  arc.component = to_enumeration(fields[3], SMF::Component_kind::SPHERE);
  arc.height = fields[4].cast<double>();
  arc.flux = fields[5].cast<double>();
  arc.area = fields[6].cast<double>();
  arc.polyline = points_of_array(fields[7].cast<Doubles>());
  arc.radii = fields[8].cast<std::vector<double>>();
  const auto levels = fields[9].cast<std::vector<double>>();
  const auto lengths = fields[10].cast<std::vector<double>>();
  const std::size_t size = levels.size(), n = num_vertices(result.graph);
  if (first >= n || last >= n || lengths.size() != size || arc.polyline.size() != size + 2 ||
      arc.radii.size() != size + 2)
    refuse_pickle();
  result.embedding.arc_polylines.push_back(arc.polyline);
  result.embedding.levels.push_back(levels);
  result.embedding.leaf_lengths.push_back(lengths);
  result.embedding.leaf_radii.emplace_back(arc.radii.begin() + 1, arc.radii.end() - 1);
  add_edge(first, last, arc, result.graph);
}

} // namespace

py::tuple pickled(const Embedded_graph& embedded)
{
  return py::make_tuple(pickled_nodes(embedded.graph), pickled_arcs(embedded));
}

std::shared_ptr<Embedded_graph> unpickled(const py::tuple& state)
{
  const py::tuple lists = fields_of(state, 2);
  auto result = std::make_shared<Embedded_graph>();
  for (const py::handle node : lists[0].cast<py::list>())
    add_node(node, *result);
  for (const py::handle arc : lists[1].cast<py::list>())
    add_arc(arc, *result);
  return result;
}

} // namespace smf_python
