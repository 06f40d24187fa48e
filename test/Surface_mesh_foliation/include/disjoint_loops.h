// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_DISJOINT_LOOPS_H
#define SMF_TEST_DISJOINT_LOOPS_H

#include <CGAL/Surface_mesh_foliation/internal/Loops/loop_checks.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace smf_test {

inline void expect_simple_and_disjoint(
  const CGAL::Surface_mesh_foliation::internal::Flat_mesh& mesh,
  const std::vector<CGAL::Surface_mesh_foliation::internal::Flat_loop>& loops)
{
  CGAL::Surface_mesh_foliation::internal::Problems problems;
  for (std::size_t a = 0; a < loops.size(); ++a)
    check_curve(mesh, {}, loops[a], static_cast<int>(a), problems);
  check_disjointness(mesh, loops,
                     CGAL::Surface_mesh_foliation::internal::Edge_crossings(mesh, loops), problems);
  for (const auto& problem : problems)
    ADD_FAILURE() << problem.message;
}

} // namespace smf_test

#endif // SMF_TEST_DISJOINT_LOOPS_H
