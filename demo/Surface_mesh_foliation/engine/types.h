// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_ENGINE_TYPES_H
#define SMF_ENGINE_TYPES_H

#include <CGAL/Surface_mesh_foliation/Loop.h>
#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>
#include <CGAL/Surface_mesh_foliation/Poles_and_loops.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_embedding.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdint>
#include <vector>

namespace smf_engine {

namespace SMF = CGAL::Surface_mesh_foliation;

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;
using Edge = Mesh::Edge_index;
using Face = Mesh::Face_index;

using Loop = SMF::Loop<Mesh>;
using Poles_and_loops = SMF::Poles_and_loops<Mesh>;
using System = SMF::Loop_system<Mesh>;
using Foliation = SMF::Measured_foliation<Mesh>;
using Embedding = SMF::Reeb_graph_embedding<Point>;
using Graph = SMF::Reeb_graph<Point>;

using Index = std::uint32_t; // of vertices and faces in arrays
using Indices = std::vector<Index>;
using Doubles = std::vector<double>;

inline void append(const Point& p, Doubles& coordinates)
{
  coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
}

} // namespace smf_engine

#endif // SMF_ENGINE_TYPES_H
