// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_CLASS_MODULI_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_CLASS_MODULI_H

#include <CGAL/Surface_mesh_foliation/internal/Common/Poll.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>
#include <CGAL/Surface_mesh_foliation/internal/Homotopy/Deck_cocycle.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/Extraction.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/Flat_loop_system.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/Loop_after_flips.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Delaunay_flips.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/weights_of_flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Newton_solver.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Supernodal_cholesky_solver.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/start_from_coarse.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// by vertex, the number of its pole or -1
inline std::vector<int> poles_of_vertices(const Flat_mesh& mesh, const std::vector<Pole>& poles)
{
  std::vector<int> result(mesh.number_of_vertices(), -1);
  for (std::size_t p = 0; p < poles.size(); ++p)
    for (int v : poles[p])
      result[v] = static_cast<int>(p);
  return result;
}

// The moduli of homotopy classes of simple loops on a surface minus its poles: the largest ratio of
// height to circumference of an annulus embedded in the class, which is one over its extremal
// length. The harmonic foliation of the class alone has height h and flux f with h / f the modulus;
// ours has small heights at the poles, too, which make the result smaller by about a thousandth of
// the ratio of their fluxes.
//
// The energy is that of functions linear on the triangles of an intrinsic Delaunay triangulation.
// It is never below the Dirichlet energy of the surface that these triangles make, so a modulus is
// never larger than there, but for faces so flat that their weights are capped.
class Class_moduli
{
public:
  // lengths: by edge; those of the three sides of a face make a triangle
  Class_moduli(const Flat_mesh& mesh,
               const std::vector<double>& lengths,
               std::vector<Pole> poles,
               Poll poll = poll_nobody)
    : m_mesh(mesh),
      m_poles(std::move(poles)),
      m_flips(mesh, lengths, poles_of_vertices(mesh, m_poles)),
      m_poll(std::move(poll))
  {
    compute_weights();
  }

  Class_moduli(const Class_moduli&) = delete;
  Class_moduli& operator=(const Class_moduli&) = delete;

  // The same with other poles. Precondition: those that are not single vertices are the same.
  void set_poles(std::vector<Pole> poles)
  {
    m_poles = std::move(poles);
    m_deck.reset();
  }

  // a set of vertices of the surface, on `mesh()`
  std::vector<bool> on_mesh(std::vector<bool> contains) const
  {
    return m_flips.with_middles(std::move(contains));
  }

  // that the energy is measured on, after flips
  const Flat_mesh& mesh() const { return m_flips.mesh(); }
  const std::vector<double>& weights() const { return m_weights; } // by edge of it

  struct Result
  {
    double modulus;
    bool is_separating;
  };

  // Precondition: the loop is simple, and neither contractible nor homotopic to a loop around a
  // pole.
  Result of_loop(const Flat_loop& loop)
  {
    Flat_loop_system system = system_of_poles();
    system.loops.push_back(loop_after_flips(m_mesh, loop, m_flips));
    system.loops.back().height = 1;
    finish(system);
    const auto [left, right] = system.nodes_of_arc.back();
    return {1 / fluxes(system, m_weights).back(), left != right};
  }

  // Of loops around a pole, which is an opening (around a vertex the modulus is infinite).
  // Precondition: there is another pole or a handle.
  double of_pole(int pole)
  {
    Flat_loop_system system = system_of_poles();
    system.loops[pole].height = 1;
    if (is_sphere_with_two_pole_loops(system))
      merge_pole_loops(system);
    const double height = system.loops[system.merged_loops.empty() ? pole : 0].height;
    finish(system);
    return height / fluxes(system, m_weights)[system.merged_loops.empty() ? pole : 0];
  }

  // Of loops around a pole that is a single vertex, and some vertices around it, as if these were
  // one place. (`is_in_cap`: by vertex of `mesh()`; for `tolerance` see below.) Precondition:
  // there are two other poles or a handle.
  double around_cap(int pole, const std::vector<bool>& is_in_cap, double tolerance = fine)
  {
    constexpr double rigid = 1e4; // usual weights are about 1
    Flat_loop_system system = system_of_poles();
    system.loops[pole].height = 1;
    finish(system);
    std::vector<double> weights = m_weights;
    for (int e = 0; e < system.mesh.number_of_edges(); ++e)
    {
      const int h = halfedge_of(e);
      if (is_in_cap[system.mesh.source(h)] && is_in_cap[system.mesh.target(h)])
        weights[e] = rigid;
    }
    return 1 / fluxes(system, std::move(weights), tolerance)[pole];
  }

  // Relative tolerances of forces.
  static constexpr double fine = 1e-5;   // moduli then have errors of about 1e-7
  static constexpr double coarse = 1e-3; // about 1e-5

private:
  static constexpr double height_of_poles = 1e-3;

  void compute_weights()
  {
    constexpr double least_ratio = 1e-4; // to the median
    m_weights = m_flips.cotangents();
    std::vector<double> sorted = m_weights;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    for (double& weight : m_weights)
      weight = std::clamp(weight, least_ratio * *middle, largest_tangent);
  }

  Flat_loop_system system_of_poles() const
  {
    Flat_loop_system result;
    result.mesh = m_flips.mesh();
    result.poles = m_poles;
    for (std::size_t p = 0; p < m_poles.size(); ++p)
      result.loops.push_back(
        tight_loop(result.mesh, m_poles[p], static_cast<int>(p), height_of_poles));
    return result;
  }

  static void finish(Flat_loop_system& system)
  {
    system.crossings = Edge_crossings(system.mesh, system.loops);
    build_dual_graph(system, Regions(system.mesh, system.poles, system.loops, system.crossings));
  }

  std::vector<double> fluxes(const Flat_loop_system& system,
                             std::vector<double> weights,
                             double tolerance = fine)
  {
    constexpr std::size_t most_iterations = 50; // then, the fluxes of the leaves found are close
    if (!m_deck)
      m_deck.emplace(m_flips.mesh(), m_poles);
    Foliation_state state(system, std::move(weights), *m_deck);
    Newton_solver<Supernodal_cholesky_solver> solver(state, m_factored_matrix);
    start_from_coarse(state);
    solver.start(tolerance);
    while (!solver.statistics().has_converged &&
           solver.statistics().number_of_iterations < most_iterations)
    {
      m_poll();
      if (move_tied_vertices_as_one(state, solver.statistics().number_of_iterations))
        solver.refresh();
      solver.find_step();
      solver.take_step();
    }
    return flux_of_leaves(state, middle_leaves(state));
  }

  const Flat_mesh& m_mesh;
  std::vector<Pole> m_poles;
  const Delaunay_flips m_flips;
  const Poll m_poll;
  std::vector<double> m_weights;      // by edge of the mesh after flips
  std::optional<Deck_cocycle> m_deck; // of the mesh after flips, minus the poles
  Supernodal_cholesky_solver m_linear_solver;
  Factored_matrix<Supernodal_cholesky_solver> m_factored_matrix{m_linear_solver};
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_CLASS_MODULI_H
