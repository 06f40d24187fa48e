// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_EXPERIMENTS_FACE_TREE_H
#define SMF_EXPERIMENTS_FACE_TREE_H

#include "Shapes.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif

namespace smf_experiments {

namespace internal {

using Face_primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
#if CGAL_VERSION_NR >= 1060000000
using Face_traits = CGAL::AABB_traits_3<Kernel, Face_primitive>;
#else
using Face_traits = CGAL::AABB_traits<Kernel, Face_primitive>;
#endif

} // namespace internal

// finds the faces of a mesh that are nearest to points, or first on rays
using Face_tree = CGAL::AABB_tree<internal::Face_traits>;

} // namespace smf_experiments

#endif // SMF_EXPERIMENTS_FACE_TREE_H
