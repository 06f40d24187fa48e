// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_BORDER_POLES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_BORDER_POLES_H

#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Mesh_index.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Pole.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/checked_flat_mesh.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// By vertex of the mesh, the number of its opening, or -1.
inline std::vector<int> opening_of_vertex(const Capped_mesh& capped)
{
  std::vector<int> result(capped.mesh.number_of_vertices(), -1);
  for (std::size_t i = 0; i < capped.openings.size(); ++i)
    for (int v : capped.openings[i])
      result[v] = static_cast<int>(i);
  return result;
}

// Reads the openings that are poles, and says what is wrong with them.
template <class TriangleMesh>
class Border_poles
{
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

public:
  Border_poles(const Mesh_index<TriangleMesh>& mesh_index, const Capped_mesh& capped)
    : m_mesh_index(mesh_index),
      m_capped(capped),
      m_opening_of_vertex(opening_of_vertex(capped)),
      m_pole_of_opening(capped.openings.size(), -1)
  {}

  Pole operator()(halfedge_descriptor border, int pole, Problems& problems)
  {
    const TriangleMesh& mesh = m_mesh_index.mesh();
    const int v = m_mesh_index.find(target(border, mesh));
    const int opening = v < 0 || !is_border(border, mesh) ? -1 : m_opening_of_vertex[v];
    if (opening < 0)
      problems.push_back(problem(Problem_kind::INVALID_POLE, "the halfedge given for pole ", pole,
                                 " does not lie on the border of an opening"));
    else if (m_pole_of_opening[opening] >= 0)
      problems.push_back(problem(Problem_kind::INVALID_POLE, "the poles ",
                                 m_pole_of_opening[opening], " and ", pole, " are the same opening")
                           .vertices({index(v)}));
    if (opening < 0)
      return Pole();
    m_pole_of_opening[opening] = pole;
    return m_capped.cap(opening);
  }

  // that every opening is a pole
  void check_all(Problems& problems) const
  {
    int number_of_others = 0;
    for (int pole : m_pole_of_opening)
      number_of_others += pole < 0;
    if (number_of_others == 0)
      return;
    Problem result = m_capped.border_problems[0];
    result.message += text("; ", number_of_others,
                           " of them are no poles: make them poles by add_border_poles(), or fill "
                           "them by fill_openings()");
    problems.push_back(std::move(result));
  }

private:
  const Mesh_index<TriangleMesh>& m_mesh_index;
  const Capped_mesh& m_capped;
  std::vector<int> m_opening_of_vertex, m_pole_of_opening;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_BORDER_POLES_H
