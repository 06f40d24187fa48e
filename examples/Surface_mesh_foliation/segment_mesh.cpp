// Divides the faces of a mesh among its parts, without cutting any face. Each part becomes a mesh
// of its own.

#include <CGAL/Surface_mesh_foliation.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace SMF = CGAL::Surface_mesh_foliation;

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;

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

  const auto segment = mesh.add_property_map<Face, std::size_t>("f:segment").first;
  const std::size_t number_of_segments = SMF::face_segmentation(foliation, segment);
  for (std::size_t s = 0; s < number_of_segments; ++s)
  {
    const CGAL::Face_filtered_graph<Mesh> part(mesh, s, segment);
    Mesh part_mesh;
    CGAL::copy_face_graph(part, part_mesh);
    CGAL::IO::write_OFF("segment_" + std::to_string(s) + ".off", part_mesh);
    std::cout << "segment " << s << ": " << num_faces(part_mesh) << " faces\n";
  }
  return EXIT_SUCCESS;
}
catch (const SMF::Foliation_exception& exception)
{
  std::cerr << exception.what() << std::endl;
  return EXIT_FAILURE;
}
