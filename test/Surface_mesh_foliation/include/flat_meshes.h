// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_FLAT_MESHES_H
#define SMF_TEST_FLAT_MESHES_H

#include "generators/soups.h"

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>

#include <vector>

namespace smf_test {

// for tests of what is inside the package
inline CGAL::Surface_mesh_foliation::internal::Flat_mesh flat_mesh(const Triangle_soup& soup)
{
  std::vector<CGAL::Surface_mesh_foliation::internal::Triangle> triangles;
  for (const auto& t : soup.triangles)
    triangles.push_back({static_cast<int>(t[0]), static_cast<int>(t[1]), static_cast<int>(t[2])});
  return {soup.points, triangles};
}

} // namespace smf_test

#endif // SMF_TEST_FLAT_MESHES_H
