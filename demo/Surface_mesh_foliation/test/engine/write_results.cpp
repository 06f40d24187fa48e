// write_results MESH...: what the engine computes on meshes, compiled natively, as one JSON array.
// For each mesh the poles that are found, and one result after another, as a user would change the
// state. compare.test.mjs does the same in WebAssembly.

#include "engine/Session.h"

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

using namespace smf_engine;
using Json = nlohmann::json;

namespace {

Json to_json(const Point& p)
{
  return {p.x(), p.y(), p.z()};
}

Json to_json(const std::vector<State_pole>& poles)
{
  Json result = Json::array();
  for (const State_pole& pole : poles)
    result.push_back(pole.vertex);
  return result;
}

Json to_json(const State_loop& loop)
{
  Json crossings = Json::array();
  for (const State_crossing& crossing : loop.crossings)
    crossings.insert(crossings.end(), {crossing.source, crossing.target, crossing.position});
  return {{"vertices", loop.vertices}, {"crossings", crossings}};
}

Json to_json(const Result_node& node)
{
  return {{"id", node.id},         {"kind", node.kind},         {"pole", node.pole},
          {"degree", node.degree}, {"symmetry", node.symmetry}, {"point", to_json(node.point)}};
}

// JSON has no number for one that is missing: null.
Json to_json(const Result_arc& arc)
{
  return {{"id", arc.id},         {"source", arc.source},     {"target", arc.target},
          {"pole", arc.pole},     {"loop", arc.loop},         {"component", arc.component},
          {"height", arc.height}, {"symmetry", arc.symmetry}, {"flux", arc.flux},
          {"area", arc.area},     {"length", arc.length},     {"modulus", arc.modulus},
          {"margin", arc.margin}};
}

template <class T>
Json all_to_json(const std::vector<T>& values)
{
  Json result = Json::array();
  for (const T& value : values)
    result.push_back(to_json(value));
  return result;
}

Json to_json(const Result& result)
{
  return {{"energy", result.energy},
          {"certified", result.is_certified},
          {"nodes", all_to_json(result.nodes)},
          {"arcs", all_to_json(result.arcs)},
          {"loops", all_to_json(result.state.loops)},
          {"partTriangles", result.part_triangles},
          {"partLabels", result.part_labels},
          {"edgeValues", result.edge_values}};
}

Json results_of(const std::string& file)
{
  Session session(file, true, false);
  const Found_poles found = session.find_poles();
  Json results = Json::array();
  const auto solve = [&](const State& state) {
    const Result& result = session.solve(state, [](const std::string&) { return true; });
    results.push_back(to_json(result));
    return result.state;
  };
  State state;
  state.poles = found.poles;
  const State canonical = solve(state);
  state.mode = Mode::ALL;
  solve(state);
  state.mode = Mode::STAR;
  solve(state);
  state = canonical; // with higher loops
  state.mode = Mode::GIVEN;
  for (State_loop& loop : state.loops)
    loop.height = 2;
  solve(state);
  if (!state.poles.empty())
  {
    state.poles.front().height = 3;
    solve(state);
  }
  Json leaves = Json::array();
  for (const Index first : session.leaves(3).first)
    leaves.push_back(first);
  return {{"file", file},
          {"report", session.loaded().report},
          {"genus", session.loaded().genus()},
          {"openings", session.loaded().vertices_of_openings()},
          {"triangles", session.loaded().triangles()},
          {"edges", session.loaded().edges()},
          {"poles", to_json(found.poles)},
          {"significances", found.significances},
          {"results", results},
          {"leaves", leaves}};
}

} // namespace

int main(int argc, char* argv[])
{
  Json all = Json::array();
  for (int i = 1; i < argc; ++i)
  {
    const std::string file = argv[i];
    try
    {
      all.push_back(results_of(file));
    }
    catch (const SMF::Foliation_exception& exception)
    {
      all.push_back({{"file", file}, {"error", exception.what()}});
    }
  }
  std::cout << all << std::endl;
  return std::cout ? EXIT_SUCCESS : EXIT_FAILURE;
}
