// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Session.h"

#include "problems.h"
#include "walks.h"

#include <CGAL/Surface_mesh_foliation/Foliation_visitor.h>
#include <CGAL/Surface_mesh_foliation/Leaf_tracer.h>
#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/add_missing_poles.h>
#include <CGAL/Surface_mesh_foliation/automatic_loops.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/feature_poles.h>
#include <CGAL/Surface_mesh_foliation/loops.h>
#include <CGAL/Surface_mesh_foliation/openings.h>
#include <CGAL/Surface_mesh_foliation/picked_loops.h>

#include <CGAL/Named_function_parameters.h>

#include <chrono>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace smf_engine {

namespace {

// More leaves are sampled where a chord between two is farther from the leaf between them than
// this, in units of its radius. The main program does the same.
constexpr double max_chord_deviation = 0.1;

class Stopwatch
{
public:
  // the time since the last call, or since the beginning
  double lap()
  {
    const Clock::time_point now = Clock::now();
    const std::chrono::duration<double, std::milli> result = now - m_last;
    m_last = now;
    return result.count();
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point m_last = Clock::now();
};

// Tells how far a solver has come, and ends it if nobody wants the result any longer.
class Visitor : public SMF::Default_foliation_visitor
{
public:
  Visitor(const Progress& progress, const Show_sketch& show_sketch, const System& system)
    : m_progress(progress), m_show_sketch(show_sketch), m_system(system)
  {}

  void at_start(const std::vector<std::size_t>& arcs)
  {
    if (m_show_sketch)
      m_show_sketch(sketch_of(m_system, arcs));
  }
  bool after_iteration(const SMF::Foliation_statistics& statistics)
  {
    return tell(m_system.mesh().number_of_vertices(), statistics);
  }
  bool after_coarse_iteration(std::size_t number_of_vertices,
                              const SMF::Foliation_statistics& statistics)
  {
    return tell(number_of_vertices, statistics);
  }
  bool go_on() { return m_progress(m_stage); }

private:
  // That a result is unwanted is for go_on() to say.
  bool tell(std::size_t number_of_vertices, const SMF::Foliation_statistics& statistics)
  {
    m_stage = "solving on " + std::to_string(number_of_vertices) + " vertices, step " +
              std::to_string(statistics.number_of_iterations);
    return true;
  }

