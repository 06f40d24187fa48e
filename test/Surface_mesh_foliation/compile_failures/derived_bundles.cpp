// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Does not compile: each line marked as refused has a graph whose bundles look like nodes or arcs
// but cannot be filled.

#include <CGAL/Surface_mesh_foliation/reeb_graph.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/graph/adjacency_list.hpp>

#include <string>

namespace SMF = CGAL::Surface_mesh_foliation;

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Other_point = CGAL::Simple_cartesian<float>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
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
