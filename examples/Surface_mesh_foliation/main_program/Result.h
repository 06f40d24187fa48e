// What the main program computes.

#ifndef SMF_EXAMPLES_MAIN_PROGRAM_RESULT_H
#define SMF_EXAMPLES_MAIN_PROGRAM_RESULT_H

#include <CGAL/Surface_mesh_foliation.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace main_program {

namespace SMF = CGAL::Surface_mesh_foliation;

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Foliation = SMF::Measured_foliation<Mesh>;
using Graph = SMF::Reeb_graph<Point_3>;

// Everything that the program computes, and how many seconds each stage took.
struct Result
{
  Mesh mesh;
  SMF::Poles_and_loops<Mesh> input;
  std::size_t number_of_vertices = 0, number_of_faces = 0; // of the file
  std::size_t number_of_ends = 0, number_of_filled_openings = 0;
  std::vector<std::vector<std::size_t>> poles; // vertex indices
  std::optional<Foliation> foliation;
  std::vector<SMF::Singularity<Mesh>> singularities;
  Mesh components;
  SMF::Reeb_graph_embedding<Point_3> embedding;
  Graph graph;
  std::vector<std::pair<std::string, double>> seconds;
};

} // namespace main_program

#endif // SMF_EXAMPLES_MAIN_PROGRAM_RESULT_H
