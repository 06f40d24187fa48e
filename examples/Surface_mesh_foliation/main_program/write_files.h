// The files that the main program writes.

#ifndef SMF_EXAMPLES_MAIN_PROGRAM_WRITE_FILES_H
#define SMF_EXAMPLES_MAIN_PROGRAM_WRITE_FILES_H

#include "Interruption.h"
#include "Options.h"
#include "Result.h"
#include "summarize_result.h"

#include <CGAL/Surface_mesh_foliation/IO/write_repair_maps.h>

#include <algorithm>
#include <csignal>
#include <cstddef>
#include <filesystem>
#include <numeric>
#include <string>
#include <vector>

namespace main_program {

using Path = std::filesystem::path;

// The name of the file to write next; not if a signal wants the program to end.
inline std::string next_file(const Path& folder, const char* name)
{
  throw_if_interrupted();
  return (folder / name).string();
}

// by arc, its number or, if symmetric arcs are to look alike, the least number of its class
inline std::vector<std::size_t> shown_numbers(const Options& options, const Result& result)
{
  std::vector<std::size_t> numbers(number_of_loops(result));
  std::iota(numbers.begin(), numbers.end(), std::size_t(0));
  if (options.shows_symmetry)
    for (const std::vector<std::size_t>& arcs : classes_of_arcs(result.graph))
      for (const std::size_t arc : arcs)
        numbers[arc] = *std::min_element(arcs.begin(), arcs.end());
  return numbers;
}

// the mesh with the component of each face; a face of a part without graph has none
inline void write_segments(const std::string& file_name,
                           const Options& options,
                           const Result& result)
{
  const std::vector<std::size_t> shown = shown_numbers(options, result);
  Mesh::Property_map<Mesh::Face_index, std::size_t> component;
  Mesh mesh = result.mesh; // a copy, which takes a property
  component = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component", 0).first;
  auto is_left_out = mesh.add_property_map<Mesh::Face_index, bool>("f:left_out", true).first;
  std::size_t first = 0; // arc of the part
  for (std::size_t i = 0; i < result.parts.size(); ++i)
  {
    const Part& part = result.parts[i];
    if (part.foliation)
    {
      SMF::face_segmentation(*part.foliation, component);
      for (const auto f : faces(result.part_meshes[i]))
      {
        component[f] = shown[first + component[f]];
        is_left_out[f] = result.is_filled[f];
      }
    }
    first += part.input.size();
  }
  SMF::write_segments_ply(file_name, mesh, component,
                          SMF::parameters::filled_face_map(is_left_out));
}

// the loops that were found, if there are any
inline void write_found_loops(const std::string& file_name, const Result& result)
{
  std::vector<SMF::Loop<Mesh>> loops;
  for (const Part& part : result.parts)
    for (std::size_t a = part.first_found_loop; a < part.end_of_found_loops; ++a)
    {
      loops.emplace_back();
      for (const auto& crossing : part.input.entries()[a].loop)
        loops.back().push_back({crossing.halfedge, crossing.position});
    }
  if (!loops.empty())
    SMF::write_loops(file_name, result.mesh, loops,
                     SMF::parameters::numbered_vertices(result.numbered_vertices));
}

// what there is to see of the foliation of one part
inline void write_foliation_files(const Path& folder, const Part& part, const Result& result)
{
  std::filesystem::create_directories(folder);
  const auto file = [&](const char* name) { return next_file(folder, name); };
  const auto parameters = SMF::parameters::filled_face_map(result.is_filled);
  SMF::write_leaves_ply(file("leaves.ply"), *part.foliation, part.embedding);
  SMF::write_components_ply(file("components.ply"), *part.foliation, parameters);
  SMF::write_foliation_ply(file("foliation.ply"), *part.foliation, parameters);
  SMF::write_leaves_vtp(file("leaves.vtp"), *part.foliation, part.embedding);
  SMF::write_components_vtp(file("components.vtp"), *part.foliation, parameters);
  SMF::write_foliation_vtp(file("foliation.vtp"), *part.foliation, parameters);
  SMF::write_singularities_vtp(file("singularities.vtp"), *part.foliation);
}

// The graph, and for each of several parts a folder of its own. A file is complete, or not there.
inline void write_files(const Options& options, const Result& result)
{
  const Signal_catcher interrupt(SIGINT), termination(SIGTERM);
  const Path folder(options.output);
  std::filesystem::create_directories(folder);
  const auto file = [&](const char* name) { return next_file(folder, name); };
  SMF::write_reeb_graph_graphml(file("reeb_graph.graphml"), result.graph);
  SMF::write_reeb_graph_dot(file("reeb_graph.dot"), result.graph);
  SMF::write_skeleton_ply(file("skeleton.ply"), result.graph);
  SMF::write_skeleton_vtp(file("skeleton.vtp"), result.graph);
  SMF::write_skeleton_swc(file("skeleton.swc"), result.graph);
  write_segments(file("segments.ply"), options, result);
  write_found_loops(file("found_loops.txt"), result);
  if (result.repaired)
  {
    SMF::write_repaired_vertices(file("repaired_vertices.txt"), *result.repaired);
    SMF::write_repaired_faces(file("repaired_faces.txt"), *result.repaired);
  }
  for (std::size_t i = 0; i < result.parts.size(); ++i)
    if (result.parts[i].foliation)
      write_foliation_files(has_several_parts(result) ? folder / ("part_" + std::to_string(i))
                                                      : folder,
                            result.parts[i], result);
}

} // namespace main_program

#endif // SMF_EXAMPLES_MAIN_PROGRAM_WRITE_FILES_H
