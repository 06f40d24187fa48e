// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_EDGE_STRETCHES_H
#define SMF_TEST_EDGE_STRETCHES_H

#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>

#include <cstddef>
#include <vector>

namespace smf_test {

// the way of an edge through one arc, from level to level
struct Stretch
{
  std::size_t arc;
  double from, to;
};

// The image of a halfedge in the tree, arc by arc, put together from what the foliation says about
// its vertices and its path.
template <class TriangleMesh, class Halfedge>
std::vector<Stretch> edge_stretches(
  const CGAL::Surface_mesh_foliation::Measured_foliation<TriangleMesh>& foliation, Halfedge h)
{
  const auto u = source(h, foliation.mesh()), v = target(h, foliation.mesh());
  bool is_in_arc = foliation.cell(u).is_arc;
  double level = foliation.parameter(u);
  std::vector<Stretch> result;
  for (const auto& passage : foliation.path(h))
  {
    const double end = passage.end == 0 ? 0 : foliation.system().height(passage.arc);
    if (is_in_arc)
      result.push_back({passage.arc, level, end});
    is_in_arc = !is_in_arc;
    level = end;
  }
  if (is_in_arc)
    result.push_back({foliation.cell(v).index, level, foliation.parameter(v)});
  return result;
}

} // namespace smf_test

#endif // SMF_TEST_EDGE_STRETCHES_H
