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

#include <array>
#include <cstddef>
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
  std::vector<int> result, open;
  for (int f = 0; f < mesh.number_of_faces(); ++f)
  {
    result.push_back(refined.faces[f].arc);
    if (result[f] == Refined_mesh::NONE)
      open.push_back(f);
  }
  while (!open.empty())
  {
    std::vector<int> still_open, label(open.size(), Refined_mesh::NONE);
    for (std::size_t i = 0; i < open.size(); ++i)
      for (int h : mesh.halfedges(open[i]))
      {
        const int neighbour = result[mesh.face(h ^ 1)];
        if (neighbour != Refined_mesh::NONE &&
            (label[i] == Refined_mesh::NONE || neighbour < label[i]))
          label[i] = neighbour;
      }
    for (std::size_t i = 0; i < open.size(); ++i)
      if (label[i] == Refined_mesh::NONE)
        still_open.push_back(open[i]);
      else
        result[open[i]] = label[i];
    open = still_open;
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMPONENT_LABELS_H
