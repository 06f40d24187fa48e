// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_ENGINE_PROBLEMS_H
#define SMF_ENGINE_PROBLEMS_H

#include "Result.h"
#include "types.h"

#include <CGAL/Surface_mesh_foliation/exceptions.h>

#include <string>
#include <vector>

namespace smf_engine {

// A problem in terms of the state: the package numbers the loops of openings and poles, too.
SMF::Problem in_terms_of_state(const SMF::Problem& problem,
                               const Loop_numbers& numbers,
                               const std::vector<State_pole>& poles);

} // namespace smf_engine

#endif // SMF_ENGINE_PROBLEMS_H
