// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_COMPONENT_LABELS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_COMPONENT_LABELS_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/Leaf_graph.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/Refined_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/Sum.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The arc of every face of the refined mesh. Faces at a node get that of the closest other face, in
// rounds from the outside; among neighbors in the same round, the smallest arc wins.
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
        const int g = mesh.face(opposite_of(h));
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

// The area of a face of the refined mesh, with all lengths divided by `unit`.
inline double area_of_face(const Refined_mesh& refined, const Refined_mesh::Face& face, double unit)
{
  const Point &p = refined.points[face.vertices[0]], &q = refined.points[face.vertices[1]],
              &r = refined.points[face.vertices[2]];
  const Eigen::Vector3d a = difference(q, p) / unit, b = difference(r, p) / unit;
  return norm(a.cross(b)) / 2;
}

// by arc
inline std::vector<double> areas_of_components(const Refined_mesh& refined,
                                               const Leaf_graph& graph,
                                               int number_of_arcs)
{
  const std::vector<int> label = component_labels(refined, graph);
  std::vector<Sum> sum(number_of_arcs);
  for (int f = 0; f < refined.first_cap_face; ++f)
    sum[label[f]].add(area_of_face(refined, refined.faces[f], 1));
  std::vector<double> result;
  result.reserve(sum.size());
  for (const Sum& area : sum)
    result.push_back(area.value());
  return result;
}

// By face of the mesh, without caps: the arc that most of its area lies in; in a tie, the smallest.
// The parts of a face are consecutive in the refined mesh.
inline std::vector<int> components_of_origins(const Refined_mesh& refined, const Leaf_graph& graph)
{
  std::vector<int> label = component_labels(refined, graph);
  label.resize(refined.first_cap_face);
  std::vector<int> result;
  std::map<int, double> area; // by arc
  for (std::size_t begin = 0, end = 0; begin < label.size(); begin = end)
  {
    double unit = 0; // so that areas neither overflow nor vanish
    for (; end < label.size() && refined.faces[end].origin == refined.faces[begin].origin; ++end)
      for (int i : {0, 1, 2})
        unit = (std::max)(unit, distance(refined.points[refined.faces[end].vertices[i]],
                                         refined.points[refined.faces[end].vertices[(i + 1) % 3]]));
    area.clear();
    for (std::size_t f = begin; f < end; ++f)
      area[label[f]] += end == begin + 1 ? 1 : area_of_face(refined, refined.faces[f], unit);
    const auto largest = std::max_element(
      area.begin(), area.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    result.push_back(largest->first);
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_COMPONENT_LABELS_H
