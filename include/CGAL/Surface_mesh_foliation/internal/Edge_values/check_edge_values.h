// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_CHECK_EDGE_VALUES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_CHECK_EDGE_VALUES_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// How accurate foliation values are that come without their combinatorics. This is the only place
// where the package lets numbers decide about topology.
struct Edge_value_tolerances
{
  Edge_value_tolerances(double relative_tolerance, const std::vector<double>& value)
    : relative(relative_tolerance), scale(0)
  {
    for (double w : value)
      scale = (std::max)(scale, w);
  }

  // between levels that have been carried along leaves
  double snap() const { return relative * scale; }
  // the largest value that may be taken for noise if it causes an accidental pole
  double noise() const { return 0.1 * snap(); }
  // the largest value that is taken for zero next to much larger ones
  double zero() const { return 0.001 * snap(); }

  double relative; // of the three values of a triangle
  double scale;    // the largest value of the mesh
};

inline Problem edge_value_problem(const std::string& message, Indices vertices, Indices faces)
{
  return problem(Problem_kind::INVALID_EDGE_VALUE, message)
    .vertices(std::move(vertices))
    .faces(std::move(faces));
}

// The first value that is negative or not finite, if there is one.
inline std::optional<Problem> find_bad_value(const Flat_mesh& mesh,
                                             const std::vector<double>& value)
{
  for (int e = 0; e < mesh.number_of_edges(); ++e)
    if (!(value[e] >= 0 && std::isfinite(value[e])))
    {
      const int u = mesh.source(halfedge_of(e)), v = mesh.target(halfedge_of(e));
      return edge_value_problem(
        text("the foliation value of edge ", u, " ", v, " is ", value[e],
             ", but it must be finite and not negative"),
        {index(u), index(v)},
        {index(mesh.face(halfedge_of(e))), index(mesh.face(opposite_of(halfedge_of(e))))});
    }
  return std::nullopt;
}

// The first face whose values violate the triangle inequality, if there is one. Precondition: the
// values are finite and not negative.
inline std::optional<Problem> find_bad_triangle(const Flat_mesh& mesh,
                                                const std::vector<double>& value,
                                                const Edge_value_tolerances& tolerances)
{
  for (int f = 0; f < mesh.number_of_faces(); ++f)
  {
    const std::array<int, 3> sides = mesh.halfedges(f);
    std::array<double, 3> w;
    for (int i : {0, 1, 2})
      w[i] = value[edge_of(sides[i])];
    std::sort(w.begin(), w.end());
    if (w[2] - w[1] - w[0] > (std::max)(tolerances.relative * w[2], tolerances.noise()))
      return edge_value_problem(text("the foliation values ", w[0], ", ", w[1], ", ", w[2],
                                     " of face ", f, " violate the triangle inequality"),
                                {}, {index(f)});
  }
  return std::nullopt;
}

// what is wrong with foliation values, taken singly or in threes [3.2]
inline std::optional<Problem> find_bad_edge_values(const Flat_mesh& mesh,
                                                   const std::vector<double>& value,
                                                   const Edge_value_tolerances& tolerances)
{
  if (std::optional<Problem> problem = find_bad_value(mesh, value))
    return problem;
  if (tolerances.scale <= 0)
    return edge_value_problem("all foliation values are zero: there is no leaf", {}, {});
  return find_bad_triangle(mesh, value, tolerances);
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_CHECK_EDGE_VALUES_H
