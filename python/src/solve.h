// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_PYTHON_SOLVE_H
#define SMF_PYTHON_SOLVE_H

#include "types.h"

// The solver of harmonic foliations, and foliations made of edge values.

namespace smf_python {

void define_solve(py::module_& module);

} // namespace smf_python

#endif // SMF_PYTHON_SOLVE_H
