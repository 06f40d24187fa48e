// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LOOPS_FLAT_LOOP_SYSTEM_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LOOPS_FLAT_LOOP_SYSTEM_H

#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/Flat_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/Regions.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/loop_checks.h>

#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// A checked loop system on a flat mesh, with its dual graph: a node per region, an arc per loop.
struct Flat_loop_system
{
  struct Node
  {
    int genus = 0;
    int pole = -1;
    int euler_characteristic = 0; // of the region; its poles are filled
    int degree = 0;
  };

  Flat_mesh mesh;
  std::vector<Pole> poles;
  std::vector<Flat_loop> loops;
  Edge_crossings crossings;
  std::vector<Node> nodes;
  std::vector<std::array<int, 2>> nodes_of_arc; // by end; end 0 lies to the left of the loop
  std::vector<int> node_of_vertex;
  std::vector<int> merged_loops; // a sphere with two poles: loop 1, merged into loop 0

  int number_of_arcs() const { return static_cast<int>(loops.size()); }
  double height(int arc) const { return loops[arc].height; }
  int node_of_end(int arc, int end) const { return nodes_of_arc[arc][end]; }
};

// Both pole loops of a sphere with two poles are homotopic, and are one arc.
inline bool is_sphere_with_two_pole_loops(const Flat_loop_system& system)
{
  return system.mesh.genus() == 0 && system.poles.size() == 2 && system.loops.size() == 2;
}

inline void merge_pole_loops(Flat_loop_system& system)
{
  system.loops[0].height += system.loops[1].height;
  system.loops.pop_back();
  system.merged_loops = {1};
  system.crossings = Edge_crossings(system.mesh, system.loops);
}

inline void build_dual_graph(Flat_loop_system& system, const Regions& regions)
{
  for (int r = 0; r < regions.number_of_regions(); ++r)
  {
    const Regions::Region& region = regions.region(r);
    system.nodes.push_back({region.genus(), region.poles.empty() ? -1 : region.poles[0],
                            region.euler_characteristic, static_cast<int>(region.sides.size())});
  }
  for (int a = 0; a < system.number_of_arcs(); ++a)
    system.nodes_of_arc.push_back(
      {regions.region_beside(system.loops[a], a, 0), regions.region_beside(system.loops[a], a, 1)});
  for (int v = 0; v < system.mesh.number_of_vertices(); ++v)
    system.node_of_vertex.push_back(regions.region_of_vertex(v));
}

// Completes a system whose mesh, poles and loops are given: adds a tight loop for each pole loop
// without crossings, checks everything, and builds the dual graph. Stops at the first stage with a
// problem.
inline void complete(Flat_loop_system& system, Problems& problems)
{
  check_heights(system.loops, problems);
  check_poles(system.mesh, system.poles, problems);
  if (!problems.empty())
    return;
  for (Flat_loop& loop : system.loops)
    if (loop.is_tight)
      loop = tight_loop(system.mesh, system.poles[loop.pole], loop.pole, loop.height);
  for (int a = 0; a < system.number_of_arcs(); ++a)
    check_curve(system.mesh, system.poles, system.loops[a], a, problems);
  if (system.loops.empty())
    problems.push_back(problem(Problem_kind::NO_LOOP,
                               "no pole and no loop is given: give vertices as poles, or let "
                               "detect_feature_poles() look for "
                               "some with a smaller persistence or another detector"));
  if (!problems.empty())
    return;
  system.crossings = Edge_crossings(system.mesh, system.loops);
  check_disjointness(system.mesh, system.loops, system.crossings, problems);
  if (!problems.empty())
    return;
  const bool are_merged = is_sphere_with_two_pole_loops(system);
  const Regions regions(system.mesh, system.poles, system.loops, system.crossings);
  check_regions(system.mesh, system.poles, system.loops, regions, are_merged, problems);
  if (!problems.empty())
    return;
  if (!are_merged)
  {
    build_dual_graph(system, regions);
    return;
  }
  merge_pole_loops(system);
  check_heights(system.loops, problems); // of the sum
  if (problems.empty())
    build_dual_graph(system, Regions(system.mesh, system.poles, system.loops, system.crossings));
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LOOPS_FLAT_LOOP_SYSTEM_H
