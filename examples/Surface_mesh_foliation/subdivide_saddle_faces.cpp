// Singularities of a foliation, and a mesh on which all of them are vertices.

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
using Edge = Mesh::Edge_index;

const char* kind_name(SMF::Singularity_kind kind)
{
  switch (kind)
  {
  case SMF::Singularity_kind::CENTER_POLE:
    return "center pole";
  case SMF::Singularity_kind::THORN_POLE:
    return "thorn pole";
  case SMF::Singularity_kind::TRIPOD:
    return "tripod";
  case SMF::Singularity_kind::MORSE_SADDLE:
    return "Morse saddle";
  default:
    return "saddle of higher order";
  }
}

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

  std::vector<SMF::Singularity<Mesh>> singularities;
  SMF::singularities(foliation, std::back_inserter(singularities));
  for (const auto& singularity : singularities)
  {
    std::cout << kind_name(singularity.kind) << " of index " << singularity.index;
    if (singularity.is_face)
      std::cout << " in face " << singularity.face << '\n';
    else
      std::cout << " at vertex " << singularity.vertex << '\n';
  }

  std::vector<SMF::Complex_saddle_leaf> complex_leaves;
  SMF::complex_saddle_leaves(foliation, std::back_inserter(complex_leaves));
  for (const auto& leaf : complex_leaves)
    std::cout << leaf.order << " components meet at node " << leaf.node << '\n';

  // each face that is a saddle is split into three, with foliation values on the new edges
  Mesh split_mesh;
  const auto value = split_mesh.add_property_map<Edge, double>("e:value").first;
  const std::size_t number =
    SMF::subdivide_saddle_faces(foliation, split_mesh, SMF::parameters::edge_value_map(value));
  std::cout << number << " faces were split\n";
  return EXIT_SUCCESS;
}
catch (const SMF::Foliation_exception& exception)
{
  std::cerr << exception.what() << std::endl;
  return EXIT_FAILURE;
}
