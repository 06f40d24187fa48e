// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_ENGINE_STATE_H
#define SMF_ENGINE_STATE_H

#include "types.h"

#include <CGAL/Surface_mesh_foliation/canonical_loops.h>

#include <vector>

namespace smf_engine {

// What a user can choose; the same as in protocol.ts.

enum class Mode {
  CANONICAL, // the loops of one level of the hierarchy
  STAR,      // only loops that handles need
  ALL,       // all loops of the hierarchy
  GIVEN      // the loops that are given
};

struct State_pole
{
  Index vertex = 0;
  double height = 1;
};

// where a loop crosses the edge from `source` to `target`, see `SMF::Crossing`
struct State_crossing
{
  Index source = 0, target = 0;
  double position = 0;
};

struct State_loop
{
  // the picked vertices or, of a loop that was found, those of a closed walk along edges
  Indices vertices;
  double height = 1;
  bool is_found = false;
  std::vector<State_crossing> crossings; // of a loop that was found, exactly; may be left out
};

struct State
{
  Mode mode = Mode::CANONICAL;
  double detail = SMF::default_min_modulus;
  std::vector<State_pole> poles;
  std::vector<State_loop> loops;
};

} // namespace smf_engine

#endif // SMF_ENGINE_STATE_H
