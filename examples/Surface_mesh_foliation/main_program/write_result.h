// What the main program prints, and the files that it writes.

#ifndef SMF_EXAMPLES_MAIN_PROGRAM_WRITE_RESULT_H
#define SMF_EXAMPLES_MAIN_PROGRAM_WRITE_RESULT_H

#include "Options.h"
#include "Result.h"

#include <boost/range/iterator_range.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <map>
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
  for (const auto& singularity : result.singularities)
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

inline Json graph_to_json(const Graph& graph)
{
  Json nodes = Json::array(), arcs = Json::array();
  std::vector<std::size_t> degrees;
  for (const auto v : boost::make_iterator_range(vertices(graph)))
  {
    degrees.push_back(degree(v, graph));
    nodes.push_back({{"id", graph[v].id},
                     {"kind", SMF::name(graph[v].kind)},
                     {"pole", graph[v].pole},
                     {"genus", graph[v].genus},
                     {"degree", degrees.back()},
                     {"point", to_json(graph[v].point)}});
  }
  std::sort(degrees.begin(), degrees.end());
  for (const auto& e : boost::make_iterator_range(edges(graph)))
    arcs.push_back({{"id", graph[e].loop},
                    {"nodes", {source(e, graph), target(e, graph)}},
                    {"loop", graph[e].loop},
                    {"height", graph[e].height},
                    {"flux", graph[e].flux},
                    {"length", SMF::length(graph[e].polyline)},
                    {"area", graph[e].area}});
  const std::size_t cycles = num_edges(graph) + 1 - num_vertices(graph); // it is connected
  return {{"nodes", nodes}, {"arcs", arcs}, {"cycles", cycles}, {"degrees", degrees}};
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

inline Json to_json(const Options& options, const Result& result)
{
  const SMF::Foliation_statistics& statistics = result.foliation->statistics();
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
    {"openings", {{"ends", result.number_of_ends}, {"filled", result.number_of_filled_openings}}},
    {"genus", result.foliation->system().genus()},
    {"poles", result.poles},
    {"loops", result.input.size()},
    {"foliation",
     {{"solver", options.solver},
      {"energy", statistics.energy},
      {"optimality", statistics.optimality},
      {"iterations", statistics.number_of_iterations},
      {"converged", statistics.has_converged},
      {"certified", statistics.is_certified}}},
    {"singularities", singularities_to_json(result)},
    {"reeb_graph", graph_to_json(result.graph)},
    {"components", components_to_json(result.graph)},
    {"seconds", seconds}};
}

inline void print_table(const Result& result)
{
  const Graph& graph = result.graph;
  const SMF::Foliation_statistics& statistics = result.foliation->statistics();
  const std::size_t genus = result.foliation->system().genus();
  std::cout << result.number_of_vertices << " vertices, " << result.number_of_faces
            << " faces, genus " << genus << '\n';
  if (result.number_of_ends + result.number_of_filled_openings > 0)
    std::cout << "openings: " << result.number_of_ends << " ends, "
              << result.number_of_filled_openings << " filled\n";
  std::cout << "foliation: energy " << statistics.energy << ", optimality " << statistics.optimality
            << " after " << statistics.number_of_iterations << " iterations"
            << (statistics.has_converged ? "" : ", NOT CONVERGED")
            << ", certified\nReeb graph: " << num_vertices(graph) << " nodes, " << num_edges(graph)
            << " arcs, " << num_edges(graph) + 1 - num_vertices(graph) << " cycles\n\n";
  std::cout << "  arc  nodes        component   height      flux        length\n";
  for (const auto& e : boost::make_iterator_range(edges(graph)))
  {
    const std::string nodes =
      std::to_string(source(e, graph)) + " - " + std::to_string(target(e, graph));
    std::cout << std::setw(5) << graph[e].loop << "  " << std::left << std::setw(13) << nodes
              << std::setw(12) << SMF::name(graph[e].component) << std::setw(12) << graph[e].height
              << std::setw(12) << graph[e].flux << SMF::length(graph[e].polyline) << std::right
              << '\n';
  }
  std::cout << "\nseconds:";
  for (const auto& [stage, time] : result.seconds)
    std::cout << ' ' << stage << ' ' << std::setprecision(3) << time;
  std::cout << '\n';
}

inline void write_files(const Options& options, const Result& result)
{
  std::filesystem::create_directories(options.output);
  const auto file = [&](const char* name) {
    return (std::filesystem::path(options.output) / name).string();
  };
  SMF::write_reeb_graph_graphml(file("reeb_graph.graphml"), result.graph);
  SMF::write_reeb_graph_dot(file("reeb_graph.dot"), result.graph);
  SMF::write_skeleton_ply(file("skeleton.ply"), result.graph);
  SMF::write_leaves_ply(file("leaves.ply"), *result.foliation, result.embedding);
  SMF::write_components_ply(file("components.ply"), *result.foliation);
  SMF::write_foliation_ply(file("foliation.ply"), *result.foliation);
  SMF::write_skeleton_vtp(file("skeleton.vtp"), result.graph);
  SMF::write_leaves_vtp(file("leaves.vtp"), *result.foliation, result.embedding);
  SMF::write_components_vtp(file("components.vtp"), *result.foliation);
  SMF::write_foliation_vtp(file("foliation.vtp"), *result.foliation);
  SMF::write_singularities_vtp(file("singularities.vtp"), *result.foliation);
}

} // namespace main_program

#endif // SMF_EXAMPLES_MAIN_PROGRAM_WRITE_RESULT_H
