// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_PYTHON_FIND_H
#define SMF_PYTHON_FIND_H

#include "types.h"

// What the package finds on a mesh: poles, lines, loops, moduli.

namespace smf_python {

void define_find(py::module_& module);

} // namespace smf_python

#endif // SMF_PYTHON_FIND_H
