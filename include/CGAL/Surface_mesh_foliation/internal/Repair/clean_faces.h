// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_REPAIR_CLEAN_FACES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_REPAIR_CLEAN_FACES_H

#include <CGAL/Surface_mesh_foliation/internal/Repair/Traced_soup.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Cuts a face at the vertices that it passes several times, and outputs what is left: polygons of
// at least three different vertices.
template <class Output>
void split_at_repeated_vertices(Traced_soup::Face face, const Output& output)
{
  for (std::size_t j = 1; j < face.size(); ++j)
  {
    const auto first = face.begin();
    const auto found = std::find(first, first + j, face[j]);
    if (found == first + j)
      continue;
    split_at_repeated_vertices(Traced_soup::Face(found, first + j), output);
    face.erase(found, first + j);
    j = found - first;
  }
  if (face.size() >= 3)
    output(std::move(face));
}

// Splits faces that use a vertex several times into faces that do not, and returns the number of
// faces of which nothing is left.
inline std::size_t remove_repeated_corners(Traced_soup& soup)
{
  std::vector<Traced_soup::Face> faces;
  std::vector<std::size_t> origins;
  std::size_t result = 0;
  for (std::size_t f = 0; f < soup.faces.size(); ++f)
  {
    const std::size_t before = faces.size();
    split_at_repeated_vertices(std::move(soup.faces[f]), [&](Traced_soup::Face face) {
      faces.push_back(std::move(face));
      origins.push_back(f);
    });
    result += faces.size() == before;
  }
  soup.set_faces(std::move(faces), origins);
  return result;
}

// Removes triangles with the same vertices as an earlier one, and returns their number.
inline std::size_t remove_repeated_triangles(Traced_soup& soup)
{
  std::set<Traced_soup::Face> known;
  std::vector<Traced_soup::Face> faces;
  std::vector<std::size_t> origins;
  const std::size_t before = soup.faces.size();
  for (std::size_t f = 0; f < before; ++f)
  {
    Traced_soup::Face vertices = soup.faces[f];
    std::sort(vertices.begin(), vertices.end());
    if (vertices.size() == 3 && !known.insert(std::move(vertices)).second)
      continue;
    faces.push_back(std::move(soup.faces[f]));
    origins.push_back(f);
  }
  soup.set_faces(std::move(faces), origins);
  return before - soup.faces.size();
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_REPAIR_CLEAN_FACES_H
