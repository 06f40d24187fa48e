// Every component of a surface as a flat cylinder: its modulus, texture coordinates in a file, and
// a chart to draw on.

#include <CGAL/Surface_mesh_foliation.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace SMF = CGAL::Surface_mesh_foliation;

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;

int main()
try
{
  Mesh mesh; // a camel
  SMF::read_triangle_mesh(CGAL::data_file_path("meshes/camel.off"), mesh);
  // nose, hooves, tip of the tail
  const std::vector<Vertex> poles = {Vertex(3548), Vertex(9213), Vertex(9495),
                                     Vertex(8802), Vertex(9067), Vertex(512)};
  SMF::Poles_and_loops<Mesh> loops;
  for (const Vertex v : poles)
    loops.add_pole(v);
  // Cotangent weights make coordinates conformal. This mesh is not quite Delaunay, so some weights
  // are negative. Then nothing is guaranteed, and two of 20,000 faces are turned over.
  const SMF::Loop_system<Mesh> system(mesh, loops);
  const SMF::Measured_foliation<Mesh> foliation = SMF::harmonic_foliation(
    system, SMF::parameters::weights(SMF::Cotangent_weights()).allow_any_weights(true));

  const SMF::Component_coordinates<Mesh> coordinates(foliation);
  for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
  {
    const SMF::Component_shape shape = SMF::component_shape(foliation, a);
    std::cout << "Component " << a << ": height " << shape.height << ", circumference "
              << shape.circumference << ", modulus " << shape.modulus() << '\n';
  }
  SMF::write_component_coordinates_obj("coordinates.obj", coordinates);
  SMF::write_component_coordinates_ply("coordinates.ply", coordinates);
  SMF::write_components_ply("components.ply", foliation);

  Mesh chart; // flat, with the coordinates as positions
  const auto surface_point = chart.add_property_map<Vertex, Point_3>("v:surface_point").first;
  coordinates.chart(0, chart, SMF::parameters::surface_point_map(surface_point));
  std::cout << "The chart of component 0 has " << num_faces(chart) << " faces\n";
  if (!CGAL::IO::write_OFF("chart.off", chart))
    return EXIT_FAILURE;
  return EXIT_SUCCESS;
}
catch (const SMF::Foliation_exception& exception)
{
  std::cerr << exception.what() << std::endl;
  return EXIT_FAILURE;
}
