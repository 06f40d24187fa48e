// Two ways to sample the leaves through whose centroids the arcs of a Reeb graph are drawn: evenly
// along the arc, or at equal differences of the transverse measure.

#include <CGAL/Surface_mesh_foliation.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace SMF = CGAL::Surface_mesh_foliation;

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;

// The longest segment between two samples of a polyline, divided by the shortest.
double unevenness(const std::vector<Point_3>& polyline)
{
  std::vector<double> squares;
  for (std::size_t i = 2; i + 1 < polyline.size(); ++i)
    squares.push_back(CGAL::squared_distance(polyline[i - 1], polyline[i]));
  const auto [least, greatest] = std::minmax_element(squares.begin(), squares.end());
  return CGAL::approximate_sqrt(*greatest / *least);
}

int main()
try
{
  Mesh mesh; // a camel
  SMF::read_triangle_mesh(CGAL::data_file_path("meshes/camel.off"), mesh);
  // nose, hooves, tip of the tail
  const std::vector<Vertex> poles = {Vertex(3548), Vertex(9213), Vertex(9495),
                                     Vertex(8802), Vertex(9067), Vertex(512)};
  SMF::Reeb_graph<Point_3> graph;
  const SMF::Measured_foliation<Mesh> foliation = SMF::foliation_reeb_graph(mesh, poles, graph);

  for (const bool is_uniform : {false, true})
  {
    const auto embedding =
      SMF::reeb_graph_embedding(foliation, SMF::parameters::use_uniform_levels(is_uniform));
    const std::string name = is_uniform ? "uniform" : "even";
    std::cout << name << ": spaces of arc 0 differ by a factor of up to "
              << unevenness(embedding.arc_polylines[0]) << '\n';

    graph.clear();
    SMF::reeb_graph(foliation, graph, embedding);
    SMF::write_skeleton_ply(name + "_skeleton.ply", graph);
    SMF::write_leaves_ply(name + "_leaves.ply", foliation, embedding);
  }
  return EXIT_SUCCESS;
}
catch (const SMF::Foliation_exception& exception)
{
  std::cerr << exception.what() << std::endl;
  return EXIT_FAILURE;
}
