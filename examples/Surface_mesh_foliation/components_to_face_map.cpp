// The surface components of a foliation as property maps of a mesh that is cut along the critical
// leaves: the area of each, and the length of the cuts.

#include <CGAL/Surface_mesh_foliation.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <iostream>
#include <vector>

namespace SMF = CGAL::Surface_mesh_foliation;
namespace PMP = CGAL::Polygon_mesh_processing;

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;
using Edge = Mesh::Edge_index;
using Face = Mesh::Face_index;

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
  const SMF::Loop_system<Mesh> system(mesh, loops);
  const SMF::Measured_foliation<Mesh> foliation = SMF::harmonic_foliation(system);

  // the input mesh is not changed; the cut mesh is a copy
  Mesh cut_mesh;
  const auto component = cut_mesh.add_property_map<Face, std::size_t>("f:component").first;
  const auto is_critical = cut_mesh.add_property_map<Edge, bool>("e:is_critical").first;
  const std::size_t number_of_components = SMF::surface_components(
    foliation, cut_mesh,
    SMF::parameters::face_component_map(component).edge_is_constrained_map(is_critical));

  std::vector<double> area(number_of_components, 0);
  for (const Face f : faces(cut_mesh))
    area[component[f]] += PMP::face_area(f, cut_mesh);
  for (std::size_t a = 0; a < number_of_components; ++a)
    std::cout << "component " << a << ", a " << SMF::name(SMF::component_kind(system, a))
              << ": area " << area[a] << '\n';

  double length = 0;
  for (const Edge e : edges(cut_mesh))
    if (is_critical[e])
      length += PMP::edge_length(e, cut_mesh);
  std::cout << "critical leaves: length " << length << '\n';
  return EXIT_SUCCESS;
}
catch (const SMF::Foliation_exception& exception)
{
  std::cerr << exception.what() << std::endl;
  return EXIT_FAILURE;
}
