// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_PYTHON_ERRORS_H
#define SMF_PYTHON_ERRORS_H

#include "types.h"

#include <CGAL/Surface_mesh_foliation/exceptions.h>

#include <string>

// Exceptions of the package as those of Python.

namespace smf_python {

// throws an exception of the package that says what is wrong with an argument
[[noreturn]] void refuse_argument(const std::string& message);

// throws a MeshError that is about a face, if `face` is not negative
[[noreturn]] void refuse_mesh(SMF::Problem_kind kind, const std::string& message, Index face);

// (kind, message, vertices, faces, loops)
py::tuple problem_to_tuple(const SMF::Problem& problem);

void register_exceptions();

} // namespace smf_python

#endif // SMF_PYTHON_ERRORS_H
