// What the main program prints, and the files that it writes.

#ifndef SMF_EXAMPLES_MAIN_PROGRAM_WRITE_RESULT_H
#define SMF_EXAMPLES_MAIN_PROGRAM_WRITE_RESULT_H

#include "Options.h"
#include "Result.h"

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/centroid.h>

#include <boost/range/iterator_range.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace main_program {

using Json = nlohmann::ordered_json;

inline Json to_json(const Point_3& p)
{
  return {p.x(), p.y(), p.z()};
}

inline Json singularities_to_json(const Result& result)
{
  int center_poles = 0, thorn_poles = 0;
  std::map<int, int> saddles; // number by order
  for (const Part& part : result.parts)
    for (const auto& singularity : part.singularities)
      if (singularity.index < 0)
        ++saddles[-singularity.index];
      else
        ++(singularity.index == 2 ? center_poles : thorn_poles);
  Json orders = Json::object();
  for (const auto& [order, number] : saddles)
    orders[std::to_string(order)] = number;
  return {{"center_poles", center_poles},
          {"thorn_poles", thorn_poles},
          {"saddles", orders},
          {"centre_poles", center_poles}}; // deprecated: the former name of center_poles
}

// the vertices of a pole: of an opening, those of its border
inline std::vector<std::size_t> pole_numbers(const Result& result,
                                             const Part_mesh& mesh,
                                             const Part_input::Entry& entry)
{
  std::vector<std::size_t> numbers;
  for (const Vertex v : entry.pole)
    numbers.push_back(result.number_of_vertex[v]);
  if (entry.pole.empty())
    for (const Vertex v : vertices_around_face(entry.border, mesh))
      numbers.push_back(result.number_of_vertex[v]);
  return numbers;
}

inline Json poles_to_json(const Result& result)
{
  Json poles = Json::array();
  for (std::size_t i = 0; i < result.parts.size(); ++i)
    for (const auto& entry : result.parts[i].input.entries())
      if (entry.is_pole_loop())
        poles.push_back(pole_numbers(result, result.part_meshes[i], entry));
  return poles;
}

// the points where a loop crosses edges
inline std::vector<Point_3> polyline(const SMF::Loop<Part_mesh>& loop, const Mesh& mesh)
{
  std::vector<Point_3> points;
  for (const auto& crossing : loop)
  {
    const Point_3 &p = mesh.point(mesh.source(crossing.halfedge)),
                  &q = mesh.point(mesh.target(crossing.halfedge));
    points.push_back(p + crossing.position * (q - p));
  }
  return points;
}

// of each loop that was found: its id, the centroid of its crossings, and its length
inline Json found_loops_to_json(const Result& result)
{
  Json loops = Json::array();
  std::size_t first = 0; // of the part
  for (const Part& part : result.parts)
  {
    for (std::size_t a = part.first_found_loop; a < part.end_of_found_loops; ++a)
    {
      std::vector<Point_3> points = polyline(part.input.entries()[a].loop, result.mesh);
      const Point_3 center = CGAL::centroid(points.begin(), points.end(), CGAL::Dimension_tag<0>());
      points.push_back(points.front());
      loops.push_back(
        {{"loop", first + a}, {"point", to_json(center)}, {"length", SMF::length(points)}});
    }
    first += part.input.size();
  }
  return loops;
}

inline Json repair_to_json(const Result& result)
{
  if (!result.repaired)
    return nullptr;
  const SMF::Repair_report& report = result.repaired->report;
  return {{"merged_vertices", report.merged_vertices},
          {"triangulated_faces", report.triangulated_faces},
          {"degenerate_faces", report.degenerate_faces},
          {"repeated_faces", report.repeated_faces},
          {"reversed_faces", report.reversed_faces},
          {"duplicated_vertices", report.duplicated_vertices},
          {"stitched_edges", report.stitched_edges},
          {"unused_vertices", report.unused_vertices}};
}

