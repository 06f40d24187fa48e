// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Does not compile: each line marked as refused uses a named parameter that its function does not
// know. The values are of different types so that each line is an error of its own.

#include <CGAL/Surface_mesh_foliation.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/property_map.h>

#include <iterator>
#include <string>
#include <vector>

namespace SMF = CGAL::Surface_mesh_foliation;
namespace np = CGAL::parameters;
namespace smf_np = CGAL::Surface_mesh_foliation::parameters;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
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
