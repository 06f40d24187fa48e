// Loops through a few picked vertices, as if clicked in a viewer: one that is compatible with the
// poles and loops that are already there, and two that are not, with the reason.

#include <CGAL/Surface_mesh_foliation.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <iostream>
#include <vector>

namespace SMF = CGAL::Surface_mesh_foliation;

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;

int main()
try
{
  Mesh mesh;
  SMF::read_triangle_mesh(CGAL::data_file_path("meshes/elephant.off"), mesh);
  SMF::Poles_and_loops<Mesh> loops; // trunk, legs and tail
  for (const int v : {2759, 2555, 2047, 1671, 2279, 1401, 982})
    loops.add_pole(Vertex(v));

  const std::vector<std::vector<Vertex>> clicks = {
    {Vertex(567), Vertex(1456), Vertex(433), Vertex(2734)}, // around the neck
    {Vertex(449), Vertex(148), Vertex(537)},                // around it again
    {Vertex(567), Vertex(1286), Vertex(433), Vertex(315)}}; // lengthwise
  for (const std::vector<Vertex>& picks : clicks)
    try
    {
      const std::size_t id = SMF::add_loop_through_vertices(picks, mesh, loops);
      std::cout << "loop " << id << " with " << loops.entries()[id].loop.size() << " crossings\n";
    }
    catch (const SMF::Invalid_loops_exception& exception)
    {
      std::cout << "not added: " << exception.what() << '\n';
    }

  SMF::Reeb_graph<Point_3> graph;
  SMF::foliation_reeb_graph(mesh, loops, graph);
  std::cout << num_vertices(graph) << " nodes, " << num_edges(graph) << " arcs\n";
  SMF::write_skeleton_ply("skeleton.ply", graph);
  return EXIT_SUCCESS;
}
catch (const SMF::Foliation_exception& exception)
{
  std::cerr << exception.what() << std::endl;
  return EXIT_FAILURE;
}
