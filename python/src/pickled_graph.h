// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_PYTHON_PICKLED_GRAPH_H
#define SMF_PYTHON_PICKLED_GRAPH_H

#include "Embedded_graph.h"
#include "types.h"

#include <memory>

// Graphs as tuples of numbers and arrays, which pickles consist of.

namespace smf_python {

py::tuple pickled(const Embedded_graph& embedded);

// throws if this is not what pickled() returns
std::shared_ptr<Embedded_graph> unpickled(const py::tuple& state);

} // namespace smf_python

#endif // SMF_PYTHON_PICKLED_GRAPH_H
