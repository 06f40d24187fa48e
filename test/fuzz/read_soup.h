// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_FUZZ_READ_SOUP_H
#define SMF_FUZZ_READ_SOUP_H

#include "require.h"

#include "generators/meshes.h"

#include <CGAL/Surface_mesh_foliation/IO/polygon_soup.h>
#include <CGAL/Surface_mesh_foliation/IO/read_triangle_mesh.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace smf_fuzz {

using SMF::internal::Polygon_collector;
using SMF::internal::Triangle_collector;

inline void require_same(const SMF::Triangle_soup& triangles, const SMF::Polygon_soup& polygons)
{
  require(triangles.points == polygons.points, "triangles and polygons have different vertices");
  require(triangles.triangles.size() == polygons.polygons.size(),
          "there are more polygons than triangles");
  for (std::size_t f = 0; f < triangles.triangles.size(); ++f)
  {
    const auto& triangle = triangles.triangles[f];
    require(polygons.polygons[f] == std::vector<std::size_t>(triangle.begin(), triangle.end()),
            "a triangle that is another polygon");
  }
}

// The text of a file is read as triangles and as polygons, by the reader of its format. What is
// triangles is also polygons, and the same.
template <class ReadTriangles, class ReadPolygons>
void read_soup(const std::uint8_t* data,
               std::size_t size,
               const ReadTriangles& read_triangles,
               const ReadPolygons& read_polygons)
{
  if (size == 0) // no file is empty: that is found before its format matters
    return;
  const std::string text(reinterpret_cast<const char*>(data), size);
  SMF::Triangle_soup triangles;
  SMF::Polygon_soup polygons;
  const bool are_triangles = survives([&] { triangles = read_triangles("file", text); });
  const bool are_polygons = survives([&] { polygons = read_polygons("file", text); });
  require(are_polygons || !are_triangles, "triangles that are no polygons");
  if (are_polygons)
    for (const auto& polygon : polygons.polygons)
      for (const std::size_t v : polygon)
        require(v < polygons.points.size(), "a corner that is no vertex");
  if (!are_triangles)
    return;
  require_same(triangles, polygons);
  survives([&] {
    smf_test::Mesh mesh;
    SMF::triangle_soup_to_triangle_mesh(triangles, mesh,
                                        SMF::parameters::allow_openings(true).allow_parts(true));
    require(mesh.is_valid(), "an invalid mesh");
    require(num_faces(mesh) == triangles.triangles.size(), "faces are lost");
  });
}

} // namespace smf_fuzz

#endif // SMF_FUZZ_READ_SOUP_H
