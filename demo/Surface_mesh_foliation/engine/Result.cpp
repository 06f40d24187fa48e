// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Result.h"

#include "arrays.h"

#include <CGAL/Surface_mesh_foliation/IO/write_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/components.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_symmetries.h>
#include <CGAL/Surface_mesh_foliation/singularities.h>

#include <CGAL/centroid.h>

#include <boost/range/iterator_range.hpp>

#include <iterator>
#include <numeric>
#include <vector>

namespace smf_engine {

namespace {

struct Symmetry_classes
{
  std::vector<std::size_t> nodes, arcs;
};

// Every node and arc is a class by itself if sums of areas are too large for a number.
Symmetry_classes symmetry_classes(const Graph& graph)
{
  try
  {
    const auto symmetries = SMF::reeb_graph_symmetries(graph);
    return {symmetries.node_classes, symmetries.arc_classes};
  }
  catch (const SMF::Invalid_parameter_exception&)
  {
    Symmetry_classes result;
    result.nodes.resize(num_vertices(graph));
    result.arcs.resize(num_edges(graph));
    std::iota(result.nodes.begin(), result.nodes.end(), std::size_t(0));
    std::iota(result.arcs.begin(), result.arcs.end(), std::size_t(0));
    return result;
  }
}

void read_graph(const Graph& graph, const Loop_numbers& numbers, Result& result)
{
  const Symmetry_classes classes = symmetry_classes(graph);
  for (const auto v : boost::make_iterator_range(vertices(graph)))
  {
    Result_node node;
    node.id = graph[v].id;
    node.kind = SMF::name(graph[v].kind);
    node.pole = graph[v].pole < 0 ? -1 : numbers.pole(graph[v].pole);
    node.degree = degree(v, graph);
    node.point = graph[v].point;
    node.symmetry = classes.nodes[v];
    result.nodes.push_back(node);
  }
  for (const auto& e : boost::make_iterator_range(edges(graph)))
  {
    Result_arc arc;
    arc.id = graph[e].loop;
    arc.source = source(e, graph);
    arc.target = target(e, graph);
    arc.component = SMF::name(graph[e].component);
    arc.height = graph[e].height;
    arc.flux = graph[e].flux;
    arc.area = graph[e].area;
    arc.length = SMF::length(graph[e].polyline);
    arc.symmetry = classes.arcs[result.arcs.size()];
    arc.pole = numbers.pole_of_loop(arc.id);
    arc.loop = numbers.loop(arc.id);
    result.arcs.push_back(arc);
    Result_polyline polyline = {arc.id, {}, graph[e].radii};
    for (const Point& p : graph[e].polyline)
      append(p, polyline.points);
    result.skeleton.push_back(polyline);
  }
}

void read_components(const Foliation& foliation, Result& result)
{
  Mesh cut;
  auto label = cut.add_property_map<Face, std::size_t>("f:component", 0).first;
  SMF::surface_components(foliation, cut, SMF::parameters::face_component_map(label));
  result.part_positions = positions_of(cut);
  result.part_triangles = triangles_of(cut);
  result.part_labels.reserve(cut.number_of_faces());
  for (const Face f : cut.faces())
    result.part_labels.push_back(static_cast<Index>(label[f]));
}

void read_singularities(const Foliation& foliation, Result& result)
{
  const Mesh& mesh = foliation.mesh();
  std::vector<SMF::Singularity<Mesh>> all;
  SMF::singularities(foliation, std::back_inserter(all));
  for (const SMF::Singularity<Mesh>& singularity : all)
  {
    Point point;
    if (singularity.is_face)
    {
      const std::array<Vertex, 3> corners = corners_of(singularity.face, mesh);
      point =
        CGAL::centroid(mesh.point(corners[0]), mesh.point(corners[1]), mesh.point(corners[2]));
    }
    else
      point = mesh.point(singularity.vertex);
    result.singularities.push_back({point, singularity.index});
  }
}

} // namespace

void read_foliation(const Foliation& foliation,
                    const Graph& graph,
                    const Loop_numbers& numbers,
                    Result& result)
{
  const SMF::Foliation_statistics& statistics = foliation.statistics();
  result.is_certified = statistics.is_certified;
  result.energy = statistics.energy;
  result.optimality = statistics.optimality;
  result.number_of_iterations = statistics.number_of_iterations;
  read_graph(graph, numbers, result);
  read_components(foliation, result);
  read_singularities(foliation, result);
  for (const Edge e : foliation.mesh().edges())
    result.edge_values.push_back(foliation.edge_value(e));
}

} // namespace smf_engine
