// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_FEATURE_POLES_OF_H
#define SMF_TEST_FEATURE_POLES_OF_H

#include <CGAL/Surface_mesh_foliation/feature_poles.h>
#include <CGAL/Surface_mesh_foliation/loops.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <iterator>
#include <vector>

namespace smf_test {

// the positions in `vertices(mesh)` of the poles, in the order in which they are output
template <class TriangleMesh, class NamedParameters>
std::vector<std::size_t> poles_of(const TriangleMesh& mesh, const NamedParameters& parameters)
{
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> poles;
  CGAL::Surface_mesh_foliation::detect_feature_poles(mesh, std::back_inserter(poles), parameters);
  std::vector<std::size_t> result;
  for (const auto v : poles)
    result.push_back(CGAL::Surface_mesh_foliation::internal::position_of_vertex(v, mesh));
  return result;
}

} // namespace smf_test

#endif // SMF_TEST_FEATURE_POLES_OF_H
