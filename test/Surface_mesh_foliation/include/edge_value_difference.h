// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_EDGE_VALUE_DIFFERENCE_H
#define SMF_TEST_EDGE_VALUE_DIFFERENCE_H

#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>

#include <algorithm>
#include <cmath>

namespace smf_test {

// the largest difference of foliation values on one mesh, divided by the largest value
template <class TriangleMesh>
double difference(const CGAL::Surface_mesh_foliation::Measured_foliation<TriangleMesh>& a,
                  const CGAL::Surface_mesh_foliation::Measured_foliation<TriangleMesh>& b)
{
  double largest = 0, result = 0;
  for (const auto e : edges(a.mesh()))
  {
    largest = std::max(largest, a.edge_value(e));
    result = std::max(result, std::abs(a.edge_value(e) - b.edge_value(e)));
  }
  return result / largest;
}

} // namespace smf_test

#endif // SMF_TEST_EDGE_VALUE_DIFFERENCE_H
