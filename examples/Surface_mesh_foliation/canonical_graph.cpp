// The canonical graph of a shape, its levels of detail and its symmetries, from nothing but a
// closed mesh.

#include <CGAL/Surface_mesh_foliation.h>
#include <CGAL/Surface_mesh_foliation/canonical_loops.h>
#include <CGAL/Surface_mesh_foliation/canonical_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_symmetries.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace SMF = CGAL::Surface_mesh_foliation;

using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Graph = SMF::Reeb_graph<Point_3>;

// Argument: a mesh.
int main(int argc, char* argv[])
try
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  SMF::read_triangle_mesh(file_name, mesh);

  // the graph, with the poles and loops that the shape decides
  Graph graph;
  std::vector<SMF::Canonical_loop<Mesh>> loops;
  const auto foliation = SMF::canonical_reeb_graph(
    mesh, graph, SMF::parameters::canonical_loop_output_iterator(std::back_inserter(loops)));
  const std::size_t number_of_poles = foliation.system().number_of_poles();
  std::cout << number_of_poles << " poles, " << num_vertices(graph) << " nodes, "
            << num_edges(graph) << " arcs\n";
  for (const SMF::Canonical_loop<Mesh>& loop : loops)
    std::cout << "modulus " << loop.modulus << ", margin " << loop.margin()
              << (loop.is_separating ? "" : ", around a handle")
              << (loop.is_near_bound() ? ", near the bound" : "") << '\n';
  SMF::write_skeleton_ply("skeleton.ply", graph);

  // all levels of detail with the same poles
  SMF::Poles_and_loops<Mesh> poles;
  for (std::size_t p = 0; p < number_of_poles; ++p)
    poles.add_pole(foliation.system().pole_vertices(p)[0]);
  const SMF::Loop_hierarchy<Mesh> hierarchy = SMF::loop_hierarchy(mesh, poles);
  for (const double least : {0.3, 0.6, 1.2})
    std::cout << hierarchy.level(least).size() << " loops at level " << least << '\n';

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
