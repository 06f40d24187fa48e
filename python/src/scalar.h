// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_PYTHON_SCALAR_H
#define SMF_PYTHON_SCALAR_H

#include "types.h"

// The Reeb graph of a function on the vertices.

namespace smf_python {

void define_scalar(py::module_& module);

} // namespace smf_python

#endif // SMF_PYTHON_SCALAR_H
