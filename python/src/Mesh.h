// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_PYTHON_MESH_H
#define SMF_PYTHON_MESH_H

#include "arrays.h"
#include "types.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace smf_python {

// A mesh that does not change once it is made, so that threads and results may share it.
struct Mesh
{
  Surface surface;
  std::vector<Halfedge> openings; // a halfedge of the border of each, in the order of openings()
  std::vector<bool> is_filled;    // by face: whether it fills an opening of the input
  std::size_t number_of_filled_openings = 0;
};

using Mesh_pointer = std::shared_ptr<Mesh>;

// the vertex of this number; throws if there is none
Vertex vertex_of(const Mesh& mesh, Index number);
Face face_of(const Mesh& mesh, Index number);

std::vector<Vertex> vertices_of(const Mesh& mesh, const Indices& numbers);

// the corners of all faces
py::array_t<Index> faces_to_array(const Surface& surface);

void define_mesh(py::module_& module);

} // namespace smf_python

#endif // SMF_PYTHON_MESH_H
