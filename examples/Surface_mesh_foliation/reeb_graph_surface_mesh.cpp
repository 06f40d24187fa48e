// The Reeb graph of a mesh in one call, from poles to an embedded graph.

#include <CGAL/Surface_mesh_foliation.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/range/iterator_range.hpp>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace SMF = CGAL::Surface_mesh_foliation;

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;
using Graph = SMF::Reeb_graph<Point_3>;

// Arguments: a mesh and its poles. By default a fist: wrist, thumb, and the bends of four fingers.
int main(int argc, char* argv[])
try
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/hand.off");
  Mesh mesh;
  SMF::read_triangle_mesh(file_name, mesh);

  std::vector<Vertex> poles = {Vertex(51),  Vertex(21),  Vertex(217),
                               Vertex(435), Vertex(852), Vertex(1076)};
  if (argc > 1)
    poles.clear();
  for (int i = 2; i < argc; ++i)
    poles.emplace_back(std::stoi(argv[i]));
  for (const Vertex v : poles)
    if (!mesh.is_valid(v))
    {
      std::cerr << "there is no vertex " << v << std::endl;
      return EXIT_FAILURE;
    }

  Graph graph;
  SMF::foliation_reeb_graph(mesh, poles, graph);

  for (const auto v : boost::make_iterator_range(vertices(graph)))
    std::cout << "node " << graph[v].id << ": " << SMF::name(graph[v].kind) << " at "
              << graph[v].point << '\n';
  for (const auto& e : boost::make_iterator_range(edges(graph)))
    std::cout << "arc " << graph[e].loop << ": from node " << source(e, graph) << " to node "
              << target(e, graph) << ", a " << SMF::name(graph[e].component) << " of length "
              << SMF::length(graph[e].polyline) << '\n';

  SMF::write_skeleton_ply("skeleton.ply", graph);
  return EXIT_SUCCESS;
}
catch (const std::exception& exception)
{
  std::cerr << exception.what() << std::endl;
  return EXIT_FAILURE;
}
