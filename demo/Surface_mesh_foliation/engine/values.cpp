// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "values.h"

#include "problems.h"
#include "walks.h"

#include <cmath>
#include <string>
#include <vector>

namespace smf_engine {

namespace {

using emscripten::val;

// a typed array that belongs to JavaScript
template <class T>
val copy(const std::vector<T>& values, const char* type)
{
  return val::global(type).new_(val(emscripten::typed_memory_view(values.size(), values.data())));
}

val to_value(const Indices& values)
{
  return copy(values, "Uint32Array");
}

val to_value(const Doubles& values)
{
  return copy(values, "Float64Array");
}

template <class T, class Function>
val to_array(const std::vector<T>& values, const Function& value_of)
{
  val result = val::array();
  for (const T& value : values)
    result.call<void>("push", value_of(value));
  return result;
}

// a plain array of numbers
template <class T>
val to_numbers(const std::vector<T>& values)
{
  return to_array(values, [](T value) { return val(static_cast<double>(value)); });
}

val to_strings(const std::vector<std::string>& values)
{
  return to_array(values, [](const std::string& value) { return val(value); });
}

val to_value(const Point& p)
{
  return to_numbers(Doubles{p.x(), p.y(), p.z()});
}

// null if it is not a number
val number_or_null(double number)
{
  return std::isnan(number) ? val::null() : val(number);
}

val to_value(const State_pole& pole)
{
  val result = val::object();
  result.set("vertex", pole.vertex);
  result.set("height", pole.height);
  return result;
}

val to_value(const State_loop& loop)
{
  val result = val::object();
  result.set("vertices", to_numbers(loop.vertices));
  result.set("height", loop.height);
  if (loop.is_found)
    result.set("found", true);
  if (!loop.crossings.empty())
  {
    Doubles numbers;
    for (const State_crossing& crossing : loop.crossings)
      for (const double number :
           {double(crossing.source), double(crossing.target), crossing.position})
        numbers.push_back(number);
    result.set("crossings", to_numbers(numbers));
  }
  return result;
}

const char* const names_of_modes[] = {"canonical", "star", "all", "given"}; // as in Mode

val to_value(const State& state)
{
  val result = val::object();
  result.set("mode", val(std::string(names_of_modes[static_cast<int>(state.mode)])));
  result.set("detail", state.detail);
  result.set("poles", to_array(state.poles, [](const auto& pole) { return to_value(pole); }));
  result.set("loops", to_array(state.loops, [](const auto& loop) { return to_value(loop); }));
  return result;
}

val to_value(const Result_node& node)
{
  val result = val::object();
  result.set("id", node.id);
  result.set("kind", node.kind);
  result.set("pole", node.pole);
  result.set("degree", node.degree);
  result.set("point", to_value(node.point));
  result.set("symmetry", node.symmetry);
  return result;
}

val to_value(const Result_arc& arc)
{
  val result = val::object();
  result.set("id", arc.id);
  result.set("source", arc.source);
  result.set("target", arc.target);
  result.set("component", arc.component);
  result.set("height", arc.height);
  result.set("flux", arc.flux);
  result.set("area", arc.area);
  result.set("length", arc.length);
  result.set("modulus", number_or_null(arc.modulus));
  result.set("margin", number_or_null(arc.margin));
  result.set("symmetry", arc.symmetry);
  result.set("pole", arc.pole);
  result.set("loop", arc.loop);
  return result;
}

val to_value(const Result_polyline& polyline)
{
  val result = val::object();
  result.set("arc", polyline.arc);
  result.set("points", to_value(polyline.points));
  result.set("radii", to_value(polyline.radii));
  return result;
}

val to_value(const Result_singularity& singularity)
{
  val result = val::object();
  result.set("point", to_value(singularity.point));
  result.set("index", singularity.index);
  return result;
}

val to_value(const Milliseconds& milliseconds)
{
  val result = val::object();
  result.set("poles", milliseconds.poles);
  result.set("loops", milliseconds.loops);
  result.set("solve", milliseconds.solve);
  result.set("extract", milliseconds.extract);
  result.set("total", milliseconds.loops + milliseconds.solve + milliseconds.extract);
  return result;
}

std::vector<val> elements_of(const val& array)
{
  std::vector<val> result;
  const auto size = array["length"].as<unsigned int>();
  for (unsigned int i = 0; i < size; ++i)
    result.push_back(array[i]);
  return result;
}

[[noreturn]] void refuse(const std::string& message)
{
  throw SMF::Invalid_parameter_exception(
    {SMF::Problem_kind::INVALID_PARAMETER, message, {}, {}, {}});
}

// A number from a link may be anything.
Index index_of(double number)
{
  if (!(number >= 0 && number < 4294967295. && std::floor(number) == number))
    refuse("a vertex has the number " + std::to_string(number) + ", which is no whole number");
  return static_cast<Index>(number);
}

Mode mode_of(const std::string& name)
{
  for (const Mode mode : {Mode::CANONICAL, Mode::STAR, Mode::ALL, Mode::GIVEN})
    if (name == names_of_modes[static_cast<int>(mode)])
      return mode;
  refuse("there is no mode '" + name + "'");
}

std::vector<State_crossing> crossings_of(const val& array)
{
  const Doubles numbers = emscripten::convertJSArrayToNumberVector<double>(array);
  if (numbers.size() % 3 != 0)
    refuse("crossings are not given by three numbers each");
  std::vector<State_crossing> result;
  for (std::size_t i = 0; i < numbers.size(); i += 3)
    result.push_back({index_of(numbers[i]), index_of(numbers[i + 1]), numbers[i + 2]});
  return result;
}

State_loop loop_of(const val& loop)
{
  State_loop result;
  result.vertices = indices_of(loop["vertices"]);
  result.height = loop["height"].as<double>();
  result.is_found = loop["found"].isTrue();
  if (!loop["crossings"].isUndefined())
    result.crossings = crossings_of(loop["crossings"]);
  return result;
}

} // namespace

Indices indices_of(const val& array)
{
  Indices result;
  for (const double number : emscripten::convertJSArrayToNumberVector<double>(array))
    result.push_back(index_of(number));
  return result;
}

std::vector<State_pole> poles_of(const val& poles)
{
  std::vector<State_pole> result;
  for (const val& pole : elements_of(poles))
    result.push_back({index_of(pole["vertex"].as<double>()), pole["height"].as<double>()});
  return result;
}

State state_of(const val& state)
{
  State result;
  result.mode = mode_of(state["mode"].as<std::string>());
  result.detail = state["detail"].as<double>();
  if (!(result.detail >= 0))
    refuse("the detail, the least modulus of a loop, is not at least 0");
  result.poles = poles_of(state["poles"]);
  for (const val& loop : elements_of(state["loops"]))
    result.loops.push_back(loop_of(loop));
  return result;
}

val to_value(const Loaded_mesh& loaded)
{
  val result = val::object();
  result.set("numberOfVertices", loaded.mesh.number_of_vertices());
  result.set("numberOfFaces", loaded.mesh.number_of_faces());
  result.set("numberOfEdges", loaded.mesh.number_of_edges());
  result.set("genus", loaded.genus());
  result.set("numberOfOpenings", loaded.openings.size());
  result.set("openings", to_array(loaded.vertices_of_openings(),
                                  [](const Indices& border) { return to_numbers(border); }));
  result.set("positions", to_value(loaded.positions()));
  result.set("triangles", to_value(loaded.triangles()));
  result.set("edges", to_value(loaded.edges()));
  result.set("repair", to_strings(loaded.report));
  return result;
}

val to_value(const Found_poles& found)
{
  val result = val::object();
  result.set("poles", to_array(found.poles, [](const auto& pole) { return to_value(pole); }));
  result.set("significances", to_numbers(found.significances));
  return result;
}

val to_value(const Result& result)
{
  val value = val::object();
  value.set("state", to_value(result.state));
  value.set("notes", to_strings(result.notes));
  value.set("certified", result.is_certified);
  value.set("energy", result.energy);
  value.set("optimality", result.optimality);
  value.set("iterations", result.number_of_iterations);
  value.set("nodes", to_array(result.nodes, [](const auto& node) { return to_value(node); }));
  value.set("arcs", to_array(result.arcs, [](const auto& arc) { return to_value(arc); }));
  value.set("partPositions", to_value(result.part_positions));
  value.set("partTriangles", to_value(result.part_triangles));
  value.set("partLabels", to_value(result.part_labels));
  value.set("skeleton", to_array(result.skeleton, [](const auto& line) { return to_value(line); }));
  value.set("edgeValues", to_value(result.edge_values));
  value.set("singularities",
            to_array(result.singularities, [](const auto& place) { return to_value(place); }));
  value.set("milliseconds", to_value(result.milliseconds));
  return value;
}

val to_value(const std::vector<SMF::Canonical_loop<Mesh>>& hierarchy, const Mesh& mesh)
{
  return to_array(hierarchy, [&mesh](const auto& loop) {
    val value = to_value(found_loop(loop.loop, mesh));
    value.set("modulus", loop.modulus);
    value.set("margin", loop.margin());
    value.set("separating", loop.is_separating);
    value.set("cutsHandle", loop.cuts_handle);
    return value;
  });
}

val to_value(const Sketch& sketch)
{
  val result = val::object();
  result.set("partLabels", to_value(sketch.part_labels));
  result.set("ends", to_value(sketch.ends));
  return result;
}

val to_value(const Leaves& leaves)
{
  val result = val::object();
  result.set("points", to_value(leaves.points));
  result.set("first", to_value(leaves.first));
  result.set("arc", to_value(leaves.arcs));
  return result;
}

val to_value(const Loop_check& check)
{
  val result = val::object();
  result.set("path", to_numbers(check.path));
  result.set("problem", check.problem ? to_value(*check.problem) : val::null());
  return result;
}

val to_value(const SMF::Problem& problem)
{
  val result = val::object();
  result.set("kind", std::string(SMF::name(problem.kind)));
  result.set("message", problem.message);
  result.set("vertices", to_numbers(problem.vertices));
  result.set("faces", to_numbers(problem.faces));
  result.set("loops", to_numbers(problem.loops));
  return result;
}

} // namespace smf_engine
