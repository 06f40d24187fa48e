// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_MODEL_SUMMARY_H
#define SMF_TEST_MODEL_SUMMARY_H

#include "Summarizer.h"
#include "example_systems.h"
#include "summary.h"

#include <vector>

namespace smf_test {

// what the package says about a mesh of any type; `output` is an empty mesh
template <class TriangleMesh,
          class OutputMesh,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Summary summary(const TriangleMesh& mesh,
                const std::vector<Item>& items,
                OutputMesh& output,
                const NamedParameters& np = CGAL::parameters::default_values())
{
  return Summarizer<TriangleMesh, NamedParameters>(mesh, np)(items, output);
}

// what a Surface_mesh says about an example
inline Summary expected_summary(const Example& example)
{
  Mesh output;
  return summary(to_mesh(example.soup), example.items, output);
}

// a few examples with all kinds of items, for slow compilers and slow numbers
inline std::vector<Example> examples_for_models()
{
  std::vector<Example> result;
  for (const Example& example : example_systems())
    if (example.name == "limbs" || example.name == "dumbbell" || example.name == "line pole" ||
        example.name == "torus with poles" || example.name == "two poles")
      result.push_back(example);
  return result;
}

} // namespace smf_test

#endif // SMF_TEST_MODEL_SUMMARY_H
