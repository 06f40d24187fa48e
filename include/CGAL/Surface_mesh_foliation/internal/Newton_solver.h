// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_NEWTON_SOLVER_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_NEWTON_SOLVER_H

#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation_state.h>
#include <CGAL/Surface_mesh_foliation/internal/Geodesic_step.h>
#include <CGAL/Surface_mesh_foliation/internal/grow_fronts.h>
#include <CGAL/Surface_mesh_foliation/internal/optimality.h>
#include <CGAL/Surface_mesh_foliation/internal/relax_vertex.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// what the solver tells after each iteration
struct Iteration
{
  int number = 0;
  double energy = 0;
  double optimality = 0;
  int number_of_moves = 0;             // passages of vertices over nodes
  int number_of_vertices_at_nodes = 0; // without poles
};

struct Solver_options
{
  double tolerance = 1e-12;
  int max_iterations = 100;
  std::function<bool(const Iteration&)> goes_on = [](const Iteration&) { return true; };
};

struct Solver_result
{
  Iteration last;
  bool has_converged = false;
};

// The harmonic foliation by Newton's method with an active set. As long as no word changes, the
// energy is a quadratic function of the parameters of the vertices in arcs; its minimum is one
// sparse symmetric positive definite solve away. The vertices are carried there along geodesics of
// T, which updates the words; then the vertices near those that changed are relaxed one by one. The
// last solve, after which no word changes, is exact.
template <class LinearSolver = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>>
class Newton_solver
{
public:
  explicit Newton_solver(Foliation_state& state)
    : m_state(state), m_step(state), m_right_side(state.mesh().number_of_vertices())
  {
    build_pattern();
  }

  // Starts from the leaves in the loops.
  Solver_result operator()(const Solver_options& options)
  {
    grow_fronts(m_state);
    if (m_state.deck().group().is_abelian())
      pin_a_vertex();
    m_result.last = report(0, m_state.energy());
    m_result.has_converged = m_result.last.optimality < options.tolerance;
    while (!m_result.has_converged && m_result.last.number < options.max_iterations)
    {
      iterate_once(options.tolerance);
      if (!options.goes_on(m_result.last))
        break;
    }
    return m_result;
  }

  // Does one more iteration, whatever the limits say.
  Solver_result iterate_once(double tolerance)
  {
    const int number_of_moves = iterate(m_result.last.energy);
    m_result.last = report(m_result.last.number + 1, m_state.energy());
    m_result.last.number_of_moves = number_of_moves;
    m_result.has_converged = m_result.last.optimality < tolerance;
    return m_result;
  }

private:
  using Matrix = Eigen::SparseMatrix<double>;
  using Vector = Eigen::VectorXd;

  // the lower triangle: one entry per vertex and per edge
  void build_pattern()
  {
    const Flat_mesh& mesh = m_state.mesh();
    const int n = mesh.number_of_vertices();
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(n + mesh.number_of_edges());
    for (int v = 0; v < n; ++v)
      entries.emplace_back(v, v, 1.);
    for (int e = 0; e < mesh.number_of_edges(); ++e)
      entries.emplace_back(row(e), column(e), 0.);
    m_matrix.resize(n, n);
    m_matrix.setFromTriplets(entries.begin(), entries.end());
    m_entry_of_edge.resize(mesh.number_of_edges());
    for (int e = 0; e < mesh.number_of_edges(); ++e)
      m_entry_of_edge[e] =
        static_cast<int>(&m_matrix.coeffRef(row(e), column(e)) - m_matrix.valuePtr());
  }

  int row(int e) const
  {
    return (std::max)(m_state.mesh().source(2 * e), m_state.mesh().target(2 * e));
  }
  int column(int e) const
  {
    return (std::min)(m_state.mesh().source(2 * e), m_state.mesh().target(2 * e));
  }

  // A torus without pole has no singularity, and its foliation can slide along itself.
  void pin_a_vertex()
  {
    for (int v = 0; v < m_state.mesh().number_of_vertices(); ++v)
      if (m_state.is_free_in_arc(v))
        return m_state.fix(v);
  }

  // Matrix and right side of the quadratic energy; vertices that cannot move are decoupled rows.
  void assemble()
  {
    const Flat_mesh& mesh = m_state.mesh();
    double* const values = m_matrix.valuePtr();
    for (int v = 0; v < mesh.number_of_vertices(); ++v)
      values[m_matrix.outerIndexPtr()[v]] = m_state.total_weight(v);
    m_right_side.setZero();
    for (int e = 0; e < mesh.number_of_edges(); ++e)
    {
      const int u = mesh.source(2 * e), v = mesh.target(2 * e);
      const bool is_inside_arc = m_state.word_size(e) == 0 && !m_state.is_at_node(u);
      const double length =
        is_inside_arc ? m_state.parameter(u) - m_state.parameter(v) : m_state.length(e);
      const int slope_u = m_state.is_free_in_arc(u) ? m_state.slope(2 * e) : 0;
      const int slope_v = m_state.is_free_in_arc(v) ? m_state.slope(2 * e + 1) : 0;
      const double alpha = m_state.weight(e);
      values[m_entry_of_edge[e]] = alpha * slope_u * slope_v;
      m_right_side[u] -= alpha * length * slope_u;
      m_right_side[v] -= alpha * length * slope_v;
    }
  }

  Vector solve()
  {
    if (m_number_of_solves++ == 0)
      m_linear_solver.analyzePattern(m_matrix);
    m_linear_solver.factorize(m_matrix);
    if (m_linear_solver.info() != Eigen::Success)
      throw Solver_exception({Problem_kind::SOLVER_FAILURE,
                              "the linear system of the foliation could not be factored",
                              {},
                              {},
                              {}});
    Vector result = m_linear_solver.solve(m_right_side);
    if (!result.allFinite())
      throw Solver_exception({Problem_kind::SOLVER_FAILURE,
                              "the linear system of the foliation has no finite solution",
                              {},
                              {},
                              {}});
    return result;
  }

  // One step towards the minimum of the quadratic, halved as long as the energy rises (it is convex
  // along the step), then relaxation of the band where words changed or a vertex sits at a node.
  int iterate(double energy)
  {
    assemble();
    const Vector step = solve();
    const Tree_map before = m_state.map();
    m_step(step, 1);
    double duration = 1;
    for (int halvings = 0;
         halvings < 14 && !m_step.moved().empty() && m_state.energy() > energy * (1 + 1e-14);
         ++halvings)
    {
      m_state.set_map(before);
      duration /= 2;
      m_step(step, duration);
    }
    std::vector<int> band = m_step.moved();
    for (int v = 0; v < m_state.mesh().number_of_vertices(); ++v)
      if (m_state.is_at_node(v) && !m_state.is_fixed(v))
        band.push_back(v);
    relax_band(m_state, std::move(band), m_step.moved().empty() ? 0 : 2, 3);
    return static_cast<int>(m_step.moved().size());
  }

  Iteration report(int number, double energy) const
  {
    Iteration result;
    result.number = number;
    result.energy = energy;
    result.optimality = optimality(m_state);
    for (int v = 0; v < m_state.mesh().number_of_vertices(); ++v)
      result.number_of_vertices_at_nodes += m_state.is_at_node(v) && !m_state.is_fixed(v);
    return result;
  }

  Foliation_state& m_state;
  Solver_result m_result;
  Geodesic_step m_step;
  Matrix m_matrix;
  std::vector<int> m_entry_of_edge;
  Vector m_right_side;
  LinearSolver m_linear_solver;
  int m_number_of_solves = 0;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_NEWTON_SOLVER_H
