// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What says which functions the compiled library has. That it has them, and that they do the same,
// is tested by the consumer `compiled`.

#include <CGAL/Surface_mesh_foliation/internal/Common/compiled.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Compiled_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Surface_mesh_copy.h>

#include <gtest/gtest.h>

#include <string>
#include <type_traits>

#define SMF_TEXT_OF(...) #__VA_ARGS__
#define SMF_EXPANDED_TEXT_OF(...) SMF_TEXT_OF(__VA_ARGS__)

namespace test_compiled {

namespace internal = CGAL::Surface_mesh_foliation::internal;

// a program that links no library finds everything in the headers
TEST(Compiled, nothing_is_unless_it_is_asked_for)
{
  EXPECT_TRUE(CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES);
  EXPECT_EQ(std::string(SMF_EXPANDED_TEXT_OF(CGAL_SURFACE_MESH_FOLIATION_INLINE)), "inline");
}

// so that the library has what it instantiates anyway
TEST(Compiled_mesh, is_that_of_copies)
{
  EXPECT_TRUE((std::is_same_v<internal::Compiled_mesh, internal::Surface_mesh_copy>));
}

} // namespace test_compiled
