// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LOOPS_LOOP_PROBLEM_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LOOPS_LOOP_PROBLEM_H

#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// What is wrong with a loop, and the vertices concerned.

template <class TriangleMesh>
std::size_t position_of_vertex(typename boost::graph_traits<TriangleMesh>::vertex_descriptor v,
                               const TriangleMesh& mesh)
{
  const auto range = vertices(mesh);
  return static_cast<std::size_t>(
    std::distance(range.begin(), std::find(range.begin(), range.end(), v)));
}

[[noreturn]] inline void throw_loop_problem(std::string message, std::vector<std::size_t> vertices)
{
  throw Invalid_loops_exception(
    problem(Problem_kind::INVALID_LOOP, std::move(message)).vertices(std::move(vertices)));
}

template <class Vertices, class TriangleMesh>
std::vector<std::size_t> positions_of_vertices(const Vertices& some, const TriangleMesh& mesh)
{
  std::vector<std::size_t> result;
  for (const auto v : some)
    result.push_back(position_of_vertex(v, mesh));
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LOOPS_LOOP_PROBLEM_H
