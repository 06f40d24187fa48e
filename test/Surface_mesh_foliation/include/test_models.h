// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_TEST_MODELS_H
#define SMF_TEST_TEST_MODELS_H

#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Linear_cell_complex_traits.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

// The models of FaceGraph that tests run on. The polyhedron has no ids: it is the strictest.

namespace smf_test {

template <class Kernel>
using Surface_mesh_model = CGAL::Surface_mesh<typename Kernel::Point_3>;

template <class Kernel>
using Polyhedron_model = CGAL::Polyhedron_3<Kernel>;

template <class Kernel>
using Linear_cell_complex_model =
  typename CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<
    2,
    3,
    CGAL::Linear_cell_complex_traits<3, Kernel>>::type;

} // namespace smf_test

#endif // SMF_TEST_TEST_MODELS_H