  const Progress& m_progress;
  const Show_sketch& m_show_sketch;
  const System& m_system;
  std::string m_stage = "solving";
};

void require_progress(const Progress& progress, const std::string& stage)
{
  if (!progress(stage))
    throw SMF::Stopped_exception();
}

Indices vertices_of(const std::vector<State_pole>& poles)
{
  Indices result;
  for (const State_pole& pole : poles)
    result.push_back(pole.vertex);
  return result;
}

} // namespace

Session::Session(const std::string& file, bool repairs, bool fills_openings)
  : m_loaded(file, repairs, fills_openings)
{}

Found_poles Session::find_poles()
{
  Stopwatch watch;
  const Mesh& mesh = m_loaded.mesh;
  std::vector<Vertex> found;
  Found_poles result;
  SMF::detect_feature_poles(
    mesh, std::back_inserter(found),
    SMF::parameters::significance_output_iterator(std::back_inserter(result.significances)));
  Poles_and_loops input;
  SMF::add_border_poles(mesh, input);
  for (const Vertex v : found)
    input.add_pole(v);
  SMF::add_missing_poles(mesh, input);
  for (const auto& entry : input.entries())
    if (!entry.pole.empty())
      result.poles.push_back({entry.pole[0], 1});
  result.significances.resize(result.poles.size(), std::numeric_limits<double>::infinity());
  m_milliseconds_for_poles = watch.lap();
  return result;
}

Loop_numbers Session::numbers(const std::vector<State_pole>& poles) const
{
  return {m_loaded.openings.size(), poles.size()};
}

Poles_and_loops Session::poles_of(const std::vector<State_pole>& poles) const
{
  Poles_and_loops result;
  SMF::add_border_poles(m_loaded.mesh, result);
  for (const State_pole& pole : poles)
    result.add_pole(vertex_of(pole.vertex, m_loaded.mesh), pole.height);
  return result;
}

// A picked loop keeps clear of the poles.
void Session::add_loop(const State_loop& loop, Poles_and_loops& input) const
{
  std::vector<Vertex> vertices;
  for (const Index v : loop.vertices)
    vertices.push_back(vertex_of(v, m_loaded.mesh));
  if (!loop.crossings.empty())
    input.add_loop(loop_of(loop.crossings, m_loaded.mesh), loop.height);
  else if (loop.is_found)
    input.add_loop(SMF::loop_from_edge_cycle(vertices, m_loaded.mesh), loop.height);
  else
    input.set_height(SMF::add_loop_through_vertices(vertices, m_loaded.mesh, input), loop.height);
}

void Session::add_given_loops(const State& state, Poles_and_loops& input) const
{
  for (const State_loop& loop : state.loops)
    add_loop(loop, input);
}

// Whether canonical loops are found within seconds: a pants decomposition has few loops. The main
// program decides likewise.
bool Session::is_simple_enough(const Poles_and_loops& poles) const
{
  constexpr std::size_t most_loops = 50;
  return 3 * m_loaded.genus() + poles.size() <= most_loops + 3;
}

void Session::add_handle_loops(Result& result, Poles_and_loops& input) const
{
  if (m_loaded.genus() == 0)
    return;
  const std::size_t first = input.size();
  SMF::propose_loops(m_loaded.mesh, input);
  for (std::size_t i = first; i < input.size(); ++i)
    result.state.loops.push_back(found_loop(input.entries()[i].loop, m_loaded.mesh));
}

void Session::add_hierarchy_loops(Result& result, Poles_and_loops& input)
{
  find_hierarchy(result.state.poles);
  const double detail = result.state.mode == Mode::ALL ? 0 : result.state.detail;
  for (const std::size_t i : m_hierarchy->level(detail))
  {
    const Loop& loop = m_hierarchy->loops()[i].loop;
    input.add_loop(loop);
    result.state.loops.push_back(found_loop(loop, m_loaded.mesh));
  }
}

void Session::add_found_loops(Result& result, Poles_and_loops& input)
{
  State& state = result.state;
  state.loops.clear();
  if (state.mode == Mode::CANONICAL && !is_simple_enough(input))
  {
    state.mode = Mode::STAR;
    result.notes.emplace_back("So many poles and handles have too many canonical loops to find; "
                              "the graph shows the handles only.");
  }
  if (state.mode == Mode::STAR)
    add_handle_loops(result, input);
  else
    add_hierarchy_loops(result, input);
}

// Loops of the hierarchy come first among those of the state, in their order.
void Session::set_moduli(Result& result) const
{
  if (result.state.mode != Mode::CANONICAL && result.state.mode != Mode::ALL)
    return;
  const double detail = result.state.mode == Mode::ALL ? 0 : result.state.detail;
  const std::vector<std::size_t> level = m_hierarchy->level(detail);
  for (Result_arc& arc : result.arcs)
    if (arc.loop >= 0)
    {
      const auto& loop = m_hierarchy->loops()[level[static_cast<std::size_t>(arc.loop)]];
      arc.modulus = loop.modulus;
      arc.margin = loop.margin();
    }
}

// The hierarchy does not depend on heights.
void Session::find_hierarchy(const std::vector<State_pole>& poles)
{
  const Indices vertices = vertices_of(poles);
  if (m_hierarchy && m_poles_of_hierarchy == vertices)
    return;
  m_hierarchy = SMF::loop_hierarchy(m_loaded.mesh, poles_of(poles));
  m_poles_of_hierarchy = vertices;
}

const std::vector<SMF::Canonical_loop<Mesh>>& Session::hierarchy(
  const std::vector<State_pole>& poles)
{
  try
  {
    find_hierarchy(poles);
  }
  catch (const SMF::Foliation_exception& exception)
  {
    rethrow(exception, poles);
  }
  return m_hierarchy->loops();
}

// The mesh is checked once.
System Session::system_of(const Poles_and_loops& input) const
{
  return m_foliation ? System(m_foliation->system(), input) : System(m_loaded.mesh, input);
}

const Result& Session::solve(const State& state, const Progress& progress)
{
  Stopwatch watch;
  Result result;
  result.state = state;
  result.milliseconds.poles = m_milliseconds_for_poles;
  try
  {
    Poles_and_loops input = poles_of(state.poles);
    require_progress(progress, "looking for loops");
    if (state.mode == Mode::GIVEN)
      add_given_loops(state, input);
    else
      add_found_loops(result, input);
    const System system = system_of(input);
    result.milliseconds.loops = watch.lap();
    Visitor visitor(progress, m_show_sketch, system);
    const Foliation foliation =
      m_solver.solve(system, CGAL::parameters::visitor(std::ref(visitor)));
    result.milliseconds.solve = watch.lap();
    require_progress(progress, "cutting the mesh");
    Embedding embedding = SMF::reeb_graph_embedding(
      foliation, SMF::parameters::max_chord_deviation(max_chord_deviation));
    Graph graph;
    SMF::reeb_graph(foliation, graph, embedding);
    read_foliation(foliation, graph, numbers(state.poles), result);
    set_moduli(result);
    result.milliseconds.extract = watch.lap();
    m_foliation = foliation;
    m_embedding = std::move(embedding);
    m_graph = std::move(graph);
    m_result = std::move(result);
  }
  catch (const SMF::Foliation_exception& exception)
  {
    rethrow(exception, state.poles);
  }
  return m_result;
}

void Session::rethrow(const SMF::Foliation_exception& exception,
                      const std::vector<State_pole>& poles) const
{
  throw SMF::Foliation_exception(in_terms_of_state(exception.problem(), numbers(poles), poles));
}

const Foliation& Session::last_foliation() const
{
  if (!m_foliation)
    throw SMF::Invalid_parameter_exception(
      {SMF::Problem_kind::INVALID_PARAMETER, "there is no result yet: solve first", {}, {}, {}});
  return *m_foliation;
}

Leaves Session::leaves(std::size_t number_per_arc) const
{
  const Foliation& foliation = last_foliation();
  const SMF::Leaf_tracer<Mesh> tracer(foliation);
  Leaves result;
  result.first.push_back(0);
  for (std::size_t arc = 0; arc < foliation.system().number_of_arcs(); ++arc)
  {
    std::vector<SMF::Leaf<Point>> leaves;
    tracer.evenly_spaced_leaves(arc, number_per_arc, std::back_inserter(leaves));
    for (const SMF::Leaf<Point>& leaf : leaves)
    {
      for (const Point& p : leaf.points)
        append(p, result.points);
      result.first.push_back(static_cast<Index>(result.points.size() / 3));
      result.arcs.push_back(static_cast<Index>(arc));
    }
  }
  return result;
}

Loop_check Session::check_loop(const Indices& picks, const State& state) const
{
  const Mesh& mesh = m_loaded.mesh;
  Loop_check result;
  result.path = path_through(picks, mesh);
  try
  {
    Poles_and_loops input = poles_of(state.poles);
    add_given_loops(state, input);
    if (picks.size() < 3)
      return result;
    State_loop loop;
    loop.vertices = picks;
    add_loop(loop, input);
    result.path = walk_to_right_of(input.entries().back().loop, mesh);
  }
  catch (const SMF::Foliation_exception& exception)
  {
    result.problem = in_terms_of_state(exception.problem(), numbers(state.poles), state.poles);
  }
  return result;
}

} // namespace smf_engine
