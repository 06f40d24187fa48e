// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/model_summary.h"
#include "include/test_models.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace test_kernels {

// Coordinates of any kernel are converted to double; for the types of meshes see
// test_mesh_models.cpp.

namespace {

using smf_test::Example;

using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

template <class TriangleMesh>
class Exact_meshes : public ::testing::Test
{};

using Models = ::testing::Types<smf_test::Surface_mesh_model<Epeck>,
                                smf_test::Polyhedron_model<Epeck>,
                                smf_test::Linear_cell_complex_model<Epeck>>;
TYPED_TEST_SUITE(Exact_meshes, Models);

TYPED_TEST(Exact_meshes, give_equal_results)
{
  for (const Example& example : smf_test::examples_for_models())
  {
    SCOPED_TRACE(example.name);
    const TypeParam mesh = smf_test::to_mesh<TypeParam>(example.soup);
    TypeParam output;
    expect_equal(smf_test::summary(mesh, example.items, output),
                 smf_test::expected_summary(example));
  }
}

// numbers that are no doubles: the nearest ones are used
TYPED_TEST(Exact_meshes, coordinates_are_rounded)
{
  Example example = smf_test::theta_example();
  TypeParam mesh = smf_test::to_mesh<TypeParam>(example.soup);
  std::size_t i = 0;
  for (const auto v : vertices(mesh))
  {
    auto&& p = get(CGAL::vertex_point, mesh, v);
    const Epeck::FT third = Epeck::FT(1) / 3;
    const Epeck::Point_3 q(p.x() * third, p.y() * third, p.z() * third);
    put(CGAL::vertex_point, mesh, v, q);
    example.soup.points[i++] = {CGAL::to_double(q.x()), CGAL::to_double(q.y()),
                                CGAL::to_double(q.z())};
  }
  for (auto& item : example.items)
    item.plane[3] /= 3;
  TypeParam output;
  expect_equal(smf_test::summary(mesh, example.items, output), smf_test::expected_summary(example));
}

} // namespace

} // namespace test_kernels