inline Json parts_to_json(const Result& result)
{
  Json parts = Json::array();
  for (std::size_t i = 0; i < result.parts.size(); ++i)
  {
    const Part& part = result.parts[i];
    Json json = {{"vertices", vertices(result.part_meshes[i]).size()},
                 {"faces", faces(result.part_meshes[i]).size()},
                 {"ends", part.number_of_ends},
                 {"loops", part.input.size()}};
    if (part.foliation)
    {
      json["genus"] = part.foliation->system().genus();
      json["nodes"] = part.foliation->system().number_of_nodes();
      json["arcs"] = part.foliation->system().number_of_arcs();
    }
    else
      json["error"] = part.error;
    parts.push_back(json);
  }
  return parts;
}

// The number of independent cycles. Each part of the graph is connected.
inline std::size_t number_of_cycles(const Result& result)
{
  const auto has_graph = [](const Part& part) { return part.error.empty(); };
  return num_edges(result.graph) +
         std::count_if(result.parts.begin(), result.parts.end(), has_graph) -
         num_vertices(result.graph);
}

inline Json graph_to_json(const Result& result)
{
  const Graph& graph = result.graph;
  Json nodes = Json::array(), arcs = Json::array();
  std::vector<std::size_t> degrees;
  for (const auto v : boost::make_iterator_range(vertices(graph)))
  {
    degrees.push_back(degree(v, graph));
    nodes.push_back({{"id", graph[v].id},
                     {"part", graph[v].part},
                     {"kind", SMF::name(graph[v].kind)},
                     {"pole", graph[v].pole},
                     {"genus", graph[v].genus},
                     {"degree", degrees.back()},
                     {"point", to_json(graph[v].point)}});
  }
  std::sort(degrees.begin(), degrees.end());
  for (const auto& e : boost::make_iterator_range(edges(graph)))
    arcs.push_back({{"id", graph[e].loop},
                    {"part", graph[e].part},
                    {"nodes", {source(e, graph), target(e, graph)}},
                    {"loop", graph[e].loop},
                    {"height", graph[e].height},
                    {"flux", graph[e].flux},
                    {"length", SMF::length(graph[e].polyline)},
                    {"area", graph[e].area}});
  return {
    {"nodes", nodes}, {"arcs", arcs}, {"cycles", number_of_cycles(result)}, {"degrees", degrees}};
}

inline Json components_to_json(const Graph& graph)
{
  std::map<SMF::Component_kind, int> number;
  for (const auto& e : boost::make_iterator_range(edges(graph)))
    ++number[graph[e].component];
  return {{"disks", number[SMF::Component_kind::DISK]},
          {"cylinders", number[SMF::Component_kind::CYLINDER]},
          {"spheres", number[SMF::Component_kind::SPHERE]}};
}

// The statistics of all parts: sums, and the worst.
inline SMF::Foliation_statistics statistics(const Result& result)
{
  SMF::Foliation_statistics all;
  all.has_converged = all.is_certified = true;
  for (const Part& part : result.parts)
    if (part.foliation)
    {
      const SMF::Foliation_statistics& one = part.foliation->statistics();
      all.energy += one.energy;
      all.optimality = (std::max)(all.optimality, one.optimality);
      all.number_of_iterations = (std::max)(all.number_of_iterations, one.number_of_iterations);
      all.has_converged = all.has_converged && one.has_converged;
      all.is_certified = all.is_certified && one.is_certified;
    }
  return all;
}

inline std::size_t number_of_ends(const Result& result)
{
  std::size_t number = 0;
  for (const Part& part : result.parts)
    number += part.number_of_ends;
  return number;
}

inline std::size_t genus(const Result& result)
{
  std::size_t sum = 0;
  for (const Part& part : result.parts)
    sum += part.foliation ? part.foliation->system().genus() : 0;
  return sum;
}

