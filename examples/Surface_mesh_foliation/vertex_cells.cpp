// Where each vertex lies in the Reeb graph, as property maps of the mesh: its arc, its node if it
// lies on a critical leaf, and its parameter, how far along the arc it is. Like all property maps
// of a surface mesh, and with colors, they are written to PLY.

#include <CGAL/Surface_mesh_foliation.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <vector>

namespace SMF = CGAL::Surface_mesh_foliation;

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;

int main()
try
{
  Mesh mesh; // a fist
  SMF::read_triangle_mesh(CGAL::data_file_path("meshes/hand.off"), mesh);
  // wrist, thumb, the bends of four fingers
  const std::vector<Vertex> poles = {Vertex(51),  Vertex(21),  Vertex(217),
                                     Vertex(435), Vertex(852), Vertex(1076)};
  SMF::Reeb_graph<Point_3> graph;
  const SMF::Measured_foliation<Mesh> foliation = SMF::foliation_reeb_graph(mesh, poles, graph);

  const auto arc = mesh.add_property_map<Vertex, int>("v:arc").first;
  const auto node = mesh.add_property_map<Vertex, int>("v:node").first;
  const auto parameter = mesh.add_property_map<Vertex, double>("v:parameter").first;
  SMF::vertex_cells(foliation, arc, node, parameter);

  // ten rings on each arc
  const CGAL::IO::Color gray(128, 128, 128);
  const auto color = mesh.add_property_map<Vertex, CGAL::IO::Color>("v:color", gray).first;
  std::vector<std::size_t> number_of_vertices(num_edges(graph), 0);
  for (const Vertex v : vertices(mesh))
    if (arc[v] >= 0)
    {
      const auto a = static_cast<std::size_t>(arc[v]);
      ++number_of_vertices[a];
      if (static_cast<int>(20 * parameter[v] / foliation.system().height(a)) % 2 == 0)
        color[v] = SMF::arc_color(a);
    }
  for (std::size_t a = 0; a < number_of_vertices.size(); ++a)
    std::cout << "arc " << a << ": " << number_of_vertices[a] << " vertices\n";
  std::ofstream output("hand_with_cells.ply");
  CGAL::IO::write_PLY(output, mesh);
  return output ? EXIT_SUCCESS : EXIT_FAILURE;
}
catch (const SMF::Foliation_exception& exception)
{
  std::cerr << exception.what() << std::endl;
  return EXIT_FAILURE;
}
