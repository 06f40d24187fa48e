// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_KEPT_SOUP_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_KEPT_SOUP_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Triangle_soup.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// What is written of a soup: some of its faces, and the vertices that these use, in their order.
struct Kept_soup
{
  template <class IsKept>
  Kept_soup(const Triangle_soup& all, const IsKept& is_kept)
  {
    std::vector<bool> is_used(all.points.size(), false);
    for (std::size_t f = 0; f < all.triangles.size(); ++f)
      if (is_kept(static_cast<int>(f)))
      {
        faces.push_back(static_cast<int>(f));
        for (const std::size_t v : all.triangles[f])
          is_used[v] = true;
      }
    std::vector<std::size_t> number(all.points.size());
    for (std::size_t v = 0; v < all.points.size(); ++v)
      if (is_used[v])
      {
        number[v] = vertices.size();
        vertices.push_back(static_cast<int>(v));
        soup.points.push_back(all.points[v]);
      }
    for (const int f : faces)
    {
      const std::array<std::size_t, 3>& triangle = all.triangles[f];
      soup.triangles.push_back({number[triangle[0]], number[triangle[1]], number[triangle[2]]});
    }
  }

  // the data of the elements that are kept
  template <class T>
  static std::vector<T> select(const std::vector<T>& all, const std::vector<int>& elements)
  {
    std::vector<T> result;
    result.reserve(elements.size());
    for (const int i : elements)
      result.push_back(all[i]);
    return result;
  }

  Triangle_soup soup;
  std::vector<int> vertices, faces; // their numbers in the whole soup
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_KEPT_SOUP_H
