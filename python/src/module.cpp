// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Embedded_graph.h"
#include "Mesh.h"
#include "Result.h"
#include "errors.h"
#include "files.h"
#include "find.h"
#include "leaves.h"
#include "memory.h"
#include "poles_and_loops.h"
#include "scalar.h"
#include "solve.h"
#include "types.h"

#include <CGAL/Surface_mesh_foliation/version.h>

// The part of the module that is compiled. It takes arrays of the right type and shape, which its
// callers in Python see to, and checks everything else.
PYBIND11_MODULE(_core, module)
{
  module.attr("__version__") = CGAL_SURFACE_MESH_FOLIATION_VERSION;
  smf_python::keep_memory();
  smf_python::register_exceptions();
  smf_python::define_mesh(module);
  smf_python::define_loops(module);
  smf_python::define_find(module);
  smf_python::define_result(module);
  smf_python::define_solve(module);
  smf_python::define_embedded_graph(module);
  smf_python::define_leaves(module);
  smf_python::define_scalar(module);
  smf_python::define_files(module);
}
