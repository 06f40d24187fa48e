// The Reeb graph of a function given at the vertices: the elevation of each vertex.

#include <CGAL/Surface_mesh_foliation.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <map>
#include <string>

namespace SMF = CGAL::Surface_mesh_foliation;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Vertex = Mesh::Vertex_index;
using Graph = SMF::Scalar_reeb_graph<Mesh>;
using Arc = Graph::edge_descriptor;

// Arguments: a mesh, and the persistence as a fraction of the total elevation. By default an
// elephant.
int main(int argc, char* argv[])
try
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  const double share = argc > 2 ? std::stod(argv[2]) : 0.05;
  Mesh mesh;
  SMF::read_triangle_mesh(file_name, mesh);

  auto height = mesh.add_property_map<Vertex, double>("v:height").first;
  double lowest = mesh.point(Vertex(0)).y(), highest = lowest;
  for (const Vertex v : vertices(mesh))
  {
    height[v] = mesh.point(v).y();
    lowest = (std::min)(lowest, height[v]);
    highest = (std::max)(highest, height[v]);
  }

  // bumps and dents lower than a twentieth of the total elevation are removed
  Graph graph;
  auto arc_of_vertex = mesh.add_property_map<Vertex, Arc>("v:arc").first;
  SMF::reeb_graph_of_function(
    mesh, height, graph,
    SMF::parameters::persistence(share * (highest - lowest)).vertex_to_arc_map(arc_of_vertex));

  const std::map<SMF::Critical_kind, std::string> names = {{SMF::Critical_kind::MINIMUM, "minimum"},
                                                           {SMF::Critical_kind::MAXIMUM, "maximum"},
                                                           {SMF::Critical_kind::SADDLE, "saddle"}};
  for (const auto node : boost::make_iterator_range(vertices(graph)))
    std::cout << "node " << node << ": " << names.at(graph[node].kind) << " at vertex "
              << graph[node].vertex.idx() << ", height " << graph[node].value << '\n';
  for (const Arc& arc : boost::make_iterator_range(edges(graph)))
    std::cout << "arc from node " << source(arc, graph) << " up to node " << target(arc, graph)
              << ": heights " << graph[arc].lower << " to " << graph[arc].upper << ", "
              << graph[arc].number_of_vertices << " vertices\n";
  std::cout << "independent cycles: " << num_edges(graph) + 1 - num_vertices(graph) << '\n';

  const Arc here = arc_of_vertex[Vertex(0)];
  std::cout << "vertex 0 lies between the nodes " << source(here, graph) << " and "
            << target(here, graph) << '\n';
  return EXIT_SUCCESS;
}
catch (const std::exception& exception)
{
  std::cerr << exception.what() << std::endl;
  return EXIT_FAILURE;
}
