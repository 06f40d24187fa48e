// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_PROBLEM_OF_H
#define SMF_TEST_PROBLEM_OF_H

#include <CGAL/Surface_mesh_foliation/exceptions.h>

#include <gtest/gtest.h>

namespace smf_test {

// the problem that a call reports
template <class Call>
CGAL::Surface_mesh_foliation::Problem problem_of(const Call& call)
{
  try
  {
    call();
  }
  catch (const CGAL::Surface_mesh_foliation::Foliation_exception& exception)
  {
    EXPECT_EQ(exception.problem().message, exception.what());
    return exception.problem();
  }
  ADD_FAILURE() << "nothing was thrown";
  return {CGAL::Surface_mesh_foliation::Problem_kind::FILE, "", {}, {}, {}};
}

} // namespace smf_test

#endif // SMF_TEST_PROBLEM_OF_H
