// From a scan as it comes from a file to one Reeb graph: the mesh is repaired, small holes are
// filled, large openings are ends, and each part has its poles and loops found.

#include <CGAL/Surface_mesh_foliation.h>
#include <CGAL/Surface_mesh_foliation/fill_openings.h>
#include <CGAL/Surface_mesh_foliation/repair.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/range/iterator_range.hpp>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace SMF = CGAL::Surface_mesh_foliation;

using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Part = SMF::Mesh_part<Mesh>;

int main(int argc, char* argv[])
try
{
  const std::string file =
    argc > 1 ? argv[1] : CGAL::data_file_path("meshes/double-torus-3-holes.off");
  const SMF::Repaired_soup repaired = SMF::repair_polygon_soup(SMF::read_polygon_soup(file));
  for (const std::string& line : SMF::descriptions(repaired.report))
    std::cout << line << '\n';

  Mesh mesh;
  SMF::triangle_soup_to_triangle_mesh(repaired.soup, mesh,
                                      SMF::parameters::allow_openings(true).allow_parts(true));
  const auto filled = mesh.add_property_map<Mesh::Face_index, bool>("f:filled", false).first;
  std::cout << SMF::fill_openings(mesh, SMF::parameters::filled_face_map(filled))
            << " holes were filled\n";

  const std::vector<Part> parts = SMF::mesh_parts(mesh);
  SMF::Poles_and_loops<Mesh> given; // none; repaired.vertices[v] would be vertex v of the file
  std::vector<SMF::Poles_and_loops<Part>> input = SMF::poles_and_loops_of_parts(parts, given);
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    std::cout << "part " << i << ": " << SMF::add_border_poles(parts[i], input[i])
              << " openings are ends\n";
    SMF::propose_loops(parts[i], input[i]);
    SMF::add_missing_poles(parts[i], input[i]);
  }
  SMF::Reeb_graph<Point_3> graph;
  const auto foliations = SMF::foliation_reeb_graph_of_parts(parts, input, graph);
  for (const auto v : boost::make_iterator_range(vertices(graph)))
    std::cout << SMF::name(graph[v].kind) << ' ' << graph[v].id << " of part " << graph[v].part
              << " at " << graph[v].point << '\n';
  std::cout << num_edges(graph) << " arcs\n";

  for (std::size_t i = 0; i < parts.size(); ++i)
    SMF::write_components_ply("part_" + std::to_string(i) + ".ply", foliations[i],
                              SMF::parameters::filled_face_map(filled));
  return EXIT_SUCCESS;
}
catch (const SMF::Foliation_exception& exception)
{
  std::cerr << exception.what() << std::endl;
  return EXIT_FAILURE;
}
