// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_PYTHON_RESULT_H
#define SMF_PYTHON_RESULT_H

#include "Mesh.h"
#include "types.h"

namespace smf_python {

// A foliation with the mesh that it refers to. Neither changes, so threads may share it.
struct Result
{
  Mesh_pointer mesh;
  Foliation foliation;
};

void define_result(py::module_& module);

} // namespace smf_python

#endif // SMF_PYTHON_RESULT_H
