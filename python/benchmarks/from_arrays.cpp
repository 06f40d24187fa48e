// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// from_arrays FILE: reads points, triangles and poles, and for each line of the standard input,
// computes the foliation from these arrays, with all that measure_overhead.py asks for, and prints
// how many seconds of processor time that took.

#include <CGAL/Surface_mesh_foliation/Foliation_solver.h>
#include <CGAL/Surface_mesh_foliation/IO/read_triangle_mesh.h>
#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>
#include <CGAL/Surface_mesh_foliation/Poles_and_loops.h>
#include <CGAL/Surface_mesh_foliation/components.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_embedding.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Foliation = SMF::Measured_foliation<Mesh>;

struct Input
{
  SMF::Triangle_soup soup;
  std::vector<Mesh::Vertex_index> poles;
};

template <class T>
std::vector<T> read_numbers(std::istream& stream, std::int64_t number)
{
  std::vector<T> result(static_cast<std::size_t>(number));
  stream.read(reinterpret_cast<char*>(result.data()),
              static_cast<std::streamsize>(result.size() * sizeof(T)));
  return result;
}

// the numbers of points, triangles and poles, then each of them
Input read(std::istream& stream)
{
  Input result;
  const auto sizes = read_numbers<std::int64_t>(stream, 3);
  const auto coordinates = read_numbers<double>(stream, 3 * sizes[0]);
  const auto corners = read_numbers<std::int64_t>(stream, 3 * sizes[1]);
  for (std::size_t i = 0; i < coordinates.size(); i += 3)
    result.soup.points.push_back({coordinates[i], coordinates[i + 1], coordinates[i + 2]});
  for (std::size_t i = 0; i < corners.size(); i += 3)
    result.soup.triangles.push_back({static_cast<std::size_t>(corners[i]),
                                     static_cast<std::size_t>(corners[i + 1]),
                                     static_cast<std::size_t>(corners[i + 2])});
  for (const std::int64_t pole : read_numbers<std::int64_t>(stream, sizes[2]))
    result.poles.emplace_back(static_cast<Mesh::size_type>(pole));
  return result;
}

// Returns something that depends on all results.
double compute(const Input& input)
{
  Mesh mesh;
  SMF::triangle_soup_to_triangle_mesh(input.soup, mesh,
                                      SMF::parameters::allow_openings(true).allow_parts(true));
  SMF::Poles_and_loops<Mesh> poles;
  for (const auto pole : input.poles)
    poles.add_pole(pole);
  SMF::Foliation_solver<Mesh> solver;
  const Foliation foliation = solver.solve(SMF::Loop_system<Mesh>(mesh, poles));

  const auto embedding = SMF::reeb_graph_embedding(
    foliation, SMF::parameters::number_of_samples(20).max_chord_deviation(0.1));
  SMF::Reeb_graph<Point> graph;
  SMF::reeb_graph(foliation, graph, embedding);
  std::vector<std::size_t> arcs(mesh.number_of_faces());
  SMF::face_segmentation(
    foliation, boost::make_iterator_property_map(arcs.begin(), get(boost::face_index, mesh)));
  double sum = static_cast<double>(arcs.back() + num_edges(graph));
  for (const auto v : mesh.vertices())
    sum += foliation.parameter(v) + static_cast<double>(foliation.cell(v).index);
  for (const auto e : mesh.edges())
    sum += foliation.edge_value(e);
  return sum;
}

} // namespace

int main(int argc, char** argv)
{
  std::ifstream file(argc == 2 ? argv[1] : "", std::ios::binary);
  const Input input = file ? read(file) : Input();
  if (!file)
  {
    std::cerr << "from_arrays FILE: the file cannot be read\n";
    return EXIT_FAILURE;
  }
  double sum = 0;
  for (std::string line; std::getline(std::cin, line);)
  {
    const std::clock_t begin = std::clock();
    sum += compute(input);
    std::cout << static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC << std::endl;
  }
  return sum >= 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
