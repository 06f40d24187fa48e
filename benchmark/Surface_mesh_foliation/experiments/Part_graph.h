// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_EXPERIMENTS_PART_GRAPH_H
#define SMF_EXPERIMENTS_PART_GRAPH_H

#include "Shapes.h"

#include <CGAL/Surface_mesh_foliation/Poles_and_loops.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace smf_experiments {

// A Reeb graph of any kind, with the arc of each face of the mesh. Nodes of degree 1 are of kind
// POLE, and their `pole` is the marked part in which they lie; so the package can match graphs.
struct Part_graph
{
  SMF::Reeb_graph<Point> graph;
  std::vector<int> arc_of_face;
  std::vector<double> values; // by node, of the function if there is one

  std::size_t number_of_nodes() const { return num_vertices(graph); }
  std::size_t number_of_arcs() const { return num_edges(graph); }
  std::size_t number_of_cycles() const { return number_of_arcs() + 1 - number_of_nodes(); }
  std::size_t largest_degree() const
  {
    std::size_t result = 0;
    for (const auto node : boost::make_iterator_range(vertices(graph)))
      result = (std::max)(result, static_cast<std::size_t>(degree(node, graph)));
    return result;
  }
};

std::vector<double> face_areas(const Mesh& mesh);

// as `SMF::reeb_graphs_are_isomorphic()`, so ends have to lie in the same parts
bool are_isomorphic(const Part_graph& first, const Part_graph& second);

// ===  Poles and loops

SMF::Poles_and_loops<Mesh> with_poles(const std::vector<Vertex>& poles);

// with those that a surface of genus 0 needs
std::vector<Vertex> found_poles(const Mesh& mesh);

// of `SMF::canonical_loops()`, by its named parameters
struct Canonical_options
{
  bool show_handles = true;
};

SMF::Poles_and_loops<Mesh> with_canonical_loops(const Mesh& mesh,
                                                const std::vector<Vertex>& poles,
                                                const Canonical_options& options = {});

struct Loops_and_moduli
{
  SMF::Poles_and_loops<Mesh> loops;
  std::vector<double> moduli; // by loop; 0 for the loops of poles, which have none
};

Loops_and_moduli canonical_loops_and_moduli(const Mesh& mesh,
                                            const std::vector<Vertex>& poles,
                                            const Canonical_options& options = {});

// ===  Graphs

struct Named_graph
{
  std::string name;
  double persistence; // 0 for foliations
  Part_graph graph;

  bool is_of_foliation() const { return name.rfind("ours", 0) == 0; }
};

// Extrema that are less persistent than a share of the range of the function are left out. A face
// belongs to the arc of the vertex in its middle.
std::vector<Named_graph> graphs_of_functions(const Mesh& mesh,
                                             int up,
                                             const std::vector<Vertex>& poles,
                                             const std::vector<double>& persistences,
                                             const std::vector<int>& part_of_vertex);

Part_graph graph_of_foliation(const Mesh& mesh,
                              const SMF::Poles_and_loops<Mesh>& input,
                              const std::vector<int>& part_of_vertex);

// with the given poles alone, with canonical loops, and with poles that are found and canonical
// loops
std::vector<Named_graph> graphs_of_foliations(const Mesh& mesh,
                                              const std::vector<Vertex>& poles,
                                              const std::vector<int>& part_of_vertex);

// With the tips as poles and a loop that was drawn by hand, on the shape or a pose of it: one graph
// if the examples have such a loop, for it is on one of CGAL's meshes, or none.
std::vector<Named_graph> graphs_with_loop_by_hand(const Shape& shape, const Mesh& pose);

// of functions and of foliations, without loops drawn by hand
std::vector<Named_graph> all_graphs(const Mesh& mesh,
                                    int up,
                                    const std::vector<Vertex>& poles,
                                    const std::vector<double>& persistences,
                                    const std::vector<int>& part_of_vertex);

} // namespace smf_experiments

#endif // SMF_EXPERIMENTS_PART_GRAPH_H
