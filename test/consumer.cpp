// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The program of the projects consumer_*: uses the package as they got it.

#include <CGAL/Surface_mesh_foliation.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#ifndef CGAL_EIGEN3_ENABLED
#error "the package did not bring Eigen along"
#endif

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

int main()
{
  Mesh mesh;
  CGAL::make_tetrahedron(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1), mesh);
  const std::vector<Mesh::Vertex_index> poles(vertices(mesh).begin(), vertices(mesh).end());
  CGAL::Surface_mesh_foliation::Reeb_graph<Point> graph;
  CGAL::Surface_mesh_foliation::foliation_reeb_graph(mesh, poles, graph);
  const std::string version = CGAL_SURFACE_MESH_FOLIATION_VERSION;
  std::cout << "Surface_mesh_foliation " << version << ": a graph of " << num_vertices(graph)
            << " nodes and " << num_edges(graph) << " arcs" << std::endl;
  const bool is_right = num_vertices(graph) == 5 && num_edges(graph) == 4;
  return is_right && version == EXPECTED_VERSION ? EXIT_SUCCESS : EXIT_FAILURE;
}
