// Finds the rims of an elephant's ears and makes them line poles.

#include <CGAL/Surface_mesh_foliation/IO/read_triangle_mesh.h>
#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/Poles_and_loops.h>
#include <CGAL/Surface_mesh_foliation/feature_lines.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace SMF = CGAL::Surface_mesh_foliation;

using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;

// Arguments: a mesh and its other poles. By default the elephant's four feet and its trunk.
int main(int argc, char* argv[])
try
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  SMF::read_triangle_mesh(file_name, mesh);
  std::vector<Vertex> poles;
  if (argc == 1)
    poles = {Vertex(2759), Vertex(2555), Vertex(2047), Vertex(1671), Vertex(2279)};
  for (int i = 2; i < argc; ++i)
    poles.emplace_back(std::stoi(argv[i]));

  std::vector<std::vector<Vertex>> lines;
  SMF::detect_feature_lines(mesh, std::back_inserter(lines));

  SMF::Poles_and_loops<Mesh> input;
  for (const std::vector<Vertex>& line : lines)
  {
    std::cout << "line from " << mesh.point(line.front()) << " to " << mesh.point(line.back())
              << ", vertices ";
    for (const Vertex v : line)
      std::cout << static_cast<int>(v) << (v == line.back() ? "\n" : ",");
    input.add_line_pole(line);
  }
  for (const Vertex v : poles)
    input.add_pole(v);

  const SMF::Loop_system<Mesh> system(mesh, input);
  std::cout << "a Reeb graph with " << system.number_of_nodes() << " nodes and "
            << system.number_of_arcs() << " arcs" << std::endl;
  return EXIT_SUCCESS;
}
catch (const std::exception& exception)
{
  std::cerr << exception.what() << std::endl;
  return EXIT_FAILURE;
}
