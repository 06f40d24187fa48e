// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Part_graph.h"

#include "Functions.h"

#include <CGAL/Surface_mesh_foliation/IO/read_loops.h>
#include <CGAL/Surface_mesh_foliation/add_missing_poles.h>
#include <CGAL/Surface_mesh_foliation/canonical_loops.h>
#include <CGAL/Surface_mesh_foliation/components.h>
#include <CGAL/Surface_mesh_foliation/feature_poles.h>
#include <CGAL/Surface_mesh_foliation/foliation_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_matching.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_of_function.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace smf_experiments {

std::vector<double> face_areas(const Mesh& mesh)
{
  std::vector<double> result;
  for (const Face f : faces(mesh))
    result.push_back(CGAL::Polygon_mesh_processing::face_area(f, mesh));
  return result;
}

bool are_isomorphic(const Part_graph& first, const Part_graph& second)
{
  return SMF::reeb_graphs_are_isomorphic(first.graph, second.graph);
}

// ===  Of functions

namespace {

using Scalar_graph = SMF::Scalar_reeb_graph<Mesh>;
using Scalar_arc = boost::graph_traits<Scalar_graph>::edge_descriptor;

// the nodes and arcs; returns the numbers of the arcs
std::map<const SMF::Scalar_reeb_arc*, int> copy_nodes_and_arcs(
  const Mesh& mesh,
  const Scalar_graph& scalar_graph,
  const std::vector<int>& part_of_vertex,
  Part_graph& result)
{
  for (const auto node : boost::make_iterator_range(vertices(scalar_graph)))
  {
    const Vertex v = scalar_graph[node].vertex;
    auto& added = result.graph[add_vertex(result.graph)];
    added.point = mesh.point(v);
    result.values.push_back(scalar_graph[node].value);
    if (degree(node, scalar_graph) == 1)
    {
      added.kind = SMF::Node_kind::POLE;
      added.pole = part_of_vertex[v.idx()];
    }
  }
  std::map<const SMF::Scalar_reeb_arc*, int> numbers;
  for (const Scalar_arc& arc : boost::make_iterator_range(edges(scalar_graph)))
  {
    numbers.emplace(&scalar_graph[arc], static_cast<int>(numbers.size()));
    add_edge(source(arc, scalar_graph), target(arc, scalar_graph), result.graph);
  }
  return numbers;
}

// the corner of a face in the middle
Vertex middle_vertex(const Mesh& mesh, const Values& values, Face f)
{
  std::array<Vertex, 3> corner = corners(mesh, f);
  std::sort(corner.begin(), corner.end(),
            [&](Vertex u, Vertex v) { return values[u.idx()] < values[v.idx()]; });
  return corner[1];
}

// Areas of arcs, and polylines through the centroids of strips between equally spaced values.
void measure_arcs(const Mesh& mesh, const Values& values, Part_graph& result)
{
  constexpr int number_of_strips = 10;
  struct Strip
  {
    double area = 0;
    Kernel::Vector_3 sum = CGAL::NULL_VECTOR;
  };
  std::vector<std::array<Strip, number_of_strips>> strips(result.number_of_arcs());
  std::vector<std::array<double, 2>> ranges; // by arc
  for (const auto& arc : boost::make_iterator_range(edges(result.graph)))
    ranges.push_back(
      {result.values[source(arc, result.graph)], result.values[target(arc, result.graph)]});
  for (const Face f : faces(mesh))
  {
    const int arc = result.arc_of_face[f.idx()];
    const auto [lower, upper] = ranges[arc];
    const double value = values[middle_vertex(mesh, values, f).idx()];
    const double position = upper > lower ? (value - lower) / (upper - lower) : 0;
    Strip& strip =
      strips[arc]
            [static_cast<int>(std::clamp(position * number_of_strips, 0., number_of_strips - 1.))];
    const double area = CGAL::Polygon_mesh_processing::face_area(f, mesh);
    strip.area += area;
    for (const Vertex v : corners(mesh, f))
      strip.sum = strip.sum + (mesh.point(v) - CGAL::ORIGIN) * (area / 3);
  }
  std::size_t next = 0;
  for (const auto& e : boost::make_iterator_range(edges(result.graph)))
  {
    auto& arc = result.graph[e];
    arc.polyline.push_back(result.graph[source(e, result.graph)].point);
    for (const Strip& strip : strips[next++])
      if (strip.area > 0)
      {
        arc.area += strip.area;
        arc.polyline.push_back(CGAL::ORIGIN + strip.sum / strip.area);
      }
    arc.polyline.push_back(result.graph[target(e, result.graph)].point);
    arc.radii.assign(arc.polyline.size(), 0);
  }
}

} // namespace

Part_graph graph_of_function(const Mesh& mesh,
                             const Values& values,
                             double persistence,
                             const std::vector<int>& part_of_vertex)
{
  const auto [least, largest] = std::minmax_element(values.begin(), values.end());
  Scalar_graph scalar_graph;
  std::vector<Scalar_arc> arc_of_vertex(values.size());
  const auto index = get(CGAL::vertex_index, mesh);
  SMF::reeb_graph_of_function(
    mesh, boost::make_iterator_property_map(values.begin(), index), scalar_graph,
    SMF::parameters::persistence(persistence * (*largest - *least))
      .vertex_to_arc_map(boost::make_iterator_property_map(arc_of_vertex.begin(), index)));

  Part_graph result;
  const auto numbers = copy_nodes_and_arcs(mesh, scalar_graph, part_of_vertex, result);
  for (const Face f : faces(mesh))
    result.arc_of_face.push_back(
      numbers.at(&scalar_graph[arc_of_vertex[middle_vertex(mesh, values, f).idx()]]));
  measure_arcs(mesh, values, result);
  return result;
}

