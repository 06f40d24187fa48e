// The canonical graph of a shape, its levels of detail and its symmetries, from the mesh and its
// poles alone.

#include <CGAL/Surface_mesh_foliation.h>
#include <CGAL/Surface_mesh_foliation/canonical_loops.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_symmetries.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace SMF = CGAL::Surface_mesh_foliation;

using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Graph = SMF::Reeb_graph<Point_3>;

// Arguments: a mesh, and the vertices of poles.
int main(int argc, char* argv[])
try
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  std::vector<std::size_t> vertices;
  for (int i = 2; i < argc; ++i)
    vertices.push_back(std::stoul(argv[i]));
  if (argc == 1) // trunk, tail and feet
    vertices = {2759, 2555, 2047, 1671, 2279, 1401};
  Mesh mesh;
  SMF::read_triangle_mesh(file_name, mesh);
  SMF::Poles_and_loops<Mesh> poles;
  for (const std::size_t v : vertices)
    poles.add_pole(Mesh::Vertex_index(static_cast<Mesh::size_type>(v)));

  // all levels of detail
  const SMF::Loop_hierarchy<Mesh> hierarchy = SMF::loop_hierarchy(mesh, poles);
  for (const SMF::Canonical_loop<Mesh>& loop : hierarchy.loops())
    std::cout << "modulus " << loop.modulus << ", margin " << loop.margin()
              << (loop.is_separating ? "" : ", around a handle")
              << (loop.is_near_bound() ? ", near the bound" : "") << '\n';
  for (const double least : {0.3, 0.6, 1.2})
    std::cout << hierarchy.level(least).size() << " loops at level " << least << '\n';

  // the graph of one of them
  SMF::Poles_and_loops<Mesh> input = poles;
  for (const std::size_t i : hierarchy.level())
    input.add_loop(hierarchy.loops()[i].loop);
  Graph graph;
  SMF::foliation_reeb_graph(mesh, input, graph);
  std::cout << num_vertices(graph) << " nodes, " << num_edges(graph) << " arcs\n";
  SMF::write_skeleton_ply("skeleton.ply", graph);

  // arcs that are alike have the same class
  std::cout << "classes of arcs:";
  for (const std::size_t arc_class : SMF::reeb_graph_symmetries(graph).arc_classes)
    std::cout << ' ' << arc_class;
  std::cout << '\n';
  return EXIT_SUCCESS;
}
catch (const std::exception& exception)
{
  std::cerr << exception.what() << std::endl;
  return EXIT_FAILURE;
}
