// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_ENGINE_SESSION_H
#define SMF_ENGINE_SESSION_H

#include "Loaded_mesh.h"
#include "Result.h"
#include "Sketch.h"
#include "State.h"
#include "types.h"

#include <CGAL/Surface_mesh_foliation/Foliation_solver.h>
#include <CGAL/Surface_mesh_foliation/canonical_loops.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace smf_engine {

// Is told what is at work, and returns whether to go on.
using Progress = std::function<bool(const std::string& stage)>;

struct Found_poles
{
  std::vector<State_pole> poles;
  Doubles significances; // infinite for poles that a surface needs in any case
};

struct Leaves
{
  Doubles points;
  Indices first, arcs; // leaf i has the points from first[i] to first[i + 1] - 1
};

struct Loop_check
{
  Indices path; // through the picked vertices; not closed if there are fewer than three
  std::optional<SMF::Problem> problem;
};

// One mesh, and what a user does with it. After an exception, everything is as it was.
//
// In problems that are thrown, loops have their numbers in the state, and those around poles are
// given by the vertices of these.
class Session
{
public:
  // Reads a mesh; see Loaded_mesh.
  Session(const std::string& file, bool repairs, bool fills_openings);

  const Loaded_mesh& loaded() const { return m_loaded; }

  Found_poles find_poles();

  // The function is called within `solve()`, as early as parts are known.
  void show_sketches(Show_sketch show) { m_show_sketch = std::move(show); }

  // Computes a foliation, with what can be kept from the one before.
  const Result& solve(const State& state, const Progress& progress);

  const std::vector<SMF::Canonical_loop<Mesh>>& hierarchy(const std::vector<State_pole>& poles);

  // The following are about the last result; they throw if there is none.
  Leaves leaves(std::size_t number_per_arc) const;
  void write(const std::string& what, const std::string& file) const;

  // Whether a loop through the picked vertices is compatible with poles and loops. Of the state
  // only these matter.
  Loop_check check_loop(const Indices& picks, const State& state) const;

private:
  Loop_numbers numbers(const std::vector<State_pole>& poles) const;
  Poles_and_loops poles_of(const std::vector<State_pole>& poles) const;
  void find_hierarchy(const std::vector<State_pole>& poles);
  void add_loop(const State_loop& loop, Poles_and_loops& input) const;
  void add_given_loops(const State& state, Poles_and_loops& input) const;
  void add_found_loops(Result& result, Poles_and_loops& input);
  void add_handle_loops(Result& result, Poles_and_loops& input) const;
  void add_hierarchy_loops(Result& result, Poles_and_loops& input);
  bool is_simple_enough(const Poles_and_loops& poles) const;
  System system_of(const Poles_and_loops& input) const;
  void set_moduli(Result& result) const;
  [[noreturn]] void rethrow(const SMF::Foliation_exception& exception,
                            const std::vector<State_pole>& poles) const;
  const Foliation& last_foliation() const;

  Loaded_mesh m_loaded;
  SMF::Foliation_solver<Mesh> m_solver;
  Show_sketch m_show_sketch; // may be empty

  Indices m_poles_of_hierarchy;
  std::optional<SMF::Loop_hierarchy<Mesh>> m_hierarchy; // for these poles

  double m_milliseconds_for_poles = 0;
  Result m_result;
  std::optional<Foliation> m_foliation; // of the result, as the following
  Embedding m_embedding;
  Graph m_graph;
};

} // namespace smf_engine

#endif // SMF_ENGINE_SESSION_H
