// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Does not compile: each line marked as refused fails a static assertion with the message that
// stands above its namespace. (One file, since the headers take longer to compile than the rest.)

#include <CGAL/Surface_mesh_foliation.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/property_map.h>

#include <boost/graph/adjacency_list.hpp>

#include <iterator>
#include <string>
#include <vector>

namespace SMF = CGAL::Surface_mesh_foliation;
namespace np = CGAL::parameters;
namespace smf_np = CGAL::Surface_mesh_foliation::parameters;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

// Named parameters that the function does not know. The values are of different types so that each
// line is an error of its own.
// message: does not know one of the named parameters
namespace unknown_parameters {

using Graph = SMF::Reeb_graph<Mesh::Point>;

void misuse(Mesh& mesh,
            Graph& graph,
            const SMF::Poles_and_loops<Mesh>& input,
            SMF::Poles_and_loops<Mesh>& loops,
            const SMF::Loop_system<Mesh>& system,
            const SMF::Measured_foliation<Mesh>& foliation,
            const SMF::Reeb_graph_embedding<Mesh::Point>& embedding,
            const SMF::Triangle_soup& soup,
            const Mesh::Property_map<Mesh::Vertex_index, double>& function)
{
  const Mesh::Vertex_index v(0);
  std::vector<SMF::Loop<Mesh>> out;
  const auto points = mesh.points();
  SMF::Loop_system<Mesh>(mesh, input, smf_np::tolerance(1.)); // refused
  SMF::validate(mesh, input, smf_np::tolerance(1.f));         // refused
  SMF::plane_section_loops(mesh, {0, 0, 1, 0}, std::back_inserter(out),
                           smf_np::tolerance(short(1)));                       // refused
  SMF::plane_section_loop(mesh, {0, 0, 1, 0}, v, smf_np::tolerance(1L));       // refused
  SMF::read_loops("file", mesh, loops, smf_np::tolerance(1u));                 // refused
  SMF::triangle_soup_to_triangle_mesh(soup, mesh, smf_np::tolerance(1UL));     // refused
  SMF::read_triangle_mesh("file", mesh, smf_np::tolerance(1LL));               // refused
  SMF::harmonic_foliation(system, np::vertex_point_map(points));               // refused
  SMF::harmonic_foliation(system, np::random_seed(1).verbose(true));           // refused
  SMF::harmonic_foliation(system, smf_np::tolerance(1.).number_of_samples(1)); // refused
  SMF::harmonic_foliation(system,
                          smf_np::combine(smf_np::tolerance(1.), np::verbose(true)));    // refused
  SMF::surface_components(foliation, mesh, smf_np::number_of_samples(1));                // refused
  SMF::subdivide_saddle_faces(foliation, mesh, smf_np::number_of_samples(1.f));          // refused
  const SMF::Component_coordinates<Mesh> coordinates(foliation, smf_np::tolerance('1')); // refused
  coordinates.chart(0, mesh, smf_np::tolerance(true));                                   // refused
  SMF::reeb_graph_embedding(foliation, smf_np::tolerance(1.));                           // refused
  SMF::reeb_graph(foliation, graph, embedding, smf_np::number_of_samples(1.));           // refused
  SMF::reeb_graph(foliation, graph, smf_np::tolerance(1.));                              // refused
  SMF::foliation_reeb_graph(mesh, input, graph, np::face_index_map(0));                  // refused
  SMF::propose_loops(mesh, loops, smf_np::persistence(1.));                              // refused
  SMF::reeb_graphs_are_isomorphic(graph, graph, smf_np::arc_map(1));                     // refused
  SMF::match_reeb_graphs(graph, graph, smf_np::tolerance(1.));                           // refused
  SMF::match_reeb_graphs(graph, graph, np::default_values(),
                         smf_np::use_pole_labels(true)); // refused
  const CGAL::Constant_property_map<Mesh::Edge_index, double> values(1);
  SMF::integrate_foliation(mesh, values, smf_np::number_of_samples(1L)); // refused
  SMF::Scalar_reeb_graph<Mesh> scalar_graph;
  SMF::reeb_graph_of_function(mesh, function, scalar_graph, smf_np::weights(1)); // refused
}

} // namespace unknown_parameters

// Threads without TBB.
// message: CGAL::Parallel_tag needs TBB
namespace parallel_tag {

void misuse(const SMF::Loop_system<Mesh>& system)
{
  SMF::harmonic_foliation<CGAL::Parallel_if_available_tag>(system);
  SMF::harmonic_foliation<CGAL::Parallel_tag>(system); // refused
}

} // namespace parallel_tag

// Graph types without parallel edges.
// message: needs a graph type that allows parallel edges
namespace graph_types {

template <class Out_edges, class Directed>
using List = boost::adjacency_list<Out_edges, boost::vecS, Directed>;

void misuse(const SMF::Measured_foliation<Mesh>& foliation,
            const SMF::Reeb_graph_embedding<Mesh::Point>& embedding,
            const Mesh& mesh,
            const Mesh::Property_map<Mesh::Vertex_index, double>& function,
            List<boost::setS, boost::undirectedS>& set,
            List<boost::hash_setS, boost::directedS>& hash_set,
            List<boost::multisetS, boost::undirectedS>& multiset)
{
  SMF::reeb_graph(foliation, set, embedding);      // refused
  SMF::reeb_graph(foliation, hash_set, embedding); // refused
  SMF::reeb_graph(foliation, multiset, embedding);
  SMF::reeb_graph_of_function(mesh, function, set); // refused
  SMF::reeb_graph_of_function(mesh, function, multiset);
}

} // namespace graph_types

// Graphs whose bundles look like nodes or arcs but cannot be filled.
// message: cannot be assigned
namespace derived_bundles {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Other_point = CGAL::Simple_cartesian<float>::Point_3;
using Node = SMF::Reeb_node<Point>;
using Arc = SMF::Reeb_arc<Point>;
template <class Node_bundle, class Arc_bundle>
using Graph =
  boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Node_bundle, Arc_bundle>;

struct Derived_node : Node
{};
struct Private_node : private Node
{};
struct Twice_an_arc_1 : Arc
{};
struct Twice_an_arc_2 : Arc
{};
struct Twice_an_arc : Twice_an_arc_1, Twice_an_arc_2
{};
struct Other_arc : SMF::Reeb_arc<Other_point>
{};

void misuse(const SMF::Measured_foliation<Mesh>& foliation,
            const SMF::Reeb_graph_embedding<Point>& embedding,
            Graph<SMF::Reeb_node<Other_point>, Arc>& with_other_nodes,
            Graph<Derived_node, Other_arc>& with_other_arcs,
            Graph<Private_node, Arc>& with_private_nodes,
            Graph<Node, Twice_an_arc>& with_ambiguous_arcs,
            Graph<Derived_node, std::string>& with_strings)
{
  SMF::reeb_graph(foliation, with_other_nodes, embedding);    // refused
  SMF::reeb_graph(foliation, with_other_arcs, embedding);     // refused
  SMF::reeb_graph(foliation, with_private_nodes, embedding);  // refused
  SMF::reeb_graph(foliation, with_ambiguous_arcs, embedding); // refused
  SMF::reeb_graph(foliation, with_strings, embedding);
}

} // namespace derived_bundles
