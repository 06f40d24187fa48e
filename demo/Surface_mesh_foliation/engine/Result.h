// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_ENGINE_RESULT_H
#define SMF_ENGINE_RESULT_H

#include "State.h"
#include "types.h"

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace smf_engine {

// What the page shows; the same as in protocol.ts.

struct Result_node
{
  std::size_t id = 0;
  std::string kind;
  int pole = -1; // of the state
  std::size_t degree = 0;
  Point point;
  std::size_t symmetry = 0;
};

struct Result_arc
{
  std::size_t id = 0, source = 0, target = 0;
  std::string component;
  double height = 0, flux = 0, area = 0, length = 0;
  // of a loop of the hierarchy, otherwise not a number
  double modulus = std::numeric_limits<double>::quiet_NaN();
  double margin = std::numeric_limits<double>::quiet_NaN();
  std::size_t symmetry = 0;
  int pole = -1, loop = -1; // of the state
};

struct Result_polyline
{
  std::size_t arc = 0;
  Doubles points, radii;
};

struct Result_singularity
{
  Point point;
  int index = 0;
};

struct Milliseconds
{
  double poles = 0, loops = 0, solve = 0, extract = 0;
};

struct Result
{
  State state; // with the loops that were found
  std::vector<std::string> notes;
  bool is_certified = false;
  double energy = 0, optimality = 0;
  int number_of_iterations = 0;
  std::vector<Result_node> nodes;
  std::vector<Result_arc> arcs;
  // the mesh cut along critical leaves, with the arc of each face
  Doubles part_positions;
  Indices part_triangles, part_labels;
  std::vector<Result_polyline> skeleton;
  Doubles edge_values;
  std::vector<Result_singularity> singularities;
  Milliseconds milliseconds;
};

// How many of the package's loops come first: those of openings, then those of the state's poles.
struct Loop_numbers
{
  std::size_t number_of_openings = 0, number_of_poles = 0;

  // the state's pole of a pole of the package, or -1
  int pole(int pole) const
  {
    return pole < static_cast<int>(number_of_openings)
             ? -1
             : pole - static_cast<int>(number_of_openings);
  }
  // the state's pole that a loop of the package runs around, or -1
  int pole_of_loop(std::size_t loop) const
  {
    return loop < number_of_openings + number_of_poles ? pole(static_cast<int>(loop)) : -1;
  }
  // the state's loop that a loop of the package is, or -1
  int loop(std::size_t loop) const
  {
    const std::size_t first = number_of_openings + number_of_poles;
    return loop < first ? -1 : static_cast<int>(loop - first);
  }
};

// Fills in what follows from a foliation and its graph; the state is there already.
void read_foliation(const Foliation& foliation,
                    const Graph& graph,
                    const Loop_numbers& numbers,
                    Result& result);

} // namespace smf_engine

#endif // SMF_ENGINE_RESULT_H
