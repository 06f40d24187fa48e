// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMPONENT_LABELS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMPONENT_LABELS_H

#include <CGAL/Surface_mesh_foliation/IO/Triangle_soup.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaf_graph.h>
#include <CGAL/Surface_mesh_foliation/internal/Refined_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

inline Triangle_soup soup_of(const Refined_mesh& refined)
{
  Triangle_soup result;
  result.points = refined.points;
  result.triangles.reserve(refined.faces.size());
  for (const Refined_mesh::Face& face : refined.faces)
    result.triangles.push_back({static_cast<std::size_t>(face.vertices[0]),
                                static_cast<std::size_t>(face.vertices[1]),
                                static_cast<std::size_t>(face.vertices[2])});
  return result;
}

inline Triangle_soup soup_of(const Flat_mesh& mesh)
{
  Triangle_soup result;
  result.points = mesh.points();
  for (int f = 0; f < mesh.number_of_faces(); ++f)
  {
    const std::array<int, 3> h = mesh.halfedges(f);
    result.triangles.push_back({static_cast<std::size_t>(mesh.source(h[0])),
                                static_cast<std::size_t>(mesh.source(h[1])),
                                static_cast<std::size_t>(mesh.source(h[2]))});
  }
  return result;
}

// The arc of every face of the refined mesh. Faces at a node get that of the closest other face, in
// rounds from the outside; among neighbours of one round the smallest arc wins.
inline std::vector<int> component_labels(const Refined_mesh& refined, const Leaf_graph& graph)
{
  const Flat_mesh& mesh = graph.mesh();
  constexpr int NONE = Refined_mesh::NONE;
  std::vector<int> result, round, last_round(mesh.number_of_faces(), 0);
  for (int f = 0; f < mesh.number_of_faces(); ++f)
  {
    result.push_back(refined.faces[f].arc);
    if (result[f] != NONE)
      round.push_back(f);
  }
  for (int number = 1; !round.empty(); ++number)
  {
    std::vector<int> next_round;
    for (int f : round)
      for (int h : mesh.halfedges(f))
      {
        const int g = mesh.face(h ^ 1);
        if (result[g] == NONE)
        {
          next_round.push_back(g);
          last_round[g] = number;
          result[g] = result[f];
        }
        else if (last_round[g] == number)
          result[g] = (std::min)(result[g], result[f]);
      }
    round = std::move(next_round);
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMPONENT_LABELS_H