inline Json to_json(const Options& options, const Result& result)
{
  const SMF::Foliation_statistics all = statistics(result);
  Json seconds = Json::object();
  double total = 0;
  for (const auto& [stage, time] : result.seconds)
  {
    seconds[stage] = time;
    total += time;
  }
  seconds["total"] = total;
  return {
    {"vertices", result.number_of_vertices},
    {"faces", result.number_of_faces},
    {"repair", repair_to_json(result)},
    {"openings", {{"ends", number_of_ends(result)}, {"filled", result.number_of_filled_openings}}},
    {"parts", parts_to_json(result)},
    {"genus", genus(result)},
    {"poles", poles_to_json(result)},
    {"detector", result.detector.empty() ? Json() : Json(result.detector)},
    {"loops", number_of_loops(result)},
    {"found_loops", found_loops_to_json(result)},
    {"foliation",
     {{"solver", options.solver},
      {"energy", all.energy},
      {"optimality", all.optimality},
      {"iterations", all.number_of_iterations},
      {"converged", all.has_converged},
      {"certified", all.is_certified}}},
    {"singularities", singularities_to_json(result)},
    {"reeb_graph", graph_to_json(result)},
    {"components", components_to_json(result.graph)},
    {"seconds", seconds}};
}

// what was found, and by which detector
inline void print_poles(const Result& result)
{
  std::cout << "poles:";
  for (std::size_t i = 0; i < result.parts.size(); ++i)
  {
    const Part& part = result.parts[i];
    for (const auto& entry : part.input.entries())
      if (!entry.pole.empty() || entry.is_pole_loop())
      {
        const std::vector<std::size_t> numbers = pole_numbers(result, result.part_meshes[i], entry);
        if (entry.pole.empty())
          std::cout << " opening(" << numbers.size() << " vertices)";
        else
          for (std::size_t k = 0; k < numbers.size(); ++k)
            std::cout << (k == 0 ? ' ' : '-') << numbers[k];
      }
  }
  std::size_t found = 0, loops = 0;
  for (const Part& part : result.parts)
  {
    found += part.number_of_found_poles;
    loops += part.end_of_found_loops - part.first_found_loop;
  }
  if (found > 0)
    std::cout << "; " << found << " of them found"
              << (result.detector.empty() ? "" : " by the " + result.detector);
  std::cout << '\n';
  if (loops > 0)
    std::cout << "loops found: " << loops << '\n';
}

inline void print_summary(const Result& result)
{
  const Graph& graph = result.graph;
  const SMF::Foliation_statistics all = statistics(result);
  std::cout << result.number_of_vertices << " vertices, " << result.number_of_faces
            << " faces, genus " << genus(result) << '\n';
  if (result.repaired)
    for (const std::string& line : SMF::descriptions(result.repaired->report))
      std::cout << "repair: " << line << '\n';
  if (number_of_ends(result) + result.number_of_filled_openings > 0)
    std::cout << "openings: " << number_of_ends(result) << " ends, "
              << result.number_of_filled_openings << " filled\n";
  if (has_several_parts(result))
    std::cout << "parts: " << result.parts.size() << '\n';
  if (result.parts.size() < result.number_of_all_parts)
    std::cout << "parts left out: " << result.number_of_all_parts - result.parts.size() << '\n';
  print_poles(result);
  std::cout << "foliation: energy " << all.energy << ", optimality " << all.optimality << " after "
            << all.number_of_iterations << " iterations"
            << (all.has_converged ? "" : ", NOT CONVERGED")
            << ", certified\nReeb graph: " << num_vertices(graph) << " nodes, " << num_edges(graph)
            << " arcs, " << number_of_cycles(result) << " cycles\n\n";
}

