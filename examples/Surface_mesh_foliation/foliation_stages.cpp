// From poles to the Reeb graph stage by stage, with a visitor that watches the solver and the
// foliation values in a property map.

#include <CGAL/Surface_mesh_foliation.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <iterator>
#include <vector>

namespace SMF = CGAL::Surface_mesh_foliation;

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;
using Edge = Mesh::Edge_index;

// Prints how the energy decreases, and stops the solver when it hardly decreases any more.
struct Reporting_visitor
{
  bool after_iteration(const SMF::Foliation_statistics& statistics)
  {
    std::cout << "iteration " << statistics.number_of_iterations << ": energy " << statistics.energy
              << ", optimality " << statistics.optimality << '\n';
    const bool goes_on = statistics.energy < (1 - 1e-9) * last_energy;
    last_energy = statistics.energy;
    return goes_on;
  }
  double last_energy = 1e300;
};

int main()
try
{
  Mesh mesh;
  SMF::read_triangle_mesh(CGAL::data_file_path("meshes/camel.off"), mesh);

  // 1. poles and loops: nose, hooves, and the tip of the tail with fewer leaves around it
  SMF::Poles_and_loops<Mesh> loops;
  for (const Vertex v : {Vertex(3548), Vertex(9213), Vertex(9495), Vertex(8802), Vertex(9067)})
    loops.add_pole(v);
  loops.add_pole(Vertex(512), 0.3);

  // 2. the loop system: from here on the Reeb graph is known
  const SMF::Loop_system<Mesh> system(mesh, loops);
  for (std::size_t arc = 0; arc < system.number_of_arcs(); ++arc)
    std::cout << "arc " << arc << " joins nodes " << system.node(arc, 0) << " and "
              << system.node(arc, 1) << '\n';

  // 3. the harmonic foliation; a reference keeps the state of the visitor
  Reporting_visitor visitor;
  const SMF::Measured_foliation<Mesh> foliation = SMF::harmonic_foliation(
    system, SMF::parameters::weights(SMF::Mean_value_weights()).visitor(std::ref(visitor)));
  SMF::edge_values(foliation, mesh.add_property_map<Edge, double>("e:foliation_value").first);

  // 4. singularities and components
  std::vector<SMF::Singularity<Mesh>> singularities;
  SMF::singularities(foliation, std::back_inserter(singularities));
  Mesh components;
  SMF::surface_components(foliation, components);
  std::cout << singularities.size() << " singularities; cutting along the critical leaves adds "
            << num_vertices(components) - num_vertices(mesh) << " vertices\n";

  // 5. the graph, and its embedding
  SMF::Reeb_graph<Point_3> graph;
  SMF::reeb_graph(foliation, graph, SMF::reeb_graph_embedding(foliation));
  SMF::write_reeb_graph_dot("reeb_graph.dot", graph);
  return EXIT_SUCCESS;
}
catch (const SMF::Foliation_exception& exception)
{
  std::cerr << exception.what() << std::endl;
  return EXIT_FAILURE;
}
