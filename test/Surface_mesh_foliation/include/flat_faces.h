// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_FLAT_FACES_H
#define SMF_TEST_FLAT_FACES_H

#include "generators/Random.h"
#include "generators/meshes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// Faces that are flat up to rounding: vertices on edges, closed by a face that is nearly a segment.

namespace smf_test {

// Splits a side of a face by a vertex on it, or close to it in the direction of the third corner,
// and closes the gap by a flat face. No edge vanishes.
inline void add_flat_face(Triangle_soup& soup, std::size_t face, double share, double height)
{
  const auto [u, v, apex] = soup.triangles[face];
  soups::Point p;
  for (int i : {0, 1, 2})
    p[i] = soup.points[u][i] * (1 - share) + soup.points[v][i] * share +
           height * (soup.points[apex][i] - soup.points[u][i]);
  const std::size_t middle = soup.points.size();
  soup.points.push_back(p);
  soup.triangles[face] = {u, middle, apex};
  soup.triangles.push_back({middle, v, apex});
  soup.triangles.push_back({u, v, middle});
}

// a face at one of the vertices
inline std::size_t face_at(const Triangle_soup& soup,
                           const std::vector<std::size_t>& vertices,
                           Random& random)
{
  const std::size_t v = vertices[random.index(vertices.size())];
  std::vector<std::size_t> faces;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    if (std::count(soup.triangles[f].begin(), soup.triangles[f].end(), v) > 0)
      faces.push_back(f);
  return faces[random.index(faces.size())];
}

// Adds 5 to 20 flat faces, all of one kind: at midpoints of edges, at random places on them, as
// needles of height 1e-16 to 1e-3, as fans, or at some of the given vertices.
inline void add_flat_faces(Triangle_soup& soup,
                           const std::vector<std::size_t>& vertices,
                           Random& random)
{
  enum Kind { MIDPOINTS, RANDOM_PLACES, NEEDLES, FANS, AT_VERTICES };
  const auto kind = static_cast<Kind>(random.index(vertices.empty() ? 4 : 5));
  std::size_t face = 0;
  for (std::size_t i = 5 + random.index(16); i > 0; --i)
  {
    if (kind == AT_VERTICES)
      face = face_at(soup, vertices, random);
    else if (kind != FANS || i % 5 == 0) // further faces of a fan lie in what is left of the first
      face = random.index(soup.triangles.size());
    const double share = kind == MIDPOINTS ? 0.5 : random.between(0.01, 0.99);
    const double height = kind == NEEDLES ? std::pow(10., random.between(-16, -3)) : 0;
    add_flat_face(soup, face, share, height);
  }
}

} // namespace smf_test

#endif // SMF_TEST_FLAT_FACES_H
