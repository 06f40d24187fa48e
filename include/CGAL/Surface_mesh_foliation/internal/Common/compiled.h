// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_COMPILED_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_COMPILED_H

// The optional compiled library (CMake: Surface_mesh_foliation::Compiled) has the functions that
// take longest to compile. Who links it compiles with SURFACE_MESH_FOLIATION_COMPILED defined, by
// the target, and sees only their declarations; the library itself also defines
// SURFACE_MESH_FOLIATION_LIBRARY. Without either, all is inline, in the headers.
//
// CGAL_SURFACE_MESH_FOLIATION_INLINE     in place of `inline` before such a function
// CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES whether its definition, with what only it needs, is seen

#ifdef SURFACE_MESH_FOLIATION_COMPILED
#define CGAL_SURFACE_MESH_FOLIATION_INLINE
#else
#define CGAL_SURFACE_MESH_FOLIATION_INLINE inline
#endif

#if !defined(SURFACE_MESH_FOLIATION_COMPILED) || defined(SURFACE_MESH_FOLIATION_LIBRARY)
#define CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES 1
#else
#define CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES 0
#endif

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_COMPILED_H
