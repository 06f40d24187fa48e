// The Reeb graph of a Polyhedron_3, with poles at the vertices farthest in some directions.

#include <CGAL/Surface_mesh_foliation.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace SMF = CGAL::Surface_mesh_foliation;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Mesh = CGAL::Polyhedron_3<Kernel>; // no ids are needed
using Vertex = boost::graph_traits<Mesh>::vertex_descriptor;
using Graph = SMF::Reeb_graph<Point_3>;

Vertex farthest_vertex(const Mesh& mesh, const Vector_3& direction)
{
  const auto is_less = [&](Vertex u, Vertex v) {
    return (u->point() - v->point()) * direction < 0;
  };
  const auto range = vertices(mesh);
  return *std::max_element(range.begin(), range.end(), is_less);
}

// Argument: a mesh. By default a standing figure, whose farthest points toward the top, the sides
// and the lower corners are on the head, the hands and the feet.
int main(int argc, char* argv[])
try
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/homer.off");

  Mesh mesh;
  SMF::read_triangle_mesh(file_name, mesh);

  std::vector<Vertex> poles;
  for (const Vector_3& direction : {Vector_3(0, 1, 0), Vector_3(1, 0, 0), Vector_3(-1, 0, 0),
                                    Vector_3(1, -2, 1), Vector_3(-1, -2, 1)})
    poles.push_back(farthest_vertex(mesh, direction));

  Graph graph;
  const SMF::Measured_foliation<Mesh> foliation =
    SMF::foliation_reeb_graph(mesh, poles, graph, SMF::parameters::number_of_samples(40));

  std::cout << num_vertices(graph) << " nodes and " << num_edges(graph) << " arcs after "
            << foliation.statistics().number_of_iterations << " iterations\n";
  SMF::write_reeb_graph_graphml("reeb_graph.graphml", graph);
  SMF::write_components_ply("components.ply", foliation);
  return EXIT_SUCCESS;
}
catch (const SMF::Foliation_exception& exception)
{
  std::cerr << exception.what() << std::endl;
  return EXIT_FAILURE;
}
