// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_ENGINE_WALKS_H
#define SMF_ENGINE_WALKS_H

#include "State.h"
#include "types.h"

#include <cstddef>

namespace smf_engine {

// Loops as the package has them, sequences of crossings, and as the page has them, sequences of
// vertices.

// A vertex by its number. Throws if there is none.
Vertex vertex_of(std::size_t number, const Mesh& mesh);

// The vertices to the right of a loop: a closed walk along edges. If it is pushed off to its left,
// it crosses the edges that the loop does, unless the loop runs around a vertex and almost back,
// where the walk takes a short cut.
Indices walk_to_right_of(const Loop& loop, const Mesh& mesh);

// A loop that was found, with its walk and its crossings.
State_loop found_loop(const Loop& loop, const Mesh& mesh);

// The loop with these crossings. Throws if no edge joins the two vertices of one.
Loop loop_of(const std::vector<State_crossing>& crossings, const Mesh& mesh);

// The shortest paths along edges from each vertex to the next, as one path that is not closed.
Indices path_through(const Indices& picks, const Mesh& mesh);

} // namespace smf_engine

#endif // SMF_ENGINE_WALKS_H
