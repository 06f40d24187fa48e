// A foliation from nothing but the values of its edges: here the values of a harmonic foliation,
// kept in a property map as if they came from another program.

#include <CGAL/Surface_mesh_foliation.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>

namespace SMF = CGAL::Surface_mesh_foliation;

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;
using Edge = Mesh::Edge_index;

int main()
try
{
  Mesh mesh;
  SMF::read_triangle_mesh(CGAL::data_file_path("meshes/camel.off"), mesh);
  const auto values = mesh.add_property_map<Edge, double>("e:foliation_value").first;
  {
    SMF::Poles_and_loops<Mesh> loops; // nose, hooves, and the tip of the tail
    for (const Vertex v : {Vertex(3548), Vertex(9213), Vertex(9495), Vertex(8802), Vertex(9067)})
      loops.add_pole(v);
    loops.add_pole(Vertex(512), 0.3);
    SMF::edge_values(SMF::harmonic_foliation(SMF::Loop_system<Mesh>(mesh, loops)), values);
  }

  // poles, heights and graph are recovered
  const SMF::Measured_foliation<Mesh> foliation = SMF::integrate_foliation(mesh, values);
  const SMF::Loop_system<Mesh>& system = foliation.system();
  for (std::size_t arc = 0; arc < system.number_of_arcs(); ++arc)
  {
    std::cout << "arc " << arc << " of height " << system.height(arc) << " joins nodes "
              << system.node(arc, 0) << " and " << system.node(arc, 1);
    const int pole = system.pole(system.node(arc, 0));
    if (pole >= 0)
      std::cout << ", the former at vertex "
                << std::size_t(system.pole_vertices(static_cast<std::size_t>(pole))[0]);
    std::cout << '\n';
  }

  // this foliation can be used like any other
  SMF::Reeb_graph<Point_3> graph;
  SMF::reeb_graph(foliation, graph);
  SMF::write_skeleton_ply("skeleton.ply", graph);

  // values that belong to no foliation are rejected
  values[*edges(mesh).begin()] += 1;
  try
  {
    SMF::integrate_foliation(mesh, values);
  }
  catch (const SMF::Invalid_foliation_exception& exception)
  {
    std::cout << exception.what() << '\n';
  }
  return EXIT_SUCCESS;
}
catch (const SMF::Foliation_exception& exception)
{
  std::cerr << exception.what() << std::endl;
  return EXIT_FAILURE;
}
