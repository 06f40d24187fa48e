// The mesh: read, repaired if that is wanted, its openings filled, and taken apart.

#ifndef SMF_EXAMPLES_MAIN_PROGRAM_READ_MESH_H
#define SMF_EXAMPLES_MAIN_PROGRAM_READ_MESH_H

#include "Options.h"
#include "Result.h"
#include "read_file.h"

#include <CGAL/Surface_mesh_foliation/fill_openings.h>
#include <CGAL/Surface_mesh_foliation/repair.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace main_program {

inline std::size_t number_of_parts(Mesh& mesh)
{
  auto part = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:part", 0).first;
  const std::size_t number = CGAL::Polygon_mesh_processing::connected_components(mesh, part);
  mesh.remove_property_map(part);
  return number;
}

inline auto any_surface()
{
  return SMF::parameters::allow_openings(true).allow_parts(true);
}

// what --repair would do to a file, in one line; empty if it would do nothing or does not help
inline std::string advice_to_repair(const Options& options)
{
  std::string result;
  try
  {
    const SMF::Repaired_soup repaired = SMF::repair_polygon_soup(read_polygons(options));
    if (!SMF::check_triangle_soup(repaired.soup, any_surface()).empty())
      return std::string();
    for (const std::string& line : SMF::descriptions(repaired.report))
      result += (result.empty() ? "" : ", ") + line;
  }
  catch (const SMF::Foliation_exception&) // that cannot be repaired
  {}
  return result;
}

inline void read_strictly(const Options& options, Mesh& mesh)
{
  const std::string& file = options.mesh;
  try
  {
    if (is_standard_input(options) || is_vtk_file(file) || is_gltf_file(file))
      SMF::triangle_soup_to_triangle_mesh(
        SMF::polygon_soup_to_triangle_soup(read_polygons(options)), mesh, any_surface());
    else
      SMF::read_triangle_mesh(file, mesh, any_surface());
  }
  catch (const SMF::Invalid_mesh_exception& exception)
  {
    const std::string advice = advice_to_repair(options);
    std::string message = exception.what();
    if (message.find(file) == std::string::npos)
      message.insert(0, file + ": ");
    if (advice.empty())
      throw std::invalid_argument(message);
    throw std::invalid_argument(message + "; use --repair, which would report: " + advice);
  }
}

// A mesh of triangles that do not know their neighbors has as many parts as faces, none with a
// graph.
inline void check_that_faces_are_joined(const std::string& file, const Result& result)
{
  if (result.number_of_all_parts > 1 && result.number_of_all_parts == result.number_of_faces)
    throw std::invalid_argument(file + ": the mesh is " + std::to_string(result.number_of_faces) +
                                " faces, of which no two share an edge; use --repair, which merges "
                                "vertices at equal positions");
}

// vertices by the number that they have in the file, and the numbers of the vertices
inline void number_vertices(Result& result)
{
  if (result.repaired)
    for (const std::size_t v : result.repaired->vertices)
      result.numbered_vertices.push_back(v == SMF::Repaired_soup::none
                                           ? Mesh::null_vertex()
                                           : Vertex(static_cast<Mesh::size_type>(v)));
  else
    result.numbered_vertices.assign(result.mesh.vertices_begin(),
                                    result.mesh.vertices_begin() + result.number_of_vertices);
  constexpr std::size_t none = SMF::Repaired_soup::none;
  result.number_of_vertex.assign(num_vertices(result.mesh), none);
  for (std::size_t i = result.numbered_vertices.size(); i-- > 0;)
    if (result.numbered_vertices[i] != Mesh::null_vertex())
      result.number_of_vertex[result.numbered_vertices[i]] = i;
  for (const Vertex v : result.mesh.vertices())
    if (result.number_of_vertex[v] == none)
    {
      result.number_of_vertex[v] = result.numbered_vertices.size();
      result.numbered_vertices.push_back(v);
    }
}

inline void fill_openings(const Options& options, Result& result)
{
  result.is_filled = result.mesh.add_property_map<Mesh::Face_index, bool>("f:filled", false).first;
  if (CGAL::is_closed(result.mesh))
    return;
  const auto parameters = SMF::parameters::filled_face_map(result.is_filled);
  result.number_of_filled_openings =
    options.max_filled_length
      ? SMF::fill_openings(result.mesh, parameters.max_opening_length(*options.max_filled_length))
      : SMF::fill_openings(result.mesh, parameters);
}

inline void read_mesh(const Options& options, Result& result)
{
  if (options.repairs)
  {
    result.repaired = SMF::repair_polygon_soup(read_polygons(options));
    try
    {
      SMF::triangle_soup_to_triangle_mesh(result.repaired->soup, result.mesh, any_surface());
    }
    catch (const SMF::Invalid_mesh_exception& exception)
    {
      throw std::invalid_argument(options.mesh + ": after the repair, " + exception.what());
    }
  }
  else
    read_strictly(options, result.mesh);
  result.number_of_vertices = num_vertices(result.mesh);
  result.number_of_faces = num_faces(result.mesh);
  result.number_of_all_parts = number_of_parts(result.mesh);
  check_that_faces_are_joined(options.mesh, result);
  fill_openings(options, result);
  number_vertices(result);
  result.part_meshes =
    SMF::mesh_parts(result.mesh, SMF::parameters::number_of_parts(options.max_parts));
  result.parts.resize(result.part_meshes.size());
}

} // namespace main_program

#endif // SMF_EXAMPLES_MAIN_PROGRAM_READ_MESH_H
