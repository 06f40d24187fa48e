// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_EACH_FOLIATION_H
#define SMF_TEST_EACH_FOLIATION_H

#include "example_systems.h"

#include <gtest/gtest.h>

namespace smf_test {

// for INSTANTIATE_TEST_SUITE_P with examples
class Each_foliation : public ::testing::TestWithParam<Example>
{
protected:
  Each_foliation()
    : example(GetParam()), mesh(*example.mesh), foliation(example.foliation), system(example.system)
  {}

  Solved_example<> example;
  const Mesh& mesh;
  const SMF::Measured_foliation<Mesh>& foliation;
  const SMF::Loop_system<Mesh>& system;
};

} // namespace smf_test

#endif // SMF_TEST_EACH_FOLIATION_H
