// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_PYTHON_POLES_AND_LOOPS_H
#define SMF_PYTHON_POLES_AND_LOOPS_H

#include "Mesh.h"
#include "types.h"

#include <vector>

// Poles and loops, from and to Python, where a loop is a pair of arrays: by crossing, the two
// vertices of its halfedge, and the position. An entry of a collection is a tuple: the vertices of
// the pole (none if it is none), the number of the opening that is the pole (or -1), the loop (or
// None), and the height.

namespace smf_python {

Loop loop_of(const Mesh& mesh, const py::handle& loop);
py::tuple loop_to_tuple(const Mesh& mesh, const Loop& loop);

Poles_and_loops poles_and_loops_of(const Mesh& mesh, const py::list& entries);

void define_loops(py::module_& module);

} // namespace smf_python

#endif // SMF_PYTHON_POLES_AND_LOOPS_H
