// A Reeb graph as a curve skeleton like those of CGAL's skeletonization: each point has the mesh
// vertices around it. The local thickness of the shape is carried over to its vertices.

#include <CGAL/Surface_mesh_foliation.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <vector>

namespace SMF = CGAL::Surface_mesh_foliation;

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;
using Skeleton = SMF::Curve_skeleton<Mesh>;

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

  // centroids jump at branchings; smoothing makes the skeleton straighter
  const auto embedding =
    SMF::reeb_graph_embedding(foliation, SMF::parameters::number_of_smoothing_steps(5));
  Skeleton skeleton;
  SMF::curve_skeleton(foliation, embedding, skeleton);

  const auto thickness = mesh.add_property_map<Vertex, double>("v:thickness").first;
  double largest = 0;
  for (const auto s : boost::make_iterator_range(vertices(skeleton)))
    for (const Vertex v : skeleton[s].vertices)
    {
      thickness[v] = skeleton[s].radius;
      largest = (std::max)(largest, thickness[v]);
    }
  std::cout << num_vertices(skeleton) << " points and " << num_edges(skeleton)
            << " edges for a mesh of " << num_vertices(mesh) << " vertices; largest radius "
            << largest << '\n';
  std::ofstream output("hand_with_thickness.ply");
  CGAL::IO::write_PLY(output, mesh);
  return output ? EXIT_SUCCESS : EXIT_FAILURE;
}
catch (const SMF::Foliation_exception& exception)
{
  std::cerr << exception.what() << std::endl;
  return EXIT_FAILURE;
}
