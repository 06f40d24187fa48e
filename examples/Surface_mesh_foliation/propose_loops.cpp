// Finds loops around the handles of a mesh, with and without the small handles.

#include <CGAL/Surface_mesh_foliation.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

namespace SMF = CGAL::Surface_mesh_foliation;

using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

// Describes a loop system; no foliation is needed for that.
void print(const SMF::Loop_system<Mesh>& system)
{
  std::size_t genus = 0;
  for (std::size_t node = 0; node < system.number_of_nodes(); ++node)
    genus += system.genus(node);
  std::cout << system.number_of_arcs() << " arcs, "
            << system.number_of_arcs() + 1 - system.number_of_nodes()
            << " cycles, and nodes of total genus " << genus << '\n';
}

// Arguments: a mesh, the least length of a loop as a fraction of the bounding box's diagonal, and
// the vertices of poles.
int main(int argc, char* argv[])
try
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  const double least_length = argc > 2 ? std::stod(argv[2]) : 0.2;
  Mesh mesh;
  SMF::read_triangle_mesh(file_name, mesh);
  SMF::Poles_and_loops<Mesh> poles;
  for (int i = 3; i < argc; ++i)
    poles.add_pole(Mesh::Vertex_index(static_cast<Mesh::size_type>(std::stoul(argv[i]))));

  SMF::Poles_and_loops<Mesh> all = poles;
  SMF::propose_loops(mesh, all);
  print(SMF::Loop_system<Mesh>(mesh, all));

  SMF::Poles_and_loops<Mesh> large_ones = poles;
  SMF::propose_loops(mesh, large_ones, SMF::parameters::min_relative_loop_length(least_length));
  if (large_ones.size() > 0)
    print(SMF::Loop_system<Mesh>(mesh, large_ones));

  SMF::Reeb_graph<Point_3> graph;
  SMF::foliation_reeb_graph(mesh, all, graph);
  SMF::write_skeleton_ply("skeleton.ply", graph);
  return EXIT_SUCCESS;
}
catch (const std::exception& exception)
{
  std::cerr << exception.what() << std::endl;
  return EXIT_FAILURE;
}
