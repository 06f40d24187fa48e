// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_REFINED_MESHES_H
#define SMF_TEST_REFINED_MESHES_H

#include <CGAL/Surface_mesh_foliation/internal/Leaves/Refined_mesh.h>

#include <gtest/gtest.h>

namespace smf_test {

inline CGAL::Surface_mesh_foliation::internal::Refined_mesh refined(
  const CGAL::Surface_mesh_foliation::internal::Foliation_state& state)
{
  return CGAL::Surface_mesh_foliation::internal::Refinement(state).result();
}

inline void expect_near(const CGAL::Surface_mesh_foliation::internal::Point& p,
                        const CGAL::Surface_mesh_foliation::internal::Point& q,
                        double tolerance = 1e-14)
{
  for (int i : {0, 1, 2})
    EXPECT_NEAR(p[i], q[i], tolerance);
}

} // namespace smf_test

#endif // SMF_TEST_REFINED_MESHES_H
