// A user edits loops: the same solver computes one foliation after another, and starts each from
// what it has already computed.

#include <CGAL/Surface_mesh_foliation.h>

#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>

namespace SMF = CGAL::Surface_mesh_foliation;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Vertex = Mesh::Vertex_index;

int main()
try
{
  Mesh mesh;
  SMF::read_triangle_mesh(CGAL::data_file_path("meshes/camel.off"), mesh);
  SMF::Poles_and_loops<Mesh> loops; // nose, hooves, and the tip of the tail
  for (const Vertex v : {Vertex(3548), Vertex(9213), Vertex(9495), Vertex(8802), Vertex(9067)})
    loops.add_pole(v);
  const std::size_t tail = loops.add_pole(Vertex(512));

  SMF::Loop_system<Mesh> system(mesh, loops); // checks the mesh, once and for all
  SMF::Foliation_solver<Mesh> solver;
  const auto solve = [&](const char* what) {
    CGAL::Real_timer timer;
    timer.start();
    system = SMF::Loop_system<Mesh>(system, loops);
    const auto foliation = solver.solve(system);
    std::cout << what << ": energy " << foliation.statistics().energy << " after "
              << foliation.statistics().number_of_iterations << " iterations, "
              << 1000 * timer.time() << " ms\n";
  };
  solve("from scratch");
  loops.set_height(tail, 0.3);
  solve("a thinner tail"); // from the last solution
  loops.add_pole(Vertex(2000));
  solve("one more pole"); // from coarse meshes, with the last factorization
  return EXIT_SUCCESS;
}
catch (const SMF::Foliation_exception& exception)
{
  std::cerr << exception.what() << std::endl;
  return EXIT_FAILURE;
}
