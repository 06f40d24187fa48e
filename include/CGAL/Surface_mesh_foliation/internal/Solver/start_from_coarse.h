// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_START_FROM_COARSE_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_START_FROM_COARSE_H

#include <CGAL/Surface_mesh_foliation/internal/Common/compiled.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Progress.h>

#include <cstddef>

#if CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES
#include <CGAL/Surface_mesh_foliation/internal/Solver/Supernodal_cholesky_solver.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Coarse_level.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Newton_solver.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/grow_fronts.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/relax_folds.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/relax_vertex.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/tied_vertices.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/exceptions.h>

#include <algorithm>
#include <limits>
#include <vector>
#endif // CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// (explained where they are defined)
CGAL_SURFACE_MESH_FOLIATION_INLINE bool start_from_coarse(Foliation_state& state,
                                                          const Progress& progress = Progress(),
                                                          int least_size = 150);
CGAL_SURFACE_MESH_FOLIATION_INLINE bool move_tied_vertices_as_one(Foliation_state& state,
                                                                  std::size_t number_of_iterations);

#if CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES

// Rounds off the corners of critical leaves that come from a coarser mesh, so that the matrix that
// is factored first is closer to the last one. This costs less than the iterations it saves.
inline void relax_critical_leaves(Foliation_state& state)
{
  std::vector<int> band;
  for (int e = 0; e < state.mesh().number_of_edges(); ++e)
    if (state.word_size(e) > 0)
      band.insert(band.end(),
                  {state.mesh().source(halfedge_of(e)), state.mesh().target(halfedge_of(e))});
  relax_band(state, band, rings_of_band, sweeps_of_band(0));
}

inline bool start_from_level(Foliation_state& state,
                             Coarse_level& level,
                             const Progress& progress,
                             int least_size,
                             bool is_to_converge);

// whether some arcs of T are so much longer than others that the ends of short ones coincide on a
// coarse mesh
inline bool has_short_arcs(const Flat_loop_system& system)
{
  constexpr double much_longer = 100;
  double shortest = (std::numeric_limits<double>::infinity)(), longest = 0;
  for (int a = 0; a < system.number_of_arcs(); ++a)
  {
    shortest = (std::min)(shortest, system.height(a));
    longest = (std::max)(longest, system.height(a));
  }
  return longest > much_longer * shortest;
}

// A sixteenth of the vertices, or a third if there are short arcs; but at least two hundred for
// each saddle except one, up to half of the vertices, so that critical leaves stay apart. The
// number of saddles, counted with multiplicity, is 2g - 2 plus the number of poles.
inline int size_of_coarse_mesh(const Foliation_state& state)
{
  const int n = state.mesh().number_of_vertices();
  const int saddles = 2 * state.mesh().genus() - 2 + static_cast<int>(state.system().poles.size());
  return (std::max)(
    {n / 16, (std::min)(n / 2, 200 * (saddles - 1)), has_short_arcs(state.system()) ? n / 3 : 0});
}

// What came of a start.
enum class Start { NONE, DONE, STOPPED };

// Moves the leaves to where they are if tied vertices move as one, should there be enough of them.
inline Start start_with_tied_vertices(Foliation_state& state,
                                      const Progress& progress,
                                      int least_size,
                                      double least_share)
{
  constexpr double enough = 0.01; // of all vertices become others
  const std::vector<int> tied = tied_vertices(state, least_share);
  progress.poll();
  if (tied.empty())
    return Start::NONE;
  Coarse_level level(state, tied);
  progress.poll();
  const int n = state.mesh().number_of_vertices();
  if (level.state().mesh().number_of_vertices() >= (1 - enough * (least_share > 0)) * n)
    return Start::NONE;
  return start_from_level(state, level, progress, least_size, true) ? Start::DONE : Start::STOPPED;
}

