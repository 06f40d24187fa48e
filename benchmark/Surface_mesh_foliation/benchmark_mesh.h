// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_BENCHMARK_MESH_H
#define SMF_BENCHMARK_MESH_H

#include "generators/meshes.h"

#include <CGAL/Surface_mesh_foliation/IO/read_triangle_mesh.h>
#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/Simplicial_cholesky_solver.h>
#include <CGAL/Surface_mesh_foliation/edge_weights.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <benchmark/benchmark.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

// The meshes of the benchmarks: CGAL's hand.off with a pole at each fingertip and at the wrist,
// split midpoint by midpoint into growing resolutions.

namespace smf_benchmark {

namespace SMF = CGAL::Surface_mesh_foliation;
using Mesh = smf_test::Mesh;
using Vertex = Mesh::Vertex_index;

struct Case
{
  Mesh mesh;
  SMF::Poles_and_loops<Mesh> poles;
};

inline SMF::Poles_and_loops<Mesh> poles_at(const std::vector<int>& tips)
{
  SMF::Poles_and_loops<Mesh> result;
  for (int tip : tips)
    result.add_pole(Vertex(static_cast<Mesh::size_type>(tip)));
  return result;
}

// of CGAL's hand: the wrist, the thumb and the bends of four fingers
inline std::vector<int> tips_of_hand()
{
  return {51, 21, 217, 435, 852, 1076};
}

// 1.2k, 4.8k, 19k, 76k, ... vertices for levels 0, 1, 2, 3, ...
inline const Case& hand(int level)
{
  static std::map<int, std::unique_ptr<Case>> cases;
  std::unique_ptr<Case>& result = cases[level];
  if (!result)
  {
    result = std::make_unique<Case>();
    if (level == 0)
      SMF::read_triangle_mesh(std::string(SMF_DATA_DIR) + "/hand.off", result->mesh);
    else
      result->mesh = smf_test::midpoint_subdivided(hand(level - 1).mesh);
    result->poles = poles_at(tips_of_hand());
  }
  return *result;
}

// a human body (shared meshes) or CGAL's hand, split at the midpoints of its edges `level` times
inline Mesh subdivided(int level)
{
  if (level > 0)
    return smf_test::midpoint_subdivided(subdivided(level - 1));
  Mesh result;
  const std::string shared = SMF_SHARED_DIR;
  SMF::read_triangle_mesh(shared.empty() ? std::string(SMF_DATA_DIR) + "/hand.off"
                                         : shared + "/meshes/human_man_6890.off",
                          result);
  return result;
}

// one at a time, since they are large
inline Mesh& body(const benchmark::State& state)
{
  static int level = -1;
  static Mesh mesh;
  if (level != state.range(0))
  {
    level = static_cast<int>(state.range(0));
    mesh = subdivided(level);
  }
  return mesh;
}

// head, hands and feet of the body, or the ends of the hand
inline std::vector<int> body_tips()
{
  return std::string(SMF_SHARED_DIR).empty() ? tips_of_hand()
                                             : std::vector<int>{331, 2446, 5905, 3216, 6617};
}

// Poles there. The first is moved by `first_step` in the numbering of the vertices.
inline SMF::Poles_and_loops<Mesh> body_poles(int first_step = 0)
{
  std::vector<int> tips = body_tips();
  tips[0] += first_step;
  return poles_at(tips);
}

inline double seconds_of(const std::function<void()>& run)
{
  CGAL::Real_timer timer;
  timer.start();
  run();
  return timer.time();
}

// Analyses, factors and solves with the Laplacian of the mesh, one vertex held: the unit in which
// the times of the package are to be read. The matrix is assembled before.
template <class LinearSolver = SMF::Simplicial_cholesky_solver>
class One_solve
{
public:
  explicit One_solve(const SMF::Loop_system<Mesh>& system)
  {
    const SMF::internal::Flat_mesh& mesh = system.data().flat.mesh;
    const std::vector<double> weight = SMF::internal::mean_value_weights(mesh);
    const int n = mesh.number_of_vertices();
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(n + 2 * mesh.number_of_halfedges());
    entries.emplace_back(0, 0, 1.);
    for (int h = 0; h < mesh.number_of_halfedges(); ++h)
    {
      entries.emplace_back(mesh.source(h), mesh.source(h), weight[SMF::internal::edge_of(h)]);
      if (mesh.source(h) > mesh.target(h))
        entries.emplace_back(mesh.source(h), mesh.target(h), -weight[SMF::internal::edge_of(h)]);
    }
    m_matrix.resize(n, n);
    m_matrix.setFromTriplets(entries.begin(), entries.end());
    m_right_side = Eigen::VectorXd::Zero(n);
    m_right_side[n / 2] = 1;
  }

  double operator()() const
  {
    LinearSolver solver;
    solver.analyze_pattern(m_matrix);
    solver.factorize(m_matrix);
    return solver.solve(m_right_side)[m_right_side.size() - 1];
  }

private:
  Eigen::SparseMatrix<double> m_matrix;
  Eigen::VectorXd m_right_side;
};

// Measures run() in turns with one solve on the mesh. Counters: the vertices, and the time in units
// of such solves.
template <class LinearSolver = SMF::Simplicial_cholesky_solver, class Run>
void measure_beside_solve(benchmark::State& state, const Mesh& mesh, const Run& run)
{
  SMF::Poles_and_loops<Mesh> poles; // any: for the matrix
  for (int v : {0, 100, 200})
    poles.add_pole(Vertex(static_cast<Mesh::size_type>(v)));
  const One_solve<LinearSolver> solve(SMF::Loop_system<Mesh>(mesh, poles));
  double seconds = 0, solve_seconds = 0;
  for (auto _ : state)
  {
    const double seconds_of_run = seconds_of(run);
    state.SetIterationTime(seconds_of_run);
    seconds += seconds_of_run;
    solve_seconds += seconds_of([&] { benchmark::DoNotOptimize(solve()); });
  }
  state.counters["vertices"] = static_cast<double>(num_vertices(mesh));
  state.counters["solves"] = seconds / solve_seconds;
}

} // namespace smf_benchmark

#endif // SMF_BENCHMARK_MESH_H