inline void print_table(const Result& result)
{
  const Graph& graph = result.graph;
  print_summary(result);
  const bool tells_part = has_several_parts(result);
  std::cout << "  arc  " << (tells_part ? "part  " : "")
            << "nodes        component   height      flux        length\n";
  for (const auto& e : boost::make_iterator_range(edges(graph)))
  {
    const std::string nodes =
      std::to_string(source(e, graph)) + " - " + std::to_string(target(e, graph));
    std::cout << std::setw(5) << graph[e].loop << "  " << std::left;
    if (tells_part)
      std::cout << std::setw(6) << graph[e].part;
    std::cout << std::setw(13) << nodes << std::setw(12) << SMF::name(graph[e].component)
              << std::setw(12) << graph[e].height << std::setw(12) << graph[e].flux
              << SMF::length(graph[e].polyline) << std::right << '\n';
  }
  std::cout << "\nseconds:";
  for (const auto& [stage, time] : result.seconds)
    std::cout << ' ' << stage << ' ' << std::setprecision(3) << time;
  std::cout << '\n';
}

// ===  Files

using Path = std::filesystem::path;

// the mesh with the component of each face; a face of a part without graph has none
inline void write_segments(const std::string& file_name, const Result& result)
{
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
        component[f] += first;
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

// for each vertex or face of the file, a line with those of the mesh that it has become
inline void write_repair_maps(const Path& folder, const Result& result)
{
  std::ofstream of_vertices(folder / "repaired_vertices.txt");
  for (const std::size_t v : result.repaired->vertices)
    of_vertices << (v == SMF::Repaired_soup::none ? "-1" : std::to_string(v)) << '\n';
  std::ofstream of_faces(folder / "repaired_faces.txt");
  const std::vector<std::size_t>& first = result.repaired->first_faces;
  for (std::size_t f = 0; f + 1 < first.size(); ++f)
  {
    for (std::size_t g = first[f]; g < first[f + 1]; ++g)
      of_faces << (g == first[f] ? "" : " ") << g;
    of_faces << '\n';
  }
  of_vertices.close();
  of_faces.close();
  if (!of_vertices || !of_faces)
    throw std::runtime_error((folder / "repaired_vertices.txt").string() + ": cannot be written");
}

// what there is to see of the foliation of one part
inline void write_foliation_files(const Path& folder, const Part& part, const Result& result)
{
  std::filesystem::create_directories(folder);
  const auto file = [&](const char* name) { return (folder / name).string(); };
  const auto parameters = SMF::parameters::filled_face_map(result.is_filled);
  SMF::write_leaves_ply(file("leaves.ply"), *part.foliation, part.embedding);
  SMF::write_components_ply(file("components.ply"), *part.foliation, parameters);
  SMF::write_foliation_ply(file("foliation.ply"), *part.foliation, parameters);
  SMF::write_leaves_vtp(file("leaves.vtp"), *part.foliation, part.embedding);
  SMF::write_components_vtp(file("components.vtp"), *part.foliation, parameters);
  SMF::write_foliation_vtp(file("foliation.vtp"), *part.foliation, parameters);
  SMF::write_singularities_vtp(file("singularities.vtp"), *part.foliation);
}

// The graph, and for each of several parts a folder of its own.
inline void write_files(const Options& options, const Result& result)
{
  const Path folder(options.output);
  std::filesystem::create_directories(folder);
  const auto file = [&](const char* name) { return (folder / name).string(); };
  SMF::write_reeb_graph_graphml(file("reeb_graph.graphml"), result.graph);
  SMF::write_reeb_graph_dot(file("reeb_graph.dot"), result.graph);
  SMF::write_skeleton_ply(file("skeleton.ply"), result.graph);
  SMF::write_skeleton_vtp(file("skeleton.vtp"), result.graph);
  SMF::write_skeleton_swc(file("skeleton.swc"), result.graph);
  write_segments(file("segments.ply"), result);
  write_found_loops(file("found_loops.txt"), result);
  if (result.repaired)
    write_repair_maps(folder, result);
  for (std::size_t i = 0; i < result.parts.size(); ++i)
    if (result.parts[i].foliation)
      write_foliation_files(has_several_parts(result) ? folder / ("part_" + std::to_string(i))
                                                      : folder,
                            result.parts[i], result);
}

} // namespace main_program

#endif // SMF_EXAMPLES_MAIN_PROGRAM_WRITE_RESULT_H
