// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_ENGINE_LOADED_MESH_H
#define SMF_ENGINE_LOADED_MESH_H

#include "types.h"

#include <cstddef>
#include <string>
#include <vector>

namespace smf_engine {

// A connected mesh with what was done to make it one. It stays where it is: others refer to it.
struct Loaded_mesh
{
  // Reads a file. `repairs`: whether to repair the mesh; `fills_openings`: whether to fill all
  // openings instead of only the short ones.
  Loaded_mesh(const std::string& file, bool repairs, bool fills_openings);

  Loaded_mesh(const Loaded_mesh&) = delete;
  Loaded_mesh& operator=(const Loaded_mesh&) = delete;

  std::size_t genus() const;
  Doubles positions() const;
  Indices triangles() const;
  Indices edges() const; // the two vertices of each
  std::vector<Indices> vertices_of_openings() const;

  Mesh mesh;
  Mesh::Property_map<Face, bool> is_filled; // whether a face fills an opening
  std::vector<Halfedge> openings;           // a border halfedge of each that is left
  std::vector<std::string> report;          // what was done, a sentence each
};

} // namespace smf_engine

#endif // SMF_ENGINE_LOADED_MESH_H
