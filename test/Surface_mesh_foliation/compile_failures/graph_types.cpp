// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Does not compile: each line marked as refused has a graph type without parallel edges.

#include <CGAL/Surface_mesh_foliation.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/graph/adjacency_list.hpp>

namespace SMF = CGAL::Surface_mesh_foliation;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
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
