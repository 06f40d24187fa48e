// Loops of all kinds on one mesh: around poles, around a line pole, from a plane section, and as
// the boundary of a set of vertices. They are validated before anything is computed.

#include <CGAL/Surface_mesh_foliation.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

namespace SMF = CGAL::Surface_mesh_foliation;

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;
using Loop = SMF::Loop<Mesh>;

// The points where a loop crosses edges, as a closed polyline.
std::vector<Point_3> polyline(const Loop& loop, const Mesh& mesh)
{
  std::vector<Point_3> result;
  for (const auto& [halfedge, position] : loop)
  {
    const Point_3 &p = mesh.point(source(halfedge, mesh)), &q = mesh.point(target(halfedge, mesh));
    result.push_back(p + position * (q - p));
  }
  result.push_back(result.front());
  return result;
}

int main()
try
{
  Mesh mesh; // a bear
  SMF::read_triangle_mesh(CGAL::data_file_path("meshes/bear.off"), mesh);
  SMF::Poles_and_loops<Mesh> loops;
  // ears, an arm and legs: poles, each with a loop a few edges away from it
  for (const Vertex v : {Vertex(8257), Vertex(8311), Vertex(5146), Vertex(2481), Vertex(6552)})
    loops.add_pole(v, SMF::pole_loop(v, mesh, 8));
  // the other arm: a line pole along its flat end, with the loop that hugs it
  std::vector<Vertex> line;
  for (const int v : {5530, 5905, 5904, 6426, 6421, 6414, 6854, 7231, 7221})
    line.emplace_back(v);
  loops.add_line_pole(line);
  // the neck: of the curves of the plane y = 0.4, the one that comes nearest to a vertex
  loops.add_loop(SMF::plane_section_loop(mesh, {0, 1, 0, -0.4}, Vertex(8257)));
  // the hip: the boundary of the vertices below it
  std::vector<Vertex> below;
  for (const Vertex v : vertices(mesh))
    if (mesh.point(v).y() < -0.2)
      below.push_back(v);
  std::vector<Loop> boundary;
  SMF::loops_around_vertices(below, mesh, std::back_inserter(boundary));
  loops.add_loop(boundary.at(0)); // it is one curve

  for (const SMF::Problem& problem :
       SMF::validate(mesh, loops)) // reports problems without throwing
    std::cerr << problem.message << '\n';

  SMF::Reeb_graph<Point_3> graph;
  const SMF::Measured_foliation<Mesh> foliation = SMF::foliation_reeb_graph(mesh, loops, graph);
  std::cout << num_vertices(graph) << " nodes, " << num_edges(graph) << " arcs\n";
  std::vector<std::vector<Point_3>> polylines;
  for (std::size_t arc = 0; arc < foliation.system().number_of_arcs(); ++arc)
    polylines.push_back(polyline(foliation.system().loop(arc), mesh));
  SMF::write_polylines_ply("loops.ply", polylines);
  SMF::write_leaves_ply("leaves.ply", foliation, SMF::reeb_graph_embedding(foliation));
  SMF::write_components_ply("components.ply", foliation);
  SMF::write_skeleton_ply("skeleton.ply", graph);
  SMF::write_reeb_graph_graphml("reeb_graph.graphml", graph);
  return EXIT_SUCCESS;
}
catch (const SMF::Foliation_exception& exception)
{
  std::cerr << exception.what() << std::endl;
  return EXIT_FAILURE;
}
