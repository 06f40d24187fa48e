// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_POLYLINES_H
#define SMF_TEST_POLYLINES_H

#include "generators/meshes.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace smf_test {

inline double distance(const Mesh::Point& p, const Mesh::Point& q)
{
  return std::sqrt(CGAL::squared_distance(p, q));
}

inline double length(const std::vector<Mesh::Point>& polyline)
{
  double result = 0;
  for (std::size_t i = 1; i < polyline.size(); ++i)
    result += distance(polyline[i - 1], polyline[i]);
  return result;
}

} // namespace smf_test

#endif // SMF_TEST_POLYLINES_H
