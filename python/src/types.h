// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_PYTHON_TYPES_H
#define SMF_PYTHON_TYPES_H

#include <CGAL/Surface_mesh_foliation/Loop.h>
#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>
#include <CGAL/Surface_mesh_foliation/Poles_and_loops.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_embedding.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <pybind11/pybind11.h>

#include <cstdint>

namespace smf_python {

namespace py = pybind11;
namespace SMF = CGAL::Surface_mesh_foliation;

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Surface = CGAL::Surface_mesh<Point>;
using Vertex = Surface::Vertex_index;
using Halfedge = Surface::Halfedge_index;
using Edge = Surface::Edge_index;
using Face = Surface::Face_index;

using Loop = SMF::Loop<Surface>;
using Poles_and_loops = SMF::Poles_and_loops<Surface>;
using Foliation = SMF::Measured_foliation<Surface>;
using Embedding = SMF::Reeb_graph_embedding<Point>;
using Graph = SMF::Reeb_graph<Point>;

using Index = std::int64_t; // of arrays, in both directions; -1 stands for nothing

// Calls a function while other threads of Python run. It must not touch objects of Python.
template <class Function>
auto without_gil(const Function& function)
{
  py::gil_scoped_release release;
  return function();
}

} // namespace smf_python

#endif // SMF_PYTHON_TYPES_H
