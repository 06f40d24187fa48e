// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMPONENT_COORDINATES_COMPONENT_LAYOUT_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMPONENT_COORDINATES_COMPONENT_LAYOUT_H

#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/Extraction.h>
#include <CGAL/Surface_mesh_foliation/internal/Component_coordinates/Component_springs.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The coordinates of all components: t along, and the equilibrium of springs around.
//
// Both coordinates are in equilibrium with the same system of positive springs, t because the
// foliation is harmonic. Reflected at both ends, a component becomes a torus on which their
// differentials are harmonic one-forms. Such one-forms, and so all their linear combinations, have
// no singularity at a vertex or face of a torus (Gortler, Gotsman and Thurston, 2006): the images
// of the pieces of faces are convex and cover the cylinder once, and all triangles keep their
// orientation.
class Component_layout
{
public:
  template <class LinearSolver>
  Component_layout(const Foliation_state& state, const Extraction& extraction, LinearSolver& solver)
    : m_flux(extraction.flux),
      m_nodes(extraction.refined_mesh, extraction.leaf_graph),
      m_seams(m_nodes, heights(state))
  {
    solve(Component_springs(state, m_flux, m_nodes, m_seams).springs(), solver);
  }

  Component_layout(const Component_layout&) = delete;
  Component_layout& operator=(const Component_layout&) = delete;

  const Corner_nodes& nodes() const { return m_nodes; }
  const Component_seams& seams() const { return m_seams; }

  // The coordinate u of an end of a side, as seen in its face.
  double around_of_source(int h) const
  {
    return around(m_nodes.node_of_source(h), m_seams.is_source_left(h), m_nodes.arc(h));
  }
  double around_of_target(int h) const
  {
    return around(m_nodes.node_of_target(h), m_seams.is_target_left(h), m_nodes.arc(h));
  }

  // Of the corner of source(h) in face(h). A corner at a pole, which is an interval of the circle
  // that the pole is blown up to, gets the middle of the interval.
  std::array<double, 2> corner(int h) const
  {
    const double a = around_of_source(h), b = around_of_target(m_nodes.mesh().prev(h));
    return {a == b ? a : a / 2 + b / 2, m_nodes.parameter(h)};
  }

private:
  double around(int node, bool is_left, int arc) const
  {
    return m_around[node] + (is_left ? m_flux[arc] : 0);
  }

  static std::vector<double> heights(const Foliation_state& state)
  {
    std::vector<double> result;
    for (int a = 0; a < state.system().number_of_arcs(); ++a)
      result.push_back(state.system().height(a));
    return result;
  }

  // The first node of each seam is at 0. Since all forces of a component add up to zero, it makes
  // no difference how strongly the node is held.
  template <class LinearSolver>
  void solve(const std::vector<Component_springs::Spring>& springs, LinearSolver& solver)
  {
    const int n = m_nodes.number_of_nodes();
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(n), force = Eigen::VectorXd::Zero(n);
    for (const Component_springs::Spring& s : springs)
    {
      if (s.source_node == s.target_node)
        continue;
      diagonal[s.source_node] += s.strength;
      diagonal[s.target_node] += s.strength;
      entries.emplace_back((std::max)(s.source_node, s.target_node),
                           (std::min)(s.source_node, s.target_node), -s.strength);
      force[s.source_node] += s.strength * s.turns * m_flux[s.arc];
      force[s.target_node] -= s.strength * s.turns * m_flux[s.arc];
    }
    for (std::size_t a = 0; a < m_flux.size(); ++a)
      diagonal[m_nodes.node_of_source(m_seams.seam(static_cast<int>(a)).front())] *= 2;
    for (int i = 0; i < n; ++i)
      entries.emplace_back(i, i, diagonal[i]);
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    solver.analyze_pattern(matrix);
    if (!solver.factorize(matrix))
      fail();
    m_around = solver.solve(force);
    m_around += solver.solve(force - matrix.selfadjointView<Eigen::Lower>() * m_around);
    if (!m_around.allFinite())
      fail();
  }

  [[noreturn]] static void fail()
  {
    throw Solver_exception(
      problem(Problem_kind::SOLVER_FAILURE,
              "the linear system of component coordinates could not be solved"));
  }

  const std::vector<double> m_flux; // by arc
  Corner_nodes m_nodes;
  Component_seams m_seams;
  Eigen::VectorXd m_around; // by node
};

} // namespace internal

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMPONENT_COORDINATES_COMPONENT_LAYOUT_H
