// Regular leaves of a foliation: the one through a point of the surface, and some at equal
// differences of level in each component.

#include <CGAL/Surface_mesh_foliation.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <optional>
#include <vector>

namespace SMF = CGAL::Surface_mesh_foliation;

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
using Tracer = SMF::Leaf_tracer<Mesh>;
using Leaf = SMF::Leaf<Tracer::Point>;

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
  const SMF::Measured_foliation<Mesh> foliation =
    SMF::harmonic_foliation(SMF::Loop_system<Mesh>(mesh, loops));

  // takes linear time once; then each leaf takes time linear in its length
  const Tracer tracer(foliation);

  const std::optional<Leaf> leaf = tracer.leaf_through(Face(100), {0.2, 0.3, 0.5});
  if (leaf) // there is none through points of critical leaves
    std::cout << "The leaf through a point of face 100: component " << leaf->arc << ", level "
              << leaf->level << ", length " << leaf->length << ", centroid " << leaf->centroid
              << '\n';

  std::vector<std::vector<Tracer::Point>> polylines;
  for (std::size_t a = 0; a < foliation.system().number_of_arcs(); ++a)
  {
    std::vector<Leaf> leaves;
    tracer.evenly_spaced_leaves(a, 9, std::back_inserter(leaves));
    std::cout << "Component " << a << ": lengths";
    for (const Leaf& l : leaves)
    {
      std::cout << ' ' << l.length;
      polylines.push_back(l.points);
    }
    std::cout << '\n';
  }
  SMF::write_polylines_ply("leaves.ply", polylines);
  return EXIT_SUCCESS;
}
catch (const SMF::Foliation_exception& exception)
{
  std::cerr << exception.what() << std::endl;
  return EXIT_FAILURE;
}
