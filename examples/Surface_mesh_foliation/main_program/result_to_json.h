// A result as JSON.

#ifndef SMF_EXAMPLES_MAIN_PROGRAM_RESULT_TO_JSON_H
#define SMF_EXAMPLES_MAIN_PROGRAM_RESULT_TO_JSON_H

#include "Options.h"
#include "Result.h"
#include "summarize_result.h"

#include <CGAL/centroid.h>

#include <boost/range/iterator_range.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
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
  for (const Part& part : result.parts)
    for (const auto& singularity : part.singularities)
      if (singularity.index < 0)
        ++saddles[-singularity.index];
      else
        ++(singularity.index == 2 ? center_poles : thorn_poles);
  Json orders = Json::object();
  for (const auto& [order, number] : saddles)
    orders[std::to_string(order)] = number;
  return {{"center_poles", center_poles}, {"thorn_poles", thorn_poles}, {"saddles", orders}};
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

// by pole, how much of a limb it is the end of; null for poles that were not found, or that a
// foliation needs in any case
inline Json significances_to_json(const Result& result)
{
  Json significances = Json::array();
  for (const Part& part : result.parts)
    for (std::size_t a = 0; a < part.input.size(); ++a)
      if (part.input.entries()[a].is_pole_loop())
      {
        const auto found = part.significances.find(a);
        const bool is_known = found != part.significances.end() && std::isfinite(found->second);
        significances.push_back(is_known ? Json(found->second) : Json());
      }
  return significances;
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

inline void add_canonical_loop(const Options& options,
                               const SMF::Canonical_loop<Part_mesh>& loop,
                               Json& json)
{
  json["modulus"] = loop.modulus;
  json["dominance"] = std::isfinite(loop.dominance) ? Json(loop.dominance) : Json();
  json["margin"] = loop.margin(min_modulus(options));
  json["near_bound"] = loop.is_near_bound(min_modulus(options));
  json["separating"] = loop.is_separating;
  json["completing"] = is_completing(options, loop);
}

// of each loop that was found: its id, the centroid of its crossings, its length, and what makes it
// canonical
inline Json found_loops_to_json(const Options& options, const Result& result)
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
      if (!part.canonical_loops.empty())
        add_canonical_loop(options, part.canonical_loops[a - part.first_found_loop], loops.back());
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

// the numbers of arcs that symmetries of the graph exchange, class by class
inline Json symmetries_to_json(const Graph& graph)
{
  Json classes = Json::array();
  for (const std::vector<std::size_t>& arcs : classes_of_arcs(graph))
    classes.push_back(arcs);
  return classes;
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
    {"pole_significances", significances_to_json(result)},
    {"detector", result.detector.empty() ? Json() : Json(result.detector)},
    {"loops", number_of_loops(result)},
    {"found_loops", found_loops_to_json(options, result)},
    {"foliation",
     {{"solver", options.solver},
      {"energy", all.energy},
      {"optimality", all.optimality},
      {"iterations", all.number_of_iterations},
      {"converged", all.has_converged},
      {"certified", all.is_certified}}},
    {"singularities", singularities_to_json(result)},
    {"reeb_graph", graph_to_json(result)},
    {"symmetries", symmetries_to_json(result.graph)},
    {"components", components_to_json(result.graph)},
    {"seconds", seconds}};
}

} // namespace main_program

#endif // SMF_EXAMPLES_MAIN_PROGRAM_RESULT_TO_JSON_H
