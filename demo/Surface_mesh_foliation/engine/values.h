// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_ENGINE_VALUES_H
#define SMF_ENGINE_VALUES_H

#include "Session.h"

#include <emscripten/val.h>

namespace smf_engine {

// Objects of JavaScript, as protocol.ts has them, from those of C++, and back.

State state_of(const emscripten::val& state);
std::vector<State_pole> poles_of(const emscripten::val& poles);
Indices indices_of(const emscripten::val& array);

emscripten::val to_value(const Loaded_mesh& loaded);
emscripten::val to_value(const Found_poles& found);
emscripten::val to_value(const Sketch& sketch);
emscripten::val to_value(const Result& result);
emscripten::val to_value(const std::vector<SMF::Canonical_loop<Mesh>>& hierarchy, const Mesh& mesh);
emscripten::val to_value(const Leaves& leaves);
emscripten::val to_value(const Loop_check& check);
emscripten::val to_value(const SMF::Problem& problem);

} // namespace smf_engine

#endif // SMF_ENGINE_VALUES_H
