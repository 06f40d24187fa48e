// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Calls all that is in the compiled library, and prints the results in full.

#include <CGAL/Surface_mesh_foliation.h>

// (not called, but to be compiled in both ways)
#include <CGAL/Surface_mesh_foliation/canonical_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/feature_poles.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_symmetries.h>
#include <CGAL/Surface_mesh_foliation/repair.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/range/iterator_range.hpp>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace SMF = CGAL::Surface_mesh_foliation;

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Graph = SMF::Reeb_graph<Point>;

constexpr int around = 40, across = 16;

// a torus with a thick and a thin side, large enough for coarser meshes to begin with
void write_torus(const std::string& file_name)
{
  std::ofstream output(file_name);
  output << "OFF\n" << around * across << ' ' << 2 * around * across << " 0\n";
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j)
    {
      const double u = 2 * CGAL_PI * i / around, v = 2 * CGAL_PI * j / across;
      const double radius = 0.6 + 0.3 * std::cos(u);
      output << (2 + radius * std::cos(v)) * std::cos(u) << ' '
             << (2 + radius * std::cos(v)) * std::sin(u) << ' ' << radius * std::sin(v) << '\n';
    }
  const auto corner = [&](int i, int j) { return i % around * across + j % across; };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j)
      output << "3 " << corner(i, j) << ' ' << corner(i + 1, j) << ' ' << corner(i + 1, j + 1)
             << "\n3 " << corner(i, j) << ' ' << corner(i + 1, j + 1) << ' ' << corner(i, j + 1)
             << '\n';
}

void print(const Graph& graph)
{
  for (const auto v : boost::make_iterator_range(vertices(graph)))
    std::cout << SMF::name(graph[v].kind) << ' ' << graph[v].point << '\n';
  for (const auto& e : boost::make_iterator_range(edges(graph)))
  {
    std::cout << source(e, graph) << ' ' << target(e, graph) << ' ' << graph[e].flux << ' '
              << graph[e].area;
    for (const Point& p : graph[e].polyline)
      std::cout << ' ' << p;
    std::cout << '\n';
  }
}

int main()
{
  std::cout.precision(17);
  const std::string file_name = "torus.off";
  write_torus(file_name);
  Mesh mesh;
  SMF::read_triangle_mesh(file_name, mesh);
  std::cout << SMF::read_polygon_soup(file_name).polygons.size() << " faces\n";

  SMF::Poles_and_loops<Mesh> two_poles, three_poles;
  for (const int v : {0, around / 2 * across + 3})
  {
    two_poles.add_pole(Mesh::Vertex_index(v));
    three_poles.add_pole(Mesh::Vertex_index(v));
  }
  three_poles.add_pole(Mesh::Vertex_index(around / 4 * across + 8));
  std::cout << SMF::propose_loops(mesh, two_poles) << " loops, "
            << SMF::propose_loops(mesh, three_poles) << " loops\n";
  Graph graph;
  const SMF::Measured_foliation<Mesh> foliation = SMF::foliation_reeb_graph(mesh, two_poles, graph);
  print(graph);

  const SMF::Loop_system<Mesh> system(mesh, three_poles);
  SMF::Foliation_solver<Mesh> solver;
  solver.solve(foliation.system());
  Graph of_newton, of_whitehead;
  SMF::reeb_graph(solver.solve(system), of_newton);
  print(of_newton);
  SMF::reeb_graph(SMF::whitehead_foliation(system), of_whitehead);
  std::cout << SMF::reeb_graphs_are_isomorphic(graph, of_newton)
            << SMF::match_reeb_graphs(of_newton, of_whitehead).has_value() << " matches\n";

  const auto height = mesh.add_property_map<Mesh::Vertex_index, double>("v:height").first;
  for (const auto v : vertices(mesh))
    height[v] = mesh.point(v).y();
  SMF::Scalar_reeb_graph<Mesh> of_height;
  SMF::reeb_graph_of_function(mesh, height, of_height);
  std::cout << num_vertices(of_height) << " nodes of the height\n";
  std::vector<std::vector<Mesh::Vertex_index>> lines;
  SMF::detect_feature_lines(mesh, std::back_inserter(lines));
  std::cout << lines.size() << " blades\n";
  return EXIT_SUCCESS;
}
