// From a bare mesh to its Reeb graph: the program finds the poles.

#include <CGAL/Surface_mesh_foliation.h>
#include <CGAL/Surface_mesh_foliation/feature_poles.h>

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

// Arguments: a mesh, and the least significance of its poles.
int main(int argc, char* argv[])
try
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/camel.off");
  const double significance = argc > 2 ? std::stod(argv[2]) : SMF::default_min_significance;
  Mesh mesh;
  SMF::read_triangle_mesh(file_name, mesh);

  std::vector<Mesh::Vertex_index> poles;
  SMF::detect_feature_poles(mesh, std::back_inserter(poles),
                            SMF::parameters::min_significance(significance));
  for (const auto v : poles)
    std::cout << "pole " << static_cast<int>(v) << " at " << mesh.point(v) << '\n';

  SMF::Reeb_graph<Point_3> graph;
  SMF::foliation_reeb_graph(mesh, poles, graph);
  std::cout << "a Reeb graph with " << num_vertices(graph) << " nodes and " << num_edges(graph)
            << " arcs" << std::endl;
  SMF::write_skeleton_ply("skeleton.ply", graph);
  return EXIT_SUCCESS;
}
catch (const std::exception& exception)
{
  std::cerr << exception.what() << std::endl;
  return EXIT_FAILURE;
}
