// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_PYTHON_LEAVES_H
#define SMF_PYTHON_LEAVES_H

#include "types.h"

// Leaves of a foliation, and flat coordinates of its components.

namespace smf_python {

void define_leaves(py::module_& module);

} // namespace smf_python

#endif // SMF_PYTHON_LEAVES_H
