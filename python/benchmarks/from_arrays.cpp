// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// from_arrays FILE: reads points, triangles and poles, and for each line of the standard input,
// computes the foliation from these arrays, with all that measure_overhead.py asks for, and prints
// how many seconds of processor time that took.

#include <CGAL/Surface_mesh_foliation/IO/read_triangle_mesh.h>
#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>
#include <CGAL/Surface_mesh_foliation/Poles_and_loops.h>
#include <CGAL/Surface_mesh_foliation/components.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
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

struct Arrays
{
  std::vector<double> coordinates;
  std::vector<std::int64_t> corners, poles;
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
Arrays read(std::istream& stream)
{
  Arrays result;
  const auto sizes = read_numbers<std::int64_t>(stream, 3);
  result.coordinates = read_numbers<double>(stream, 3 * sizes[0]);
  result.corners = read_numbers<std::int64_t>(stream, 3 * sizes[1]);
  result.poles = read_numbers<std::int64_t>(stream, sizes[2]);
  return result;
}

SMF::Triangle_soup soup_of(const Arrays& arrays)
{
  const auto corner = [&](std::size_t i) { return static_cast<std::size_t>(arrays.corners[i]); };
  const std::vector<double>& x = arrays.coordinates;
  SMF::Triangle_soup result;
  result.points.reserve(x.size() / 3);
  for (std::size_t i = 0; i < x.size(); i += 3)
    result.points.push_back({x[i], x[i + 1], x[i + 2]});
  result.triangles.reserve(arrays.corners.size() / 3);
  for (std::size_t i = 0; i < arrays.corners.size(); i += 3)
    result.triangles.push_back({corner(i), corner(i + 1), corner(i + 2)});
  return result;
}

// Returns something that depends on all results.
double compute(const Arrays& arrays)
{
  Mesh mesh;
  SMF::triangle_soup_to_triangle_mesh(soup_of(arrays), mesh,
                                      SMF::parameters::allow_openings(true).allow_parts(true));
  SMF::Poles_and_loops<Mesh> poles;
  for (const std::int64_t pole : arrays.poles)
    poles.add_pole(Mesh::Vertex_index(static_cast<Mesh::size_type>(pole)));
  // (the solver is gone before the results are read, as in Python)
  const Foliation foliation = SMF::harmonic_foliation(SMF::Loop_system<Mesh>(mesh, poles));

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
  const Arrays arrays = file ? read(file) : Arrays();
  if (!file)
  {
    std::cerr << "from_arrays FILE: the file cannot be read\n";
    return EXIT_FAILURE;
  }
  double sum = 0;
  for (std::string line; std::getline(std::cin, line);)
  {
    const std::clock_t begin = std::clock();
    sum += compute(arrays);
    std::cout << static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC << std::endl;
  }
  return sum >= 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