// Moves the leaves from the loops to where they are in the harmonic foliation of a coarser mesh,
// found in the same way: a mesh where tied vertices move as one if there are many of them,
// otherwise one of `size_of_coarse_mesh()`. If the mesh is small, or loops fill it, fronts are
// grown instead. Returns false if `progress` stopped it: then the leaves stay where they happened
// to be.
CGAL_SURFACE_MESH_FOLIATION_INLINE bool start_from_coarse(Foliation_state& state,
                                                          const Progress& progress,
                                                          int least_size)
{
  constexpr double many = 0.05; // of all vertices
  const int n = state.mesh().number_of_vertices();
  if (n >= least_size)
  {
    const Start start = start_with_tied_vertices(state, progress, least_size, many);
    if (start != Start::NONE)
      return start == Start::DONE;
    Coarse_level level(state, size_of_coarse_mesh(state));
    progress.poll();
    if (level.state().mesh().number_of_vertices() <= n / 2)
      return start_from_level(state, level, progress, least_size, false);
  }
  grow_fronts(state);
  return true;
}

enum class End_of_level {
  LEFT,    // the coarse solution is good enough for a start
  STOPPED, // by whoever receives the reports
  FAILED   // the coarse mesh was too bad for the linear solver
};

// Unless it has to converge, the coarse solve ends as soon as few of its vertices have changed arcs
// in an iteration, fewer than lie along a leaf: further progress would be lost again on the finer
// mesh. It does have to converge if tied vertices move as one, since they hardly move otherwise.
inline End_of_level iterate_on_level(Foliation_state& coarse,
                                     const Progress& progress,
                                     bool is_to_converge)
{
  constexpr double tolerance = 1e-6;
  constexpr int max_iterations = 20;
  const int size = coarse.mesh().number_of_vertices();
  Supernodal_cholesky_solver linear_solver;
  Newton_solver solver(coarse, linear_solver);
  solver.start(tolerance);
  for (int i = 0; i < max_iterations && !solver.statistics().has_converged; ++i)
  {
    progress.poll();
    try
    {
      solver.find_step();
    }
    catch (const Solver_exception&) // not one of a visitor, which is not called here
    {
      return End_of_level::FAILED;
    }
    progress.poll();
    solver.take_step();
    if (!progress.after_coarse_iteration(size, solver.statistics()))
      return End_of_level::STOPPED;
    const auto changed = static_cast<double>(solver.statistics().number_of_changed_vertices);
    if (!is_to_converge && changed * changed < size)
      break;
  }
  return End_of_level::LEFT;
}

// Once stopped, no level iterates any more. The leaves are only carried to the finest level, and
// folds are smoothed out where that takes the least work.
inline bool start_from_level(Foliation_state& state,
                             Coarse_level& level,
                             const Progress& progress,
                             int least_size,
                             bool is_to_converge)
{
  // whose own start need not be as good
  const bool is_going_on = start_from_coarse(level.state(), progress, 2 * least_size);
  const End_of_level end =
    is_going_on ? iterate_on_level(level.state(), progress, is_to_converge) : End_of_level::STOPPED;
  if (end == End_of_level::STOPPED)
    relax_folds(level.state(), progress.poll);
  progress.poll();
  if (end == End_of_level::FAILED)
    grow_fronts(state);
  else
  {
    state.set_map(level.prolonged());
    relax_critical_leaves(state);
  }
  return end != End_of_level::STOPPED;
}

// How many iterations are more than Newton's method needs, unless there are tied vertices that it
// moves one after another. Then it goes on from where they are if they move as one. (Of ten
// thousand random systems without flat faces, none needed as many.)
constexpr std::size_t iterations_with_ties = 20;

// Returns whether the leaves were moved.
CGAL_SURFACE_MESH_FOLIATION_INLINE bool move_tied_vertices_as_one(Foliation_state& state,
                                                                  std::size_t number_of_iterations)
{
  return number_of_iterations == iterations_with_ties &&
         start_with_tied_vertices(state, Progress(), 150, 0) != Start::NONE;
}

#endif // CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_START_FROM_COARSE_H
