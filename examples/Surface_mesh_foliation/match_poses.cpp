// Matches the Reeb graphs of a camel in two poses: lengths, areas and fluxes tell which part of one
// is which part of the other.

#include <CGAL/Surface_mesh_foliation.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace SMF = CGAL::Surface_mesh_foliation;

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;
using Graph = SMF::Reeb_graph<Point_3>;

// Turns every slice of the mesh along its x-axis by an angle that grows along the axis.
void twist(Mesh& mesh)
{
  double low = mesh.point(*vertices(mesh).begin()).x(), high = low;
  for (const Vertex v : vertices(mesh))
  {
    low = (std::min)(low, mesh.point(v).x());
    high = (std::max)(high, mesh.point(v).x());
  }
  for (const Vertex v : vertices(mesh))
  {
    const Point_3 p = mesh.point(v);
    const double angle = (p.x() - low) / (high - low);
    mesh.point(v) = Point_3(p.x(), std::cos(angle) * p.y() - std::sin(angle) * p.z(),
                            std::sin(angle) * p.y() + std::cos(angle) * p.z());
  }
}

int main()
try
{
  Mesh mesh; // a camel
  SMF::read_triangle_mesh(CGAL::data_file_path("meshes/camel.off"), mesh);
  // nose, hooves, tip of the tail
  const std::vector<Vertex> poles = {Vertex(3548), Vertex(9213), Vertex(9495),
                                     Vertex(8802), Vertex(9067), Vertex(512)};
  Graph graph, other_graph;
  SMF::foliation_reeb_graph(mesh, poles, graph);

  // another pose, with its poles in another order
  twist(mesh);
  const std::vector<Vertex> other_poles(poles.rbegin(), poles.rend());
  SMF::foliation_reeb_graph(mesh, other_poles, other_graph);

  const auto matching =
    SMF::match_reeb_graphs(graph, other_graph, SMF::parameters::use_pole_labels(false));
  if (!matching)
  {
    std::cout << "the graphs are not isomorphic\n";
    return EXIT_SUCCESS;
  }
  for (const auto& [v, other] : matching->nodes)
    if (graph[v].pole >= 0)
      std::cout << "pole " << graph[v].pole << " is pole " << other_graph[other].pole << '\n';
  std::cout << "distance " << matching->distance << ": lengths " << matching->length_distance
            << ", areas " << matching->area_distance << ", fluxes " << matching->flux_distance
            << '\n';
  return EXIT_SUCCESS;
}
catch (const SMF::Foliation_exception& exception)
{
  std::cerr << exception.what() << std::endl;
  return EXIT_FAILURE;
}