// ===  Of foliations

SMF::Poles_and_loops<Mesh> with_poles(const std::vector<Vertex>& poles)
{
  SMF::Poles_and_loops<Mesh> result;
  for (const Vertex pole : poles)
    result.add_pole(pole);
  return result;
}

std::vector<Vertex> found_poles(const Mesh& mesh)
{
  std::vector<Vertex> poles;
  SMF::detect_feature_poles(mesh, std::back_inserter(poles));
  SMF::Poles_and_loops<Mesh> all = with_poles(poles);
  SMF::add_missing_poles(mesh, all);
  poles.clear();
  for (const auto& entry : all.entries())
    poles.push_back(entry.pole.at(0));
  return poles;
}

SMF::Poles_and_loops<Mesh> with_canonical_loops(const Mesh& mesh,
                                                const std::vector<Vertex>& poles,
                                                const Canonical_options& options)
{
  return canonical_loops_and_moduli(mesh, poles, options).loops;
}

Loops_and_moduli canonical_loops_and_moduli(const Mesh& mesh,
                                            const std::vector<Vertex>& poles,
                                            const Canonical_options& options)
{
  Loops_and_moduli result{with_poles(poles), std::vector<double>(poles.size(), 0)};
  const auto added =
    SMF::canonical_loops(mesh, result.loops, SMF::parameters::show_handles(options.show_handles));
  for (const auto& loop : added)
    result.moduli.push_back(loop.modulus);
  return result;
}

Part_graph graph_of_foliation(const Mesh& mesh,
                              const SMF::Poles_and_loops<Mesh>& input,
                              const std::vector<int>& part_of_vertex)
{
  Part_graph result;
  const auto foliation = SMF::foliation_reeb_graph(mesh, input, result.graph);
  for (const auto node : boost::make_iterator_range(vertices(result.graph)))
  {
    int& pole = result.graph[node].pole;
    if (pole >= 0)
      pole = part_of_vertex[foliation.system().pole_vertices(pole)[0].idx()];
  }
  std::map<std::size_t, int> number;
  for (const auto& arc : boost::make_iterator_range(edges(result.graph)))
    number.emplace(result.graph[arc].loop, static_cast<int>(number.size()));
  std::vector<std::size_t> loop_of_face(num_faces(mesh));
  SMF::face_segmentation(foliation, boost::make_iterator_property_map(loop_of_face.begin(),
                                                                      get(CGAL::face_index, mesh)));
  for (const std::size_t loop : loop_of_face)
    result.arc_of_face.push_back(number.at(loop));
  return result;
}

// ===  All kinds

std::vector<Named_graph> graphs_of_functions(const Mesh& mesh,
                                             int up,
                                             const std::vector<Vertex>& poles,
                                             const std::vector<double>& persistences,
                                             const std::vector<int>& part_of_vertex)
{
  std::vector<Named_graph> result;
  for (const Named_function& function : all_functions(mesh, up, poles))
    for (const double persistence : persistences)
      result.push_back({function.name, persistence,
                        graph_of_function(mesh, function.values, persistence, part_of_vertex)});
  return result;
}

std::vector<Named_graph> graphs_of_foliations(const Mesh& mesh,
                                              const std::vector<Vertex>& poles,
                                              const std::vector<int>& part_of_vertex)
{
  const std::vector<Vertex> found = found_poles(mesh);
  const auto graph = [&](const SMF::Poles_and_loops<Mesh>& input) {
    return graph_of_foliation(mesh, input, part_of_vertex);
  };
  return {{"ours (star)", 0, graph(with_poles(poles))},
          {"ours (canonical loops)", 0, graph(with_canonical_loops(mesh, poles))},
          {"ours (all found)", 0, graph(with_canonical_loops(mesh, found))}};
}

std::vector<Named_graph> graphs_with_loop_by_hand(const Shape& shape, const Mesh& pose)
{
  const std::string path = SMF_LOOPS_DIR "/" + shape.name + ".loops";
  if (!std::ifstream(path))
    return {};
  SMF::Poles_and_loops<Mesh> input = with_poles(shape.tips());
  SMF::read_loops(path, pose, input);
  return {{"ours (loop by hand)", 0, graph_of_foliation(pose, input, shape.part_of_vertex)}};
}

std::vector<Named_graph> all_graphs(const Mesh& mesh,
                                    int up,
                                    const std::vector<Vertex>& poles,
                                    const std::vector<double>& persistences,
                                    const std::vector<int>& part_of_vertex)
{
  std::vector<Named_graph> result =
    graphs_of_functions(mesh, up, poles, persistences, part_of_vertex);
  for (Named_graph& graph : graphs_of_foliations(mesh, poles, part_of_vertex))
    result.push_back(std::move(graph));
  return result;
}

} // namespace smf_experiments
