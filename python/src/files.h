// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_PYTHON_FILES_H
#define SMF_PYTHON_FILES_H

#include "types.h"

// Results as files for other programs: those that the main program writes.

namespace smf_python {

void define_files(py::module_& module);

} // namespace smf_python

#endif // SMF_PYTHON_FILES_H
