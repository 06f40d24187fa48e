// What the main program computes.

#ifndef SMF_EXAMPLES_MAIN_PROGRAM_RESULT_H
#define SMF_EXAMPLES_MAIN_PROGRAM_RESULT_H

#include <CGAL/Surface_mesh_foliation.h>
#include <CGAL/Surface_mesh_foliation/canonical_loops.h>
#include <CGAL/Surface_mesh_foliation/repair.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace main_program {

namespace SMF = CGAL::Surface_mesh_foliation;

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;
using Part_mesh = SMF::Mesh_part<Mesh>;
using Part_input = SMF::Poles_and_loops<Part_mesh>;
using Part_foliation = SMF::Measured_foliation<Part_mesh>;
using Graph = SMF::Reeb_graph<Point_3>;

// One connected component of the mesh.
struct Part
{
  Part_input input;
  std::size_t number_of_given = 0; // poles and loops that options gave
  std::size_t first_found_loop = 0, end_of_found_loops = 0;
  std::size_t number_of_found_poles = 0;
  std::size_t number_of_ends = 0;
  std::map<std::size_t, double> significances; // of poles found, by loop id
  // those of the loops found that are canonical: all or none
  std::vector<SMF::Canonical_loop<Part_mesh>> canonical_loops;
  std::optional<Part_foliation> foliation;
  std::vector<SMF::Singularity<Part_mesh>> singularities;
  SMF::Reeb_graph_embedding<Point_3> embedding;
  std::string error; // why it has no graph
};

// Everything that the program computes, and how many seconds each stage took. The foliations refer
// to the mesh and its parts, so a result stays where it is.
struct Result
{
  Mesh mesh;
  Mesh::Property_map<Mesh::Face_index, bool> is_filled;
  std::size_t number_of_vertices = 0, number_of_faces = 0; // without those of filled openings
  std::size_t number_of_filled_openings = 0;
  std::size_t number_of_all_parts = 0; // of the mesh
  // Vertices have the numbers of the file; those that are new come behind.
  std::vector<Vertex> numbered_vertices;
  std::vector<std::size_t> number_of_vertex;
  std::optional<SMF::Repaired_soup> repaired;
  std::vector<Part_mesh> part_meshes;
  std::vector<Part> parts;
  std::string detector; // of poles; empty if none ran
  Graph graph;
  std::vector<std::pair<std::string, double>> seconds;
};

inline std::size_t number_of_loops(const Result& result)
{
  std::size_t number = 0;
  for (const Part& part : result.parts)
    number += part.input.size();
  return number;
}

inline bool has_several_parts(const Result& result)
{
  return result.parts.size() > 1;
}

} // namespace main_program

#endif // SMF_EXAMPLES_MAIN_PROGRAM_RESULT_H
