// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_EXPERIMENTS_FUNCTIONS_H
#define SMF_EXPERIMENTS_FUNCTIONS_H

#include "Shapes.h"

#include <string>
#include <vector>

// The functions whose Reeb graphs are compared with ours.

namespace smf_experiments {

using Values = std::vector<double>; // by vertex

struct Named_function
{
  std::string name;
  Values values;
};

// All of them: the height, the geodesic distance and the commute-time distance from the nearest
// pole, the first eigenfunction of the Laplacian that is not constant, and the harmonic function
// that is 0 at the first pole and 1 at the others, with two kinds of weights.
std::vector<Named_function> all_functions(const Mesh& mesh,
                                          int up,
                                          const std::vector<Vertex>& poles);

} // namespace smf_experiments

#endif // SMF_EXPERIMENTS_FUNCTIONS_H
