// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_PYTHON_EMBEDDED_GRAPH_H
#define SMF_PYTHON_EMBEDDED_GRAPH_H

#include "types.h"

namespace smf_python {

// A Reeb graph in space. It does not change.
struct Embedded_graph
{
  Embedding embedding;
  Graph graph; // its edges are numbered as they are iterated: like arcs
};

void define_embedded_graph(py::module_& module);

} // namespace smf_python

#endif // SMF_PYTHON_EMBEDDED_GRAPH_H
